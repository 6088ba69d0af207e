"""Aerosols of any phase law under the physical sky: against discrete ordinates, in tables, in other libraries."""

from dataclasses import replace

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.air.constituents import Aerosol
from skydome.air.phase_laws import HenyeyGreenstein
from skydome.air.series.legendre_series import LegendreSeries
from skydome.skies.all_air.low_aerosol import LowAerosol, straight_part

WAVELENGTHS = np.array([450.0, 650.0])
VIEWS = sd.direction(*np.meshgrid(np.array([25.0, 110.0, 180.0]) * deg, np.array([4.0, 15, 40, 80]) * deg)).reshape(
    -1, 3
)
TWO = HenyeyGreenstein((0.8, -0.5), (0.93, 0.07))


def air_of(law, depth=0.2, **others):
    return replace(sd.Atmosphere.of_aerosol(Aerosol(depth, phase=law, **others)), gases=None)


@pytest.fixture(scope="module")
def dust():
    sizes = sd.Lognormal(0.39e-6, 2.0)
    optics = sd.MieParticles(sizes, 1.53, 0.0055, 200).optics([450.0, 650.0])
    return replace(sd.Atmosphere.of_aerosol(optics.aerosol(0.2)), gases=None)


@pytest.mark.parametrize(("elevation", "near", "most"), [(40.0, 0.005, 0.02), (10.0, 0.03, 0.045)])
def test_desert_dust_is_that_of_discrete_ordinates(dust, elevation, near, most):
    pytest.importorskip("nanodisort")
    sun = sd.direction(0.0, elevation * deg)
    views = np.concatenate([VIEWS, sd.direction(0.0, (elevation + 4) * deg)[None]])
    truth = sd.DiscreteOrdinates(sun, dust, streams=24).radiance(views, WAVELENGTHS)
    off = sd.PhysicalSky(sun, dust).radiance(views, WAVELENGTHS) / truth - 1
    assert np.sqrt(np.mean(off[:-1] ** 2)) < most  # 0.03 and 0.09 by the mean cosine alone
    assert abs(off[-1]).max() < near  # 0.02 and 0.06


def test_the_scaled_lobe_has_the_first_moment_and_nearer_second():
    mean, second = np.array([0.7, 0.72, 0.6]), np.array([0.49, 0.62, 0.30])
    straight = straight_part(mean, second)
    lobe = (mean - straight) / (1 - straight)
    np.testing.assert_allclose(straight[[0, 2]], 0.0, atol=1e-12)  # one lobe; a law blunter than a lobe
    assert lobe[1] > 0.48
    assert second[1] > straight[1] + (1 - straight[1]) * lobe[1] ** 2 > mean[1] ** 2


@pytest.mark.parametrize("elevation", [1.0, 10.0])
def test_maps_hold_what_is_sharp(dust, elevation):
    sky = sd.PhysicalSky(sd.direction(0.3, elevation * deg), dust)
    near = sd.direction(0.3 + np.array([0.01, 0.04, 0.1, 0.2]), (elevation + np.array([0.5, 2, 4, 1])) * deg)
    np.testing.assert_allclose(sky.held().xyz(near), sky.xyz(near), rtol=0.01)


def test_two_aerosols_of_one_law_are_one():
    whole = air_of(TWO)
    molecules, low, *others = whole.constituents
    half = replace(low, optical_depth=low.optical_depth / 2)
    parts = replace(whole, constituents=(molecules, half, half, *others))
    sun = sd.direction(0.0, 20 * deg)
    one, two = (sd.PhysicalSky(sun, air).radiance(VIEWS, WAVELENGTHS) for air in (whole, parts))
    np.testing.assert_allclose(two, one, rtol=2e-4)


def test_many_airs_and_torch_as_one_air_each():
    torch = pytest.importorskip("torch")
    sun, depths = sd.direction(0.0, 20 * deg), np.array([[0.1], [0.3]])
    alone = [sd.PhysicalSky(sun, air_of(TWO, float(d[0]))).radiance(VIEWS, WAVELENGTHS) for d in depths]
    many = sd.PhysicalSky(sun, air_of(TWO, depths)).radiance(VIEWS, WAVELENGTHS)
    np.testing.assert_allclose(many, alone, rtol=1e-9)
    sharp = torch.tensor(0.8, dtype=torch.float64, requires_grad=True)
    law = HenyeyGreenstein((sharp, torch.tensor(-0.5, dtype=torch.float64)), (0.93, 0.07))
    light = sd.PhysicalSky(torch.as_tensor(sun), air_of(law, 0.1)).radiance(torch.as_tensor(VIEWS), WAVELENGTHS)
    np.testing.assert_allclose(light.detach().numpy(), alone[0], rtol=1e-9)
    light.sum().backward()
    ends = [air_of(HenyeyGreenstein((0.8 + step, -0.5), (0.93, 0.07)), 0.1) for step in (-1e-5, 1e-5)]
    low, high = (sd.PhysicalSky(sun, air).radiance(VIEWS, WAVELENGTHS).sum() for air in ends)
    assert float(sharp.grad) == pytest.approx((high - low) / 2e-5, rel=1e-4)


def test_one_lobe_by_its_moments_is_one_lobe():
    lobe = HenyeyGreenstein((0.7,))
    series = LegendreSeries([550.0], lobe.moments(128, [550.0]))
    assert LowAerosol.of(air_of(lobe), WAVELENGTHS, np.zeros(1)) is None
    sun = sd.direction(0.0, 15 * deg)
    one, same = (sd.PhysicalSky(sun, air_of(law)).radiance(VIEWS, WAVELENGTHS) for law in (lobe, series))
    np.testing.assert_allclose(same, one, rtol=1e-6)
