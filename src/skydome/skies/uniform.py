"""Skies without a sun: the uniform sky and Moon and Spencer's overcast sky."""

from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arrays import Array, floating, namespace
from skydome.ground.directions import checked_directions
from skydome.ground.limits.ranges import LIGHT
from skydome.skies.formula.level import require_one_level
from skydome.skies.sky import Sky


@dataclass(frozen=True, eq=False)
class Uniform(Sky):
    """The same luminance, cd m-2, from everywhere above the horizon; illuminance is pi times it.

    >>> import skydome as sd
    >>> round(float(sd.illuminance(sd.Uniform(1.0), sd.ZENITH)), 9) == round(np.pi, 9)
    True
    """

    value: Any
    bounds: ClassVar = {"value": LIGHT}
    source: ClassVar[str] = "definition"

    def luminance(self, directions: Array) -> Array:
        """Luminance toward each direction, cd m-2, shape (...,)."""
        xp = namespace(directions, self.value)
        directions = checked_directions(directions, like=self.value)
        value, z = xp.broadcast_arrays(floating(self.value, like=directions), directions[..., 2])
        return self.blanked(xp.where(z >= 0, value, xp.zeros_like(value)), directions, channels=0)


@dataclass(frozen=True, eq=False)
class MoonSpencer(Sky):
    """The overcast sky Lz (1 + 2 cos t) / 3 (Moon and Spencer 1942; Preetham 1999, eq. 2).

    Give zenith_luminance, cd m-2, or illuminance, lx: E = 7 pi / 9 Lz.

    >>> import skydome as sd
    >>> sky = sd.MoonSpencer(zenith_luminance=9000.0)
    >>> float(sky.luminance(sd.NORTH) / sky.luminance(sd.ZENITH)) * 3
    1.0
    """

    zenith_luminance: Any = field(default=None, kw_only=True)
    illuminance: Any = field(default=None, kw_only=True)
    bounds: ClassVar = {"zenith_luminance": LIGHT, "illuminance": LIGHT}
    source: ClassVar[str] = "Moon and Spencer 1942; Preetham 1999, eq. 2"

    def __post_init__(self) -> None:
        """Validate only."""
        require_one_level("MoonSpencer", self.zenith_luminance, self.illuminance)
        super().__post_init__()

    def luminance(self, directions: Array) -> Array:
        """Luminance toward each direction, cd m-2, shape (...,)."""
        level = self.zenith_luminance if self.illuminance is None else self.illuminance
        directions = checked_directions(directions, like=level)
        zenith = floating(level, like=directions) * (1 if self.illuminance is None else 9 / (7 * np.pi))
        return self.blanked(zenith * (1 + 2 * directions[..., 2]) / 3, directions, channels=0)
