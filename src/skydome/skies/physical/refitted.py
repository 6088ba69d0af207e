"""A fast sky for an atmosphere of one's own: the nine numbers fitted to a slow sky, by suns and wavelengths."""

from dataclasses import dataclass
from os import PathLike
from typing import Any, ClassVar

import numpy as np

from skydome.air.cross_sections import solar_irradiance
from skydome.ground.arguments import require_file
from skydome.ground.arrays import Array
from skydome.ground.directions import checked_directions, elevation
from skydome.ground.interpolation import cells, weights
from skydome.light.spectrum import checked_wavelengths
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.formula.perez_formula import evaluate, view_geometry
from skydome.skies.sky import SunlitSky

OFFSET = 0.01
"""What is added to cos t in the gradation, as Hosek and Wilkie have it."""


@dataclass(frozen=True, eq=False)
class Numbers:
    """R A ... I for sun elevations (E,), radians, and wavelengths (W,), nm: coefficients (E, W, 10), light in sr-1.

    `sun_scale` multiplies the sun's irradiance; `error` (E, W) is each fit's relative RMS error.
    """

    elevations: np.ndarray
    wavelengths: np.ndarray
    coefficients: np.ndarray
    error: np.ndarray
    sun_scale: float = 1.0

    def save(self, path: str | PathLike[str]) -> None:
        """Write to a .npz file, whole or not at all."""
        from skydome.ground.writing import appearing

        with appearing(path) as beside, beside.open("wb") as file:
            np.savez(file, **vars(self))

    @classmethod
    def load(cls, path: str | PathLike[str]) -> "Numbers":
        """From a .npz file; ValueError for a file that holds something else."""
        with np.load(require_file(path, "a refitted sky"), allow_pickle=False) as stored:
            missing = set(cls.__dataclass_fields__) - set(stored.files)
            if missing:
                raise ValueError(f"{path} holds no refitted sky: it lacks {', '.join(sorted(missing))}")
            held = {name: stored[name] for name in cls.__dataclass_fields__}
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
