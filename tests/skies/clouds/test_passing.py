"""A layer of cloud without air, by doubling: against discrete ordinates, and its energy."""

import numpy as np
import pytest

import skydome as sd
from skydome.air.clouds.particles import CloudParticles
from skydome.skies.clouds.passing import AREAS, SOURCES, VIEWS, passing

LAYERS = [(sd.Water(), 10e-6, 5.0, 6), (sd.Water(), 6e-6, 50.0, 12), (sd.Ice(), 30e-6, 20.0, 1)]


@pytest.mark.parametrize(("kind", "radius", "depth", "source"), LAYERS)
def test_light_passes_as_by_discrete_ordinates(kind: CloudParticles, radius: float, depth: float, source: int) -> None:
    """Away from the glow, where theirs depends on their streams."""
    w = [450.0, 650.0]
    layer, sun = passing(depth, kind, radius, tuple(w)), sd.direction(0.0, np.arcsin(SOURCES[source]))
    apart = np.abs(np.arcsin(VIEWS) - np.arcsin(SOURCES[source])) > np.radians(12)
    seen = np.flatnonzero((VIEWS > 0.03) & apart)[::6]
    views = sd.direction(np.radians(np.arange(5.0, 180.0, 10.0)), np.arcsin(VIEWS[seen])[:, None])
    cloud = sd.Cloud(depth, kind=kind, effective_radius=radius)
    air = sd.Atmosphere((sd.Molecules(pressure=1.0), cloud), albedo=0.0)
    truth = sd.DiscreteOrdinates(sun, air, streams=32).radiance(views, w).mean(axis=1) / air.sun_at(np.array(w))
    np.testing.assert_allclose(layer.table[source, seen], truth, rtol=5e-3)


@pytest.mark.parametrize("depth", [5.0, 60.0])
def test_no_light_is_lost_where_nothing_is_absorbed(depth: float) -> None:
    layer = passing(depth, sd.Water(), 10e-6, (500.0,))
    np.testing.assert_allclose(layer.through + layer.back, 1.0, atol=1e-3)
    falls = np.einsum("v,svw->sw", AREAS, layer.table)
    np.testing.assert_allclose(falls + SOURCES[:, None] * layer.up, SOURCES[:, None], atol=7e-3)
    np.testing.assert_allclose(AREAS @ layer.even, layer.through, rtol=5e-3)
    np.testing.assert_allclose(AREAS @ layer.below, layer.back, rtol=5e-3)
    assert AREAS.sum() == pytest.approx(np.pi, rel=1e-9)


def test_hexagonal_ice_passes_light_too() -> None:
    layer = passing(8.0, sd.HexagonalIce(), 30e-6, (550.0,))
    assert 0.9 < float((layer.through + layer.back)[0]) < 1.0 + 1e-6
