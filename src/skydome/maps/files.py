"""Maps to files: which layout, which scale, and what the header says about the light, the place and the time."""

import math
from dataclasses import replace
from datetime import datetime
from os import PathLike
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np

from skydome.ground import exr, hdr, png
from skydome.ground.arguments import require_path
from skydome.ground.limits.ranges import Range, require
from skydome.ground.limits.sizes import row_parts
from skydome.ground.units import RADIANCE_EFFICACY
from skydome.light.colour import SRGB, RGBSpace
from skydome.light.gamut import count_outside, within_gamut
from skydome.light.tone import Curve
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.pixels import MapPixels
from skydome.maps.projection import Projection
from skydome.maps.showing.preview import preview_in_bytes
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
Gamut = Literal["white", "none"]
"""What becomes of colours outside the RGB space: moved toward its white, or written as they are."""

MOVED = "colours outside the RGB space moved toward its white, luminance kept"


def save(
    environment: MapPixels,
    path: str | PathLike[str],
    target: str | None = None,
    half: bool = False,
    height: int | None = None,
    exposure: float | None = None,
    curve: Curve | None = None,
    white_luminance: float | None = None,
    gamut: Gamut = "white",
    in_place: bool = False,
) -> None:
    """Write a map to `path` (.exr, .hdr or .png), atomically, in the layout of a renderer where `target` names one.

    .exr: RGB times whiteLuminance is cd m-2. `white_luminance` sets it; else it is the map's, and `HALF_WHITE` for
    every file of half floats, so that the frames of a day have one scale. .hdr: Radiance's W m-2 sr-1, cd m-2 / 179,
    EXPOSURE 1; with `white_luminance` values are cd m-2 over it, and EXPOSURE says so. Targets that keep half floats
    alone (three) get them, at that scale. Colours outside the RGB space move toward white, luminance kept;
    `gamut="none"` writes them as they are (.hdr then cuts at 0). Targets that read one space get it. .png: a preview
    with `exposure` (per cd m-2) and `curve`. `height` resizes; without it texels keep their size. `in_place`: the map's
    own pixels may be overwritten, so that a large one needs no second.
    """
    suffix = require_path(path, "a map").suffix.lower()
    layout = None if target is None else target_named(target)
    require_choices(path, half, white_luminance, exposure, gamut)
    if layout is not None or height is not None:
        environment = environment.resampled(layout.projection if layout else environment.projection, height)
    if suffix != ".exr" or gamut != "none":
        environment.tell_of_negative_light(Path(path).name)
    if suffix == ".png":
        png.write(path, preview_in_bytes(environment, exposure, curve), provenance(environment, layout))
        return
    environment = in_its_colours(environment, space_in_file(environment, path, layout), gamut, in_place)
    notes = provenance(environment, layout)
    white = file_white(environment, path, layout, half, white_luminance) or environment.white_luminance
    require("white luminance", white, WHITE_IN_FILE)
    if suffix == ".exr":
        save_exr(environment, path, is_half(layout, half), white, notes)
    else:
        save_hdr(environment, path, white, notes)


def is_half(layout: Target | None, half: bool) -> bool:
    """Whether light is kept in half floats: asked for, or all that the target has."""
    return half or (layout is not None and layout.only_half)


def file_white(
    environment: MapPixels, path: str | PathLike[str], layout: Target | None, half: bool, given: float | None
) -> float | None:
    """cd m-2 of RGB (1, 1, 1) in the file; None for a .png, which is developed."""
    suffix = Path(path).suffix.lower()
    if suffix == ".png" or given is not None:
        return given
    if is_half(layout, half):
        return HALF_WHITE
    return environment.white_luminance if suffix == ".exr" else RADIANCE_EFFICACY


def space_in_file(environment: MapPixels, path: str | PathLike[str], layout: Target | None) -> RGBSpace:
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
    for what, value, allowed in (
        ("white luminance", white_luminance, (".exr", ".hdr")),
        ("exposure", exposure, (".png",)),
    ):
        if value is not None and suffix not in allowed:
            raise ValueError(f"{what} goes with {' and '.join(allowed)} alone, got {name!r}")
        if value is not None and not 0 < value < math.inf:
            raise ValueError(f"{what} must be finite and more than 0, got {value:g}")
    if white_luminance is not None:
        require("white luminance", white_luminance, WHITE_IN_FILE)


