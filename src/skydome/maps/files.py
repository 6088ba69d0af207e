"""Maps to files: which layout, which scale, and what the header says about the light, the place and the time."""

import math
from datetime import datetime
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from skydome.ground import exr, hdr, png
from skydome.ground.tone import Curve
from skydome.light.colour import RGBSpace
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.pixels import MapPixels
from skydome.maps.preview import preview
from skydome.maps.targets import TARGETS, Target
from skydome.maps.targets import target as target_named

RADIANCE_EFFICACY = 179.0  # lm W-1 of white, Radiance's src/common/color.h
PLACE = ("latitude", "longitude", "altitude")
FORMATS = (".exr", ".hdr", ".png")


def save(
    environment: MapPixels,
    path: str | PathLike[str],
    target: str | None = None,
    half: bool = False,
    height: int | None = None,
    exposure: float | None = None,
    curve: Curve | None = None,
) -> None:
    """Write a map to `path` (.exr, .hdr or .png), atomically, in the layout of a renderer where `target` names one.

    .exr: RGB times whiteLuminance is cd m-2; with `half` the values are divided by the power of ten that makes the
    peak fit 65504, and whiteLuminance is multiplied by it. .hdr: Radiance's W m-2 sr-1, cd m-2 / 179, EXPOSURE 1.
    .png: a preview with `exposure` (per cd m-2) and `curve`. `height` resizes; without it texels keep their size.
    """
    suffix = Path(path).suffix.lower()
    if suffix not in FORMATS:
        raise ValueError(f"a map's file must end in {', '.join(FORMATS)}, got {Path(path).name!r}")
    if half and suffix != ".exr":
        raise ValueError(f"half floats exist in .exr alone, got {Path(path).name!r}")
    layout = None if target is None else target_named(target)
    if layout is not None or height is not None:
        environment = environment.resampled(layout.projection if layout else environment.projection, height)
    notes = provenance(environment, layout)
    if suffix == ".exr":
        save_exr(environment, path, half, notes)
    elif suffix == ".hdr":
        save_hdr(environment, path, notes)
    else:
        png.write(path, preview(environment, exposure, curve), notes)


def save_exr(environment: MapPixels, path: str | PathLike[str], half: bool, notes: dict[str, Any]) -> None:
    """OpenEXR, float or half, with place, time, unit and primaries in their own attributes."""
    scale = half_scale(environment.pixels) if half else 1.0
    pixels = environment.pixels if scale == 1 else environment.pixels / environment.pixels.dtype.type(scale)
    header = {
        **light_unit(environment.space, environment.white_luminance * scale),
        "comments": f"RGB times {environment.white_luminance * scale:g} is luminance in cd m-2 (Y); texel centres.",
        **{name: float(environment.metadata[name]) for name in PLACE if name in environment.metadata},
        **time_attributes(environment.metadata.get("time")),
        **notes,
    }
    seen_from_inside = isinstance(environment.projection, Equirectangular) and not environment.projection.mirrored
    exr.write(path, {"RGB": pixels}, header, half, latlong=seen_from_inside)


def half_scale(pixels: np.ndarray) -> float:
    """The smallest power of ten, 1 or more, that brings the largest value within half floats."""
    peak = float(np.max(np.abs(pixels), initial=0.0))
    return 10.0 ** max(0, math.ceil(math.log10(peak / exr.HALF_MAXIMUM))) if 0 < peak < math.inf else 1.0


def save_hdr(environment: MapPixels, path: str | PathLike[str], notes: dict[str, Any]) -> None:
    """Radiance picture: cd m-2 / 179 in the map's own primaries, stated in PRIMARIES."""
    primaries = " ".join(f"{value:.4f}" for value in environment.space.chromaticities)
    place = {name: environment.metadata[name] for name in (*PLACE, "time") if name in environment.metadata}
    header = {"SOFTWARE": "skydome", "EXPOSURE": 1.0, "PRIMARIES": primaries, **place, **notes}
    factor = environment.pixels.dtype.type(environment.white_luminance / RADIANCE_EFFICACY)
    hdr.write(path, environment.pixels * factor, header)


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
    layout = layout or next((entry for entry in TARGETS if entry.projection == environment.projection), None)
    facts |= {"target": layout.name, "orientation": layout.note} if layout else {}
    return {f"skydome:{name}": value for name, value in facts.items()}


def plain(value: object) -> str | float:
    """A number as a float, all else as text."""
    if isinstance(value, int | float | np.number) and not isinstance(value, bool):
        return float(value)
    return str(value)
