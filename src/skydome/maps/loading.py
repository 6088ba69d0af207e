"""Maps from files: pixels, unit, primaries, place, time and provenance back out of the header."""

import ast
from collections.abc import Mapping, Sequence
from datetime import datetime, timedelta, timezone
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from skydome.ground import exr, hdr
from skydome.ground.arguments import require_path
from skydome.ground.limits.ranges import LIGHT, Range, require
from skydome.ground.units import RADIANCE_EFFICACY
from skydome.light.colour import ACESCG, RADIANCE, REC2020, SRGB, RGBSpace
from skydome.maps import projections
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.files import OWN, PLACE, WHITE_IN_FILE
from skydome.maps.projection import Projection
from skydome.maps.targets import target as target_named
from skydome.sun.place import Place

SPACES = (SRGB, REC2020, ACESCG, RADIANCE)
LAYOUTS: dict[str, Any] = {name: getattr(projections, name) for name in projections.__all__}
LAYOUT_NOTES = ("projection", "space", "target", "orientation")


def load(path: str | PathLike[str], target: str | None = None, projection: Projection | None = None) -> EnvironmentMap:
    """The map in an .exr or .hdr file, laid out as its own header says, else as `target` says (native unless given).

    What `EnvironmentMap.save` wrote comes back: its layout, its unit from whiteLuminance (.exr; 1 cd m-2 where the file
    is silent) or Radiance's 179 lm W-1 (.hdr), primaries, place, time and provenance. `projection` overrules both, for
    files that were laid out anew by another program. ValueError for a `target` of another layout than the header's,
    another ending, another target, a damaged file, NaN or infinity; OSError where there is no such file.

    >>> from tempfile import TemporaryDirectory
    >>> import skydome as sd
    >>> with TemporaryDirectory() as folder:
    ...     sd.render(sd.Daylight(sd.Uniform(1000.0)), height=16).save(f"{folder}/sky.exr", target="skylibs")
    ...     load(f"{folder}/sky.exr").projection == sd.target("skylibs").projection
    True
    """
    suffix = require_path(path, "a map").suffix.lower()
    if target is not None:
        target_named(target)
    if suffix not in READERS:
        raise ValueError(f"a map's file must end in {' or '.join(READERS)}, got {Path(path).name!r}")
    return READERS[suffix](path, target, projection)


def projection_of(
    header: Mapping[str, Any], target: str | None, projection: Projection | None, path: str | PathLike[str]
) -> Projection:
    """The projection of a file with that header; ValueError where `target` contradicts it."""
    if projection is not None:
        return projection
    wanted = None if target is None else target_named(target).projection
    stated = stated_projection(header)
    if wanted is None or stated is None:
        return wanted or stated or target_named("native").projection
    if wanted != stated:
        name = header.get(f"{OWN}target", repr(stated))
        raise ValueError(f"{Path(path).name} says that its layout is {name}, got {target}; leave that out")
    return stated


def stated_projection(header: Mapping[str, Any]) -> Projection | None:
    """The layout that our own saving wrote into a header; None where it says nothing that can be read.

    >>> stated_projection({"skydome:projection": "Equirectangular(azimuth_left=1.0, mirrored=False)"}).azimuth_left
    1.0
    """
    try:
        found = built(ast.parse(str(header[f"{OWN}projection"]), mode="eval").body)
    except (KeyError, SyntaxError, TypeError, ValueError):
        return None
    return found if isinstance(found, Projection) else None


def built(node: ast.expr) -> Any:
    """A projection, a lens or a number from its own words; ValueError for anything else: nothing is executed."""
    if not isinstance(node, ast.Call):
        return ast.literal_eval(node)
    if not isinstance(node.func, ast.Name) or node.func.id not in LAYOUTS or node.args:
        raise ValueError(f"a layout must be one of {', '.join(LAYOUTS)}")
    return LAYOUTS[node.func.id](**{str(word.arg): built(word.value) for word in node.keywords})


