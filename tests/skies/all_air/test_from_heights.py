"""The sky, the haze and the ground from heights: DISORT's light inside the air, paths, and what must hold."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import skydome as sd
from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Molecules
from skydome.ground.quadrature import hemisphere
from skydome.skies.all_air.from_heights.diffuse_field import SUNS
from skydome.skies.all_air.from_heights.harmonics import associated
from skydome.skies.all_air.from_heights.views import Places
from skydome.skies.physical import layers
from skydome.skies.physical.precomputed.observer import lines

W = np.array([450.0, 550.0, 700.0])
AIR = replace(sd.Atmosphere.standard(0.3, 0.7, albedo=0.6), gases=None)
SINE = np.sin(25 * sd.deg)
STEEP = np.array([-70.0, -40.0, -20.0, 20.0, 40.0, 70.0])
"""Elevations at which flat layers and round ones hardly differ."""


@cache
def field():
    """Of the air above."""
    return sd.DiffuseField.of(AIR, W)


def disort_inside(height, azimuth, streams=32):
    """Radiance at a height for a sun of irradiance 1, sr-1, (views, W), in flat layers, its beam in round ones."""
    nanodisort = pytest.importorskip("nanodisort")
    cut = layers.layered(AIR, W, streams)
    light = np.zeros((STEEP.size, W.size))
    for w in range(W.size):
        state = nanodisort.DisortState()
        state.nstr, state.nlyr, state.nmom = streams, len(cut.depth), streams
        state.ntau, state.numu, state.nphi = 1, STEEP.size, 1
        state.usrtau = state.usrang = state.lamber = state.quiet = state.spher = True
        state.intensity_correction = state.old_intensity_correction = True
        state.planck = state.onlyfl = False
        state.umu0, state.phi0, state.fbeam, state.albedo = SINE, 0.0, 1.0, 0.6
        state.allocate()
        state.radius, state.zd = cut.radii[-1] / 1000, (cut.radii - cut.radii[-1]) / 1000
        state.dtauc, state.ssalb = cut.depth[:, w].copy(), cut.scattered[:, w].copy()
        state.pmom = cut.moments[:, :, w].copy()
        edges = cut.radii - cut.radii[-1]
        state.utau = np.interp([-height], -edges, np.append(0.0, np.cumsum(cut.depth[:, w])))
        order = np.argsort(-STEEP)
        state.umu, state.phi = -np.sin(np.radians(STEEP[order])), np.array([azimuth])
        state.solve()
        light[order, w] = np.asarray(state.uu)[:, 0, 0]
    return light


@pytest.mark.parametrize(("edge", "azimuth"), [(6, 60.0), (9, 150.0)])
def test_up_and_down_from_within_the_air(edge, azimuth):
    """As discrete ordinates have it at an edge of their layers, where their light needs no interpolation."""
    height = float(layers.edges_of(AIR)[edge])
    sky = sd.SkyFromHeight.by(field(), sd.direction(0.0, 25 * sd.deg), height)
    light = sky.radiance(sd.direction(azimuth * sd.deg, STEEP * sd.deg), W) / AIR.sun_at(W)
    np.testing.assert_allclose(light, disort_inside(height, azimuth), rtol=0.03)


def test_without_air_there_is_the_ground_alone():
    """From 10 km a lit ground of albedo .5 down to the horizon at -3.2 degrees, and nothing above."""
    empty = Atmosphere((Molecules(optical_depth=0.0),), albedo=0.5)
    sky = sd.SkyFromHeight.by(sd.DiffuseField.of(empty, [550.0]), sd.direction(0.0, 30 * sd.deg), 10_000.0)
    views = sd.direction(90 * sd.deg, np.array([-90.0, -45.0, -3.5, -3.0]) * sd.deg)
    light = sky.radiance(views, [550.0])[:, 0] / empty.sun_at([550.0])
    np.testing.assert_allclose(light[:2], 0.5 / np.pi * 0.5, rtol=2e-3)
    assert light[2] > 0.05
    assert light[3] == 0.0


def test_what_comes_in_is_absorbed_by_the_ground_or_goes_out():
    """Air that absorbs nothing over a flat, black ground: its light on the ground and out to space is the sun's."""
    flat = Atmosphere((Molecules(),), albedo=0.0, radius=6.371e9)
    field, sun = sd.DiffuseField.of(flat, [400.0]), sd.direction(0.0, 0.7)
    views, solid_angles = hemisphere(24, 12)
    sky = sd.SkyFromHeight.by(field, sun, flat.height)
    out = solid_angles * views[:, 2] @ sky.radiance(views * [1, 1, -1], [400.0])[:, 0] / flat.sun_at([400.0])[0]
    assert out + field.falling(sun[2:])[0, 0] == pytest.approx(sun[2], rel=2e-3)


def test_light_that_goes_to_and_fro_is_a_series():
    """Irradiance of the ground is E / (1 - albedo s), with E that of a black one and s what the air sends back."""
    lit = [
        sd.DiffuseField.of(Atmosphere((Molecules(),), albedo), [400.0]).falling(np.array([0.6]))[0, 0]
        for albedo in (0.0, 0.5, 1.0)
    ]
    assert 1 / lit[0] - 1 / lit[1] == pytest.approx(1 / lit[1] - 1 / lit[2], rel=1e-9)
    assert 1 - lit[0] / lit[2] == pytest.approx(0.25, abs=0.03)  # s of molecules .36 deep


