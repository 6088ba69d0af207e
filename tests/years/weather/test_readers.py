"""What other programs write: encodings, quotes, marks of missing values, years of their own, layouts of services."""

import gzip
import warnings
from pathlib import Path

import numpy as np
import pvlib
import pytest

import skydome as sd
from skydome.light.decomposition import NAME, erbs
from skydome.sun.place import Place
from skydome.years.skies.series import year
from skydome.years.weather.calendar import days_from, laid_years
from skydome.years.weather.reading import read_weather
from skydome.years.weather.sun_of_interval import lit_sun
from skydome.years.weather.text import LARGEST, text_of

PVLIB = Path(pvlib.__file__).parent / "data"
pytestmark = pytest.mark.filterwarnings("ignore:.* rows are missing of the period")
TAPE = "place a_b\nlatitude 50\nlongitude -10\ntime_zone -15\nsite_elevation 0\nweather_data_file_units 1\n"


@pytest.fixture
def epw(tmp_path, make_epw):
    """Writes an EPW of some rows, its text changed by a function, and reads it."""
    row, header = make_epw

    def written(change=lambda text: text, rows=None, encoding="utf-8", **choices):
        text = header.format(name="Zürich", latitude=50, longitude=10, offset=1, altitude=0)
        rows = rows or [row(6, 21, hour, 10, 500, 100) for hour in (11, 12, 13)]
        (tmp_path / "a.epw").write_bytes(change(text + "\n".join(rows) + "\n").encode(encoding))
        return read_weather(tmp_path / "a.epw", **choices)

    return written


@pytest.mark.parametrize(
    ("change", "encoding"),
    [
        (lambda text: "\ufeff" + text, "utf-8"),
        (lambda text: text, "latin-1"),
        (lambda text: text, "utf-16"),
        (lambda text: text.replace("\n", "\r\n"), "utf-8"),
        (lambda text: text.replace("\n", "\r"), "utf-8"),
        (lambda text: text.replace("made for a test", "a\x0cb\u2028c\u2029d\x85e\x1cf"), "utf-8"),
        (lambda text: text.replace("COMMENTS 2,-", "COMMENTS 2,-\nCOMMENTS 3,more"), "utf-8"),
        (lambda text: text.replace("LOCATION,Zürich,", 'LOCATION,"Zürich",'), "utf-8"),
        (lambda text: "\n".join(line + ",,," for line in text.splitlines()), "utf-8"),
        (lambda text: text + "\n\n\x1a", "utf-8"),
        (lambda text: text.replace("\n2023", "\n\n2023"), "utf-8"),
    ],
)
def test_the_same_weather_however_it_is_written(epw, change, encoding):
    weather = epw(change, encoding=encoding)
    assert (weather.place, weather.name) == (Place(50, 10, 0), "Zürich")
    assert weather.direct_normal.tolist() == [500, 500, 500]


@pytest.mark.parametrize("city", ['"Town, North"', "Town, North", '"Say ""hi"", town"'])
def test_commas_in_a_city_move_no_column(epw, city):
    weather = epw(lambda text: text.replace("Zürich", city))
    assert (weather.place, weather.utc_offset) == (Place(50, 10, 0), 1)


@pytest.mark.parametrize("mark", ["", " ", "nan", "NA", "-999", "-9999", "9999", "99999", "-9900", "-99"])
def test_every_mark_of_a_missing_value(epw, make_epw, mark):
    rows = [make_epw[0](6, 21, hour, 10, 500, 777 if hour == 12 else 100) for hour in (11, 12, 13)]
    data = year(epw(lambda text: text.replace("777", mark), rows))
    assert data.diffuse_horizontal_irradiance.isnull().values.tolist() == [False, True, False]
    assert np.isnan(data.luminance.values).all(axis=1).tolist() == [False, True, False]


def test_a_packed_file_and_one_by_another_name(epw, tmp_path):
    plain = epw()
    text = (tmp_path / "a.epw").read_bytes()
    (tmp_path / "b.epw.gz").write_bytes(gzip.compress(text))
    (tmp_path / "c.txt").write_bytes(text)
    for name in ("b.epw.gz", "c.txt"):
        assert np.array_equal(read_weather(tmp_path / name).start, plain.start)
    (tmp_path / "d.epw.gz").write_bytes(gzip.compress(text)[:-20])
    with pytest.raises(ValueError, match=r"d.epw.gz: a damaged gzip file"):
        read_weather(tmp_path / "d.epw.gz")


