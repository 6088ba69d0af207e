"""Which of the CIE's fifteen skies each hour of a year is nearest to (Tregenza 2004)."""

from typing import TYPE_CHECKING

import numpy as np

from skydome.dome.patches import patches as patches_named
from skydome.ground.directions import direction
from skydome.ground.units import deg
from skydome.skies.cie import CIE

if TYPE_CHECKING:
    import xarray

TYPES = np.arange(1, 16)
HOURS_AT_ONCE = 256


def cie_types(skies: "xarray.Dataset") -> tuple[np.ndarray, np.ndarray]:
    """The CIE type, 1 to 15, nearest to each hour's sky, 0 without light, and how far it is off, (T,) each.

    Of luminances at the patches' centres over the diffuse horizontal illuminance, the type of the least root mean
    square difference over all patches is chosen (Tregenza 2004, Lighting Research and Technology 36, 271); the second
    array is that difference over the mean.

    >>> import pandas as pd, skydome as sd
    >>> times = pd.date_range("2026-06-21T09:00", periods=2, freq="h", tz="UTC")
    >>> frame = pd.DataFrame({"dni": [0.0, 850.0], "dhi": [250.0, 80.0]}, index=times)
    >>> types, _ = cie_types(sd.year(frame, place=sd.Place(45.07, 7.69)))
    >>> types.tolist()
    [3, 14]
    """
    cut = patches_named(skies.attrs["patches"])
    light = np.nan_to_num(skies["luminance"].values).astype(np.float64)
    suns = direction(skies["sun_azimuth"].values * deg, skies["sun_elevation"].values * deg)
    chosen, off = np.zeros(len(light), np.int8), np.full(len(light), np.nan)
    lit = np.flatnonzero((skies["sun_elevation"].values > 0) & light.any(axis=1))
    for k in range(0, lit.size, HOURS_AT_ONCE):
        rows = lit[k : k + HOURS_AT_ONCE]
        own = light[rows] / (light[rows] @ cut.horizontal_solid_angles)[:, None]
        standard = CIE(suns[rows, None, None], TYPES[:, None], zenith_luminance=1.0, check="clamp")
        shapes = np.asarray(standard.luminance(cut.directions))
        shapes = shapes / (shapes @ cut.horizontal_solid_angles)[..., None]
        error = np.sqrt(((shapes - own[:, None]) ** 2).mean(axis=-1))
        best = error.argmin(axis=1)
        chosen[rows] = TYPES[best]
        off[rows] = error[np.arange(len(rows)), best] / own.mean(axis=1)
    return chosen, off
