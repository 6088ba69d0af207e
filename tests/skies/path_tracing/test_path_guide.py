"""What leads paths in twilight: it changes the noise and never the mean, down to suns 12 degrees below the horizon."""

import numpy as np
import pytest

import skydome as sd
from skydome.air.atmosphere import Atmosphere
from skydome.ground.quadrature import hemisphere
from skydome.skies.path_tracing.guide import guide_for
from skydome.skies.path_tracing.sky import PathTraced
from skydome.skies.path_tracing.tables import shells
from skydome.skies.physical.nishita import Nishita93

pytest.importorskip("numba")
W = np.array([400.0, 550.0, 700.0])
AIR = Atmosphere.standard(aerosol_depth=0.1)
VIEWS = np.concatenate([hemisphere(4, 6)[0], sd.direction(np.radians([180.0, 0, 180]), np.radians([2.0, 4, 90]))])


def sun_at(elevation):
    return sd.direction(np.pi, elevation * sd.deg)


def traced(elevation, guide, seed, passes=32, each=24, air=AIR, **choices):
    sky = PathTraced(sun_at(elevation), air, guide=guide, seed=seed, paths_per_pass=each, **choices)
    return sky.job(VIEWS, W).start().more(passes)


def differences(one, other):
    return ((one.radiance - other.radiance) / np.hypot(one.standard_error, other.standard_error)).ravel()


def check(away):
    """No more than chance: 4 standard errors at most, their mean square near 1 (a path has all wavelengths)."""
    assert np.abs(away).max() < 4
    assert 0.55 < (away**2).mean() < 1.6


@pytest.mark.parametrize(("elevation", "choices"), [(20.0, {"exact_first": False}), (6.0, {"orders": 3})])
def test_guided_or_not_the_mean_is_the_same(elevation, choices):
    """By day: in twilight the paths without a guide seldom find the light, and their scatter does not tell so."""
    snow = Atmosphere.standard(aerosol_depth=0.1, albedo=0.6)
    check(differences(*(traced(elevation, g, int(10 * g), air=snow, **choices) for g in (0.8, 0.0))))


@pytest.mark.parametrize("elevation", [-4.0, -8.0])
def test_two_guides_agree_in_twilight(elevation, monkeypatch):
    one = traced(elevation, 0.8, 1)
    import skydome.skies.path_tracing.guide as room

    for name, value in {"HEIGHTS": 16, "SUNS": 33, "ROWS": 20, "TURNS": 5, "CELLS": 11, "ORDERS": 3}.items():
        monkeypatch.setattr(room, name, value)
    other = traced(elevation, 0.5, 2)
    check(differences(one, other))
    assert np.median(one.standard_error / one.radiance) < 0.05


def test_the_guide_is_worth_its_while():
    guided, plain = (traced(-4.0, g, 3, 24) for g in (0.8, 0.0))
    assert np.median(guided.standard_error / plain.standard_error) < 0.5


def test_deep_twilight_falls_as_it_should_and_has_no_dark_holes():
    """A factor of 10 in about 2.5 degrees at the zenith; the sun's side stays the brighter; one scattering is less."""
    light = []
    for elevation in (-4.0, -6.0, -8.0, -10.0, -12.0):
        found = traced(elevation, None, 5, 16)
        assert (found.radiance > 0).all()
        assert np.median(found.standard_error / found.radiance) < 0.2
        single = Nishita93(sun_at(elevation), AIR).radiance(VIEWS, W)
        assert (found.radiance > 0.98 * single).all()
        assert found.radiance[-3, 2] > 3 * found.radiance[-2, 2]
        light.append(found.radiance[-1, 1])
    step = 10 ** -np.mean(np.diff(np.log10(light)))  # in 2 degrees
    assert (np.diff(light) < 0).all()
    assert 4 < step < 12
    assert light[-1] < 1e-3 * light[0]


