"""A fast sky for an atmosphere of one's own: the nine numbers fitted to a slow sky, by suns and wavelengths."""

from dataclasses import dataclass, fields
from os import PathLike
from typing import Any, ClassVar

import numpy as np

from skydome.air.cross_sections import solar_irradiance
from skydome.ground.arrays import Array
from skydome.ground.directions import checked_directions, elevation
from skydome.ground.files.reading import arrays_in, decoding
from skydome.ground.interpolation import cells, weights
from skydome.ground.limits.ranges import FINITE, NOT_NEGATIVE, Bounded, Range
from skydome.light.spectrum import checked_wavelengths
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.formula.perez_formula import evaluate, view_geometry
from skydome.skies.sky import SunlitSky

OFFSET = 0.01
"""What is added to cos t in the gradation, as Hosek and Wilkie have it."""

MOST_BYTES = 256 * 2**20
"""Size, unpacked, above which a file is refused."""


@dataclass(frozen=True, eq=False)
class Numbers(Bounded):
    """R A ... I for sun elevations (E,), radians, and wavelengths (W,), nm: coefficients (E, W, 10), light in sr-1.

    `sun_scale` multiplies the sun's irradiance; `error` (E, W) is each fit's relative RMS error.
    """

    elevations: np.ndarray
    wavelengths: np.ndarray
    coefficients: np.ndarray
    error: np.ndarray
    sun_scale: float = 1.0
    bounds: ClassVar = {
        "elevations": Range(-np.pi / 2, np.pi / 2, "rad"),
        "wavelengths": Range(1.0, 1e5, "nm"),
        "coefficients": FINITE,
        "sun_scale": NOT_NEGATIVE,
    }

    def __post_init__(self) -> None:
        """Validate only."""
        self.require_bounds()
        counts = np.shape(self.elevations) + np.shape(self.wavelengths)
        if np.shape(self.coefficients) != (*counts, 10) or np.shape(self.error) != counts or len(counts) != 2:
            raise ValueError(
                f"coefficients of a refitted sky must be {(*counts, 10)}, got {np.shape(self.coefficients)}"
            )
        for name in ("elevations", "wavelengths"):
            if not np.size(getattr(self, name)) or (np.diff(getattr(self, name)) <= 0).any():
                raise ValueError(f"{name} of a refitted sky must be rising")

    def save(self, path: str | PathLike[str]) -> None:
        """Write to a .npz file, whole or not at all."""
        from skydome.ground.writing import appearing

        with appearing(path) as beside, beside.open("wb") as file:
            np.savez(file, **vars(self))

    @classmethod
    def load(cls, path: str | PathLike[str]) -> "Numbers":
        """From a .npz file; ValueError for a file that holds something else."""
        held: dict[str, Any] = dict(arrays_in(path, "a refitted sky", {item.name for item in fields(cls)}, MOST_BYTES))
        with decoding(path, "a refitted sky"):
            return cls(**(held | {"sun_scale": float(held["sun_scale"])}))


@dataclass(frozen=True, eq=False)
class Refitted(SunlitSky, SpectralSky):
    """The sky of `numbers` (`skydome.own_air.refit.refitted` makes them), for any sun between the elevations fitted.

    Between two suns fitted, the light of both formulas, linear in elevation; between two wavelengths, linear in the
    logarithm. A sun below the least elevation fitted is taken as standing at it (`valid` is False there).
    """

    numbers: Numbers
    source: ClassVar[str] = "Hosek and Wilkie 2012, eq. 8, fitted to a physical sky"

    @property
    def valid(self) -> Array:
        """True where the sun stands between the elevations fitted."""
        height = elevation(np.asarray(self.sun, dtype=np.float64))
        low, high = self.numbers.elevations[[0, -1]]
        return (height >= low - 1e-9) & (height <= high + 1e-9)

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction (..., 3) at wavelengths (W,), W m-2 sr-1 nm-1, shape (..., W)."""
        directions = checked_directions(np.asarray(directions, dtype=np.float64))
        w, sun = checked_wavelengths(wavelengths), np.asarray(self.sun, dtype=np.float64)
        known = self.numbers.wavelengths
        if w[0] < known[0] or w[-1] > known[-1]:
            raise ValueError(f"wavelengths must lie in [{known[0]:g}, {known[-1]:g}] nm, got {w[0]:g} to {w[-1]:g}")
        light = np.log(np.maximum(self.transfer(directions, sun), 1e-12))
        between = np.exp(light @ weights(known, w).T)
        return self.blanked(between * solar_irradiance(w) * self.numbers.sun_scale, directions)

    def transfer(self, directions: np.ndarray, sun: np.ndarray) -> Array:
        """Light for a sun of irradiance 1 at the wavelengths fitted, sr-1, shape (..., W)."""
        heights = self.numbers.elevations
        place = np.clip(elevation(sun), heights[0], heights[-1])
        lower, share = cells(heights, place)
        share = share[..., None]
        cosine, angle = view_geometry(directions, sun)
        low, high = (
            evaluate(self.numbers.coefficients[k], cosine, angle, OFFSET, floor=OFFSET) for k in (lower, lower + 1)
        )
        return low * (1 - share) + high * share
