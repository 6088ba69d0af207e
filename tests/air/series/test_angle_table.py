"""Phase functions of long series by tables of the angle: as the series itself, in every library, with gradients."""

import numpy as np
import pytest

import skydome as sd
from skydome.air.series.legendre import combined, legendre, series_sum, strengths

WAVELENGTHS = np.array([450.0, 650.0])
COSINES = np.cos(np.concatenate([np.linspace(0, np.pi, 1501), np.geomspace(1e-4, 0.1, 200)]))
LAWS = {
    "narrow droplets": sd.MieParticles(sd.Lognormal(4e-6, 1.05), 1.33).optics(WAVELENGTHS).phase_law,
    "dust": sd.MieParticles(sd.Lognormal(0.39e-6, 2.0), 1.53, 0.0055, 400).optics(WAVELENGTHS).phase_law,
}


@pytest.mark.parametrize("name", LAWS)
def test_the_table_is_the_series(name):
    """Within 1e-4 at every angle, the forward peak and the glory among them; its polarised part, of its own peak."""
    law = LAWS[name]
    np.testing.assert_allclose(law.value(COSINES, WAVELENGTHS), series_sum(law.series, COSINES), rtol=1e-4)
    polarised = series_sum(law.polarising, COSINES)
    assert np.abs(law.polarised(COSINES, WAVELENGTHS) - polarised).max() < 1e-4 * np.abs(polarised).max()


def test_between_wavelengths_the_table_is_linear_as_the_moments_are():
    law, w = LAWS["dust"], np.array([400.0, 500.0, 700.0])
    np.testing.assert_allclose(law.value(COSINES, w), series_sum(law.moments(len(law.series), w), COSINES), rtol=1e-4)


@pytest.mark.parametrize("library", ["torch", "jax.numpy"])
def test_a_series_has_values_and_gradients_in_every_library(library):
    """By central differences of the table; the true slope of the series is within 1 % of its largest."""
    xp, law = pytest.importorskip(library), LAWS["narrow droplets"]
    c, step = np.cos(np.radians([0.5, 3.0, 60.0, 140.0, 179.0])), 1e-7
    slopes = (law.value(c + step, [550.0]) - law.value(c - step, [550.0])) / (2 * step)
    if library == "torch":
        x = xp.tensor(c, dtype=xp.float64, requires_grad=True)
        values = law.value(x, [550.0])
        (found,) = xp.autograd.grad(values.sum(), x)
        values = values.detach()
    else:
        import jax

        with jax.enable_x64(True):
            values = law.value(xp.asarray(c), [550.0])
            found = jax.grad(lambda x: law.value(x, [550.0]).sum())(xp.asarray(c))
    np.testing.assert_allclose(np.asarray(values), law.value(c, [550.0]), rtol=1e-9)
    np.testing.assert_allclose(np.asarray(found), slopes[:, 0], rtol=1e-4)


def test_a_series_combined_at_many_airs_is_that_of_each():
    chi = np.random.default_rng(1).uniform(0, 1, (9, 3, 1, 2))
    whole = combined(legendre(9, COSINES[:7]), strengths(chi))
    assert whole.shape == (3, 7, 2)
    for k in range(3):
        np.testing.assert_allclose(whole[k], series_sum(chi[:, k, 0], COSINES[:7]), atol=1e-13)
