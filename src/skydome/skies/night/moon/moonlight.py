"""Moonlight: the physical sky with the moon as its light."""

from dataclasses import dataclass, replace
from typing import Any, ClassVar, Self

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.light.spectrum import Spectrum
from skydome.moon.phase import MoonPhase, moon_phase
from skydome.skies.all_air.sky import PhysicalSky
from skydome.skies.night.moon.lunar_light import BANDS, LunarLight
from skydome.skies.night.moon.moon_face import MoonFace
from skydome.skies.night.stars import instant
from skydome.skies.night.through_air import air_of
from skydome.sun.place import Place
from skydome.sun.times import Times


@dataclass(frozen=True, eq=False)
class Moonlight(PhysicalSky):
    """The moonlit sky: `PhysicalSky` under a moon toward `sun`, whose spectrum is the atmosphere's `sunlight`.

    `Moonlight.over(place, time)` makes it of the moon of that hour (`LunarLight`, ROLO). Sunlight that comes so is
    scattered as sunlight is, so all that holds of the physical sky holds here. `MoonDisc` is the moon itself.

    >>> import skydome as sd
    >>> sky = Moonlight.over(sd.Place(50.0, 8.0), "2026-01-03T22:00Z")
    >>> bool(0.0005 < sky.luminance(sd.ZENITH) < 0.01)
    True
    """

    shines_at_night: ClassVar[bool] = True
    source: ClassVar[str] = "the physical sky; moonlight by Kieffer and Stone 2005 (ROLO)"

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.atmosphere.sunlight is None:
            raise ValueError("atmosphere must have the moon's light as its sunlight: use Moonlight.over(place, time)")

    @classmethod
    def over(cls, place: Place, time: Times, air: Atmosphere | None = None, **others: Any) -> Self:
        """The moonlit sky of one time at a place."""
        return cls.under(moon_phase(place, instant(time)), air, **others)

    @classmethod
    def under(cls, phase: MoonPhase, air: Atmosphere | None = None, **others: Any) -> Self:
        """The sky under one moon of shape ()."""
        return cls(np.asarray(phase.direction), moonlit(phase, air), **others)

    def own_disc(self, angular_radius: Any) -> None:
        """None: the moon is no round sun; `MoonDisc.over` has its phase."""
        return


def moonlit(phase: MoonPhase, air: Atmosphere | None) -> Atmosphere:
    """An air under the moonlight of one moon, less what the earth's shadow takes of it."""
    light = LunarLight.of(phase)
    left = light.lit * MoonFace.of(phase).left(BANDS) + light.earthshine
    return replace(air_of(air), sunlight=Spectrum(BANDS, left), sun_scale=1.0)
