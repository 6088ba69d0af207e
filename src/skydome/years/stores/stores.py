"""A Dataset to a Zarr store or a netCDF file that appears whole or not at all."""

import json
import os
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from skydome.dome.patches import patches as patches_named
from skydome.ground.extras import required
from skydome.ground.files.folders import folder_appearing, folder_replacing, is_empty
from skydome.ground.files.leftovers import sweep
from skydome.ground.writing import appearing, require_place
from skydome.years.skies.series import year
from skydome.years.weather.closure import facts_of
from skydome.years.weather.plausibility import warn_of_wrong_place
from skydome.years.weather.weather import Weather

if TYPE_CHECKING:
    import xarray

MAKER = "skydome year"
"""By which a store tells that it may be replaced."""


def write_dataset(data: "xarray.Dataset", path: str | os.PathLike[str], overwrite: bool = False) -> None:
    """Write .zarr (a folder) or .nc; what was there before stays until the new one is whole.

    ValueError for another ending; FileExistsError for a folder that is there, unless it is a year that was written
    like this and `overwrite` says so; OSError with nothing left behind where the disk is full.
    """
    final = Path(path)
    if final.suffix.lower() == ".nc":
        required("h5netcdf", "year", "a year as .nc")
        packed = {"luminance": {"zlib": True, "complevel": 1}} if "luminance" in data else {}
        # In memory first: on a full disk libhdf5 does not only fail, it takes the process with it.
        content = data.to_netcdf(engine="h5netcdf", encoding=packed)
        with appearing(final) as beside:
            beside.write_bytes(content)
        return
    if final.suffix.lower() != ".zarr":
        raise ValueError(f"a year must be written as .zarr or .nc, got {final.name!r}")
    required("zarr", "year", "a year as .zarr")
    with store_appearing(final, overwrite) as beside:
        data.assign_attrs(written_by=MAKER).to_zarr(beside, mode="w-")


def write_year(
    weather: Weather,
    path: str | os.PathLike[str],
    values_at_once: int = 1 << 25,
    overwrite: bool = False,
    **choices: Any,
) -> "xarray.Dataset":
    """Write the Dataset of `year(weather, **choices)` to a Zarr store some hours at a time; the Dataset in the store.

    Memory is bounded: about `values_at_once` float32 numbers are held of the largest variable, and the Dataset reads
    from the store what is asked of it. ValueError for compat="gendaymtx", whose dew points look back; FileExistsError
    as in `write_dataset`.
    """
    required("zarr", "year", "a year as .zarr")
    import xarray

    if choices.get("compat") == "gendaymtx":
        raise ValueError('compat="gendaymtx" is written whole: use year(...) and write_dataset')
    wavelengths = choices.get("wavelengths")
    each = max(3, 0 if wavelengths is None else np.size(wavelengths))
    hours = max(24, values_at_once // (each * patches_named(choices.get("patches", "tregenza")).count))
    warn_of_wrong_place(weather)
    with store_appearing(path, overwrite) as beside:
        for k in range(0, weather.count, hours):
            part = slice(k, min(k + hours, weather.count))
            hourly = {name: choices[name] for name in ("turbidity", "clouds") if np.ndim(choices.get(name, 0.0))}
            given = choices | {name: values[part] for name, values in hourly.items()}
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # the place has been looked at already
                data = year(weather.rows(part), **given)
                data.attrs |= {"title": f"A year of skies{weather.where}", "written_by": MAKER, **facts_of(weather)}
                if k == 0:
                    clock = {"units": "seconds since 1970-01-01", "dtype": "int64"}
                    data.to_zarr(beside, mode="w-", encoding={"time": clock, "sun_time": clock, "local_time": clock})
                else:
                    moving = [name for name in data.variables if "time" not in data[name].dims]
                    data.drop_vars(moving).to_zarr(beside, append_dim="time")
    return xarray.open_zarr(path)


@contextmanager
def store_appearing(path: str | os.PathLike[str], overwrite: bool) -> Iterator[Path]:
    """The name of a folder beside `path` that becomes it on leaving, and is removed on any error."""
    require_free(path, overwrite)
    with (folder_replacing if overwrite else folder_appearing)(path) as beside, warnings.catch_warnings():
        warnings.simplefilter("ignore")  # zarr tells of consolidated metadata, which xarray writes on purpose
        yield beside


def require_free(path: str | os.PathLike[str], overwrite: bool = False) -> None:
    """FileExistsError for a folder that may not be replaced: one that no year was written to, or without `overwrite`.

    An empty folder may always.
    """
    folder = require_place(path, folder=True)
    sweep(folder)
    if is_empty(folder):
        return
    if not is_year(folder):
        raise FileExistsError(f"the folder to write must be empty or a year that skydome wrote, got {path}")
    if others := [entry.name for entry in sorted(folder.iterdir()) if not is_of_store(entry)]:
        raise FileExistsError(f"{path} holds more than the year that skydome wrote and stays, got {others[0]} in it")
    if not overwrite:
        raise FileExistsError(f"{path} holds a year already: choose another name, or give --overwrite")


def is_of_store(entry: Path) -> bool:
    """True for what a Zarr store of one level holds: its own record, and arrays with theirs."""
    return entry.name == "zarr.json" or (entry / "zarr.json").is_file()


def is_year(folder: Path) -> bool:
    """True for a store that `write_dataset` or `write_year` wrote, as it tells itself."""
    try:
        told = json.loads((folder / "zarr.json").read_text("utf-8"))
        return bool(told["attributes"]["written_by"] == MAKER)
    except (OSError, ValueError, KeyError, TypeError):
        return False
