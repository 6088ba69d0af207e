"""Models that turn diffuse horizontal irradiance into that on a tilted plane in the open, beside our own skies.

model | the sky | source
`FromPatches` | the year's own patches, Perez 1993; knows obstructions | Perez, Seals and Michalsky 1993
`IsotropicSky` | uniform | Liu and Jordan 1961
`HayDavies` | uniform, and a share at the sun | Hay and Davies 1980
`Perez1990` | uniform, a share at the sun, one along the horizon, by bins of clearness | Perez et al. 1990, eq. 9
`PerezDriesse` | the same with splines for the bins | Driesse, Jensen and Perez 2024
"""

from abc import ABC, abstractmethod
from typing import ClassVar, NamedTuple

import numpy as np

from skydome.ground.arguments import require_word
from skydome.ground.directions import zenith_angle
from skydome.ground.tables import columns
from skydome.skies.formula.perez_table import brightness, clearness, clearness_bin

LOWEST_SINE = float(np.cos(np.radians(85.0)))
"""The sun's sine of elevation in the circumsolar ratio, at least (Perez et al. 1990, eq. 11)."""

HAY_DAVIES_LOWEST = 0.01745
"""The same in the ratio Rb of Hay and Davies, as pvlib takes it."""

HIGHEST_F1 = 0.9
"""Circumsolar share at most (Driesse, Jensen and Perez 2024)."""

LETTERS = ("F11", "F12", "F13", "F21", "F22", "F23")
SPLINE = "perez_driesse_2024"


class Hours(NamedTuple):
    """K hours with the sun up: `suns` (K, 3), irradiances, W m-2, and `luminance` (K, N) of patches, cd m-2.

    `level` (K,), lx, is the illuminance of these patches on the horizontal.
    """

    suns: np.ndarray
    direct: np.ndarray
    diffuse: np.ndarray
    extraterrestrial: np.ndarray
    luminance: np.ndarray
    level: np.ndarray


class Transposition(ABC):
    """A model of the diffuse light on tilted planes: `name` as on the command line."""

    name: ClassVar[str]
    obstructions: ClassVar[bool] = False

    @abstractmethod
    def shares(self, hours: Hours, normals: np.ndarray, weights: np.ndarray) -> np.ndarray:
        """Diffuse light from the sky on planes with `normals` (P, 3), over that on the horizontal, (K, P).

        `weights` (N, P), sr, are what the planes see of the sky's patches.
        """


class FromPatches(Transposition):
    """The sky as the year has it, patch by patch: what hides a part of it takes that part's light."""

    name = "perez-1993"
    obstructions = True

    def shares(self, hours: Hours, normals: np.ndarray, weights: np.ndarray) -> np.ndarray:
        """The patches' light on the planes; 0 without light."""
        falling = hours.luminance @ weights.astype(hours.luminance.dtype)
        level = hours.level[:, None]
        found: np.ndarray = np.divide(falling, level, out=np.zeros_like(falling), where=level > 0).astype(np.float64)
        return found


class IsotropicSky(Transposition):
    """A uniform sky: (1 + cos tilt) / 2.

    >>> hours = Hours(*[np.ones((1, 3))] * 6)
    >>> IsotropicSky().shares(hours, np.array([[0.0, -1.0, 0.0]]), np.zeros((1, 1))).tolist()
    [[0.5]]
    """

    name = "isotropic"

    def shares(self, hours: Hours, normals: np.ndarray, weights: np.ndarray) -> np.ndarray:
        """The same for every hour."""
        return np.repeat((1 + normals[None, :, 2]) / 2, len(hours.suns), axis=0)


class HayDavies(Transposition):
    """A share of the diffuse light comes from the sun's direction: as much as the air lets through of direct light."""

    name = "hay-davies"

    def shares(self, hours: Hours, normals: np.ndarray, weights: np.ndarray) -> np.ndarray:
        """A Rb + (1 - A) (1 + cos tilt) / 2."""
        through = (hours.direct / hours.extraterrestrial)[:, None]
        ratio = np.maximum(hours.suns @ normals.T, 0) / np.maximum(hours.suns[:, 2:], HAY_DAVIES_LOWEST)
        found: np.ndarray = through * ratio + (1 - through) * (1 + normals[:, 2]) / 2
        return found


