"""Colour given to skies that know luminance only: by luminance, or another sky's; the luminance stays."""

import numpy as np
import pytest

import skydome as sd

SUN = sd.direction(2.0, 0.6)
VIEWS = sd.direction(np.linspace(0, 6, 9), np.linspace(0.05, 1.5, 9))
CLEAR = sd.CIE(SUN, 12, illuminance=12_000.0)


@pytest.mark.parametrize(("luminance", "kelvin"), [(2000.0, 15336.8), (10_000.0, 9347.5), (1e5, 5997.0)])
def test_colour_temperature_by_luminance(luminance, kelvin):
    """1e6 / (59.77 log10 L - 132.1), Chain et al. 1999; within what the daylight locus is off its temperature."""
    xyz = sd.ColourByLuminance(sd.Uniform(luminance)).xyz(sd.ZENITH)
    assert float(sd.colour_temperature(xyz)) == pytest.approx(kelvin, rel=0.004)
    assert xyz[1] == pytest.approx(luminance)


def test_dim_parts_stay_on_the_locus():
    seen = sd.colour_temperature(sd.ColourByLuminance(sd.Uniform(np.array([1.0, 100.0, 700.0]))).xyz(sd.ZENITH))
    np.testing.assert_allclose(seen, 25_000.0, rtol=0.01)


def test_the_chromaticity_of_another_sky():
    like = sd.Preetham(SUN, 3.0)
    ours, theirs = sd.ColourOf(CLEAR, like).xyz(VIEWS), like.xyz(VIEWS)
    np.testing.assert_allclose(ours[:, 1], CLEAR.luminance(VIEWS))
    np.testing.assert_allclose(ours / ours[:, 1:2], theirs / theirs[:, 1:2])