def in_its_colours(environment: MapPixels, space: RGBSpace, gamut: Gamut, in_place: bool) -> MapPixels:
    """The map in that RGB space, its colours within the space unless `gamut` is "none"."""
    environment = environment.in_space(space, in_place)
    if gamut == "none" or not count_outside(environment.pixels):
        return environment
    pixels = within_gamut(environment.pixels, environment.space, in_place)
    return replace(environment, pixels=pixels, metadata={**environment.metadata, "gamut": MOVED})


def save_exr(
    environment: MapPixels, path: str | PathLike[str], half: bool, white: float, notes: dict[str, Any]
) -> None:
    """OpenEXR, float or half, with place, time, unit and primaries in their own attributes."""
    factor = environment.white_luminance / white
    if half:
        require_half(environment.pixels, white, factor)
    header = {
        **light_unit(environment.space, white),
        "comments": f"RGB times {white:g} is luminance in cd m-2 (Y); texel centres.",
        **{name: float(environment.metadata[name]) for name in PLACE if name in environment.metadata},
        **time_attributes(environment.metadata.get("time")),
        **notes,
    }
    seen_from_inside = isinstance(environment.projection, Equirectangular) and not environment.projection.mirrored
    exr.write(path, {"RGB": environment.pixels}, header, half, latlong=seen_from_inside, factor=factor)


def require_half(pixels: np.ndarray, white: float, factor: float) -> None:
    """ValueError where half floats end below the light, pixels times a factor, or are too coarse for most of it."""
    peak = factor * float(max(pixels.max(initial=0.0), -pixels.min(initial=0.0)))
    if peak > exr.HALF_MAXIMUM:
        least = half_white(peak * white)
        raise ValueError(
            f"half floats end at {exr.HALF_MAXIMUM:g}, got {peak:g} at a white luminance of {white:g} cd m-2; "
            f"{least:g} holds it"
        )
    total, lost = 0.0, 0.0
    for part in row_parts(len(pixels)):
        light = pixels[part] * pixels.dtype.type(factor)
        total += float(np.abs(light).sum(dtype=np.float64))
        lost += float(np.abs(light.astype(np.float16) - light.astype(np.float64)).sum())
    if lost > COARSE * total:
        best = half_white(peak * white)
        raise ValueError(
            f"half floats are too coarse for light of at most {peak * white:.3g} cd m-2 at a white luminance of "
            f"{white:g} cd m-2; {best:g} suits it"
        )


def half_white(peak: float) -> float:
    """The smallest power of ten, as cd m-2 of RGB (1, 1, 1), at which half floats hold light of `peak` cd m-2.

    >>> half_white(1.6e9), half_white(60000.0)
    (100000.0, 1.0)
    """
    return float(10.0 ** math.ceil(math.log10(peak / exr.HALF_MAXIMUM)))


def save_hdr(environment: MapPixels, path: str | PathLike[str], white: float, notes: dict[str, Any]) -> None:
    """Radiance picture: cd m-2 / `white` in the map's own primaries, as PRIMARIES says, Radiance's unit by EXPOSURE."""
    primaries = " ".join(f"{value:.4f}" for value in environment.space.chromaticities)
    place = {name: environment.metadata[name] for name in (*PLACE, "time") if name in environment.metadata}
    header = {"SOFTWARE": "skydome", "EXPOSURE": RADIANCE_EFFICACY / white, "PRIMARIES": primaries, **place, **notes}
    hdr.write(path, environment.pixels, header, environment.white_luminance / white)


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


def provenance(environment: MapPixels, layout: Target | None) -> dict[str, Any]:
    """The remaining metadata and the layout, as `skydome:name` -> str or float."""
    facts = {name: plain(value) for name, value in environment.metadata.items() if name not in (*PLACE, "time")}
    facts |= {"projection": repr(environment.projection), "space": environment.space.name}
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
