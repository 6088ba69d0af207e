"""Weather files made on the fly: a real TMY3 year of pvlib as EPW and WEA, and random ones."""

import subprocess
from pathlib import Path

import numpy as np
import pvlib
import pytest

from skydome.year.calendar import month_day_hour
from skydome.year.wea import write_wea
from skydome.year.weather import Weather, read_weather

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
    return {"epw": folder / "site.epw", "wea": folder / "site.wea", "stress": folder / "stress.wea"}


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
def make_epw():
    return epw_row, HEADER
