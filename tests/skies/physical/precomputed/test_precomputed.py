"""The sky by tables of scattered light: the tables' maps, each step in closed form, and the whole against paths."""

from dataclasses import replace

import numpy as np
import pytest

import skydome as sd
from skydome.air.phase_laws import HenyeyGreenstein, Rayleigh
from skydome.skies.physical.nishita import Nishita93
from skydome.skies.physical.precomputed.convolution import convolved, ring_cosines, turns
from skydome.skies.physical.precomputed.grid import SMALL, Sizes
from skydome.skies.physical.precomputed.medium import phases_of

pytest.importorskip("numba")
AIR = sd.Atmosphere.standard(aerosol_depth=0.1)
WAVELENGTHS = np.array([450.0, 650.0])
VIEWS = np.concatenate(
    [sd.direction(a * sd.deg, np.array([5.0, 20.0, 45.0, 80.0]) * sd.deg) for a in (0.0, 70.0, 180.0)]
)


@pytest.fixture(scope="module")
def tables():
    return sd.ScatteringTables.of(AIR, WAVELENGTHS, sizes=SMALL)


def sun_at(elevation):
    return sd.direction(0.0, elevation * sd.deg)


def test_a_table_gives_its_own_values_at_its_nodes(tables):
    radii, views, suns, _ = tables.orders.nodes
    table = np.random.default_rng(0).uniform(1, 2, tables.multiple.shape).astype(np.float32)
    i, j, k = np.array([1, 5, 11, 7]), np.array([3, 15, 20, 23]), np.array([0, 9, 14, 23])
    out = np.empty((4, 2))
    from skydome.skies.physical.precomputed.orders_kernel import look_up

    grounded = j < views.shape[1] // 2
    look_up(
        0, 4, radii[i], views[i, j], suns[k], np.array([-1.0, -0.2, 0.6, 1.0]), grounded, table, tables.orders.air, out
    )
    np.testing.assert_allclose(out, table[i, j, k, [0, 2, 4, 5]], rtol=2e-3)


def test_even_light_is_given_off_as_it_came():
    laws, cosines = [Rayleigh(0.0), HenyeyGreenstein((0.76,))], np.polynomial.legendre.leggauss(16)
    comes = np.broadcast_to(cosines[1][None, :, None, None] * np.pi / 16, (3, 16, 16, 1))
    views = np.array([-0.9, 0.1, 0.7])
    turn = turns(views, np.array([0.0, 0.5, 1.0]), np.linspace(-1, 1, 4))
    made = convolved(comes, phases_of(laws, np.array([550.0]), 32), cosines[0], views, turn)
    np.testing.assert_allclose(made, 1.0, rtol=2e-3)


def test_rings_see_a_belt_of_light_at_the_horizon(tables):
    """In twilight all light comes from it: the belt exp(-(c - horizon) / .01), whose integral is known."""
    orders = replace(tables.orders, sizes=Sizes())
    cosines, weights, _ = orders.sphere
    radius = orders.shell.bottom + 10_000.0
    rings, low = ring_cosines(orders.shell, radius, cosines), -float(orders.shell.rho(radius)) / radius
    above, below = rings[: len(cosines)] - low, low - rings[len(cosines) :]
    assert (1 - low) * weights @ np.exp(-above / 0.01) == pytest.approx(0.01, rel=2e-3)
    assert (1 + low) * weights @ np.exp(-below / 0.01) == pytest.approx(0.01, rel=2e-3)


def test_light_scattered_once_is_that_by_quadrature():
    """The table looked up, as published, against Gauss nodes along each view."""
    tables = sd.ScatteringTables.of(AIR, WAVELENGTHS, 1, Sizes(12, 48, 32, 12, directions=8, samples=24))
    sun = sun_at(30.0)
    looked_up = sd.PrecomputedScattering.by(tables, sun, exact_first=False).radiance(VIEWS, WAVELENGTHS)
    np.testing.assert_allclose(looked_up, Nishita93(sun, AIR).radiance(VIEWS, WAVELENGTHS), rtol=0.06)
    exact = sd.PrecomputedScattering.by(tables, sun).radiance(VIEWS, WAVELENGTHS)
    np.testing.assert_allclose(exact, Nishita93(sun, AIR).radiance(VIEWS, WAVELENGTHS), rtol=2e-3)


