"""The moon against the JPL's DE421 by skyfield, and Meeus's printed example."""

from importlib.resources import files

import numpy as np
import pytest

from skydome.ground.directions import angle_between, direction
from skydome.ground.units import deg
from skydome.moon.events import moon_events
from skydome.moon.geocentric import moon_vectors
from skydome.moon.libration import moon_axes, places_on_moon
from skydome.moon.phase import moon_phase
from skydome.moon.position import moon_direction, moon_distance
from skydome.sun.geocentric import J2000, days_since_j2000
from skydome.sun.place import Place

SECOND = np.timedelta64(1, "s")


@pytest.fixture(scope="module")
def sky():
    """DE421 and skyfield's time scale, by UT1 as ours."""
    from skyfield.api import load, load_file

    scale = load.timescale(builtin=True)
    ephemeris = load_file(str(files("skyfield_data") / "data" / "de421.bsp"))
    yield ephemeris, lambda times: scale.ut1_jd(2451545.0 + days_since_j2000(times.astype("datetime64[us]")))
    ephemeris.close()


def station(ephemeris, place):
    from skyfield.api import wgs84

    return ephemeris["earth"] + wgs84.latlon(place.latitude, place.longitude, place.altitude)


def cases(count, each):
    random = np.random.default_rng(18)
    for _ in range(count):
        place = Place(random.uniform(-90, 90), random.uniform(-180, 180), random.uniform(0, 4000))
        seconds = random.integers(0, 100 * 365 * 86400, each).astype("timedelta64[s]")
        yield place, np.datetime64("1950-01-01T00:00:00", "us") + seconds


def test_direction_distance_and_phase_against_de421(sky):
    ephemeris, scale = sky
    for place, times in cases(40, 25):
        at = station(ephemeris, place).at(scale(times))
        moon = at.observe(ephemeris["moon"]).apparent()
        elevation, azimuth, distance = moon.altaz()
        off = angle_between(moon_direction(place, times), direction(azimuth.radians, elevation.radians)) / deg
        phase = moon_phase(place, times)
        assert off.max() < 0.006
        np.testing.assert_allclose(moon_distance(place, times), distance.m, rtol=1.5e-4)
        np.testing.assert_allclose(phase.phase_angle / deg, moon.phase_angle(ephemeris["sun"]).degrees, atol=0.005)
        sun = at.observe(ephemeris["sun"]).apparent()
        np.testing.assert_allclose(phase.elongation / deg, moon.separation_from(sun).degrees, atol=0.01)


def test_bright_limb_and_illuminated_share_against_de421(sky):
    from skyfield.trigonometry import position_angle_of

    ephemeris, scale = sky
    for place, times in cases(8, 10):
        at = station(ephemeris, place).at(scale(times))
        moon, sun = (at.observe(ephemeris[name]).apparent() for name in ("moon", "sun"))
        phase = moon_phase(place, times)
        np.testing.assert_allclose(phase.illuminated, moon.fraction_illuminated(ephemeris["sun"]), atol=1e-4)
        theirs = position_angle_of(moon.altaz(), sun.altaz()).radians
        off = np.abs((phase.bright_limb - theirs + np.pi) % (2 * np.pi) - np.pi) / deg
        assert off[(phase.phase_angle > 0.1) & (phase.phase_angle < 3.0)].max() < 0.1


def test_rise_and_set_against_de421(sky):
    from skyfield import almanac

    ephemeris, scale = sky
    worst = 0.0
    for place, times in cases(12, 1):
        low = Place(place.latitude * 0.7, place.longitude)
        day = times[0].astype("datetime64[D]")
        found = moon_events(low, day, "UTC")
        start, end = scale(np.array([day, day + 1]))
        for search, ours in ((almanac.find_risings, found.rise), (almanac.find_settings, found.set)):
            theirs, real = search(station(ephemeris, low), ephemeris["moon"], start, end)
            theirs = theirs[real]
            assert len(theirs) == (not np.isnat(ours))
            if len(theirs):
                instant = J2000 + np.timedelta64(round((theirs[0].ut1 - 2451545.0) * 86400e6), "us")
                worst = max(worst, abs((instant - ours) / SECOND))
    print(f"rise and set within {worst:.1f} s")
    assert worst < 5


def test_libration_of_meeus_example_53a():
    # Meeus 1998, example 53.a, 12 April 1992, 0h TD: optical librations of the earth, and the sun's place
    instant = np.array([np.datetime64("1992-04-12T00:00:00.000", "us") - np.timedelta64(59184, "ms")])
    axes = moon_axes(instant)
    longitude, latitude = places_on_moon(axes, -moon_vectors(instant))
    np.testing.assert_allclose([longitude[0] / deg, latitude[0] / deg], [-1.206, 4.194], atol=0.001)


def test_upside_down_in_the_south():
    time = "2026-01-04T00:30Z"  # near its transit
    north, south = (moon_phase(Place(latitude, 0.0), time).axis / deg for latitude in (50.0, -35.0))
    assert abs((north + 180) % 360 - 180) < 40
    assert abs(south - 180) < 40


def test_days_without_a_rise():
    days = np.arange("2026-01-01", "2026-02-01", dtype="datetime64[D]")
    found = moon_events(Place(50.0, 8.0), days, "Europe/Berlin")
    assert np.isnat(found.rise).sum() == np.isnat(found.set).sum() == 1
    with pytest.raises(ValueError, match="days must be at least one"):
        moon_events(Place(50.0, 8.0), [])
