"""Clouds in the air: published figures of droplets, phase functions that are whole, and layers that solvers see."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import skydome as sd
from skydome.air.clouds.cloud import Cloud
from skydome.air.clouds.particles import Ice, Water
from skydome.air.phase_laws import PhaseLaw
from skydome.ground.quadrature import gauss_legendre
from skydome.skies.physical.layers import layered


def test_droplets_have_the_published_asymmetry_and_absorb_in_the_near_infrared() -> None:
    # Hu and Stamnes 1993, J. Climate 6, 728, their figures for r = 10 um: g 0.86, nothing absorbed in the visible
    seen = Water().optics(10e-6, [550.0, 1650.0, 2200.0])
    assert seen.asymmetry[0] == pytest.approx(0.862, abs=0.003)
    assert seen.albedo[0] > 0.99999
    assert 0.98 < seen.albedo[1] < 0.997
    assert 0.96 < seen.albedo[2] < 0.99


@pytest.mark.parametrize("law", [Water().phase_law(6e-6), Water().phase_law(11e-6), Ice().phase_law(40e-6)])
def test_a_phase_function_is_whole_and_has_its_own_mean_cosine(law: PhaseLaw) -> None:
    w = [320.0, 450.0, 550.0, 700.0, 1650.0]
    t, share = gauss_legendre(4000)
    cosine, weight = np.cos(np.pi * t), 2 * np.pi * np.pi * share * np.sin(np.pi * t)
    values = law.value(cosine, w)
    np.testing.assert_allclose(weight @ values, 1.0, atol=1e-5)
    np.testing.assert_allclose((weight * cosine) @ values, law.mean_cosine(w), atol=0.002)
    np.testing.assert_allclose(law.moments(40, w)[1], (weight * cosine) @ values, atol=1e-4)


def test_a_bow_of_droplets_stands_where_fogbows_are_seen_and_a_smaller_droplet_has_a_wider_corona() -> None:
    degrees = np.linspace(130.0, 160.0, 301)
    bow = degrees[np.argmax(Water().phase_law(10e-6).value(np.cos(np.radians(degrees)), [650.0])[:, 0])]
    assert 138.0 < bow < 144.0  # below the rainbow's 138 degrees for large drops, by interference
    half = [float(law.value(np.cos(np.radians([1.0])), [550.0])[0, 0]) for law in map(Water().phase_law, (5e-6, 20e-6))]
    peak = [float(law.value(np.array([1.0]), [550.0])[0, 0]) for law in map(Water().phase_law, (5e-6, 20e-6))]
    assert peak[1] > 10 * peak[0]
    assert half[1] / peak[1] < half[0] / peak[0]


def test_a_layer_is_cut_out_of_the_air_and_a_deep_one_dims_it() -> None:
    clear, sun = sd.Atmosphere.standard(), sd.direction(0.0, 0.8)
    layers = layered(with_cloud(clear, Cloud(20.0, 1200.0, 300.0)), np.array([550.0]), 16)
    assert {1200.0, 1500.0} <= set(layers.heights.tolist())
    inside = (layers.heights[1:] >= 1200.0) & (layers.heights[:-1] <= 1500.0)
    assert layers.depth[inside].sum() == pytest.approx(20.0, rel=1e-3)
    under = [sd.illuminance(sd.DiscreteOrdinates(sun, with_cloud(clear, Cloud(d)))) for d in (10.0, 40.0)]
    assert under[0] > 1.8 * under[1] > 10_000


def test_light_goes_to_and_fro_between_a_cloud_and_the_ground() -> None:
    """E(A) = E(0) / (1 - A R), R what the cloud mirrors down: of two grounds follows the third."""
    sun = sd.direction(0.0, np.radians(50.0))

    def down(albedo: float) -> float:
        air = sd.Atmosphere((Cloud(16.0),), albedo=albedo)
        beam = air.sun_at([550.0]) * sun[2] * air.transmittance(sun[2], [550.0])
        return float((sd.irradiance(sd.DiscreteOrdinates(sun, air, streams=32), [550.0]) + beam)[0])

    black, half, white = (down(albedo) for albedo in (0.0, 0.5, 1.0))
    mirror = 1 - black / white
    assert half == pytest.approx(black / (1 - 0.5 * mirror), rel=2e-3)
    assert 0.5 < mirror < 0.75


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"optical_depth": -1.0}, "optical_depth must lie in"),
        ({"base": -100.0}, "base must lie in"),
        ({"thickness": 0.0}, "thickness must lie in"),
        ({"effective_radius": 60e-6}, r"effective_radius must lie in \[4e-06, 2.5e-05\] m, got 6e-05"),
        ({"kind": "ice"}, "kind must be"),
    ],
)
def test_impossible_clouds_are_refused_in_one_line(wrong: dict[str, Any], message: str) -> None:
    with pytest.raises((ValueError, TypeError), match=message):
        Cloud(**wrong)


def with_cloud(air: sd.Atmosphere, cloud: Cloud) -> sd.Atmosphere:
    return replace(air, constituents=(*air.constituents, cloud))
