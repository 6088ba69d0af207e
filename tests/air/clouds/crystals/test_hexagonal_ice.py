"""Hexagonal prisms of ice: rays by closed forms and published figures, and the halos of their phase function."""

import numpy as np
import pytest

import skydome as sd
from skydome.air.clouds.crystals.diffraction import pattern, spread
from skydome.air.clouds.crystals.fresnel import split, sunlight
from skydome.air.clouds.crystals.halos import least_deviation
from skydome.air.clouds.crystals.mixture import ice
from skydome.air.clouds.crystals.prism import Prism
from skydome.air.clouds.crystals.tracing import BINS, turned
from skydome.air.series.legendre import legendre

PURE = sd.HexagonalIce(aspect=2.0, smooth=1.0)


@pytest.mark.parametrize(("aspect", "published"), [(0.2, 0.8742), (1.0, 0.7792), (2.0, 0.8154), (5.0, 0.8616)])
def test_traced_prisms_have_the_published_asymmetry(aspect: float, published: float) -> None:
    """Van Diedenhoven et al. 2014, J. Atmos. Sci. 71, 1763: fits to rays through plane-faced prisms at 862 nm."""
    found = turned(Prism(aspect), 1.3038, np.array([0.0]), rays=20_000)
    assert (1 + found.mean_cosine[0]) / 2 == pytest.approx(published, abs=0.005)
    assert found.area == pytest.approx(Prism(aspect).surface / 4, rel=1e-3)
    assert found.angles.sum() + found.straight[0] == pytest.approx(1.0, abs=1e-12)


def test_traced_prisms_absorb_as_published_and_rough_ones_too() -> None:
    """Van Diedenhoven et al. 2014, their first fit: albedo 1 - .4576 (1 - exp(-20.97 chi)), chi = a / (3 pi) here."""
    absorption = np.array([0.01, 0.1, 0.5, 2.0])
    known = 0.457593 * -np.expm1(-20.9738 * absorption / (3 * np.pi))
    for roughness in (0.0, 0.2):
        found = turned(Prism(1.0), 1.3038, absorption, roughness, rays=10_000)
        np.testing.assert_allclose(found.absorbed / 2, known, atol=0.012)


def test_light_is_turned_least_at_the_halos() -> None:
    found = turned(Prism(1.0), 1.31, np.array([0.0]), rays=40_000).angles[0]
    edges = np.cos(np.linspace(0, np.pi, BINS + 1))

    def mean(low: float, high: float) -> float:
        part = slice(*(np.array([low, high]) * BINS / 180).astype(int))
        return float(found[part].sum() / -np.diff(edges)[part].sum())

    for wedge in (60.0, 90.0):
        halo = least_deviation(1.31, wedge)
        assert mean(halo, halo + 0.5) > 2 * mean(halo - 1.0, halo - 0.1)


def test_a_sphere_of_the_same_surfaces_has_the_rainbow_and_loses_no_light() -> None:
    """Descartes' angle: least deviation of rays mirrored once within, at cos^2 i = (n^2 - 1) / 3."""
    n, b = 1.333, np.sqrt((np.arange(4000) + 0.5) / 4000)
    inward = np.stack([-b, np.zeros_like(b), np.sqrt(1 - b * b)], axis=1)
    sun = sunlight(np.broadcast_to([0.0, 0.0, 1.0], inward.shape))
    place, told, total = -inward, [], 0.0
    left, rays = split(sun, inward, n)
    for _ in range(9):
        total += left.power.mean()
        told.append(np.degrees(np.arccos(np.clip(left.toward[:, 2], -1, 1))))
        far = 2 * -np.einsum("nk,nk->n", place, rays.toward)
        place = place + far[:, None] * rays.toward
        place /= np.linalg.norm(place, axis=1, keepdims=True)
        rays, left = split(rays, place, 1 / n)
    i = np.arccos(np.sqrt((n * n - 1) / 3))
    assert total == pytest.approx(1.0, abs=2e-3)
    assert told[2].min() == pytest.approx(180 + np.degrees(2 * i - 4 * np.arcsin(np.sin(i) / n)), abs=0.01)


def test_the_phase_function_has_a_halo_red_within_that_small_crystals_blur() -> None:
    degrees = np.linspace(17.0, 27.0, 401)
    w = [450.0, 650.0]
    large, small = (PURE.phase_law(r).value(np.cos(np.radians(degrees)), w) for r in (150e-6, 20e-6))
    steep = degrees[np.diff(large, axis=0).argmax(axis=0)]
    np.testing.assert_allclose(steep, [least_deviation(float(n), 60.0) for n in ice(1e-4, np.array(w))[0]], atol=0.2)
    assert steep[1] < steep[0] - 0.3
    np.testing.assert_array_less(8 * large[80], large.max(axis=0))
    np.testing.assert_array_less(small.max(axis=0), 0.8 * large.max(axis=0))
    mixed = sd.HexagonalIce().phase_law(30e-6).value(np.cos(np.radians([20.0, 22.5])), [550.0])[:, 0]
    assert 1.1 < mixed[1] / mixed[0] < 1.8


def test_diffraction_is_whole_and_its_moments_are_a_moved_disc() -> None:
    t = (np.arange(20_000) + 0.5) / 20_000
    size = np.array([150.0, 400.0])
    seen = pattern(size, 180 * t) * (2 * np.pi**2 / t.size * np.sin(np.pi * t))[:, None]
    moments = legendre(60, np.cos(np.pi * t)) @ seen
    np.testing.assert_allclose(moments, spread(size, 60), atol=0.004)


def test_layers_absorb_as_ebert_and_curry_have_it_and_differ_little_by_the_mixture() -> None:
    w = np.arange(300.0, 2500.0, 20.0)
    mine, theirs = sd.HexagonalIce().optics(20e-6, w), sd.Ice().optics(20e-6, [475.0, 1000.0, 1600.0, 2200.0])
    for k, (low, high) in enumerate(((300, 700), (700, 1300), (1300, 1900), (1900, 2500))):
        band = (w >= low) & (w < high)
        assert np.mean(1 - mine.albedo[band]) == pytest.approx(1 - theirs.albedo[k], rel=0.6, abs=2e-5)
        assert np.mean(mine.asymmetry[band]) == pytest.approx(theirs.asymmetry[k], abs=0.03)


def test_a_layer_shows_the_halo_and_the_overcast_sky_refuses_it_in_one_line() -> None:
    sun = sd.direction(azimuth=180 * sd.deg, elevation=45 * sd.deg)
    cloud = sd.Cloud(0.5, base=9000.0, thickness=1000.0, effective_radius=60e-6, kind=PURE)
    clear = sd.Atmosphere((sd.Molecules(), sd.Ozone(330.0)), albedo=0.2)
    air = sd.Atmosphere((*clear.constituents, cloud), albedo=0.2)
    views = sd.direction(azimuth=180 * sd.deg, elevation=np.array([45.0 + 19.5, 45.0 + 22.5]) * sd.deg)
    dark, bright = sd.DiscreteOrdinates(sun, air).radiance(views, [550.0])[:, 0]
    assert bright > 1.5 * dark
    with pytest.raises(ValueError, match=r"was taught Water\(\) and Ice\(\), got HexagonalIce"):
        sd.OvercastSky(sun, 5.0, kind=sd.HexagonalIce())
