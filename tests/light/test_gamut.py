"""Colours outside an RGB space: what comes out is inside, of the same luminance and hue; what was inside stays."""

import numpy as np
import pytest

from skydome.light.colour import ACESCG, REC2020, SRGB, xyY_from_xyz, xyz_from_rgb
from skydome.light.gamut import outside, within_gamut


@pytest.mark.parametrize("space", [SRGB, REC2020, ACESCG], ids=lambda space: space.name)
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_luminance_and_dominant_wavelength_stay(space, dtype):
    """In x, y the colour stays on its line through the white; luminance to rounding."""
    rgb = np.random.default_rng(4).uniform(-0.4, 1.0, (400, 3)).astype(dtype) * 1e6
    rgb = rgb[rgb.astype(np.float64) @ space.to_xyz[1] > 1e4]
    seen = within_gamut(rgb, space)
    assert seen.dtype == dtype
    assert seen.min() == 0
    before, after = (xyY_from_xyz(xyz_from_rgb(value.astype(np.float64), space)) for value in (rgb, seen))
    np.testing.assert_allclose(after[:, 2], before[:, 2], rtol=1e-5 if dtype is np.float32 else 1e-12)
    white = xyY_from_xyz(xyz_from_rgb(np.ones(3), space))[:2]
    a, b = before[:, :2] - white, after[:, :2] - white
    turned = np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / (np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1))
    usual = before[:, 1] > 0.05
    assert turned[usual].max() < (2e-3 if dtype is np.float32 else 1e-9)
    assert (np.sum(a * b, axis=1)[usual] >= 0).all()
    kept = ~outside(rgb)
    np.testing.assert_array_equal(seen[kept], rgb[kept])
    assert within_gamut(seen, space) is seen


def test_light_without_luminance_becomes_black():
    assert within_gamut(np.array([[-1.0, -2.0, -3.0], [1.0, -1.0, 0.0]]), SRGB).tolist() == [[0, 0, 0], [0, 0, 0]]
