"""A smooth sky's colours on a fine grid of the dome, for maps."""

from dataclasses import dataclass
from typing import ClassVar, Self

import numpy as np

from skydome.ground.arrays import Array
from skydome.ground.directions import azimuth, checked_directions, direction, elevation
from skydome.skies.colour_sky import ColourSky
from skydome.skies.sky import Sky
from skydome.skies.wrapped.wrapped_sky import WrappedSky

RINGS, COLUMNS = 129, 241
"""Heights, crowded at the horizon, and azimuths of the grid, the first again at the end."""


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

    @property
    def wrapped(self) -> Sky:
        """The sky that is held."""
        return self.sky

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction (..., 3), Y in cd m-2, shape (..., 3); 0 below the horizon."""
        views = np.asarray(checked_directions(directions))
        high, turn = np.maximum(np.asarray(elevation(views)), 0.0), np.asarray(azimuth(views))
        row = np.cbrt(high / (np.pi / 2)) * (RINGS - 1)
        column = turn / (2 * np.pi) * (COLUMNS - 1)
        i, j = (np.minimum(x.astype(np.int64), last) for x, last in ((row, RINGS - 2), (column, COLUMNS - 2)))
        a, b = (row - i)[..., None], (column - j)[..., None]
        upper = self.colours[i, j] * (1 - b) + self.colours[i, j + 1] * b
        lower = self.colours[i + 1, j] * (1 - b) + self.colours[i + 1, j + 1] * b
        return self.blanked(upper * (1 - a) + lower * a, views)


def grid() -> np.ndarray:
    """Directions of the grid, (RINGS, COLUMNS, 3)."""
    heights = np.linspace(0.0, 1.0, RINGS) ** 3 * np.pi / 2
    return np.asarray(direction(np.linspace(0.0, 2 * np.pi, COLUMNS)[None, :], heights[:, None]))
