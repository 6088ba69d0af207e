"""A Dataset to a Zarr store or a netCDF file that appears whole or not at all."""

import os
import secrets
import shutil
import warnings
from pathlib import Path
from typing import TYPE_CHECKING

from skydome.ground.writing import appearing

if TYPE_CHECKING:
    import xarray


def write_dataset(data: "xarray.Dataset", path: str | os.PathLike[str]) -> None:
    """Write .zarr (a folder) or .nc; what was there before stays until the new one is whole.

    ValueError for another ending; OSError with nothing left behind where the disk is full.
    """
    final = Path(path)
    if final.suffix == ".nc":
        # In memory first: on a full disk libhdf5 does not only fail, it takes the process with it.
        content = data.to_netcdf(engine="h5netcdf", encoding={"luminance": {"zlib": True, "complevel": 1}})
        with appearing(final) as beside:
            beside.write_bytes(content)
        return
    if final.suffix != ".zarr":
        raise ValueError(f"a year must be written as .zarr or .nc, got {final.name!r}")
    beside = final.with_name(f".{final.name}.{secrets.token_hex(4)}.part")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # zarr tells of consolidated metadata, which xarray writes on purpose
            data.to_zarr(beside, mode="w-")
        old = final.with_name(f".{final.name}.{secrets.token_hex(4)}.old")
        if final.exists():
            final.rename(old)
        beside.rename(final)
        shutil.rmtree(old, ignore_errors=True)
    finally:
        shutil.rmtree(beside, ignore_errors=True)
