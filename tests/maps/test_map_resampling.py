"""Resampling: light is conserved between all layouts and sizes, suns included, and a constant stays constant."""

import numpy as np
import pytest

from skydome.ground.directions import direction
from skydome.ground.units import deg
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.projections import CubeMap, EqualAreaSquare, Equirectangular, Equisolid, Fisheye
from skydome.maps.resample import resample

BALL = Fisheye(2 * np.pi, Equisolid())
SPHERE = [
    (Equirectangular(), 64),
    (Equirectangular(), 192),
    (Equirectangular(azimuth_left=0.1, mirrored=True), 96),
    (EqualAreaSquare(), 90),
    (EqualAreaSquare(), 200),
    (CubeMap(), 6 * 20),
    (CubeMap(), 6 * 64),
    (BALL, 150),
]
# at noon, on the seam, near the zenith, low, and where cube faces meet
SUNS = [(180, 60), (0.2, 20), (40, 89.8), (271, 1.0), (45, 35.2)]


def flux(pixels, projection):
    angles = np.broadcast_to(projection.solid_angles(len(pixels)), pixels.shape[:2])
    return np.einsum("ij,ijc->c", angles, pixels)


def hazy_sky(projection, height):
    """A bright horizon and a brown ground with texture."""
    toward = projection.directions(height)
    up = toward[..., 2:]
    rng = np.random.default_rng(4)
    texture = 1 + 0.3 * rng.uniform(-1, 1, toward.shape[:2])[..., None]
    sky = 2000 * np.array([1.0, 1.3, 2.0]) * (1.5 - np.abs(up)) * texture * (up > 0) + 300 * (up <= 0)
    return sky * projection.valid(height)[..., None]


def with_sun(pixels, projection, azimuth, elevation, brightness=1.6e9):
    row, column, _ = projection.pixels(direction(azimuth * deg, elevation * deg), len(pixels))
    pixels = pixels.copy()
    pixels[int(row), int(column)] = brightness * np.array([1.0, 0.9, 0.8])
    return pixels


def label(case):
    return f"{type(case[0]).__name__}{case[1]}"


@pytest.mark.parametrize("destination", SPHERE, ids=label)
@pytest.mark.parametrize("source", SPHERE, ids=label)
def test_flux_constants_and_one_texel_suns(source, destination):
    (layout, height), (new_layout, new_height) = source, destination
    valid = new_layout.valid(new_height)
    ones = np.full((*layout.shape(height), 3), 2.5)
    np.testing.assert_allclose(resample(ones, layout, new_layout, new_height)[valid], 2.5, rtol=1e-6)
    sky = hazy_sky(layout, height)
    calm = resample(sky, layout, new_layout, new_height)
    np.testing.assert_allclose(flux(calm, new_layout), flux(sky, layout), rtol=1e-3)
    sunny = sky
    for azimuth, elevation in SUNS:
        sunny = with_sun(sunny, layout, azimuth, elevation)
    result = resample(sunny, layout, new_layout, new_height)
    expected = flux(sunny, layout) - flux(sky, layout)
    np.testing.assert_allclose(flux(result, new_layout) - flux(calm, new_layout), expected, rtol=1e-4)
    assert (result[valid] >= 0).all()


@pytest.mark.parametrize("radius", [0.27, 1.0])
@pytest.mark.parametrize("destination", SPHERE, ids=label)
def test_a_disc_of_many_texels_keeps_its_flux_and_place(radius, destination):
    layout, height, centre = Equirectangular(), 512, direction(200 * deg, 33 * deg)
    sky = hazy_sky(layout, height)
    inside = layout.directions(height) @ centre > np.cos(radius * deg)
    sunny = np.where(inside[..., None], 1e9, sky)
    new_layout, new_height = destination
    difference = resample(sunny, layout, new_layout, new_height) - resample(sky, layout, new_layout, new_height)
    np.testing.assert_allclose(flux(difference, new_layout), flux(sunny - sky, layout), rtol=1e-3)
    weights = new_layout.solid_angles(new_height) * difference[..., 0]
    mean = np.einsum("ij,ijk->k", weights, new_layout.directions(new_height))
    assert mean / np.linalg.norm(mean) @ centre > np.cos(np.pi / min(new_layout.shape(new_height)))


