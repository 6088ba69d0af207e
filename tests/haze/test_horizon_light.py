"""Haze that tends to the sky behind it."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.haze.ground_air import AtmosphereAir
from skydome.haze.horizon_light import HORIZON

SUN = sd.direction(250 * deg, 12 * deg)
AROUND = sd.direction(np.arange(0, 360, 45) * deg, 0.0)
BEHIND = sd.direction(np.arange(0, 360, 45) * deg, HORIZON)


def with_sun(sky):
    return sky + sd.SunDisc.of(sky)


@pytest.mark.parametrize("height", [0.0, 800.0, 3000.0])
@pytest.mark.parametrize("model", [sd.HosekWilkie, sd.Preetham])
def test_an_endless_level_ray_takes_the_light_of_the_horizon(model, height):
    sky = model(SUN, 3.0)
    air = sd.AirLight(with_sun(sky), meets_horizon=True).at(1e8, AROUND, height)
    assert air.transmittance.max() < 1e-12
    np.testing.assert_allclose(air.inscattered, np.maximum(sky.rgb(BEHIND), 0), rtol=5e-4)
    own = sd.AirLight(with_sun(sky)).at(1e8, AROUND, height).inscattered
    assert abs(own / air.inscattered - 1).max() > 0.2  # without it the limit is another


@pytest.mark.parametrize(("elevation", "own"), [(60, 0.01), (20, 0.02), (5, 0.07), (0, 0.1), (-4, 0.12)])
def test_far_land_melts_into_the_physical_sky_of_the_same_air(elevation, own):
    """And by its own scattering haze comes near that light, within 2 % under suns from 20 degrees up."""
    sky, wavelengths = sd.PhysicalSky(sd.direction(250 * deg, elevation * deg)), [400.0, 550.0, 700.0]
    horizon = sky.radiance(BEHIND, wavelengths)
    air = sd.AirLight(with_sun(sky), wavelengths, ground_albedo=0.2)
    assert abs(air.at(1e8, AROUND).inscattered / horizon - 1).max() < 1e-3
    dark = air.at(120e3, AROUND, 100.0).seen(0.3 * horizon)
    assert abs(dark / horizon - 1).max() < 0.02
    alone = sd.AirLight(with_sun(sky), wavelengths, ground_albedo=0.2, meets_horizon=False)
    ratio = alone.at(1e8, AROUND).inscattered / horizon
    assert abs(ratio[:, :2] - 1).max() < own  # at 700 nm water vapour darkens the horizon alone, by 8 %


def test_the_air_of_an_atmosphere_is_that_above():
    air = sd.clear_air(aerosol_depth=0.3)
    haze, gas = AtmosphereAir(air).extinction(np.array([450.0, 650.0]))
    column = sum(part / rate for part, rate in zip((haze, gas), AtmosphereAir(air).decays, strict=True))
    low = [part for part in air.constituents if not isinstance(part, sd.Ozone)][:2]
    np.testing.assert_allclose(column, sum(part.depth([450.0, 650.0]) for part in low), rtol=0.15)
    assert AtmosphereAir(air).decays[0] == pytest.approx(1 / 1500, rel=1e-6)
    with pytest.raises(ValueError, match="air of single numbers"):
        sd.AirLight(sd.PhysicalSky(SUN, sd.clear_air(aerosol_depth=np.array([0.1, 0.2]))))


def test_an_endless_spectral_ray_too():
    sky, wavelengths = sd.HosekWilkie(SUN, 3.0), [450.0, 550.0, 650.0]
    air = sd.AirLight(with_sun(sky), wavelengths, meets_horizon=True).at(1e8, AROUND)
    np.testing.assert_allclose(air.inscattered, sky.radiance(BEHIND, wavelengths), rtol=5e-4)


@pytest.mark.parametrize("sky", [sd.HosekWilkie(SUN, 3.0), sd.PhysicalSky(SUN)])
def test_many_rays_few_rays_and_torch_agree(sky):
    torch = pytest.importorskip("torch")
    sky = with_sun(sky)
    air = sd.AirLight(sky, meets_horizon=True)
    rng = np.random.default_rng(0)
    views = sd.direction(rng.uniform(0, 2 * np.pi, 12_000), rng.uniform(-1.5, 0.3, 12_000))
    distance = rng.uniform(10, 60e3, 12_000)
    many, few = air.at(distance, views, 500.0), air.at(distance[:50], views[:50], 500.0)
    np.testing.assert_allclose(many.inscattered[:50], few.inscattered, rtol=5e-3)
    foreign = air.at(torch.tensor(distance[:50]), torch.tensor(views[:50]), 500.0)
    np.testing.assert_allclose(foreign.inscattered.numpy(), few.inscattered, rtol=1e-9)


def test_straight_down_the_azimuth_does_not_matter():
    air = sd.AirLight(with_sun(sd.HosekWilkie(SUN, 3.0)), meets_horizon=True)
    down = air.at(500.0, sd.direction(np.arange(0, 360, 30) * deg, -89.9999 * deg)).inscattered
    assert (np.ptp(down, axis=0) / down.mean(axis=0)).max() < 1e-4


def test_night_stays_dark_and_one_turbidity_is_asked_for():
    night = sd.Preetham(sd.direction(0.0, -0.3), 3.0, check="nan")
    assert sd.AirLight(night, meets_horizon=True).at(1e4, AROUND).inscattered.max() == 0
    with pytest.raises(ValueError, match="meets_horizon needs one turbidity"):
        sd.AirLight(sd.Preetham(SUN, 3.0), turbidity=[2.0, 3.0], meets_horizon=True)


def test_a_ground_under_a_sky_that_knows_no_spectrum():
    """Sunlight on the ground comes in the channels of the sky's light: colours where the sky has no spectrum."""
    sky = sd.HosekWilkieRGB(SUN, 3.0) + sd.SunDisc(SUN, 3.0)
    spectral = with_sun(sd.HosekWilkie(SUN, 3.0))
    found, known = (sd.aerial_perspective(s, 20e3, AROUND, ground_albedo=0.3).inscattered for s in (sky, spectral))
    np.testing.assert_allclose(found, known, rtol=0.15)
