"""Stars, planets and glows of the night for the explorer's page, data/night.json: `python scripts/export_night.py`.

Stars are those of the extra `night`, places of 2030; planets are Kepler's orbits (`fit_planets.py`). Of the usual air
at some turbidities it has logarithms: of what stays of starlight and of glows, and airglow's own, each X, Y and Z over
rings that crowd at the horizon; and what the air scatters of glows, by harmonics of the azimuth (`GlowScattering`).
"""

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
from explorer_digits import digits
from export_physical import LEAST_HAZE
from fit_planets import OBLIQUITY, orbit

from skydome.ground.units import deg
from skydome.light.spectrum import xyz_weights
from skydome.skies.catalogue import model_named
from skydome.skies.night import celestial, starlight, zodiacal
from skydome.skies.night.airglow import Airglow
from skydome.skies.night.celestial import UNIT, Celestial
from skydome.skies.night.hour import GLOWS_SEEN, POINTS_SEEN
from skydome.skies.night.magnitudes import BANDS, illuminance_of, starlight_of
from skydome.skies.night.scattering import TURNS, VIEWS, GlowScattering, at_bands, sources
from skydome.skies.night.stars import FAINTEST
from skydome.skies.night.through_air import Air
from skydome.stars.catalogue import EPOCH, hipparcos
from skydome.stars.planets import COLOURS, FAR_MARS, FAR_VENUS, NUMBERS, POLE_OF_SATURN, POLYNOMIALS

PATH = Path(__file__).resolve().parent.parent / "explorer" / "src" / "data" / "night.json"
TURBIDITIES = (1.0, LEAST_HAZE, 3.0, 6.0, 9.5)
GROUNDS = (0.0, 1.0)
RINGS = 65
"""Heights, even in the cube root."""
EVEN = 5.0
"""Degrees between the nodes of maps of the heavens."""
MODES, EVERY = 8, 3
"""Harmonics of the azimuth, and of `VIEWS` every so many, of the light that air scatters."""
YEAR, HUE = 2030.0, np.arange(-0.4, 2.01, 0.2)
TRUE = np.concatenate([np.arange(-1.0, 2.0, 0.1), np.arange(2.0, 90.1, 2.0)])
"""Elevations without air, degrees, at which it is told where one sees it."""
STEP = 1e-3


def airs(albedo: float = 0.0) -> list[Air]:
    """The usual air at the turbidities, over a ground."""
    return [Air(model_named("physical").air({"turbidity": t, "albedo": albedo})) for t in TURBIDITIES]


def sines() -> np.ndarray:
    """Sines of the rings' elevations."""
    return np.asarray(np.sin(np.linspace(0.0, 1.0, RINGS) ** 3 * np.pi / 2))


def told(logarithms: np.ndarray) -> dict[str, Any]:
    """Logarithms (turbidities, ..., rings, 3), differences along the rings."""
    return digits(np.moveaxis(logarithms, -1, 0), STEP, logarithms.ndim - 1)


def glow(kind: type[Celestial]) -> dict[str, Any]:
    """X, Y and Z of a unit: logarithms of what stays (turbidities, rings, 3), harmonics of what comes from beside,
    (3, turbidities, grounds, views, sources, modes).
    """
    bands = kind.bands
    weights = UNIT * kind(turn=np.eye(3)).spectrum(bands)[:, None] * xyz_weights(bands)
    straight = [air.transmittance(sines(), bands) @ weights for air in airs()]
    each = np.stack([[harmonics(air) for air in airs(albedo)] for albedo in GROUNDS], axis=1)
    beside = np.moveaxis(at_bands(each, bands) @ weights, -1, 0)
    steps = np.abs(beside).max(axis=(1, 2, 3, 4, 5)) / 4000
    return {"left": told(np.log(straight)), "beside": digits(beside, steps, 3)}


def harmonics(air: Air) -> np.ndarray:
    """What an air scatters, (views, sources, modes, W)."""
    return GlowScattering.of(air.atmosphere).harmonics[::EVERY, :, :MODES]


def airglow() -> dict[str, Any]:
    """Logarithm of XYZ of airglow, (turbidities, grounds, rings, 3)."""
    sine, bands = sines(), Airglow.bands
    views = np.stack([0 * sine, np.sqrt(1 - sine * sine), sine], axis=-1)
    glows = [[Airglow(air.atmosphere).glow(views, bands) for air in airs(albedo)] for albedo in GROUNDS]
    return told(np.log(np.stack(glows, axis=1) @ xyz_weights(bands)))


