"""The sun's place against pvlib's SPA for every age, and against an ephemeris of the JPL by skyfield, run here."""

from importlib.resources import files

import numpy as np
import pytest

from skydome.ground.directions import angle_between, direction
from skydome.ground.units import deg
from skydome.sun.delta_t import delta_t
from skydome.sun.geocentric import J2000, days_since_j2000
from skydome.sun.place import Place
from skydome.sun.position import earth_sun_distance, sun_angles, sun_direction

SECOND = np.timedelta64(1, "s")
AGES = (-1999, -1500, -1000, -500, 0, 500, 1000, 1500, 1700, 1800, 1900, 1950, 2000, 2026, 2050, 2100, 2300, 2700, 2999)


def times_of(year, count, random):
    """Random instants of a year, in order."""
    start = np.datetime64(year - 1970, "Y").astype("datetime64[us]")
    return start + np.sort(random.integers(0, 365 * 86_400_000_000, count)).astype("timedelta64[us]")


def spa(times, place, pressure=101325.0, temperature=12.0):
    """pvlib's SPA: directions seen and true, and distances; delta T is pvlib's, by month."""
    from pvlib import spa

    months = times.astype("datetime64[M]").astype(int)
    seconds, lag = (
        days_since_j2000(times) * 86400 + 946728000,
        spa.calculate_deltat(months // 12 + 1970, months % 12 + 1),
    )
    where = (place.latitude, place.longitude, place.altitude, pressure / 100, temperature, lag, 0.5667)
    _, _, seen, true, azimuth, _ = spa.solar_position(seconds, *where)
    distance = np.asarray(spa.solar_position(seconds, *where, esd=True))[0]
    return direction(azimuth * deg, seen * deg), direction(azimuth * deg, true * deg), distance


@pytest.mark.parametrize("year", AGES)
def test_within_two_hundred_thousandths_of_a_degree_of_spa(year):
    random = np.random.default_rng(year + 2000)
    times = times_of(year, 300, random)
    for latitude in (*random.uniform(-90, 90, 3), 90.0, -90.0):
        place = Place(latitude, random.uniform(-180, 180), random.uniform(0, 4000))
        seen, true, distance = spa(times, place, pressure=90000.0, temperature=20.0)
        off = angle_between(sun_direction(place, times), true).max() / deg
        print(f"{year}: {off:.1e} degrees from SPA")
        assert off < 2e-5
        # two suns by SPA's steps may stand on both sides of -0.8333 degrees, below which nothing is corrected
        edge = np.abs(np.arcsin(true[:, 2]) / deg + 0.8333) < 1e-4
        assert angle_between(sun_direction(place, times, True, 90000.0, 20.0), seen)[~edge].max() / deg < 1e-4
        np.testing.assert_allclose(earth_sun_distance(times), distance, rtol=1e-8)


def test_refraction_has_spas_own_numbers():
    times = times_of(2026, 2000, np.random.default_rng(1))
    place = Place(45.07, 7.69, 240)
    seen, true, _ = spa(times, place, 95000.0, -5.0)
    theirs = np.arcsin(seen[:, 2]) - np.arcsin(true[:, 2])
    ours = sun_angles(place, times, True, 95000.0, -5.0)[1] - sun_angles(place, times)[1]
    np.testing.assert_allclose(ours, theirs, atol=1e-7 * deg)


def test_delta_t_against_pvlib():
    from pvlib.spa import calculate_deltat

    years = np.arange(-1999, 3000)
    middle_of_june = years + 5.5 / 12
    np.testing.assert_allclose(delta_t(middle_of_june), calculate_deltat(years, np.full(years.shape, 6)), rtol=1e-10)


def by_skyfield(ephemeris, times, place):
    """Directions and distances of the apparent sun, DE421; `times` are UT1, and the lag (s) is skyfield's."""
    from skyfield.api import load, wgs84

    instants = load.timescale(builtin=True).ut1_jd(2451545.0 + days_since_j2000(times))
    station = ephemeris["earth"] + wgs84.latlon(place.latitude, place.longitude, place.altitude)
    elevation, azimuth, _ = station.at(instants).observe(ephemeris["sun"]).apparent().altaz()
    _, _, distance = ephemeris["earth"].at(instants).observe(ephemeris["sun"]).radec()
    return direction(azimuth.radians, elevation.radians), distance.au


def test_against_the_jpl_ephemeris():
    """By skyfield, with the measured lag of the earth's turning, 1900 to 2026.

    A third of the difference is the aberration by the earth's turning, which SPA leaves out.
    """
    load_file = pytest.importorskip("skyfield.api").load_file
    folder = files(pytest.importorskip("skyfield_data")) / "data"
    random = np.random.default_rng(3)
    times = J2000 + np.sort(random.integers(-36000 * 86400, 9800 * 86400, 4000)) * SECOND
    ephemeris = load_file(str(folder / "de421.bsp"))
    for latitude in (-60.0, 0.0, 45.07):
        place = Place(latitude, random.uniform(-180, 180), 240)
        theirs, distance = by_skyfield(ephemeris, times, place)
        off = angle_between(sun_direction(place, times), theirs) / deg
        print(f"latitude {latitude}: {off.max():.6f} degrees from DE421, median {np.median(off):.6f}")
        assert off.max() < 0.00025
        np.testing.assert_allclose(earth_sun_distance(times), distance, atol=4e-6)
    ephemeris.close()


def test_against_erfas_own_chain():
    """ERFA's earth (`epv00`), precession, nutation and sidereal time by today's standards, 1900 to 2100."""
    import erfa

    random = np.random.default_rng(4)
    times = J2000 + np.sort(random.integers(-36500 * 86400, 36500 * 86400, 500)) * SECOND
    days = days_since_j2000(times)
    tt = days + delta_t(2000 + days / 365.2425) / 86400
    place = Place(-33.87, 151.21, 60)
    heliocentric, barycentric = erfa.epv00(2451545.0, tt)
    sun = -heliocentric["p"]
    distance = np.linalg.norm(sun, axis=-1, keepdims=True)
    velocity = barycentric["v"] / 173.1446326846693
    proper = erfa.ab(sun / distance, velocity, distance[:, 0], np.sqrt(1 - np.sum(velocity**2, axis=-1)))
    of_date = np.einsum("nij,nj->ni", erfa.pnm06a(2451545.0, tt), proper) * distance
    turn = erfa.gst06a(2451545.0, days, 2451545.0, tt)
    fixed = np.einsum("nij,nj->ni", erfa.rz(turn, np.eye(3)), of_date)
    local = fixed - erfa.gd2gc(1, place.longitude * deg, place.latitude * deg, place.altitude) / 149597870700.0
    local /= np.linalg.norm(local, axis=-1, keepdims=True)
    south_east_up = erfa.ry(np.pi / 2 - place.latitude * deg, erfa.rz(place.longitude * deg, np.eye(3)))
    south, east, up = south_east_up @ local.T
    off = angle_between(sun_direction(place, times), np.stack([east, -south, up], axis=-1)) / deg
    print(f"{off.max():.6f} degrees from ERFA's chain, median {np.median(off):.6f}")
    assert off.max() < 0.0003