def test_too_large_a_file_is_not_unpacked(tmp_path):
    with gzip.open(tmp_path / "bomb.epw.gz", "wb", compresslevel=1) as file:
        for _ in range(LARGEST // 2**22 + 1):
            file.write(bytes(2**22))
    with pytest.raises(ValueError, match="may have 256 MiB of text"):
        text_of(tmp_path / "bomb.epw.gz")


@pytest.mark.parametrize(
    ("years", "months", "laid"),
    [
        ([2019, 2019, 2020, 2020], [11, 12, 1, 2], [2019, 2019, 2020, 2020]),  # July to June, with years given
        ([2018, 2019, 2020, 2021], [1, 1, 1, 1], [2018, 2019, 2020, 2021]),  # one row a year
        ([0, 0, 0, 0], [11, 12, 1, 2], [2022, 2022, 2023, 2023]),  # a tape over New Year
        ([2003, 1999, 2010, 2001], [1, 2, 3, 12], [2023] * 4),  # a typical year
        ([1999, 2001, 2003, 2004], [1, 2, 3, 12], [2023] * 4),  # one whose years happen to rise
        ([2007, 2009, 2001, 2002], [7, 12, 1, 6], [2022, 2022, 2023, 2023]),  # a typical one from July to June
    ],
)
def test_years_are_kept_where_they_follow_one_another(years, months, laid):
    if years == [2018, 2019, 2020, 2021]:
        months = [12, 11, 10, 9]
    found = laid_years(*(np.array(column, float) for column in (years, months, [5] * 4)), None)
    assert found.tolist() == laid


def test_a_leap_day_after_new_year_lies_in_a_leap_year():
    months, days = np.array([12.0, 1, 2]), np.array([31.0, 1, 29])
    assert laid_years(np.zeros(3), months, days, None).tolist() == [2023, 2024, 2024]
    assert laid_years(np.zeros(3), months, days, 2027).tolist() == [2027, 2028, 2028]
    with pytest.raises(ValueError, match="2025 has not; give a leap year"):
        laid_years(np.zeros(3), months, days, 2024)


def test_a_tape_across_new_year(tmp_path):
    (tmp_path / "a.wea").write_text(TAPE + "12 31 22.5 0 0\n12 31 23.5 0 0\n1 1 0.5 0 0\n1 1 1.5 0 0\n")
    weather = read_weather(tmp_path / "a.wea")
    assert (np.diff(weather.start) == np.timedelta64(3600, "s")).all()


@pytest.mark.parametrize(
    ("old", "new", "value"),
    [
        ("elevation 0", "elevation 235,Csb", 235),
        ("elevation 0", "elevation 12.5 m", 12.5),
        ("place a", "Place a", 0),
        ("latitude ", "latitude\t", 0),
    ],
)
def test_headers_of_tapes_with_words_after_numbers(tmp_path, old, new, value):
    (tmp_path / "a.wea").write_text("\ufeff" + (TAPE + "6 21 12.5 500 100\n").replace(old, new))
    assert read_weather(tmp_path / "a.wea").place.altitude == value


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("a.wea", TAPE.replace("latitude 50", "latitude 50,5") + "6 21 12 1 1\n", "line 2: latitude must be a number"),
        ("a.wea", TAPE.replace("latitude 50", "latitude 91") + "6 21 12 1 1\n", "latitude must lie in"),
        ("a.wea", TAPE + "6 21 25 1 1\n", r"line 7, column 3 \(hour\): hour must lie in \[0, 24\], got 25"),
        (
            "a.wea",
            TAPE + "6 21 12 1 3000\n",
            r"line 7, column 5 \(diffuse\): must lie in \[-10, 2000\] W m-2, got 3000",
        ),
        ("a.wea", TAPE + "6 31 12 1 1\n", "line 7: no such date as month 6, day 31"),
        ("a.wea", TAPE, "at least one row of data, got none"),
        ("a.wea", TAPE + "6 21 12 1 1\n6 21 11 1 1\n", "line 8: times must increase, got 2023-06-21 11:00 after"),
        ("a.csv", "Latitude,Longitude\n45\n", r"line 2 \(timezone\): must be a number"),
        ("a.csv", "Latitude,Longitude,Time Zone,Elevation\n45,8,1,2\nA,B\n1,2\n", "line 3: needs columns Month, Day"),
        ("a.csv", "month,day,hour,dni,dhi\n6,21,12,500,100\n", "does not say where it is from; give place="),
        ("a.epw", "", "line 1: not a weather file of a kind"),
        ("a.epw", "\x00\x01\x02" * 99, "line 1: not a weather file of a kind"),
    ],
)
def test_what_cannot_be_read_is_told_by_file_line_and_column(tmp_path, name, text, message):
    (tmp_path / name).write_text(text)
    with pytest.raises(ValueError, match=message) as caught:
        read_weather(tmp_path / name)
    assert name in str(caught.value)
    assert "\n" not in str(caught.value)


