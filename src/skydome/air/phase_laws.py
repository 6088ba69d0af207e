"""Phase functions as objects: their value, and their Legendre moments for solvers that want them."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from skydome.air import phase_functions
from skydome.air.phase_functions import ClosedForm
from skydome.air.series.legendre import legendre
from skydome.ground.arrays import Array, constant, floating, is_numpy, namespace
from skydome.ground.limits.ranges import FINITE, HeldBySky, Range, require
from skydome.ground.quadrature import gauss_legendre


class PhaseLaw(HeldBySky, ABC):
    """A phase function, sr-1, whose integral over the sphere is 1, at any wavelength."""

    wavelengths_alike: ClassVar[bool] = True
    """True where it is the same for all wavelengths."""

    @abstractmethod
    def value(self, cosine: ArrayLike, wavelengths: ArrayLike) -> Array:
        """The phase function of the cosine (...,) at wavelengths (W,) nm, sr-1, shape (..., W)."""

    def polarised(self, cosine: ArrayLike, wavelengths: ArrayLike) -> Array:
        """Minus P12 over sin^2 of the angle, sr-1, shape (..., W): sunlight is polarised across the plane of scattering
        by so much. 0 for laws that tell nothing of polarisation.
        """
        return spread(0.0 * floating(cosine), wavelengths)

    @property
    def straight_between(self) -> np.ndarray | None:
        """Wavelengths (W,), nm, between which its values are straight lines, and held outside; None for other laws."""
        return None

    @property
    def closed(self) -> ClosedForm | None:
        """The law as a closed form, the same for all wavelengths; None for those known by tables or series."""
        return None

    def mean_cosine(self, wavelengths: Any) -> Array:
        """The mean cosine of the scattering angle, (W,), or (..., W) where the law's numbers are arrays (...,)."""
        return self.moments(2, wavelengths)[1]

    @property
    def one_lobe(self) -> bool:
        """Whether it is one Henyey-Greenstein lobe."""
        return False

    def second_moment(self, wavelengths: Any) -> Array:
        """The second Legendre moment, the mean of (3 cos^2 - 1) / 2, of the shape of `mean_cosine`."""
        return self.moments(3, wavelengths)[2]

    def moments(self, count: int, wavelengths: Any) -> Array:
        """Legendre moments 0 .. count - 1 (the first is 1), shape (count, W), by quadrature in the angle."""
        t, w = gauss_legendre(max(512, 4 * count))
        cosine = np.cos(np.pi * t)
        weight = 2 * np.pi * np.pi * w * np.sin(np.pi * t)
        moments: np.ndarray = (legendre(count, cosine) * weight) @ self.value(cosine, wavelengths)
        return moments / moments[0]


ASYMMETRY = Range(-0.999999, 0.999999)


@dataclass(frozen=True)
class Rayleigh(PhaseLaw):
    """Rayleigh's phase function with a `depolarisation` factor (a number, for all wavelengths)."""

    depolarisation: float = 0.0
    bounds: ClassVar = {"depolarisation": Range(0.0, 0.5)}

    def __post_init__(self) -> None:
        if not 0 <= self.depolarisation < 0.5:
            raise ValueError(f"depolarisation must lie in [0, 0.5), got {self.depolarisation}")

    def value(self, cosine: ArrayLike, wavelengths: ArrayLike) -> Array:
        """Chandrasekhar's generalised form, the same for all wavelengths."""
        return spread(phase_functions.rayleigh(floating(cosine), self.depolarisation), wavelengths)

    def polarised(self, cosine: ArrayLike, wavelengths: ArrayLike) -> Array:
        """The same at every angle."""
        return spread(0.0 * floating(cosine) + phase_functions.rayleigh_polarised(self.depolarisation), wavelengths)

    @property
    def closed(self) -> ClosedForm:
        """A constant and a square."""
        level = float(phase_functions.rayleigh(np.asarray(0.0), self.depolarisation))
        return ClosedForm(level, float(phase_functions.rayleigh(np.asarray(1.0), self.depolarisation)) - level)

    def mean_cosine(self, wavelengths: Any) -> Array:
        """None: as much goes forward as back."""
        return np.zeros(np.size(wavelengths))


