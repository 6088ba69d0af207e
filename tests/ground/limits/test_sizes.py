"""What would take too much is refused before it is begun, and what people ask for fits."""

import numpy as np
import pytest

import skydome as sd
from skydome.ground.limits.sizes import granting
from skydome.light.gamut import within_gamut

SUN = np.array([0.0, 0.6, 0.8])


def test_a_map_beyond_memory_is_refused_at_once():
    with pytest.raises(ValueError, match=r"a map of 16384 x 32768 texels would take 6 GB of memory, 4 are allowed"):
        sd.render(sd.Preetham(SUN, 3.0), 16384)
    with granting(1 << 26), pytest.raises(ValueError, match="give --max-memory"):
        sd.render(sd.Preetham(SUN, 3.0), 2048)
    small = sd.render(sd.Preetham(SUN, 3.0), 16)
    with pytest.raises(ValueError, match="a map of"):
        small.resampled(small.projection, 30_000)


def test_a_picture_beyond_memory_is_refused_at_once():
    with pytest.raises(ValueError, match="a picture of 16384 x 16384 would take"):
        sd.Camera(width=16384, height=16384)


def test_colours_are_moved_by_rows_as_all_at_once():
    rgb = np.random.default_rng(0).normal(1, 1, (150, 8, 3)).astype(np.float32)
    whole = within_gamut(rgb.reshape(-1, 3), sd.SRGB).reshape(rgb.shape)
    assert np.array_equal(within_gamut(rgb, sd.SRGB), whole)
    assert within_gamut(np.ones((4, 4, 3)), sd.SRGB).min() == 1
