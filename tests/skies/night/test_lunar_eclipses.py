"""The moon in the earth's shadow: contacts and magnitudes against the canon and skyfield, light against papers."""

from importlib.resources import files

import numpy as np
import pytest

import skydome as sd
from skydome.air.cross_sections import solar_irradiance
from skydome.ground.units import deg
from skydome.light.spectrum import xyz_weights
from skydome.skies.night.moon.earth_shadow import KNOTS, Ring, usual_ring
from skydome.skies.night.moon.lunar_light import BANDS, LunarLight
from skydome.skies.night.moon.moon_face import MoonFace

PLACE = sd.Place(0.0, 180.0)
DISTANCE, RADIUS = 384_400_000.0, 0.2666 * deg


def seconds_from(published, day, magnitude, level):
    """Of what crosses a level, the seconds between ours and the published times."""
    times = np.datetime64(f"{day}T08:00") + np.arange(0, 13 * 3600, 30) * np.timedelta64(1, "s")
    values = getattr(sd.LunarEclipse.at(times), magnitude) - level
    at = np.flatnonzero(np.diff(np.sign(values)))
    found = 30 * (at + values[at] / (values[at] - values[at + 1]))
    wanted = [(np.datetime64(f"{day}T{text}") - times[0]) / np.timedelta64(1, "s") for text in published.split()]
    return np.abs(found - wanted)


@pytest.mark.parametrize(
    ("day", "half", "partial", "total", "umbral"),
    [
        ("2025-09-07", "15:28:21 20:55:00", "16:27:02 19:56:26", "17:30:41 18:52:47", 1.36379),
        ("2026-03-03", "08:44:22 14:22:59", "09:50:00 13:17:10", "11:04:26 12:02:45", 1.1507),
    ],
)
def test_contacts_are_those_of_the_canon(day, half, partial, total, umbral):
    """Espenak's contacts, UTC; the umbral magnitude to the canon's own digits of the earth's figure."""
    off = [
        seconds_from(half, day, "penumbral_magnitude", 0),
        seconds_from(partial, day, "umbral_magnitude", 0),
        seconds_from(total, day, "umbral_magnitude", 1),
    ]
    assert np.max(off) < 12
    deepest = np.datetime64(f"{day}T11:00") + np.arange(0, 8 * 60) * np.timedelta64(1, "m")
    assert sd.LunarEclipse.at(deepest).umbral_magnitude.max() == pytest.approx(umbral, abs=0.003)


def test_magnitudes_are_skyfields():
    from skyfield import eclipselib
    from skyfield.api import load, load_file

    scale = load.timescale(builtin=True)
    ephemeris = load_file(str(files("skyfield_data") / "data" / "de421.bsp"))
    times, _, details = eclipselib.lunar_eclipses(scale.utc(2022), scale.utc(2030), ephemeris)
    ours = sd.LunarEclipse.at(np.array([time.replace(tzinfo=None) for time in times.utc_datetime()], "datetime64[us]"))
    ephemeris.close()
    assert len(ours.separation) > 15
    np.testing.assert_allclose(ours.umbral_magnitude, details["umbral_magnitude"], atol=0.005)
    np.testing.assert_allclose(ours.penumbral_magnitude, details["penumbral_magnitude"], atol=0.005)


def test_molecules_alone_leave_a_2400th_in_the_middle():
    """Vollmer and Gedzelman 2008; with ozone, haze, clouds and mountains a hundred times less."""
    bands = np.arange(400.0, 701.0, 10.0)
    sun = solar_irradiance(bands)

    def reduced(ring):
        light = ring.light(np.array([0.0, 0.01]), DISTANCE, RADIUS)[0]
        return sun.sum() / (np.exp(np.interp(bands, KNOTS, np.log(light))) @ sun)

    molecules = sd.clear_air(aerosol_depth=0.0, ozone=0.0, stratospheric_depth=0.0)
    assert reduced(Ring.of(molecules, clouded=0.0)) == pytest.approx(2400, rel=0.1)
    assert 2400 * 50 < reduced(usual_ring()) < 2400 * 150


def test_half_shadow_is_the_part_of_the_sun_beside_the_earth():
    """Above the air light is straight: the share is that of a disc less one a hundred kilometres larger than the earth,
    but for what the highest air bends; out of the shadow all is left."""
    ring = Ring.of(sd.clear_air(), clouded=1.0)
    angles = np.array([0.9, 1.0, 1.1, 1.4]) * deg
    found = ring.light(angles, DISTANCE, RADIUS)[:, np.searchsorted(KNOTS, 560.0)]
    edge = (6_371_000.0 + 20_000.0) / DISTANCE
    eclipse = sd.Eclipse(
        np.array([1.0, 0, 0]), np.stack([np.cos(angles), np.sin(angles), 0 * angles], -1), RADIUS, edge
    )
    uniform = 1 - eclipse.obscuration
    np.testing.assert_allclose(found[:3], uniform[:3], atol=0.06)  # the limb is darker than the mean
    assert found[3] == pytest.approx(1.0, abs=2e-3)
    assert np.all(np.diff(found) > 0)


def test_a_total_eclipse_is_copper_and_ten_thousand_times_darker():
    """9 February 1990: -3.32 magnitudes at the deepest, as measured by Hernitschek et al. 2008."""
    phase = sd.moon_phase(PLACE, "1990-02-09T19:11Z")
    light = LunarLight.of(phase).lit * MoonFace.of(phase).left(BANDS) @ xyz_weights(BANDS)
    assert -2.5 * np.log10(light[1] / 2.54e-6) == pytest.approx(-3.32, abs=0.3)
    deep = sd.sky_at(PLACE, "2026-03-03T11:34Z")
    x, y = deep["moon"].normal_xyz[:2] / deep["moon"].normal_xyz.sum()
    assert x > 0.42 > y > 0.37
    assert any("umbral magnitude 1.15" in note for note in deep.notes)
    before = sd.sky_at(PLACE, "2026-03-03T08:30Z")
    assert 5_000 < float(before["moon"].normal_xyz[1]) / float(deep["moon"].normal_xyz[1]) < 50_000
    assert not any("eclipse" in note for note in before.notes)


def test_maps_keep_the_energy_of_an_eclipsed_moon_and_moonlight_has_as_much():
    disc = sd.MoonDisc.over(PLACE, "2026-03-03T10:30Z")
    level = float(disc.illuminance(disc.sun))
    picture = sd.render(disc, 256, ground_albedo=0.0, dtype=np.float64)
    light = (picture.pixels @ sd.SRGB.to_xyz[1] * picture.projection.solid_angles(256)).sum()
    assert light == pytest.approx(level, rel=1e-3)
    lunar = sd.Moonlight.over(PLACE, "2026-03-03T10:30Z").atmosphere.sun_at(np.array([450.0, 650.0]))
    whole = disc.atmosphere.sun_at(np.array([450.0, 650.0]))
    _, spots = disc.spots(4096, np.array([450.0, 650.0]))
    np.testing.assert_allclose(
        spots.sum(axis=0) / disc.left(disc.sun[2], np.array([450.0, 650.0])), lunar / whole, rtol=0.01
    )
