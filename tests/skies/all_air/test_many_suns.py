"""Many suns at once: compiled rays against rays in arrays, kinds of suns, and many suns against each alone."""

import numpy as np
import pytest

import skydome as sd
from skydome.skies.all_air import fast
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.many_suns import by_kind
from skydome.skies.all_air.single_scattering import cosines
from skydome.skies.all_air.spectral_nodes import NODES

VIEWS = sd.direction(np.linspace(0, np.pi, 9)[:, None], np.radians([0.2, 3.0, 30.0, 90.0]))


@pytest.mark.parametrize("elevation", [70.0, 1.0, -0.3, -5.0, -15.0])
def test_compiled_rays(elevation):
    """Many suns, two airs: light scattered once by the kernel is that of arrays, where there is any."""
    pytest.importorskip("numba")
    air = sd.clear_air(np.array([0.1, 0.4])[:, None, None, None])
    depths = [part.depth(NODES) for part in air.constituents]
    suns = sd.direction(0.3, np.radians(elevation + np.array([0.0, 0.1])))[:, None, None]
    given = (ColumnTables.of(air), *cosines(suns, VIEWS), depths)
    for found, wanted in zip(fast.compiled(*given), fast.in_arrays(*given), strict=True):
        assert found.shape == (2, 2, 9, 4, len(NODES))
        np.testing.assert_allclose(found, wanted, rtol=1e-4, atol=1e-9 * wanted.max())


def test_pieces_are_the_whole_but_for_the_night():
    suns = sd.direction(0.0, np.radians([50.0, -3.0, -30.0, 1.0, 50.0, -40.0]))[:, None]
    seen = np.zeros((6, 5), int)
    for piece in by_kind(suns, seen.shape, compiled=False):
        seen[piece] += 1
    np.testing.assert_array_equal(seen, np.array([1, 1, 0, 1, 1, 0])[:, None] * np.ones((1, 5), int))
    assert [piece[0].tolist() for piece in by_kind(suns, (6, 5), compiled=True)] == [[1], [3], [0, 4]]


def test_many_suns_compiled_are_each_alone(monkeypatch):
    pytest.importorskip("numba")
    suns = sd.direction(0.5, np.radians([-20.0, -5.0, 0.5, 40.0, 2.5]))[:, None]
    sky, views = sd.PhysicalSky(suns, sd.clear_air(np.linspace(0.05, 0.4, 5)[:, None])), VIEWS.reshape(-1, 3)
    plain = sky.xyz(views)
    monkeypatch.setattr(fast, "LEAST_RAYS", 1)
    np.testing.assert_allclose(sky.xyz(views), plain, rtol=2e-5)
    assert (plain[0] == 0).all()
