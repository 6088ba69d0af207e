"""The sky cut into patches: Tregenza's 145, Reinhart's finer ones, and patches of equal area, in Radiance's order."""

import re
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array, as_numpy
from skydome.ground.directions import azimuth, direction, elevation
from skydome.ground.quadrature import gauss_legendre
from skydome.ground.tables import columns

NAMES = "tregenza, reinhart:N or equal-area:N with N from 1 to 12"
FINEST = 12


@dataclass(frozen=True, eq=False)
class Patches:
    """Patches of the sky, N of them, in rows from the horizon up; the last row is one round patch at the zenith.

    `edges` (R + 1,) are the elevations of the rows' bounds, radians, from 0 to pi / 2; `counts` (R,) the patches in
    each row. In a row the first patch is centred on north and the next lies clockwise, to the east: Radiance's order
    (its patch 0, the ground, is not counted here).

    >>> sky = tregenza()
    >>> sky.count, round(float(sky.solid_angles.sum() / (2 * np.pi)), 12)
    (145, 1.0)
    """

    name: str
    edges: np.ndarray
    counts: np.ndarray

    def __post_init__(self) -> None:
        rises = np.all(np.diff(self.edges) > 0) and self.edges[0] == 0 and np.isclose(self.edges[-1], np.pi / 2)
        if not rises or len(self.edges) != len(self.counts) + 1 or self.counts[-1] != 1:
            raise ValueError("edges must rise from 0 to pi / 2 around rows of which the last has 1 patch")

    @property
    def count(self) -> int:
        """How many patches there are."""
        return int(self.counts.sum())

    @cached_property
    def row(self) -> np.ndarray:
        """Row of each patch, 0 at the horizon, (N,)."""
        return np.repeat(np.arange(len(self.counts)), self.counts)

    @cached_property
    def starts(self) -> np.ndarray:
        """Index of the first patch of each row, (R,)."""
        first: np.ndarray = np.concatenate([[0], np.cumsum(self.counts)[:-1]])
        return first

    @cached_property
    def widths(self) -> np.ndarray:
        """Extent of each patch in azimuth, radians, (N,)."""
        widths: np.ndarray = 2 * np.pi / self.counts[self.row]
        return widths

    @cached_property
    def azimuths(self) -> np.ndarray:
        """Azimuth of each centre, radians clockwise from north, (N,)."""
        centres: np.ndarray = (np.arange(self.count) - self.starts[self.row]) * self.widths
        return centres

    @cached_property
    def elevations(self) -> np.ndarray:
        """Elevation of each centre, radians, midway between its row's edges; pi / 2 for the zenith's. (N,)."""
        middle = (self.edges[:-1] + self.edges[1:]) / 2
        centres: np.ndarray = np.concatenate([middle[:-1], [np.pi / 2]])[self.row]
        return centres

    @cached_property
    def directions(self) -> np.ndarray:
        """Unit vectors toward the centres, (N, 3)."""
        centres: np.ndarray = direction(self.azimuths, self.elevations)
        return centres

    @cached_property
    def solid_angles(self) -> np.ndarray:
        """Solid angle of each patch, sr, (N,); they add up to 2 pi."""
        sines = np.sin(self.edges)
        sizes: np.ndarray = (sines[1:] - sines[:-1])[self.row] * self.widths
        return sizes

    @cached_property
    def horizontal_solid_angles(self) -> np.ndarray:
        """Integral of the sine of the elevation over each patch, sr, (N,): weights of horizontal illuminance."""
        squares = np.sin(self.edges) ** 2
        sizes: np.ndarray = (squares[1:] - squares[:-1])[self.row] / 2 * self.widths
        return sizes

    @property
    def bounds(self) -> np.ndarray:
        """Lowest and highest elevation, first and last azimuth of each patch, radians, (N, 4)."""
        half = self.widths / 2
        low, high = self.edges[self.row], self.edges[self.row + 1]
        return np.stack([low, high, self.azimuths - half, self.azimuths + half], axis=-1)

    def samples(
        self, rings: int = 2, columns: int = 2, which: np.ndarray | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        """Directions (N, S, 3) inside each patch and their weights (N, S), which add up to 1; S = rings x columns.

        Gauss nodes in the sine of the elevation and in azimuth: `(light * weights).sum(-1)` is the mean over the
        patch. Exact for light that is a polynomial of degree 2 x rings - 1 in the sine of the elevation. `which`,
        indices, asks for some of the patches only.
        """
        t, step = gauss_legendre(rings)
        s, share = gauss_legendre(columns)
        bounds = self.bounds if which is None else self.bounds[which]
        low, high, first, last = (column[:, None, None] for column in bounds.T)
        sine = np.sin(low) + (np.sin(high) - np.sin(low)) * t[:, None]
        turn = first + (last - first) * s
        directions = direction(turn, np.arcsin(np.minimum(sine, 1.0)))
        weights = np.broadcast_to(step[:, None] * share, directions.shape[:-1])
        return directions.reshape(len(bounds), -1, 3), weights.reshape(len(bounds), -1).copy()

    def index(self, directions: Array) -> np.ndarray:
        """Index of the patch in which each direction (..., 3) lies, shape (...,); -1 below the horizon.

        >>> tregenza().index(np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])).tolist()
        [0, 144, -1]
        """
        v = as_numpy(directions)
        height = elevation(v)
        row = np.clip(np.searchsorted(self.edges, height, side="right") - 1, 0, len(self.counts) - 1)
        columns = self.counts[row]
        column = np.floor(azimuth(v) / (2 * np.pi) * columns + 0.5).astype(np.int64) % columns
        found: np.ndarray = np.where(height < 0, -1, self.starts[row] + column)
        return found


def reinhart(division: int = 1) -> Patches:
    """Reinhart's patches MF:n: each of Tregenza's cut in n x n, 144 n^2 + 1 of them (reinhart.cal).

    >>> reinhart(4).count
    2305
    """
    counts = reinhart_counts(division)
    step = np.pi / 2 / (len(counts) - 0.5)
    edges = np.append(np.arange(len(counts)) * step, np.pi / 2)
    return Patches(f"reinhart:{division}", edges, counts)


def reinhart_counts(division: int) -> np.ndarray:
    """Patches in each row of Reinhart's MF:n, the zenith's 1 last; ValueError for n outside 1-12."""
    if division != int(division) or not 1 <= division <= FINEST:
        raise ValueError(f"patches must be {NAMES}, got N = {division}")
    return np.append(np.repeat(columns("tregenza")["patches"].astype(np.int64), division) * division, 1)


def tregenza() -> Patches:
    """Tregenza's 145 patches, which are Reinhart's MF:1."""
    plain = reinhart(1)
    return Patches("tregenza", plain.edges, plain.counts)


def equal_area(division: int = 1) -> Patches:
    """As many patches as Reinhart's MF:n in as many rows, all of one solid angle: the rows' edges are moved.

    >>> sky = equal_area(2)
    >>> bool(np.allclose(sky.solid_angles, 2 * np.pi / sky.count, rtol=1e-12))
    True
    """
    counts = reinhart_counts(division)
    sines = np.concatenate([[0.0], np.cumsum(counts) / counts.sum()])
    edges = np.arcsin(np.minimum(sines, 1.0))
    return Patches(f"equal-area:{division}", edges, counts)


def patches(name: "str | Patches") -> Patches:
    """The patches of that name: "tregenza", "reinhart:N" (also "mf:N") or "equal-area:N"; Patches pass untouched.

    >>> patches("reinhart:2").count
    577
    """
    if isinstance(name, Patches):
        return name
    require_kind(name, str, "patches", "tregenza or reinhart:2")
    if name == "tregenza":
        return tregenza()
    kinds = {"reinhart": reinhart, "mf": reinhart, "equal-area": equal_area}
    found = re.fullmatch(r"(reinhart|mf|equal-area):(\d{1,4})", str(name).lower())
    if found is None:
        raise ValueError(f"patches must be {NAMES}, got {name!r}")
    return kinds[found[1]](int(found[2]))
