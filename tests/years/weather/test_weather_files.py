"""Weather files: each reader against the same year, labels, leap days, missing values, bad rows."""

from pathlib import Path

import numpy as np
import pandas as pd
import pvlib
import pytest

import skydome as sd
from skydome.sun.track import SunTrack
from skydome.years.skies.series import year
from skydome.years.skies.status import BITS
from skydome.years.weather.plausibility import share_at_night, warn_of_wrong_place
from skydome.years.weather.reading import read_weather
from skydome.years.weather.sun_of_interval import crossing, lit_sun
from skydome.years.weather.wea import read_wea, write_wea

DATA = Path(pvlib.__file__).parent / "data"
pytestmark = pytest.mark.filterwarnings("ignore:.* rows are missing of the period")


def test_epw_and_wea_tell_the_same_year(files, greensboro):
    epw, wea = read_weather(files["epw"]), read_weather(files["wea"])
    for weather in (epw, wea):
        assert weather.count == 8760
        assert np.array_equal(weather.middle, greensboro.middle)
        assert np.allclose(weather.direct_normal, greensboro.direct_normal)
        assert np.isclose(weather.place.longitude, -79.95)
    assert np.allclose(epw.dew_point, greensboro.dew_point)
    assert epw.label == "end"
    assert str(epw.end[0]) == "2023-01-01T06:00:00"  # the first row is labelled 1:00 at UTC-5


def test_pvlib_reads_the_epw_that_was_made(files, greensboro):
    frame, facts = pvlib.iotools.read_epw(files["epw"])
    assert np.allclose(frame["dni"], greensboro.direct_normal)
    assert facts["longitude"] == -79.95


@pytest.mark.parametrize(("name", "altitude"), [("703165TY.csv", 7), ("723170TYA.CSV", 273), ("12839.tm2", 2)])
def test_typical_years_have_no_light_while_the_sun_is_down(name, altitude):
    weather = read_weather(DATA / name)
    light = sum(weather.irradiances)
    assert weather.count == 8760
    assert weather.place.altitude == altitude
    dark = lit_sun(weather).lit == 0
    assert light[dark].sum() < 1e-4 * light.sum()
    assert light[~dark].sum() > 0


def test_a_short_row_of_tm2_is_told(tmp_path):
    lines = (DATA / "12839.tm2").read_text().splitlines()
    (tmp_path / "cut.tm2").write_text("\n".join([*lines[:3], lines[3][:97], *lines[4:]]))
    with pytest.raises(ValueError, match="line 4: a row needs 142 characters, got 97"):
        read_weather(tmp_path / "cut.tm2")


def test_tm2_dew_point_is_in_degrees():
    assert read_weather(DATA / "12839.tm2").dew_point[:3].tolist() == [15.0, 15.6, 15.6]


def test_the_sun_is_taken_at_the_middle_of_the_lit_part(greensboro):
    sun = lit_sun(greensboro)
    lit = sun.lit > 0
    assert np.degrees(sd.angle_between(sun.directions, sd.sun_direction(greensboro.place, sun.times))).max() < 0.006
    assert (sun.directions[lit, 2] > 0).all()
    part = lit & (sun.lit < 1)
    assert 2 * 364 <= part.sum() <= 2 * 366
    rising = np.flatnonzero(part)[0]
    sunrise = greensboro.end[rising] - np.timedelta64(int(sun.lit[rising] * 3600), "s")
    assert abs(np.degrees(np.arcsin(sd.sun_direction(greensboro.place, sunrise)[2]))) < 0.02
    middle = sunrise + (greensboro.end[rising] - sunrise) // 2
    assert abs((sun.times[rising] - middle).astype(int)) <= 2
    whole = sun.lit == 1
    assert np.array_equal(sun.times[whole], greensboro.middle[whole])


