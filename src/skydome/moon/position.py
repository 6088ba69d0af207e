"""Where the moon stands over a place, how far away and how large."""

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.directions import azimuth, elevation
from skydome.ground.labels import COMPONENTS, keeps_labels
from skydome.moon.geocentric import moon_vectors
from skydome.sun.celestial import ASTRONOMICAL_UNIT, from_place
from skydome.sun.place import Place
from skydome.sun.position import checked_years, lifted
from skydome.sun.times import Times, instants

LUNAR_RADIUS = 1_737_400.0
"""Mean radius of the moon, m (IAU 2015)."""


def seen_vectors(place: Place, utc: np.ndarray) -> np.ndarray:
    """The moon from the place, AU, east, north and up, (..., 3), at instants (...,)."""
    flat = utc.ravel()
    return from_place(place, moon_vectors(flat), flat).reshape(*utc.shape, 3)


@keeps_labels(last=(COMPONENTS,), time=0)
def moon_direction(
    place: Place, time: Times, refraction: bool = False, pressure: float | None = None, temperature: float = 12.0
) -> np.ndarray:
    """Unit vectors toward the centre of the moon's disc, shape (..., 3) for times (...,); float64.

    Seen from the place, not from the earth's centre: the parallax is up to a degree. Arguments and refraction as in
    `sun_direction`. Within 0.004 degrees of the JPL's ephemeris DE421 in 1950-2050 (tested).

    >>> turin = Place(latitude=45.07, longitude=7.69, altitude=240)
    >>> moon_direction(turin, "2026-08-12T20:00+02:00").round(3).tolist()
    [-0.96, 0.261, 0.102]
    """
    Place.required(place)
    require_kind(refraction, bool, "refraction", "True")
    vectors = seen_vectors(place, checked_years(instants(time)))
    toward: np.ndarray = vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
    return lifted(toward, place, pressure, temperature) if refraction else toward


@keeps_labels("rad", time=0)
def moon_angles(
    place: Place, time: Times, refraction: bool = False, pressure: float | None = None, temperature: float = 12.0
) -> tuple[np.ndarray, np.ndarray]:
    """Azimuth (clockwise from north, [0, 2 pi)) and elevation of the moon, radians, each (...,).

    >>> azimuth, elevation = moon_angles(Place(50.0, 8.0), "2026-01-03T22:00Z")
    >>> round(float(elevation * 180 / np.pi), 1)
    55.3
    """
    toward = moon_direction(place, time, refraction, pressure, temperature)
    return azimuth(toward), elevation(toward)


@keeps_labels("m", time=0)
def moon_distance(place: Place, time: Times) -> np.ndarray:
    """Distance from the place to the moon's centre, m, shape (...,).

    >>> round(float(moon_distance(Place(45.07, 7.69), "2026-08-12T20:00+02:00")), -5)
    366300000.0
    """
    Place.required(place)
    distance: np.ndarray = np.linalg.norm(seen_vectors(place, checked_years(instants(time))), axis=-1)
    return distance * ASTRONOMICAL_UNIT


@keeps_labels("rad", time=0)
def lunar_radius(place: Place, time: Times) -> np.ndarray:
    """Angular radius of the moon's disc seen from the place, radians, shape (...,).

    >>> from skydome.ground.units import deg
    >>> round(float(lunar_radius(Place(45.07, 7.69), "2026-08-12T20:00+02:00")) / deg, 3)
    0.272
    """
    radius: np.ndarray = np.arcsin(LUNAR_RADIUS / moon_distance(place, time))
    return radius
