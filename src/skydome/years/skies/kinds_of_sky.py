"""The kind of each hour's sky: overcast, partly cloudy or clear, and how unsteady its light is."""

import csv
from os import PathLike
from typing import TYPE_CHECKING

import numpy as np

from skydome.ground.extras import required
from skydome.ground.units import SOLAR_CONSTANT
from skydome.ground.writing import appearing
from skydome.skies.formula.perez_table import clearness_bin
from skydome.sun.position import earth_sun_distance
from skydome.years.quality.clear_sky import ineichen
from skydome.years.skies.cie_of_year import cie_types

if TYPE_CHECKING:
    import xarray

KINDS = ("", "overcast", "partly cloudy", "clear")
"""What the CIE's types 1-5, 6-10 and 11-15 are; the first for an hour without light."""
TYPICAL = 3.0
"""Linke's turbidity of the clear sky that variability is counted by."""
STEADY = np.timedelta64(90, "m")
"""Rows further apart than this are no neighbours."""


def sky_kinds(skies: "xarray.Dataset") -> "xarray.Dataset":
    """The kind of each hour of a year of skies, as a Dataset (time,): `skies.merge(sky_kinds(skies))`.

    `kind`, index in `KINDS`, by groups of the `cie_type` 1-15 that the sky's patches are nearest to (Tregenza 2004; CIE
    S 011: overcast and uniform, partly cloudy, clear and turbid), 0 without light; `perez_category` 1 (overcast) to 8
    (clear), by clearness (Perez et al. 1990, Table 1); `variability`, the root mean square change of the clear-sky
    index to the hours before and after (Skartveit, Olseth and Tuft 1998), NaN where it has no neighbour with light.

    >>> import pandas as pd, skydome as sd
    >>> times = pd.date_range("2026-06-21T09:00", periods=3, freq="h", tz="UTC")
    >>> frame = pd.DataFrame({"dni": [0.0, 250.0, 850.0], "dhi": [250.0, 400.0, 80.0]}, index=times)
    >>> found = sky_kinds(sd.year(frame, place=sd.Place(45.07, 7.69)))
    >>> [KINDS[kind] for kind in found.kind.values], found.perez_category.values.tolist()
    (['overcast', 'partly cloudy', 'clear'], [1, 4, 8])
    """
    required("xarray", "year", "kinds of sky")
    import xarray

    types, off = cie_types(skies)
    lit = types > 0
    category = np.where(lit, np.asarray(clearness_bin(np.nan_to_num(skies["clearness"].values))) + 1, 0)
    names = " ".join(name.replace(" ", "_") or "no_light" for name in KINDS)
    columns = {
        "kind": (-(-types // 5), {"flag_values": np.arange(4, dtype=np.int8), "flag_meanings": names}),
        "cie_type": (types, {"long_name": "type of CIE S 011 that the sky is nearest to"}),
        "cie_error": (off, {"long_name": "rms difference to that type over the mean luminance"}),
        "perez_category": (category.astype(np.int8), {"long_name": "category of clearness, Perez et al. 1990"}),
        "variability": (variability(skies, lit), {"long_name": "rms change of the clear-sky index to its neighbours"}),
    }
    return xarray.Dataset({name: ("time", *parts) for name, parts in columns.items()}, {"time": skies["time"]})


def variability(skies: "xarray.Dataset", lit: np.ndarray) -> np.ndarray:
    """Of the clear-sky index of lit hours, (T,): NaN where neither the hour before nor that after has light."""
    index, times = np.where(lit, clear_sky_index(skies), np.nan), skies["time"].values
    change = np.where(np.diff(times) <= STEADY, np.diff(index) ** 2, np.nan)
    both = np.stack([np.append(np.nan, change), np.append(change, np.nan)])
    known = np.isfinite(both)
    count = np.where(known.any(axis=0), known.sum(axis=0), np.nan)
    return np.asarray(np.sqrt(np.where(known, both, 0.0).sum(axis=0) / count))


def clear_sky_index(skies: "xarray.Dataset") -> np.ndarray:
    """Global irradiance over that of Ineichen and Perez's clear sky of turbidity 3, (T,)."""
    elevation = np.radians(skies["sun_elevation"].values)
    direct, diffuse = (skies[f"{part}_irradiance"].values for part in ("direct_normal", "diffuse_horizontal"))
    outside = SOLAR_CONSTANT / earth_sun_distance(skies["sun_time"].values) ** 2
    clear = ineichen(np.pi / 2 - elevation, outside, float(skies.attrs["altitude"]), TYPICAL).global_horizontal
    whole = diffuse + direct * np.maximum(np.sin(elevation), 0.0)
    return np.asarray(whole / np.maximum(clear, 1.0))


def write_kinds(skies: "xarray.Dataset", path: str | PathLike[str]) -> dict[str, int]:
    """Write the kind of each hour as a table (.csv), whole or not at all; how many hours are of each kind."""
    found = sky_kinds(skies)
    local = skies["local_time"].values.astype("datetime64[m]")
    known = skies["sun_elevation"].values, skies["clearness"].values
    shown = zip(local, *known, *(found[name].values for name in found), strict=True)
    with appearing(path) as beside, beside.open("w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["local_time", "sun_elevation", "clearness", *found])
        for time, elevation, clear, kind, number, *others in shown:
            told = ("" if np.isnan(value) else f"{value:.4g}" for value in others)
            rows.writerow([time, f"{elevation:.2f}", f"{clear:.3f}", KINDS[kind], number, *told])
    counts = np.bincount(found["kind"].values, minlength=len(KINDS))
    return {name: int(count) for name, count in zip(KINDS, counts, strict=True) if name}
