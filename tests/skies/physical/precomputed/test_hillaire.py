"""Hillaire's sky: his series in closed form, and how far it is from all orders."""

from dataclasses import replace

import numpy as np
import pytest

import skydome as sd
from skydome.skies.physical.nishita import Nishita93
from skydome.skies.physical.precomputed.grid import SMALL

AIR = sd.Atmosphere.standard(aerosol_depth=0.1)
WAVELENGTHS = [450.0, 650.0]
VIEWS = np.concatenate([sd.direction(a * sd.deg, np.array([5.0, 20.0, 60.0]) * sd.deg) for a in (0.0, 90.0, 180.0)])
SUN = sd.direction(0.0, 40 * sd.deg)


@pytest.fixture(scope="module")
def table():
    return sd.MultipleScatteringTable.of(AIR, WAVELENGTHS)


def test_thin_air_scatters_once():
    thin = replace(AIR, constituents=(sd.Molecules(optical_depth=1e-4),), albedo=0.0)
    light = sd.Hillaire.by(sd.MultipleScatteringTable.of(thin, [550.0]), SUN).radiance(VIEWS, [550.0])
    np.testing.assert_allclose(light, Nishita93(SUN, thin).radiance(VIEWS, [550.0]), rtol=1e-2)


def test_ground_under_thin_air_lights_all_sides_by_half():
    """Just above a white plain the lower half of the sphere has the ground's radiance, E / pi."""
    thin = replace(AIR, constituents=(sd.Molecules(optical_depth=1e-6),), albedo=1.0)
    table = sd.MultipleScatteringTable.of(thin, [550.0])
    cosine = np.array([0.5])
    assert float(table.look_up(np.zeros(1), cosine)[0, 0]) == pytest.approx(0.5 * 0.5 / np.pi, rel=0.03)


def test_against_all_orders(table):
    tables = sd.ScatteringTables.of(AIR, WAVELENGTHS, sizes=SMALL)
    all_orders = sd.PrecomputedScattering.by(tables, SUN).radiance(VIEWS, WAVELENGTHS)
    error = sd.Hillaire.by(table, SUN).radiance(VIEWS, WAVELENGTHS) / all_orders - 1
    assert np.sqrt(np.mean(error**2)) < 0.12
    assert abs(error.mean()) < 0.05


def test_errors_in_one_line(table):
    with pytest.raises(ValueError, match="table must be that of the sky's atmosphere"):
        sd.Hillaire(SUN, sd.Atmosphere.mars(), table=table)
    with pytest.raises(TypeError, match="atmosphere must be of kind Atmosphere"):
        sd.MultipleScatteringTable.of("x", WAVELENGTHS)
    with pytest.raises(TypeError, match="table must be of kind MultipleScatteringTable"):
        sd.Hillaire.by("x", SUN)
