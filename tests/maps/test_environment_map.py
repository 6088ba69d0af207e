"""The environment map: units, lookups and the integrals of its light."""

import numpy as np
import pytest

from skydome.ground.directions import EAST, NORTH, WEST, ZENITH, direction, unit
from skydome.light.colour import ACESCG, REC2020, SRGB
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.projections import CubeMap, EqualAreaSquare, Equirectangular, Equisolid, Fisheye

LAYOUTS = [
    (Equirectangular(), 64),
    (EqualAreaSquare(), 91),
    (CubeMap(), 6 * 36),
    (CubeMap(), 6 * 37),
    (Fisheye(2 * np.pi, Equisolid()), 400),
]
NORMALS = [ZENITH, -ZENITH, NORTH, EAST, np.array([0.6, 0.0, 0.8]), unit(np.array([1.0, -2.0, 0.3]))]


@pytest.mark.parametrize(("layout", "height"), LAYOUTS)
def test_uniform_luminance_gives_pi(layout, height):
    grey = EnvironmentMap(np.full((*layout.shape(height), 3), 2.0, dtype=np.float64), layout, white_luminance=10.0)
    tolerance = 2e-3 if isinstance(layout, Fisheye) else 2e-5
    np.testing.assert_allclose(grey.illuminance(np.array(NORMALS)), 20 * np.pi, rtol=tolerance)
    np.testing.assert_allclose(grey.vector_illuminance(), 0, atol=20 * np.pi * tolerance)


def test_horizontal_illuminance_is_exact_for_rows():
    """Rows of constant luminance: the closed integral is pi times the difference of sin^2 of the elevations."""
    rng = np.random.default_rng(8)
    for height in (2, 4, 6, 50):
        rows = rng.random(height)
        pixels = np.repeat(np.repeat(rows[:, None, None], 2 * height, 1), 3, 2)
        edges = np.sin(np.pi / 2 - np.pi * np.arange(height // 2 + 1) / height) ** 2
        expected = np.pi * np.sum(rows[: height // 2] * -np.diff(edges))
        assert float(EnvironmentMap(pixels).illuminance()) == pytest.approx(expected, rel=1e-13)


def test_overcast_sky_against_its_closed_integral():
    """Moon-Spencer, L = Lz (1 + 2 sin e) / 3: horizontal 7 pi / 9 Lz; vertical Lz (pi / 6 + 4 / 9)... by quadrature."""
    up = Equirectangular().directions(512)[..., 2:]
    pixels = np.where(up > 0, (1 + 2 * up) / 3, 0) * np.ones(3)
    overcast = EnvironmentMap(pixels)
    assert float(overcast.illuminance()) == pytest.approx(7 * np.pi / 9, rel=2e-6)
    assert float(overcast.illuminance(NORTH)) == pytest.approx(np.pi / 6 + 4 / 9, rel=2e-5)


def test_net_light_is_the_light_vector():
    rng = np.random.default_rng(9)
    for layout, height in LAYOUTS[:3]:
        random = EnvironmentMap(rng.random((*layout.shape(height), 3)), layout)
        vector = random.vector_illuminance()
        for normal in NORMALS:
            net = random.illuminance(normal) - random.illuminance(-np.asarray(normal))
            assert float(net) == pytest.approx(float(vector @ normal), abs=1e-4)


@pytest.mark.parametrize("space", [SRGB, REC2020, ACESCG], ids=lambda space: space.name)
def test_luminance_in_each_space(space):
    white = EnvironmentMap(np.ones((4, 8, 3), dtype=np.float32), space=space, white_luminance=250.0)
    assert white.luminance().dtype == np.float32
    np.testing.assert_allclose(white.luminance(), 250.0, rtol=1e-6)
    red = np.zeros((4, 8, 3))
    red[..., 0] = 1
    np.testing.assert_allclose(EnvironmentMap(red, space=space).luminance(), space.to_xyz[1, 0], rtol=1e-12)


def test_lookup_at_centres_gives_the_pixels():
    pixels = np.random.default_rng(10).random((8, 16, 3))
    environment = EnvironmentMap(pixels, white_luminance=3.0)
    np.testing.assert_allclose(environment.sample(Equirectangular().directions(8)), pixels, atol=1e-13)
    brightness = environment.sample_luminance(Equirectangular().directions(8))
    np.testing.assert_allclose(brightness, environment.luminance(), rtol=1e-12)


def test_lookup_across_the_seam_and_over_the_pole():
    pixels = np.zeros((8, 16, 3))
    pixels[:, 0], pixels[:, -1] = 1.0, 3.0
    np.testing.assert_allclose(EnvironmentMap(pixels).sample(NORTH), 2.0)
    pixels = np.zeros((8, 16, 3))
    pixels[0] = np.arange(16)[:, None]
    over_the_pole = [np.arange(16)[k] + np.arange(16)[(k + 8) % 16] for k in (3, 4)]
    zenith = EnvironmentMap(pixels).sample(direction(2 * np.pi * 4 / 16, np.pi / 2 - 1e-12))
    np.testing.assert_allclose(zenith, np.mean(over_the_pole) / 2, rtol=1e-9)


def test_fisheye_is_dark_outside():
    disc = EnvironmentMap(np.ones((20, 20, 3)), Fisheye())
    np.testing.assert_array_equal(disc.sample(-ZENITH), 0)
    np.testing.assert_allclose(disc.sample(direction(np.linspace(0, 6, 50), 0.0005)), 1)
    assert disc.sample(np.array([[ZENITH, WEST]])).shape == (1, 2, 3)


@pytest.mark.parametrize(
    ("pixels", "error", "words"),
    [
        (np.zeros((4, 4, 3)), ValueError, "pixels must have shape"),
        (np.zeros((4, 8)), ValueError, "pixels must have shape"),
        (np.zeros((3, 6, 3)), ValueError, "height of an equirectangular map"),
        (np.zeros((4, 8, 3), dtype=np.uint8), TypeError, "float32 or float64, got uint8"),
    ],
)
def test_wrong_pixels(pixels, error, words):
    with pytest.raises(error, match=words):
        EnvironmentMap(pixels)


def test_wrong_unit_and_directions():
    with pytest.raises(ValueError, match="white_luminance must lie in"):
        EnvironmentMap(np.zeros((4, 8, 3)), white_luminance=0.0)
    with pytest.raises(ValueError, match="unit vectors"):
        EnvironmentMap(np.zeros((4, 8, 3))).sample([0.0, 0.0, 2.0])
