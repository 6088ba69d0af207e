import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from skydome.ground.directions import angle_between, azimuth, elevation
from skydome.ground.units import deg
from skydome.sun.place import Place
from skydome.sun.position import earth_sun_distance, solar_radius, sun_angles, sun_direction
from skydome.sun.preetham_position import preetham_sun_direction

TURIN = Place(45.07, 7.69, 240)
places = st.builds(Place, st.floats(-90, 90), st.floats(-180, 180), st.floats(0, 4000))


def test_reda_and_andreas_worked_example():
    # NREL/TP-560-34302, appendix A.5: zenith 50.11162 (with refraction), azimuth 194.34024 degrees, R 0.9965422974;
    # its delta T is 67 s, 2.5 s more than that of the polynomial: 3e-5 degrees
    place, time = Place(39.742476, -105.1786, 1830.14), "2003-10-17T12:30:30-07:00"
    toward = sun_direction(place, time, refraction=True, pressure=82000, temperature=11)
    assert 90 - float(elevation(toward)) / deg == pytest.approx(50.11162, abs=5e-5)
    assert float(azimuth(toward)) / deg == pytest.approx(194.34024, abs=5e-5)
    assert float(earth_sun_distance(time)) == pytest.approx(0.9965422974, abs=1e-8)


@given(places, st.integers(-2208988800, 4133894400))
def test_unit_vectors_everywhere_from_1900_to_2100(place, second):
    time = np.datetime64(second, "s")
    for refraction in (False, True):
        assert np.linalg.norm(sun_direction(place, time, refraction)) == pytest.approx(1, abs=1e-12)


@given(places, st.integers(-2208988800, 4133894400))
def test_refraction_lifts_and_never_by_more_than_a_degree(place, second):
    time = np.datetime64(second, "s")
    lift = sun_angles(place, time, refraction=True)[1] - sun_angles(place, time)[1]
    assert -1e-12 <= lift < 1 * deg


def test_shapes():
    times = np.datetime64("2026-06-21T00", "h") + np.arange(24).reshape(2, 3, 4)
    assert sun_direction(TURIN, times).shape == (2, 3, 4, 3)
    assert sun_direction(TURIN, times[0, 0, 0]).shape == (3,)
    assert sun_direction(TURIN, []).shape == (0, 3)
    assert earth_sun_distance(times).shape == solar_radius(times).shape == (2, 3, 4)
    np.testing.assert_allclose(sun_direction(TURIN, times)[1, 2, 3], sun_direction(TURIN, times[1, 2, 3]), atol=1e-13)


def test_sun_goes_east_south_west_over_turin():
    morning, noon, evening = (
        sun_direction(TURIN, f"2026-03-20T{hour}", refraction=False)
        for hour in ("06:00+01:00", "12:36+01:00", "18:30+01:00")
    )
    assert morning[0] > 0.9
    assert noon[1] < -0.6
    assert abs(noon[0]) < 0.01
    assert evening[0] < -0.9


def test_sun_stands_north_in_the_south():
    assert sun_direction(Place(-33.87, 151.21), "2026-06-21T12:00+10:00")[1] > 0.8


def test_poles():
    june = sun_direction(Place(90, 0), np.datetime64("2026-06-21T00", "h") + np.arange(24))
    np.testing.assert_allclose(june[:, 2], np.sin(23.435 * deg), atol=2e-3)
    december = sun_direction(Place(-90, 0), np.datetime64("2026-12-21T00", "h") + np.arange(24))
    np.testing.assert_allclose(december[:, 2], np.sin(23.435 * deg), atol=2e-3)


@pytest.mark.parametrize("latitude", [-60.0, 0.0, 60.0])
def test_date_line_is_one_line(latitude):
    times = np.datetime64("2026-06-21T00", "h") + np.arange(24)
    east, west = (sun_direction(Place(latitude, side), times) for side in (180.0, -180.0))
    np.testing.assert_allclose(east, west, atol=1e-11)


def test_leap_day_moves_on_smoothly():
    days = np.datetime64("2024-02-27T12") + 24 * np.arange(5)
    steps = np.diff(sun_angles(TURIN, days)[1]) / deg
    np.testing.assert_allclose(steps, 0.38, atol=0.02)


def test_distance_and_radius():
    days = np.datetime64("2026-01-01") + np.arange(365)
    distance = earth_sun_distance(days)
    assert distance.min() == pytest.approx(0.9833, abs=1e-4)
    assert distance.max() == pytest.approx(1.0167, abs=1e-4)
    np.testing.assert_allclose(solar_radius(days) / deg * 3600, 959.63 / distance, rtol=1e-6)


def test_years_out_of_reach():
    with pytest.raises(ValueError, match="years -1999 to 3000, got 3001"):
        sun_direction(TURIN, np.datetime64("3001-01-01"))
    assert np.isfinite(sun_direction(TURIN, np.datetime64("-1999-01-01"))).all()


def test_naive_time_is_refused():
    with pytest.raises(ValueError, match="needs its zone"):
        sun_direction(TURIN, "2026-06-21T15:00")


def test_refraction_follows_pressure_and_altitude():
    time = "2026-06-21T20:00+02:00"
    sea, high = (sun_angles(Place(45.07, 7.69, altitude), time, refraction=True)[1] for altitude in (0, 3000))
    assert sea > high
    assert sun_angles(TURIN, time, refraction=True, pressure=0)[1] == pytest.approx(sun_angles(TURIN, time)[1])


def random_places_and_times(count):
    random = np.random.default_rng(2020)
    latitudes = np.arcsin(random.uniform(-1, 1, count)) / deg
    span = np.datetime64("2031-01-01", "us") - np.datetime64("2020-01-01", "us")
    times = np.datetime64("2020-01-01", "us") + (random.uniform(0, 1, count) * span.astype(float)).astype("m8[us]")
    return [Place(*place) for place in zip(latitudes, random.uniform(-180, 180, count), strict=True)], times


def test_preetham_a6_against_spa():
    places, times = random_places_and_times(1000)
    pairs = zip(places, times, strict=True)
    off = [angle_between(preetham_sun_direction(p, t), sun_direction(p, t)) / deg for p, t in pairs]
    print(f"Preetham A.6 against SPA: largest {max(off):.4f}, median {np.median(off):.4f} degrees")
    assert 0.95 < max(off) < 0.98


def test_preetham_a6_shapes():
    times = np.datetime64("2026-06-21T00", "h") + np.arange(24).reshape(4, 6)
    toward = preetham_sun_direction(TURIN, times)
    assert toward.shape == (4, 6, 3)
    assert (angle_between(toward, sun_direction(TURIN, times)) < 1.5 * deg).all()