def test_tmy3_and_tm2_as_pvlib_reads_them():
    for name, columns in (("723170TYA.CSV", ("dni", "dhi", "temp_dew")), ("12839.tm2", ("DNI", "DHI", "DewPoint"))):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            if name.endswith("CSV"):
                frame, facts = pvlib.iotools.read_tmy3(PVLIB / name, map_variables=True)
            else:
                frame, facts = pvlib.iotools.read_tmy2(PVLIB / name)
        ours = read_weather(PVLIB / name)
        tenths = 10 if name.endswith("tm2") else 1
        for found, column in zip((ours.direct_normal, ours.diffuse_horizontal, ours.dew_point), columns, strict=True):
            scale = tenths if "ew" in column else 1
            assert np.allclose(found, frame[column].to_numpy(dtype=float) / scale, equal_nan=True)
        assert np.allclose([ours.place.latitude, ours.place.longitude], [facts["latitude"], facts["longitude"]])


PSM = """Source,Location ID,City,State,Country,Latitude,Longitude,Time Zone,Elevation,Local Time Zone,DNI Units
NSRDB,149190,-,-,-,31.69,-106.38,-7,1111,-7,w/m2
Year,Month,Day,Hour,Minute,DNI,Clearsky DNI,DHI,GHI,Dew Point,Temperature
2010,6,21,11,30,900,950,100,960,3.5,30
2010,6,21,12,30,910,950,101,,,30
"""
SAM = """Latitude,Longitude,Time Zone,Elevation
33.45,-111.98,-7,358
Year,Month,Day,Hour,Global (W/m2),Beam (W/m2),Diffuse (W/m2),Tdry,Tdew
,,,,W/m2,W/m2,W/m2,C,C
1999,6,21,11,960,900,100,30,3
1999,6,21,12,970,910,101,30,3
"""
PVGIS = """Latitude (decimal degrees):\t45.0
Longitude (decimal degrees):\t8.0
Elevation (m):\t250.0
Radiation database:\tPVGIS-SARAH3


Slope: 0 deg.
Azimuth: 0 deg.
time,Gb(i),Gd(i),Gr(i),H_sun,T2m,WS10m,Int
20230621:1111,600.0,110.0,0.0,67.0,25.0,1.0,0.0
20230621:1211,610.0,111.0,0.0,66.0,25.0,1.0,0.0

Gb(i): Beam (direct) irradiance on the inclined plane
"""


@pytest.mark.parametrize("text", [PSM, SAM])
def test_nsrdb_and_sam(tmp_path, text):
    (tmp_path / "a.csv").write_text(text)
    weather = read_weather(tmp_path / "a.csv")
    assert [str(time) for time in weather.local] == [
        f"{weather.local[0].astype('M8[Y]')}-06-21T{h}:30:00" for h in (11, 12)
    ]
    assert weather.direct_normal.tolist() == [900, 910]
    assert weather.diffuse_horizontal.tolist() == [100, 101]
    assert weather.utc_offset == -7
    assert weather.dew_point[0] in (3, 3.5)


