"""Discrete ordinates: against CDISORT's own radiance and flux, in limits, and for shapes."""

from dataclasses import replace
from itertools import product

import numpy as np
import pytest

import skydome as sd
from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Aerosol, Molecules
from skydome.air.phase_laws import HenyeyGreenstein
from skydome.ground.directions import rotate_about_vertical
from skydome.ground.quadrature import hemisphere
from skydome.skies.physical.cosine_series import geometry
from skydome.skies.physical.discrete_ordinates import DiscreteOrdinates, usable_streams
from skydome.skies.physical.layers import layered
from skydome.skies.physical.nishita import Nishita93

nanodisort = pytest.importorskip("nanodisort")
W = np.array([400.0, 700.0])
AIR = Atmosphere.standard(aerosol_depth=0.15, albedo=0.3)
FLAT = replace(AIR, radius=6.371e9)


def sun_at(elevation, azimuth=137.0):
    return sd.direction(azimuth * sd.deg, elevation * sd.deg)


def cdisort(air, cos_sun, wavelength, streams=48, cosines=(0.2, 0.5, 0.9), azimuths=(0.0, 60.0, 180.0)):
    """CDISORT by itself: 300 moments, its own correction (Nakajima and Tanaka); radiance and downward flux."""
    layers = layered(air, np.array([wavelength]), 300)
    state = nanodisort.DisortState()
    state.nstr, state.nlyr, state.nmom, state.ntau = streams, len(layers.depth), 300, 1
    state.numu, state.nphi = len(cosines), len(azimuths)
    state.usrtau = state.usrang = state.lamber = state.quiet = True
    state.intensity_correction = state.old_intensity_correction = True
    state.planck = state.onlyfl = False
    state.umu0, state.phi0, state.fbeam = cos_sun, 0.0, 1.0
    state.albedo = float(air.albedo_at([wavelength])[0])
    state.allocate()
    state.dtauc, state.ssalb = layers.depth[:, 0].copy(), layers.scattered[:, 0].copy()
    state.pmom, state.utau = layers.moments[:, :, 0].copy(), np.array([layers.depth.sum()])
    state.umu, state.phi = -np.sort(cosines)[::-1], np.array(azimuths)
    state.solve()
    return np.asarray(state.uu)[::-1, 0, :], float(np.asarray(state.rfldn)[0]), float(np.asarray(state.rfldir)[0])


@pytest.mark.parametrize("elevation", [10.0, 45.0, 80.0])
def test_against_cdisort_with_many_streams(elevation):
    sun = sun_at(elevation, 0.0)
    azimuth, cosine = np.meshgrid(np.radians([0.0, 60.0, 180.0]), [0.2, 0.5, 0.9])
    views = sd.direction(azimuth, np.arcsin(cosine))
    got = DiscreteOrdinates(sun, FLAT, 24).radiance(views, [550.0])[..., 0] / AIR.sun_at([550.0])
    expected, _, _ = cdisort(FLAT, float(sun[2]), 550.0)
    np.testing.assert_allclose(got, expected, rtol=4e-3)


def test_flux_is_the_integral_of_radiance_and_energy_balances():
    sun = sun_at(50.0)
    directions, solid_angles = hemisphere(48, 64)
    air = Atmosphere((Molecules(), Aerosol(0.2, albedo=1.0)), albedo=1.0)
    light = DiscreteOrdinates(sun, air, 24).radiance(directions, [550.0])[:, 0] / air.sun_at([550.0])
    _, diffuse, direct = cdisort(air, float(sun[2]), 550.0)
    assert (solid_angles * directions[:, 2]) @ light == pytest.approx(diffuse, rel=2e-3)
    assert direct == pytest.approx(sun[2] * np.exp(-air.depth([550.0])[0] / sun[2]), rel=1e-3)
    dark = Atmosphere(air.constituents, albedo=0.0)
    _, diffuse_dark, direct_dark = cdisort(dark, float(sun[2]), 550.0)
    assert 0.5 * sun[2] < diffuse_dark + direct_dark < sun[2]  # nothing absorbs: the rest leaves upward


