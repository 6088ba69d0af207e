"""The planets over a place, and how bright they are."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.labels import COMPONENTS, Parts, keeps_labels
from skydome.ground.units import deg
from skydome.sun.celestial import LIGHT_DAYS_PER_AU, aberrated, earth, from_place, terrestrial_days
from skydome.sun.geocentric import JULIAN_DAY_J2000
from skydome.sun.place import Place
from skydome.sun.position import checked_years, lifted
from skydome.sun.times import Times, instants

NUMBERS = {"Mercury": 1, "Venus": 2, "Mars": 4, "Jupiter": 5, "Saturn": 6, "Uranus": 7, "Neptune": 8}
"""ERFA's number of each planet."""

COLOURS = {
    "Mercury": 0.97, "Venus": 0.82, "Mars": 1.36, "Jupiter": 0.83, "Saturn": 1.04, "Uranus": 0.56, "Neptune": 0.41,
}  # fmt: skip
"""B - V (Allen's Astrophysical Quantities, 4th edition, table 12.7)."""

POLE_OF_SATURN = np.array([np.cos(40.589 * deg) * np.cos(83.537 * deg), np.sin(40.589 * deg) * np.cos(83.537 * deg),
                           np.sin(83.537 * deg)])  # fmt: skip
"""In the stars' axes (IAU 2015)."""


@dataclass(frozen=True, eq=False)
class Planet(Parts):
    """A planet as seen from a place at times (...,).

    >>> venus = planets(Place(50.0, 8.0), "2026-06-09T22:30+02:00")[1]
    >>> venus.name, round(float(venus.magnitude), 1), round(float(np.arcsin(venus.direction[2])) / deg)
    ('Venus', -4.0, 14)
    """

    name: str
    direction: np.ndarray
    """Toward its true place, (..., 3)."""
    distance: np.ndarray
    """AU."""
    phase_angle: np.ndarray
    """Between sun and earth at the planet, radians."""
    magnitude: np.ndarray
    """In V, outside the air (Mallama and Hilton 2018)."""
    own_axes: ClassVar = {"direction": (COMPONENTS,)}
    units: ClassVar = {"distance": "AU", "phase_angle": "rad"}

    @property
    def colour(self) -> float:
        """B - V."""
        return COLOURS[self.name]


@keeps_labels(time=0)
def planets(place: Place, time: Times, refraction: bool = False) -> tuple[Planet, ...]:
    """The seven planets from Mercury to Neptune as seen from a place at times (...,), with parallax and aberration.

    By ERFA's `plan94` (Simon et al. 1994): within 0.03 degrees of DE421 in 1950-2050 (tested), as
    Saturn and Uranus are; the nearer ones within 0.02.

    >>> [planet.name for planet in planets(Place(50.0, 8.0), "2026-01-10T22:00Z") if planet.direction[2] > 0.5]
    ['Jupiter', 'Uranus']
    """
    require_kind(refraction, bool, "refraction", "True")
    Place.required(place)
    given = checked_years(instants(time))
    utc = given.ravel()
    here, velocity = earth(utc)
    return tuple(planet(name, place, utc, here, velocity, given.shape, refraction) for name in NUMBERS)


def planet(
    name: str,
    place: Place,
    utc: np.ndarray,
    here: np.ndarray,
    velocity: np.ndarray,
    shape: tuple[int, ...],
    refraction: bool,
) -> Planet:
    """One planet at instants (N,), its numbers in `shape`."""
    from erfa.ufunc import plan94  # does not warn of years outside 1000-3000

    days = terrestrial_days(utc)
    far = np.zeros(utc.shape)
    for _ in range(3):  # where it was when the light left
        there = plan94(JULIAN_DAY_J2000, days - far * LIGHT_DAYS_PER_AU, NUMBERS[name])[0]["p"]
        vector = there - here
        far = np.linalg.norm(vector, axis=-1)
    seen = aberrated(vector / far[:, None], velocity)
    near = from_place(place, seen * far[:, None], utc)
    toward = near / np.linalg.norm(near, axis=-1, keepdims=True)
    from_sun = np.linalg.norm(there, axis=-1)
    angle = np.arccos(np.clip(np.sum(there * vector, axis=-1) / (from_sun * far), -1, 1))
    bright = magnitude(name, from_sun, far, angle / deg, there, vector)
    direction = lifted(toward, place) if refraction else toward
    return Planet(name, direction.reshape(*shape, 3), *(x.reshape(shape) for x in (far, angle, bright)))


POLYNOMIALS = {
    "Mercury": (-0.613, 6.3280e-2, -1.6336e-3, 3.3644e-5, -3.4265e-7, 1.6893e-9, -3.0334e-12),
    "Venus": (-4.384, -1.044e-3, 3.687e-4, -2.814e-6, 8.938e-9),
    "Mars": (-1.601, 2.267e-2, -1.302e-4),
    "Jupiter": (-9.395, -3.7e-4, 6.16e-4),
    "Saturn": (-8.914, 0.026),
    "Uranus": (-7.110, 6.587e-3, 1.045e-4),
    "Neptune": (-7.00,),
}
"""Magnitude at 1 AU from sun and earth by powers of the phase angle in degrees (Mallama and Hilton 2018)."""

FAR_VENUS, FAR_MARS = (236.05828, -2.81914, 8.39034e-3), (-0.367, -0.02573, 3.445e-4)
"""The same for Venus beyond 163.7 degrees, and for Mars beyond 50."""


def magnitude(
    name: str, from_sun: np.ndarray, far: np.ndarray, phase: np.ndarray, there: np.ndarray, vector: np.ndarray
) -> np.ndarray:
    """Magnitude in V, (N,): Mallama and Hilton 2018; without the turning of Mars and the seasons of Uranus."""
    value = np.polynomial.polynomial.polyval
    unit = value(phase, POLYNOMIALS[name])
    if name == "Venus":
        unit = np.where(phase > 163.7, value(phase, FAR_VENUS), unit)
    if name == "Mars":
        unit = np.where(phase > 50.0, value(phase, FAR_MARS), unit)
    if name == "Saturn":
        unit = unit + rings(there, vector, phase)
    total: np.ndarray = unit + 5 * np.log10(from_sun * far)
    return total


def rings(there: np.ndarray, vector: np.ndarray, phase: np.ndarray) -> np.ndarray:
    """What Saturn's rings add to its magnitude, (N,): by how far earth and sun stand above their plane."""
    of_sun, of_earth = (np.arcsin(-(way @ POLE_OF_SATURN) / np.linalg.norm(way, axis=-1)) for way in (there, vector))
    both = np.sin(of_sun) * np.sin(of_earth)
    sine = np.sqrt(np.maximum(both, 0.0))
    added: np.ndarray = -1.825 * sine - 0.378 * sine * np.exp(-2.25 * phase)
    return added
