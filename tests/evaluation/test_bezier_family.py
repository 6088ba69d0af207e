"""The family over elevation and turbidity: close to the physical sky, between the suns and airs fitted too."""

import numpy as np
import pytest

import skydome as sd
from skydome.air.cross_sections import rayleigh_depth
from skydome.study.bezier_family import SUNS, bezier_family
from skydome.study.refit import Views

pytest.importorskip("scipy")
pytest.importorskip("nanodisort")
BANDS = np.array([450.0, 650.0])
VIEWS = Views.half(12, 10)


def air(turbidity):
    return sd.Atmosphere.standard((turbidity - 1) * float(rayleigh_depth([550.0])[0]))


@pytest.fixture(scope="module")
def family():
    return bezier_family({2.0: air(2.0), 3.0: air(3.0)}, BANDS)


def away(family, turbidity, elevation):
    sun = sd.direction(np.pi, elevation * sd.deg)
    numbers = family.numbers(turbidity, np.radians([elevation, elevation + 1]))
    light = sd.Refitted(sun, numbers).radiance(VIEWS.directions, BANDS)
    ratio = light / sd.DiscreteOrdinates(sun, air(turbidity)).radiance(VIEWS.directions, BANDS)
    return np.sqrt(VIEWS.solid_angles @ (ratio - 1) ** 2 / VIEWS.solid_angles.sum())


def test_the_family_is_within_four_per_cent_over_all_suns_above_five_degrees(family):
    assert family.control.shape == (2, 2, 10, 6)
    assert family.error.max() < 0.04


def test_suns_and_turbidities_between_those_fitted(family):
    for turbidity in (2.0, 2.5, 3.0):
        assert away(family, turbidity, 14.0).max() < 0.05
        assert away(family, turbidity, 60.0).max() < 0.035


def test_numbers_for_refitted_and_bad_input(family):
    numbers = family.numbers(2.5)
    assert numbers.coefficients.shape == (SUNS.size, 2, 10)
    with pytest.raises(ValueError, match=r"turbidity must lie in \[2, 3\], got 4"):
        family.numbers(4.0)
