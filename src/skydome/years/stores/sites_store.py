"""The Zarr store of many site-years: one chunk a site and variable, written by the worker that made it.

The store is Zarr's own (format 3, Blosc's lz4), read by zarr and xarray. Workers write whole chunks as files, as Zarr
names and encodes them: seven small writes a site by `zarr` itself took as long as the skies.
"""

import json
import os
from dataclasses import asdict, dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from skydome.dome.patches import patches as patches_named

if TYPE_CHECKING:
    import xarray

HOURS = 8760
DONE, FAILED = 1, 2
"""What the store's `state` holds of each site; 0: not yet."""

FIELDS = ("sun_azimuth", "sun_elevation", "direct_normal_illuminance", "diffuse_horizontal_illuminance")
LAYOUT = 2
"""Goes up when chunks are written otherwise, so that no store is filled in two ways."""

LEVEL, BYTE_SHUFFLE = 1, 1
"""Choices of Blosc (lz4): as small as zstd's for luminance, in a quarter of the time."""


@dataclass(frozen=True)
class Site:
    """A row of sites.csv: its number there, a name, a weather file."""

    row: int
    name: str
    file: str


def open_store(store: str | PathLike[str], sites: list[Site], choices: dict[str, Any]) -> Any:
    """The Zarr group for these sites and choices, made if it is not there; ValueError where it is of others."""
    import zarr

    about = {"sites": [asdict(site) for site in sites], "choices": choices, "layout": LAYOUT}
    if Path(store).exists():
        group = zarr.open_group(store, mode="r+")
        if json.loads(group.attrs.get("skydome", "{}")) != about:
            raise ValueError(f"{store} holds other sites or choices; give another name, or remove it")
        return group
    cut = patches_named(choices.get("patches", "tregenza"))
    group = zarr.open_group(store, mode="w")
    count = len(sites)
    new_array(group, "luminance", (count, HOURS, cut.count), ["site", "time", "patch"], "float32")
    for name in FIELDS:
        new_array(group, name, (count, HOURS), ["site", "time"], "float32")
    new_array(group, "status", (count, HOURS), ["site", "time"], "uint16")
    new_array(group, "time", (count, HOURS), ["site", "time"], "int64")
    group["time"].attrs["units"] = "seconds since 1970-01-01"
    new_array(group, "state", (count,), ["site"], "uint8")
    for name, values in (("solid_angle", cut.solid_angles), ("horizontal_solid_angle", cut.horizontal_solid_angles)):
        group.create_array(name, data=values, dimension_names=["patch"])
    group.attrs["skydome"] = json.dumps(about)
    return group


def new_array(group: Any, name: str, shape: tuple[int, ...], dims: list[str], dtype: str) -> None:
    """An empty array with a chunk for each site, in files side by side; `state` is not compressed."""
    from zarr.codecs import BloscCodec

    size = np.dtype(dtype).itemsize
    group.create_array(
        name,
        shape=shape,
        chunks=(1, *shape[1:]),
        dtype=dtype,
        compressors=BloscCodec(typesize=size, cname="lz4", clevel=LEVEL, shuffle="shuffle") if shape[1:] else None,
        chunk_key_encoding={"name": "default", "separator": "."},
        dimension_names=dims,
        fill_value=0,
    )


def write_site(store: str | PathLike[str], index: int, data: "xarray.Dataset", middle: np.ndarray) -> None:
    """Write a site's arrays whole, then mark it done; `middle` (T,), datetime64[s], are the intervals' middles."""
    write_chunk(store, "luminance", index, data["luminance"].values.astype("<f4", copy=False))
    for name in FIELDS:
        write_chunk(store, name, index, data[name].values.astype("<f4"))
    write_chunk(store, "status", index, data["status"].values.astype("<u2", copy=False))
    write_chunk(store, "time", index, middle.astype("<i8"))
    mark(store, index, DONE)


def write_chunk(store: str | PathLike[str], name: str, index: int, values: np.ndarray) -> None:
    """Write the chunk of one site, as Zarr would: Blosc over the little-endian values, in the array's folder."""
    from numcodecs import Blosc

    encoded = Blosc("lz4", LEVEL, BYTE_SHUFFLE).encode(np.ascontiguousarray(values))
    with open(chunk_file(store, name, index, values.ndim), "wb") as file:
        file.write(encoded)


def mark(store: str | PathLike[str], index: int, state: int) -> None:
    """Write the state of one site."""
    with open(chunk_file(store, "state", index, 0), "wb") as file:
        file.write(bytes([state]))


def chunk_file(store: str | PathLike[str], name: str, index: int, axes: int) -> str:
    """The file of a site's chunk, which has `axes` more axes of one chunk each."""
    return os.path.join(store, name, ".".join(["c", str(index), *["0"] * axes]))
