"""Phase functions as objects: their value, and their Legendre moments for solvers that want them."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from hashlib import sha256
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from skydome.air.phase_functions import cornette_shanks, haze, henyey_greenstein, rayleigh
from skydome.ground.arguments import numbers
from skydome.ground.arrays import Array, constant, floating, is_numpy, namespace
from skydome.ground.limits.ranges import Range, require
from skydome.ground.quadrature import gauss_legendre
from skydome.light.spectrum import Spectrum

CHUNK = 4096


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


class PhaseLaw(ABC):
    """A phase function, sr-1, whose integral over the sphere is 1, at any wavelength."""

    wavelengths_alike: ClassVar[bool] = True
    """True where it is the same for all wavelengths."""

    @abstractmethod
    def value(self, cosine: ArrayLike, wavelengths: ArrayLike) -> Array:
        """The phase function of the cosine (...,) at wavelengths (W,) nm, sr-1, shape (..., W)."""

    @property
    def closed(self) -> ClosedForm | None:
        """The law as a closed form, the same for all wavelengths; None for those known by tables or series."""
        return None

    def mean_cosine(self, wavelengths: Any) -> Array:
        """The mean cosine of the scattering angle, (W,), or (..., W) where the law's numbers are arrays (...,)."""
        return self.moments(2, wavelengths)[1]

    def moments(self, count: int, wavelengths: Any) -> Array:
        """Legendre moments 0 .. count - 1 (the first is 1), shape (count, W), by quadrature in the angle."""
        t, w = gauss_legendre(max(512, 4 * count))
        cosine = np.cos(np.pi * t)
        weight = 2 * np.pi * np.pi * w * np.sin(np.pi * t)
        moments: np.ndarray = (legendre(count, cosine) * weight) @ self.value(cosine, wavelengths)
        return moments / moments[0]


def legendre(count: int, cosine: np.ndarray) -> Array:
    """Legendre polynomials P_0 .. P_(count - 1) of the cosine (N,), shape (count, N)."""
    rows = [np.ones_like(cosine), cosine]
    for n in range(1, count - 1):
        rows.append(((2 * n + 1) * cosine * rows[-1] - n * rows[-2]) / (n + 1))
    return np.stack(rows[:count])


ASYMMETRY = Range(-0.999999, 0.999999)


@dataclass(frozen=True)
class Rayleigh(PhaseLaw):
    """Rayleigh's phase function with a `depolarisation` factor (a number, for all wavelengths)."""

    depolarisation: float = 0.0

    def __post_init__(self) -> None:
        if not 0 <= self.depolarisation < 0.5:
            raise ValueError(f"depolarisation must lie in [0, 0.5), got {self.depolarisation}")

    def value(self, cosine: ArrayLike, wavelengths: ArrayLike) -> Array:
        """Chandrasekhar's generalised form, the same for all wavelengths."""
        return spread(rayleigh(floating(cosine), self.depolarisation), wavelengths)

    @property
    def closed(self) -> ClosedForm:
        """A constant and a square."""
        level = float(rayleigh(np.asarray(0.0), self.depolarisation))
        return ClosedForm(level, float(rayleigh(np.asarray(1.0), self.depolarisation)) - level)

    def mean_cosine(self, wavelengths: Any) -> Array:
        """None: as much goes forward as back."""
        return np.zeros(np.size(wavelengths))


@dataclass(frozen=True)
class HenyeyGreenstein(PhaseLaw):
    """A sum of Henyey-Greenstein lobes: `asymmetries` g in (-1, 1) and the `weights` of each, made to sum to 1.

    >>> bool(np.isclose(HenyeyGreenstein((0.85, 0.6), (1.0, 1.0)).moments(2, [550.0])[1, 0], 0.725))
    True
    """

    asymmetries: tuple[Any, ...] = (0.76,)
    weights: tuple[float, ...] = (1.0,)

    def __post_init__(self) -> None:
        if len(self.asymmetries) != len(self.weights) or not self.weights:
            raise ValueError(
                f"each lobe needs a weight, got {len(self.asymmetries)} lobes, {len(self.weights)} weights"
            )
        for g in self.asymmetries:
            require("asymmetry", g, ASYMMETRY)
        if not (min(self.weights) >= 0 and sum(self.weights) > 0):
            raise ValueError(f"weights must not be negative, nor all 0, got {self.weights}")

    @property
    def shares(self) -> Array:
        """The weights scaled to a sum of 1."""
        weights = np.asarray(self.weights, dtype=np.float64)
        return weights / weights.sum()

    def value(self, cosine: ArrayLike, wavelengths: ArrayLike) -> Array:
        """The lobes' sum, the same for all wavelengths."""
        cosine = floating(cosine)
        lobes = [
            float(part) * henyey_greenstein(cosine, g) for g, part in zip(self.asymmetries, self.shares, strict=True)
        ]
        return spread(sum(lobes[1:], lobes[0]), wavelengths)

    @property
    def closed(self) -> ClosedForm | None:
        """The lobes; None where an asymmetry is an array."""
        if any(np.ndim(g) or not is_numpy(g) for g in self.asymmetries):
            return None
        each = [(float(part), float(g)) for part, g in zip(self.shares, self.asymmetries, strict=True)]
        return ClosedForm(lobes=tuple((part * (1 - g * g) / (4 * np.pi), 0.0, g) for part, g in each))

    def mean_cosine(self, wavelengths: Any) -> Array:
        """The sum of the lobes' g."""
        means = [float(part) * floating(g) for g, part in zip(self.asymmetries, self.shares, strict=True)]
        return spread(sum(means[1:], means[0]), wavelengths)

    def moments(self, count: int, wavelengths: ArrayLike) -> Array:
        """The sum of g^n, exact."""
        powers = np.asarray(self.asymmetries) ** np.arange(count)[:, None]
        return spread(powers @ self.shares, wavelengths)


