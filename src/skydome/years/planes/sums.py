"""Sums of a year's light: by month and in all on planes, and the sky of a period added up patch by patch."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arguments import require_kind
from skydome.ground.arrays import brief
from skydome.ground.extras import required
from skydome.ground.units import deg

if TYPE_CHECKING:
    import xarray

SUMS = {"irradiance": ("irradiation", "kWh m-2"), "illuminance": ("light_exposure", "klx h")}


def monthly_sums(light: "xarray.Dataset") -> "xarray.Dataset":
    """Irradiation, kWh m-2, and light exposure, klx h, of `on_planes`, by month of local time and part, (month, plane).

    Hours without data count 0 and are told in `missing_hours` (month). `.sum("month")` is the whole.

    >>> import pandas as pd, skydome as sd
    >>> times = pd.date_range("2026-06-21T06:00", periods=12, freq="h", tz="UTC")
    >>> frame = pd.DataFrame({"dni": 600.0, "dhi": 100.0}, index=times)
    >>> sums = monthly_sums(sd.on_planes(frame, sd.Plane(), place=sd.Place(45.07, 7.69)))
    >>> sums.month.values.tolist(), round(float(sums.sky_irradiation.sum("month")[0]), 3)
    ([6], 1.2)
    """
    required("xarray", "year", "sums of a year")
    import xarray

    require_kind(light, xarray.Dataset, "light", "on_planes(year, planes)")
    require_variables(light, ("irradiance", "local_time", "interval_hours"), "on_planes")
    local = light["local_time"].values.astype("datetime64[M]").astype(np.int64) % 12 + 1
    months = np.unique(local)
    hours = (months[:, None] == local) * light["interval_hours"].values  # (M, T)
    found: dict[str, Any] = {}
    for name in light.data_vars:
        part, _, quantity = str(name).rpartition("_")
        if quantity in SUMS:
            title, unit = SUMS[quantity]
            text = str(light[name].attrs["long_name"]).replace(quantity, title.replace("_", " "))
            total = hours @ np.nan_to_num(light[name].values) / 1000
            found[f"{part}_{title}".lstrip("_")] = (("month", "plane"), total, {"units": unit, "long_name": text})
    lacking = hours @ np.isnan(light["irradiance"].values).any(axis=1)
    found["missing_hours"] = ("month", lacking, {"units": "h", "long_name": "hours without data, counted as 0"})
    planes = {name: value.variable for name, value in light.coords.items() if value.dims == ("plane",)}
    return xarray.Dataset(found, {"month": months} | planes, light.attrs)


def cumulative_sky(skies: "xarray.Dataset", when: ArrayLike | None = None) -> "xarray.Dataset":
    """The sky of a period added up: radiant exposure, kWh m-2 sr-1, and luminous, by patch, (patch,).

    `sky_radiant_exposure` and `sun_radiant_exposure` (the direct light spread over the patch in which each hour's sun
    stands), and the same `luminous`, klx h sr-1. `when` (T,) says which hours count (None: all): one cumulative sky
    then stands for a season or for working hours, as GenCumulativeSky's (Robinson and Stone 2004). A plane's
    irradiation in the open is their sum times its projected solid angles.

    >>> import pandas as pd, skydome as sd
    >>> times = pd.date_range("2026-06-21T06:00", periods=12, freq="h", tz="UTC")
    >>> frame = pd.DataFrame({"dni": 600.0, "dhi": 100.0}, index=times)
    >>> total = cumulative_sky(sd.year(frame, place=sd.Place(45.07, 7.69)))
    >>> round(float((total.sky_radiant_exposure * total.horizontal_solid_angle).sum()), 3)
    1.2
    """
    required("xarray", "year", "a cumulative sky")
    import xarray

    require_kind(skies, xarray.Dataset, "skies", 'year("turin.epw")')
    require_variables(skies, ("luminance", "sun_patch", "solid_angle", "interval_hours"), "year")
    hours = chosen_hours(skies, when)
    light = np.nan_to_num(skies["luminance"].values)
    level = np.nan_to_num(skies["diffuse_horizontal_illuminance"].values)
    diffuse, direct, sun = (np.nan_to_num(skies[name].values) for name in RADIANT)
    efficacy = np.divide(diffuse, level, out=np.zeros_like(level), where=level > 0)
    stands, size = skies["sun_patch"].values, skies["solid_angle"].values
    up = np.maximum(np.sin(skies["sun_elevation"].values * deg), 0) > 0
    exposures: dict[str, Any] = {}
    for name, unit, sky_level, beam in (
        ("radiant", "kWh m-2 sr-1", efficacy, direct),
        ("luminous", "klx h sr-1", 1.0, sun),
    ):
        sky = (hours * sky_level / 1000).astype(np.float64) @ light
        counted = np.where(up & (stands >= 0), hours * beam / 1000, 0.0)
        spread = np.bincount(np.maximum(stands, 0), counted, len(size)) / size
        for part, values in (("sky", sky), ("sun", spread)):
            about = {"units": unit, "long_name": f"{name} exposure from the {part}, by patch"}
            exposures[f"{part}_{name}_exposure"] = ("patch", values, about)
    places = {name: value.variable for name, value in skies.coords.items() if value.dims == ("patch",)}
    kept = {name: value for name, value in skies.attrs.items() if name not in ("title", "model")}
    title = skies.attrs["title"].replace("A year of skies", "A cumulative sky")
    return xarray.Dataset(exposures, places, {"title": title} | kept | {"hours": float(hours.sum())})


def require_variables(data: "xarray.Dataset", names: tuple[str, ...], maker: str) -> None:
    """ValueError with what lacks, unless the Dataset has all the names."""
    lacking = [name for name in names if name not in data]
    if lacking:
        raise ValueError(f"a Dataset of `{maker}` is asked for, got one without {', '.join(lacking)}")


RADIANT = ("diffuse_horizontal_irradiance", "direct_normal_irradiance", "direct_normal_illuminance")


def chosen_hours(skies: "xarray.Dataset", when: ArrayLike | None) -> np.ndarray:
    """Length of each interval that counts, h, 0 of the others, (T,); ValueError for a choice of another length."""
    length: np.ndarray = skies["interval_hours"].values
    if when is None:
        return length
    try:
        chosen = np.asarray(when)
    except ValueError:  # a list of lists of several lengths
        raise ValueError(f"when must be booleans of shape {length.shape}, got {brief(when)}") from None
    if chosen.shape != length.shape or chosen.dtype != bool:
        raise ValueError(f"when must be booleans of shape {length.shape}, got {chosen.dtype} of {chosen.shape}")
    kept: np.ndarray = length * chosen
    return kept
