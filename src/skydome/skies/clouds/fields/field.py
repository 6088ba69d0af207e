"""A field of cloud: extinction in inverse metres at every place over the ground, repeating, drifting with the wind."""

from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from typing import Any, ClassVar, NamedTuple, Self

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.arrays import brief
from skydome.ground.limits.ranges import FINITE, SEED, SHARE, Bounded, Range, require, require_one
from skydome.skies.clouds.fields.kinds import CloudKind, Cumulus, ramp
from skydome.skies.clouds.fields.noise import cells
from skydome.skies.clouds.fields.thickening import NONE, Column, Thickening, thickened

DETAIL = 64
"""Places along each side of the block of fine detail, which repeats."""
MET = 0.08
"""Cloud counts as met where, somewhere in a column, it has come so far up its edge."""
CLOSED = 0.3
"""How far under the thinnest place the threshold of a whole cover lies: no holes."""
SPEED = Range(-200.0, 200.0, "m s-1")
METRES = Range(-1e9, 1e9, "m")


class Medium(NamedTuple):
    """What extinction is computed from."""

    shape: np.ndarray
    """(count, count, levels), float32: north, east, up."""
    detail: np.ndarray
    """(DETAIL, DETAIL, DETAIL), float32."""
    profile: np.ndarray
    """(levels,)."""
    spacing: float
    base: float
    thickness: float
    threshold: float
    erosion: float
    edge: float
    extinction: float
    fine: float
    """m between places of the detail."""
    east: float
    """Where the eye stands over the field, m."""
    north: float
    thicker: Column
    """Where there is more of the shape, or less."""


