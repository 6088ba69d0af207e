"""A sky's sun: no array that is written to afterwards, and no rounding of half floats beyond the sun's own."""

import numpy as np
import pytest

import skydome as sd

SUN = sd.direction(azimuth=2.0, elevation=0.7)


def test_a_sky_keeps_its_sun():
    mine = np.array(SUN)
    sky = sd.Preetham(mine, 3.0)
    mine[:] = [0.0, 0.0, 1.0]
    np.testing.assert_array_equal(sky.sun, SUN)
    with pytest.raises(ValueError, match="read-only"):
        sky.sun[:] = mine


@pytest.mark.parametrize("library", ["numpy", "torch", "jax.numpy"])
def test_half_suns_are_computed_in_whole_floats(library):
    xp = pytest.importorskip(library)
    half = xp.asarray(np.asarray(SUN), dtype=xp.float16)
    rounded = sd.Preetham(np.asarray(SUN).astype(np.float16).astype(np.float64), 3.0).luminance(sd.ZENITH)
    assert float(sd.Preetham(half, 3.0).luminance(sd.ZENITH)) == pytest.approx(float(rounded), rel=2e-6)
