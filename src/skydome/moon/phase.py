"""The moon's phase as seen from a place: its illuminated share, and which way its bright limb points."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from skydome.ground.labels import COMPONENTS, Parts, keeps_labels
from skydome.moon.geocentric import moon_vectors
from skydome.moon.libration import moon_axes, places_on_moon
from skydome.moon.position import seen_vectors
from skydome.sun.celestial import ASTRONOMICAL_UNIT, LIGHT_DAYS_PER_AU, earth, place_axes
from skydome.sun.place import Place
from skydome.sun.position import checked_years
from skydome.sun.times import Times, instants


@dataclass(frozen=True, eq=False)
class MoonPhase(Parts):
    """How the moon looks from a place; every number of the shape (...,) of the times, angles in radians.

    >>> from skydome.ground.units import deg
    >>> young = moon_phase(Place(50.0, 8.0), "2026-04-19T20:00+02:00")
    >>> round(float(young.illuminated), 3), bool(young.waxing), round(float(young.bright_limb) / deg)
    (0.072, True, 205)
    """

    direction: np.ndarray
    """Toward the moon's true place, (..., 3)."""
    toward_sun: np.ndarray
    """From the moon toward the sun, east, north and up, (..., 3)."""
    north: np.ndarray
    """The moon's axis of rotation, north, in the place's axes, (..., 3)."""
    phase_angle: np.ndarray
    """Between sun and place at the moon: 0 when it is full."""
    distance: np.ndarray
    """From the place to the moon, m."""
    sun_distance: np.ndarray
    """From the moon to the sun, AU."""
    waxing: np.ndarray
    """Whether it grows, seen from the earth's centre."""
    longitude_of_sun: np.ndarray
    """Selenographic longitude of the sun, east."""
    longitude: np.ndarray
    """Selenographic longitude of the place, east: libration."""
    latitude: np.ndarray
    """Selenographic latitude of the place: libration."""
    earth: np.ndarray
    """The earth's centre from the moon's, where sunlight that reaches the moon passed it, m, (..., 3)."""
    own_axes: ClassVar = dict.fromkeys(("direction", "toward_sun", "north", "earth"), (COMPONENTS,))
    units: ClassVar = {
        "phase_angle": "rad", "distance": "m", "sun_distance": "AU",
        "longitude_of_sun": "rad", "longitude": "rad", "latitude": "rad",
    }  # fmt: skip

    @property
    def illuminated(self) -> np.ndarray:
        """Share of the disc that is lit: (1 + cos of the phase angle) / 2."""
        return lit_share(self.phase_angle)

    @property
    def elongation(self) -> np.ndarray:
        """Angle between moon and sun as seen from the place, radians."""
        return elongation(self.direction, self.distance, self.toward_sun, self.sun_distance)

    @property
    def bright_limb(self) -> np.ndarray:
        """Where the middle of the bright limb lies: from the top of the disc, counterclockwise as seen, [0, 2 pi).

        0: lit from above; pi / 2: from the left; pi: from below, as a boat.
        """
        return clock_angle(self.direction, self.toward_sun)

    @property
    def axis(self) -> np.ndarray:
        """Where the moon's north pole lies on the disc, counted in the same way: about 180 degrees in the south."""
        return clock_angle(self.direction, self.north)


@keeps_labels(angle=0)
def lit_share(angle: np.ndarray) -> np.ndarray:
    """Share of the disc that is lit, (...,), at a phase angle."""
    return np.asarray((1 + np.cos(angle)) / 2)


@keeps_labels("rad", direction=1, distance=0, toward_sun=1, sun_distance=0)
def elongation(
    direction: np.ndarray, distance: np.ndarray, toward_sun: np.ndarray, sun_distance: np.ndarray
) -> np.ndarray:
    """Angle between moon and sun, (...,): the moon's direction and distance, m, and from it to the sun, AU."""
    moon = direction * (distance / ASTRONOMICAL_UNIT)[..., None]
    sun = moon + toward_sun * sun_distance[..., None]
    across = np.linalg.norm(np.cross(moon, sun), axis=-1)
    return np.asarray(np.arctan2(across, np.sum(moon * sun, axis=-1)))


@keeps_labels("rad", center=1, toward=1)
def clock_angle(center: np.ndarray, toward: np.ndarray) -> np.ndarray:
    """Angle at `center` (..., 3) of the way to `toward` (..., 3): from the zenith, counterclockwise, [0, 2 pi)."""
    left, up = left_and_up(center)
    along, across = np.sum(toward * up, axis=-1), np.sum(toward * left, axis=-1)
    return np.asarray(np.arctan2(across, along) % (2 * np.pi))


def left_and_up(center: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Unit vectors to the left of and up from directions (..., 3), as one sees them who looks there."""
    flat = np.stack([-center[..., 1], center[..., 0], np.zeros_like(center[..., 0])], axis=-1)
    size = np.linalg.norm(flat, axis=-1, keepdims=True)
    left = np.where(size > 0, flat / np.where(size > 0, size, 1.0), [1.0, 0.0, 0.0])
    return left, np.cross(center, left)


@keeps_labels(time=0)
def moon_phase(place: Place, time: Times) -> MoonPhase:
    """The `MoonPhase` at times (...,) from a place.

    >>> full = moon_phase(Place(50.0, 8.0), "2026-01-03T11:00+01:00")
    >>> round(float(full.illuminated), 3)
    0.999
    """
    Place.required(place)
    given = checked_years(instants(time))
    utc = given.ravel()
    axes = place_axes(place, utc)
    moon = seen_vectors(place, utc)
    (from_sun, velocity), from_centre = earth(utc), moon_vectors(utc)
    sun = -from_sun - from_centre
    turned = moon_axes(utc)
    of_sun, _ = places_on_moon(turned, sun)
    back = -np.einsum("nji,nj->ni", axes, moon)
    longitude, latitude = places_on_moon(turned, back)
    toward_sun = np.einsum("nij,nj->ni", axes, sun)
    north = np.einsum("nij,nj->ni", axes, turned[:, 2])
    way = np.linalg.norm(from_centre, axis=-1, keepdims=True) * LIGHT_DAYS_PER_AU
    centre = -np.einsum("nij,nj->ni", axes, from_centre + velocity * way) * ASTRONOMICAL_UNIT
    size, far = np.linalg.norm(moon, axis=-1), np.linalg.norm(toward_sun, axis=-1)
    angle = np.arctan2(np.linalg.norm(np.cross(moon, toward_sun), axis=-1), -np.sum(moon * toward_sun, axis=-1))
    told = {
        "direction": moon / size[:, None], "toward_sun": toward_sun / far[:, None], "north": north,
        "phase_angle": angle, "distance": size * ASTRONOMICAL_UNIT, "sun_distance": far, "waxing": np.sin(of_sun) > 0,
        "longitude_of_sun": of_sun, "longitude": longitude, "latitude": latitude, "earth": centre,
    }  # fmt: skip
    return MoonPhase(**{name: value.reshape(given.shape + value.shape[1:]) for name, value in told.items()})
