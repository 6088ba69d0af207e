"""The light that gas and haze at the ground scatter toward a viewer: S1 and S2 of Preetham 1999, eq. 8.

deviation from the paper | here | why
sky and sun from above only | and, if asked for, light from a ground of an albedo | it brightens haze over snow or sand
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.ground.arrays import Array, constant, floating, namespace
from skydome.ground.directions import azimuth, zenith_angle
from skydome.ground.interpolation import catmull_rom_about
from skydome.ground.quadrature import hemisphere
from skydome.haze.ground_air import GroundAir

RINGS, COLUMNS = 32, 64
"""Nodes of the sky's quadrature: zenith angles and azimuths."""

ZENITHS, AZIMUTHS = 37, 24
"""Grid of the table: every 5 degrees from zenith to nadir, every 15 degrees around."""


@dataclass(frozen=True, eq=False)
class Sources:
    """Light by direction: where from (N, 3), and how much haze and gas scatter in all, m-1 times light, (N, C) each.

    `wavelengths` (C,): at which the phase function of the `air`'s haze is taken for each channel.
    """

    directions: Array
    haze: Array
    gas: Array
    wavelengths: np.ndarray
    air: GroundAir

    def toward(self, views: Array) -> tuple[Array, Array]:
        """S1 and S2 of a viewer who looks along `views` (..., 3), light per metre, each (..., C)."""
        views = floating(views)
        sources, haze, gas = (constant_or_own(part, views) for part in (self.directions, self.haze, self.gas))
        cosines = views @ sources.T
        xp = namespace(views)
        first = xp.sum(self.air.haze_phase(cosines, self.wavelengths) * haze, axis=-2)
        return first, self.air.gas_phase(cosines) @ gas

    def in_parts(self, views: np.ndarray, size: int = 128) -> tuple[np.ndarray, np.ndarray]:
        """The same for many views (D, 3), in NumPy, a few at a time to save memory."""
        found = [self.toward(views[k : k + size]) for k in range(0, len(views), size)]
        return np.concatenate([part[0] for part in found]), np.concatenate([part[1] for part in found])


@dataclass(frozen=True, eq=False)
class LightTable:
    """S1 and S2 of the sky on a grid of views (ZENITHS, AZIMUTHS, 2 C), read by Catmull-Rom cubics (error .2 %)."""

    values: np.ndarray

    @classmethod
    def of(cls, sources: Sources) -> "LightTable":
        """The table of these sources."""
        zenith, around = np.linspace(0, np.pi, ZENITHS), np.arange(AZIMUTHS) * (2 * np.pi / AZIMUTHS)
        level = np.sin(zenith)[:, None]
        up = np.broadcast_to(np.cos(zenith)[:, None], (ZENITHS, AZIMUTHS))
        views = np.stack([level * np.sin(around), level * np.cos(around), up], axis=-1)
        found = np.concatenate(sources.in_parts(views.reshape(-1, 3)), axis=-1)
        return cls(over_the_poles(found.reshape(ZENITHS, AZIMUTHS, -1)))

    def toward(self, views: Array) -> tuple[Array, Array]:
        """S1 and S2 of views (..., 3), each (..., C)."""
        row, rows = catmull_rom_about(ZENITHS - 1, zenith_angle(views) * ((ZENITHS - 1) / np.pi))
        column, columns = catmull_rom_about(AZIMUTHS, azimuth(views) * (AZIMUTHS / (2 * np.pi)))
        table = constant_or_own(self.values, views)
        total: Array = 0.0
        for i in range(4):
            line: Array = 0.0
            for j in range(4):
                line = line + columns[j][..., None] * table[row + i, (column + j - 1) % AZIMUTHS]
            total = total + rows[i][..., None] * line
        half = self.values.shape[-1] // 2
        return total[..., :half], total[..., half:]


def over_the_poles(values: np.ndarray) -> np.ndarray:
    """A grid with a row more at either end: beyond a pole lies the other side."""
    other = np.roll(values, AZIMUTHS // 2, axis=1)
    return np.concatenate([other[1:2], values, other[-2:-1]])


def sky_nodes() -> tuple[np.ndarray, np.ndarray]:
    """Directions (N, 3) of the upper hemisphere and their solid angles (N,), sr."""
    return hemisphere(RINGS, COLUMNS)


def with_ground(directions: np.ndarray, light: Array, solid_angles: np.ndarray, flux: Array) -> tuple[Any, Array, Any]:
    """Nodes above and, mirrored, below, where a grey ground sends back the light `flux` / pi, (C,), all ways."""
    xp = namespace(light)
    below = xp.zeros_like(light) + flux / np.pi
    both = np.concatenate([directions, directions * np.array([1.0, 1.0, -1.0])])
    return both, xp.concat([light, below], axis=0), np.concatenate([solid_angles, solid_angles])


def constant_or_own(values: Any, like: Array) -> Array:
    """NumPy values in the library and dtype of `like`; an array of another library as it is."""
    return constant(values, like) if isinstance(values, np.ndarray) else values
