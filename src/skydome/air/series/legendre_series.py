"""The phase law of a series of Legendre moments at some wavelengths."""

from dataclasses import dataclass
from functools import cached_property
from hashlib import sha256
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from skydome.air.phase_laws import PhaseLaw
from skydome.air.series.angle_table import AngleTable
from skydome.air.series.legendre import series_sum
from skydome.ground.arguments import numbers
from skydome.ground.arrays import Array, floating
from skydome.ground.limits.ranges import FINITE
from skydome.light.spectrum import Spectrum


@dataclass(frozen=True, eq=False, repr=False)
class LegendreSeries(PhaseLaw):
    """A phase function as its Legendre moments (L, W) at `wavelengths` (W,), nm, the first of each 1.

    p(cos) = sum of (2 l + 1) chi_l P_l(cos) / (4 pi), so that its integral is 1 to rounding. The moments are linear
    between the wavelengths and held outside. ValueError unless the first moments are 1 and p is not negative.
    `polarising`: moments (L, W) of `polarised`; None: light scattered once is unpolarised.

    >>> law = LegendreSeries([550.0], [[1.0], [0.0], [0.1]])     # Rayleigh's
    >>> law.value(np.array([1.0]), [550.0]).round(4).tolist() == [[round(3 / (8 * np.pi), 4)]]
    True
    """

    wavelengths: Any
    series: Any
    polarising: Any = None
    bounds: ClassVar = dict.fromkeys(("wavelengths", "series", "polarising"), FINITE)
    wavelengths_alike: ClassVar[bool] = False

    def __post_init__(self) -> None:
        known = Spectrum(self.wavelengths, self.series)
        if known.values.ndim != 2 or len(known.values) < 2:
            raise ValueError(f"a series must have shape (L, W) with L >= 2, got {known.values.shape}")
        if not np.allclose(known.values[0], 1.0, rtol=0, atol=1e-9):
            raise ValueError(f"the first moment must be 1, got {known.values[0].tolist()}")
        object.__setattr__(self, "wavelengths", known.wavelengths)
        object.__setattr__(self, "series", known.values)
        least = series_sum(known.values, np.cos(np.linspace(0, np.pi, 361))).min()
        if least < 0:
            raise ValueError(f"a phase function must not be negative, got {least:.3g} sr-1 by its moments")

    def __repr__(self) -> str:
        """Tells different series apart, however long."""
        mark = sha256(self.wavelengths.tobytes() + self.series.tobytes()).hexdigest()[:16]
        return f"LegendreSeries({len(self.series)} moments at {self.wavelengths.size} wavelengths, {mark})"

    def value(self, cosine: ArrayLike, wavelengths: ArrayLike) -> Array:
        """The series' sum, by a table of the angle: within 1e-4 of itself."""
        return self.table.at(floating(cosine), np.atleast_1d(numbers(wavelengths, "wavelengths")))

    def polarised(self, cosine: ArrayLike, wavelengths: ArrayLike) -> Array:
        """The sum of the other series."""
        if self.polarising is None:
            return super().polarised(cosine, wavelengths)
        return self.polarised_table.at(floating(cosine), np.atleast_1d(numbers(wavelengths, "wavelengths")))

    @property
    def straight_between(self) -> np.ndarray:
        """The wavelengths of its moments."""
        return np.asarray(self.wavelengths)

    @cached_property
    def table(self) -> AngleTable:
        """The phase function at even angles."""
        return AngleTable.of_series(self.wavelengths, self.series)

    @cached_property
    def polarised_table(self) -> AngleTable:
        """What is polarised, at even angles."""
        return AngleTable.of_series(self.wavelengths, np.asarray(self.polarising))

    def moments(self, count: int, wavelengths: ArrayLike) -> Array:
        """The moments, 0 beyond the series' end."""
        there = Spectrum(self.wavelengths, self.series[:count]).at(np.atleast_1d(numbers(wavelengths, "wavelengths")))
        return np.concatenate([there, np.zeros((count - len(there), there.shape[1]))])
