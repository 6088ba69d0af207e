"""Max's layered fog: against plain sums along rays, and against the exponential that layers tend to."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg

TOPS, RATES = (50.0, 120.0, 400.0), (0.02, 0.006, 0.001)
SUN = sd.direction(120 * deg, 25 * deg)


def plain(fog, distance, view, height):
    """Trapezoids along a ray: transmittance, ambient and sunlight scattered, for lights of 1."""
    s = np.linspace(0.0, distance, 200_001)
    h = height + s * view[2]
    k = np.select([h < top for top in TOPS], RATES, 0.0)
    depth = np.concatenate([[0.0], np.cumsum((k[1:] + k[:-1]) / 2 * np.diff(s))])
    fine = np.linspace(0.0, TOPS[-1], 40_001)
    rate = np.select([fine < top for top in TOPS], RATES, 0.0)
    column = np.concatenate([[0.0], np.cumsum((rate[1:] + rate[:-1]) / 2 * np.diff(fine))])
    above = (column[-1] - np.interp(h, fine, column)) / SUN[2]
    return np.exp(-depth[-1]), np.trapezoid(k * np.exp(-depth), s), np.trapezoid(k * np.exp(-depth - above), s)


@pytest.mark.parametrize("elevation", [60.0, 10.0, 25.0, 0.0, -5.0])
@pytest.mark.parametrize("height", [10.0, 300.0])
def test_rays_against_plain_sums(elevation, height):
    fog = sd.LayeredFog(TOPS, RATES, (1.0,), SUN, (1.0,))
    view = sd.direction(20 * deg, elevation * deg)
    distance = 800.0 if elevation >= 0 else (height - 1.0) / -view[2]
    tau, ambient, sunlit = plain(fog, distance, view, height)
    found = fog.at(distance, view, height)
    assert float(found.transmittance[0]) == pytest.approx(tau, rel=2e-3)
    assert float(found.inscattered[0]) == pytest.approx(ambient + sunlit, rel=2e-3)


def test_many_layers_tend_to_exponential_haze():
    """Kaneda et al.'s density is the limit: a column of 600 layers against the closed form of the exponential."""
    tops = np.linspace(10.0, 6000.0, 600)
    rates = 1e-4 * np.exp(-(tops - 5.0) / 1200.0)
    fog = sd.LayeredFog(tuple(tops), tuple(rates), (1.0, 1.0))
    for elevation in (80.0, 10.0, 2.0):
        view = sd.direction(0.0, elevation * deg)
        depth = 1e-4 * 1200.0 / view[2] * (1 - np.exp(-5000.0 * view[2] / 1200.0))
        assert float(-np.log(fog.at(5000.0, view).transmittance[0])) == pytest.approx(depth, rel=1e-3)


def test_shapes_and_what_is_refused():
    fog = sd.LayeredFog(TOPS, RATES, (100.0, 200.0, 300.0))
    views = sd.direction(np.zeros(4), np.array([0.1, 0.0, -0.1, 1.0]))
    far = fog.at(np.array([[10.0], [1e4]]), views, height=20.0)
    assert far.transmittance.shape == far.inscattered.shape == (2, 4, 3)
    assert (far.inscattered[1] > far.inscattered[0]).all()
    for choice, message in (
        ({"tops": (5.0, 1.0, 9.0)}, "tops must increase"),
        ({"extinctions": (-1.0, 1.0, 1.0)}, "extinctions must lie in"),
        ({"sun": SUN}, "needs sun and sunlight"),
    ):
        with pytest.raises(ValueError, match=message):
            sd.LayeredFog(**({"tops": TOPS, "extinctions": RATES, "ambient": (1.0,)} | choice))
