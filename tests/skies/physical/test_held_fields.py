"""A held sky's fine fields against its series, and their compiled form against them."""

import numpy as np
import pytest

import skydome as sd

RNG = np.random.default_rng(3)
VIEWS = sd.direction(RNG.uniform(0, 2 * np.pi, 3000), np.arcsin(RNG.uniform(0, 1, 3000)))


@pytest.fixture(scope="module", params=[40.0, 3.0])
def held(request):
    return sd.held(sd.Nishita93(sd.direction(azimuth=1.0, elevation=request.param * sd.deg)))


@pytest.mark.parametrize(("elevation", "valid"), [(40.0, True), (-11.0, True), (-17.0, True), (-19.0, False)])
def test_a_table_of_the_physical_sky_is_valid_where_the_sky_is(elevation, valid):
    """Between -12 and -18 degrees the table said that it was not."""
    sky = sd.PhysicalSky(sd.direction(azimuth=0.0, elevation=elevation * sd.deg))
    assert bool(sky.valid) == bool(sd.held(sky).valid) == valid


def test_a_table_of_air_that_was_not_taught_is_not_valid():
    thick = sd.PhysicalSky(sd.direction(azimuth=0.0, elevation=0.7), sd.clear_air(aerosol_depth=3.0), check="clamp")
    assert not thick.valid
    assert not sd.held(thick).valid


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
