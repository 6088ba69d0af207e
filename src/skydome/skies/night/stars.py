"""Stars and planets as points of light through the air."""

from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.limits.ranges import FINITE, require, require_one
from skydome.light.spectrum import Spectrum
from skydome.skies.night.magnitudes import BANDS, starlight_of
from skydome.skies.night.through_air import Air, air_of
from skydome.skies.suns.point_lights import PointLights
from skydome.stars.catalogue import EPOCH, hipparcos
from skydome.stars.directions import star_directions
from skydome.stars.planets import planets
from skydome.sun.place import Place
from skydome.sun.position import checked_years
from skydome.sun.times import Times, instants

FAINTEST = 6.5
"""Magnitude down to which stars are points; the light of fainter ones is in `Starlight`."""


class Stars(PointLights):
    """Stars as points of light, through air that dims, reddens and lifts them: `Stars.over(place, time, air)`.

    >>> import skydome as sd
    >>> stars = Stars.over(sd.Place(50.0, 8.0), "2026-01-15T22:00Z")
    >>> bool(2e-5 < sd.illuminance(stars) < 1e-4)  # lx
    True
    """

    @classmethod
    def over(cls, place: Place, time: Times, air: Atmosphere | None = None, faintest: float = FAINTEST) -> "Stars":
        """The stars of Hipparcos of magnitude `faintest` or brighter over a place at one time (extra `night`)."""
        Place.required(place)
        require("faintest", faintest, FINITE)
        require_one("faintest", faintest)
        table = hipparcos(float(faintest))
        motion = (table.along, table.north)
        true = star_directions(
            place, instant(time), table.right_ascension, table.declination, motion, table.parallax, EPOCH
        )
        return cls(*through(air, true, table.magnitude, table.colour))


class Planets(PointLights):
    """The planets as points of light through the air: `Planets.over(place, time, air)`.

    >>> import skydome as sd
    >>> bool(sd.illuminance(Planets.over(sd.Place(50.0, 8.0), "2026-04-19T20:00Z")) > 1e-6)  # Venus, mostly
    True
    """

    @classmethod
    def over(cls, place: Place, time: Times, air: Atmosphere | None = None) -> "Planets":
        """Those of one time at a place."""
        seen = planets(place, instant(time))
        true = np.stack([planet.direction for planet in seen])
        bright = np.array([float(planet.magnitude) for planet in seen])
        return cls(*through(air, true, bright, np.array([planet.colour for planet in seen])))


def instant(time: Times) -> Any:
    """One time as datetime64; ValueError for many."""
    found = checked_years(instants(time))
    if found.shape:
        raise ValueError(
            f"time must be one time, got times of shape {found.shape}: call once for each, or sd.light_at for light "
            "on the level through all of them"
        )
    return found[()]


def through(
    air: Atmosphere | None, true: np.ndarray, magnitude: np.ndarray, colour: np.ndarray
) -> tuple[np.ndarray, Spectrum]:
    """Where points (N, 3) of a magnitude and a colour are seen, and what the air leaves of those that rose."""
    over = Air(air_of(air))
    high = true[:, 2] > -0.01
    seen = over.lifted(true[high])
    light = starlight_of(magnitude[high], colour[high]) * over.transmittance(seen[:, 2], BANDS)
    return seen, Spectrum(BANDS, light)
