"""A smooth sky's colours on a fine grid of the dome, for maps."""

from dataclasses import dataclass
from functools import cache, cached_property
from typing import ClassVar, Self

import numpy as np

from skydome.ground.arrays import Array
from skydome.ground.directions import azimuth, checked_directions, direction, elevation
from skydome.ground.quadrature import hemisphere
from skydome.skies.colour_sky import ColourSky
from skydome.skies.sky import Sky
from skydome.skies.wrapped.wrapped_sky import WrappedSky

RINGS, COLUMNS = 129, 241
"""Heights, crowded at the horizon, and azimuths of the grid, the first again at the end."""

NODES = (24, 48)
"""Rings and columns on which the light on the horizontal is summed."""


@dataclass(frozen=True, eq=False)
class HeldDome(WrappedSky, ColourSky):
    """The colours (RINGS, COLUMNS, 3) of a sky, linear between: 99 % within 1.5 % of the sky itself (tested)."""

    sky: ColourSky
    colours: np.ndarray
    shines_at_night: ClassVar[bool] = True

    @classmethod
    def of(cls, sky: ColourSky) -> Self:
        """The table of a sky."""
        return cls(sky, np.asarray(sky.xyz(grid()), np.float32))

    @cached_property
    def on_level(self) -> np.ndarray:
        """XYZ of the light on the horizontal, Y in lx, (3,): within 0.5 % (tested)."""
        nodes, angles = hemisphere(*NODES)
        return np.asarray((angles * nodes[:, 2]) @ self.xyz(nodes))

    @property
    def wrapped(self) -> Sky:
        """The sky that is held."""
        return self.sky

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction (..., 3), Y in cd m-2, shape (..., 3); 0 below the horizon."""
        views = np.asarray(checked_directions(directions))
        high, turn = np.maximum(np.asarray(elevation(views)), 0.0), np.asarray(azimuth(views))
        (i, a), (j, b) = rings_at(high), columns_at(turn)
        upper = self.colours[i, j] * (1 - b) + self.colours[i, j + 1] * b
        lower = self.colours[i + 1, j] * (1 - b) + self.colours[i + 1, j + 1] * b
        return self.blanked(upper * (1 - a) + lower * a, views)


def rings_at(elevation: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The ring below elevations (...,), rad, and how far on to the next they lie, (..., 1)."""
    return between(np.cbrt(elevation / (np.pi / 2)) * (RINGS - 1), RINGS - 2)


def columns_at(azimuth: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The column before azimuths (...,), 0 to 2 pi, and how far on to the next they lie, (..., 1)."""
    return between(azimuth / (2 * np.pi) * (COLUMNS - 1), COLUMNS - 2)


def between(place: np.ndarray, last: int) -> tuple[np.ndarray, np.ndarray]:
    """The node before places (...,), `last` at most, and what is left, (..., 1)."""
    node = np.minimum(place.astype(np.int64), last)
    return node, (place - node)[..., None]


@cache
def grid() -> np.ndarray:
    """Directions of the grid, (RINGS, COLUMNS, 3)."""
    heights = np.linspace(0.0, 1.0, RINGS) ** 3 * np.pi / 2
    return np.asarray(direction(np.linspace(0.0, 2 * np.pi, COLUMNS)[None, :], heights[:, None]))
