"""Colour temperature: Planck's law, the nearest black body to a colour, and the distance to it."""

from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arguments import numbers, with_last_axis
from skydome.ground.arrays import as_numpy
from skydome.ground.labels import keeps_labels
from skydome.light.spectrum import checked_wavelengths, xyz_weights

PLANCK = 6.62607015e-34
"""Planck constant, J s (exact, SI 2019)."""

LIGHT_SPEED = 299792458.0
"""Speed of light in vacuum, m s-1 (exact)."""

BOLTZMANN = 1.380649e-23
"""Boltzmann constant, J K-1 (exact, SI 2019)."""

COOLEST = 800.0
"""Lowest temperature of the Planckian locus that is searched, K."""


def planck(wavelengths: ArrayLike, temperature: ArrayLike) -> np.ndarray:
    """Spectral radiance of black bodies, W m-2 sr-1 nm-1, shape (..., W), in vacuum (n = 1).

    `wavelengths` (W,) in nm, `temperature` (...,) in K, > 0. Planck's law, in the form that stays exact for hot bodies.

    >>> round(float(planck([500.0], 5772.0)[0]))
    26239
    """
    kelvin = np.asarray(temperature, dtype=np.float64)
    if not (kelvin > 0).all():
        raise ValueError(f"temperature must be > 0 K, got {kelvin.min()}")
    metres = checked_wavelengths(wavelengths) * 1e-9
    classical = 2e-9 * LIGHT_SPEED * BOLTZMANN * kelvin[..., None] / metres**4
    radiance: np.ndarray = classical * _quantum_factor(metres, 1 / kelvin)
    return radiance


def _quantum_factor(metres: np.ndarray, per_kelvin: np.ndarray) -> np.ndarray:
    """Factor x / (e^x - 1), x = h c / (k lambda T): Planck's law over the classical one; 1 where 1 / T = 0."""
    x = PLANCK * LIGHT_SPEED / BOLTZMANN * per_kelvin[..., None] / metres
    x = np.clip(x, 1e-12, 700.0)
    result: np.ndarray = x / np.expm1(x)
    return result


def uv_from_xyz(xyz: ArrayLike) -> np.ndarray:
    """CIE 1960 u, v of XYZ (..., 3), shape (..., 2); NaN for black.

    >>> uv_from_xyz([1.0, 1.0, 1.0]).round(4).tolist()
    [0.2105, 0.3158]
    """
    each = with_last_axis(numbers(as_numpy(xyz), "xyz"), 3, "xyz")
    x, y, z = (each[..., k] for k in range(3))
    total = x + 15 * y + 3 * z
    usable = np.where(total > 0, total, np.nan)
    return np.stack([4 * x / usable, 6 * y / usable], axis=-1)


@cache
def _locus() -> tuple[np.ndarray, np.ndarray]:
    """u, v (N, 2) of black bodies at 0, 1, 2 ... mired (N - 1 = 1e6 / COOLEST) and the unit tangents toward red."""
    wavelengths = np.arange(360.0, 831.0)
    mired = np.arange(0.0, 1e6 / COOLEST + 1)
    spectra = _quantum_factor(wavelengths * 1e-9, mired * 1e-6) / (wavelengths * 1e-3) ** 4
    points = uv_from_xyz(spectra @ xyz_weights(wavelengths))
    tangents = np.gradient(points, axis=0, edge_order=2)
    return points, tangents / np.linalg.norm(tangents, axis=-1, keepdims=True)


def _nearest(uv: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Mired (...,) of the nearest black body, -inf beyond the hottest and inf beyond the coolest, and its duv (...,).

    The isotherm (normal to the locus) through `uv` lies between two of the table's, found by halving; between these
    the angle is linear (Robertson 1968, with isotherms at 1 mired).
    """
    points, tangents = _locus()

    def along(index: np.ndarray) -> np.ndarray:
        distance: np.ndarray = np.sum((uv - points[index]) * tangents[index], axis=-1)
        return distance

    low = np.zeros(uv.shape[:-1], dtype=np.intp)
    high = np.full(uv.shape[:-1], len(points) - 1)
    for _ in range(int(np.ceil(np.log2(len(points))))):
        middle = (low + high) // 2
        redder = along(middle) >= 0
        low, high = np.where(redder, middle, low), np.where(redder, high, middle)
    before, after = along(low), along(low + 1)
    fraction = np.clip(before / (before - after), 0.0, 1.0)
    mired = np.where(along(np.zeros_like(low)) < 0, -np.inf, np.where(after > 0, np.inf, low + fraction))
    nearest = points[low] + fraction[..., None] * (points[low + 1] - points[low])
    offset, tangent = uv - nearest, tangents[low]
    above = tangent[..., 0] * offset[..., 1] - tangent[..., 1] * offset[..., 0] >= 0
    return mired, np.where(above, 1.0, -1.0) * np.linalg.norm(offset, axis=-1)


@keeps_labels("K", xyz=1)
def colour_temperature(xyz: ArrayLike) -> np.ndarray:
    """Correlated colour temperature of XYZ (..., 3), K, shape (...,).

    The black body nearest in CIE 1960 u, v (CIE 15). Infinity for colours bluer than the hottest black body (much of a
    clear sky), NaN for black and for colours redder than 800 K. Meant for |duv| < 0.05, as CIE says. NumPy.

    >>> colour_temperature([[95.047, 100.0, 108.883], [40.0, 40.0, 90.0], [0.0, 0.0, 0.0]]).round(-1).tolist()
    [6500.0, inf, nan]
    """
    uv = uv_from_xyz(xyz)
    known = np.isfinite(uv).all(axis=-1)
    mired, _ = _nearest(np.where(known[..., None], uv, 0.3))
    usable = known & np.isfinite(mired) & (mired > 0)
    kelvin = 1e6 / np.where(usable, mired, 1.0)
    endless = known & (mired <= 0)
    result: np.ndarray = np.where(usable, kelvin, np.where(endless, np.inf, np.nan))
    return result


@keeps_labels(xyz=1)
def duv(xyz: ArrayLike) -> np.ndarray:
    """Distance of XYZ (..., 3) from the Planckian locus in CIE 1960 u, v, shape (...,); positive above it (greenish).

    For colours beyond the ends of the locus: the distance to the end. NaN for black.

    >>> round(float(duv([95.047, 100.0, 108.883])), 4)
    0.0032
    """
    uv = uv_from_xyz(xyz)
    known = np.isfinite(uv).all(axis=-1)
    _, distance = _nearest(np.where(known[..., None], uv, 0.3))
    result: np.ndarray = np.where(known, distance, np.nan)
    return result
