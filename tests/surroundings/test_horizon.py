"""Horizons: closed forms, files, terrain; what they take from sky, sun and ground."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg

SUN = sd.direction(180 * deg, 25 * deg)


@pytest.mark.parametrize("height", [5, 30, 60])
def test_a_ring_leaves_cos_squared(height):
    view = sd.PlaneView.of(sd.Horizon.level(height * deg))
    assert view.sky_view_factor == pytest.approx(np.cos(height * deg) ** 2, abs=2e-4)
    assert view.factors.sum() / np.pi + view.sky_view_factor == pytest.approx(1.0, abs=1e-12)


def test_a_rough_profile_against_its_integral():
    rng = np.random.default_rng(3)
    profile = sd.Horizon(np.arange(36) * 10 * deg, rng.uniform(0, 40, 36) * deg)
    turn = (np.arange(72_000) + 0.5) * (2 * np.pi / 72_000)
    exact = np.mean(np.cos(profile.at(turn)) ** 2)
    assert sd.PlaneView.of(profile).sky_view_factor == pytest.approx(exact, abs=2e-4)
    assert sd.PlaneView.of(profile, tolerance=3e-5).sky_view_factor == pytest.approx(exact, abs=5e-5)


def test_a_tilted_plane_before_hills_against_a_dense_sum():
    profile = sd.Horizon(np.array([0, 90, 180, 270]) * deg, np.array([5, 10, 35, 20]) * deg)
    normal, sky = sd.direction(180 * deg, 50 * deg), sd.HosekWilkie(SUN, turbidity=3.0)
    z = (np.arange(1000) + 0.5) / 1000
    turn = (np.arange(2000) + 0.5) * (2 * np.pi / 2000)
    nodes = sd.direction(turn[None, :], np.arcsin(z)[:, None]).reshape(-1, 3)
    seen = profile.seen(nodes) == -1
    exact = np.sum(sky.luminance(nodes) * np.maximum(nodes @ normal, 0) * seen) * (2 * np.pi / nodes.shape[0])
    received = sd.obstructed_illuminance(sky, profile, normal)
    assert received.sky == pytest.approx(exact, rel=1e-3)


def test_an_open_horizon_is_the_open_sky():
    sky = sd.HosekWilkie(SUN, turbidity=3.0)
    whole = sky + sd.SunDisc.of(sky)
    for normal in (sd.ZENITH, sd.SOUTH, sd.direction(1.0, 0.6)):
        received = sd.obstructed_illuminance(whole, sd.Horizon.level(0.0), normal, albedo=0.3)
        assert received.total == pytest.approx(float(sd.illuminance(whole, normal, ground_albedo=0.3)), rel=5e-4)


def test_the_sun_goes_behind_a_ridge():
    sky = sd.HosekWilkie(SUN, turbidity=3.0)
    disc = sd.SunDisc.of(sky)
    radius = float(disc.angular_radius)
    full = float(disc.illuminance(sd.ZENITH))
    for rise, share in ((-2 * radius, 1.0), (0.0, 0.5), (2 * radius, 0.0)):
        lit = sd.obstructed_illuminance(sky + disc, sd.Horizon.level(25 * deg + rise), sd.ZENITH).sun
        assert lit == pytest.approx(share * full, abs=0.05 * full)


def test_a_year_of_skies_by_one_view():
    suns = sd.direction(np.linspace(1.8, 4.5, 6), np.linspace(0.2, 0.9, 6))[:, None, :]
    sky = sd.HosekWilkie(suns, turbidity=3.0)
    view = sd.PlaneView.of(sd.Horizon.level(20 * deg), sd.SOUTH, 32)
    received = view.receive(sky + sd.SunDisc.of(sky), albedo=0.2)
    assert received.total.shape == received.sky.shape == received.sun.shape == (6,)
    one = sd.HosekWilkie(suns[4, 0], turbidity=3.0)
    alone = view.receive(one + sd.SunDisc.of(one), albedo=0.2)
    np.testing.assert_allclose(received.total[4], alone.total, rtol=1e-9)
    assert received.sun[0] == 0  # below the ridge
    assert received.sun[4] > 0


def test_faces_of_given_luminance_add_their_share():
    hills = sd.Horizon.level(30 * deg)
    bright = sd.obstructed_illuminance(sd.Uniform(0.0), hills, luminances={0: 100.0})
    assert bright.total == pytest.approx(100 * np.pi * 0.25, rel=1e-3)


def test_profiles_are_read(tmp_path):
    file = tmp_path / "profile.csv"
    file.write_text("azimuth,elevation\n# hills\n90,10\n0,5\n180,20\n270,8.5\n360,5\n")
    profile = sd.Horizon.read(file)
    np.testing.assert_allclose(profile.at(np.array([0, 45, 315]) * deg) / deg, [5, 7.5, 6.75])


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "must have rows"),
        ("0,5\n90,x\n", "line 2: must be azimuth,elevation"),
        ("0,5\n90\n", "line 2"),
        ("0,5\n90,95\n", r"elevations must lie in \[0, 90\) degrees, got 95"),
        ("0,5\n90,-3\n", "got -3"),
        ("0,nan\n", "must be finite"),
        ("0,5\n0,7\n", "must not repeat"),
    ],
)
def test_bad_profiles_are_refused(tmp_path, text, said):
    file = tmp_path / "profile.csv"
    file.write_text(text)
    with pytest.raises(ValueError, match=said):
        sd.Horizon.read(file)


def test_a_cliff_in_the_terrain():
    heights = np.zeros((201, 201))
    heights[:, 150:] = 100.0  # a plateau 50 cells to the east
    profile = sd.Horizon.from_dem(heights, 10.0, 100, 100, curvature=False)
    assert profile.at(90 * deg) == pytest.approx(np.arctan(100 / 500), abs=1e-9)
    assert profile.at(60 * deg) == pytest.approx(np.arctan(100 / (500 / np.sin(60 * deg))), rel=0.03)
    assert profile.at(270 * deg) == 0
    turned = sd.Horizon.from_dem(heights.T[::-1], 10.0, 100, 100, curvature=False)
    assert turned.at(0.0) == pytest.approx(np.arctan(100 / 500), rel=0.03)  # now in the north
    assert turned.at(180 * deg) == 0


def test_a_cone_seen_from_its_foot_and_the_earths_curve():
    y, x = np.mgrid[0:301, 0:301] - 150.0
    far = np.hypot(x - 100, y)
    heights = np.maximum(0, 60 - far) * 30.0  # 1800 m high, 100 cells east
    profile = sd.Horizon.from_dem(heights, 30.0, 150, 150, curvature=False)
    assert profile.at(90 * deg) == pytest.approx(np.arctan(1800 / 3000), rel=1e-6)
    curved = sd.Horizon.from_dem(heights, 30.0, 150, 150)
    assert 0 < profile.at(90 * deg) - curved.at(90 * deg) < 3000 / (2 * 6.371e6) * 1.01
    assert sd.Horizon.from_dem(heights, 30.0, 150, 150, above=2000.0).at(90 * deg) == 0


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"heights": np.zeros(4)}, "shape"),
        ({"heights": np.full((4, 4), np.nan)}, "16 cells without data"),
        ({"cell": 0.0}, "cell must be"),
        ({"row": 9}, "viewpoint must lie inside"),
    ],
)
def test_bad_terrain_is_refused(change, said):
    with pytest.raises(ValueError, match=said):
        sd.Horizon.from_dem(**({"heights": np.zeros((4, 4)), "cell": 10.0, "row": 1, "column": 1} | change))


def test_bad_albedo_is_refused():
    with pytest.raises(ValueError, match="albedo must lie"):
        sd.obstructed_illuminance(sd.Uniform(1.0), sd.Horizon.level(0.1), albedo=1.5)