def test_thin_air_is_single_scattering():
    air = Atmosphere((Molecules(optical_depth=1e-4),), albedo=0.0)
    sun = sun_at(40.0)
    views = hemisphere(4, 8)[0]
    expected = 1e-4 / views[:, 2] * 3 / (16 * np.pi) * (1 + (views @ sun) ** 2)
    thin = Atmosphere((Molecules(optical_depth=1e-4, depolarisation=0.0),), albedo=0.0, radius=6.371e9)
    got = DiscreteOrdinates(sun, thin).radiance(views, [550.0])[:, 0] / thin.sun_at([550.0])
    np.testing.assert_allclose(got, expected, rtol=2e-3)
    assert air.depth([550.0])[0] == 1e-4


@pytest.mark.parametrize(("elevation", "tolerance"), [(5.0, 0.012), (10.0, 0.007), (40.0, 0.004)])
def test_light_scattered_once_goes_through_round_layers(elevation, tolerance):
    """Closed form in 17 layers against quadrature along each view (Nishita 1993)."""
    air, sun = Atmosphere((Molecules(), Aerosol(0.1, phase=HenyeyGreenstein((0.0,)))), albedo=0.0), sun_at(elevation)
    views = np.array([sd.direction(a, np.radians(h)) for a, h in product((0.3, 1.7, 3.0), (2, 5, 20, 70))])
    cosine, _, angle = geometry(views, sun)
    got = layered(air, W, 16).single(cosine, angle, float(sun[2])) * air.sun_at(W)
    np.testing.assert_allclose(got, Nishita93(sun, air).radiance(views, W), rtol=tolerance)


def test_a_sun_on_a_quadrature_angle_is_no_trouble():
    nodes = (np.polynomial.legendre.leggauss(8)[0] + 1) / 2
    assert usable_streams(nodes[3], 16) == 18
    sun = sun_at(np.degrees(np.arcsin(nodes[3])))
    near = sun_at(np.degrees(np.arcsin(nodes[3] + 2e-3)))
    views = hemisphere(4, 8)[0]
    np.testing.assert_allclose(
        DiscreteOrdinates(sun, AIR).radiance(views, W), DiscreteOrdinates(near, AIR).radiance(views, W), rtol=0.02
    )


def test_shapes_night_turning_and_order():
    views = hemisphere(3, 5)[0]
    suns = sun_at(np.array([-5.0, 20.0, 60.0]))[:, None, :]
    light = DiscreteOrdinates(suns, AIR).radiance(views, W)
    assert light.shape == (3, 15, 2)
    assert (light[0] == 0).all()
    np.testing.assert_allclose(light[1], DiscreteOrdinates(sun_at(20.0), AIR).radiance(views, W), rtol=1e-12)
    turned = DiscreteOrdinates(rotate_about_vertical(suns[1, 0], 1.0), AIR)
    np.testing.assert_allclose(turned.radiance(rotate_about_vertical(views, 1.0), W), light[1], rtol=1e-9)
    assert (DiscreteOrdinates(sun_at(20.0), AIR).radiance(-views, W) == 0).all()
    assert DiscreteOrdinates(sun_at(20.0), AIR).luminance(sd.ZENITH) > 100


def test_colours_a_photographer_would_believe():
    sky = DiscreteOrdinates(sun_at(45.0, 180.0), AIR)
    away = sky.radiance(sd.direction(0.0, 45 * sd.deg), [450.0, 650.0])
    near = sky.radiance(sd.direction(np.pi, 40 * sd.deg), [450.0, 650.0])
    assert away[0] / away[1] > 2 * near[0] / near[1]


def test_bad_streams_are_refused():
    with pytest.raises(ValueError, match="streams must be even, got 15"):
        DiscreteOrdinates(sun_at(20.0), AIR, 15)
    with pytest.raises(ValueError, match=r"streams must lie in \[4, 128\], got 2"):
        DiscreteOrdinates(sun_at(20.0), AIR, 2)