def test_a_polar_year_has_whole_days_and_nights():
    times = pd.date_range("2026-01-01", periods=8760, freq="h", tz="UTC")
    weather = sd.Weather.from_frame(pd.DataFrame({"dni": 0.0, "dhi": 0.0}, index=times), sd.Place(80.0, 20.0))
    lit = lit_sun(weather).lit
    assert (lit[times.month == 6] == 1).all()
    assert (lit[times.month == 12] == 0).all()


def test_frames_at_any_step_and_label(greensboro):
    times = pd.date_range("2026-06-21T00:00", periods=96, freq="15min", tz="America/New_York")
    frame = pd.DataFrame({"beam": 500.0, "dhi": 100.0}, index=times)
    ends = sd.Weather.from_frame(frame, greensboro.place, direct_normal="beam")
    starts = sd.Weather.from_frame(frame, greensboro.place, direct_normal="beam", label="start")
    assert (starts.middle - ends.middle == np.timedelta64(900, "s")).all()
    assert (
        str(sd.Weather.from_frame(frame, greensboro.place, "beam", label="instant").middle[0]) == "2026-06-21T04:00:00"
    )
    with pytest.raises(ValueError, match="no column for direct_normal"):
        sd.Weather.from_frame(frame, greensboro.place)
    with pytest.raises(ValueError, match="a time needs its zone"):
        sd.Weather.from_frame(frame.tz_localize(None), greensboro.place, "beam")
    with pytest.raises(ValueError, match="must hold numbers"):
        sd.Weather.from_frame(frame.assign(beam="much"), greensboro.place, "beam")
    with pytest.raises(ValueError, match="label must be"):
        sd.Weather.from_frame(frame, greensboro.place, "beam", label="left")


def test_sub_hourly_epw(tmp_path, make_epw):
    row, header = make_epw
    text = header.format(name="a", latitude=50, longitude=10, offset=1, altitude=0).replace(
        "PERIODS,1,1", "PERIODS,1,4"
    )
    rows = [row(6, 21, 12, 10, 500, 100, minute=minute) for minute in (15, 30, 45, 60)]
    (tmp_path / "quarter.epw").write_text(text + "\n".join(rows) + "\n")
    weather = read_weather(tmp_path / "quarter.epw")
    assert [str(time) for time in weather.start] == [f"2023-06-21T10:{m:02d}:00" for m in (0, 15, 30, 45)]


def test_leap_days_and_years(tmp_path, make_epw):
    row, header = make_epw
    head = header.format(name="a", latitude=50, longitude=10, offset=1, altitude=0)
    rows = [row(2, 29, 12, 10, 500, 100, year=1999), row(3, 1, 12, 10, 500, 100, year=2001)]
    (tmp_path / "leap.epw").write_text(head + "\n".join(rows) + "\n")
    assert str(read_weather(tmp_path / "leap.epw").start[0])[:10] == "2024-02-29"
    assert str(read_weather(tmp_path / "leap.epw", year=2028).start[1])[:10] == "2028-03-01"
    with pytest.raises(ValueError, match="2023 has not; give a leap year"):
        read_weather(tmp_path / "leap.epw", year=2023)


def test_missing_and_slightly_negative_values(tmp_path, make_epw):
    row, header = make_epw
    head = header.format(name="a", latitude=50, longitude=10, offset=1, altitude=0)
    rows = [row(6, 21, 11, 99.9, 9999, 100), row(6, 21, 12, 10, -2, 100), row(6, 21, 13, 10, 500, 100)]
    (tmp_path / "gaps.epw").write_text(head + "\n".join(rows) + "\n\n")
    weather = read_weather(tmp_path / "gaps.epw")
    assert weather.missing.tolist() == [True, False, False]
    assert weather.negative.tolist() == [False, True, False]
    assert weather.irradiances[0].tolist() == [0, 0, 500]
    assert np.isnan(weather.dew_point[0])


