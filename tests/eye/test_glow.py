"""A sun in the eye: its light is kept, its glow is round, its halo coloured, its needles fair."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.eye.bright_source import BrightSource, without_sources
from skydome.eye.eye import Eye, halo_share, plainly_seen
from skydome.eye.glow import Glow, disc_glow
from skydome.eye.point_spread import MESOPIC, PHOTOPIC, CIETotal, StilesHolladay, cap
from skydome.eye.streaks import Needles, halo_colours
from skydome.eye.view import Camera, HalfSphere

SUN = sd.direction(180 * deg, 25 * deg)
RADIUS = 0.2666 * deg


@pytest.fixture(scope="module")
def sky():
    return sd.HosekWilkie(SUN, turbidity=3.0)


@pytest.fixture(scope="module")
def sunny(sky):
    return sd.render(sky + sd.SunDisc.of(sky), height=512)


def whole(angle, value):
    """Integral over the sphere of a profile (A, 3), by a fine trapezium rule."""
    fine = np.unique(np.concatenate([angle, np.linspace(0, np.pi, 200_001), np.linspace(0, 2 * RADIUS, 20_001)]))
    cells = np.diff(cap(fine))[:, None]
    dense = np.stack([np.interp(fine, angle, value[:, k]) for k in range(3)], axis=-1)
    return np.sum((dense[1:] + dense[:-1]) / 2 * cells, axis=0)


@pytest.mark.parametrize("spread", [PHOTOPIC, MESOPIC, CIETotal(60, 1.2), StilesHolladay(40)], ids=str)
@pytest.mark.parametrize("halo", [0.0, 0.016])
@pytest.mark.parametrize("radius", [RADIUS, 2 * deg, 0.02 * deg])
def test_glow_of_a_disc_keeps_its_light(spread, halo, radius):
    np.testing.assert_allclose(whole(*disc_glow(spread, radius, halo)), 1, rtol=5e-3)


def test_glow_is_the_mean_over_the_disc():
    # by brute force: the spread averaged over 40,000 points of the disc
    spread, angle = CIETotal(35), np.array([0.0, 0.1, 0.25, 0.3, 0.5, 1.0, 4.0, 8.0]) * deg
    k = np.arange(40_000)
    r, turn = RADIUS * np.sqrt((k + 0.5) / k.size), k * np.pi * (3 - np.sqrt(5))
    at, value = disc_glow(spread, RADIUS)
    for a in angle[3:]:
        distance = np.hypot(a - r * np.cos(turn), r * np.sin(turn))
        assert np.interp(a, at, value[:, 1]) == pytest.approx(spread(distance).mean(), rel=4e-3)
    # within the disc nearly all the light of the core is there: the disc's own brightness times that share
    middle = spread.within(RADIUS) / cap(np.float64(RADIUS))
    assert value[0, 1] == pytest.approx(middle, rel=1e-3)


def test_glow_meets_its_far_form_without_a_step():
    angle, value = disc_glow(CIETotal(35), RADIUS, 0.004)
    joint = np.argmin(np.abs(angle - 24 * RADIUS))
    near = slice(joint - 3, joint + 5)
    slope = np.diff(np.log(value[near, 1])) / np.diff(np.log(angle[near]))
    assert np.ptp(slope) < 0.1


@pytest.mark.parametrize("side", [64, 256, 1024])
def test_view_holds_the_share_that_the_spread_has(side):
    # the share of light within 10 degrees of the sun, against the spread's own
    view = Camera(180 * deg, 25 * deg, 40 * deg, side)
    source = BrightSource(SUN, np.array([1.0, 1.0, 1.0]), RADIUS)
    glow = Eye(60, "blue").glow(RADIUS, 3000.0, sd.SRGB)
    picture = glow.painted(view.toward, view.shape, source)
    within = np.arccos(view.directions() @ SUN) <= 10 * deg
    got = np.einsum("ijc,ij->c", picture, view.solid_angles() * within)
    want = whole_within(glow, 10 * deg)
    np.testing.assert_allclose(got, want, rtol=0.012 if side == 64 else 4e-3)
    assert 0.9 < want[1] < 1


def whole_within(glow, limit):
    inside = np.where(glow.angle[:, None] <= limit, glow.value, 0.0)
    return whole(glow.angle, inside)


@pytest.mark.parametrize("height", [32, 64, 256, 1024])
def test_sun_is_found_in_maps_of_every_size(sky, height):
    disc = sd.SunDisc.of(sky)
    environment = sd.render(sky + disc, height=height)
    calm, sources = without_sources(environment)
    assert len(sources) == 1
    assert sources[0].illuminance(environment.space) == pytest.approx(
        float(disc.illuminance(SUN)), rel=0.01 if height < 64 else 2e-3
    )
    assert sd.angle_between(sources[0].direction, SUN) < np.pi / height
    assert calm.luminance().max() < 1e5
    # nothing is lost: what the calm map lacks, the source has
    angles = environment.projection.solid_angles(height)
    lack = np.einsum("ij,ijc->c", np.broadcast_to(angles, calm.pixels.shape[:2]), environment.pixels - calm.pixels)
    np.testing.assert_allclose(lack, sources[0].light, rtol=1e-4)


@pytest.mark.parametrize("elevation", [0.1, 1.0, 2.5, 6.0])
def test_setting_suns_are_found_whole(elevation):
    # redder than sRGB: the blue of the light is negative
    sky = sd.HosekWilkie(sd.direction(290 * deg, elevation * deg), 4.0)
    environment = sd.render(sky + sd.SunDisc.of(sky), height=512)
    calm, sources = without_sources(environment)
    assert len(sources) == 1
    angles = np.broadcast_to(environment.projection.solid_angles(512), calm.pixels.shape[:2])
    gone = np.sum(angles * (environment.luminance() - calm.luminance()))
    assert sources[0].illuminance(environment.space) == pytest.approx(gone, rel=1e-3)
    seen = Eye(60).look(environment, Camera(290 * deg, 5 * deg, 20 * deg, 128))
    assert seen.plain.max() > 100 * np.median(seen.plain)


def test_a_map_without_sun_is_left_alone(sky):
    environment = sd.render(sky, height=128)
    calm, sources = without_sources(environment)
    assert sources == []
    assert calm is environment


def test_two_suns_are_two_sources(sky):
    other = sd.SunDisc(sd.direction(90 * deg, 40 * deg), direct_normal_illuminance=20_000.0)
    _, sources = without_sources(sd.render(sky + sd.SunDisc.of(sky) + other, height=256))
    assert len(sources) == 2
    assert sources[1].illuminance(sd.SRGB) == pytest.approx(20_000, rel=2e-2)


def test_without_sun_no_visible_change(sky):
    environment = sd.render(sky, height=256)
    seen = Eye(60, "blue").look(environment, Camera(180 * deg, 35 * deg, 40 * deg, 256))
    assert np.max(np.abs(seen.eye / seen.plain - 1)) < 0.02  # below a step of 8 bit sRGB at middle grey


def test_an_even_view_stays_even():
    even = sd.EnvironmentMap(np.full((32, 64, 3), 500.0))
    seen = Eye(80).look(even, Camera(0.0, 0.0, 90 * deg, 128))
    np.testing.assert_allclose(seen.eye, 500, rtol=1e-4)


def test_light_of_a_view_is_kept():
    # a bright bar (no sun: it is wide) in the middle of a dark view spreads, and its light stays
    pixels = np.full((256, 512, 3), 10.0)
    pixels[118:138, 246:266] = 200.0
    view = Camera(180 * deg, 0.0, 60 * deg, 256)
    seen = Eye(35).look(sd.EnvironmentMap(pixels), view, sources=[])
    before, after = (np.sum(picture[..., 1] * view.solid_angles()) for picture in (seen.plain, seen.eye))
    assert after == pytest.approx(before, rel=0.01)
    assert seen.eye[128, 60, 1] > seen.plain[128, 60, 1] * 1.02


def test_light_of_a_sphere_is_kept(sunny):
    scattered = Eye(60, "blue").on_sphere(sunny)
    angles = sunny.projection.solid_angles(512)
    before, after = (np.sum(angles * environment.luminance()) for environment in (sunny, scattered))
    assert after == pytest.approx(before, rel=2e-3)
    assert scattered.pixels.min() > -1e-3 * sunny.luminance().mean()


def test_scattering_on_the_sphere_is_the_same_in_every_direction(sky):
    # a map turned about the vertical, then scattered, is the map scattered, then turned
    environment = sd.render(sky + sd.SunDisc.of(sky), height=128)
    eye = Eye(60, needles=None)
    turned = eye.on_sphere(environment.rotated(np.pi / 2)).luminance()
    np.testing.assert_allclose(turned, eye.on_sphere(environment).luminance(), rtol=1e-4)


def test_sphere_and_view_agree(sunny):
    eye = Eye(60, "brown", pupil=2.2, needles=None)
    view = Camera(180 * deg, 40 * deg, 50 * deg, 128)
    there = view.seen(eye.on_sphere(sunny))[..., 1]
    seen = eye.look(sunny, view).eye[..., 1]
    far = np.arccos(view.directions() @ SUN) > 5 * deg
    far &= view.directions()[..., 2] > np.sin(
        18 * deg
    )  # away from the edge of the ground, which the two see differently
    np.testing.assert_allclose(seen[far], there[far], rtol=0.03)


def test_needles_keep_the_light_of_every_ring():
    needles = Needles(seed=3)
    np.testing.assert_allclose(needles.table.mean(axis=1), 1, rtol=5e-3)
    turn = np.linspace(-np.pi, np.pi, 8192, endpoint=False, dtype=np.float32)
    ring = needles.factor(np.full_like(turn, 4 * deg), turn)
    np.testing.assert_allclose(ring.mean(axis=0), 1, rtol=5e-3)
    assert 0.3 < ring[:, 1].std() < 0.45  # seen as needles
    sun = Needles(seed=3, radius=0.2666 * deg).factor(np.full_like(turn, 4 * deg), turn)
    assert 0.1 < sun[:, 1].std() < 0.2  # the sun washes most of them out
    assert np.array_equal(needles.table, Needles(seed=3).table)
    assert not np.array_equal(needles.table, Needles(seed=4).table)


def test_halo_is_a_rainbow_red_outside():
    angle = np.linspace(1.5, 4.5, 601) * deg
    rings = angle[np.argmax(halo_colours(angle), axis=0)] / deg
    assert rings[2] < rings[1] < rings[0]
    assert rings[2] > 2.2
    assert rings[0] < 3.6


def test_halo_grows_with_the_pupil():
    assert halo_share(1.9) == 0
    assert halo_share(4.9) == 0.033
    bright, dim = (Eye().glow(RADIUS, luminance, sd.SRGB) for luminance in (10_000.0, 10.0))
    at = 3 * deg
    assert np.interp(at, dim.angle, dim.value[:, 1]) > 2 * np.interp(at, bright.angle, bright.value[:, 1])


def test_plain_discs_have_their_light(sunny):
    frame = HalfSphere(180 * deg, 10 * deg, 400)
    picture = plainly_seen(sunny, frame) @ sunny.space.to_xyz[1]
    light = np.sum(picture * frame.solid_angles() * np.maximum(frame.directions() @ frame.forward, 0))
    assert light == pytest.approx(float(sunny.illuminance(frame.forward)), rel=5e-3)


def test_bare_disc_has_no_glow():
    assert Glow.plain(RADIUS).is_bare
    assert not Eye().glow(RADIUS, 100.0, sd.SRGB).is_bare


@pytest.mark.parametrize(
    ("choices", "message"),
    [
        ({"age": 101.0}, r"age must lie in \[5, 100\] years, got 101"),
        ({"age": float("nan")}, "age must lie in"),
        ({"iris": "red"}, "iris must be one of black, brown, green, blue, got 'red'"),
        ({"pupil": 12.0}, r"pupil must lie in \[1, 9\] mm"),
        ({"iris": "blue", "spread": PHOTOPIC}, "an iris or a spread, not both, got 'blue' and Spencer"),
    ],
)
def test_eyes_that_there_are_not(choices, message):
    with pytest.raises(ValueError, match=message):
        Eye(**choices)
