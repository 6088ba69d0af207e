"""What is wrong with single hours of a weather record, as flags, each with its published limit.

flag | limit | source
`impossible` | global 1.5 S m^1.2 + 100, diffuse .95 S m^1.2 + 50, direct S (S outside the air, m = cos z) | BSRN
`rare` | global 1.2 S m^1.2 + 50, diffuse .75 S m^1.2 + 30, direct .95 S m^.2 + 10 | BSRN
`unclosed` | global over its parts within 8 %, 15 % below 15 degrees of sun, above 50 W m-2 | BSRN
`diffuse_above_global` | diffuse over global at most 1.05, 1.10 below 15 degrees of sun | BSRN
`above_clear` | direct at most 5 % above the clear sky's with the cleanest air, Linke 2 | Ineichen and Perez 2002
`above_bird` | direct at most 5 % above that of air without aerosol, 2 mm of water | Bird and Hulstrom 1981

BSRN: Long and Dutton 2002, BSRN Global Network recommended QC tests, V2.0.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from skydome.ground.directions import zenith_angle
from skydome.ground.units import SOLAR_CONSTANT, deg
from skydome.sun.track import SunTrack
from skydome.years.quality.clear_sky import ClearSky, bird, ineichen
from skydome.years.weather.sun_of_interval import LitSun, lit_sun
from skydome.years.weather.weather import Weather

FLAGS = {
    "missing": "an irradiance is missing while the sun is up",
    "light_at_night": "more than 5 W m-2 while the sun is down",
    "no_diffuse": "direct light without diffuse light",
    "impossible": "beyond what can be (BSRN)",
    "rare": "beyond what is extremely rare (BSRN)",
    "unclosed": "global irradiance is not diffuse plus direct (BSRN)",
    "diffuse_above_global": "diffuse irradiance above the global one (BSRN)",
    "above_clear": "direct irradiance above that of the cleanest air (Ineichen and Perez)",
    "above_bird": "direct irradiance above that of air without aerosol (Bird and Hulstrom)",
    "stuck": "the same light for 4 hours or more while the sun is up",
}
"""Name and meaning."""

AT_NIGHT, LEAST, STUCK = 5.0, 50.0, 4
"""W m-2 that count at night, W m-2 from which ratios are looked at, hours of one value."""

LOW_SUN = 15 * deg
DRIEST = 0.2
"""Water of the driest air, cm."""

CLEANEST, ABOVE = 2.0, 1.05
"""Linke's turbidity of the cleanest air, and how much more direct light is let pass."""


@dataclass(frozen=True, eq=False)
class Looked:
    """A record with its sun: T intervals of `weather`, the sun of each, the clear sky of the cleanest air."""

    weather: Weather
    sun: LitSun

    @classmethod
    def at(cls, weather: Weather, track: SunTrack | None = None) -> "Looked":
        """The record, with the sun at the middle of the lit part of each interval."""
        return cls(weather, lit_sun(weather, track))

    @cached_property
    def up(self) -> np.ndarray:
        """True where the sun is up in a part of the interval, (T,)."""
        part: np.ndarray = self.sun.lit > 0
        return part

    @cached_property
    def zenith(self) -> np.ndarray:
        """The sun's zenith angle, radians, (T,)."""
        angle: np.ndarray = zenith_angle(self.sun.directions)
        return angle

    @cached_property
    def cosine(self) -> np.ndarray:
        """Mean cosine of the zenith angle over the interval, 0 at night, (T,)."""
        mean: np.ndarray = np.maximum(self.sun.directions[:, 2], 0) * self.sun.lit
        return mean

    @cached_property
    def extraterrestrial(self) -> np.ndarray:
        """Normal irradiance outside the air, W m-2, (T,)."""
        level: np.ndarray = SOLAR_CONSTANT / self.sun.distances**2
        return level

    @cached_property
    def whole(self) -> np.ndarray:
        """Global horizontal irradiance, W m-2, (T,): the file's, or from the parts where it has none."""
        parts = self.weather.diffuse_horizontal + self.weather.direct_normal * self.cosine
        known = self.weather.global_horizontal
        total: np.ndarray = parts if known is None else np.where(np.isnan(known), parts, known)
        return total

    def clear(self, linke: "float | np.ndarray" = CLEANEST) -> ClearSky:
        """The clear sky of each interval for Linke's turbidity."""
        return ineichen(self.zenith, self.extraterrestrial, self.weather.place.altitude, linke)

    def purest(self) -> ClearSky:
        """The clear sky of each interval without aerosol and nearly without water."""
        return bird(self.zenith, self.extraterrestrial, self.weather.place.altitude, aerosol=0.0, water=DRIEST)


def flags_of(looked: Looked) -> dict[str, np.ndarray]:
    """Booleans (T,) for each of `FLAGS`; comparisons with what is missing are False.

    >>> start = np.array(["2026-06-21T11", "2026-06-21T23"], dtype="datetime64[s]")
    >>> from skydome.sun.place import Place
    >>> light = (np.array([1500.0, 0.0]), np.array([100.0, 90.0]), np.array([10.0, 10.0]))
    >>> found = flags_of(Looked.at(Weather(Place(45.0, 8.0), start, start + np.timedelta64(3600, "s"), *light)))
    >>> [name for name, marks in found.items() if marks.any()]
    ['light_at_night', 'impossible', 'rare', 'above_clear', 'above_bird']
    """
    weather, up, cosine = looked.weather, looked.up, looked.cosine
    direct, diffuse, whole, outside = (
        weather.direct_normal,
        weather.diffuse_horizontal,
        looked.whole,
        looked.extraterrestrial,
    )
    power, low = cosine**1.2, looked.zenith > np.pi / 2 - LOW_SUN
    with np.errstate(invalid="ignore", divide="ignore"):
        ratio = whole / (diffuse + direct * cosine)
        limits = ((1.5, 0.95, 100, 50), (1.2, 0.75, 50, 30))
        above = [(whole > a * outside * power + c) | (diffuse > b * outside * power + d) for a, b, c, d in limits]
        return {
            "missing": up & weather.missing,
            "light_at_night": ~up & (np.maximum(np.nan_to_num(diffuse), np.nan_to_num(direct)) > AT_NIGHT),
            "no_diffuse": up & (direct > 0) & (diffuse <= 0),
            "impossible": up & (above[0] | (direct > outside)),
            "rare": up & (above[1] | (direct > 0.95 * outside * cosine**0.2 + 10)),
            "unclosed": up & (whole > LEAST) & (np.abs(ratio - 1) > np.where(low, 0.15, 0.08)),
            "diffuse_above_global": up & (whole > LEAST) & (diffuse / whole > np.where(low, 1.10, 1.05)),
            "above_clear": up & (direct > LEAST) & (direct > ABOVE * looked.clear().direct_normal),
            "above_bird": up & (direct > LEAST) & (direct > ABOVE * looked.purest().direct_normal),
            "stuck": stuck(whole, up),
        }


def stuck(values: np.ndarray, up: np.ndarray) -> np.ndarray:
    """True in runs of at least 4 equal values above 0 while the sun is up, (T,)."""
    same = np.append(False, (values[1:] == values[:-1]) & (values[1:] > 0) & up[1:] & up[:-1])
    start = np.cumsum(~same)
    run: np.ndarray = np.bincount(start)[start] >= STUCK
    held: np.ndarray = run & up & (np.nan_to_num(values) > 0)
    return held
