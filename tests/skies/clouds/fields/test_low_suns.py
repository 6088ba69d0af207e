"""Suns about the level and below it: a field lit from below, over the round earth, and the sun by the cloud's place."""

import numpy as np
import pytest

import skydome as sd
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.kinds import Slab
from skydome.skies.clouds.fields.lit_field import LitField
from skydome.skies.clouds.fields.low_sun import LOWEST, seen_from, share_of
from skydome.skies.clouds.fields.reference import beam, laws_of, photon_shares, traced_through

pytest.importorskip("numba")
HEAPS = CloudField(sd.Altocumulus(), cover=0.5, seed=3)


def sun_at(elevation):
    """A sun in the south."""
    return sd.direction(azimuth=180 * sd.deg, elevation=elevation * sd.deg)


def slab(depth):
    """A layer of droplets of an optical depth."""
    return CloudField(Slab(sd.Water()), cover=1.0, extinction=depth / 1000.0)


@pytest.mark.parametrize("elevation", [3.0, 20.0])
def test_a_slab_lit_from_below_is_one_lit_from_above_upside_down(elevation):
    above, below = (LitField.of(slab(8.0), sun_at(sign * elevation)) for sign in (1, -1))
    assert below.sunlight[1] == pytest.approx(above.sunlight[1][::-1], rel=2e-3)
    level = np.sin(elevation * sd.deg)
    assert below.budget[0] + sum(below.sunlight[1]) / level == pytest.approx(1.0, abs=0.003)
    up, down, straight, _ = photon_shares(above, 3000)
    up_from_below, down_from_below, straight_from_below, _ = photon_shares(below, 3000)
    assert [down_from_below, up_from_below] == pytest.approx([up, down], abs=0.04)
    assert straight_from_below == pytest.approx(straight, abs=0.02)


def test_thin_cloud_scatters_a_sun_below_once_by_its_true_angle():
    sun, views = sun_at(-5.0), sd.direction(np.array([3.0, 1.0, 0.0]), np.array([0.3, 0.6, 1.2]))
    lit = LitField.of(slab(0.005), sun)
    law = sd.Water().phase_law(1e-5).value(views @ sun, [550.0])[:, 0]
    seen = lit.seen(views)
    sunlight = seen[:, 1] + lit.scattering().once(views @ sun, seen[:, 5:])[:, 0]
    np.testing.assert_allclose(sunlight, 0.005 / views[:, 2] * law, rtol=0.1, atol=2e-4)
    passes = [traced_through(lit, laws_of(lit.scattering()), views, beam(lit, [1.0]), np.zeros((3, 4, 1)), 4000, 0, n)
              for n in range(4)]  # fmt: skip
    np.testing.assert_allclose(np.mean(passes, axis=0)[:, 0], sunlight, rtol=0.25, atol=3e-4)


def test_light_of_the_sun_goes_through_the_level_without_a_step():
    shares = np.array([share_of([0.0, 1.0, sine], 1000.0) for sine in np.linspace(-2 * LOWEST, 2 * LOWEST, 401)])
    assert np.abs(np.diff(shares)).max() < 0.021
    clear = [sd.PhysicalSky(sun_at(elevation)) for elevation in (-0.43, -0.38)]
    thin = CloudField(Slab(sd.Water()), cover=1.0, base=3500.0, thickness=300.0, extinction=0.003)
    below, above = (sd.CloudySky(sky, thin) for sky in clear)
    assert below.lit.sun[2] < 0 < above.lit.sun[2]
    views = sd.direction(np.linspace(0, 6, 24)[:, None], np.array([0.05, 0.2, 0.6, 1.2]))
    ratio = below.luminance(views).mean() / above.luminance(views).mean()
    bare = clear[0].luminance(views).mean() / clear[1].luminance(views).mean()
    assert ratio == pytest.approx(bare, abs=0.03)


def test_the_sun_is_brighter_and_whiter_on_higher_cloud_and_toward_it():
    light = sd.CloudySky(sd.PhysicalSky(sun_at(-0.5)), HEAPS).colours.sunlight
    heights = np.array([0.0, 1000.0, 2000.0, 4000.0, 8000.0])
    there = light.at(heights, np.zeros(5))
    red, blue = np.argmin(np.abs(light.wavelengths - 650)), np.argmin(np.abs(light.wavelengths - 450))
    assert (np.diff(there.sum(axis=-1)) > 0).all()
    assert (np.diff(there[1:, blue] / there[1:, red]) > 0).all()
    away, toward = light.at(np.full(2, 4000.0), np.array([-0.01, 0.01]))
    assert (away < there[3]).all()
    assert (there[3] < toward).all()
    high = sd.PhysicalSky(sun_at(30.0))
    disc = sd.CloudySky(high, HEAPS).colours
    np.testing.assert_allclose(disc.sunlight.over_the_eye(0.0), disc.sun_below, rtol=2e-3)
    assert seen_from(high, 3000.0) == pytest.approx(high.seen_sun, abs=3e-4)


def test_a_sun_below_lights_bases_red_toward_it():
    """Altocumulus, the sun a degree down: what stands toward the sun is redder and brighter than without a beam."""
    sky = sd.CloudySky(sd.PhysicalSky(sun_at(-1.0)), HEAPS)
    light = sky.colours
    seen = sky.lit.seen(sd.direction(np.pi + np.linspace(-0.3, 0.3, 40), 12 * sd.deg))
    once = light.scattering.once(np.full(40, np.cos(13 * sd.deg)), seen[:, 5:]) * (light.sun @ light.channels.weights)
    x, y, z = once.mean(axis=0)
    assert y > 10.0
    assert x > y > 5 * z


@pytest.mark.parametrize("elevation", [40.0, -10.0])
def test_rays_to_the_sun_are_let_through_as_by_the_field(elevation):
    from skydome.skies.clouds.fields.air.sunlight_kernel import reaches

    sun, lit = sun_at(elevation), LitField.of(HEAPS, sun_at(elevation))
    m, keys = lit.field.medium, np.random.default_rng(1).integers(1, 1 << 62, 3000, dtype=np.uint64)
    for x, y in ((0.0, 0.0), (700.0, 900.0), (3000.0, 5200.0)):
        z = 0.5 * m.thickness
        left = [reaches(m, lit.gaps, lit.steps[0], x, y, z, sun, key) for key in keys]
        s = np.arange(0.5, (m.thickness - z if sun[2] > 0 else z) / abs(sun[2]), 1.0)
        places = np.array([x - m.east, y - m.north, z + m.base]) + s[:, None] * sun
        known = np.exp(-lit.field.extinction_at(places).sum())
        assert np.mean(left) == pytest.approx(known, abs=4 * np.std(left) / np.sqrt(len(left)) + 2e-3)


def test_the_sun_s_light_by_place_is_between_its_nodes():
    from skydome.skies.clouds.fields.air.sunlight_kernel import FARTHEST, light_at, place_of

    m, sun, table = HEAPS.medium, sun_at(-0.5), np.random.default_rng(2).uniform(0, 1, (3, 9, 2))
    for high, along in ((0.0, -1.0), (0.3, 0.13), (1.0, 1.0)):
        there = np.array([m.east, m.north, high * m.thickness])
        there[:2] += along * FARTHEST * sun[:2] / np.hypot(*sun[:2])
        row, column = place_of(m, there, sun, table)
        columns = np.array([np.interp((along + 1) * 4, np.arange(9), line) for line in table[:, :, 1]])
        assert light_at(table, row, column, 1) == pytest.approx(np.interp(high * 2, np.arange(3), columns), rel=1e-9)
