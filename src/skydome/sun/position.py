"""Where the sun stands: NREL's Solar Position Algorithm (SPA), as pvlib carries it."""

from typing import Any

import numpy as np

from skydome.ground.directions import direction
from skydome.ground.units import deg
from skydome.sun.place import Place
from skydome.sun.spa import distances, positions, standard_pressure
from skydome.sun.times import instants

YEARS = (-1999, 3000)
"""Years for which the difference between terrestrial and universal time is known or foreseen (Espenak and Meeus)."""

SOLAR_RADIUS_AT_1_AU = 959.63 / 3600 * deg
"""Angular radius of the sun's disc at 1 AU, radians (959.63 arcsec; Auwers 1891, used by the almanacs)."""


def sun_direction(
    place: Place, time: Any, refraction: bool = False, pressure: float | None = None, temperature: float = 12.0
) -> np.ndarray:
    """Unit vectors toward the centre of the sun's disc, shape (..., 3) for times (...,); float64.

    `time` is anything that `instants` takes. Without `refraction` the direction is the true (airless) one, which sky
    models expect; with it, the one seen, for `pressure` in Pa (None: that of the standard atmosphere at the place's
    altitude) and `temperature` in degrees C. SPA corrects a sun below -0.83 degrees by nothing.

    Reda and Andreas 2004, https://doi.org/10.1016/j.solener.2003.12.003, by pvlib: 0.0003 degrees for
    the years -2000 to 6000, with Espenak and Meeus' polynomial for delta T (some seconds off after 2015, below 0.0001
    degrees).

    >>> turin = Place(latitude=45.07, longitude=7.69, altitude=240)
    >>> sun_direction(turin, "2026-06-21T15:00+02:00").round(4).tolist()
    [-0.3472, -0.3204, 0.8814]
    """
    toward: np.ndarray = direction(*sun_angles(place, time, refraction, pressure, temperature))
    return toward


def sun_angles(
    place: Place, time: Any, refraction: bool = False, pressure: float | None = None, temperature: float = 12.0
) -> tuple[np.ndarray, np.ndarray]:
    """Azimuth (clockwise from north, [0, 2 pi)) and elevation of the sun, radians, each (...,); see `sun_direction`.

    At a pole the azimuth counts from the meridian of the place's longitude.

    >>> azimuth, elevation = sun_angles(Place(0.0, 0.0), "2026-03-20T12:00Z")
    >>> round(float(elevation) / deg, 1)
    88.1
    """
    utc = instants(time)
    pressure = standard_pressure(place.altitude) if pressure is None else pressure
    table = positions(checked_years(utc).ravel(), place, pressure, temperature)
    _, _, apparent, true, azimuth, _ = table.reshape(6, *utc.shape)
    return azimuth * deg, (apparent if refraction else true) * deg


def earth_sun_distance(time: Any) -> np.ndarray:
    """Distance between the centres of the earth and the sun, AU, shape (...,); SPA's, by pvlib.

    >>> earth_sun_distance(["2026-01-03T17:00Z", "2026-07-06T17:00Z"]).round(4).tolist()
    [0.9833, 1.0166]
    """
    utc = instants(time)
    return distances(checked_years(utc).ravel()).reshape(utc.shape)


def solar_radius(time: Any) -> np.ndarray:
    """Angular radius of the sun's disc seen from the earth, radians, shape (...,): 959.63 arcsec at 1 AU.

    >>> (solar_radius("2026-01-03T17:00Z") / deg).round(4).tolist()
    0.2711
    """
    radius: np.ndarray = np.arcsin(np.sin(SOLAR_RADIUS_AT_1_AU) / earth_sun_distance(time))
    return radius


def checked_years(utc: np.ndarray) -> np.ndarray:
    """The instants, any shape; ValueError outside `YEARS`."""
    years = utc.astype("datetime64[Y]").astype(np.int64) + 1970
    if years.size and (years.min() < YEARS[0] or years.max() > YEARS[1]):
        wrong = years.min() if years.min() < YEARS[0] else years.max()
        raise ValueError(f"time must lie in the years {YEARS[0]} to {YEARS[1]}, got {wrong}")
    return utc
