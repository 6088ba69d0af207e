"""Maps to files: which layout, which scale, and what the header says about the light, the place and the time."""

from collections.abc import Iterator, Mapping
from datetime import datetime
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple, get_args

import numpy as np

from skydome.ground import hdr, png
from skydome.ground.arguments import require_path
from skydome.ground.files import exr_rows
from skydome.ground.limits.ranges import Range, require
from skydome.ground.units import RADIANCE_EFFICACY
from skydome.light.colour import SRGB, RGBSpace
from skydome.light.tone import EXPOSURE, Curve
from skydome.maps.by_rows.light_in_file import Gamut, LightInFile, Report, watched
from skydome.maps.by_rows.map_rows import MapRows
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.projection import Projection
from skydome.maps.showing.preview import preview_rows, usual_exposure
from skydome.maps.targets import TARGETS, Target
from skydome.maps.targets import target as target_named

PLACE = ("latitude", "longitude", "altitude")
OWN = "skydome:"  # begins the names of what we alone write into headers
FORMATS = (".exr", ".hdr", ".png")
HALF_WHITE = 1e5
"""cd m-2 of RGB (1, 1, 1) in half floats: they end at 65504, so at 6.6e9, the sun is near 1.6e9; one for all files."""
WHITE_IN_FILE = Range(float(np.float32(1e-12)), 1e12, "cd m-2")
"""What a file's white may be, so that the file can be read again; OpenEXR keeps it in float32."""
COARSE = 0.01
"""Share of a map's light that the rounding to half floats may move."""
MOVED = "colours outside the RGB space moved toward its white, luminance kept"


class Written(NamedTuple):
    """What was seen of the light on its way: texels outside the file's RGB space, the exposure of a picture."""

    outside: int = 0
    exposure: float | None = None


def save(
    environment: MapRows,
    path: str | PathLike[str],
    target: str | None = None,
    half: bool = False,
    height: int | None = None,
    exposure: float | None = None,
    curve: Curve | None = None,
    white_luminance: float | None = None,
    gamut: Gamut = "white",
    report: Report = lambda *_: None,
) -> Written:
    """Write a map to `path` (.exr, .hdr or .png), atomically, in the layout of a renderer where `target` names one.

    .exr: RGB times whiteLuminance is cd m-2. `white_luminance` sets it; else it is the map's, and `HALF_WHITE` for
    every file of half floats, so that the frames of a day have one scale. .hdr: Radiance's W m-2 sr-1, cd m-2 / 179,
    EXPOSURE 1; with `white_luminance` values are cd m-2 over it, and EXPOSURE says so. Targets that keep half floats
    alone (three) get them, at that scale. Colours outside the RGB space move toward white, luminance kept;
    `gamut="none"` writes them as they are (.hdr then cuts at 0). Targets that read one space get it. .png: a preview
    with `exposure` (per cd m-2) and `curve`. `height` resizes; without it texels keep their size. A map that is told by
    rows is never held whole, unless its layout or height change; `report` is called with the rows done and all rows.
    """
    suffix = require_path(path, "a map").suffix.lower()
    layout = None if target is None else target_named(target)
    require_choices(path, half, white_luminance, exposure, gamut)
    environment = laid_out(environment, layout, height)
    tells = suffix != ".exr" or gamut != "none"
    seen = watched(environment, Path(path).name) if tells else environment.blocks()
    if suffix == ".png":
        return save_png(environment, seen, path, layout, exposure, curve, report)
    white = file_white(environment, path, layout, half, white_luminance) or environment.white_luminance
    require("white luminance", white, WHITE_IN_FILE)
    space = space_in_file(environment, path, layout)
    light = LightInFile(environment, space, gamut, white, suffix == ".exr" and is_half(layout, half))
    write = save_exr if suffix == ".exr" else save_hdr
    write(light, seen, path, layout, report)
    return Written(light.outside)


def laid_out(environment: MapRows, layout: Target | None, height: int | None) -> MapRows:
    """The map in a target's layout and a height: itself where it has both."""
    projection = layout.projection if layout else environment.projection
    if projection == environment.projection and height in (None, environment.height):
        return environment
    return environment.resampled(projection, height)


def is_half(layout: Target | None, half: bool) -> bool:
    """Whether light is kept in half floats: asked for, or all that the target has."""
    return half or (layout is not None and layout.only_half)


def file_white(
    environment: MapRows, path: str | PathLike[str], layout: Target | None, half: bool, given: float | None
) -> float | None:
    """cd m-2 of RGB (1, 1, 1) in the file; None for a .png, which is developed."""
    suffix = Path(path).suffix.lower()
    if suffix == ".png" or given is not None:
        return given
    if is_half(layout, half):
        return HALF_WHITE
    return environment.white_luminance if suffix == ".exr" else RADIANCE_EFFICACY


def space_in_file(environment: MapRows, path: str | PathLike[str], layout: Target | None) -> RGBSpace:
    """The RGB space of the file: sRGB in a .png, else the map's where the target takes it."""
    if Path(path).suffix.lower() == ".png":
        return SRGB
    return environment.space if layout is None or layout.takes(environment.space) else layout.spaces[0]


