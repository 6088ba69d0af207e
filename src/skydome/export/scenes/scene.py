"""What a scene tells, whatever its language: the map, its unit, the sun's lamp, how bright to show it."""

import math
from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

import skydome
from skydome.export.scenes.sun_lamp import SunLamp
from skydome.ground.directions import azimuth, elevation, tangent_frame
from skydome.ground.units import deg
from skydome.light.colour import SRGB, RGBSpace
from skydome.maps.targets import Target, target


@dataclass(frozen=True, eq=False)
class SkyScene:
    """The light of a sky for a renderer: a map without the sun, in the file `map_name`, and the sun as a lamp.

    RGB (1, 1, 1) of the map's file means `white` cd m-2. `exposure`, per cd m-2, shows it as a photograph would.
    `horizontal` is the illuminance of sky and sun on the level ground, lx; `about` says what sky it is.

    >>> overcast = SkyScene("sky.exr", 1.0, SRGB, None, 2.5e-5, (12000.0, 0.0))
    >>> overcast.lamp is None, sum(overcast.horizontal)
    (True, 12000.0)
    """

    map_name: str
    white: float
    space: RGBSpace
    lamp: SunLamp | None
    exposure: float
    horizontal: tuple[float, float]
    about: tuple[str, ...] = ()

    def lines(self, kind: "SceneFormat") -> Iterator[str]:
        """What every scene says of itself, in lines that no language takes for code: sky, sun, light, unit, axes."""
        for line in self.facts(kind):
            yield " ".join(line.replace('"', "'").replace("\\", "/").split())

    def facts(self, kind: "SceneFormat") -> Iterator[str]:
        """The same as it comes."""
        yield f"skydome {skydome.__version__}: {kind.name}"
        yield from self.about
        body, lamp = "sun", self.lamp
        if lamp is not None:
            body, where = lamp.body, lamp.direction
            yield (
                f"{body}: azimuth {float(azimuth(where)) / deg:.4f} degrees clockwise from north, elevation "
                f"{float(elevation(where)) / deg:.4f}; {lamp.illuminance:.6g} lx facing it, "
                f"{lamp.colour_temperature:.0f} K, {lamp.width:.4g} degrees across"
            )
        sky, sun = self.horizontal
        yield f"light on the level ground: {sky + sun:.6g} lx, of which {sky:.6g} from the sky"
        yield f"map: {self.map_name}, without the {body}; RGB times {self.white:g} is cd m-2 ({self.space.name})"
        yield kind.target.note.split(";")[0] + f"; east is {kind.axis((1, 0, 0))}, north {kind.axis((0, 1, 0))}"


class SceneFormat(ABC):
    """A renderer's language for scenes: how the sky's map and the sun's lamp are written in it.

    `target_name` has the map's layout and axes, `suffix` ends the scene's files, `map_suffix` the map's.
    """

    name: ClassVar[str]
    target_name: ClassVar[str]
    suffix: ClassVar[str]
    map_suffix: ClassVar[str] = ".exr"

    @abstractmethod
    def text(self, scene: SkyScene) -> str:
        """The file's text."""

    @property
    def target(self) -> Target:
        """The layout of the map, and the axes."""
        return target(self.target_name)

    def lamp_space(self, space: RGBSpace) -> RGBSpace:
        """The RGB space in which the lamp's colour is read, beside a map in `space`: linear sRGB unless told."""
        return SRGB

    def toward(self, direction: np.ndarray) -> np.ndarray:
        """A direction of ours as the renderer's vector (3,), rounded to what is worth writing."""
        return np.round(self.target.frame_vectors(direction), 9) + 0.0

    def axis(self, direction: tuple[float, ...]) -> str:
        """The renderer's axis that lies along one of ours, such as -z."""
        vector = self.toward(np.array(direction, dtype=float))
        k = int(np.argmax(np.abs(vector)))
        return f"{'+' if vector[k] > 0 else '-'}{'xyz'[k]}"

    def lamp_frame(self, lamp: SunLamp) -> np.ndarray:
        """Axes (3, 3), one a row, of a lamp that shines along its own -z: the third looks toward the sun."""
        toward = self.toward(lamp.direction)
        return np.stack([*tangent_frame(toward), toward])


def stops(exposure: float, white: float) -> float:
    """Stops by which a view is made brighter that shows RGB (1, 1, 1) of `white` cd m-2 as 1.

    >>> stops(2.0**-14, 1.0), stops(2.0**-14, 1024.0)
    (-14.0, -4.0)
    """
    return math.log2(exposure * white)


def listed(values: np.ndarray, between: str = " ") -> str:
    """Numbers as text, nine digits each.

    >>> listed(np.array([0.5, -1.0, 123456.789]))
    '0.5 -1 123456.789'
    """
    return between.join(f"{value:.9g}" for value in values)
