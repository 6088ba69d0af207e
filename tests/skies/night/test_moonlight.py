"""The moon's light: ROLO against rimopy, the disc's energy on maps, moonlit illuminance."""

import numpy as np
import pytest

import skydome as sd
from skydome.ground.units import deg
from skydome.light.spectrum import xyz_weights
from skydome.moon.phase import left_and_up
from skydome.skies.night.moon.lunar_light import BANDS, LunarLight, reflectance
from skydome.skies.night.moon.moon_disc import MoonDisc
from skydome.skies.night.moon.moonlight import Moonlight

PLACE = sd.Place(50.0, 8.0)
FULL, HALF, YOUNG = "2026-01-03T22:00Z", "2026-01-11T03:00Z", "2026-04-19T20:00Z"


@pytest.mark.filterwarnings("ignore::FutureWarning")
def test_reflectance_is_rimopys():
    elref, types = (pytest.importorskip(f"rimopy.{name}") for name in ("elref", "types"))
    random = np.random.default_rng(18)
    phase, turn = random.uniform(2, 97, 200), random.uniform(-97, 97, 200) * deg
    along, across = random.uniform(-8, 8, 200), random.uniform(-7, 7, 200)
    wavelengths = np.arange(400.0, 901.0, 20.0)
    geometry = types.MoonDatas(np.ones(200), np.full(200, 384400.0), turn, across, along, phase)
    theirs = elref.get_reflectance(wavelengths, mds=geometry)
    ours = reflectance(wavelengths, phase * deg, turn, along * deg, across * deg)
    np.testing.assert_allclose(ours, theirs, rtol=1e-9)


def test_light_falls_with_the_phase():
    light = [float(LunarLight.of(sd.moon_phase(PLACE, time)).illuminance) for time in (FULL, HALF, YOUNG)]
    assert 0.2 < light[0] < 0.4  # Allen: 0.267 lx at the mean distance and phase 0; surge and perigee here
    assert 0.05 < light[1] / light[0] < 0.15
    assert light[2] < 0.01


def test_full_moon_at_55_degrees_gives_a_fifth_to_a_third_of_a_lux():
    whole = float(sd.illuminance(Moonlight.over(PLACE, FULL) + MoonDisc.over(PLACE, FULL)))
    print(f"full moon at 55 degrees: {whole:.3f} lx")
    assert 0.2 < whole < 0.3


def test_a_half_moon_gives_a_tenth_of_a_full_one():
    """On the level at 60 degrees and one distance; Krisciunas and Schaefer 1991, eq. 20, has .097 for either half."""
    place, times = sd.Place(0.0, 0.0), ("2025-03-14T02:00Z", "2025-07-02T19:50Z", "2025-08-16T04:20Z")
    phases = [sd.moon_phase(place, time) for time in times]
    angles = np.array([float(phase.phase_angle) for phase in phases]) / deg
    np.testing.assert_allclose(angles, [2.7, 90.0, 90.0], atol=0.3)
    np.testing.assert_allclose([phase.direction[2] for phase in phases], np.sin(60 * deg), atol=0.01)
    light = [float(sd.illuminance(Moonlight.over(place, time) + MoonDisc.over(place, time))) for time in times]
    full, waxing, waning = (
        lux * (float(phase.distance) / 384_400e3) ** 2 for lux, phase in zip(light, phases, strict=True)
    )
    magnitudes = 0.026 * angles + 4e-9 * angles**4
    print(f"full {full:.3f} lx, waxing half {waxing / full:.3f}, waning half {waning / full:.3f} of it")
    assert 0.2 < full < 0.3
    assert waning < waxing  # more of the maria are lit
    assert (waxing + waning) / 2 / full == pytest.approx(10 ** (-0.4 * (magnitudes[1] - magnitudes[0])), rel=0.2)


def test_moonlight_is_sunlight_made_weaker():
    phase = sd.moon_phase(PLACE, FULL)
    moonlit = Moonlight.under(phase)
    day = sd.PhysicalSky(phase.direction)
    wavelengths = [450.0, 550.0, 650.0]
    ratio = moonlit.radiance(sd.ZENITH, wavelengths) / day.radiance(sd.ZENITH, wavelengths)
    np.testing.assert_allclose(
        ratio, moonlit.atmosphere.sun_at(wavelengths) / day.atmosphere.sun_at(wavelengths), rtol=1e-12
    )


@pytest.mark.parametrize("time", [FULL, HALF, YOUNG])
def test_energy_of_the_disc_on_maps_of_every_height(time):
    disc = MoonDisc.over(PLACE, time)
    level = float(disc.illuminance(disc.sun))
    for height in (64, 300, 2048):
        picture = sd.render(disc, height, ground_albedo=0.0, dtype=np.float64)
        angles = picture.projection.solid_angles(height)
        luminance = picture.pixels @ sd.SRGB.to_xyz[1]
        np.testing.assert_allclose((luminance * angles).sum() / level, 1.0, atol=1e-3)
        views = picture.projection.directions(height, slice(0, height // 2))
        mean = np.einsum("rc,rcd->d", (luminance * angles)[: height // 2], views)
        points, carried = disc.points(4096)
        wanted = carried[:, 1] @ points
        assert (
            sd.angle_between(mean / np.linalg.norm(mean), wanted / np.linalg.norm(wanted)) < 0.02 * 2 * np.pi / height
        )


@pytest.mark.parametrize("time", [FULL, HALF])
def test_radiance_over_the_disc_is_its_irradiance_and_lies_where_the_sun_is(time):
    disc = MoonDisc.over(PLACE, time)
    left, up = left_and_up(disc.sun)
    grid = np.linspace(-1.2, 1.2, 200) * disc.angular_radius
    views = disc.sun - grid[None, :, None] * left - grid[:, None, None] * up
    light = disc.radiance(views / np.linalg.norm(views, axis=-1, keepdims=True), BANDS) @ xyz_weights(BANDS)[:, 1]
    whole = light.sum() * (grid[1] - grid[0]) ** 2
    np.testing.assert_allclose(whole, float(disc.illuminance(disc.sun)), rtol=0.01)
    phase = sd.moon_phase(PLACE, time)
    across, along = -(light.sum(axis=0) @ grid), -(light.sum(axis=1) @ grid)
    if phase.phase_angle > 1:
        tilt = np.arctan2(across, along) % (2 * np.pi)
        assert abs((tilt - float(phase.bright_limb) + np.pi) % (2 * np.pi) - np.pi) < 10 * deg


def test_a_set_moon_gives_no_disc():
    disc = MoonDisc.over(PLACE, "2026-01-03T12:00Z")
    assert float(disc.illuminance(sd.ZENITH)) == 0.0
    assert not disc.is_day


def test_moonlight_beside_a_set_sun_is_not_dark():
    set_sun = sd.HosekWilkie(sd.direction(azimuth=0.0, elevation=-0.5), 3.0)
    both = set_sun + Moonlight.over(PLACE, FULL)
    assert float(both.luminance(sd.ZENITH)) > 5e-4
    assert float((set_sun + sd.Uniform(1.0)).luminance(sd.ZENITH)) == 0.0
    three = set_sun + sd.Uniform(1.0) * 1.0 + Moonlight.over(PLACE, FULL)
    assert float(three.luminance(sd.ZENITH)) == pytest.approx(float(both.luminance(sd.ZENITH)))