def test_the_guides_directions_are_a_distribution():
    guide = guide_for(shells(AIR, W), -0.1, 0.8)
    assert np.isfinite(guide.source).all()
    np.testing.assert_allclose(guide.rows[..., -1], 1, rtol=1e-12)
    np.testing.assert_allclose(guide.turns[..., -1], 1, rtol=1e-12)
    assert (np.diff(guide.rows, axis=-1) >= 0).all()
    assert (np.diff(guide.turns, axis=-1) >= 0).all()


def test_directions_sampled_have_the_pdf_stated():
    """The mean of 1 / density over what is drawn is the solid angle where light comes from; of cos, its integral."""
    from skydome.skies.path_tracing.guide_kernel import direction_pdf, frame, sample_direction

    guide = guide_for(shells(AIR, W), -0.1, 0.8)
    node, axes, d = (3, 20), np.zeros((3, 3)), np.zeros(3)
    x = np.array([0.3, -0.2, 0.9]) / np.linalg.norm([0.3, -0.2, 0.9])
    sun = np.array(sun_at(-6.0))
    frame(x, 1.0, sun, float(x @ sun), axes)
    np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-12)
    numbers = np.random.default_rng(1).random((20_000, 2))
    inverse, level = [], []
    for u, v in numbers:
        sample_direction(u, v, node, guide, axes, d)
        assert np.linalg.norm(d) == pytest.approx(1, rel=1e-12)
        inverse.append(1 / direction_pdf(d, node, guide, axes))
        level.append((d @ x) ** 2)
    inverse = np.array(inverse)
    assert inverse.mean() == pytest.approx(4 * np.pi, abs=4 * inverse.std() / 141)
    square = inverse * np.array(level)
    assert square.mean() == pytest.approx(4 * np.pi / 3, abs=4 * square.std() / 141)


def test_distances_sampled_have_the_pdf_stated():
    from skydome.skies.path_tracing.flight_kernel import segment_of
    from skydome.skies.path_tracing.guide_kernel import cell_pdf, sample_cell, tabulate_cells

    air = shells(AIR, W)
    guide = guide_for(air, -0.1, 0.8)
    for r, cosine in ((air.radius, 0.3), (air.radius + 2e4, -0.03), (air.radius + 2e4, -0.5)):
        segment = segment_of(r, cosine, air)
        edges, cdf, scratch = np.zeros(17), np.zeros(18), np.zeros((4, 4))
        total = tabulate_cells(
            r, cosine, segment, -0.05, 0.9, air, guide, guide.source, np.ones(4), scratch, edges, cdf
        )
        assert total == pytest.approx(scratch[3].sum(), rel=1e-9)
        assert (np.diff(edges) > 0).all()
        assert edges[-1] == pytest.approx(segment[1], rel=1e-6)
        ground = cell_pdf(-1.0, edges, cdf)
        inner = (edges[1:] + edges[:-1]) / 2
        density = np.array([cell_pdf(t, edges, cdf) for t in inner])
        assert density @ np.diff(edges) + ground == pytest.approx(1, rel=1e-9)
        drawn = np.array([sample_cell(u, edges, cdf) for u in (np.arange(4000) + 0.5) / 4000])
        assert (drawn < 0).mean() == pytest.approx(ground, abs=1e-3)
        counts = np.histogram(drawn[drawn >= 0], edges)[0] / 4000
        np.testing.assert_allclose(counts, density * np.diff(edges), atol=1e-3)


def test_the_parts_in_vectors_are_the_functions_they_stand_for():
    special = pytest.importorskip("scipy.special")
    from skydome.ground.elementary_kernel import exponential_double
    from skydome.skies.path_tracing.air_kernel import scaled_erfc

    x = np.concatenate([-np.linspace(0, 600, 2001), [1e-12, -1e-9, 3.0]])
    np.testing.assert_allclose([exponential_double(v) for v in x], np.exp(x), rtol=3e-10)
    assert exponential_double(-1e6) < 1e-300
    z = np.concatenate([np.linspace(0, 40, 2001), [1e3, 1e6]])
    np.testing.assert_allclose([scaled_erfc(v) for v in z], special.erfcx(z), rtol=1e-8)