def load_exr(path: str | PathLike[str], target: str | None, projection: Projection | None) -> EnvironmentMap:
    """The map in an OpenEXR file; sRGB primaries where the file names none."""
    pixels, header = exr.read(path, finite=True)
    layout = projection_of(header, target, projection, path)
    facts: dict[str, Any] = {name: stated(header, name, path) for name in PLACE if name in header}
    moment = time_of(header)
    facts |= {"time": moment} if moment else {}
    white = stated(header, "whiteLuminance", path) if "whiteLuminance" in header else 1.0
    space = space_of(header.get("chromaticities"), SRGB, "chromaticities", path)
    return of_light(EnvironmentMap(pixels, layout, space, facts | notes_of(header), white), path)


def load_hdr(path: str | PathLike[str], target: str | None, projection: Projection | None) -> EnvironmentMap:
    """The map in a Radiance picture; Radiance's own primaries where the file names none."""
    pixels, text = hdr.read(path)
    layout = projection_of(text, target, projection, path)
    primaries = text["PRIMARIES"].split() if "PRIMARIES" in text else None
    facts = {name: stated(text, name, path) for name in PLACE if name in text} | notes_of(text)
    facts |= {"time": text["time"]} if "time" in text else {}
    white = RADIANCE_EFFICACY / stated(text, "EXPOSURE", path)
    space = space_of(primaries, RADIANCE, "PRIMARIES", path)
    return of_light(EnvironmentMap(pixels, layout, space, facts, white), path)


READERS = {".exr": load_exr, ".hdr": load_hdr}


STATED = {
    **Place.bounds,
    "whiteLuminance": WHITE_IN_FILE,
    "EXPOSURE": Range(1e-12, 1e15),
    "chromaticities": Range(-5.0, 5.0),
    "PRIMARIES": Range(-5.0, 5.0),
}
"""What the numbers of a header may be."""


def stated(header: Mapping[str, Any], name: str, path: str | PathLike[str]) -> float:
    """A number of a header; ValueError with its name where it is none, or can mean nothing."""
    return number_of(header[name], name, path)


def number_of(value: Any, name: str, path: str | PathLike[str]) -> float:
    """The value as a number in the range of that name."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = float("nan")
    require(f"{name} in the header of {Path(path).name}", number, STATED[name])
    return number


def of_light(environment: EnvironmentMap, path: str | PathLike[str]) -> EnvironmentMap:
    """The map; ValueError where its numbers, in cd m-2, are beyond all light."""
    size = max(float(environment.pixels.max(initial=0.0)), -float(environment.pixels.min(initial=0.0)))
    peak = size * environment.white_luminance
    if not peak <= LIGHT.high:
        raise ValueError(f"light must be at most {LIGHT.high:g} cd m-2, got {peak:g} in {Path(path).name}")
    return environment


def space_of(values: Sequence[Any] | None, silent: RGBSpace, name: str, path: str | PathLike[str]) -> RGBSpace:
    """The RGB space with those CIE x, y of red, green, blue, white: one of ours where they agree; `silent` for None.

    ValueError with the header's `name` for them where they span no colours.
    """
    if values is None:
        return silent
    count = len(values) if isinstance(values, Sequence | np.ndarray) else 0
    if count != 8:
        raise ValueError(f"{name} in the header of {Path(path).name} must be eight numbers, got {count}")
    chromaticities = [number_of(value, name, path) for value in values]
    for space in SPACES:
        if np.allclose(space.chromaticities, chromaticities, rtol=0, atol=1e-3):
            return space
    red, green, blue, white = ((float(x), float(y)) for x, y in np.reshape(chromaticities, (4, 2)))
    try:
        return RGBSpace("as its file states", red, green, blue, white)
    except ValueError as error:
        raise ValueError(f"{name} in the header of {Path(path).name}: {error}") from error


def notes_of(header: Mapping[str, Any]) -> dict[str, Any]:
    """The provenance in a header, without what its saving added about the layout."""
    notes = {name.removeprefix(OWN): value for name, value in header.items() if name.startswith(OWN)}
    return {name: value for name, value in notes.items() if name not in LAYOUT_NOTES}


def time_of(header: Mapping[str, Any]) -> datetime | None:
    """The timezone-aware time of capDate and utcOffset, None where they are missing or unreadable."""
    try:
        local = datetime.strptime(header["capDate"], "%Y:%m:%d %H:%M:%S")
        return local.replace(tzinfo=timezone(timedelta(seconds=-float(header["utcOffset"]))))
    except (KeyError, ValueError, TypeError):
        return None