def stars() -> dict[str, Any]:
    """Right ascension and declination of J2000, radians, magnitude and colour, in the order of declinations."""
    table = hipparcos(FAINTEST)
    years = (YEAR - EPOCH) * deg / 3.6e6
    north = table.declination + years * table.north
    along = table.right_ascension + years * table.along / np.cos(table.declination)
    order = np.argsort(north)
    return {
        "along": digits(along[order], 1e-4, 0), "north": digits(north[order], 1e-4, 0),
        "magnitude": digits(table.magnitude[order], 0.01, 0), "hue": digits(table.colour[order], 0.02, 0),
    }  # fmt: skip


def starlight_left() -> dict[str, Any]:
    """Logarithm of what stays of X, Y and Z of a star like the sun, (turbidities, rings, 3)."""
    light = starlight_of(np.asarray(0.0), np.asarray(0.65))[:, None] * xyz_weights(BANDS)
    rows = [air.transmittance(sines(), BANDS) @ light / light.sum(axis=0) for air in airs()]
    return told(np.log(np.asarray(rows)))


def lift() -> list[float]:
    """By how much the air lifts what stands at `TRUE`, degrees."""
    true = np.stack([0 * TRUE, np.cos(TRUE * deg), np.sin(TRUE * deg)], axis=-1)
    seen = airs()[2].lifted(true)
    return (np.arcsin(np.clip(seen[:, 2], -1, 1)) / deg - TRUE).round(5).tolist()


def planets() -> dict[str, Any]:
    """Orbits and how bright they are (Mallama and Hilton 2018)."""
    return {
        name: {"orbit": orbit(name)[0].round(9).tolist(), "hue": COLOURS[name], "magnitude": list(POLYNOMIALS[name])}
        for name in list(NUMBERS)[:6]
    }


def evenly(rows: np.ndarray, columns: np.ndarray, values: np.ndarray) -> np.ndarray:
    """A table between whose nodes are straight lines, at every `EVEN` degrees, which its nodes are multiples of."""
    every = [np.arange(axis[0], axis[-1] + 1, EVEN) for axis in (rows, columns)]
    return np.asarray(celestial.bilinear(rows, columns, values, every[0][:, None], every[1][None, :]))


def milky_way() -> dict[str, Any]:
    """Brightness at 440 nm, 1e-8 W m-2 um-1 sr-1, by galactic latitude and longitude; the axes from J2000."""
    latitudes, longitudes, values = starlight.round_the_circle()
    one = starlight.Starlight(turn=np.eye(3)).brightness(np.array([0.0, 0.0, 1.0])) / values[-1, 0] / UNIT
    return {"values": digits(evenly(latitudes, longitudes, values * one), 0.1, 1), "axes": starlight.GALACTIC.tolist()}


def dust() -> dict[str, Any]:
    """Logarithm of the zodiacal light at 500 nm, 1e-8 W m-2 um-1 sr-1, by ecliptic latitude, longitude from the sun."""
    longitudes, latitudes, logarithm = zodiacal.filled()
    return {"values": digits(evenly(longitudes, latitudes, logarithm).T, STEP, 1)}


def table() -> dict[str, Any]:
    """Everything."""
    hues = starlight_of(np.zeros(HUE.size), HUE) @ xyz_weights(BANDS)
    return {
        "turbidities": np.round(TURBIDITIES, 6).tolist(), "rings": RINGS, "turns": TURNS, "even": EVEN,
        "views": VIEWS[::EVERY].round(8).tolist(), "sources": sources()[0].round(8).tolist(),
        "true": TRUE.round(3).tolist(), "lift": lift(), "obliquity": OBLIQUITY,
        "seen": {"points": POINTS_SEEN / deg, "glows": GLOWS_SEEN / deg},
        "zero": float(illuminance_of(0.0)), "hues": HUE.round(2).tolist(),
        "xyz": (hues / hues[:, 1:2]).round(5).tolist(),
        "stars": stars(), "left": starlight_left(), "airglow": airglow(),
        "milkyWay": milky_way() | {"air": glow(starlight.Starlight)},
        "dust": dust() | {"air": glow(zodiacal.ZodiacalLight)},
        "planets": planets(), "farVenus": list(FAR_VENUS), "farMars": list(FAR_MARS), "pole": POLE_OF_SATURN.tolist(),
    }  # fmt: skip


if __name__ == "__main__":
    PATH.write_text(json.dumps(table(), separators=(",", ":")) + "\n", "utf-8")
    sys.exit(0)
