"""The horizon as seen from one place: elevation by azimuth, from a table or from a model of the terrain."""

from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arguments import numbers, require_file
from skydome.ground.arrays import Array
from skydome.ground.directions import azimuth, checked_turn, elevation
from skydome.ground.units import EARTH_RADIUS, in_degrees
from skydome.surroundings.intervals import GROUND, SKY, Surroundings

HILLS = 0


@dataclass(frozen=True, eq=False)
class Horizon(Surroundings):
    """Hills or houses up to `elevations` (K,) at `azimuths` (K,), radians clockwise from north, linear in between.

    Below is face 0 down to the level, then ground. A profile closes on itself; one azimuth makes a level ring.
    ValueError for azimuths that repeat, or elevations outside [0, pi/2).

    >>> import skydome as sd
    >>> wall = sd.Horizon([0.0, 3.0, 3.1, 3.2, 3.3], [0.0, 0.0, 0.5, 0.5, 0.0])
    >>> round(float(wall.at(3.15)), 3), round(float(wall.at(6.0)), 3)
    (0.5, 0.0)
    """

    azimuths: Any
    elevations: Any

    def __post_init__(self) -> None:
        turn, height = (np.atleast_1d(numbers(part, name)) for name, part in vars(self).items())
        if turn.ndim != 1 or turn.shape != height.shape or turn.size == 0:
            raise ValueError(f"azimuths and elevations must have one shape (K,), got {turn.shape} and {height.shape}")
        if not (np.isfinite(turn).all() and np.isfinite(height).all()):
            raise ValueError("azimuths and elevations must be finite, got NaN or infinity")
        checked_turn(turn, "azimuths")
        if (height < 0).any() or (height >= np.pi / 2).any():
            worst = float(height[np.argmax(np.abs(height - np.pi / 4))])
            raise ValueError(f"elevations must lie in [0, 90) degrees, got {in_degrees(worst)}")
        turn = np.mod(turn, 2 * np.pi)
        order = np.argsort(turn, kind="stable")
        if (np.diff(turn[order]) <= 0).any():
            raise ValueError("azimuths must not repeat (360 degrees is 0 again)")
        object.__setattr__(self, "azimuths", turn[order])
        object.__setattr__(self, "elevations", height[order])

    @classmethod
    def level(cls, elevation: float) -> "Horizon":
        """A ring of one elevation, radians, all around."""
        return cls([0.0], [elevation])

    @classmethod
    def read(cls, path: "str | PathLike[str]") -> "Horizon":
        """The profile in a CSV file: rows of azimuth,elevation in degrees; a header line and # lines may be there.

        A row at 360 degrees that repeats the one at 0 is dropped. ValueError names the line that is wrong.
        """
        rows = numbered_rows(require_file(path, "a horizon's profile"))
        if not rows:
            raise ValueError(f"{Path(path).name} must have rows of azimuth,elevation in degrees, got none")
        if (360.0, dict(rows).get(0.0)) in rows:
            rows.remove((360.0, dict(rows)[0.0]))
        table = np.radians(np.array(rows))
        return cls(table[:, 0], table[:, 1])

    @classmethod
    def from_dem(
        cls,
        heights: ArrayLike,
        cell: float,
        row: int,
        column: int,
        *,
        above: float = 0.0,
        count: int = 360,
        curvature: bool = True,
    ) -> "Horizon":
        """The horizon from elevation data: `heights` (R, C) m, north up (row 0 northmost), square cells of `cell` m.

        Seen from the middle of cell (row, column), `above` m over its height, in `count` directions; terrain is
        bilinear, met at every half cell; the Earth's curvature lowers it by d^2 / 2R (no refraction). Sea level
        horizons below the level count as 0. ValueError for NaN, a viewpoint outside, or a cell not above 0.
        """
        data = checked_heights(heights, cell, row, column)
        eye = data[row, column] + above
        turn = np.arange(count) * (2 * np.pi / count)
        distance = np.arange(1, 2 * int(np.ceil(np.hypot(*data.shape))) + 1) * (cell / 2)
        rows = row - np.cos(turn)[:, None] * distance / cell
        columns = column + np.sin(turn)[:, None] * distance / cell
        drop = distance**2 / (2 * EARTH_RADIUS) if curvature else 0.0
        rise = (bilinear_height(data, rows, columns) - drop - eye) / distance
        slope = np.max(np.where(np.isnan(rise), 0.0, rise), axis=1, initial=0.0)
        return cls(turn, np.arctan(slope))

    def at(self, turn: Array) -> np.ndarray:
        """Elevation of the horizon toward azimuths (...,), radians."""
        height: np.ndarray = np.interp(turn, self.azimuths, self.elevations, period=2 * np.pi)
        return height

    def seen(self, directions: np.ndarray) -> np.ndarray:
        """SKY above the profile, face 0 from it down to the level, GROUND below."""
        free = elevation(directions) >= self.at(azimuth(directions))
        return np.where(directions[..., 2] < 0, GROUND, np.where(free, SKY, HILLS))