@dataclass(frozen=True)
class HenyeyGreenstein(PhaseLaw):
    """A sum of Henyey-Greenstein lobes: `asymmetries` g in (-1, 1) and the `weights` of each, made to sum to 1.

    `peak_polarisation`: degree to which light scattered by 90 degrees is polarised (White 1979): 0 for none.

    >>> bool(np.isclose(HenyeyGreenstein((0.85, 0.6), (1.0, 1.0)).moments(2, [550.0])[1, 0], 0.725))
    True
    """

    asymmetries: tuple[Any, ...] = (0.76,)
    weights: tuple[float, ...] = (1.0,)
    peak_polarisation: float = 0.0
    bounds: ClassVar = {"weights": FINITE, "peak_polarisation": Range(-1.0, 1.0)}

    def __post_init__(self) -> None:
        require("peak_polarisation", self.peak_polarisation, self.bounds["peak_polarisation"])
        lobes, weights = len(self.asymmetries), len(self.weights)
        if lobes != weights or not weights:
            raise ValueError(f"each lobe needs a weight, got {lobes} lobes, {weights} weights")
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
        c, parts = floating(cosine), zip(self.asymmetries, self.shares, strict=True)
        lobes = [float(part) * phase_functions.henyey_greenstein(c, g) for g, part in parts]
        return spread(sum(lobes[1:], lobes[0]), wavelengths)

    def polarised(self, cosine: ArrayLike, wavelengths: ArrayLike) -> Array:
        """White 1979: P12 = -peak P11 (1 - cos^2) / (1 + cos^2), as of Rayleigh's."""
        c = floating(cosine)
        return self.value(c, wavelengths) * (self.peak_polarisation / (1 + c * c))[..., None]

    @property
    def one_lobe(self) -> bool:
        """Where it has one."""
        return len(self.asymmetries) == 1

    @property
    def closed(self) -> ClosedForm | None:
        """The lobes; None where an asymmetry is an array."""
        if any(np.ndim(g) or not is_numpy(g) for g in self.asymmetries):
            return None
        each = [(float(part), float(g)) for part, g in zip(self.shares, self.asymmetries, strict=True)]
        return ClosedForm(lobes=tuple((part * (1 - g * g) / (4 * np.pi), 0.0, g) for part, g in each))

    def moments(self, count: int, wavelengths: ArrayLike) -> Array:
        """The sums of g^n, exact, (count, ..., W) where the lobes' g are arrays (...,)."""
        lobes = [(float(part), floating(g)) for g, part in zip(self.asymmetries, self.shares, strict=True)]
        each = [spread(sum(part * g**order for part, g in lobes), wavelengths) for order in range(count)]
        return namespace(each[0]).stack(each)


@dataclass(frozen=True)
class CornetteShanks(PhaseLaw):
    """Cornette and Shanks's phase function of `asymmetry` g in (-1, 1)."""

    asymmetry: float = 0.76
    bounds: ClassVar = {"asymmetry": ASYMMETRY}

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
        return spread(phase_functions.cornette_shanks(floating(cosine), self.asymmetry), wavelengths)


@dataclass(frozen=True)
class Haze(PhaseLaw):
    """The Mie table of haze (Bullrich, as Preetham 1999, Table 1 prints it)."""

    wavelengths_alike: ClassVar[bool] = False

    def value(self, cosine: ArrayLike, wavelengths: ArrayLike) -> Array:
        """Interpolated in angle and wavelength."""
        return phase_functions.haze(floating(cosine), wavelengths)


def spread(values: np.ndarray, wavelengths: ArrayLike) -> Array:
    """Values (...,) repeated for each of the wavelengths, (..., W)."""
    values = floating(values)
    return values[..., None] * constant(np.ones(np.size(wavelengths)), values)
