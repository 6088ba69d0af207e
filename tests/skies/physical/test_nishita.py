"""Nishita's skies: against slow plain quadrature, against discrete ordinates, in twilight."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

import skydome as sd
from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Aerosol, Molecules
from skydome.air.rays import ColumnTable, columns_out, horizon, running_integral
from skydome.ground.quadrature import gauss_legendre, hemisphere
from skydome.skies.physical.nishita import Nishita93, Nishita96

AIR = replace(Atmosphere.standard(aerosol_depth=0.06, albedo=0.1), gases=None)
W = np.array([400.0, 550.0, 700.0])


def sun_at(elevation, azimuth=180.0):
    return sd.direction(azimuth * sd.deg, elevation * sd.deg)


def plain_single_scattering(air, sun, view, wavelengths, steps=2000):
    """Trapezoids along the view and toward the sun, nothing shared with the library's tables."""
    top = air.radius + air.height
    start = np.array([0, 0, air.radius])
    length = -start @ view + np.sqrt((start @ view) ** 2 - start @ start + top**2)
    t = length * np.linspace(0, 1, steps) ** 2
    points = start + t[:, None] * view
    depths = np.stack([p.depth(wavelengths) for p in air.constituents])
    height = np.linalg.norm(points, axis=1) - air.radius
    density = np.stack([p.profile.density(height) for p in air.constituents])
    pieces = (density[:, 1:] + density[:, :-1]) / 2 * np.diff(t)
    to_eye = np.concatenate([np.zeros((len(density), 1)), np.cumsum(pieces, axis=1)], axis=1)
    out = -points @ sun + np.sqrt((points @ sun) ** 2 - (points**2).sum(1) + top**2)
    u = out[:, None] * np.linspace(0, 1, 600) ** 2
    along = np.linalg.norm(points[:, None] + u[..., None] * sun, axis=-1) - air.radius
    lit = (along.min(axis=1) > -1e-3)[:, None]
    to_sun = np.stack([np.trapezoid(p.profile.density(np.maximum(along, 0)), u, axis=1) for p in air.constituents])
    light = np.exp(-((to_eye + to_sun).T @ depths)) * lit
    strength = sum(
        density[k][:, None] * depths[k] * p.scattered(wavelengths) * p.phase_law.value(view @ sun, wavelengths)
        for k, p in enumerate(air.constituents)
    )
    return np.trapezoid(light * strength, t, axis=0) * air.sun_at(wavelengths)


@pytest.mark.parametrize("elevation", [60.0, 8.0, 0.5])
def test_single_scattering_against_plain_quadrature(elevation):
    sun = sun_at(elevation)
    for azimuth, height in ((180.0, 5.0), (180.0, 70.0), (0.0, 1.0), (90.0, 30.0)):
        view = sd.direction(azimuth * sd.deg, height * sd.deg)
        expected = plain_single_scattering(AIR, sun, view, W)
        np.testing.assert_allclose(
            Nishita93(sun, AIR).radiance(view, W), expected, rtol=1e-2
        )  # at half a degree the blue is e-13 of sunlight


@pytest.mark.parametrize("height", [20.0, 2.0])
def test_twilight_by_plain_quadrature(height):
    """Measured 0.4 and 0.35 %: the earth's shadow ends somewhere between two of 128 samples."""
    view = sd.direction(np.pi, height * sd.deg)
    got = Nishita93(sun_at(-4.0), AIR).radiance(view, W)
    np.testing.assert_allclose(got, plain_single_scattering(AIR, sun_at(-4.0), view, W, 1000), rtol=5e-3)


def test_twilight_falls_with_the_sun():
    zenith = [float(Nishita93(sun_at(e), AIR).radiance(sd.ZENITH, [550.0])[0]) for e in (5.0, 0.0, -3.0, -6.0, -9.0)]
    assert all(a > 2 * b > 0 for a, b in pairwise(zenith))


def test_orders_grow_toward_the_whole():
    pytest.importorskip("nanodisort")
    views = hemisphere(6, 8)[0]
    views = views[views[:, 2] > 0.17]
    sun = sun_at(50.0)
    whole = sd.DiscreteOrdinates(sun, AIR).radiance(views, W)
    once, twice = Nishita93(sun, AIR).radiance(views, W) / whole, Nishita96(sun, AIR).radiance(views, W) / whole
    assert (once < twice).all()
    assert (twice < 1.01).all()
    assert (np.median(twice, axis=0) > [0.7, 0.88, 0.93]).all()


def test_second_order_is_the_square_of_a_thin_air():
    """In thin air the second order over the first is proportional to the optical depth."""
    sun, view = sun_at(50.0), sd.direction(0.3, 60 * sd.deg)
    ratios = []
    for depth in (0.0005, 0.001):
        air = Atmosphere((Molecules(optical_depth=depth), Aerosol(depth, 0.0, 0.9)), albedo=0.0)
        ratios.append(Nishita96(sun, air).radiance(view, [550.0]) / Nishita93(sun, air).radiance(view, [550.0]) - 1)
    assert ratios[1] / ratios[0] == pytest.approx(2, rel=0.02)


def test_column_table_against_quadrature():
    table, rng = ColumnTable.of(AIR), np.random.default_rng(3)
    height = rng.uniform(0, 1, 500) ** 2 * 40_000
    lowest = horizon(AIR, height)
    cosine = lowest + (1 - lowest) * rng.uniform(0, 1, 500) ** 2
    found, blocked = table.look_up(height, cosine)
    exact = columns_out(AIR, AIR.radius + height, cosine)
    assert not blocked.any()
    np.testing.assert_allclose(found[0], exact[0], rtol=5e-3)
    assert table.look_up(np.array([1000.0]), np.array([-0.1]))[1].all()


def test_running_integral_is_exact_for_polynomials():
    x = gauss_legendre(12)[0]
    np.testing.assert_allclose(running_integral(12) @ (6 * x**5), x**6, atol=1e-13)


def test_shapes_and_what_lies_below_the_horizon():
    suns = sun_at(np.array([10.0, 40.0]))[:, None, :]
    views = hemisphere(3, 4)[0]
    light = Nishita96(suns, AIR).radiance(views, W)
    assert light.shape == (2, 12, 3)
    np.testing.assert_allclose(light[1], Nishita96(sun_at(40.0), AIR).radiance(views, W), rtol=1e-12)
    assert (Nishita93(sun_at(40.0), AIR).radiance(-views, W) == 0).all()
    with pytest.raises(ValueError, match=r"rings must lie in \[2, 64\], got 1"):
        Nishita96(sun_at(40.0), AIR, rings=1)
