"""Folders of captures: every layout, metadata, order, masks; everything that must be refused, in one line."""

import numpy as np
import pytest
from PIL import Image

import skydome as sd
from skydome import deg
from skydome.captures.capture import Capture
from skydome.captures.captures import LAYOUTS, read_captures
from skydome.captures.sky_mask import write_mask
from skydome.ground import exr
from skydome.ground.directions import angle_between
from skydome.maps.equirectangular import Equirectangular

PLACE = sd.Place(45.07, 7.69, 240)
TIMES = ("2026-06-21T08:00+02:00", "2026-06-21T11:00+02:00")


def picture_at(time, height=64, projection=None):
    sun = sd.sun_direction(PLACE, time)
    sky = sd.HosekWilkie(sun, 3.0)
    return sd.render(sky + sd.SunDisc.of(sky), height, projection=projection or Equirectangular())


def write(folder, name, picture, time=None, **metadata):
    notes = metadata | ({} if time is None else {"time": time})
    sd.EnvironmentMap(picture.pixels, picture.projection, metadata=notes).save(folder / name)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_every_layout_is_read_alike(layout, tmp_path):
    height = {"latlong": 64, "cube": 576}.get(layout, 128)
    for k, time in enumerate(TIMES):
        exr.write(tmp_path / f"{k}.exr", {"RGB": picture_at(time, height, LAYOUTS[layout]).pixels})
    captures = read_captures(tmp_path, layout)
    for capture, time in zip(captures, TIMES, strict=True):
        sun = sd.sun_direction(PLACE, time)
        assert float(angle_between(capture.sun, sun)) < 2.0 * deg
        assert isinstance(capture.picture.projection, Equirectangular)
        sky = capture.captured_sky()
        view = sd.direction(3.0, 1.0)
        assert float(sky.luminance(view)) == pytest.approx(float(sd.HosekWilkie(sun, 3.0).luminance(view)), rel=0.05)
        upper = capture.sky[: len(capture.sky) // 2]
        assert upper.mean() > 0.9


def test_times_order_and_the_computed_sun(tmp_path):
    write(tmp_path, "a.exr", picture_at(TIMES[1]), TIMES[1], latitude=45.07, longitude=7.69, altitude=240.0)
    write(tmp_path, "b.hdr", picture_at(TIMES[0]), TIMES[0], latitude=45.07, longitude=7.69, altitude=240.0)
    captures = read_captures(tmp_path)
    assert [capture.name for capture in captures] == ["b.hdr", "a.exr"]
    for capture, time in zip(captures, TIMES, strict=True):
        assert np.allclose(capture.sun, sd.sun_direction(PLACE, time), atol=1e-5)
    assert captures[1].sunlight[1] == pytest.approx(captures[1].sunlight[0], rel=0.5)


def test_times_in_names_and_masks_beside(tmp_path):
    for name, time in (("sky_2026-06-21T0800", TIMES[0]), ("sky_2026-06-21T1100", TIMES[1])):
        write(tmp_path, f"{name}.exr", picture_at(time))
    mask = np.zeros((64, 128), bool)
    mask[:20] = True
    write_mask(tmp_path / "sky_2026-06-21T1100.mask.png", mask)
    captures = read_captures(tmp_path, zone="Europe/Rome")
    assert [str(capture.time)[:16] for capture in captures] == ["2026-06-21T06:00", "2026-06-21T09:00"]
    assert not captures[1].sky[20:].any()


def test_negative_pixels_become_zero_and_are_counted():
    picture = picture_at(TIMES[0])
    pixels = picture.pixels.copy()
    pixels[3, :5] = -2.0
    capture = Capture.of(sd.EnvironmentMap(pixels))
    assert capture.clipped == 15
    assert capture.picture.pixels.min() >= 0


def refused(folder, message, **choices):
    with pytest.raises(ValueError, match=message) as caught:
        read_captures(folder, **choices)
    assert "\n" not in str(caught.value)


def test_refusals(tmp_path):
    refused(tmp_path / "none", "must be a folder")
    refused(tmp_path, "at least two .exr or .hdr maps, got 0")
    write(tmp_path, "a.exr", picture_at(TIMES[0]), TIMES[0])
    refused(tmp_path, "at least two .exr or .hdr maps, got 1")
    write(tmp_path, "b.exr", picture_at(TIMES[1], 32), TIMES[1])
    refused(tmp_path, "one size, but a.exr has 64 rows and b.exr 32")
    write(tmp_path, "b.exr", picture_at(TIMES[1]), TIMES[0])
    refused(tmp_path, "different times, got 2026-06-21T06:00.* for a.exr and b.exr")
    write(tmp_path, "b.exr", picture_at(TIMES[1]))
    refused(tmp_path, "a time or none, but b.exr has none")
    write(tmp_path, "b.exr", picture_at(TIMES[1], 64, LAYOUTS["fisheye"]), TIMES[1])
    refused(tmp_path, "layout asked for, .* but b.exr states Fisheye")
    exr.write(tmp_path / "b.exr", {"RGB": picture_at(TIMES[1], 64, LAYOUTS["fisheye"]).pixels})
    refused(tmp_path, "b.exr is 64 x 64, which is no map of the layout Equirectangular")
    refused(tmp_path, "layout must be one of latlong", layout="pyramid")
    (tmp_path / "b.exr").write_bytes(b"no map")
    refused(tmp_path, "expected an OpenEXR file")
    (tmp_path / "b.exr").unlink()
    Image.new("RGB", (128, 64)).save(tmp_path / "b.jpg")
    refused(tmp_path, "got the LDR picture b.jpg: 8 bit formats clip the sky")


def test_ldr_in_an_hdr_file_nan_and_overcast_are_refused(tmp_path):
    picture = picture_at(TIMES[0])
    shown = np.clip(picture.pixels / 20_000, 0, 1)
    with pytest.raises(ValueError, match=r"LDR picture stored as HDR .* 255 different values|LDR picture"):
        Capture.of(sd.EnvironmentMap((np.rint(shown * 255) / 255).astype(np.float32)), "a.exr")
    with pytest.raises(ValueError, match=r"of its texels share the largest value 1: they are clipped"):
        Capture.of(sd.EnvironmentMap(np.clip(picture.pixels / 4000, 0, 1)), "a.exr")
    broken = picture.pixels.copy()
    broken[0, 0] = np.nan
    with pytest.raises(ValueError, match=r"a.exr: pixels must be finite, got 3 values"):
        Capture.of(sd.EnvironmentMap(broken), "a.exr")
    grey = sd.render(sd.Daylight(sd.MoonSpencer(zenith_luminance=5000.0)), 64).pixels
    grey = (grey * np.random.default_rng(0).lognormal(0, 0.02, grey.shape)).astype(np.float32)
    with pytest.raises(ValueError, match=r"a.exr: no sun found"):
        Capture.of(sd.EnvironmentMap(grey), "a.exr")