@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (lambda text: text[: text.rindex(",0,0")][:-40], "a row needs 16 fields or more"),
        (
            lambda text: text.replace("777", "much"),
            r"line 9, column 15 \(direct normal\): must be a number, got 'much'",
        ),
        (lambda text: text.replace("777", "-777"), r"line 9, column 15 \(direct normal\): must lie in .* got -777"),
        (lambda text: text.replace("777", "inf"), r"line 9, column 15 .*: numbers must be finite, got 'inf'"),
        (lambda text: text.replace("2023,6,21", "2023,6,31"), "line 9: no such date as month 6, day 31"),
        (lambda text: text.replace("21,12,60", "21,25,60"), "hour must be 1-24, got 25"),
        (lambda text: text.replace("50,10,1,0", "50,ten,1,0"), "LOCATION must have latitude"),
        (lambda text: text.replace("50,10,1,0", "50,10,1,nan"), "line 1: the elevation must be a finite number"),
        (lambda text: text[::-1].replace("9?", "0,9?", 1)[::-1], "line 10: a row has 35 fields at most, got 36"),
        (lambda text: text.replace("PERIODS,1,1", "PERIODS,1,7"), "DATA PERIODS must tell"),
        (lambda text: text[10:], "line 1: not a weather file of a kind that is read here"),
        (lambda text: "\n".join(text.splitlines()[:8]), "at least one row"),
        (
            lambda text: text + text.splitlines()[8] + "\n",
            "line 11: times must increase, got 2023-06-21 12:00 after 2023-06-21 13:00",
        ),
    ],
)
def test_bad_epw_rows_are_told_by_line(tmp_path, make_epw, spoil, message):
    row, header = make_epw
    text = header.format(name="a", latitude=50, longitude=10, offset=1, altitude=0)
    text += row(6, 21, 12, 10, 777, 100) + "\n" + row(6, 21, 13, 10, 500, 100) + "\n"
    (tmp_path / "bad.epw").write_text(spoil(text))
    with pytest.raises(ValueError, match=message):
        read_weather(tmp_path / "bad.epw")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("6 21 12.5 500 100", "6 21 12.5 500", "line 7: a row has 5 finite numbers"),
        ("6 21 12.5 500 100", "6 21 12.5 x 100", r"line 7, column 4 \(direct\): must be a number, got 'x'"),
        ("latitude", "lat", "line 2: a WEA file has latitude here"),
        ("units 1", "units 4", r"must be 1 or 2 \(irradiances\) or 3 \(illuminances\), got 4"),
        (
            "units 1\n6 21 12.5 500",
            "units 3\n6 21 12.5 160000",
            r"line 7, column 4 .*: illuminances must lie in .* lx, got 160000",
        ),
        ("longitude -10", "longitude west", "line 3: longitude must be a number, got 'west'"),
    ],
)
def test_bad_tapes(tmp_path, old, new, message):
    head = "place a\nlatitude 50\nlongitude -10\ntime_zone -15\nsite_elevation 0\nweather_data_file_units 1\n"
    (tmp_path / "bad.wea").write_text((head + "6 21 12.5 500 100\n").replace(old, new))
    with pytest.raises(ValueError, match=message):
        read_weather(tmp_path / "bad.wea")


def test_horizontal_direct_becomes_normal(tmp_path):
    head = "place a\nlatitude 50\nlongitude -10\ntime_zone -15\nsite_elevation 0\nweather_data_file_units 2\n"
    (tmp_path / "flat.wea").write_text(head + "6 21 12.5 500 100\n")
    weather = read_wea(tmp_path / "flat.wea")
    sine = lit_sun(weather).directions[0, 2]
    assert np.isclose(weather.direct_normal[0] * sine, 500)


