"""Does the sun of a place fit the irradiances given for it? A wrong sign shows at dawn and dusk."""

import warnings
from dataclasses import replace

import numpy as np

from skydome.sun.place import Place
from skydome.sun.preetham_position import preetham_sun_direction
from skydome.years.weather.weather import Weather

SUSPICIOUS, BETTER = 0.004, 0.35
"""Share of the irradiance that may fall at night, and the part of it that another place must leave."""


def share_at_night(weather: Weather, place: Place) -> float:
    """Share of the direct normal and diffuse irradiance in intervals during which the sun is down at `place`, 0-1."""
    direct, diffuse = weather.irradiances
    energy = direct + diffuse
    if not np.any(energy > 0):
        return 0.0
    quarter = (weather.end - weather.start) // 4
    times = np.stack([weather.start + k * quarter for k in range(5)])
    up = (preetham_sun_direction(place, times.astype("datetime64[us]"))[..., 2] > np.sin(np.radians(-1.0))).any(axis=0)
    return float(energy[~up].sum() / energy.sum())


def turned(place: Place) -> dict[str, Place]:
    """The places that a slip of sign would have meant."""
    return {
        f"longitude {-place.longitude:g}": replace(place, longitude=-place.longitude),
        f"latitude {-place.latitude:g}": replace(place, latitude=-place.latitude),
    }


def warn_of_wrong_place(weather: Weather, lit: np.ndarray | None = None) -> None:
    """Warn (UserWarning) where much irradiance falls at night and far less would with the other sign.

    `lit` (T,), the share of each interval in which the sun is up, spares the closer look where all is well.
    """
    if lit is not None:
        energy = np.add(*weather.irradiances)
        if energy[lit == 0].sum() <= SUSPICIOUS * energy.sum():
            return
    here = share_at_night(weather, weather.place)
    if here <= SUSPICIOUS:
        return
    others = {name: share_at_night(weather, place) for name, place in turned(weather.place).items()}
    best = min(others, key=lambda name: others[name])
    hint = f"; with {best} it would be {others[best]:.1%}: is a sign wrong?" if others[best] < BETTER * here else ""
    if hint or here > 0.03:
        hint = hint or "; are the time zone and the label of the interval right?"
        warnings.warn(f"{here:.1%} of the irradiance falls while the sun is down{weather.where}{hint}", stacklevel=3)
