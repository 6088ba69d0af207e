"""The light on the level through many times, each part by itself."""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from skydome.ground.labels import Parts, keeps_labels
from skydome.skies.night.celestial import NightGlow
from skydome.skies.night.sky_at import NAMES, sky_at
from skydome.skies.suns.point_lights import PointLights
from skydome.skies.suns.sun_disc import SunDisc
from skydome.sun.place import Place
from skydome.sun.times import Times, instants


@dataclass(frozen=True, eq=False)
class LightThroughTime(Parts):
    """Horizontal illuminance at `times` (...,), lx: of each part by its name, (...,), and of all."""

    times: np.ndarray
    parts: dict[str, np.ndarray]
    units: ClassVar = {"times": ""}

    @property
    def total(self) -> np.ndarray:
        """Of all parts, (...,)."""
        found = list(self.parts.values())
        return sum(found[1:], found[0]) if found else np.zeros(np.shape(self.times))


@keeps_labels("lx", times=0)
def light_at(place: Place, times: Times, air: Any = None, **choices: Any) -> LightThroughTime:
    """The `LightThroughTime` of a place: what `sky_at` has at each of times (...,), and its `choices`.

    >>> import skydome as sd
    >>> evening = np.datetime64("2026-01-18T16:00") + np.arange(3) * np.timedelta64(1, "h")
    >>> light_at(sd.Place(50.0, 8.0), evening).total.shape
    (3,)
    """
    at = np.atleast_1d(instants(times))
    found = {name: np.zeros(at.size) for name in NAMES}
    for k, time in enumerate(at.ravel()):
        whole = sky_at(place, time, air, **choices)
        for name in whole.names:
            found[name][k] = level(whole[name])
    return LightThroughTime(at, {name: light.reshape(at.shape) for name, light in found.items() if light.any()})


def level(sky: Any) -> float:
    """Illuminance of one part on the horizontal, lx."""
    if isinstance(sky, SunDisc | PointLights):
        return float(sky.illuminance(np.array([0.0, 0.0, 1.0])))
    known = sky.on_level if isinstance(sky, NightGlow) else sky.for_maps.on_level
    return float(known[1])
