"""Interpolation against NumPy, scipy and what each kind is exact for."""

import numpy as np
import pytest

from skydome.ground import interpolation

KNOTS = np.array([1.0, 2.5, 3.0, 7.0])


def test_linear_weights_are_those_of_numpy():
    x = np.linspace(1, 7, 97)
    values = np.array([3.0, -1.0, 4.0, 1.5])
    np.testing.assert_allclose(interpolation.weights(KNOTS, x) @ values, np.interp(x, KNOTS, values), atol=1e-14)
    cell, part = interpolation.cells(KNOTS, x)
    np.testing.assert_allclose(values[cell] * (1 - part) + values[cell + 1] * part, np.interp(x, KNOTS, values))
    assert interpolation.weights(KNOTS, np.array(3.0)).tolist() == [0, 0, 1, 0]
    assert interpolation.weights(KNOTS[:1], x).tolist() == [[1.0]] * 97
    np.testing.assert_allclose(interpolation.weights(KNOTS, np.array([0.0, 8.0])) @ KNOTS, [0.0, 8.0])


def test_linear_weights_of_other_libraries_and_their_gradient():
    torch = pytest.importorskip("torch")
    x = torch.tensor([1.0, 2.5, 2.6, 7.0], dtype=torch.float64, requires_grad=True)
    weights = interpolation.weights(KNOTS, x)
    np.testing.assert_array_equal(weights.detach().numpy(), interpolation.weights(KNOTS, x.detach().numpy()))
    (weights @ torch.tensor([0.0, 3.0, 4.0, 0.0], dtype=torch.float64)).sum().backward()
    np.testing.assert_allclose(x.grad.numpy(), [2.0, 2.0, 2.0, -1.0])  # of the cell above each knot


def test_lagranges_cubic_is_exact_for_cubics():
    x = np.linspace(0, 1, 50)
    knots, weights = interpolation.lagrange_about(9, x)
    cubic = np.polynomial.Polynomial([1.0, -2.0, 0.5, 3.0])
    np.testing.assert_allclose((cubic(knots / 8) * weights).sum(axis=1), cubic(x), atol=1e-14)
    assert (knots.min(), knots.max()) == (0, 8)


def test_catmull_and_roms_cubic_has_no_jumps_in_slope():
    values = np.random.default_rng(0).normal(size=12)

    def at(place):
        cell, weights = interpolation.catmull_rom_about(8, place)
        return sum(w * values[cell + k] for k, w in enumerate(weights))

    places = np.arange(1.0, 8.0)
    np.testing.assert_allclose(at(places), values[places.astype(int) + 1], atol=1e-14)
    step = 1e-6
    before, after = (at(places) - at(places - step)) / step, (at(places + step) - at(places)) / step
    np.testing.assert_allclose(before, after, atol=1e-4)
    middle = places.astype(int) + 1
    np.testing.assert_allclose(after, (values[middle + 1] - values[middle - 1]) / 2, atol=1e-4)


def test_spline_is_scipys():
    scipy = pytest.importorskip("scipy.interpolate")
    values = np.random.default_rng(1).normal(size=(4, 2))
    ends = ((2, np.zeros(2)), (1, np.zeros(2)))
    known = scipy.CubicSpline(KNOTS, values, bc_type=ends).c  # (power, piece, C), descending
    np.testing.assert_allclose(interpolation.spline(KNOTS, values), known[::-1].swapaxes(0, 1), atol=1e-12)
