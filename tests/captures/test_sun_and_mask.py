"""Finding the sun and the sky: visible, burnt out, hidden, none; skylines; real HDR maps where they are at hand."""

import base64
import os
import re
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.captures.sky_mask import read_mask, sky_mask, write_mask
from skydome.captures.sun_finding import find_sun, sun_pixels
from skydome.ground.directions import angle_between


def day(elevation, height=128, disc=True, azimuth=100.0):
    sun = sd.direction(azimuth * deg, elevation * deg)
    sky = sd.HosekWilkie(sun, 3.0)
    picture = sd.render(sky + sd.SunDisc.of(sky) if disc else sky, height=height)
    noise = np.random.default_rng(1).lognormal(0, 0.02, picture.pixels.shape).astype(np.float32)
    return sd.EnvironmentMap(picture.pixels * noise), sun


@pytest.mark.parametrize("elevation", [10.0, 40.0, 75.0])
def test_the_sun_is_found_within_half_a_texel(elevation):
    picture, sun = day(elevation)
    found = find_sun(picture)
    assert found.visible
    assert not found.burnt_out
    assert float(angle_between(found.direction, sun)) < 0.5 * np.pi / 128


@pytest.mark.parametrize("elevation", [40.0, 75.0])
def test_a_burnt_out_sun_and_a_hot_pixel(elevation):
    picture, sun = day(elevation, height=256)
    pixels = np.minimum(picture.pixels, 0.5 * picture.pixels.max() ** 0.5 + 3e4)
    pixels[40, 400] = pixels.max()
    found = find_sun(sd.EnvironmentMap(pixels))
    assert float(angle_between(found.direction, sun)) < 1.0 * deg


@pytest.mark.parametrize("elevation", [25.0, 60.0])
def test_a_hidden_sun_is_found_by_the_skys_glow(elevation):
    picture, sun = day(elevation, disc=False)
    toward = picture.projection.directions(picture.height)
    cloud = angle_between(toward, sun) < 6 * deg
    pixels = picture.pixels.copy()
    pixels[cloud] = np.median(pixels[~cloud & (toward[..., 2] > 0)], axis=0)
    found = find_sun(sd.EnvironmentMap(pixels))
    assert float(angle_between(found.direction, sun)) < 12 * deg


def test_a_sun_below_a_ridge_is_no_disc():
    """Twilight: a glow about a sun under the horizon, cut off by dark land."""
    toward = sd.Equirectangular().directions(128)
    sun = sd.direction(221 * deg, -3 * deg)
    glow = 1 + 45 * np.exp(-((angle_between(toward, sun) / (14 * deg)) ** 2))
    ridge = toward[..., 2] < np.sin((2 + 1.5 * np.sin(7 * np.arctan2(toward[..., 0], toward[..., 1]))) * deg)
    pixels = np.where(ridge, 0.1, glow)[..., None] * np.array([1.3, 0.95, 0.8])
    found = find_sun(sd.EnvironmentMap(pixels.astype(np.float32)))
    assert not found.visible
    assert float(angle_between(found.direction, sun)) < found.doubt


@pytest.mark.parametrize("sky", [sd.Uniform(2000.0), sd.MoonSpencer(zenith_luminance=5000.0)])
def test_no_sun_in_an_overcast_sky(sky):
    with pytest.raises(ValueError, match=r"no sun found.*place and time"):
        find_sun(sd.render(sd.Daylight(sky), height=64))


def test_sun_pixels_are_few_and_hold_the_sun():
    picture, sun = day(40.0)
    mask = sun_pixels(picture, sun)
    row, column, _ = picture.projection.pixels(sun, 128)
    assert mask[int(row), int(column)]
    assert mask.sum() < 30


