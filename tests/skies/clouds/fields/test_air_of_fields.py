"""The air about a field of cloud: the lower air against closed forms, and the horizon against discrete ordinates."""

from dataclasses import replace

import numpy as np
import pytest

import skydome as sd
from skydome.skies.clouds.fields.air.above import air_above
from skydome.skies.clouds.fields.air.lower import LowerAir, escape
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.kinds import Slab

pytest.importorskip("numba")
WAVES = np.array([450.0, 550.0, 650.0])


def air(turbidity, albedo=0.2):
    """Hazy air over a grey ground."""
    return replace(sd.Atmosphere.from_turbidity(turbidity), albedo=albedo)


def test_lower_air_loses_nothing_and_shows_half_of_what_is_above_it_at_the_horizon():
    molecules = LowerAir(sd.Atmosphere((sd.Molecules(),)), 2000.0, WAVES)
    down, up = molecules.shares
    np.testing.assert_allclose(down[1:2] + up[1:2], 1.0, rtol=2e-3)
    np.testing.assert_allclose(down[2] + up[2], 1.0, rtol=2e-3)
    thin = LowerAir(sd.Atmosphere((sd.Molecules(pressure=10.0),)), 2000.0, WAVES)
    level = thin.toward(np.zeros(1), np.ones((1, 3)) * 1e-9)[:, 0] * np.pi
    np.testing.assert_allclose(level[1], 0.5, atol=2e-3)
    np.testing.assert_allclose(level[2], 0.5, atol=2e-3)
    np.testing.assert_allclose(level[0], 0.5 * (escape(0.0) + escape(1.0)) / 2, atol=0.02)


def test_air_above_a_height_has_the_columns_above_it():
    whole, above = air(3.0), air_above(air(3.0), 5600.0, 0.5)
    assert above.depth([550.0]) < 0.5 * whole.depth([550.0])
    assert air_above(whole, 0.0, 0.2).depth(WAVES) == pytest.approx(whole.depth(WAVES), rel=1e-4)
    assert above.constituents[0].pressure == pytest.approx(101325 / 2, rel=0.02)


@pytest.mark.parametrize("elevation", [3.0, 40.0])
def test_cloud_that_is_nothing_leaves_the_clear_sky(elevation):
    clear = sd.PhysicalSky(sd.direction(azimuth=3.0, elevation=elevation * sd.deg), air(3.0))
    views = sd.direction(np.linspace(0, 6, 12), np.tile([0.5, 4.0, 20.0, 60.0], 3) * sd.deg)
    sky = sd.CloudySky(clear, CloudField(Slab(sd.Water()), 1.0, base=1000.0, thickness=500.0, extinction=1e-9))
    np.testing.assert_allclose(sky.radiance(views, WAVES), clear.radiance(views, WAVES), rtol=2e-3)


@pytest.mark.parametrize(("elevation", "turbidity"), [(2.0, 2.0), (15.0, 6.0)])
def test_horizon_under_a_full_cover_meets_discrete_ordinates(elevation, turbidity):
    pytest.importorskip("nanodisort")
    sun, below = sd.direction(azimuth=0.0, elevation=elevation * sd.deg), air(turbidity)
    views = sd.direction(np.repeat([0.0, 1.5, 3.0], 3), np.tile([0.5, 2.0, 10.0], 3) * sd.deg)
    covered = replace(below, constituents=(*below.constituents, sd.Cloud(30.0, base=1000.0, thickness=500.0)))
    known = sd.DiscreteOrdinates(sun, covered).radiance(views, WAVES)
    field = CloudField(Slab(sd.Water()), 1.0, base=1000.0, thickness=500.0, extinction=0.06)
    found = sd.CloudySky(sd.PhysicalSky(sun, below), field).radiance(views, WAVES)
    np.testing.assert_allclose(found, known, rtol=0.3)
    colour = (found / known) / (found / known).mean(axis=-1, keepdims=True)
    np.testing.assert_allclose(colour, 1.0, atol=0.12)
