"""Where the sun stands over a place: from the earth's centre to the place, and lifted by the air."""

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array, floating, namespace
from skydome.ground.directions import azimuth, direction, elevation
from skydome.ground.labels import COMPONENTS, keeps_labels
from skydome.ground.units import deg
from skydome.sun.celestial import local_axes, station
from skydome.sun.geocentric import distances, earth_fixed
from skydome.sun.place import Place
from skydome.sun.refraction import lift, standard_pressure
from skydome.sun.times import Times, instants

YEARS = (-1999, 3000)
"""Years for which the difference between terrestrial and universal time is known or foreseen (Espenak and Meeus)."""

SOLAR_RADIUS_AT_1_AU = 959.63 / 3600 * deg
"""Angular radius of the sun's disc at 1 AU, radians (959.63 arcsec; Auwers 1891, used by the almanacs)."""


@keeps_labels(last=(COMPONENTS,), time=0)
def sun_direction(
    place: Place, time: Times, refraction: bool = False, pressure: float | None = None, temperature: float = 12.0
) -> np.ndarray:
    """Unit vectors toward the centre of the sun's disc, shape (..., 3) for times (...,); float64.

    `time` is anything that `instants` takes. Without `refraction` the direction is the true (airless) one, which sky
    models expect; with it, the one seen, for `pressure` in Pa (None: that of the standard atmosphere at the place's
    altitude) and `temperature` in degrees C. A sun below -0.83 degrees is corrected by nothing.

    In all `YEARS` within 0.00002 degrees of NREL's Solar Position Algorithm (Reda and Andreas 2004), which states
    0.0003 for itself; from 1900 to 2026 within 0.00025 of the JPL's ephemeris DE421. Both when `time` is UT1, which the
    turning of the earth keeps. A clock keeps UTC, at most 0.9 s away since 1972: 0.004 degrees along the sun's course.
    Sources: `skydome.sun.geocentric`, `skydome.sun.delta_t`.

    >>> turin = Place(latitude=45.07, longitude=7.69, altitude=240)
    >>> sun_direction(turin, "2026-06-21T15:00+02:00").round(4).tolist()
    [-0.3472, -0.3204, 0.8814]
    """
    Place.required(place)
    require_kind(refraction, bool, "refraction", "True")
    toward = topocentric(place, checked_years(instants(time)))
    return lifted(toward, place, pressure, temperature) if refraction else toward


@keeps_labels("rad", time=0)
def sun_angles(
    place: Place, time: Times, refraction: bool = False, pressure: float | None = None, temperature: float = 12.0
) -> tuple[np.ndarray, np.ndarray]:
    """Azimuth (clockwise from north, [0, 2 pi)) and elevation of the sun, radians, each (...,); see `sun_direction`.

    At a pole the azimuth counts from the meridian of the place's longitude.

    >>> azimuth, elevation = sun_angles(Place(0.0, 0.0), "2026-03-20T12:00Z")
    >>> round(float(elevation) / deg, 1)
    88.1
    """
    toward = sun_direction(place, time, refraction, pressure, temperature)
    return azimuth(toward), elevation(toward)


def topocentric(place: Place, utc: np.ndarray) -> np.ndarray:
    """Unit vectors from the place to the true sun, x east, y north, z up, shape (..., 3), at instants (...,)."""
    return seen_from(place, earth_fixed(utc.ravel()).reshape(*utc.shape, 3))


def seen_from(place: Place, sun: np.ndarray) -> np.ndarray:
    """Unit vectors (..., 3), x east, y north, z up, from the place to the sun (..., 3), AU, in the earth's axes."""
    toward: np.ndarray = (sun - station(place)) @ local_axes(place).T
    toward /= np.sqrt(np.einsum("...i,...i->...", toward, toward))[..., None]
    return toward


def lifted(toward: np.ndarray, place: Place, pressure: float | None = None, temperature: float = 12.0) -> np.ndarray:
    """Directions (..., 3) lifted by refraction, for `pressure` in Pa (None: that of the place's altitude)."""
    high = elevation(toward)
    raised = lift(high, standard_pressure(place.altitude) if pressure is None else pressure, temperature)
    seen: np.ndarray = direction(azimuth(toward), high + raised)
    return seen


@keeps_labels("AU", time=0)
def earth_sun_distance(time: Times) -> np.ndarray:
    """Distance between the centres of the earth and the sun, AU, shape (...,), by VSOP87.

    >>> earth_sun_distance(["2026-01-03T17:00Z", "2026-07-06T17:00Z"]).round(4).tolist()
    [0.9833, 1.0166]
    """
    utc = instants(time)
    return distances(checked_years(utc).ravel()).reshape(utc.shape)


@keeps_labels("rad", time=0)
def solar_radius(time: Times) -> np.ndarray:
    """Angular radius of the sun's disc seen from the earth, radians, shape (...,): 959.63 arcsec at 1 AU.

    >>> (solar_radius("2026-01-03T17:00Z") / deg).round(4).tolist()
    0.2711
    """
    radius: np.ndarray = radius_at(earth_sun_distance(time))
    return radius


@keeps_labels("rad", distance=0)
def radius_at(distance: Array) -> Array:
    """Angular radius of the sun's disc from a distance in AU, radians, shape of `distance`.

    >>> round(float(radius_at(1.0)) / deg, 4)
    0.2666
    """
    return namespace(distance).asin(np.sin(SOLAR_RADIUS_AT_1_AU) / floating(distance))


def checked_years(utc: np.ndarray) -> np.ndarray:
    """The instants, any shape; ValueError outside `YEARS`."""
    years = utc.astype("datetime64[Y]").astype(np.int64) + 1970
    if years.size and (years.min() < YEARS[0] or years.max() > YEARS[1]):
        wrong = years.min() if years.min() < YEARS[0] else years.max()
        raise ValueError(f"time must lie in the years {YEARS[0]} to {YEARS[1]}, got {wrong}")
    return utc
