"""Maps from files: pixels, unit, primaries, place, time and provenance back out of the header."""

from collections.abc import Mapping, Sequence
from datetime import datetime, timedelta, timezone
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from skydome.ground import exr, hdr
from skydome.light.colour import ACESCG, RADIANCE, REC2020, SRGB, RGBSpace
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.files import PLACE, RADIANCE_EFFICACY
from skydome.maps.projection import Projection
from skydome.maps.targets import target as target_named

SPACES = (SRGB, REC2020, ACESCG, RADIANCE)
LAYOUT_NOTES = ("projection", "space", "target", "orientation")


def load(path: str | PathLike[str], target: str = "native", projection: Projection | None = None) -> EnvironmentMap:
    """The map in an .exr or .hdr file that is laid out as `target` says, or as `projection` where that is given.

    Its unit comes from whiteLuminance (.exr; 1 cd m-2 where the file is silent) or Radiance's 179 lm W-1 (.hdr), its
    primaries, place, time and provenance from the header too: what `EnvironmentMap.save` wrote comes back. ValueError
    for another ending, another target, a damaged file, NaN or infinity; OSError where there is no such file.

    >>> from tempfile import TemporaryDirectory
    >>> import skydome as sd
    >>> with TemporaryDirectory() as folder:
    ...     sd.render(sd.Daylight(sd.Uniform(1000.0)), height=16).save(f"{folder}/sky.exr", target="blender")
    ...     load(f"{folder}/sky.exr", target="blender").pixels.shape
    (16, 32, 3)
    """
    suffix = Path(path).suffix.lower()
    layout = projection or target_named(target).projection
    if suffix == ".exr":
        return load_exr(path, layout)
    if suffix == ".hdr":
        return load_hdr(path, layout)
    raise ValueError(f"a map's file must end in .exr or .hdr, got {Path(path).name!r}")


def load_exr(path: str | PathLike[str], layout: Projection) -> EnvironmentMap:
    """The map in an OpenEXR file; sRGB primaries where the file names none."""
    pixels, header = exr.read(path, finite=True)
    facts: dict[str, Any] = {name: float(header[name]) for name in PLACE if name in header}
    moment = time_of(header)
    facts |= {"time": moment} if moment else {}
    white = float(header.get("whiteLuminance", 1.0))
    space = space_of(header.get("chromaticities"), SRGB)
    return EnvironmentMap(pixels, layout, space, facts | notes_of(header), white if white > 0 else 1.0)


def load_hdr(path: str | PathLike[str], layout: Projection) -> EnvironmentMap:
    """The map in a Radiance picture; Radiance's own primaries where the file names none."""
    pixels, text = hdr.read(path)
    stated = [float(value) for value in text["PRIMARIES"].split()] if "PRIMARIES" in text else None
    facts = {name: float(text[name]) for name in PLACE if name in text} | notes_of(text)
    facts |= {"time": text["time"]} if "time" in text else {}
    white = RADIANCE_EFFICACY / float(text["EXPOSURE"])
    return EnvironmentMap(pixels, layout, space_of(stated, RADIANCE), facts, white)


def space_of(chromaticities: Sequence[float] | None, silent: RGBSpace) -> RGBSpace:
    """The RGB space with those CIE x, y of red, green, blue, white: one of ours where they agree; `silent` for None."""
    if chromaticities is None:
        return silent
    if len(chromaticities) != 8:
        raise ValueError(f"primaries must be eight numbers, got {len(chromaticities)}")
    for space in SPACES:
        if np.allclose(space.chromaticities, chromaticities, rtol=0, atol=1e-3):
            return space
    red, green, blue, white = ((float(x), float(y)) for x, y in np.reshape(chromaticities, (4, 2)))
    return RGBSpace("as its file states", red, green, blue, white)


def notes_of(header: Mapping[str, Any]) -> dict[str, Any]:
    """The provenance in a header, without what its saving added about the layout."""
    notes = {name.removeprefix("skydome:"): value for name, value in header.items() if name.startswith("skydome:")}
    return {name: value for name, value in notes.items() if name not in LAYOUT_NOTES}


def time_of(header: Mapping[str, Any]) -> datetime | None:
    """The timezone-aware time of capDate and utcOffset, None where they are missing or unreadable."""
    try:
        local = datetime.strptime(header["capDate"], "%Y:%m:%d %H:%M:%S")
        return local.replace(tzinfo=timezone(timedelta(seconds=-float(header["utcOffset"]))))
    except (KeyError, ValueError, TypeError):
        return None
