"""Directions and the three formulas of spherical distance, against exact small angles."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import skydome as sd
from skydome import deg
from skydome.ground.directions import (
    angle_between,
    azimuth,
    checked_directions,
    elevation,
    rotate_about_vertical,
    separation_arccos,
    separation_haversine,
    separation_vincenty,
    tangent_frame,
    unit,
    zenith_angle,
)

azimuths = st.floats(0.0, 2 * math.pi - 1e-9)
elevations = st.floats(-math.pi / 2, math.pi / 2)


def all_three(elevation_a, elevation_b, difference):
    angles = (np.asarray(value) for value in (elevation_a, elevation_b, difference))
    a, b, d = angles
    return tuple(float(f(a, b, d)) for f in (separation_arccos, separation_haversine, separation_vincenty))


@given(elevations, elevations, azimuths)
def test_the_three_formulas_agree(elevation_a, elevation_b, difference):
    arccos, haversine, vincenty = all_three(elevation_a, elevation_b, difference)
    near_an_end = min(vincenty, math.pi - vincenty) < 1e-3
    assert arccos == pytest.approx(vincenty, abs=1e-7 if near_an_end else 1e-11)
    assert haversine == pytest.approx(vincenty, abs=1e-7 if math.pi - vincenty < 1e-3 else 1e-11)


@pytest.mark.parametrize("angle", [1e-1, 1e-3, 1e-5, 1e-7, 1e-9])
@pytest.mark.parametrize("height", [0.0, 0.3, 1.2])
def test_small_angles_down_to_a_billionth(angle, height):
    """Along a meridian the distance is the difference of elevations; along the horizon that of azimuths."""
    for arccos, haversine, vincenty in (all_three(height, height + angle, 0.0), all_three(0.0, 0.0, angle)):
        exact = (height + angle) - height if height else angle
        tolerance = 1e-9 * angle + 4e-16
        assert haversine == pytest.approx(angle, abs=tolerance)
        assert vincenty == pytest.approx(angle, abs=tolerance)
        assert arccos == pytest.approx(exact, abs=3e-8)
    if angle <= 1e-9:  # what the cosine law is known for: nothing is left of so small an angle
        assert abs(all_three(0.3, 0.3 + angle, 0.0)[0] - angle) > 0.5 * angle


def test_equation_25_needs_the_term_that_the_print_lacks():
    a, b, d = 0.3, 0.9, 1.1
    hav = lambda x: math.sin(x / 2) ** 2  # noqa: E731
    printed = hav(a - b) + (1 - hav(a + b)) * hav(d)
    exact = hav(math.acos(math.sin(a) * math.sin(b) + math.cos(a) * math.cos(b) * math.cos(d)))
    assert hav(all_three(a, b, d)[1]) == pytest.approx(exact, rel=1e-12)
    assert printed == pytest.approx(0.27343, abs=1e-5)
    assert exact == pytest.approx(0.24957, abs=1e-5)


@given(azimuths, st.floats(-1.57, 1.57))
def test_azimuth_and_elevation_come_back(turn, height):
    v = sd.direction(turn, height)
    assert float(np.linalg.norm(v)) == pytest.approx(1.0, abs=1e-15)
    assert float(elevation(v)) == pytest.approx(height, abs=1e-12)
    assert float(zenith_angle(v)) == pytest.approx(math.pi / 2 - height, abs=1e-12)
    assert math.remainder(float(azimuth(v)) - turn, 2 * math.pi) == pytest.approx(0.0, abs=1e-11)


def test_the_compass():
    for degrees, axis in ((0, sd.NORTH), (90, sd.EAST), (180, sd.SOUTH), (270, sd.WEST)):
        np.testing.assert_allclose(sd.direction(degrees * sd.deg, 0.0), axis, atol=1e-15)
    np.testing.assert_allclose(rotate_about_vertical(sd.NORTH, 90 * sd.deg), sd.EAST, atol=1e-15)


@given(azimuths, elevations, st.floats(1e-9, 3.1))
def test_angle_between_vectors(turn, height, angle):
    v = sd.direction(turn, height)
    u, w = tangent_frame(v)
    np.testing.assert_allclose(np.cross(u, w), v, atol=1e-12)
    turned = math.cos(angle) * v + math.sin(angle) * u
    assert float(angle_between(v, turned)) == pytest.approx(angle, abs=1e-15 + 1e-6 * min(angle, 1e-8) + 1e-12 * angle)


def test_vectors_that_are_no_directions_are_refused():
    with pytest.raises(ValueError, match="length 0"):
        unit(np.zeros(3))
    with pytest.raises(ValueError, match="finite unit vectors within 1e-3"):
        checked_directions(np.array([0.0, 0.0, 1.01]))
    with pytest.raises(ValueError, match=r"must have shape \(..., 3\)"):
        checked_directions(np.zeros(2))


ELEVATIONS = {
    "direction": lambda e: sd.direction(0.0, e),
    "directions": lambda e: sd.direction(0.0, [0.1, e]),
    "float32": lambda e: sd.direction(np.float32(0), np.array([e], np.float32)),
    "camera": lambda e: sd.Camera(0.0, e),
    "half sphere": lambda e: sd.HalfSphere(0.0, e),
    "glare": lambda e: sd.glare(sd.EnvironmentMap(np.ones((4, 8, 3))), 0.0, e),
    "horizon": lambda e: sd.Horizon.level(e),
    "field of view": lambda e: sd.Camera(field_of_view=e),
}


@pytest.mark.parametrize("entry", ELEVATIONS.values(), ids=ELEVATIONS)
@pytest.mark.parametrize("degrees", [45, 89.5, 12])
def test_elevations_in_degrees_are_refused_wherever_they_enter(entry, degrees):
    with pytest.raises(
        ValueError, match=rf"must lie in .* degrees, got .*radians; degrees are written {degrees} \* deg"
    ):
        entry(degrees)


AZIMUTHS = {
    "direction": lambda a: sd.direction(a, 0.1),
    "camera": lambda a: sd.Camera(a),
    "canyon": lambda a: sd.StreetCanyon(10.0, 10.0, azimuth=a),
    "horizon": lambda a: sd.Horizon([0.0, a], [0.1, 0.2]),
    "map": lambda a: sd.EnvironmentMap(np.ones((4, 8, 3))).rotated(a),
    "projection": lambda a: sd.Equirectangular(azimuth_left=a),
    "turn": lambda a: rotate_about_vertical(sd.NORTH, a),
}


@pytest.mark.parametrize("entry", AZIMUTHS.values(), ids=AZIMUTHS)
@pytest.mark.parametrize("degrees", [180, -90, 13])
def test_azimuths_in_degrees_warn_wherever_they_enter(entry, degrees):
    with pytest.warns(UserWarning, match=rf"more than two turns, .*degrees are written {degrees} \* deg"):
        entry(degrees)
    entry(degrees * deg)  # and nothing is said of these


def test_ends_of_the_angles_are_allowed():
    for kind in (np.float32, np.float64):
        up = sd.direction(kind(4 * np.pi), np.array([-np.pi / 2, np.pi / 2], kind))
        assert up[:, 2].tolist() == [-1, 1]
    with pytest.raises(ValueError, match=r"\[-90, 90\] degrees, got 90\.0002$"):
        sd.direction(0.0, np.pi / 2 + 3e-6)
