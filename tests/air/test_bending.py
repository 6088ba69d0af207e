"""How the air bends light: known refraction, Bouguer's law, thinning; straight rays without air."""

import numpy as np

import skydome as sd
from skydome.air.bending import Shells, bending
from skydome.air.profiles import STANDARD_1976
from skydome.skies.all_air.column_tables import ColumnTables

EARTH = (6_371_000.0, 100_000.0)


def bennett(apparent):
    """Refraction, degrees, of apparent elevations in degrees at 10 C and 1010 hPa (Bennett 1982)."""
    return 1 / np.tan(np.radians(apparent + 7.31 / (apparent + 4.4))) / 60


def test_the_sun_is_lifted_as_the_almanacs_have_it():
    apparent = np.array([0.5, 2.0, 5.0, 10.0, 30.0, 60.0])
    turned = Shells(*EARTH).turns(np.zeros(1), np.sin(np.radians(apparent)))[0]
    warmer = 283.15 / 288.15 * 1013.25 / 1010
    np.testing.assert_allclose(np.degrees(turned), bennett(apparent) * warmer, rtol=0.03)
    horizon = np.degrees(bending(*EARTH).turned[0, 0]) * 60
    assert 32 < horizon < 35  # minutes of arc


def test_seen_from_the_ground():
    """True elevations back to apparent ones, and the flattened sun's share of light."""
    tables = ColumnTables.of(sd.clear_air())
    apparent = np.radians([0.3, 1.0, 3.0, 10.0, 45.0])
    turned = Shells(*EARTH).turns(np.zeros(1), np.sin(apparent))[0]
    seen, share = tables.seen(np.zeros(5), apparent - turned)
    np.testing.assert_allclose(seen, apparent, atol=2e-5)
    nearby = np.radians([0.01, 0.6])
    flat = 1 / (1 - np.diff(Shells(*EARTH).turns(np.zeros(1), np.sin(nearby))[0])[0] / np.diff(nearby)[0])
    assert abs(share[0] - flat) < 0.01
    assert 0.8 < flat < 0.88  # the setting sun is about five parts high and six wide
    assert tables.seen(np.zeros(1), np.radians([-0.7]))[1] == 0


def test_grazing_light_turns_twice_and_is_thinned():
    """From 30 km the ground's edge: light has turned on its way in and out; the thinning closes energy."""
    table = bending(*EARTH)
    row = np.searchsorted(table.heights, 30_000.0)
    height = table.heights[row]
    rising = Shells(*EARTH).turns(np.array([height]), np.array([(2 * height / EARTH[0]) ** 0.5]))[0, 0]
    np.testing.assert_allclose(table.lift[row, 0], 2 * table.turned[0, 0] - rising, rtol=2e-3)
    assert (np.diff(table.lift[row]) <= 0).all()
    places = np.linspace(0, 1, 96) ** 2 * (np.pi / 2 - table.horizon[row]) + table.horizon[row]
    seen = places + table.lift[row]
    middle = (table.share[row, 1:] + table.share[row, :-1]) / 2
    np.testing.assert_allclose(np.diff(seen) / np.diff(places), middle, atol=0.06)  # kinks of the tropopause
    assert table.share[row, 0] < 0.5


def test_air_that_does_not_bend():
    table = bending(*EARTH, 0.0)
    assert not table.lift.any()
    np.testing.assert_allclose(table.share, 1, rtol=1e-12)
    np.testing.assert_allclose(table.lowest, table.heights, atol=15)
    np.testing.assert_allclose(np.cos(table.horizon), EARTH[0] / (EARTH[0] + table.heights), rtol=1e-9)
    columns = Shells(*EARTH, 0.0).columns(STANDARD_1976, np.zeros(1), np.array([1.0, 0.0]))[0]
    air = sd.Atmosphere((sd.Molecules(optical_depth=1.0, profile=STANDARD_1976),))
    np.testing.assert_allclose(columns, air.slant_depths(np.array([1.0, 0.0]), [550.0])[:, 0], rtol=1e-3)


def test_the_low_sun_comes_through_a_little_more_air():
    """Relative optical mass on the horizon, refracted: 38 (Kasten and Young 1989)."""
    column = Shells(*EARTH).columns(STANDARD_1976, np.zeros(1), np.zeros(1))[0, 0]
    assert abs(column / 37.92 - 1) < 0.015
