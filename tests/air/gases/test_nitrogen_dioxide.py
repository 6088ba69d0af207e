"""Nitrogen dioxide: its table, and what it takes of sky and sun against discrete ordinates in the same air."""

from dataclasses import replace

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.air.cross_sections import nitrogen_dioxide_cross_section
from skydome.air.profiles import OZONE_LAYER

BLUE = np.array([380.0, 420.0, 450.0, 550.0])
CLEAR = sd.clear_air()
VIEWS = sd.direction(np.array([0.3, 1.5, 3.1, 0.0]), np.array([5.0, 20.0, 40.0, 85.0]) * deg)


def brown(gas):
    return replace(CLEAR, constituents=(*CLEAR.constituents, gas))


def test_the_table_is_jpls():
    """JPL 06-2, means over 397.5-402.5, 447.5-452.5, 497.5-502.5 and 597.5-602.5 nm, cm2; nothing in the infrared."""
    found = nitrogen_dioxide_cross_section([400.0, 450.0, 500.0, 600.0, 700.0]) * 1e4
    np.testing.assert_allclose(found, [6.44e-19, 4.98e-19, 1.82e-19, 3.95e-20, 0.0], rtol=1e-5)
    assert sd.NitrogenDioxide(1.0).depth([400.0])[0] == pytest.approx(6.44e-19 * 2.6867e16, rel=1e-6)


@pytest.mark.parametrize("elevation", [10.0, 40.0])
@pytest.mark.parametrize("gas", [sd.NitrogenDioxide(1.0), sd.NitrogenDioxide(1.0, OZONE_LAYER)], ids=["town", "high"])
def test_it_takes_of_the_sky_what_discrete_ordinates_say(gas, elevation):
    """What a Dobson unit takes, up to 12 % of the light, within .2 % of the light."""
    sun = sd.direction(0.0, elevation * deg)
    ours, theirs = (
        kind(sun, brown(gas)).radiance(VIEWS, BLUE) / kind(sun, CLEAR).radiance(VIEWS, BLUE)
        for kind in (sd.PhysicalSky, sd.DiscreteOrdinates)
    )
    assert theirs.min() < 0.98
    np.testing.assert_allclose(ours, theirs, atol=0.002)


def test_the_suns_beam_is_beer_lamberts():
    sun = sd.direction(0.0, 90 * deg)
    left = [
        sd.SunDisc.of(sd.PhysicalSky(sun, air)).irradiance(BLUE) for air in (sd.clear_air(nitrogen_dioxide=2.0), CLEAR)
    ]
    np.testing.assert_allclose(left[0] / left[1], np.exp(-sd.NitrogenDioxide(2.0).depth(BLUE)), rtol=1e-4)


def test_none_of_it_is_the_air_without():
    assert sd.clear_air(nitrogen_dioxide=0.0) == CLEAR
    assert sd.Atmosphere.desert(nitrogen_dioxide=0.5).constituents[-1] == sd.NitrogenDioxide(0.5)


def test_many_columns_are_each_alone_and_have_a_gradient():
    torch = pytest.importorskip("torch")
    sun, columns = sd.direction(0.0, 30 * deg), np.array([[0.1], [0.9]])
    many = sd.PhysicalSky(sun, sd.clear_air(nitrogen_dioxide=columns)).radiance(VIEWS, BLUE)
    for column, light in zip(columns[:, 0], many, strict=True):
        alone = sd.PhysicalSky(sun, sd.clear_air(nitrogen_dioxide=float(column))).radiance(VIEWS, BLUE)
        np.testing.assert_allclose(light, alone, rtol=1e-6)
    column = torch.tensor(0.5, dtype=torch.float64, requires_grad=True)
    zenith = sd.PhysicalSky(sun, sd.clear_air(nitrogen_dioxide=column)).radiance(sd.ZENITH, [420.0])
    (slope,) = torch.autograd.grad(zenith.sum(), column)
    step = [sd.PhysicalSky(sun, sd.clear_air(nitrogen_dioxide=c)).radiance(sd.ZENITH, [420.0])[0] for c in (0.49, 0.51)]
    assert float(slope) == pytest.approx((step[1] - step[0]) / 0.02, rel=1e-3)