def test_illuminances_are_kept_and_their_irradiances_found(tmp_path, change_tape, files):
    """There and back: the illuminances of a year, written as a tape of units 3.

    Some hours on the border of two bins of clearness have two answers: 2.5 % of those with the sun above 5 degrees.
    """
    given = year(read_wea(files["wea"]))
    columns = given.direct_normal_illuminance.values, given.diffuse_horizontal_illuminance.values
    (tmp_path / "lux.wea").write_text(change_tape(files["wea"].read_text(), 3, lambda *_: columns))
    weather = read_wea(tmp_path / "lux.wea")
    data = year(weather)
    assert np.allclose(data.diffuse_horizontal_illuminance, columns[1], rtol=1e-6)
    assert np.allclose(data.direct_normal_illuminance, columns[0], rtol=1e-6)
    assert np.allclose(data.luminance @ data.horizontal_solid_angle, columns[1], rtol=1e-5)
    high = (given.sun_elevation.values > 5) & (given.diffuse_horizontal_irradiance.values > 5)
    change = weather.diffuse_horizontal[high] / given.diffuse_horizontal_irradiance.values[high] - 1
    assert np.median(np.abs(change)) < 2e-4
    assert np.mean(np.abs(change) < 0.01) > 0.97
    patches = np.abs(data.luminance.values[high] / np.maximum(given.luminance.values[high], 1) - 1).max(axis=1)
    assert np.mean(patches < 0.01) > 0.96
    part = weather.rows(slice(10, 20))
    assert np.array_equal(part.diffuse_illuminance, weather.diffuse_illuminance[10:20])


def test_negative_light_counts_as_none(tmp_path):
    head = "place a\nlatitude 50\nlongitude -10\ntime_zone -15\nsite_elevation 0\nweather_data_file_units 3\n"
    (tmp_path / "dim.wea").write_text(head + "6 21 12.5 -300 9000\n6 21 13.5 50000 9000\n")
    data = year(read_wea(tmp_path / "dim.wea"))
    assert data.direct_normal_illuminance.values.tolist() == [0, 50000]
    assert (data.status.values & BITS["negative"] > 0).tolist() == [True, False]


@pytest.mark.parametrize("latitude", [0.0, 36.0, 66.0, 67.5, 75.0, -85.0])
@pytest.mark.parametrize("step", [1800.0, 43200.0])
def test_sunrise_is_found_within_half_a_second(latitude, step):
    """Against halving to a millisecond, from half hours to half days, where the sun's course is far from straight."""
    place, start = sd.Place(latitude, 15.0), np.datetime64("2023-01-01", "s")
    track = SunTrack.over(start, start + np.timedelta64(365, "D"))
    left = start.astype(float) + np.arange(0.0, 365 * 86400.0, 3600.0)
    up = [track.directions(place, edge)[:, 2] > 0 for edge in (left, left + step)]
    left, rising = left[up[0] != up[1]], up[1][up[0] != up[1]]
    low, high = left.copy(), left + step
    for _ in range(27):
        middle = (low + high) / 2
        before = (track.directions(place, middle)[:, 2] > 0) != rising
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    assert np.max(np.abs(crossing(track, place, left, left + step) - middle)) < 0.5


def test_tapes_keep_what_they_are_given(tmp_path, greensboro):
    write_wea(greensboro, tmp_path / "again.wea")
    again = read_wea(tmp_path / "again.wea")
    assert np.array_equal(again.diffuse_horizontal, greensboro.diffuse_horizontal)
    assert again.utc_offset == greensboro.utc_offset


@pytest.mark.parametrize("name", ["notes.txt", "site.csv", "site.tm2", "site.epw"])
def test_other_files_are_refused(tmp_path, name):
    (tmp_path / name).write_text("nothing\n")
    with pytest.raises(ValueError, match=rf"{name}, line 1: not a weather file of a kind that is read here"):
        read_weather(tmp_path / name)


def test_a_wrong_sign_is_noticed(greensboro):
    place = greensboro.place
    assert share_at_night(greensboro, place) < 1e-4
    warn_of_wrong_place(greensboro)
    for wrong in (sd.Place(place.latitude, -place.longitude), sd.Place(-place.latitude, place.longitude)):
        with pytest.warns(UserWarning, match="is a sign wrong"):
            warn_of_wrong_place(greensboro.at(wrong))
