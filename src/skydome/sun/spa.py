"""NREL's Solar Position Algorithm as pvlib carries it, without the rest of pvlib.

`import pvlib` loads pandas and scipy (0.75 s, 100 MB); its file `spa.py` needs NumPy alone and loads in 4 ms. See
docs/decisions.md; a test compares with pvlib's public `spa_python`.
"""

import os
from functools import cache
from importlib.util import find_spec, module_from_spec, spec_from_file_location
from typing import Any

import numpy as np

MEAN_REFRACTION = 0.5667
"""Refraction at sunrise and sunset, degrees: SPA's own figure."""


@cache
def algorithm() -> Any:
    """The module pvlib/spa.py; ImportError where pvlib is not installed."""
    package = find_spec("pvlib")
    if package is None or not package.submodule_search_locations:
        raise ImportError("the sun's position needs pvlib: pip install pvlib")
    path = os.path.join(package.submodule_search_locations[0], "spa.py")
    spec = spec_from_file_location("skydome_pvlib_spa", path)
    if spec is None or spec.loader is None:
        raise ImportError("pvlib has no spa.py; skydome needs pvlib >= 0.12")
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def delta_t(utc: np.ndarray) -> Any:
    """Terrestrial minus universal time, s, for instants (N,) (Espenak and Meeus, by pvlib)."""
    months = utc.astype("datetime64[M]").astype(np.int64)
    return algorithm().calculate_deltat(months // 12 + 1970, months % 12 + 1)


def standard_pressure(altitude: float) -> float:
    """Pressure of the standard atmosphere at an altitude in metres, Pa.

    >>> round(standard_pressure(0.0))
    101325
    """
    return float(100 * ((44331.514 - altitude) / 11880.516) ** (1 / 0.1902632))


def positions(utc: np.ndarray, place: Any, pressure: float, temperature: float) -> np.ndarray:
    """Rows apparent zenith, zenith, apparent elevation, elevation, azimuth (degrees), equation of time: (6, N)."""
    table: np.ndarray = algorithm().solar_position(
        seconds(utc), place.latitude, place.longitude, place.altitude, pressure / 100, temperature,
        delta_t(utc), MEAN_REFRACTION,
    )  # fmt: skip
    return table


def distances(utc: np.ndarray) -> np.ndarray:
    """Distance of the sun, AU, at instants (N,)."""
    table = algorithm().solar_position(seconds(utc), 0.0, 0.0, 0.0, 1013.25, 12.0, delta_t(utc), 0.0, esd=True)
    distance: np.ndarray = np.asarray(table)[0]
    return distance


def seconds(utc: np.ndarray) -> np.ndarray:
    """Instants (datetime64[us]) as seconds since 1970."""
    elapsed: np.ndarray = utc.astype("datetime64[us]").astype(np.int64) / 1e6
    return elapsed