@dataclass(frozen=True)
class CloudField(Bounded):
    """A field of cloud of one `kind` that covers a share `cover` of the sky's columns.

    base, thickness in m above the ground, extinction (the greatest) in m-1: the kind's usual ones unless given. `wind`
    (east, north), m s-1, moves it, and `place` (east, north), m, is where the eye stands over it. `thicker` makes more
    or less of it along one ray. It repeats after `kind.period` m. ValueError for cover over 1, clouds below the ground,
    negative depth.

    >>> field = CloudField(Cumulus(), cover=0.4, seed=7)
    >>> field.base, field.thickness
    (1200.0, 1300.0)
    >>> field.later(600.0).place
    (0.0, 0.0)
    """

    kind: CloudKind = field(default_factory=Cumulus)
    cover: float = 0.4
    base: float = None  # type: ignore[assignment]
    thickness: float = None  # type: ignore[assignment]
    extinction: float = None  # type: ignore[assignment]
    seed: int = 0
    wind: tuple[float, float] = (0.0, 0.0)
    place: tuple[float, float] = (0.0, 0.0)
    thicker: Thickening | None = None
    kinds: ClassVar = {"kind": (CloudKind, "Cumulus()"), "thicker": (Thickening | None, "Thickening((0, 0, 1), 0.1)")}
    bounds: ClassVar = {
        "cover": SHARE,
        "base": Range(50.0, 20_000.0, "m"),
        "thickness": Range(20.0, 10_000.0, "m"),
        "extinction": Range(0.0, 1.0, "m-1"),
        "seed": SEED,
        "wind": SPEED,
        "place": METRES,
    }

    def __post_init__(self) -> None:
        require_kind(self.kind, CloudKind, "kind", "Cumulus()")
        for name in ("base", "thickness", "extinction"):
            if getattr(self, name) is None:
                object.__setattr__(self, name, getattr(self.kind, name))
        self.require_bounds()
        for name in ("wind", "place"):
            if np.shape(getattr(self, name)) != (2,):
                raise ValueError(f"{name} must be two numbers (east, north), got {brief(getattr(self, name))}")

    def later(self, seconds: float) -> Self:
        """The field after so many seconds of wind."""
        require("seconds", seconds, FINITE)
        require_one("seconds", seconds)
        east, north = (p - w * seconds for p, w in zip(self.place, self.wind, strict=True))
        return replace(self, place=(east, north))

    @property
    def top(self) -> float:
        """Height of the clouds' top above the ground, m."""
        return self.base + self.thickness

    @property
    def middle(self) -> float:
        """Height of the middle between base and top, m."""
        return (self.base + self.top) / 2

    @property
    def words(self) -> str:
        """What it is, in a line.

        >>> CloudField(seed=7).words
        'cumulus, cover 0.40, 1200 to 2500 m, seed 7, water of 10 um'
        """
        kind, height = self.kind, f"{self.base:.0f} to {self.top:.0f} m"
        of = f"{kind.particles.name} of {kind.radius * 1e6:g} um"
        return f"{kind.name}, cover {self.cover:.2f}, {height}, seed {self.seed}, {of}"

    @cached_property
    def threshold(self) -> float:
        """The shape from which on there is cloud, so that `cover` is met."""
        highest = column_tops(self.kind, self.thickness, self.seed)
        if self.cover <= 0:
            return float(highest[-1]) + 1.0
        share = (1 - self.cover) * (len(highest) - 1)
        found = float(np.interp(share, np.arange(len(highest)), highest))
        return found - (self.kind.edge * MET if self.cover < 1 else max(self.kind.edge, CLOSED))

    @cached_property
    def medium(self) -> Medium:
        """What kernels compute the extinction from."""
        kind = self.kind
        shape, detail = tables(kind, self.thickness, self.seed)
        profile = kind.profile((np.arange(kind.levels) + 0.5) / kind.levels)
        return Medium(
            shape, detail, profile, kind.period / kind.count, self.base, self.thickness, self.threshold, kind.erosion,
            kind.edge, self.extinction, kind.detail, float(self.place[0]), float(self.place[1]), self.column,
        )  # fmt: skip

    @property
    def column(self) -> Column:
        """Where it is made thicker."""
        if self.thicker is None:
            return NONE
        middle = float(tables(self.kind, self.thickness, self.seed)[0][:: self.kind.count // 16].mean())
        return self.thicker.column((self.base, self.kind.period), self.place, middle)

    def extinction_at(self, points: Any) -> np.ndarray:
        """Extinction at points (..., 3), m from the eye's foot to east, north and up, m-1, shape (...,).

        >>> float(CloudField(Cumulus(), cover=1.0).extinction_at([0.0, 0.0, 100.0]))
        0.0
        """
        require("points", points, METRES)
        m, points = self.medium, np.asarray(points, np.float64)
        if points.shape[-1:] != (3,):
            raise ValueError(f"points must have shape (..., 3), got {points.shape}")
        x, y, z = (points + np.array([m.east, m.north, -m.base])).reshape(-1, 3).T
        height = z / m.thickness
        place = height * len(m.profile) - 0.5
        shape = interpolated(m.shape, x / m.spacing, y / m.spacing, place, wraps=False)
        shape = shape + thickened(m.thicker, shape, x, y, z)
        eaten = m.erosion * interpolated(m.detail, x / m.fine, y / m.fine, z / m.fine, wraps=True)
        level = np.interp(place, np.arange(len(m.profile)), m.profile)
        inside = (height >= 0) & (height <= 1)
        full = np.where(inside, ramp((shape - eaten - m.threshold) / m.edge) * level * m.extinction, 0.0)
        return np.asarray(full.reshape(points.shape[:-1]))


def interpolated(table: np.ndarray, x: np.ndarray, y: np.ndarray, z: np.ndarray, wraps: bool) -> np.ndarray:
    """A table (north, east, up) that repeats, linear at places x, y, z (N,); upward it `wraps`, or is held."""
    rows, columns, levels = table.shape
    z = z if wraps else np.clip(z, 0.0, levels - 1.0)
    low = [np.floor(v).astype(np.int64) for v in (x, y, z)]
    total = np.zeros(len(x))
    for a in (0, 1):
        for b in (0, 1):
            for c in (0, 1):
                weight = 1.0
                for v, n, s in zip((x, y, z), low, (a, b, c), strict=True):
                    weight = weight * ((v - n) if s else (1 - (v - n)))
                up = (low[2] + c) % levels if wraps else np.minimum(low[2] + c, levels - 1)
                total += weight * table[(low[1] + b) % rows, (low[0] + a) % columns, up]
    return total


@lru_cache(maxsize=6)
def tables(kind: CloudKind, thickness: float, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """The shape (count, count, levels) and the fine detail (DETAIL, DETAIL, DETAIL) of a kind, float32."""
    along = np.arange(kind.count) * (kind.period / kind.count)
    height = (np.arange(kind.levels) + 0.5) / kind.levels
    shape = np.empty((kind.count, kind.count, kind.levels), np.float32)
    for rows in np.array_split(np.arange(kind.count), max(1, kind.count // 32)):
        points = np.stack(np.meshgrid(along[rows], along, height * thickness, indexing="ij"), axis=-1)[..., [1, 0, 2]]
        shape[rows] = kind.shape(points, np.broadcast_to(height, points.shape[:-1]), seed)
    return shape, detail(seed)


def detail(seed: int) -> np.ndarray:
    """Fine detail: distances to points strewn at three scales, 0 to about 1."""
    place = np.arange(DETAIL) / DETAIL
    points = np.stack(np.meshgrid(place, place, place, indexing="ij"), axis=-1)[..., [1, 0, 2]]
    each = ((0.5, 4), (0.3, 9), (0.2, 19))
    return np.asarray(sum(w * cells(points * n, (n, n, n), seed + 101 + n) for w, n in each), np.float32)


@lru_cache(maxsize=6)
def column_tops(kind: CloudKind, thickness: float, seed: int) -> np.ndarray:
    """The greatest of shape less erosion in each column where there can be cloud, in order of size, (columns,)."""
    shape, fine = tables(kind, thickness, seed)
    level = np.flatnonzero(kind.profile((np.arange(kind.levels) + 0.5) / kind.levels) > 0.05)
    along, up = np.arange(kind.count) * (kind.period / kind.count), (level + 0.5) / kind.levels * thickness
    eaten = kind.erosion * on_a_grid(fine, along / kind.detail, along / kind.detail, up / kind.detail)
    return np.sort((shape[..., level] - eaten).max(axis=2), axis=None)


def on_a_grid(table: np.ndarray, north: np.ndarray, east: np.ndarray, up: np.ndarray) -> np.ndarray:
    """A table (north, east, up) that repeats, linear at all meetings of places along the axes."""
    for axis, places in ((2, up), (1, east), (0, north)):
        low = np.floor(places).astype(int)
        share = np.float32(places - low).reshape([-1 if n == axis else 1 for n in range(3)])
        first, second = (np.take(table, (low + n) % table.shape[axis], axis) for n in (0, 1))
        table = first + (second - first) * share
    return table
