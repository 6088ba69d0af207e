"""The preview: hues stay, nothing is cut off, the sun and the black ground do not set the exposure."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from skydome.light.tone import BLEACH, Filmic, Reinhard, auto_exposure, tone_mapped
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.projections import Equirectangular
from skydome.maps.showing.preview import preview

CURVES = [Filmic(), Reinhard(), Reinhard(white=2.0)]


def hue(rgb):
    """Angle of the part across the grey axis."""
    across = rgb - rgb.mean(axis=-1, keepdims=True)
    return np.arctan2(
        np.sqrt(3) * (across[..., 1] - across[..., 2]), 2 * across[..., 0] - across[..., 1] - across[..., 2]
    )


@pytest.mark.parametrize("curve", CURVES, ids=repr)
def test_curves_rise_from_0_to_1(curve):
    x = np.concatenate([[0], np.geomspace(1e-6, 1e12, 4000)])
    y = curve(x)
    assert y[0] == 0
    assert y[-1] == pytest.approx(1)
    assert (np.diff(y) >= 0).all()


@pytest.mark.parametrize("curve", CURVES, ids=repr)
@given(colour=st.tuples(*[st.floats(0.01, 1)] * 3), exposure=st.floats(1e-3, 1e8))
def test_hue_stays_at_any_exposure(curve, colour, exposure):
    colour = np.array(colour)
    shown = tone_mapped(colour * exposure, curve)
    assert (shown >= 0).all()
    assert (shown <= 1 + 1e-12).all()
    spread = np.ptp(shown) / shown.max()
    if np.ptp(colour) > 0.01 and spread > 1e-6:
        assert abs(np.angle(np.exp(1j * (hue(shown) - hue(colour))))) < 1e-6
    assert spread <= np.ptp(colour) / colour.max() + 1e-12


def test_the_sun_is_white_and_a_dark_colour_itself():
    sun = tone_mapped(np.array([1e5, 7e4, 3e4]), Filmic())
    np.testing.assert_allclose(sun, 1, atol=2e-3)
    dark = tone_mapped(np.array([0.02, 0.04, 0.01]), Filmic())
    np.testing.assert_allclose(dark / dark[1], [0.5, 1, 0.25], rtol=2e-4 * BLEACH)


def landscape(sun, ground, height=64):
    up = Equirectangular().directions(height)[..., 2]
    pixels = np.where(up[..., None] > 0, np.array([1500.0, 2300.0, 4200.0]), ground) * np.ones(3)
    pixels[10, 20] = sun
    return EnvironmentMap(pixels)


def test_exposure_does_not_follow_sun_or_black_ground():
    angles = Equirectangular().solid_angles(64)
    plain = auto_exposure(landscape(2000.0, 0.0).luminance(), angles)
    assert auto_exposure(landscape(1.6e9, 0.0).luminance(), angles) == pytest.approx(plain, rel=0.01)
    assert auto_exposure(landscape(1.6e9, 1e-9).luminance(), angles) == pytest.approx(plain, rel=0.01)
    assert plain == pytest.approx(0.18 / landscape(0, 0).luminance()[0, 0], rel=0.01)
    assert auto_exposure(np.zeros((4, 8))) == 1.0
    assert auto_exposure(landscape(1e9, 0).luminance() * 1e-4, angles) == pytest.approx(plain * 1e4, rel=0.01)


def test_pictures_of_nights_are_darker_by_their_content():
    """A moonless night by two stops, a moonlit one by one, dusk not at all."""
    stops = [np.log2(auto_exposure(np.full((4, 8), light)) * light / 0.18) for light in (3e-4, 3e-3, 0.1, 5e3)]
    np.testing.assert_allclose(stops, [-2.1, -1.3, 0.0, 0.0], atol=0.05)


def test_png_file_is_the_preview(tmp_path):
    environment = landscape(1.6e9, 300.0)
    environment.save(tmp_path / "x.png")
    with Image.open(tmp_path / "x.png") as image:
        seen = np.array(image)
        assert image.info["skydome:target"] == "native"
    np.testing.assert_array_equal(seen, np.rint(preview(environment) * 255))
    assert seen[10, 20].tolist() == [255, 255, 255]
    red, green, blue = seen[5, 50]
    assert red < green < blue < 255
    brighter = preview(environment, exposure=1e-3, curve=Reinhard())
    assert (brighter[:32] > preview(environment, exposure=1e-4, curve=Reinhard())[:32]).mean() > 0.99
