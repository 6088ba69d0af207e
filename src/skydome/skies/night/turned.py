"""The parts of a night as a scene sees them whose own axes are turned about the vertical."""

from dataclasses import replace
from functools import singledispatch
from typing import Any

import numpy as np

from skydome.skies.all_air.bent_sun import BentSun
from skydome.skies.all_air.sky import PhysicalSky
from skydome.skies.night.celestial import Celestial, NightGlow
from skydome.skies.night.eclipse import EclipsedSun
from skydome.skies.night.moon.moon_disc import MoonDisc
from skydome.skies.suns.point_lights import PointLights


def about_the_vertical(angle: float) -> np.ndarray:
    """The rotation (3, 3) that turns directions counterclockwise, so that their azimuths are less by `angle`, rad."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


@singledispatch
def turned(sky: Any, rotation: np.ndarray) -> Any:
    """A sky of the same kind whose directions are turned by a `rotation` (3, 3) about the vertical."""
    raise TypeError(f"{type(sky).__name__} cannot be turned: turn the clear sky, then put clouds over it")


@turned.register
def _(sky: NightGlow, rotation: np.ndarray) -> NightGlow:
    return sky


@turned.register
def _(sky: Celestial, rotation: np.ndarray) -> Celestial:
    return replace(sky, turn=np.asarray(sky.turn) @ rotation.T)


@turned.register
def _(sky: PointLights, rotation: np.ndarray) -> PointLights:
    return replace(sky, directions=np.asarray(sky.directions) @ rotation.T)


@turned.register
def _(sky: PhysicalSky, rotation: np.ndarray) -> PhysicalSky:
    return replace(sky, sun=sky.sun @ rotation.T)


@turned.register
def _(sky: BentSun, rotation: np.ndarray) -> BentSun:
    return replace(sky, sun=sky.sun @ rotation.T, standing=sky.standing @ rotation.T)


@turned.register
def _(sky: EclipsedSun, rotation: np.ndarray) -> EclipsedSun:
    seen, standing, moon = (np.asarray(v) @ rotation.T for v in (sky.sun, sky.standing, sky.moon))
    return replace(sky, sun=seen, standing=standing, moon=moon)


@turned.register
def _(sky: MoonDisc, rotation: np.ndarray) -> MoonDisc:
    names = ("sun", "standing", "toward_sun", "north")
    shadow = None if sky.shadow is None else sky.shadow.turned(rotation)
    return replace(sky, shadow=shadow, **{name: np.asarray(getattr(sky, name)) @ rotation.T for name in names})