def numbered_rows(path: Path) -> list[tuple[float, float]]:
    """Pairs of numbers in a CSV file; ValueError names the first line that is none."""
    try:
        text = path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        raise ValueError(f"{path.name} must be a text file of azimuth,elevation in degrees, got other bytes") from None
    found: list[tuple[float, float]] = []
    for number, line in enumerate(text.splitlines(), 1):
        cells = [cell.strip() for cell in line.split(",")]
        header = not found and all(cell[:1].isalpha() for cell in cells)
        if line.strip() and not line.lstrip().startswith("#") and not header:
            found.append(pair(cells, f"{path.name}, line {number}"))
    return found


def pair(cells: list[str], where: str) -> tuple[float, float]:
    """Azimuth and elevation, degrees; ValueError that says where something else stands."""
    try:
        turn, height = (float(cell) for cell in cells)
    except ValueError:
        expected = "must be azimuth,elevation in degrees such as 90,12.5"
        raise ValueError(f"{where}: {expected}, got {','.join(cells)!r}") from None
    return turn, height


def checked_heights(heights: ArrayLike, cell: float, row: int, column: int) -> np.ndarray:
    """The elevation data as floats (R, C); ValueError for what cannot be."""
    data = np.asarray(heights, dtype=np.float64)
    if data.ndim != 2:
        raise ValueError(f"heights must have shape (rows, columns), got {data.shape}")
    if not np.isfinite(data).all():
        raise ValueError(f"heights must be finite, got {int((~np.isfinite(data)).sum())} cells without data; fill them")
    if not (np.isfinite(cell) and cell > 0):
        raise ValueError(f"cell must be a size above 0 m, got {cell}")
    if not (0 <= row < data.shape[0] and 0 <= column < data.shape[1]):
        raise ValueError(f"the viewpoint must lie inside {data.shape}, got row {row}, column {column}")
    return data


def bilinear_height(data: np.ndarray, rows: np.ndarray, columns: np.ndarray) -> np.ndarray:
    """Heights between cell middles, m; NaN outside the data."""
    outside = (rows < 0) | (rows > data.shape[0] - 1) | (columns < 0) | (columns > data.shape[1] - 1)
    i = np.clip(np.floor(rows).astype(int), 0, max(0, data.shape[0] - 2))
    j = np.clip(np.floor(columns).astype(int), 0, max(0, data.shape[1] - 2))
    down, right = rows - i, columns - j
    below, beside = np.minimum(i + 1, data.shape[0] - 1), np.minimum(j + 1, data.shape[1] - 1)
    top = data[i, j] * (1 - right) + data[i, beside] * right
    bottom = data[below, j] * (1 - right) + data[below, beside] * right
    return np.where(outside, np.nan, top * (1 - down) + bottom * down)