def test_a_series_of_pvgis_on_the_horizontal(tmp_path):
    (tmp_path / "a.csv").write_text(PVGIS)
    weather = read_weather(tmp_path / "a.csv")
    assert str(weather.middle[0]) == "2023-06-21T11:11:00"
    assert np.allclose(weather.direct_normal * lit_sun(weather).directions[:, 2], [600, 610], rtol=1e-5)
    (tmp_path / "a.csv").write_text(PVGIS.replace("Slope: 0", "Slope: 35"))
    with pytest.raises(ValueError, match=r"a.csv: irradiance on a tilted plane \(slope 35 deg.\)"):
        read_weather(tmp_path / "a.csv")


def test_a_table_without_a_site_takes_one(tmp_path):
    (tmp_path / "a.csv").write_text("Month,Day,Hour,DNI,DHI\n6,21,11,900,100\n6,21,12,910,101\n")
    weather = read_weather(tmp_path / "a.csv", place=Place(40, -105), utc_offset=-7)
    assert str(weather.middle[0]) == "2023-06-21T18:30:00"
    assert weather.place == Place(40, -105)


def test_global_irradiance_alone_is_split_as_pvlib_splits_it(greensboro, tmp_path):
    """Erbs on each: the diffuse part within 1 % of pvlib's of the same suns, in the sum 0.3 %."""
    import pandas as pd

    sun = lit_sun(greensboro)
    times = pd.DatetimeIndex(greensboro.end).tz_localize("UTC")
    with pytest.warns(UserWarning, match=r"no direct and diffuse irradiance: found from the global one \(Erbs"):
        weather = sd.Weather.from_frame(
            pd.DataFrame({"ghi": greensboro.global_horizontal}, index=times), greensboro.place
        )
    assert weather.decomposition == NAME
    high = (sun.directions[:, 2] > 0.1) & (greensboro.global_horizontal > 20)
    zenith = np.degrees(np.arccos(sun.directions[:, 2]))
    day_of_year = (sun.times.astype("M8[D]") - sun.times.astype("M8[Y]")).astype(int) + 1
    peer = pvlib.irradiance.erbs(greensboro.global_horizontal, zenith, day_of_year)
    whole = high & (sun.lit == 1)
    assert np.allclose(weather.diffuse_horizontal[whole], peer["dhi"][whole], rtol=0.01, atol=1)
    assert np.isclose(weather.direct_normal[whole].sum(), peer["dni"][whole].sum(), rtol=0.003)
    error = weather.direct_normal[whole] - greensboro.direct_normal[whole]
    theirs = peer["dni"][whole] - greensboro.direct_normal[whole]
    assert np.sqrt(np.mean(error**2)) < 1.01 * np.sqrt(np.mean(theirs**2))
    assert "decomposition" in year(weather).attrs


def test_one_missing_column_is_found_by_closure(greensboro):
    import pandas as pd

    times = pd.DatetimeIndex(greensboro.end).tz_localize("UTC")
    columns = {"ghi": greensboro.global_horizontal, "dhi": greensboro.diffuse_horizontal}
    with pytest.warns(UserWarning, match="no direct irradiance: found from the global one"):
        weather = sd.Weather.from_frame(pd.DataFrame(columns, index=times), greensboro.place)
    high = (lit_sun(greensboro).directions[:, 2] > 0.2) & (greensboro.direct_normal > 50)
    assert np.median(np.abs(weather.direct_normal[high] / greensboro.direct_normal[high] - 1)) < 0.01


def test_the_share_of_diffuse_light_has_no_jump():
    clearness = np.linspace(0.01, 0.99, 400)
    share = erbs(1367.0 * clearness, np.ones(400))
    assert (np.abs(np.diff(share)) < 0.02).all()
    assert np.allclose(erbs(1367.0 * np.array([0.1, 0.5, 0.9]), np.ones(3)), [0.991, 0.6592, 0.165], atol=2e-4)


def test_days_of_periods():
    assert days_from((0, 7, 1), (0, 6, 30)) == 365
    assert days_from((0, 2, 30), (0, 3, 1)) is None
