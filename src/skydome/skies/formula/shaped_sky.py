"""Skies whose shape is a formula of its own, brought to a level by zenith luminance or illuminance."""

from abc import abstractmethod
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arrays import Array, at_least, floating, namespace, safe_divide
from skydome.ground.directions import checked_directions, zenith_angle
from skydome.ground.limits.ranges import LIGHT
from skydome.ground.quadrature import half_hemisphere_about
from skydome.skies.formula.level import require_one_level, risen
from skydome.skies.formula.perez_formula import view_geometry
from skydome.skies.sky import SunlitSky


@dataclass(frozen=True, eq=False)
class ShapedSky(SunlitSky):
    """A sky of luminance ~ `relative`, of a zenith_luminance, cd m-2, or a diffuse horizontal illuminance, lx."""

    zenith_luminance: Any = None
    illuminance: Any = field(default=None, kw_only=True)
    bounds: ClassVar = {"zenith_luminance": LIGHT, "illuminance": LIGHT}

    def __post_init__(self) -> None:
        """Validate only."""
        self.require_level()
        super().__post_init__()

    def require_level(self) -> None:
        """ValueError unless exactly one level is given."""
        require_one_level(type(self).__name__, self.zenith_luminance, self.illuminance)

    @property
    def levels(self) -> tuple[Any, Any]:
        """Zenith luminance, cd m-2, or illuminance, lx, the other None."""
        return self.zenith_luminance, self.illuminance

    @abstractmethod
    def relative(self, view_zenith: Array, sun_angle: Array, sun_zenith: Array) -> Array:
        """Relative luminance, shape (...,), from zenith angles and the angle to the sun, radians."""

    def reference(self, sun_zenith: Array) -> Array:
        """What the level stands for: relative luminance in the zenith, or relative illuminance, shape (...,)."""
        if self.levels[1] is None:
            return self.relative(sun_zenith * 0, sun_zenith, sun_zenith)
        cosine, angle, weight = half_hemisphere_about(sun_zenith)
        xp = namespace(cosine)
        flat = at_least(xp.where(cosine < 1, cosine, xp.ones_like(cosine)), 0.0)
        light = self.relative(xp.acos(flat), angle, sun_zenith[..., None])
        return xp.sum(light * weight * cosine, axis=-1)

    def luminance(self, directions: Array) -> Array:
        """Luminance toward each direction, cd m-2, shape (...,); 0 below the horizon and at night."""
        namespace(directions, self.sun)
        directions = checked_directions(directions, like=self.sun)
        sun = floating(self.sun, like=directions)
        _, sun_angle = view_geometry(directions, sun)
        own = [np.shape(getattr(self, name)) for name in self.ranges]
        sun_zenith = namespace(sun).broadcast_to(risen(sun), np.broadcast_shapes(tuple(sun.shape[:-1]), *own))
        shape = self.relative(self.view_zenith(directions), sun_angle, sun_zenith)
        zenith, horizontal = self.levels
        given = zenith if horizontal is None else horizontal
        level = safe_divide(floating(given, like=directions), self.reference(sun_zenith))
        return self.blanked(level * shape, directions, channels=0)

    @staticmethod
    def view_zenith(directions: Array) -> Array:
        """Zenith angle of the views, those below the horizon as at it, shape (...,)."""
        xp, angle = namespace(directions), zenith_angle(directions)
        return xp.where(angle < np.pi / 2, angle, xp.full_like(angle, np.pi / 2))