@dataclass(frozen=True)
class CornetteShanks(PhaseLaw):
    """Cornette and Shanks's phase function of `asymmetry` g in (-1, 1)."""

    asymmetry: float = 0.76

    def __post_init__(self) -> None:
        if not -1 < self.asymmetry < 1:
            raise ValueError(f"asymmetry must lie in (-1, 1), got {self.asymmetry}")

    @property
    def closed(self) -> ClosedForm:
        """One lobe, with a square."""
        g = float(self.asymmetry)
        factor = 3 / (8 * np.pi) * (1 - g * g) / (2 + g * g)
        return ClosedForm(lobes=((factor, factor, g),))

    def value(self, cosine: ArrayLike, wavelengths: ArrayLike) -> Array:
        """The same for all wavelengths."""
        return spread(cornette_shanks(floating(cosine), self.asymmetry), wavelengths)


@dataclass(frozen=True)
class Haze(PhaseLaw):
    """The Mie table of haze (Bullrich, as Preetham 1999, Table 1 prints it)."""

    wavelengths_alike: ClassVar[bool] = False

    def value(self, cosine: ArrayLike, wavelengths: ArrayLike) -> Array:
        """Interpolated in angle and wavelength."""
        return haze(floating(cosine), wavelengths)


@dataclass(frozen=True, eq=False, repr=False)
class LegendreSeries(PhaseLaw):
    """A phase function as its Legendre moments (L, W) at `wavelengths` (W,), nm, the first of each 1.

    p(cos) = sum of (2 l + 1) chi_l P_l(cos) / (4 pi), so that its integral is 1 to rounding. The moments are linear
    between the wavelengths and held outside. ValueError unless the first moments are 1 and p is not negative.

    >>> law = LegendreSeries([550.0], [[1.0], [0.0], [0.1]])     # Rayleigh's
    >>> law.value(np.array([1.0]), [550.0]).round(4).tolist() == [[round(3 / (8 * np.pi), 4)]]
    True
    """

    wavelengths: Any
    series: Any
    wavelengths_alike: ClassVar[bool] = False

    def __post_init__(self) -> None:
        known = Spectrum(self.wavelengths, self.series)
        if known.values.ndim != 2 or len(known.values) < 2:
            raise ValueError(f"a series must have shape (L, W) with L >= 2, got {known.values.shape}")
        if not np.allclose(known.values[0], 1.0, rtol=0, atol=1e-9):
            raise ValueError(f"the first moment must be 1, got {known.values[0].tolist()}")
        object.__setattr__(self, "wavelengths", known.wavelengths)
        object.__setattr__(self, "series", known.values)
        least = self.value(np.cos(np.linspace(0, np.pi, 361)), known.wavelengths).min()
        if least < 0:
            raise ValueError(f"a phase function must not be negative, got {least:.3g} sr-1 by its moments")

    def __repr__(self) -> str:
        """Tells different series apart, however long."""
        mark = sha256(self.wavelengths.tobytes() + self.series.tobytes()).hexdigest()[:16]
        return f"LegendreSeries({len(self.series)} moments at {self.wavelengths.size} wavelengths, {mark})"

    def value(self, cosine: ArrayLike, wavelengths: ArrayLike) -> Array:
        """The series' sum."""
        cosine = np.asarray(cosine, dtype=np.float64)
        count = len(self.series)
        strength = self.moments(count, wavelengths) * (2 * np.arange(count)[:, None] + 1) / (4 * np.pi)
        flat, result = cosine.ravel(), np.empty((cosine.size, strength.shape[1]))
        for start in range(0, flat.size, CHUNK):
            result[start : start + CHUNK] = legendre(count, flat[start : start + CHUNK]).T @ strength
        return result.reshape(*cosine.shape, -1)

    def moments(self, count: int, wavelengths: ArrayLike) -> Array:
        """The moments, 0 beyond the series' end."""
        there = Spectrum(self.wavelengths, self.series[:count]).at(np.atleast_1d(numbers(wavelengths, "wavelengths")))
        return np.concatenate([there, np.zeros((count - len(there), there.shape[1]))])


def spread(values: np.ndarray, wavelengths: ArrayLike) -> Array:
    """Values (...,) repeated for each of the wavelengths, (..., W)."""
    values = floating(values)
    return values[..., None] * constant(np.ones(np.size(wavelengths)), values)
