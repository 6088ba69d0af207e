"""The moon in few numbers for the explorer's page: `python scripts/export_moon.py` writes explorer/src/data/moon.json.

Where it stands: the largest terms of its longitude, latitude and distance in the four arguments of the lunar theory
(Meeus 1998, chapter 47), fitted to the package's own moon in 1900-2150. How bright it is: its light above the air over
the sun's in X, Y and Z, by `LunarLight`, at phase angles with their sign, the mean distance and no libration.
"""

import json
import sys
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

import skydome as sd
from skydome.air.cross_sections import solar_irradiance
from skydome.ground.units import deg
from skydome.light.spectrum import xyz_weights
from skydome.moon.geocentric import moon_vectors
from skydome.moon.phase import MoonPhase
from skydome.moon.position import LUNAR_RADIUS
from skydome.skies.night.moon.lunar_light import BANDS, MEAN_DISTANCE, LunarLight
from skydome.sun.celestial import ASTRONOMICAL_UNIT, centuries, ecliptic_axes

PATH = Path(__file__).resolve().parent.parent / "explorer" / "src" / "data" / "moon.json"
ARGUMENTS = (
    (218.3164477, 481267.88123421, -0.0015786),
    (297.8501921, 445267.1114034, -0.0018819),
    (357.5291092, 35999.0502909, -0.0001536),
    (134.9633964, 477198.8675055, 0.0087414),
    (93.2720950, 483202.0175233, -0.0036539),
)
"""Degrees at J2000, a century, its square: mean longitude, elongation, anomalies of sun and moon, latitude."""
COUNTS = {"longitude": 48, "latitude": 34, "distance": 24}
PHASES = np.concatenate([np.arange(0, 30, 2.0), np.arange(30, 181, 5.0)])


def fitted(values: np.ndarray, waves: np.ndarray, terms: list[tuple[int, ...]], count: int, smooth: np.ndarray) -> Any:
    """Polynomial and the largest terms [multiples ..., amplitude] of values (N,) in waves (terms, N)."""
    first, *_ = np.linalg.lstsq(np.concatenate([smooth, waves]).T, values, rcond=None)
    kept = np.argsort(-np.abs(first[len(smooth) :]))[:count]
    last, *_ = np.linalg.lstsq(np.concatenate([smooth, waves[kept]]).T, values, rcond=None)
    rows = [[*terms[k], round(float(a), 9)] for k, a in zip(kept, last[len(smooth) :], strict=True)]
    return [round(float(a), 9) for a in last[: len(smooth)]], rows


def course() -> dict[str, Any]:
    """The series of longitude and latitude, radians of the ecliptic of date, and of the distance, AU."""
    minutes = np.random.default_rng(1).integers(0, 250 * 525960, 8000)
    utc = np.datetime64("1900-01-01T00:00", "us") + np.sort(minutes) * np.timedelta64(60_000_000, "us")
    x, y, z = np.einsum("nij,nj->in", ecliptic_axes(utc), moon_vectors(utc))
    t = centuries(utc)
    mean, *arguments = (np.polynomial.polynomial.polyval(t, row) * deg for row in ARGUMENTS)
    terms = [
        c for c in product(range(5), range(-2, 3), range(-4, 5), range(-3, 4)) if c > (0,) * 4 and np.abs(c).sum() < 7
    ]
    even, odd = ([c for c in terms if c[3] % 2 == parity] for parity in (0, 1))
    phases = {id(some): np.array(some) @ np.stack(arguments) for some in (even, odd)}
    rest = (np.arctan2(y, x) - mean + np.pi) % (2 * np.pi) - np.pi
    powers = np.stack([t**0, t, t**2])
    longitude = fitted(rest, np.sin(phases[id(even)]), even, COUNTS["longitude"], powers)
    latitude = fitted(np.arctan2(z, np.hypot(x, y)), np.sin(phases[id(odd)]), odd, COUNTS["latitude"], powers[:0])
    distance = fitted(np.sqrt(x * x + y * y + z * z), np.cos(phases[id(even)]), even, COUNTS["distance"], powers[:1])
    named = {"longitude": longitude, "latitude": latitude, "distance": distance}
    return {name: {"powers": powers, "terms": rows} for name, (powers, rows) in named.items()}


def light() -> dict[str, Any]:
    """log10 of the moon's X, Y, Z over the sun's, waxing and waning, (phases, 3) each."""
    sun = solar_irradiance(BANDS) @ xyz_weights(BANDS)
    none, found = np.zeros(len(PHASES)), {}
    up, beside = (np.tile(axis, (len(PHASES), 1)) for axis in (sd.ZENITH, sd.NORTH))  # far from the earth's shadow
    for name, sign in (("waxing", 1), ("waning", -1)):
        angle = PHASES * deg
        phase = MoonPhase(
            direction=beside, toward_sun=up, north=up, phase_angle=angle, distance=none + MEAN_DISTANCE,
            sun_distance=none + 1, waxing=none > 0, longitude_of_sun=sign * angle, longitude=none, latitude=none,
            earth=MEAN_DISTANCE * beside,
        )  # fmt: skip
        found[name] = np.log10(LunarLight.of(phase).whole @ xyz_weights(BANDS) / sun).round(5).tolist()
    return found


def table() -> dict[str, Any]:
    """Everything."""
    return {
        "arguments": [list(row) for row in ARGUMENTS],
        **course(),
        "radius": LUNAR_RADIUS / ASTRONOMICAL_UNIT,
        "meanDistance": MEAN_DISTANCE / ASTRONOMICAL_UNIT,
        "phases": PHASES.tolist(),
        **light(),
    }


if __name__ == "__main__":
    PATH.write_text(json.dumps(table(), separators=(",", ":")) + "\n", "utf-8")
    sys.exit(0)