@pytest.mark.parametrize("elevation", [40.0, 3.0])
def test_against_paths(tables, elevation):
    sky = sd.PrecomputedScattering.by(tables, sun_at(elevation))
    traced = sd.PathTraced(sun_at(elevation), AIR, relative_error=0.01, refraction=False).radiance(VIEWS, WAVELENGTHS)
    error = sky.radiance(VIEWS, WAVELENGTHS) / traced - 1
    assert np.sqrt(np.mean(error**2)) < 0.06
    assert abs(error.mean()) < 0.035


def test_all_suns_share_the_tables(tables):
    suns = sun_at(np.array([50.0, 5.0, -5.0]))[:, None, :]
    together = sd.PrecomputedScattering.by(tables, suns).radiance(VIEWS, WAVELENGTHS)
    assert together.shape == (3, len(VIEWS), 2)
    alone = sd.PrecomputedScattering.by(tables, suns[2, 0]).radiance(VIEWS, WAVELENGTHS)
    np.testing.assert_allclose(together[2], alone, rtol=1e-12)


def test_without_air_the_ground_is_seen_from_space_and_beside_it_nothing():
    bare = replace(AIR, constituents=(sd.Molecules(optical_depth=0.0),), albedo=0.5)
    tables = sd.ScatteringTables.of(bare, [550.0], 3, SMALL)
    sky = sd.PrecomputedScattering.by(tables, sun_at(60.0), height=400_000.0)
    light = sky.radiance(np.stack([-sd.ZENITH, sd.NORTH]), [550.0])[:, 0]
    assert light[0] == pytest.approx(float(bare.sun_at([550.0])[0]) * 0.5 / np.pi * np.sin(np.pi / 3), rel=2e-3)
    assert light[1] == 0


def test_higher_up_the_sky_darkens_and_the_haze_is_below(tables):
    skies = [sd.PrecomputedScattering.by(tables, sun_at(30.0), height) for height in (0.0, 10_000.0, 400_000.0)]
    zenith = [float(sky.radiance(sd.ZENITH, WAVELENGTHS)[0]) for sky in skies]
    assert zenith[0] > 3 * zenith[1] > 0
    assert zenith[2] == 0
    limb = sd.direction(np.pi, -20.0 * sd.deg)  # from 400 km the ground's edge is 19.7 degrees down
    assert (skies[2].radiance(limb, WAVELENGTHS) > 0).all()


def test_errors_in_one_line(tables):
    with pytest.raises(ValueError, match=r"orders must lie in \[1, 100\], got 0"):
        sd.ScatteringTables.of(AIR, WAVELENGTHS, 0)
    with pytest.raises(TypeError, match=r"atmosphere must be of kind Atmosphere, as Atmosphere.standard\(\), got"):
        sd.ScatteringTables.of("x", WAVELENGTHS)
    with pytest.raises(TypeError, match="tables must be of kind ScatteringTables"):
        sd.PrecomputedScattering.by("x", sun_at(30.0))
    with pytest.raises(TypeError, match="sizes must be of kind Sizes or None"):
        sd.ScatteringTables.of(AIR, WAVELENGTHS, sizes=3)
    with pytest.raises(ValueError, match="views must be even, got 33"):
        Sizes(views=33)
    with pytest.raises(ValueError, match="tables must be those of the sky's atmosphere"):
        sd.PrecomputedScattering(sun_at(30.0), sd.Atmosphere.mars(), tables=tables)
    with pytest.raises(ValueError, match="wavelengths must be among the tables' own"):
        sd.PrecomputedScattering.by(tables, sun_at(30.0)).xyz(VIEWS)
