"""The planets against the JPL's DE421 and skyfield's magnitudes."""

from importlib.resources import files

import numpy as np

from skydome.ground.directions import angle_between, direction
from skydome.ground.units import deg
from skydome.stars.planets import planets
from skydome.sun.celestial import aberrated, earth, from_place
from skydome.sun.geocentric import days_since_j2000
from skydome.sun.place import Place
from skydome.sun.position import sun_direction

NEAR = {"Mercury", "Venus", "Mars"}


def test_directions_and_magnitudes_against_de421():
    from skyfield.api import load, load_file, wgs84
    from skyfield.magnitudelib import planetary_magnitude

    random = np.random.default_rng(4)
    times = np.datetime64("1950-01-01", "us") + random.integers(0, 100 * 365 * 86400, 300).astype("timedelta64[s]")
    ephemeris = load_file(str(files("skyfield_data") / "data" / "de421.bsp"))
    place = Place(48.0, 16.0, 200)
    station = ephemeris["earth"] + wgs84.latlon(place.latitude, place.longitude, place.altitude)
    at = station.at(load.timescale(builtin=True).ut1_jd(2451545.0 + days_since_j2000(times)))
    for planet in planets(place, times):
        seen = at.observe(ephemeris[planet.name if planet.name in NEAR else f"{planet.name} barycenter"])
        elevation, azimuth, _ = seen.apparent().altaz()
        off = angle_between(planet.direction, direction(azimuth.radians, elevation.radians)).max() / deg
        plain = planet.phase_angle < 140 * deg
        difference = np.abs(planetary_magnitude(seen) - planet.magnitude)[plain]
        print(f"{planet.name}: {off:.4f} degrees, {np.nanmax(difference):.3f} magnitudes")
        assert off < 0.03
        assert np.nanmax(difference) < 0.12
    ephemeris.close()


def test_years_far_from_now_come_without_a_warning():
    """ERFA's sun stands where NREL's does; ERFA itself would warn of its series for the earth outside 1900-2100."""
    place = Place(48.0, 16.0, 200)
    times = np.array(["0500-02-20T12", "1500-05-20T12", "2500-08-20T12", "2999-11-20T12"], "datetime64[us]")
    here, velocity = earth(times)
    far = np.linalg.norm(here, axis=-1, keepdims=True)
    seen = from_place(place, aberrated(-here / far, velocity) * far, times)
    seen /= np.linalg.norm(seen, axis=-1, keepdims=True)
    off = angle_between(seen, sun_direction(place, times)).max() / deg
    print(f"the sun far from now: {off:.5f} degrees")
    assert off < 0.002
    assert all(np.isfinite(planet.magnitude).all() for planet in planets(place, times))
