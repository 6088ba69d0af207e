"""The sun's disc through an atmosphere: its energy, its turbidity, its night."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.air.atmosphere import PREETHAM_HAZE
from skydome.light.spectrum import xyz_weights
from skydome.skies.suns.atmosphere_sun import turbidity_of

BANDS = np.arange(380.0, 721.0, 10.0)


def sun_at(elevation):
    return sd.direction(azimuth=200 * deg, elevation=elevation * deg)


@pytest.mark.parametrize("elevation", [1.0, 5.0, 40.0])
def test_irradiance_is_sunlight_times_transmittance(elevation):
    """Beer's law with the secant where the shells are flat to the ray; below it near the horizon."""
    air = sd.Atmosphere.from_turbidity(3.0, gases=None)
    disc = sd.AtmosphereSun(sun_at(elevation), air)
    flat = air.sun_at(BANDS) * np.exp(-air.depth(BANDS) / np.sin(elevation * deg))
    assert (disc.irradiance(BANDS) > flat).all()
    if elevation == 40:
        assert disc.irradiance(BANDS) == pytest.approx(flat, rel=0.005)
    through = air.transmittance(float(np.sin(elevation * deg)), BANDS)
    assert disc.irradiance(BANDS) == pytest.approx(air.sun_at(BANDS) * through, rel=1e-12)


def test_the_disc_holds_its_irradiance():
    """The points of the disc sum to it, and its level may be given."""
    disc = sd.AtmosphereSun(sun_at(20.0), sd.Atmosphere.from_turbidity(4.0))
    assert disc.points(500)[1].sum(axis=0) == pytest.approx(disc.normal_xyz, rel=1e-12)
    own = (disc.irradiance(disc.bands) @ xyz_weights(disc.bands))[1]
    assert disc.normal_xyz[1] == pytest.approx(own, rel=1e-12)
    given = sd.AtmosphereSun(sun_at(20.0), sd.Atmosphere.from_turbidity(4.0), direct_normal_illuminance=5e4)
    assert given.normal_xyz[1] == pytest.approx(5e4)


def test_turbidity_is_the_atmospheres():
    for turbidity in (1.0, 2.0, 6.0, 12.0):
        disc = sd.AtmosphereSun(sun_at(30.0), sd.Atmosphere.from_turbidity(turbidity, PREETHAM_HAZE))
        assert disc.turbidity == pytest.approx(turbidity, rel=1e-12)
    from skydome.air.constituents import Ozone

    assert turbidity_of(sd.Atmosphere((Ozone(),))) is None


def test_no_light_at_night_and_many_suns_at_once():
    disc = sd.AtmosphereSun(sun_at(np.array([-3.0, 10.0, 60.0])))
    light = disc.normal_xyz[:, 1]
    assert light[0] == 0
    assert 0 < light[1] < light[2]
