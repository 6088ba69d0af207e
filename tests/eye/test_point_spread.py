"""How the eye spreads light: published values, integrals, and how the formulas compare."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from skydome import deg
from skydome.eye import point_spread as spreads
from skydome.eye.point_spread import MESOPIC, PHOTOPIC, SCOTOPIC, CIETotal, Spencer, StilesHolladay
from skydome.ground.arrays import as_numpy

EVERY = [
    *(PHOTOPIC, MESOPIC, SCOTOPIC, StilesHolladay(25.0), StilesHolladay(90.0)),
    *(CIETotal(age, p) for age in (5, 35, 60, 100) for p in (0.0, 0.5, 1.2)),
]


def integral(function, first=1e-7, last=np.pi / 2):
    """Over the half sphere, by adaptive quadrature in the logarithm of the angle."""

    def ring(log_angle):
        angle = np.exp(log_angle)
        return float(function(angle)) * 2 * np.pi * np.sin(angle) * angle

    edges = np.log(np.concatenate([np.geomspace(first, last, 40), [2.5 * deg, 3 * deg, 3.5 * deg]]))
    edges = np.sort(edges[edges <= np.log(last) + 1e-12])
    return sum(quad(ring, a, b, epsrel=1e-9)[0] for a, b in pairwise(edges))


@pytest.mark.parametrize("spread", EVERY, ids=str)
def test_spread_integrates_to_one(spread):
    assert integral(spread) == pytest.approx(1, abs=1e-3)
    assert spread.within(np.pi / 2) == pytest.approx(1, abs=1e-4)


@pytest.mark.parametrize("spread", EVERY[:6], ids=str)
def test_share_within_an_angle_is_the_integral(spread):
    for angle in (0.01 * deg, 0.1 * deg, 1 * deg, 3 * deg, 20 * deg):
        assert spread.within(angle) == pytest.approx(integral(spread, last=angle), abs=1e-4)


def test_parts_of_spencer_integrate_to_one():
    # Spencer et al. 1995 say that each part integrates to 1 over the half sphere
    for part in (spreads.core, spreads.corona, spreads.bloom, lambda a: spreads.lenticular_halo(a, 568.0)):
        assert integral(part) == pytest.approx(1, abs=0.02)


def test_published_values_by_hand():
    # 1 degree, age 70, pigment 0: 0.92 (9.2e6/47259.3^1.5 + 1.5e5/494.827^1.5) + 2.6 x 400/101
    assert spreads.cie_total(1 * deg, 70.0, 0.0) == pytest.approx(23.65, rel=1e-3)
    # photopic, 10 degrees: 0.478 x 20.91/10.02^3 + 0.138 x 72.37/10.02^2
    assert Spencer().published(10 * deg) == pytest.approx(0.109409, rel=1e-4)
    assert spreads.stiles_holladay(5 * deg, 0.0) == pytest.approx(0.4)


def test_published_cie_integral_at_35_years():
    # CIE 135/1 is published nearly normalised: 1.005 (p = 0) to 1.073 (p = 1.2)
    assert CIETotal(35, 0.0).integral == pytest.approx(1.005, abs=2e-3)
    assert CIETotal(35, 1.2).integral == pytest.approx(1.073, abs=2e-3)


def test_halo_ring_by_wavelength():
    angle = np.linspace(1, 5, 4001) * deg
    for wavelength in (450.0, 568.0, 650.0):
        ring = angle[np.argmax(spreads.lenticular_halo(angle, wavelength))]
        assert ring / deg == pytest.approx(3 * wavelength / 568, abs=2e-3)


def test_older_and_lighter_eyes_scatter_more():
    far = 10 * deg
    ages = [CIETotal(age).within(far) for age in (20, 40, 60, 80)]
    assert np.all(np.diff(ages) < 0)
    irises = [CIETotal(35, p).within(far) for p in sorted(spreads.PIGMENTS.values())]
    assert np.all(np.diff(irises) < 0)


def test_spencer_by_day_meets_stiles_holladay_from_seven_degrees():
    # nearer, the spreads hold more light than 10 / angle^2 (Vos 1984 adds 10 / angle^3): 1.9 times at 1 degree
    angle = np.linspace(7, 30, 47) * deg
    assert np.max(np.abs(PHOTOPIC(angle) / spreads.stiles_holladay(angle) - 1)) < 0.15


@pytest.mark.parametrize("age", [-1.0, 101.0, float("nan")])
def test_ages_that_the_veil_does_not_know(age):
    with pytest.raises(ValueError, match=r"age must lie in \[0, 100\] years, got"):
        StilesHolladay(age)


def test_no_light_from_behind():
    assert CIETotal()(np.array([91.0, 180.0]) * deg).tolist() == [0.0, 0.0]


@pytest.mark.parametrize("library", ["torch", "jax.numpy"])
def test_other_libraries_and_gradients(library):
    xp = pytest.importorskip(library)
    angle = np.array([0.5, 3.0, 20.0]) * deg
    for spread in (PHOTOPIC, CIETotal(60, 1.2), StilesHolladay(60)):
        there = spread(xp.asarray(angle, dtype=xp.float32))
        np.testing.assert_allclose(as_numpy(there), spread(angle), rtol=2e-5)


def test_gradient_with_age_is_the_difference_quotient():
    torch = pytest.importorskip("torch")
    age = torch.tensor(60.0, dtype=torch.float64, requires_grad=True)
    spreads.cie_total(torch.tensor(0.1, dtype=torch.float64), age, 0.5).backward()
    step = (spreads.cie_total(0.1, 60.001, 0.5) - spreads.cie_total(0.1, 59.999, 0.5)) / 0.002
    assert float(age.grad) == pytest.approx(step, rel=1e-6)


@pytest.mark.parametrize(
    ("age", "pigment", "message"), [(4, 0.5, "age .*100.* got 4"), (30, 2, "pigment .*1.2.* got 2")]
)
def test_bad_eyes(age, pigment, message):
    with pytest.raises(ValueError, match=message):
        CIETotal(age, pigment)