def with_skyline(picture, seed=0):
    height = picture.height
    column = np.arange(2 * height)
    line = height / 2 - height * (
        0.04 + 0.03 * np.sin(column / height * 7) + 0.1 * ((column // (height // 4)) % 3 == 1)
    )
    below = np.arange(height)[:, None] >= line
    pixels = picture.pixels.copy()
    level = 0.15 * np.median(pixels[: height // 2])
    rough = np.random.default_rng(seed).lognormal(0, 0.3, pixels.shape)
    pixels[below] = (level * rough * [1.0, 1.1, 0.6])[below]
    return sd.EnvironmentMap(pixels), ~below


def test_the_skyline_is_found():
    picture, sun = day(40.0)
    drawn, truth = with_skyline(picture)
    mask = sky_mask(drawn, sun)
    upper = slice(0, 64)
    assert np.mean(mask[upper] == truth[upper]) > 0.97
    assert not mask[64:].any()


def test_masks_go_through_a_file_and_wrong_sizes_are_refused(tmp_path):
    mask = np.zeros((16, 32), bool)
    mask[:7] = True
    write_mask(tmp_path / "a.mask.png", mask)
    assert (read_mask(tmp_path / "a.mask.png", mask.shape) == mask).all()
    with pytest.raises(ValueError, match="size of its map, 64 x 32, got 32 x 16"):
        read_mask(tmp_path / "a.mask.png", (32, 64))
    (tmp_path / "b.mask.png").write_text("no picture")
    with pytest.raises(ValueError, match="cannot read the mask"):
        read_mask(tmp_path / "b.mask.png", mask.shape)


def asset(name, folder):
    """A map of the npm package @pmndrs/assets (CC0), unpacked in $SKYDOME_ASSETS (docs/captured.md), clipped at 0."""
    place = os.environ.get("SKYDOME_ASSETS")
    if not place:
        pytest.skip("SKYDOME_ASSETS does not name an unpacked @pmndrs/assets")
    text = (Path(place) / "hdri" / f"{name}.exr.js").read_text()
    path = folder / f"{name}.exr"
    path.write_bytes(base64.b64decode(re.search(r"base64,([A-Za-z0-9+/=]+)", text)[1]))
    from skydome.ground import exr

    return sd.EnvironmentMap(np.maximum(exr.read(path)[0], 0))


@pytest.mark.parametrize(
    ("name", "row", "column"),
    [("sunrise", 116.6, 306.9), ("sunset", 123.6, 307.2), ("park", 113.0, 307.2), ("sky", 59.9, 304.8)],
)
def test_suns_of_real_maps(name, row, column, tmp_path):
    """Places read off the pictures by eye and by their brightest texels."""
    picture = asset(name, tmp_path)
    found = find_sun(picture)
    wanted = picture.projection.toward(row, column, picture.height)
    assert found.visible
    assert float(angle_between(found.direction, wanted)) < 1.5 * deg


def test_a_real_dawn_has_no_disc(tmp_path):
    """The glow's middle is read off the picture by eye; the sun is behind the hills."""
    found = find_sun(asset("dawn", tmp_path))
    assert not found.visible
    assert float(angle_between(found.direction, sd.direction(221 * deg, 2 * deg))) < found.doubt


@pytest.mark.parametrize("name", ["sunrise", "park", "sky"])
def test_real_maps_as_skies(name, tmp_path):
    """Exchanging the captured sun for a disc keeps the light on planes that face any way."""
    picture = asset(name, tmp_path)
    sky = sd.CapturedSky(picture, find_sun(picture).direction).relit(illuminance=20_000.0)
    assert float(sd.illuminance(sky.with_disc())) == pytest.approx(20_000.0, rel=0.03)
    level = np.array([sky.sun[0], sky.sun[1], 0.0])
    normals = sd.unit(np.array([level, -level, sky.sun]))
    np.testing.assert_allclose(sd.illuminance(sky.with_disc(), normals), sky.illuminance(normals), rtol=0.05)
    turned = sky.rotated(1.0)
    assert float(turned.illuminance()) == pytest.approx(20_000.0, rel=1e-2)
    assert float(turned.luminance(turned.sun)) == pytest.approx(float(sky.luminance(sky.sun)), rel=0.5)


@pytest.mark.parametrize(
    ("name", "least", "most"),
    [("sunrise", 0.85, 0.97), ("sunset", 0.75, 0.9), ("park", 0.9, 0.98), ("dawn", 0.9, 0.97), ("venice", 0.85, 0.95)],
)
def test_skies_of_real_maps(name, least, most, tmp_path):
    picture = asset(name, tmp_path)
    mask = sky_mask(picture, find_sun(picture).direction)
    assert least < mask[:128].mean() < most
    assert mask[:64].mean() > 0.9
