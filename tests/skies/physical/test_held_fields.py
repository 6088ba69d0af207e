"""A held sky's fine fields against its series, and their compiled form against them."""

import numpy as np
import pytest

import skydome as sd

RNG = np.random.default_rng(3)
VIEWS = sd.direction(RNG.uniform(0, 2 * np.pi, 3000), np.arcsin(RNG.uniform(0, 1, 3000)))


@pytest.fixture(scope="module", params=[40.0, 3.0])
def held(request):
    return sd.held(sd.Nishita93(sd.direction(azimuth=1.0, elevation=request.param * sd.deg)))


def test_straight_lines_do(held):
    series = held.seen(VIEWS)
    np.testing.assert_allclose(held.fields.light(VIEWS), series, rtol=2e-3, atol=1e-3 * series.max())


def test_compiled(held):
    pytest.importorskip("numba")
    matrix = sd.SRGB.from_xyz
    single = held.fields.light_in_single(VIEWS.astype(np.float32), matrix)
    np.testing.assert_allclose(single, held.fields.light(VIEWS) @ matrix.T, rtol=2e-4, atol=1e-4)
    below = held.fields.light_in_single((VIEWS * [1, 1, -1]).astype(np.float32), matrix)
    assert (below == 0).all()


def test_many_directions_take_them(held):
    many = np.resize(VIEWS, (1 << 16, 3))
    np.testing.assert_allclose(held.rgb(many)[:50], held.rgb(VIEWS[:50]), rtol=2e-3, atol=0.5)
