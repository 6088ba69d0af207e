"""Broadband irradiance, UV index and photons for plants against published relations and pvlib's clear skies."""

import numpy as np
import pytest

import skydome as sd
from skydome.light.action_spectra import photosynthetic_photons


def clear(elevation, **air):
    sky = sd.PhysicalSky(sd.direction(azimuth=0.0, elevation=elevation * sd.deg), sd.clear_air(**air))
    return sky + sd.SunDisc.of(sky)


@pytest.mark.parametrize("elevation", [60.0, 30.0])
@pytest.mark.parametrize(("depth", "water"), [(0.1, 1.42), (0.25, 3.0)])
def test_the_whole_spectrum_against_birds_clear_sky(elevation, depth, water):
    """Bird and Hulstrom 1981 give less: measured here 0.5-4 % (global), 3.5-5 % (direct), 0-6 % (diffuse)."""
    pvlib = pytest.importorskip("pvlib")
    light = sd.broadband(clear(elevation, aerosol_depth=depth, ozone=300.0, water=water))
    mass = pvlib.atmosphere.get_relative_airmass(90 - elevation)
    depths = (depth * (550 / w) ** 1.3 for w in (380, 500))
    peer = pvlib.clearsky.bird(90 - elevation, mass, *depths, water, 0.3, 101325, 1367.0, 0.85, 0.2)
    assert light.global_horizontal == pytest.approx(peer["ghi"], rel=0.05)
    assert light.direct_normal == pytest.approx(peer["dni"], rel=0.055)
    assert light.diffuse_horizontal == pytest.approx(peer["dhi"], rel=0.07)


@pytest.mark.parametrize(("elevation", "ozone"), [(90.0, 300.0), (60.0, 300.0), (60.0, 400.0)])
def test_the_uv_index_is_about_madronichs(elevation, ozone):
    """12.5 cos(zenith)^2.42 (ozone / 300)^-1.23 (Madronich 2007), which knows no haze."""
    found = sd.uv_index(clear(elevation, aerosol_depth=0.05, ozone=ozone))
    wanted = 12.5 * np.sin(elevation * sd.deg) ** 2.42 * (ozone / 300) ** -1.23
    assert found == pytest.approx(wanted, rel=0.06)


def test_photons_are_those_of_the_spectrum():
    sky, w = clear(40.0), np.arange(400.0, 701.0, 5.0)
    spectral = photosynthetic_photons(sd.irradiance(sky, w), w)
    assert sd.photosynthetic_photon_flux(sky) == pytest.approx(spectral, rel=3e-3)


def test_many_suns_are_each_alone():
    suns = sd.direction(0.0, np.radians([50.0, 4.0, -3.0]))[:, None, :]
    many = sd.PhysicalSky(suns)
    both = (sd.broadband(many + sd.SunDisc.of(many)), sd.uv_index(many + sd.SunDisc.of(many)))
    for k, elevation in enumerate((50.0, 4.0, -3.0)):
        one = clear(elevation)
        assert both[0].global_horizontal[k] == pytest.approx(sd.broadband(one).global_horizontal, rel=1e-6)
        assert both[1][k] == pytest.approx(sd.uv_index(one), rel=1e-6)


def test_many_airs_and_suns_without_an_axis_for_views_are_each_alone():
    elevations, depths, water = np.array([50.0, 10.0, -0.3]), np.array([0.05, 0.2, 0.4]), np.array([1.0, 2.0, 3.0])
    both = []
    for lead in (np.s_[:], np.s_[:, None]):
        air = sd.clear_air(aerosol_depth=depths[lead], water=water[lead])
        sky = sd.PhysicalSky(sd.direction(0.0, np.radians(elevations))[lead], air)
        both.append(sky + sd.SunDisc.of(sky))
    for k in range(3):
        one = clear(elevations[k], aerosol_depth=float(depths[k]), water=float(water[k]))
        for many in both:
            assert sd.uv_index(many)[k] == pytest.approx(sd.uv_index(one), rel=1e-9)
            assert sd.broadband(many).direct_normal[k] == pytest.approx(sd.broadband(one).direct_normal, rel=1e-9)
        points, alone = both[1].parts[1].points(16)[1][k], one.parts[1].points(16)[1]
        np.testing.assert_allclose(points, alone, rtol=1e-9)


def test_skies_that_know_too_little_are_refused():
    with pytest.raises(TypeError, match="HosekWilkie does not know light of 300-2500 nm; PhysicalSky does"):
        sd.uv_index(sd.HosekWilkie(sd.direction(0.0, 0.5), 3.0))
    with pytest.raises(TypeError, match="SunDisc does not know"):
        sd.broadband(sd.PhysicalSky(sd.direction(0.0, 0.5)) + sd.SunDisc(sd.direction(0.0, 0.5), 3.0))


def test_what_a_night_must_leave_out_is_named():
    night = sd.sky_at(sd.Place(50.0, 8.0), "2026-01-03T22:00Z")
    words = "leave out Planets, Stars, Starlight, ZodiacalLight, Airglow, from a sd.sky_at by its without"
    with pytest.raises(TypeError, match=words):
        sd.broadband(night)
    known = night.without("planets", "stars", "starlight", "zodiacal light", "airglow")
    assert 0 < sd.broadband(known).global_horizontal < 0.01
