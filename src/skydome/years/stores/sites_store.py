"""The Zarr store of many site-years: one chunk a site and variable, written by the worker that made it.

The store is Zarr's own (format 3, Blosc's lz4), read by zarr and xarray. Workers write whole chunks as files, as Zarr
names and encodes them: seven small writes a site by `zarr` itself took as long as the skies.
"""

import json
import os
from dataclasses import dataclass, replace
from os import PathLike
from pathlib import Path
from struct import Struct
from typing import TYPE_CHECKING, Any

import numpy as np

from skydome.dome.patches import patches as patches_named
from skydome.ground.files.contents import digest_of_file
from skydome.ground.files.folders import folder_appearing
from skydome.ground.files.leftovers import sweep
from skydome.ground.writing import hidden_beside
from skydome.years.skies.status import BITS

if TYPE_CHECKING:
    import xarray

HOURS = 8760
DONE, FAILED = 1, 2
"""What the store's `state` holds of each site; 0: not yet."""

FIELDS = ("sun_azimuth", "sun_elevation", "direct_normal_illuminance", "diffuse_horizontal_illuminance")
LAYOUT = 3
"""Goes up when chunks are written otherwise, so that no store is filled in two ways."""

BLOSC_HEAD = Struct("<4xI4xI")
"""Bytes that a chunk holds, and its own length (Blosc 1, README_CHUNK_FORMAT)."""

LEVEL, BYTE_SHUFFLE = 1, 1
"""Choices of Blosc (lz4): as small as zstd's for luminance, in a quarter of the time."""


@dataclass(frozen=True)
class Site:
    """A row of sites.csv: its number there, a name, a weather file."""

    row: int
    name: str
    file: str

    @property
    def anywhere(self) -> "Site":
        """The same for processes that stand in other folders."""
        return replace(self, file=os.path.abspath(self.file))


def open_store(store: str | PathLike[str], sites: list[Site], choices: dict[str, Any]) -> Any:
    """The Zarr group for these sites and choices, made if it is not there; ValueError where it is of others.

    Several may begin one store at once: the first to be ready makes it, the others open that one.
    """
    import zarr

    about = about_of(sites, choices)
    sweep(store)
    if not Path(store).exists():
        try:
            with folder_appearing(store) as beside:
                make_store(beside, len(sites), choices, about)
        except FileExistsError:
            pass  # another was sooner
    try:
        group = zarr.open_group(store, mode="r+")
        held = json.loads(group.attrs["skydome"])
    except Exception as error:
        raise ValueError(f"{store} is there and is no store of sites") from error
    if held != json.loads(json.dumps(about)):
        raise ValueError(f"{store} holds other sites or choices; give another name, or remove it")
    return group


def about_of(sites: list[Site], choices: dict[str, Any]) -> dict[str, Any]:
    """What a store is of: names and contents of its weather, whatever the files are called, and the choices."""
    return {
        "sites": [{"name": site.name, "weather": digest_of_file(site.file)} for site in sites],
        "choices": choices,
        "layout": LAYOUT,
    }


def make_store(store: str | PathLike[str], count: int, choices: dict[str, Any], about: dict[str, Any]) -> None:
    """The store without any site's numbers: what is not there reads as NaN, and as missing in `status`."""
    import zarr

    cut = patches_named(choices.get("patches", "tregenza"))
    group = zarr.open_group(store, mode="w-")
    new_array(group, "luminance", (count, HOURS, cut.count), ["site", "time", "patch"], "float32", np.nan)
    for name in FIELDS:
        new_array(group, name, (count, HOURS), ["site", "time"], "float32", np.nan)
    new_array(group, "status", (count, HOURS), ["site", "time"], "uint16", BITS["missing"])
    new_array(group, "time", (count, HOURS), ["site", "time"], "int64", 0)
    group["time"].attrs["units"] = "seconds since 1970-01-01"
    new_array(group, "state", (count,), ["site"], "uint8", 0)
    for name, values in (("solid_angle", cut.solid_angles), ("horizontal_solid_angle", cut.horizontal_solid_angles)):
        group.create_array(name, data=values, dimension_names=["patch"])
    group.attrs["skydome"] = json.dumps(about)


def new_array(group: Any, name: str, shape: tuple[int, ...], dims: list[str], dtype: str, empty: float) -> None:
    """An array of `empty`, with a chunk for each site, in files side by side; `state` is not compressed."""
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
        fill_value=empty,
    )


def is_whole(store: str | PathLike[str], group: Any, index: int) -> bool:
    """True for a site that is marked done and whose chunks are all there in full."""
    arrays = {name: group[name] for name in ("luminance", *FIELDS, "status", "time")}
    return state_of(store, index) == DONE and all(
        has_chunk(chunk_file(store, name, index, array.ndim - 1), array.dtype.itemsize * int(np.prod(array.shape[1:])))
        for name, array in arrays.items()
    )


def state_of(store: str | PathLike[str], index: int) -> int:
    """The state of a site, 0 where none is written."""
    try:
        return int.from_bytes(Path(chunk_file(store, "state", index, 0)).read_bytes())
    except FileNotFoundError:
        return 0


def has_chunk(path: str, size: int) -> bool:
    """True for a chunk's file of the length that its Blosc header tells, holding `size` bytes."""
    try:
        with open(path, "rb") as file:
            head = file.read(BLOSC_HEAD.size)
            length = os.fstat(file.fileno()).st_size
    except FileNotFoundError:
        return False
    return len(head) == BLOSC_HEAD.size and BLOSC_HEAD.unpack(head) == (size, length)


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
    put(chunk_file(store, name, index, values.ndim), encoded)


def mark(store: str | PathLike[str], index: int, state: int) -> None:
    """Write the state of one site."""
    put(chunk_file(store, "state", index, 0), bytes([state]))


def put(path: str, content: bytes) -> None:
    """A file that appears whole, by rename alone: waiting for the disk would take longer than the skies.

    What a crash of the machine leaves too short is found by `is_whole`.
    """
    beside = hidden_beside(Path(path))
    try:
        beside.write_bytes(content)
        os.replace(beside, path)
    finally:
        beside.unlink(missing_ok=True)


def chunk_file(store: str | PathLike[str], name: str, index: int, axes: int) -> str:
    """The file of a site's chunk, which has `axes` more axes of one chunk each."""
    return os.path.join(store, name, ".".join(["c", str(index), *["0"] * axes]))