@pytest.mark.parametrize("height", [100, 301])
def test_the_sky_half_goes_to_a_fisheye_and_back(height):
    sunny = with_sun(hazy_sky(Equirectangular(), 128), Equirectangular(), 222, 41)
    disc = resample(sunny, Equirectangular(), Fisheye(), height)
    above = sunny[:64]
    angles = Equirectangular().solid_angles(128)[:64]
    expected = (above * angles[..., None]).sum(axis=(0, 1))
    np.testing.assert_allclose(flux(disc, Fisheye()), expected, rtol=1e-3)
    assert (disc[~Fisheye().valid(height)] == 0).all()
    back = resample(disc, Fisheye(), Equirectangular(), 128)
    np.testing.assert_allclose(flux(back, Equirectangular()), expected, rtol=1e-3)
    assert (back[65:] == 0).all()


@pytest.mark.parametrize("quarter", range(4))
@pytest.mark.parametrize("mirrored", [False, True])
def test_whole_texel_turns_are_exact(quarter, mirrored):
    pixels = np.random.default_rng(5).random((32, 64, 3)).astype(np.float32)
    layout = Equirectangular(azimuth_left=quarter * np.pi / 2, mirrored=mirrored)
    turned = resample(pixels, Equirectangular(), layout, 32)
    assert turned.dtype == np.float32
    toward = layout.directions(32)
    row, column, _ = Equirectangular().pixels(toward, 32)
    np.testing.assert_array_equal(turned, pixels[np.floor(row).astype(int), np.floor(column).astype(int)])
    np.testing.assert_array_equal(resample(turned, layout, Equirectangular(), 32), pixels)


def test_halving_is_the_mean_by_solid_angle():
    pixels = np.random.default_rng(6).random((16, 32, 3))
    angles = np.broadcast_to(Equirectangular().solid_angles(16), (16, 32))
    small = resample(pixels, Equirectangular(), Equirectangular(), 8)
    blocks = (pixels * angles[..., None]).reshape(8, 2, 16, 2, 3).sum(axis=(1, 3))
    areas = angles.reshape(8, 2, 16, 2).sum(axis=(1, 3))
    np.testing.assert_allclose(small, blocks / areas[..., None], rtol=1e-12)


@pytest.mark.parametrize(("layout", "height"), [(Equirectangular(), 64), (EqualAreaSquare(), 90), (CubeMap(), 120)])
def test_rotated_moves_everything_clockwise(layout, height):
    sunny = with_sun(np.full((*layout.shape(height), 3), 100.0), layout, 100, 30, brightness=1e6)
    original = EnvironmentMap(sunny, layout)
    turned = original.rotated(90 * deg)
    assert turned.pixels.shape == original.pixels.shape
    before, after = original.vector_illuminance(), turned.vector_illuminance()
    np.testing.assert_allclose(after, [before[1], -before[0], before[2]], atol=2e-2 * np.linalg.norm(before))
    np.testing.assert_allclose(turned.illuminance(), original.illuminance(), rtol=2e-2)  # a sun of one large texel


def test_rotated_equirectangular_maps_lose_nothing():
    original = EnvironmentMap(np.random.default_rng(7).random((16, 32, 3)))
    turned = original.rotated(1.234)
    toward = direction(np.linspace(0, 6, 20), np.linspace(-1.5, 1.5, 20))
    moved = direction(np.linspace(0, 6, 20) + 1.234, np.linspace(-1.5, 1.5, 20))
    np.testing.assert_allclose(turned.sample(moved), original.sample(toward), atol=1e-12)


def test_nothing_bright_on_black_is_lost():
    dark = np.zeros((64, 128, 3))
    dark[10, 5] = 7.0
    for layout, height in ((EqualAreaSquare(), 33), (Equirectangular(), 256), (CubeMap(), 60)):
        np.testing.assert_allclose(
            flux(resample(dark, Equirectangular(), layout, height), layout), flux(dark, Equirectangular()), rtol=1e-6
        )
