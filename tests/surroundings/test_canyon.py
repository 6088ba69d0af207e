"""Street canyons against analytic view factors; radiosity against closed forms and the conservation of light."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.surroundings.bands import Bands
from skydome.surroundings.radiosity import (
    crossed_strings,
    interreflected,
    parallel_rectangles,
    perpendicular_rectangles,
    polygon_factors,
    rectangle_factors,
)

UNIT = sd.Uniform(1 / np.pi)
CUBE = np.array(
    [
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]],
        [[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]],
        [[0, 0, 0], [0, 1, 0], [0, 1, 1], [0, 0, 1]],
        [[1, 0, 0], [1, 0, 1], [1, 1, 1], [1, 1, 0]],
        [[0, 0, 0], [0, 0, 1], [1, 0, 1], [1, 0, 0]],
        [[0, 1, 0], [1, 1, 0], [1, 1, 1], [0, 1, 1]],
    ],
    dtype=float,
)


@pytest.mark.parametrize("ratio", [0.3, 1.0, 4.0])
@pytest.mark.parametrize("turn", [0.0, 37.0])
def test_the_floor_sees_the_analytic_share_of_sky(ratio, turn):
    canyon = sd.StreetCanyon(10.0 * ratio, 10.0, turn * deg)
    x = np.linspace(-4.9, 4.9, 5)
    np.testing.assert_allclose(canyon.illuminance(UNIT, x).sky, canyon.point_view_factor(x), atol=1e-12)
    generic = [sd.PlaneView.of(canyon.at(place)).sky_view_factor for place in x]
    np.testing.assert_allclose(generic, canyon.point_view_factor(x), atol=1e-4)


@pytest.mark.parametrize("ratio", [0.5, 2.0])
def test_means_over_floor_and_wall_are_the_crossed_strings(ratio):
    canyon = sd.StreetCanyon(ratio, 1.0, 20 * deg)
    t, w = np.polynomial.legendre.leggauss(24)
    floor = canyon.illuminance(UNIT, t / 2).sky @ w / 2
    assert floor == pytest.approx(canyon.floor_view_factor, abs=1e-4)
    up = (t + 1) / 2 * ratio
    wall = [float(canyon.illuminance(UNIT, [0.5], z, -canyon.right).sky[0]) for z in up] @ w / 2
    assert wall == pytest.approx(canyon.wall_view_factor, abs=1e-4)
    sums = canyon.factors.sum(axis=1).reshape(3, -1).mean(axis=1)
    np.testing.assert_allclose(1 - sums, [canyon.floor_view_factor] + 2 * [canyon.wall_view_factor], atol=1e-12)


@pytest.mark.parametrize("z", [0.0, 3.0])
def test_a_view_is_complete(z):
    canyon = sd.StreetCanyon(12.0, 10.0, 0.5)
    for normal in (sd.ZENITH, canyon.right, sd.unit(sd.ZENITH + canyon.right + canyon.along)):
        view = canyon.at(-2.0, z).view(normal)
        assert view.sky_view_factor + view.factors.sum() / np.pi == pytest.approx(1.0, abs=1e-12)


def test_bands_along_and_across_the_street_agree():
    canyon = sd.StreetCanyon(12.0, 10.0, 0.5, strips=1)
    point = canyon.at(-2.0, 3.0)
    for normal in (canyon.right, -canyon.right, sd.unit(sd.ZENITH + canyon.right)):
        assert sd.PlaneView.of(point, normal).sky_view_factor == pytest.approx(
            point.view(normal).sky_view_factor, abs=1e-4
        )
    across = sd.PlaneView.of(point, sd.ZENITH, Bands.of(sd.ZENITH, 512, canyon.right))
    assert across.sky_view_factor == pytest.approx(point.view().sky_view_factor, abs=1e-4)


def test_the_sun_reaches_the_sunny_side_alone():
    canyon = sd.StreetCanyon(10.0, 10.0, azimuth=90 * deg)  # from west to east; its right is south
    sun = sd.direction(180 * deg, 60 * deg)
    sky = sd.HosekWilkie(sun, turbidity=3.0)
    lit = canyon.illuminance(sky + sd.SunDisc.of(sky), [-4.0, 4.0]).sun  # shadow of the south wall: 5.8 m
    assert lit[0] == pytest.approx(float(sd.SunDisc.of(sky).illuminance(sd.ZENITH)), rel=1e-12)
    assert lit[1] == 0


def test_a_white_canyon_is_as_bright_as_the_sky():
    canyon = sd.StreetCanyon(12.0, 10.0, 0.5, 1 - 1e-7, 1 - 1e-7, strips=8)
    np.testing.assert_allclose(canyon.illuminance(UNIT, [-3.0, 0.0]).total, 1.0, atol=1e-5)


def test_interreflection_converges_with_the_strips():
    sky = sd.MoonSpencer(zenith_luminance=1000.0)
    lit = [sd.StreetCanyon(10.0, 8.0, 0.0, 0.2, 0.5, n).illuminance(sky, [1.0]).reflected[0] for n in (4, 8, 24)]
    assert abs(lit[0] / lit[2] - 1) < 0.03
    assert abs(lit[1] / lit[2] - 1) < 0.01


def test_a_day_in_a_canyon():
    suns = sd.direction(np.linspace(1.8, 4.5, 3), np.linspace(0.2, 0.9, 3))[:, None, :]
    canyon = sd.StreetCanyon(10.0, 8.0, 0.0, 0.2, 0.5, 4)
    sky = sd.HosekWilkie(suns, turbidity=3.0)
    day = canyon.illuminance(sky + sd.SunDisc.of(sky), [0.0, 1.0], bands=16)
    assert day.total.shape == (3, 2)
    one = sd.HosekWilkie(suns[1, 0], turbidity=3.0)
    alone = canyon.illuminance(one + sd.SunDisc.of(one), [0.0, 1.0], bands=16)
    np.testing.assert_allclose(day.total[1], alone.total, rtol=1e-9)


def test_form_factors_in_a_cube():
    factors = rectangle_factors(CUBE, 8)
    np.testing.assert_allclose(factors.sum(axis=1), 1.0, atol=1e-10)
    assert factors[0, 1] == pytest.approx(parallel_rectangles(1, 1, 1), abs=1e-10)
    assert factors[0, 2] == pytest.approx(perpendicular_rectangles(1, 1, 1), abs=1e-10)
    assert parallel_rectangles(1, 1, 1) + 4 * perpendicular_rectangles(1, 1, 1) == pytest.approx(1.0, abs=1e-12)


def test_long_rectangles_become_crossed_strings():
    strips = np.array([[[0.0, 0.0], [1.0, 0.0]], [[0.0, 0.0], [0.0, 2.0]], [[0.0, 2.0], [1.0, 2.0]]])
    endless = crossed_strings(strips, strips)
    assert perpendicular_rectangles(1e4, 1.0, 2.0) == pytest.approx(endless[0, 1], abs=3e-4)
    assert parallel_rectangles(1.0, 1e4, 2.0) == pytest.approx(endless[0, 2], abs=3e-4)


def test_lamberts_contour_is_cut_at_the_plane_of_the_point():
    wall = np.array([[[-1, 1, -5], [1, 1, -5], [1, 1, 3], [-1, 1, 3]]], dtype=float)
    upper = np.array([[[-1, 1, 0], [1, 1, 0], [1, 1, 3], [-1, 1, 3]]], dtype=float)
    here, up = np.zeros((1, 3)), sd.ZENITH[None]
    assert polygon_factors(here, up, wall)[0, 0] == pytest.approx(polygon_factors(here, up, upper)[0, 0], abs=1e-12)
    a, b = 1.0, 3.0  # half the classic corner formula, twice (Howell B-3)
    corner = (np.arctan(a) - np.arctan(a / np.hypot(1, b)) / np.hypot(1, b)) / (2 * np.pi)
    assert polygon_factors(here, up, upper)[0, 0] == pytest.approx(2 * corner, abs=1e-12)
    assert polygon_factors(here, -up, upper)[0, 0] == 0


def test_bands_see_a_polygon_as_the_contour_does():
    pytest.importorskip("embreex")
    triangle = np.array([[-2.0, 3.0, 1.0], [3.0, 4.0, 0.5], [0.0, 2.0, 4.0]])
    scene = sd.MeshScene(triangle, [[0, 1, 2]])
    view = scene.view((0, 0, 0), sd.ZENITH)
    closed = polygon_factors(np.zeros((1, 3)), sd.ZENITH[None], triangle[None])[0, 0]
    assert view.factors[view.labels == 0][0] / np.pi == pytest.approx(closed, abs=1e-4)


def test_radiosity_in_a_cube_with_a_lamp():
    factors = rectangle_factors(CUBE, 8)
    direct = np.array([[1.0, 0, 0, 0, 0, 0], [1.0] * 6])
    lit = interreflected(direct, factors, 0.5)
    np.testing.assert_allclose(lit[1], 2.0, rtol=1e-9)  # 1 + 1/2 + 1/4 ...
    series, term = direct[0].copy(), direct[0].copy()
    for _ in range(60):
        term = factors @ (0.5 * term)
        series += term
    np.testing.assert_allclose(lit[0], series, rtol=1e-9)
    with pytest.raises(ValueError, match=r"reflectance must lie in \[0, 1\)"):
        interreflected(direct, factors, 1.0)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"height": 0.0}, "height must lie"),
        ({"width": np.nan}, "width must lie"),
        ({"wall_reflectance": 1.0}, "wall_refl"),
    ],
)
def test_bad_canyons_are_refused(change, said):
    with pytest.raises(ValueError, match=said):
        sd.StreetCanyon(**({"height": 10.0, "width": 10.0} | change))


def test_points_outside_are_refused():
    with pytest.raises(ValueError, match="must lie in the street"):
        sd.StreetCanyon(10.0, 10.0).at(6.0)
