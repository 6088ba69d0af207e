"""Phase functions: how much of the light that air and haze scatter goes which way, per steradian."""

from functools import cache
from typing import Any, NamedTuple

import numpy as np

from skydome.ground.arguments import numbers
from skydome.ground.arrays import Array, constant, floating, namespace, safe_sqrt
from skydome.ground.interpolation import spline, weights
from skydome.ground.quadrature import gauss_legendre
from skydome.ground.tables import columns


class ClosedForm(NamedTuple):
    """A phase function that kernels and shaders can write down, sr-1, of the cosine c of the angle.

    constant + square c^2 + the sum over lobes (a, b, g) of (a + b c^2) / (1 + g^2 - 2 g c)^1.5.
    """

    constant: float = 0.0
    square: float = 0.0
    lobes: tuple[tuple[float, float, float], ...] = ()

    def value(self, away: Array) -> Array:
        """The phase function of 1 - c (...,), which keeps its digits near the sun, sr-1, shape (...,)."""
        squared = (1 - away) ** 2
        total = self.constant + self.square * squared
        for plain, with_square, g in self.lobes:
            gap = (1 - g) ** 2 + 2 * g * away
            total = total + (plain + with_square * squared) / (gap * namespace(gap).sqrt(gap))
        return total


def rayleigh(cos_angle: Array, depolarisation: float = 0.0) -> Array:
    """Rayleigh's phase function, sr-1, shape of `cos_angle`; its integral over the sphere is 1.

    `depolarisation`: the factor p_n of the gas (0.035 in Preetham 1999, 0.0279 for air by modern measurements), as
    Chandrasekhar's generalised form has it; 0 is the plain 3 / (16 pi) (1 + cos^2), which Preetham 1999, A.3 uses.

    >>> round(float(rayleigh(np.array(1.0)) * 16 * np.pi / 3), 12)
    2.0
    """
    gamma = depolarisation / (2 - depolarisation)
    factor = 3 / (16 * np.pi * (1 + 2 * gamma))
    return factor * (1 + 3 * gamma + (1 - gamma) * cos_angle * cos_angle)


def rayleigh_polarised(depolarisation: float = 0.0) -> float:
    """What sin^2 of the angle is multiplied by in the polarised part of Rayleigh's phase function, sr-1.

    Light of the sun is polarised across the plane of scattering by that much (Hansen and Travis 1974, eq. 2.15).

    >>> bool(np.isclose(rayleigh_polarised(), rayleigh(np.array(0.0))))
    True
    """
    gamma = depolarisation / (2 - depolarisation)
    return 3 / (16 * np.pi * (1 + 2 * gamma)) * (1 - gamma)


def henyey_greenstein(cos_angle: Array, asymmetry: Any) -> Array:
    """Henyey and Greenstein's phase function (1941), sr-1; `asymmetry` g in (-1, 1) is its mean cosine.

    >>> round(float(henyey_greenstein(np.array(0.3), 0.0) * 4 * np.pi), 12)
    1.0
    """
    g = asymmetry
    return (1 - g * g) / (4 * np.pi) / (1 + g * g - 2 * g * cos_angle) ** 1.5


def cornette_shanks(cos_angle: Array, asymmetry: Any) -> Array:
    """Cornette and Shanks's phase function (1992), sr-1: Rayleigh's for g = 0, a forward peak for g near 1.

    Note: its mean cosine is a little above g (g = 0.76 gives 0.79).

    >>> bool(cornette_shanks(np.array(0.3), 0.0) == rayleigh(np.array(0.3)))
    True
    """
    g = asymmetry
    factor = 3 / (8 * np.pi) * (1 - g * g) / (2 + g * g)
    return factor * (1 + cos_angle * cos_angle) / (1 + g * g - 2 * g * cos_angle) ** 1.5


def haze(cos_angle: Array, wavelengths: Any) -> Array:
    """The phase function of haze (Mie, Junge's exponent 4) at `wavelengths` (W,) nm, sr-1, shape (..., W).

    Bullrich's table as Preetham 1999, Table 1 prints it: log eta is a cubic spline in the angle and linear in the
    wavelength, as `wavelength_weights` says. Scaled to an integral of exactly 1 (error 1e-9); the paper's own scale,
    eta / (2 pi K), differs from that by at most 0.4 % at 380-780 nm.

    >>> haze(np.array([1.0, 0.0]), [550.0]).round(3).ravel().tolist()
    [1.065, 0.031]
    """
    eta = scattering_term(cos_angle, wavelengths)
    return eta / constant(2 * np.pi * integrated_term(wavelengths), eta)


def scattering_term(cos_angle: Array, wavelengths: Any) -> Array:
    """Table 1's eta at any angle and `wavelengths` (W,) nm, shape (..., W); linear in log eta below 1 degree."""
    xp = namespace(cos_angle)
    c = floating(cos_angle)
    degrees = (360 / np.pi) * xp.atan2(safe_sqrt((1 - c) / 2), safe_sqrt((1 + c) / 2))
    knots, pieces = eta_spline()
    coefficients = constant(pieces @ wavelength_weights(wavelengths), c)  # (piece, power, W)
    piece = xp.astype(xp.zeros_like(degrees), xp.int32)
    for knot in knots[1:-1]:
        piece = piece + xp.astype(degrees >= float(knot), xp.int32)
    chosen = coefficients[piece]
    x = (degrees - constant(knots[:-1], c)[piece])[..., None]
    return xp.exp(((chosen[..., 3, :] * x + chosen[..., 2, :]) * x + chosen[..., 1, :]) * x + chosen[..., 0, :])


def integrated_term(wavelengths: Any) -> np.ndarray:
    """The integral of eta(theta) sin(theta) over 0..pi, (W,): what Preetham 1999, Table 2 calls K."""
    knots = np.concatenate([[0.0], eta_spline()[0][1:]]) * (np.pi / 180)
    t, w = gauss_legendre(24)
    angles = (knots[:-1, None] + np.diff(knots)[:, None] * t).ravel()
    steps = (np.diff(knots)[:, None] * w).ravel()
    eta = np.asarray(scattering_term(np.cos(angles), wavelengths))
    total: np.ndarray = (steps * np.sin(angles)) @ eta
    return total


def wavelength_weights(wavelengths: Any) -> np.ndarray:
    """Linear interpolation from Table 1's five wavelengths to `wavelengths` (W,) nm, shape (5, W).

    The line from 400 to 450 nm is followed down to 350 nm; beyond 350 and 850 nm the end values are held.
    """
    known = np.array([400.0, 450.0, 550.0, 650.0, 850.0])
    held: np.ndarray = weights(known, np.clip(numbers(wavelengths, "wavelengths"), 350.0, 850.0)).T
    return held


@cache
def eta_spline() -> tuple[np.ndarray, np.ndarray]:
    """Knots in degrees (13,) and the cubics in log eta between them, ascending powers, shape (12, 4, 5).

    A spline, natural at 1 degree and level at 180, where the table's symmetry asks for it.
    """
    table = columns("preetham_1999_table_1")
    knots = table["theta_deg"]
    values = np.log(np.stack([table[name] for name in ("400", "450", "550", "650", "850")], axis=-1))
    return knots, spline(knots, values)
