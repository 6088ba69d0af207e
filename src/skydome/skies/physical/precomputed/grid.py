"""The grid of the tables: Bruneton's maps between heights, views and suns and places in a table (2017 revision).

`rho` is the distance to the horizon, `H` its greatest, d distances along a ray; places x lie in [0, 1], from the
first texel's centre to the last's. Views are two halves: those that meet the ground, then those that do not.
"""

from dataclasses import dataclass

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.rays import columns_out
from skydome.ground.arrays import Array
from skydome.ground.limits.ranges import Range, require

LEAST = Range(4, 1024)


@dataclass(frozen=True)
class Sizes:
    """How many texels tables have: of scattering (heights, views, suns, angles), transmittance, and irradiance.

    The published ones are (32, 128, 32, 8), (64, 256), (16, 64). `directions`: of the sphere, half as many rings.
    """

    heights: int = 24
    views: int = 96
    suns: int = 64
    angles: int = 12
    transmittance: tuple[int, int] = (64, 256)
    irradiance: tuple[int, int] = (16, 64)
    directions: int = 48
    samples: int = 32

    def __post_init__(self) -> None:
        for name in ("heights", "views", "suns", "angles", "directions", "samples"):
            require(name, getattr(self, name), LEAST)
        if self.views % 2:
            raise ValueError(f"views must be even, got {self.views}")


PUBLISHED = Sizes(32, 128, 32, 8)
"""The texels of Bruneton's demo and three-geospatial."""
SMALL = Sizes(12, 24, 24, 6, (32, 64), (4, 32), 16, 16)
"""For a first look, in a second: errors of 3 % by day and a quarter at -4 degrees."""
MIDDLE = Sizes(16, 48, 40, 8, directions=32, samples=24)
"""For a picture."""


@dataclass(frozen=True)
class Shell:
    """A shell of air between two radii, m, and the cosine of the lowest sun's zenith angle in its tables."""

    bottom: float
    top: float
    lowest_sun: float

    @property
    def H(self) -> float:
        """The longest distance to the horizon, seen from the top."""
        return float(np.sqrt(self.top**2 - self.bottom**2))

    def radius(self, x: Array) -> Array:
        """Radius of places of height, from the ground to the top."""
        return np.clip(np.sqrt((self.H * np.asarray(x)) ** 2 + self.bottom**2), self.bottom, self.top)

    def rho(self, r: Array) -> Array:
        """Distance to the horizon from a radius."""
        return np.sqrt(np.maximum(np.asarray(r) ** 2 - self.bottom**2, 0.0))

    def view_above(self, r: Array, x: Array) -> Array:
        """Cosine of views that do not meet the ground, from the zenith (0) to the horizon (1)."""
        rho, least = self.rho(r), self.top - np.asarray(r)
        d = least + np.asarray(x) * (rho + self.H - least)
        mu = (self.H**2 - rho**2 - d**2) / np.maximum(2 * np.asarray(r) * d, 1e-300)
        return np.where(d > 0, np.clip(mu, -1.0, 1.0), 1.0)

    def view_below(self, r: Array, x: Array) -> Array:
        """Cosine of views that meet the ground, from straight down (0) to the horizon (1)."""
        rho, least = self.rho(r), np.asarray(r) - self.bottom
        d = least + np.asarray(x) * (rho - least)
        mu = -(rho**2 + d**2) / np.maximum(2 * np.asarray(r) * d, 1e-300)
        return np.where(d > 0, np.clip(mu, -1.0, 1.0), -1.0)

    def sun(self, x: Array) -> Array:
        """Cosine of the sun's zenith angle, from the lowest (0) to the zenith (1)."""
        least, lowest = self.top - self.bottom, self.share_of_sun(self.lowest_sun)
        a = lowest * (1 - np.asarray(x)) / (1 + np.asarray(x) * lowest)
        d = least + a * (self.H - least)
        return np.clip((self.H**2 - d**2) / (2 * self.bottom * d), -1.0, 1.0)

    def share_of_sun(self, cos_sun: float) -> float:
        """The measure `a` of a sun: 0 at the zenith, 1 at the horizon, more below."""
        least = self.top - self.bottom
        return float((distance_to_top(self, self.bottom, cos_sun) - least) / (self.H - least))


def distance_to_top(shell: Shell, r: Array, mu: Array) -> Array:
    """Length of a ray to the top, m."""
    inside = np.asarray(r) ** 2 * (np.asarray(mu) ** 2 - 1) + shell.top**2
    return np.asarray(np.maximum(-np.asarray(r) * mu + np.sqrt(np.maximum(inside, 0.0)), 0.0))


def shell_of(air: Atmosphere, lowest_sun: float) -> Shell:
    """The shell that an atmosphere fills."""
    return Shell(float(air.radius), float(air.radius + air.height), lowest_sun)


def views(shell: Shell, radii: np.ndarray, count: int) -> np.ndarray:
    """Cosines of all views from radii (R,), (R, count): horizon to straight down, then zenith to horizon."""
    x = np.linspace(0, 1, count // 2)
    below, above = shell.view_below(radii[:, None], x[::-1]), shell.view_above(radii[:, None], x)
    return np.ascontiguousarray(np.concatenate([below, above], axis=1))


def columns(air: Atmosphere, shell: Shell, sizes: tuple[int, int]) -> np.ndarray:
    """Columns of each constituent from radii (rows) toward views that miss the ground (columns), (K, rows, columns)."""
    rows, across = sizes
    r = shell.radius(np.linspace(0, 1, rows))[:, None]
    mu = shell.view_above(r, np.linspace(0, 1, across))
    radius = np.broadcast_to(r, mu.shape)
    return np.asarray(columns_out(air, radius.ravel(), mu.ravel())).reshape(-1, rows, across)
