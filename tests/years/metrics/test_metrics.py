"""An office's metrics: our scene beside Radiance's five-phase coefficients, and worked examples of each standard."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.years.gendaymtx.text import read
from skydome.years.metrics.autonomy import (
    blinds_drawn,
    continuous_autonomy,
    daylight_autonomy,
    spatial_autonomy,
    sunlight_exposure,
    useful_illuminance,
)
from skydome.years.metrics.coefficients import LUMINANCE_OF_RGB, DaylightCoefficients
from skydome.years.metrics.doses import doses
from skydome.years.metrics.en_17037 import daylight_provision, glare_level, sunlight_exposure_of_day
from skydome.years.metrics.glare import glare_of_year, position_index, probability, simplified_probability
from skydome.years.metrics.occupancy import daylight_hours, working_hours
from skydome.years.stores.radiance_files import write_matrix


@pytest.fixture(scope="module")
def days(greensboro):
    """One day in five of the Greensboro year, on Tregenza's patches."""
    return sd.year(greensboro.rows(np.arange(greensboro.count) // 24 % 5 == 2))


@pytest.fixture(scope="module")
def by_radiance(office):
    return DaylightCoefficients.read(office / "total.mtx", office / "direct.mtx", office / "suns.mtx")


@pytest.fixture(scope="module")
def by_us(days, office_mesh, desks):
    return sd.on_planes(days, [sd.Plane.facing((0, 0, 1), office_mesh.at(point, (0, 0, 1))) for point in desks])


def test_coefficients_times_skies_are_dctimesteps(days, office, run_radiance, tmp_path):
    """The same product by Radiance, sun in its patch, from the matrices that both read."""
    year = tmp_path / "year.mtx"
    write_matrix(days, year, with_sun=True)
    result = tmp_path / "result.mtx"
    result.write_bytes(run_radiance("dctimestep", "-of", office / "total.mtx", year).stdout)
    theirs = read(result)[0] @ (LUMINANCE_OF_RGB * 179)
    ours = DaylightCoefficients.read(office / "total.mtx").illuminance(days)
    np.testing.assert_allclose(ours.T, theirs, rtol=2e-4, atol=0.5)


def test_our_scene_gives_what_radiance_does(days, by_radiance, by_us):
    """View, sky and interreflection, sun: hour means within 5 % by two programs of different kinds."""
    view = by_us.sky_view_factor.values * np.pi
    np.testing.assert_allclose(view, by_radiance.direct[:, 1:].sum(axis=1), rtol=0.05)
    ours, theirs = by_us.illuminance.values, by_radiance.illuminance(days)
    rows = (light.mean(axis=0).reshape(3, 2).mean(axis=1) for light in (ours, theirs))  # left and right, less noise
    np.testing.assert_allclose(*rows, rtol=0.08)
    cloudy = days.direct_normal_irradiance.values < 1
    np.testing.assert_allclose(ours[cloudy].mean(axis=0), theirs[cloudy].mean(axis=0), rtol=0.06)
    sun = by_us.sun_illuminance.values.mean(axis=0)
    np.testing.assert_allclose(sun, by_radiance.sunlight(days).mean(axis=0), rtol=0.06, atol=6)


def test_the_numbers_to_sign_are_radiances(days, by_radiance, by_us):
    """Every metric from both: autonomies within .05 of the hours, spatial ones the same."""
    hours = working_hours(days)
    pair = by_us.illuminance.values, by_radiance.illuminance(days)
    for metric in (daylight_autonomy, continuous_autonomy):
        ours, theirs = (metric(light, hours) for light in pair)
        np.testing.assert_allclose(ours, theirs, atol=0.05)
    for ours, theirs in zip(*(useful_illuminance(light, hours) for light in pair), strict=True):
        np.testing.assert_allclose(ours, theirs, atol=0.05)
    assert spatial_autonomy(pair[0], hours) == spatial_autonomy(pair[1], hours) == 1.0
    suns = by_us.sun_illuminance.values, by_radiance.sunlight(days)
    exposures = [sunlight_exposure(sun, hours, most=50) for sun in suns]  # a fifth of the year
    assert exposures[0] == exposures[1] == pytest.approx(1 / 3)
    drawn = [blinds_drawn(sun)[hours].mean() for sun in suns]
    assert drawn[0] == pytest.approx(drawn[1], abs=0.02)
    light = daylight_hours(days)
    provisions = [daylight_provision(values, light) for values in pair]
    assert provisions[0].level == provisions[1].level
    assert provisions[0].target == pytest.approx(provisions[1].target, rel=0.12)
    assert light.sum() <= len(light) / 2


def test_provision_by_hand():
    """Ten points, half of the hours bright: medians 200 ... 1100 lx."""
    levels = np.arange(200, 1200, 100.0)
    light = np.concatenate([np.repeat(levels[None], 6, axis=0), np.zeros((5, 10))])
    found = daylight_provision(light, np.full(11, True))
    assert (found.target, found.minimum) == (600.0, 200.0)
    assert found.level == "minimum"
    assert daylight_provision(light + 400, np.full(11, True)).level == "high"


def test_sunlight_hours_of_a_window_by_hand():
    """At the equinox the sun of the equator goes through the zenith: a south wall's edge shares the day in two."""
    place = sd.Place(0.0, 0.0)
    open_sky = sd.Horizon.level(0.0)
    assert sunlight_exposure_of_day(open_sky, place, "2026-03-20").hours == pytest.approx(12, abs=0.1)
    steep = sunlight_exposure_of_day(open_sky, place, "2026-03-20", lowest=45 * deg)
    assert steep.hours == pytest.approx(6, abs=0.1)
    assert steep.level == "high"
    east = sunlight_exposure_of_day(open_sky, place, "2026-03-20", inward=sd.WEST, lowest=60 * deg)
    assert east.hours == pytest.approx(2, abs=0.1)
    assert east.level == "minimum"
    with pytest.raises(ValueError, match="between 1 February and 21 March"):
        sunlight_exposure_of_day(open_sky, place, "2026-06-21")


def test_glare_of_the_eyes(days):
    eyes = [sd.Plane(90 * deg, turn * deg) for turn in (180, 0)]
    light = sd.on_planes(days, eyes)
    found = glare_of_year(light, days)
    plain = simplified_probability(light.illuminance.values)
    dark = (light.illuminance < 1).values
    assert np.nanmax(found[dark]) < 0.02
    sunny = (light.sun_illuminance > 1000).values
    assert (found[sunny] >= plain[sunny]).mean() > 0.95
    south, north = (np.nanmean(found[working_hours(days), k]) for k in (0, 1))
    assert south > north
    assert glare_level(found[:, 0], working_hours(days))[1] == ""


def test_glare_of_a_picture_is_evalglares(run_radiance, tmp_path):
    """A fisheye picture of a grey room with one bright source, by evalglare and by the formula with Guth's index."""
    side = 400
    grid = (np.arange(side) + 0.5) / side * 2 - 1
    x, y = np.meshgrid(grid, -grid)
    radius = np.hypot(x, y)
    angle = radius * np.pi / 2
    turn = np.arctan2(y, x)
    toward = np.stack([np.sin(angle) * np.cos(turn), np.cos(angle), np.sin(angle) * np.sin(turn)], axis=-1)
    centre = sd.direction(20 * deg, 25 * deg)
    inside = (toward @ centre > np.cos(6 * deg)) & (radius < 1)
    level, source = 300.0, 30000.0
    luminance = np.where(radius < 1, np.where(inside, source, level), 0.0)
    pixels = np.repeat((luminance / 179)[..., None], 3, axis=-1).astype("<f4")
    view = "VIEW= -vta -vp 0 0 0 -vd 0 1 0 -vu 0 0 1 -vh 180 -vv 180"
    header = f"#?RADIANCE\n{view}\nFORMAT=32-bit_rle_rgbe\n\n-Y {side} +X {side}\n"
    path = tmp_path / "room.hdr"
    path.write_bytes(header.encode() + rgbe(pixels))
    printed = run_radiance("evalglare", "-b", "2000", "-vta", "-vh", "180", "-vv", "180", path).stdout.decode()
    numbers = [float(word) for word in printed.split(":")[1].split()]
    solid = 2 * np.pi * (1 - np.cos(6 * deg))
    at_eye = np.pi * level + (source - level) * solid * (centre @ sd.NORTH)
    ours = float(probability(at_eye, [source], [solid], [position_index(centre, sd.NORTH)]))
    assert numbers[0] == pytest.approx(ours, abs=0.01)


def rgbe(pixels):
    """Flat RGBE bytes of float pixels."""
    most = pixels.max(axis=-1)
    mantissa, exponent = np.frexp(most)
    scale = np.where(most > 1e-32, mantissa * 256 / np.maximum(most, 1e-32), 0)[..., None]
    return np.concatenate([pixels * scale, (exponent + 128)[..., None]], axis=-1).astype(np.uint8).tobytes()


def test_doses_of_a_level_plane_in_the_open(greensboro):
    """Sky and sun: melanopic ratio near daylight's, photons near 2 umol/J of global light."""
    skies = sd.year(greensboro.rows(slice(4000, 4072)), colour="hosek-wilkie", wavelengths=[550.0])
    light = sd.on_planes(skies, [sd.Plane(0.0), sd.Plane(90 * deg, 0.0)])
    found = doses(light, skies)
    lit = (light.illuminance[:, 0] > 5000).values
    ratio = found.melanopic_edi.values[lit, 0] / light.illuminance.values[lit, 0]
    assert (ratio > 0.8).all()
    assert (ratio < 1.25).all()
    photons = found.photosynthetic_photons.values[lit, 0] / light.irradiance.values[lit, 0]
    assert (photons > 1.7).all()
    assert (photons < 2.4).all()
    integral = found.daily_light_integral.sel(plane="0,180").values
    assert integral.max() < 70
    by_hand = (found.photosynthetic_photons.values[:, 0] * 3600e-6).sum()
    assert integral.sum() == pytest.approx(by_hand)
    with pytest.raises(ValueError, match="year with spectra"):
        doses(light, sd.year(greensboro.rows(slice(0, 24))))


def test_what_cannot_be_is_refused(days, by_radiance, office):
    with pytest.raises(ValueError, match="no hour counts"):
        daylight_autonomy(np.ones((3, 2)), np.full(3, False))
    with pytest.raises(ValueError, match="go together"):
        DaylightCoefficients(by_radiance.total, by_radiance.direct)
    with pytest.raises(ValueError, match="Reinhart's patches"):
        DaylightCoefficients(np.ones((2, 100)))
    with pytest.raises(ValueError, match="needs coefficients of suns"):
        DaylightCoefficients(by_radiance.total).sunlight(days)
    with pytest.raises(ValueError, match="the year of reinhart:2"):
        by_radiance.illuminance(days.assign_attrs(patches="reinhart:2"))