def test_near_the_ground_it_is_the_physical_sky():
    """By day, where the air bends little, the networks and the field tell the same sky."""
    air = replace(sd.clear_air(0.1), gases=None)
    sun, views = sd.direction(0.0, 35 * sd.deg), sd.direction(np.array([1.0, 2.0, 3.0]), np.array([0.2, 0.5, 1.2]))
    low = sd.SkyFromHeight.by(sd.DiffuseField.of(air, W), sun).radiance(views, W)
    np.testing.assert_allclose(low, sd.PhysicalSky(sun, air).radiance(views, W), rtol=0.02)


def test_views_along_the_haze_by_paths():
    """From 1 km, aerosol .3, sun at 25 degrees, 550 nm, azimuth 90: 1,000,000 paths (.13 %, benchmarks/heights.py)."""
    views = sd.direction(90 * sd.deg, np.array([-30.0, -5.0, -1.0, 3.0]) * sd.deg)
    light = sd.SkyFromHeight.by(field(), sd.direction(0.0, 25 * sd.deg), 1000.0).radiance(views, W)[:, 1]
    np.testing.assert_allclose(light / AIR.sun_at(W)[1], PATHS, rtol=0.02)


PATHS = [0.06319, 0.06781, 0.06942, 0.06931]


def test_what_air_gives_off_is_the_same_compiled():
    pytest.importorskip("numba")
    views, sun = sd.direction(np.linspace(0, 3, 40), np.linspace(-1.5, 1.5, 40)), sd.direction(0.0, 0.2)
    line = lines(field().shell, 3000.0, views, sun)
    places = Places.of(field().air, line, field().heights, SUNS)
    readable, compiled = (of(field().air, field().moments) for of in (places.seen, places.compiled))
    np.testing.assert_allclose(compiled, readable, rtol=1e-12)


def test_the_beam_brightens_with_height():
    suns = [sd.SkyFromHeight.by(field(), sd.ZENITH, h).direct_normal_illuminance for h in (0.0, 3000.0, 30_000.0, 4e5)]
    np.testing.assert_array_less(suns[:-1], suns[1:])
    assert suns[0] == pytest.approx(float(sd.AtmosphereSun(sd.ZENITH, AIR).normal_xyz[1]), rel=1e-3)


def test_the_functions_are_orthonormal():
    x, w = np.polynomial.legendre.leggauss(16)
    for wave in (0, 3):
        table = associated(8, wave, x)
        norm = (2 * np.arange(wave, 8) + 1) / 2
        np.testing.assert_allclose((table * w) @ table.T * norm, np.eye(8 - wave), atol=1e-12)


def test_the_lowest_sun_is_held_itself():
    """Light at -4 degrees goes on from that just above (before: what is scattered once alone)."""
    lit = [
        sd.SkyFromHeight.by(field(), sd.direction(0.0, e * sd.deg), 10.0).radiance(sd.ZENITH, W) for e in (-4, -3.99)
    ]
    np.testing.assert_allclose(lit[0], lit[1], rtol=0.02)


def test_refusals():
    for height in (-1.0, float("nan")):
        with pytest.raises(ValueError, match="height must lie in"):
            sd.SkyFromHeight(sd.ZENITH, AIR, height)
    with pytest.raises(ValueError, match=r"use SkyFromHeight\.by"):
        sd.SkyFromHeight(sd.ZENITH, sd.clear_air(), 0.0, field())
    with pytest.raises(ValueError, match="takes no layers"):
        sd.DiffuseField.of(sd.Atmosphere((sd.Cloud(10.0),)), W)


def test_arrays_of_other_libraries_are_refused():
    """Before, a sun of torch's came out as NumPy's light, without gradients, or with an error of torch's own."""
    torch = pytest.importorskip("torch")
    sun, thick = torch.tensor([0.0, 0.6, 0.8]), sd.clear_air(torch.tensor(0.1, requires_grad=True))
    for kind in (sd.SkyFromHeight, sd.Nishita93, sd.DiscreteOrdinates):
        with pytest.raises(TypeError, match=f"{kind.__name__} takes a sun of NumPy's, got torch's"):
            kind(sun)
        with pytest.raises(TypeError, match=f"{kind.__name__} takes air of plain numbers, got torch's"):
            kind(sd.ZENITH, thick)
    with pytest.raises(TypeError, match="DiffuseField takes air of plain numbers"):
        sd.DiffuseField.of(sd.clear_air(asymmetry=torch.tensor(0.7)), W)


def test_no_directions_have_no_light():
    nothing = np.zeros((0, 3))
    assert sd.SkyFromHeight.by(field(), sd.ZENITH, 10.0).radiance(nothing, W).shape == (0, 3)
    assert sd.PathTraced(sd.ZENITH, AIR).radiance(nothing, W).shape == (0, 3)
