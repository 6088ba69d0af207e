"""Captured skies from a folder: HDR maps with their time, sun and sky, in one layout and frame."""

import re
from collections.abc import Callable, Sequence
from itertools import pairwise
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from skydome.captures.capture import Capture
from skydome.captures.sky_mask import read_mask
from skydome.captures.stored_layout import stated_layout
from skydome.ground.extras import required
from skydome.maps.cube import CubeMap
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.fisheye import Equisolid, Fisheye
from skydome.maps.loading import load
from skydome.maps.projection import Projection
from skydome.maps.targets import ANGULAR, MIRROR_BALL
from skydome.sun.place import Place
from skydome.sun.position import sun_direction
from skydome.sun.times import Times, instants

LAYOUTS: dict[str, Projection] = {
    "latlong": Equirectangular(),
    "angular": ANGULAR,
    "mirror-ball": MIRROR_BALL,
    "cube": CubeMap(),
    "fisheye": Fisheye(),
    "fisheye-equisolid": Fisheye(np.pi, Equisolid()),
}
"""How maps may lie in their files: probes look level to the north, fisheyes up, a cube is a strip of six faces."""

HDR, LDR = (".exr", ".hdr"), (".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".webp")
MASK = ".mask.png"
TIME_IN_NAME = re.compile(r"(\d{4})-?(\d{2})-?(\d{2})[T_ ]?(\d{2})[:\-]?(\d{2})(?:[:\-]?(\d{2}))?(Z|[+-]\d{2}:?\d{2})?")
Progress = Callable[[str, float], None]


def read_captures(
    folder: str | PathLike[str],
    layout: str = "latlong",
    place: Place | None = None,
    zone: str | None = None,
    horizon: float = 0.0,
    progress: Progress | None = None,
) -> list[Capture]:
    """The captures of a folder's .exr and .hdr files in the order of time (or of name where no file has a time).

    All must have one size and `layout` (see `LAYOUTS`). Times come from the files' headers, else from their names
    (2013-05-27T0930-0400, or with `zone`). With `place` (else the headers' own) and times the sun is computed, the maps
    then being taken as turned to true north; else it is found in the picture. `name.mask.png` beside a map says where
    it shows sky; without it the sky is segmented. ValueError, in one line, for what does not fit.
    """
    required("scipy", "captures", "a day of captures")
    projection = layout_named(layout)
    files = map_files(Path(folder))
    pictures = [load(path, projection=as_stored(path, projection)) for path in files]
    require_one_size(files, pictures)
    times = times_of(files, pictures, zone)
    captures = []
    for k, (path, picture) in enumerate(zip(files, pictures, strict=True)):
        sun = computed_sun(picture, place, times[k])
        captures.append(Capture.of(picture, path.name, sun, painted_mask(path, picture), times[k], horizon))
        if progress is not None:
            progress(path.name, (k + 1) / len(files))
    return in_order(captures)


def layout_named(name: str) -> Projection:
    """The layout by name; ValueError lists those there are."""
    if name not in LAYOUTS:
        raise ValueError(f"layout must be one of {', '.join(LAYOUTS)}, got {name!r}")
    return LAYOUTS[name]


def map_files(folder: Path) -> list[Path]:
    """The HDR maps of a folder by name; ValueError for LDR pictures among them and for fewer than two maps."""
    if not folder.is_dir():
        raise ValueError(f"captures must be a folder of .exr or .hdr maps, got {folder}")
    entries = sorted(path for path in folder.iterdir() if path.is_file() and not path.name.startswith("."))
    low = [path.name for path in entries if path.suffix.lower() in LDR and not path.name.endswith(MASK)]
    if low:
        raise ValueError(
            f"captures must be HDR maps (.exr, .hdr), got the LDR picture {low[0]}: 8 bit formats clip the sky; "
            f"masks are named like their map, as noon{MASK}"
        )
    files = [path for path in entries if path.suffix.lower() in HDR]
    if len(files) < 2:
        raise ValueError(f"captures must be at least two .exr or .hdr maps, got {len(files)} in {folder}")
    return files


def as_stored(path: Path, projection: Projection) -> Projection:
    """The layout to read a file in; ValueError where its header states another one, or its shape is of another."""
    stated, (rows, columns) = stated_layout(path)
    if stated is not None and stated != repr(projection):
        raise ValueError(f"all maps must have the layout asked for, {projection}, but {path.name} states {stated}")
    try:
        wanted = projection.shape(rows)[1]
    except ValueError:
        wanted = 0
    if columns != wanted:
        raise ValueError(f"{path.name} is {columns} x {rows}, which is no map of the layout {projection}")
    return projection


def require_one_size(files: Sequence[Path], pictures: Sequence[EnvironmentMap]) -> None:
    """ValueError unless all maps have the same height."""
    for path, picture in zip(files, pictures, strict=True):
        if picture.height != pictures[0].height:
            rows = f"{files[0].name} has {pictures[0].height} rows and {path.name} {picture.height}"
            raise ValueError(f"all maps must have one size, but {rows}")


def times_of(files: Sequence[Path], pictures: Sequence[EnvironmentMap], zone: str | None) -> list[Any]:
    """Each map's time from its header or its name; all None where no map has one, ValueError where some lack it."""
    times = [
        picture.metadata.get("time") or time_in_name(path.stem, zone)
        for path, picture in zip(files, pictures, strict=True)
    ]
    known = [time is not None for time in times]
    if any(known) and not all(known):
        raise ValueError(f"all maps must have a time or none, but {files[known.index(False)].name} has none")
    return times


def time_in_name(stem: str, zone: str | None) -> Any:
    """The time written in a file's name, with its offset or in `zone`; None where there is none."""
    found = TIME_IN_NAME.search(stem)
    if found is None or not (found[7] or zone):
        return None
    year, month, day, hour, minute, second, offset = found.groups()
    return instants(f"{year}-{month}-{day}T{hour}:{minute}:{second or '00'}{offset or ''}", zone)[()]


def computed_sun(picture: EnvironmentMap, place: Place | None, time: Times | None) -> np.ndarray | None:
    """The sun by place and time, None where one is not known."""
    notes = picture.metadata
    if place is None and "latitude" in notes and "longitude" in notes:
        place = Place(notes["latitude"], notes["longitude"], notes.get("altitude", 0.0))
    return None if place is None or time is None else sun_direction(place, time)


def painted_mask(path: Path, picture: EnvironmentMap) -> np.ndarray | None:
    """The mask beside a map, equirectangular, or None."""
    mask = path.with_name(path.stem + MASK)
    if not mask.exists():
        return None
    height = picture.height_in(Equirectangular())
    return read_mask(mask, Equirectangular().shape(height))


def in_order(captures: list[Capture]) -> list[Capture]:
    """The captures by time; ValueError where two have the same."""
    if captures[0].time is None:
        return captures
    ordered = sorted(captures, key=lambda capture: capture.time)  # type: ignore[arg-type, return-value]
    for before, after in pairwise(ordered):
        if before.time == after.time:
            raise ValueError(
                f"captures must have different times, got {before.time} for {before.name} and {after.name}"
            )
    return ordered
