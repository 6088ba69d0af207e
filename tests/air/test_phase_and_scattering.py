"""Phase functions integrate to 1, coefficients follow from them, and the printed slips are slips."""

import numpy as np
import pytest

from skydome.air import phase_functions as phase
from skydome.air.scattering import (
    HAZE_DECAY,
    concentration,
    gas_angular,
    gas_total,
    haze_angular,
    haze_total,
)
from skydome.ground.tables import columns

NODES, WEIGHTS = np.polynomial.legendre.leggauss(4000)


def over_sphere(values):
    return 2 * np.pi * np.tensordot(WEIGHTS, values, axes=(0, 0))


@pytest.mark.parametrize(
    "function",
    [
        phase.rayleigh,
        lambda c: phase.rayleigh(c, 0.035),
        lambda c: phase.henyey_greenstein(c, 0.76),
        lambda c: phase.cornette_shanks(c, 0.76),
        lambda c: phase.haze(c, [380.0, 450.0, 523.0, 700.0, 780.0]),
    ],
)
def test_phase_functions_integrate_to_one(function):
    assert over_sphere(function(NODES)) == pytest.approx(1, abs=1e-6)


def test_haze_passes_through_the_printed_table():
    table = columns("preetham_1999_table_1")
    for name in ("400", "450", "550", "650", "850"):
        eta = phase.scattering_term(np.cos(np.radians(table["theta_deg"])), [float(name)])[:, 0]
        assert eta == pytest.approx(table[name], rel=1e-9)


def test_haze_is_smooth_between_the_knots():
    degrees = np.linspace(1, 180, 20000)
    logarithm = np.log(phase.scattering_term(np.cos(np.radians(degrees)), [550.0])[:, 0])
    slope = np.gradient(logarithm, degrees)
    assert np.abs(np.diff(slope)).max() < 2e-4  # no kink: a linear table would step by up to .02
    assert (np.diff(np.sign(slope[np.abs(slope) > 1e-5])) != 0).sum() == 1  # one minimum, near 120 degrees


def test_mean_cosines():
    assert over_sphere(NODES * phase.henyey_greenstein(NODES, 0.76)) == pytest.approx(0.76, abs=1e-9)
    assert over_sphere(NODES * phase.rayleigh(NODES)) == pytest.approx(0, abs=1e-12)
    assert over_sphere(NODES * phase.haze(NODES, [550.0])[:, 0]) == pytest.approx(0.544, abs=0.005)  # measured, forward


def test_totals_are_the_integrals_of_the_angular_coefficients():
    w = columns("preetham_1999_table_2")["wavelength_nm"]
    assert over_sphere(gas_angular(NODES, w)) == pytest.approx(gas_total(w), rel=1e-9)
    assert over_sphere(haze_angular(NODES, w, 3.0)) == pytest.approx(haze_total(w, 3.0), rel=5e-3)  # Table 1 is coarse


def test_haze_coefficient_agrees_with_the_definition_of_turbidity():
    """Haze thickness = (T - 1) x that of molecules at 550 nm; with the printed 1e-16 it would be 100 times that."""
    molecules = 0.098  # vertical optical thickness of the standard atmosphere at 550 nm
    for turbidity in (2.0, 4.0, 6.0):
        thickness = haze_total([550.0], turbidity)[0] / HAZE_DECAY
        assert thickness == pytest.approx((turbidity - 1) * molecules, rel=0.05)


def test_gas_lies_above_modern_values_by_what_the_docs_say():
    modern = 1.149e-5  # m-1 at 550 nm, 15 C, 1013.25 mb (Bucholtz 1995, Table 3)
    assert 1.15 < gas_total([550.0])[0] / modern < 1.20
    assert gas_total([550.0], refractive_index=1.000278, depolarisation=0.0279)[0] == pytest.approx(modern, rel=0.02)


def test_molecules_scatter_by_the_fourth_power():
    assert gas_total([400.0])[0] / gas_total([800.0])[0] == pytest.approx(16)


def test_gradients_pass():
    torch = pytest.importorskip("torch")
    c = torch.linspace(-1, 1, 9, dtype=torch.float64, requires_grad=True)
    phase.haze(c, [450.0, 550.0]).sum().backward()
    assert torch.isfinite(c.grad).all()
    t = torch.tensor(3.0, dtype=torch.float64, requires_grad=True)
    haze_total([550.0], t).sum().backward()
    assert float(t.grad) == pytest.approx(float(haze_total([550.0], 4.0)[0] - haze_total([550.0], 3.0)[0]))


def test_concentration_is_a_hundredth_of_the_printed():
    assert concentration(2.0) == pytest.approx(0.6578e-18)
