"""Weather files made on the fly: a real TMY3 year of pvlib as EPW and WEA, and random ones."""

import subprocess
from pathlib import Path

import numpy as np
import pvlib
import pytest

from skydome.years.weather.calendar import month_day_hour
from skydome.years.weather.reading import read_weather
from skydome.years.weather.wea import write_wea
from skydome.years.weather.weather import Weather

DATA = Path(pvlib.__file__).parent / "data"
HEADER = """LOCATION,{name},-,USA,made,000000,{latitude},{longitude},{offset},{altitude}
DESIGN CONDITIONS,0
TYPICAL/EXTREME PERIODS,0
GROUND TEMPERATURES,0
HOLIDAYS/DAYLIGHT SAVINGS,No,0,0,0
COMMENTS 1,made for a test
COMMENTS 2,-
DATA PERIODS,1,1,Data,Sunday, 1/ 1,12/31
"""


def epw_row(month, day, hour, dew_point, direct, diffuse, year=2023, minute=60):
    cells = ["0"] * 35
    cells[:6] = [str(value) for value in (year, month, day, hour, minute, "?9")]
    cells[6:9] = ["20.0", f"{dew_point:.1f}", "50"]
    cells[13], cells[14], cells[15] = "0", f"{direct:g}", f"{diffuse:g}"
    return ",".join(cells)


def epw_text(weather: Weather) -> str:
    place = weather.place
    facts = {"name": weather.name or "site", "offset": weather.utc_offset, **vars(place)}
    months, days, hours = month_day_hour(weather.local)
    columns = zip(months, days, np.ceil(hours).astype(int), weather.dew_point, *weather.irradiances, strict=True)
    return HEADER.format(**facts) + "\n".join(epw_row(*row) for row in columns) + "\n"


@pytest.fixture(scope="session")
def greensboro() -> Weather:
    return read_weather(DATA / "723170TYA.CSV")


@pytest.fixture(scope="session")
def files(tmp_path_factory, greensboro) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("weather")
    (folder / "site.epw").write_text(epw_text(greensboro))
    write_wea(greensboro, folder / "site.wea")
    (folder / "stress.wea").write_text(stress_tape(20.0, seed=3))
    for name, source in (("light", "site"), ("stress_light", "stress"), ("horizontal", "site")):
        text = (folder / f"{source}.wea").read_text()
        (folder / f"{name}.wea").write_text(horizontal_tape(text) if name == "horizontal" else light_tape(text))
    names = ("site", "stress", "light", "stress_light", "horizontal")
    return {"epw": folder / "site.epw", "wea": folder / "site.wea"} | {name: folder / f"{name}.wea" for name in names}


def with_rows(text: str, units: int, columns) -> str:
    """The tape with other units, its direct and diffuse column changed by a function of both."""
    lines = text.splitlines()
    rows = [line.split() for line in lines[6:]]
    direct, diffuse = columns(*(np.array([float(row[k]) for row in rows]) for k in (3, 4)))
    changed = [" ".join(row[:3]) + f" {a:.7g} {b:.7g}" for row, a, b in zip(rows, direct, diffuse, strict=True)]
    return "\n".join([*lines[:5], f"weather_data_file_units {units}", *changed]) + "\n"


def light_tape(text: str) -> str:
    """Illuminances in place of irradiances: 105 and 125 lm W-1."""
    return with_rows(text, 3, lambda direct, diffuse: (direct * 105, diffuse * 125))


def horizontal_tape(text: str) -> str:
    """Direct irradiance on the horizontal, here simply half."""
    return with_rows(text, 2, lambda direct, diffuse: (direct / 2, diffuse))


def stress_tape(latitude: float, seed: int) -> str:
    random = np.random.default_rng(seed)
    head = ["place nowhere", f"latitude {latitude}", "longitude -20", "time_zone -15", "site_elevation 0"]
    hours = np.datetime64("2023-01-01T00:30", "s") + np.arange(8760) * np.timedelta64(3600, "s")
    direct = random.choice([0, 1e-5, 1, 30, 300, 900], 8760) * random.random(8760)
    diffuse = random.choice([0, 1e-5, 0.5, 5, 50, 150, 400, 800], 8760) * random.random(8760)
    rows = zip(*month_day_hour(hours), direct, diffuse, strict=True)
    lines = [f"{month} {day} {hour:g} {dni:.6g} {dhi:.6g}" for month, day, hour, dni, dhi in rows]
    return "\n".join([*head, "weather_data_file_units 1", *lines]) + "\n"


def radiance(program: str, *arguments, check=True, **keywords) -> subprocess.CompletedProcess:
    """A program of Radiance as pyradiance carries it."""
    import pyradiance

    folder = Path(pyradiance.__file__).parent
    command = [folder / "bin" / program, *map(str, arguments)]
    return subprocess.run(
        command,
        capture_output=True,
        check=check,
        env={"RAYPATH": f".:{folder / 'lib'}", "PATH": str(folder / "bin")},
        **keywords,
    )


@pytest.fixture(scope="session")
def run_radiance():
    return radiance


@pytest.fixture(scope="session")
def change_tape():
    return with_rows


@pytest.fixture(scope="session")
def make_epw():
    return epw_row, HEADER
