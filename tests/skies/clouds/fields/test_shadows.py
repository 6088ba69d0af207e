"""What a field lets through of the sun: under low suns too, and what is no place, sun or size."""

import numpy as np
import pytest

import skydome as sd
from skydome.skies.clouds.fields.kinds import Slab
from skydome.skies.clouds.fields.shadows import sun_share

pytest.importorskip("numba")
HEAPS = sd.CloudField(sd.Cumulus(), cover=0.4, seed=7)
HERE = np.zeros((1, 3))


@pytest.mark.parametrize("elevation", [0.05, 0.2, 0.28, 0.3])
def test_a_whole_cover_hides_the_lowest_sun(elevation):
    cover = sd.CloudField(sd.Stratocumulus(), cover=1.0)
    sun = sd.direction(azimuth=200 * sd.deg, elevation=elevation * sd.deg)
    assert sun_share(cover, sun, HERE)[0] < 1e-9
    assert sun_share(sd.CloudField(cover=0.0), sun, HERE)[0] == 1.0
    assert sun_share(cover, sun * [1, 1, -1], HERE)[0] == 0.0


@pytest.mark.parametrize(("extinction", "depth"), [(0.059, 59.0), (0.0601, 60.0), (0.6, 60.0)])
def test_a_ray_that_is_dark_is_followed_no_further(extinction, depth):
    slab = sd.CloudField(Slab(), cover=1.0, extinction=extinction)
    assert -np.log(sun_share(slab, sd.ZENITH, HERE, points=1)[0]) == pytest.approx(depth, abs=1e-3)


def test_shadows_drift_with_the_wind_and_repeat():
    field = sd.CloudField(sd.Cumulus(), cover=0.5, seed=3, wind=(13.0, -7.0))
    sun = sd.direction(azimuth=200 * sd.deg, elevation=40 * sd.deg)
    places = np.append(np.random.default_rng(1).uniform(-5e3, 5e3, (200, 2)), np.zeros((200, 1)), axis=1)
    now = sun_share(field, sun, places)
    moved = places + np.array([3900.0, -2100.0, 0.0])
    np.testing.assert_allclose(sun_share(field.later(300.0), sun, moved), now, atol=1e-9)
    np.testing.assert_allclose(sun_share(field, sun, places + np.array([16e3, -32e3, 0.0])), now, atol=1e-9)
    assert 0.1 < now.mean() < 0.9


def test_the_greatest_seed_means_a_field():
    greatest = sd.CloudField(sd.Stratocumulus(), cover=0.5, seed=2**63 - 1)
    places = np.append(np.random.default_rng(1).uniform(0, 16e3, (300, 2)), np.zeros((300, 1)), axis=1)
    assert 0.3 < sun_share(greatest, sd.ZENITH, places).mean() < 0.9


@pytest.mark.parametrize(
    ("asked", "told"),
    [
        (lambda: sd.ShadowMap.of(HEAPS, np.tile([0.0, 0.6, 0.8], (2, 1))), r"sun must be one direction"),
        (lambda: sd.ShadowMap.of(HEAPS, [0.0, 0.6, 0.8], count=1.5), "count must be one whole number, got float 1.5"),
        (lambda: HEAPS.later("noon"), "seconds must be a number"),
        (lambda: HEAPS.later(np.arange(3.0)), "seconds must be one number"),
        (lambda: HEAPS.extinction_at([1.0, 2.0]), r"points must have shape \(..., 3\), got \(2,\)"),
        (lambda: HEAPS.extinction_at([0.0, np.nan, 1500.0]), "points must lie in"),
    ],
)
def test_refused(asked, told):
    with pytest.raises((TypeError, ValueError), match=told):
        asked()
