"""Captured skies from a folder: HDR maps with their time, sun and sky, in one layout and frame."""

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.captures.high_dynamic_range import require_hdr
from skydome.captures.level_probe import LevelProbe
from skydome.captures.sky_mask import read_mask, sky_mask
from skydome.captures.stored_layout import stated_layout
from skydome.captures.sun_finding import find_sun, sun_pixels
from skydome.ground.extras import required
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.fisheye import Equidistant, Equisolid, Fisheye
from skydome.maps.loading import load
from skydome.maps.projection import Projection
from skydome.skies.captured import CapturedSky, without_sun
from skydome.sun.place import Place
from skydome.sun.position import sun_direction
from skydome.sun.times import Times, instants

LAYOUTS: dict[str, Projection] = {
    "latlong": Equirectangular(),
    "angular": LevelProbe(Fisheye(2 * np.pi, Equidistant())),
    "mirror-ball": LevelProbe(Fisheye(2 * np.pi, Equisolid())),
    "fisheye": Fisheye(np.pi, Equidistant()),
    "fisheye-equisolid": Fisheye(np.pi, Equisolid()),
}
"""How maps may lie in their files: light probes look level to the north, fisheyes look up."""

HDR, LDR = (".exr", ".hdr"), (".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".webp")
MASK = ".mask.png"
TIME_IN_NAME = re.compile(r"(\d{4})-?(\d{2})-?(\d{2})[T_ ]?(\d{2})[:\-]?(\d{2})(?:[:\-]?(\d{2}))?(Z|[+-]\d{2}:?\d{2})?")
SUN_RADIUS, SUN_TEXELS = np.radians(4.0), 2.0
"""How far from its middle a sun is taken out of a picture: an angle, or texels where they are coarse."""

Progress = Callable[[str, float], None]


@dataclass(frozen=True, eq=False)
class Capture:
    """One captured sky: its equirectangular `picture`, the direction of its `sun`, where it shows `sky`, its time.

    `sky` (H, W) leaves out ground, skyline and the sun's own texels. `calm` is the picture with the sun taken out,
    `sunlight` what was taken, linear sRGB cd m-2 sr, (3,). `time` is UTC, None where it is not known. `clipped`
    counts the negative values that became 0.
    """

    name: str
    picture: EnvironmentMap
    sun: np.ndarray
    sky: np.ndarray
    calm: EnvironmentMap
    sunlight: np.ndarray
    time: np.datetime64 | None = None
    clipped: int = 0
    visible: bool = field(default=True)

    @classmethod
    def of(
        cls,
        picture: EnvironmentMap,
        name: str = "capture",
        sun: ArrayLike | None = None,
        sky: np.ndarray | None = None,
        time: Times | None = None,
        horizon: float = 0.0,
    ) -> "Capture":
        """A capture of a map in any layout: its sun is found where none is given, its sky segmented likewise.

        Negative values become 0; NaN, 8 bit pictures, and skies without a sun are refused (ValueError).
        """
        picture, clipped = cleaned(picture, name)
        if not isinstance(picture.projection, Equirectangular):
            picture = picture.resampled(Equirectangular())
        visible = True
        if sun is None:
            try:
                found = find_sun(picture, sky_mask(picture, None, horizon) if sky is None else sky)
            except ValueError as error:
                raise ValueError(f"{name}: {error}") from None
            sun, visible = found.direction, found.visible
        sun = np.asarray(sun, dtype=np.float64)
        mask = sky_mask(picture, sun, horizon) if sky is None else sky
        calm, taken = without_sun(picture, sun, max(SUN_RADIUS, SUN_TEXELS * np.pi / picture.height))
        scale = picture.white_luminance
        return cls(
            name,
            picture,
            sun,
            mask & ~sun_pixels(picture, sun),
            replace(picture, pixels=calm),
            taken * scale,
            None if time is None else np.datetime64(instants(time).item(), "us"),
            clipped,
            visible,
        )

    def captured_sky(self) -> CapturedSky:
        """The capture as a sky."""
        return CapturedSky(self.picture, self.sun)


def cleaned(picture: EnvironmentMap, name: str) -> tuple[EnvironmentMap, int]:
    """The map in linear sRGB without negative values, and how many there were; ValueError for NaN and for LDR."""
    broken = int(np.count_nonzero(~np.isfinite(picture.pixels)))
    if broken:
        raise ValueError(f"{name}: pixels must be finite, got {broken} values of NaN or infinity; repair the capture")
    require_hdr(picture.pixels, name)
    from skydome.light.colour import SRGB

    pixels = picture.pixels
    if picture.space is not SRGB:
        pixels = (pixels @ (SRGB.from_xyz @ picture.space.to_xyz).T).astype(pixels.dtype)
    clipped = int(np.count_nonzero(pixels < 0))
    return replace(picture, pixels=np.maximum(pixels, 0), space=SRGB), clipped


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
    wanted = 2 * rows if isinstance(projection, Equirectangular) else rows
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
