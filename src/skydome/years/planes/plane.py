"""A plane that light falls on through a year: its tilt, where it faces, and what stands around it."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.directions import checked_turn, direction
from skydome.ground.limits.ranges import FINITE, require, require_one
from skydome.ground.units import deg, in_degrees
from skydome.surroundings.intervals import Open, Surroundings

SOUTH = 180 * deg


@dataclass(frozen=True, eq=False)
class Plane:
    """A plane `tilt` from level (0 to pi) that faces `azimuth`, radians; `surroundings` as seen from it.

    These are `Horizon(...)`, a point of a street, `StreetCanyon(...).at(x, z)`, or of a scene,
    `MeshScene(...).at(point, normal)`. ValueError for a tilt outside.

    >>> wall = Plane(tilt=90 * deg, azimuth=180 * deg)
    >>> wall.normal.round(3).tolist(), wall.label
    ([0.0, -1.0, 0.0], '90,180')
    """

    tilt: float = 0.0
    azimuth: float = SOUTH
    surroundings: Surroundings = field(default_factory=Open)
    name: str = ""

    def __post_init__(self) -> None:
        require_kind(self.surroundings, Surroundings, "surroundings", "Horizon.level(30 * deg)")
        require_kind(self.name, str, "name", "'roof'")
        for name in ("tilt", "azimuth"):
            require(name, getattr(self, name), FINITE)
            require_one(name, getattr(self, name))
        if not 0 <= self.tilt <= np.pi:
            raise ValueError(f"the tilt of a plane must lie in [0, 180] degrees, got {in_degrees(self.tilt)}")
        checked_turn(self.azimuth, "azimuth of a plane")

    @classmethod
    def facing(cls, normal: Sequence[float] | np.ndarray, surroundings: Surroundings, name: str = "") -> "Plane":
        """The plane of a unit normal (3,)."""
        x, y, z = (float(value) for value in normal)
        turn = np.arctan2(x, y) % (2 * np.pi) if np.hypot(x, y) > 1e-12 else SOUTH
        return cls(float(np.arccos(np.clip(z, -1, 1))), float(turn), surroundings, name)

    @property
    def normal(self) -> np.ndarray:
        """Unit normal, (3,)."""
        way: np.ndarray = direction(self.azimuth, np.pi / 2 - self.tilt)
        return way

    @property
    def label(self) -> str:
        """Its name, or else tilt and azimuth in degrees."""
        return self.name or f"{self.tilt / deg:.6g},{self.azimuth / deg:.6g}"


def labels_of(planes: Sequence[Plane]) -> list[str]:
    """The planes' labels, all different: those that repeat are numbered.

    >>> labels_of([Plane(), Plane(), Plane(90 * deg)])
    ['0,180', '0,180 (2)', '90,180']
    """
    names: list[str] = []
    for plane in planes:
        count = sum(other == plane.label or other.startswith(f"{plane.label} (") for other in names)
        names.append(plane.label if not count else f"{plane.label} ({count + 1})")
    return names
