"""Daylight: the spectrum of the CIE D series that has a given colour and luminance (Preetham 1999, A.5, Table 2)."""

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arguments import with_last_axis
from skydome.ground.arrays import (
    Array,
    at_least,
    constant,
    floating,
    limited,
    namespace,
    safe_divide,
    settled,
)
from skydome.ground.tables import columns
from skydome.light.spectrum import checked_wavelengths, interpolated, xyz_weights

CHROMATICITY_TO_AMOUNTS = np.array(
    [
        [0.0241, -1.3515, 0.0300],
        [0.2562, -1.7703, -31.4424],
        [-0.7341, 5.9114, 30.0717],
    ]
)
"""Rows 1, x, y; columns the common denominator of M1 and M2 and their numerators (Preetham 1999, A.5)."""

TOTAL_FIRST = np.array([[1.0, 1.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
"""XYZ columns to X + Y + Z, X, Y: the chromaticity (1, x, y) times the total."""

RANGE = (380.0, 780.0)
"""The wavelengths of Table 2, nm."""


@settled
def daylight_basis(wavelengths: ArrayLike) -> np.ndarray:
    """S0, S1, S2 of the CIE daylight at `wavelengths` (W,), nm, shape (3, W), relative; linear between 10 nm steps.

    Preetham 1999, Table 2 (Judd, MacAdam, Wyszecki 1964). ValueError outside 380-780 nm.
    """
    w = checked_wavelengths(wavelengths)
    if w[0] < RANGE[0] or w[-1] > RANGE[1]:
        raise ValueError(f"daylight wavelengths must lie in [380, 780] nm, got {w[0]:g} to {w[-1]:g}")
    table = columns("preetham_1999_table_2")
    return interpolated(w, table["wavelength_nm"], np.stack([table[name] for name in ("S0", "S1", "S2")]))


def daylight_spectrum(xyz: Array, wavelengths: Array) -> Array:
    """Spectral radiance of the daylight with the colour `xyz` (..., 3), W m-2 sr-1 nm-1, shape (..., W).

    Y of `xyz` is in cd m-2 and is kept: the spectrum over 380-780 nm integrates to it. Chromaticity is matched as well
    as the digits of A.5 allow (within 1e-4 in x and y from D40 to D250). Black gives 0. Far from the
    daylight locus (saturated colours, as a published sky has near a low sun) parts of the series are negative: they are
    cut at 0 and the rest is raised, so that Y is kept and the colour is paler. Any array library.

    S = S0 + M1 S1 + M2 S2 (Preetham 1999, A.5), here with M1 and M2 multiplied through by their common denominator and
    by X + Y + Z: numerator and denominator are then linear in XYZ, and the pole of M1 and M2 cancels.

    >>> d65 = daylight_spectrum([95.047, 100.0, 108.883], [460.0, 560.0, 660.0])
    >>> (100 * d65 / d65[1]).round(1).tolist()
    [117.9, 100.0, 80.4]
    """
    xyz = with_last_axis(xyz, 3, "xyz")
    table = columns("preetham_1999_table_2")["wavelength_nm"]
    (relative, _), (whole, row) = daylight_weights(wavelengths), daylight_weights(table)
    xp = namespace(xyz)
    one = xp.ones_like(xyz[..., 0])
    upright = xp.where(xyz @ constant(row, xyz) < 0, -one, one)[..., None] * xyz  # the denominator's sign
    luminance = at_least(upright @ constant(whole.T, xyz), 0.0) @ constant(xyz_weights(table)[:, 1], xyz)
    return safe_divide(xyz[..., 1], luminance)[..., None] * at_least(upright @ constant(relative.T, xyz), 0.0)


def daylight_weights(wavelengths: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """What `daylight_spectrum` multiplies XYZ by: the relative spectrum's matrix (W, 3), its luminance's row (3,)."""
    basis, table = daylight_basis(wavelengths), columns("preetham_1999_table_2")["wavelength_nm"]
    luminances = daylight_basis(table) @ xyz_weights(table)[:, 1]
    amounts = CHROMATICITY_TO_AMOUNTS.T @ TOTAL_FIRST
    return basis.T @ amounts, luminances @ amounts


LOCUS = (4000.0, 25000.0)
"""Colour temperatures for which the CIE gives the daylight locus, K."""


def daylight_chromaticity(temperature: Array) -> Array:
    """CIE x, y of daylight of a correlated colour temperature (...,), K, shape (..., 2); held at the locus' ends.

    CIE 15:2018, eq. 4.1-4.3: cubics in 1 / T on both sides of 7000 K, and y by a parabola in x.

    >>> daylight_chromaticity(6504.0).round(4).tolist()
    [0.3127, 0.3291]
    """
    temperature = floating(temperature)
    xp = namespace(temperature)
    t = 1e3 / limited(temperature, *LOCUS)
    warm = ((-4.6070 * t + 2.9678) * t + 0.09911) * t + 0.244063
    cold = ((-2.0064 * t + 1.9018) * t + 0.24748) * t + 0.237040
    x = xp.where(t > 1 / 7, warm, cold)
    return xp.stack([x, (-3.000 * x + 2.870) * x - 0.275], axis=-1)
