"""Twilight in a coloured year: hours without irradiance take the light of the clear sky itself."""

from typing import TYPE_CHECKING, Any

import numpy as np

from skydome.dome.patches import Patches
from skydome.sun.day import is_day
from skydome.sun.position import earth_sun_distance
from skydome.years.skies.colour_year import Weathered, clear_sky, lender
from skydome.years.skies.perez_year import PerezYear
from skydome.years.skies.status import BITS

if TYPE_CHECKING:
    import xarray


def with_twilight(
    data: "xarray.Dataset", sky: PerezYear, cut: Patches, colour: str, air: Weathered, turbidity: Any
) -> tuple[PerezYear, Weathered]:
    """The lit hours and their weather with those of twilight after them, whose light is put into `data`.

    They are the intervals at whose middle the sun is below the horizon and the clear sky of that `colour` has light
    (`lowest_sun`), flagged "twilight": luminance and diffuse illuminance are its own, for nothing measured tells of
    clouds. A sky that knows no twilight adds none.
    """
    luminance, lowest = data["luminance"].values, lender(colour).kind.lowest_sun
    down = (sky.share == 0) & (sky.suns[:, 2] <= 0) & is_day(sky.suns, lowest) & ~np.isnan(luminance[:, 0])
    rows = np.flatnonzero(down)
    if not len(rows):
        return sky, air
    haze = np.broadcast_to(np.asarray(turbidity, dtype=np.float64), down.shape)[rows]
    nearer = earth_sun_distance(sky.times[rows]) ** -2
    clear = clear_sky(colour, sky.suns[rows], haze, data.attrs["altitude"])
    luminance[rows] = np.asarray(clear.luminance(cut.directions)) * nearer[:, None]
    data["diffuse_horizontal_illuminance"].values[rows] = luminance[rows] @ cut.horizontal_solid_angles
    data["status"].values[rows] |= BITS["twilight"]
    weather = Weathered(np.concatenate([air.haze, haze]), np.concatenate([air.clouds, np.zeros(len(rows))]))
    return sky._replace(lit=np.concatenate([sky.lit, rows])), weather