def require_choices(
    path: str | PathLike[str], half: bool, white_luminance: float | None, exposure: float | None, gamut: str
) -> None:
    """ValueError for choices that a file of that ending cannot have, before any work."""
    name, suffix = Path(path).name, Path(path).suffix.lower()
    if suffix not in FORMATS:
        raise ValueError(f"a map's file must end in {', '.join(FORMATS)}, got {name!r}")
    if half and suffix != ".exr":
        raise ValueError(f"half floats exist in .exr alone, got {name!r}")
    if gamut not in get_args(Gamut):
        raise ValueError(f"gamut must be one of {', '.join(get_args(Gamut))}, got {gamut!r}")
    for what, value, allowed, interval in (
        ("white luminance", white_luminance, (".exr", ".hdr"), WHITE_IN_FILE),
        ("exposure", exposure, (".png",), EXPOSURE),
    ):
        if value is not None and suffix not in allowed:
            raise ValueError(f"{what} goes with {' and '.join(allowed)} alone, got {name!r}")
        if value is not None:
            require(what, value, interval)


def save_png(
    environment: MapRows,
    seen: Iterator[np.ndarray],
    path: str | PathLike[str],
    layout: Target | None,
    exposure: float | None,
    curve: Curve | None,
    report: Report,
) -> Written:
    """A preview."""
    exposure = usual_exposure(environment) if exposure is None else exposure
    pictures = preview_rows(environment, seen, exposure, curve, report)
    png.write_rows(
        path, environment.size, pictures, provenance(environment, environment.metadata, environment.space, layout)
    )
    return Written(exposure=exposure)


def save_exr(
    light: LightInFile, seen: Iterator[np.ndarray], path: str | PathLike[str], layout: Target | None, report: Report
) -> None:
    """OpenEXR, float or half, with place, time, unit and primaries in their own attributes."""
    environment = light.source
    header = {
        **light_unit(light.space, light.white),
        "comments": f"RGB times {light.white:g} is luminance in cd m-2 (Y); texel centres.",
        **{name: float(environment.metadata[name]) for name in PLACE if name in environment.metadata},
        **time_attributes(environment.metadata.get("time")),
    }
    seen_from_inside = isinstance(environment.projection, Equirectangular) and not environment.projection.mirrored
    blocks = light.blocks(seen, np.float16 if light.half else np.float32, report)
    exr_rows.write_rows(path, environment.size, blocks, lambda: header | noted(light, layout), seen_from_inside)


def save_hdr(
    light: LightInFile, seen: Iterator[np.ndarray], path: str | PathLike[str], layout: Target | None, report: Report
) -> None:
    """Radiance picture: cd m-2 / white in the file's own primaries, as PRIMARIES says, Radiance's unit by EXPOSURE."""
    metadata, dtype = light.source.metadata, light.source.pixel_type
    primaries = " ".join(f"{value:.4f}" for value in light.space.chromaticities)
    place = {name: metadata[name] for name in (*PLACE, "time") if name in metadata}
    header = {"SOFTWARE": "skydome", "EXPOSURE": RADIANCE_EFFICACY / light.white, "PRIMARIES": primaries, **place}
    hdr.write_rows(path, light.source.size, light.blocks(seen, dtype, report), lambda: header | noted(light, layout))


def noted(light: LightInFile, layout: Target | None) -> dict[str, Any]:
    """The provenance, and what has become of the colours so far."""
    moved = light.outside and light.gamut != "none"
    metadata = {**light.source.metadata, **({"gamut": MOVED} if moved else {})}
    return provenance(light.source, metadata, light.space, layout)


def light_unit(space: RGBSpace, white_luminance: float = 1.0) -> dict[str, Any]:
    """OpenEXR's attributes that say what light RGB is: its primaries, and the cd m-2 of RGB (1, 1, 1)."""
    return {"chromaticities": space.chromaticities, "whiteLuminance": white_luminance}


def time_attributes(time: str | datetime | np.datetime64 | None) -> dict[str, Any]:
    """OpenEXR's capDate (local) and utcOffset (seconds, UTC = local + utcOffset) of a timezone-aware time.

    `time` is a datetime, an ISO string with offset, or a numpy datetime64 (UTC); ValueError where it is naive.

    >>> time_attributes("2026-06-21T15:00+09:00")    # Tokyo
    {'capDate': '2026:06:21 15:00:00', 'utcOffset': -32400.0}
    """
    if time is None:
        return {}
    if isinstance(time, np.datetime64):
        time = f"{np.datetime_as_string(time, 's')}+00:00"  # numpy's times are UTC
    moment = datetime.fromisoformat(time) if isinstance(time, str) else time
    offset = moment.utcoffset()
    if offset is None:
        raise ValueError(f"time must have a UTC offset, got {moment.isoformat()}; write it as 2026-06-21T15:00+02:00")
    return {"capDate": moment.strftime("%Y:%m:%d %H:%M:%S"), "utcOffset": -offset.total_seconds()}


def provenance(
    environment: MapRows, metadata: Mapping[str, Any], space: RGBSpace, layout: Target | None
) -> dict[str, Any]:
    """The remaining metadata and the layout, as `skydome:name` -> str or float."""
    facts = {name: plain(value) for name, value in metadata.items() if name not in (*PLACE, "time")}
    facts |= {"projection": repr(environment.projection), "space": space.name}
    layout = layout or layout_of(environment.projection)
    facts |= {"target": layout.name, "orientation": layout.note} if layout else {}
    return {f"{OWN}{name}": value for name, value in facts.items()}


def layout_of(projection: Projection) -> Target | None:
    """The first target with that projection, None where there is none."""
    return next((entry for entry in TARGETS if entry.projection == projection), None)


def plain(value: object) -> str | float:
    """A number as a float, all else as text."""
    if isinstance(value, int | float | np.number) and not isinstance(value, bool):
        return float(value)
    return str(value)
