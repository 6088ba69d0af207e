"""Klassen's flat layers: against plain sums that share no code with them, and against round air that they tend to."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg

AIR = sd.Atmosphere.standard(aerosol_depth=0.1)
W = np.array([450.0, 650.0])
VIEWS = sd.direction(np.array([0.0, 60.0, 170.0, 180.0]) * deg, np.array([80.0, 50.0, 20.0, 8.0]) * deg)


def plain(air, tops, sun, views):
    """Trapezoids through layers of one density each, (D, W), for a sun of irradiance 1."""
    edges = np.array([0.0, *tops, air.height])
    total = np.zeros((len(views), W.size))
    parts = [
        (p, -np.diff(p.profile.above(edges) * [*np.ones(edges.size - 1), 0]) / np.diff(edges)) for p in air.constituents
    ]
    for low, high, k in zip(edges, edges[1:], range(edges.size - 1), strict=False):
        h = np.linspace(low, high, 4001)
        here = sum(p.depth(W) * density[k] for p, density in parts)
        below = sum(
            sum(p.depth(W) * density[i] for p, density in parts) * (edges[i + 1] - edges[i]) for i in range(k)
        ) + here * (h[:, None] - low)
        whole = sum(p.depth(W) * (density @ np.diff(edges)) for p, density in parts)
        for d, view in enumerate(views):
            source = sum(
                p.depth(W) * density[k] * p.scattered(W) * p.phase_law.value(np.array(view @ sun), W)
                for p, density in parts
            )
            lit = np.exp(-(whole - below) / sun[2] - below / view[2])
            total[d] += np.trapezoid(lit * source, h, axis=0) / view[2]
    return total


@pytest.mark.parametrize("tops", [(2000.0,), (500.0, 3000.0, 12_000.0)])
def test_layers_against_plain_sums(tops):
    for elevation in (60.0, 8.0):
        sun = sd.direction(180 * deg, elevation * deg)
        own = sd.Klassen87(sun, AIR, tops=tops).radiance(VIEWS, W) / AIR.sun_at(W)
        np.testing.assert_allclose(own, plain(AIR, tops, sun, VIEWS), rtol=2e-3)


def test_many_layers_tend_to_round_air_under_a_high_sun():
    sun = sd.direction(180 * deg, 60 * deg)
    tops = tuple(np.geomspace(50.0, 90_000.0, 60))
    fine, round_air = sd.Klassen87(sun, AIR, tops=tops), sd.Nishita93(sun, AIR)
    np.testing.assert_allclose(fine.radiance(VIEWS[:3], W), round_air.radiance(VIEWS[:3], W), rtol=0.01)
    two = sd.Klassen87(sun, AIR)
    np.testing.assert_allclose(two.radiance(VIEWS[:3], W), fine.radiance(VIEWS[:3], W), rtol=0.02)


def test_layers_must_lie_in_the_air():
    with pytest.raises(ValueError, match="tops must increase between 0 and the air's height, 100000 m"):
        sd.Klassen87(sd.SOUTH, AIR, tops=(3000.0, 2000.0))
