"""Gases whose bands saturate: the beam against SPECTRL2, the sky's light against discrete ordinates, term by term."""

from dataclasses import replace

import numpy as np
import pytest

import skydome as sd
from skydome.air.gases.bands import MIXED, WATER
from skydome.air.gases.gases import WATER_PROFILE, Gases
from skydome.air.gases.skylight import skylight_share
from skydome.air.profiles import STANDARD_1976


def sun_at(elevation):
    return sd.direction(azimuth=0.0, elevation=elevation * sd.deg)


@pytest.mark.parametrize(("elevation", "allowed"), [(60.0, 0.003), (30.0, 0.004), (10.0, 0.008)])
def test_the_beam_is_that_of_spectrl2(elevation, allowed):
    """As a part of the sunlight above the air, 320-2500 nm."""
    pvlib = pytest.importorskip("pvlib")
    zenith, depth = 90 - elevation, 0.2
    peer = pvlib.spectrum.spectrl2(
        zenith,
        0.0,
        0.0,
        ground_albedo=0.2,
        surface_pressure=101325.0,
        relative_airmass=pvlib.atmosphere.get_relative_airmass(zenith),
        precipitable_water=2.5,
        ozone=0.35,
        aerosol_turbidity_500nm=depth * 1.1**1.14,
        dayofyear=100,
    )
    w = peer["wavelength"].astype(float)
    use = (w >= 320) & (w <= 2500)
    air = sd.Atmosphere.standard(depth, angstrom=1.14, ozone=350.0, water=2.5)
    found = sd.AtmosphereSun(sun_at(elevation), air).irradiance(w[use]) / air.sun_at(w[use])
    off = found - np.ravel(peer["dni"] / peer["dni_extra"])[use]
    assert np.sqrt(np.mean(off**2)) < allowed
    assert abs(off.mean()) < allowed / 2


def exponentials(bands):
    """A band's transmittance as a sum of exponentials, by least squares: their rates and weights (a k-distribution)."""
    from scipy.optimize import nnls

    rates, amounts = np.logspace(-3.5, 2.3, 16), np.logspace(-4, 3, 200)
    wanted = bands.transmittance(np.ones(1), amounts)[:, 0]
    scale = 1 / (wanted + 0.03)
    basis = np.exp(-np.outer(amounts, rates))
    weights, _ = nnls(np.vstack([basis * scale[:, None], np.full((1, 16), 30.0)]), np.append(wanted * scale, 30.0))
    assert abs(basis @ weights - wanted).max() < 1e-3
    return rates[weights > 0], weights[weights > 0]


@pytest.mark.parametrize(
    ("bands", "profile", "amount", "gases", "wavelength"),
    [(WATER, WATER_PROFILE, 5.0 * 1.42, Gases(), 920.0), (MIXED, STANDARD_1976, 4.0, Gases(water=0.0), 762.5)],
)
def test_the_skys_light_is_that_of_gas_in_layers(bands, profile, amount, gases, wavelength):
    pytest.importorskip("nanodisort")
    rates, weights = exponentials(bands)
    views = sun_at(np.array([5.0, 20.0, 50.0, 90.0])) * np.array([-1.0, -1.0, 1.0])
    for elevation, depth in ((10.0, 0.3), (50.0, 0.05)):
        w = wavelength + 1e-6 * np.arange(rates.size + 1)
        gas = sd.Aerosol(sd.Spectrum(w, np.append(0.0, rates * amount)), 0.0, 0.0, profile=profile)
        air = sd.Atmosphere.standard(depth)
        layered = replace(air, constituents=(*air.constituents, gas), gases=None)
        light = sd.DiscreteOrdinates(sun_at(elevation), layered).radiance(views, w)
        left = light[:, 1:] @ weights / light[:, 0]
        found = skylight_share(gases, np.full(4, np.sin(elevation * sd.deg)), views[:, 2], [wavelength])[:, 0]
        assert (left < 0.85).all()
        off = found - left
        assert np.sqrt(np.mean(off**2)) < 0.06
        assert abs(off).max() < 0.1


def test_what_gases_take_out_of_luminance():
    """Less than 1 % from 10 degrees up; colours and spectrum agree on it."""
    views = sun_at(np.array([10.0, 40.0, 90.0]))
    sky = sd.PhysicalSky(sun_at(30.0))
    bare = sd.PhysicalSky(sun_at(30.0), replace(sky.atmosphere, gases=None))
    change = sky.luminance(views) / bare.luminance(views) - 1
    assert ((change < -0.001) & (change > -0.01)).all()
    held = sky.held().luminance(views) / bare.held().luminance(views) - 1
    np.testing.assert_allclose(held, change, atol=2e-5)
    spectral = super(sd.PhysicalSky, sky).xyz(views)[:, 1] / super(sd.PhysicalSky, bare).xyz(views)[:, 1] - 1
    np.testing.assert_allclose(change, spectral, atol=5e-5)


def test_many_waters_are_each_alone():
    suns, water = sun_at(np.array([50.0, -3.0]))[:, None, :], np.array([[0.5], [3.0]])
    sky = sd.PhysicalSky(suns, sd.clear_air(water=water))
    for make in (lambda s: s.xyz(sun_at(20.0)[None]), lambda s: s.radiance(sun_at(20.0)[None], [310.0, 940.0])):
        light = make(sky)
        for k in range(2):
            alone = make(sd.PhysicalSky(suns[k, 0], sd.clear_air(water=float(water[k, 0]))))
            np.testing.assert_allclose(light[k], alone, rtol=1e-9)


def test_higher_ground_has_less_oxygen():
    low, high = sd.Atmosphere.standard(), sd.Atmosphere.standard().at_altitude(4000.0)
    assert high.transmittance(1.0, [762.5]) > 1.05 * low.transmittance(1.0, [762.5])
    with pytest.raises(ValueError, match=r"water must lie in \[0, 100\] cm, got -1"):
        sd.Atmosphere.standard(water=-1.0)
