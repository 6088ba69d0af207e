from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from skydome.ground.tables import columns
from skydome.ground.units import LUMINOUS_EFFICACY
from skydome.light.spectrum import Spectrum, cie_1931, xyz_from_radiance, xyz_weights


def test_spectrum_is_linear_between_samples_and_held_outside():
    spectrum = Spectrum([400, 500, 700], [[1.0, 3.0, 7.0], [0.0, 0.0, 1.0]])
    np.testing.assert_allclose(spectrum.at([350, 450, 600, 800]), [[1, 2, 5, 7], [0, 0, 0.5, 1]], atol=1e-15)
    np.testing.assert_array_equal(Spectrum([550], [2.0]).at([400, 550, 700]), 2.0)


@pytest.mark.parametrize(
    ("wavelengths", "values", "message"),
    [
        ([500, 400], [1, 2], "increase"),
        ([400, 400], [1, 2], "increase"),
        ([400, np.nan], [1, 2], "finite"),
        ([-1, 400], [1, 2], "positive"),
        ([400, 500], [1, np.inf], "finite"),
        ([400, 500], [1, 2, 3], r"\(\.\.\., 2\)"),
        ([[400, 500]], [1, 2], "shape"),
        ([], [], "shape"),
    ],
)
def test_spectrum_refuses(wavelengths, values, message):
    with pytest.raises(ValueError, match=message):
        Spectrum(wavelengths, values)


def test_spectrum_keeps_its_own_read_only_copy():
    values = np.array([1.0, 2.0])
    spectrum = Spectrum([400, 500], values)
    values[0] = 9
    assert spectrum.values[0] == 1
    with pytest.raises(ValueError, match="read-only"):
        spectrum.values[0] = 5


def test_observer_is_that_of_colour_science(colour):
    observer = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"]
    np.testing.assert_allclose(cie_1931(observer.wavelengths), observer.values, atol=1e-12)


def test_observer_golden_values():
    # CIE 15:2004, Table T.4
    np.testing.assert_allclose(cie_1931([450]), [[0.33620, 0.03800, 1.77211]], atol=1e-6)
    np.testing.assert_allclose(cie_1931([600]), [[1.06220, 0.63100, 0.00080]], atol=1e-6)
    assert not cie_1931([359.999, 830.001]).any()


def brute_force_xyz(wavelengths, values):
    """The integral on a grid that holds every knot, by Gauss-Legendre in each of its small pieces."""
    knots = np.union1d(wavelengths, np.arange(360.0, 831.0))
    knots = knots[(knots >= max(wavelengths[0], 360)) & (knots <= min(wavelengths[-1], 830))]
    nodes, weights = np.polynomial.legendre.leggauss(3)
    total = np.zeros(3)
    for left, right in pairwise(knots):
        at = (left + right) / 2 + (right - left) / 2 * nodes
        radiance = np.interp(at, wavelengths, values)
        total += LUMINOUS_EFFICACY * (right - left) / 2 * (weights * radiance) @ cie_1931(at)
    return total


@given(
    st.lists(st.floats(300, 900), min_size=2, max_size=40, unique_by=lambda w: round(w, 3)),
    st.integers(0, 2**31),
)
def test_weights_integrate_piecewise_linear_spectra_exactly(wavelengths, seed):
    wavelengths = np.sort(wavelengths)
    values = np.random.default_rng(seed).uniform(0, 1, wavelengths.size)
    ours = values @ xyz_weights(wavelengths)
    np.testing.assert_allclose(ours, brute_force_xyz(wavelengths, values), rtol=1e-9, atol=1e-9)


def test_spacing_does_not_matter_for_a_linear_spectrum():
    coarse, fine = np.array([380.0, 780.0]), np.linspace(380, 780, 1234)
    np.testing.assert_allclose(xyz_from_radiance(coarse / 500, coarse), xyz_from_radiance(fine / 500, fine), rtol=1e-12)


def test_a_flat_spectrum_is_the_area_under_the_table():
    table = columns("cie_1931_2deg")
    area = [LUMINOUS_EFFICACY * np.trapezoid(table[k], table["wavelength_nm"]) for k in "xyz"]
    np.testing.assert_allclose(xyz_from_radiance([1.0, 1.0], [300, 1000]), area, rtol=1e-12)


def test_spectra_outside_the_observer_are_dark():
    np.testing.assert_array_equal(xyz_from_radiance([1.0, 1.0], [900, 1000]), 0)
    np.testing.assert_array_equal(xyz_from_radiance([1.0, 1.0], [200, 300]), 0)


def test_leading_axes_and_errors():
    assert xyz_from_radiance(np.ones((4, 5, 3)), [400, 500, 600]).shape == (4, 5, 3)
    assert xyz_from_radiance(np.ones((2, 3), dtype=np.float32), [400, 500, 600]).dtype == np.float32
    with pytest.raises(ValueError, match=r"\(\.\.\., 3\), got \(2,\)"):
        xyz_from_radiance([1.0, 2.0], [400, 500, 600])
    with pytest.raises(ValueError, match="2 wavelengths or more"):
        xyz_weights([550])


def test_torch_gives_the_weights_as_gradient():
    torch = pytest.importorskip("torch")
    radiance = torch.ones(3, dtype=torch.float64, requires_grad=True)
    xyz_from_radiance(radiance, [400, 500, 600])[1].backward()
    np.testing.assert_allclose(radiance.grad.numpy(), xyz_weights([400, 500, 600])[:, 1])
