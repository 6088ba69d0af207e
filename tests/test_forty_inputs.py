"""Forty inputs as new users bring them: weather files, suns, units, angles, labels and renderers' headers."""

import gzip

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import skydome as sd

HEAD = ["place Turin", "latitude 45.07", "longitude -7.69", "time_zone -15", "site_elevation 240"]
HEAD += ["weather_data_file_units 1"]
HOURS = np.arange(0.5, 24)
ROWS = [f"6 21 {hour} {700 if 5 < hour < 20 else 0} {120 if 5 < hour < 20 else 0}" for hour in HOURS]


def tape(head=HEAD, rows=ROWS, end="\n"):
    return end.join([*head, *rows, ""])


def changed(number, line):
    return [line if k == number else old for k, old in enumerate(HEAD)]


TAPES = {
    "as it is": tape().encode(),
    "Windows' line ends": tape(end="\r\n").encode(),
    "byte order mark": b"\xef\xbb\xbf" + tape().encode(),
    "tabs": tape().replace(" ", "\t").encode(),
    "blank lines at the end": (tape() + "\n\n").encode(),
    "blanks at line ends": tape(end="  \n").encode(),
    "Latin-1": tape(changed(0, "place Malmö")).encode("latin-1"),
    "UTF-8": tape(changed(0, "place Malmö")).encode(),
    "a height with a climate": tape(changed(4, "site_elevation 240,Csb")).encode(),
    "form feed in the place": tape(changed(0, "place Turin\x0c old")).encode(),
    "packed": gzip.compress(tape().encode()),
}


@pytest.mark.parametrize("kind", TAPES)
def test_tapes(tmp_path, kind):
    path = tmp_path / ("turin.wea.gz" if kind == "packed" else "turin.wea")
    path.write_bytes(TAPES[kind])
    weather = sd.read_weather(path, year=2026)
    assert (weather.place.latitude, weather.place.longitude, weather.place.altitude) == (45.07, 7.69, 240)
    assert weather.count == 24
    assert weather.direct_normal[12] == 700
    assert not weather.missing.any()


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        (["latitude 95"], "latitude"),
        (["6 31 12.5 700 120"], r"line 7.*no such date"),
        (["6 21 12.5 much 120"], "line 7"),
        (["6 21 12.5 700"], "line 7"),
    ],
)
def test_tapes_that_are_refused_with_their_line(tmp_path, lines, told):
    path = tmp_path / "turin.wea"
    path.write_text(tape(changed(1, lines[0]) if lines[0].startswith("lat") else HEAD, lines + ROWS[:1]))
    with pytest.raises(ValueError, match=told):
        sd.read_weather(path, year=2026)


@pytest.mark.parametrize(
    "time",
    [
        "2026-06-21T12:00Z",
        "2026-06-21T14:00+02:00",
        "2026-06-21T17:30+05:30",
        np.datetime64("2026-06-21T12:00"),
        pd.Timestamp("2026-06-21T12:00", tz="UTC"),
        pd.Timestamp("2026-06-21T14:00", tz="Europe/Rome").to_pydatetime(),
    ],
    ids=str,
)
def test_one_instant_however_it_is_written(time):
    same = sd.sun_direction(sd.Place(45.07, 7.69), "2026-06-21T12:00Z")
    np.testing.assert_allclose(sd.sun_direction(sd.Place(45.07, 7.69), time), same, atol=1e-9)


@pytest.mark.parametrize(
    ("place", "time", "azimuth", "elevation"),
    [
        ((0.0, 0.0), "2026-03-20T12:07Z", None, 90.0),
        ((-33.87, 151.21), "2026-06-21T12:00+10:00", 0.0, 32.7),
        ((90.0, 0.0), "2026-06-21T00:00Z", None, 23.4),
        ((0.0, 180.0), "2026-03-20T00:07Z", None, 90.0),
    ],
)
def test_suns_that_are_known_by_heart(place, time, azimuth, elevation):
    turn, height = sd.sun_angles(sd.Place(*place), time)
    assert float(height) / sd.deg == pytest.approx(elevation, abs=0.5)
    if azimuth is not None:
        assert abs((float(turn) / sd.deg - azimuth + 180) % 360 - 180) < 2


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda: sd.direction(180, 45), "45 radians; degrees are written 45"),
        (lambda: sd.Camera(0.0, 30), "degrees are written 30"),
        (lambda: sd.Horizon([0.0, 1.0], [10, 20]), "degrees are written"),
        (lambda: sd.sun_direction(sd.Place(45.07, 7.69), "2026-06-21T12:00"), "zone"),
        (lambda: sd.Place(7.69, 245.07), "longitude must lie in"),
        (lambda: sd.Preetham(sd.ZENITH, 3.0).radiance(sd.NORTH, [0.55]), "nm"),
    ],
)
def test_units_that_cannot_be(call, told):
    with pytest.raises(ValueError, match=told):
        call()


@pytest.mark.parametrize("turn", [lambda: sd.direction(180, 0.1), lambda: sd.Equirectangular(90.0)])
def test_turns_in_degrees_are_told(turn):
    with pytest.warns(UserWarning, match="more than two turns"):
        turn()


@pytest.mark.parametrize(
    "haze",
    [
        pd.Series([2.0, 3.0], index=pd.date_range("2026-06-21", periods=2, tz="Europe/Rome")),
        pd.Series([2, 3], index=["a", "b"]),
        xr.DataArray([2.0, 3.0], dims="day"),
        xr.DataArray(np.float32([2.0, 3.0]), {"day": [1, 2]}, ["day"]),
    ],
    ids=["times", "whole numbers", "no coordinates", "float32"],
)
def test_labels(haze):
    sky = sd.HosekWilkie(sd.direction(2.0, 0.7), haze)
    light = sd.illuminance(sky)
    assert type(light) is type(haze)
    np.testing.assert_allclose(light, sd.illuminance(sd.HosekWilkie(sd.direction(2.0, 0.7), [[2.0], [3.0]])), rtol=1e-5)


TARGETS = ["native", "blender", "mitsuba", "openexr", "usd", "three", "skylibs", "pbrt"]


@pytest.mark.parametrize("target", TARGETS)
def test_headers_bring_a_map_back(tmp_path, target):
    sky = sd.render(sd.Preetham(sd.direction(2.0, 0.7), 3.0), 64, ground_albedo=0.1)
    sky.save(tmp_path / "sky.exr", target=target)
    back = sd.load(tmp_path / "sky.exr")
    for normal in (sd.ZENITH, sd.EAST, sd.SOUTH):
        assert float(back.illuminance(normal)) == pytest.approx(float(sky.illuminance(normal)), rel=0.02)