class Perez1990(Transposition):
    """Perez's anisotropic sky of 1990: a point at the sun, a line along the horizon, the rest uniform."""

    name = "perez-1990"

    def shares(self, hours: Hours, normals: np.ndarray, weights: np.ndarray) -> np.ndarray:
        """(1 - F1) (1 + cos tilt) / 2 + F1 a / b + F2 sin tilt, at least 0 (Perez et al. 1990, eq. 9)."""
        circumsolar, horizon = (factor[:, None] for factor in self.brightening(hours))
        ratio = np.maximum(hours.suns @ normals.T, 0) / np.maximum(hours.suns[:, 2:], LOWEST_SINE)
        level = normals[:, 2]
        slope = np.sqrt(np.maximum(1 - level**2, 0))
        found: np.ndarray = (1 - circumsolar) * (1 + level) / 2 + circumsolar * ratio + horizon * slope
        held: np.ndarray = np.maximum(found, 0)
        return held

    def brightening(self, hours: Hours) -> tuple[np.ndarray, np.ndarray]:
        """F1 and F2, (K,) each: c1 + c2 Delta + c3 Z."""
        zenith = zenith_angle(hours.suns)
        epsilon = clearness(hours.direct, hours.diffuse, zenith)
        delta = brightness(hours.diffuse, zenith, hours.extraterrestrial)
        f = self.coefficients(epsilon)
        first, second = (f[:, k] + f[:, k + 1] * delta + f[:, k + 2] * zenith for k in (0, 3))
        return np.maximum(first, 0), second

    def coefficients(self, epsilon: np.ndarray) -> np.ndarray:
        """F11 ... F23 of each clearness, (K, 6)."""
        table = columns("perez_1990_transposition")
        return np.stack([table[letter] for letter in LETTERS], axis=-1)[clearness_bin(epsilon)]


class PerezDriesse(Perez1990):
    """Perez's sky of 1990 without jumps between bins."""

    name = "perez-driesse"

    def brightening(self, hours: Hours) -> tuple[np.ndarray, np.ndarray]:
        """F1, at most 0.9, and F2."""
        first, second = super().brightening(hours)
        return np.minimum(first, HIGHEST_F1), second

    def coefficients(self, epsilon: np.ndarray) -> np.ndarray:
        """The splines at zeta = 1 - 1 / clearness."""
        table = columns(SPLINE)
        knots = np.concatenate([np.zeros(3), table["knot"]])
        bases = quadratic_bases(1 - 1 / epsilon, knots)
        found: np.ndarray = bases @ np.stack([table[letter] for letter in LETTERS], axis=-1)
        return found


def quadratic_bases(x: np.ndarray, knots: np.ndarray) -> np.ndarray:
    """Quadratic B-splines over `knots` (M + 3,) at x (K,) in [0, 1], (K, M), by Cox and de Boor's recursion.

    >>> quadratic_bases(np.array([0.0, 0.5]), np.array([0, 0, 0, 1, 1, 1.0])).tolist()
    [[1.0, 0.0, 0.0], [0.25, 0.5, 0.25]]
    """
    held = np.clip(x, knots[0], np.nextafter(knots[-1], 0))[:, None]
    bases: np.ndarray = ((held >= knots[:-1]) & (held < knots[1:])).astype(np.float64)
    for degree in (1, 2):
        start, end = knots[: -degree - 1], knots[degree + 1 :]
        rise, fall = knots[degree:-1] - start, end - knots[1:-degree]
        up = np.divide(held - start, rise, out=np.zeros((len(x), len(start))), where=rise > 0)
        down = np.divide(end - held, fall, out=np.zeros((len(x), len(start))), where=fall > 0)
        bases = up * bases[:, :-1] + down * bases[:, 1:]
    return bases


TRANSPOSITIONS = {kind.name: kind() for kind in (FromPatches, IsotropicSky, HayDavies, Perez1990, PerezDriesse)}


def transposition_named(name: "str | Transposition") -> Transposition:
    """The model of that name; ValueError that lists them for another."""
    if isinstance(name, Transposition):
        return name
    return TRANSPOSITIONS[require_word(name, TRANSPOSITIONS, "transposition")]
