"""A map without the sun, and beside it the scene that lights with both."""

import os
from collections.abc import Iterator, Mapping
from os import PathLike
from pathlib import Path
from typing import Any

from skydome.dome.integrals import horizontal_xyz
from skydome.dome.render import render
from skydome.export.scenes.formats import scene_format
from skydome.export.scenes.scene import SkyScene
from skydome.export.scenes.sun_lamp import SunLamp
from skydome.ground.arguments import require_kind, require_path
from skydome.ground.limits.ranges import require, require_one
from skydome.ground.writing import appearing, require_place
from skydome.light.colour import SRGB, RGBSpace
from skydome.light.tone import EXPOSURE
from skydome.maps.by_rows.light_in_file import Gamut
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.files import file_white, require_choices, space_in_file
from skydome.maps.showing.preview import usual_exposure
from skydome.skies.colour_sky import ColourSky
from skydome.skies.sky import Sky
from skydome.skies.validity import parameters_text

UNNAMABLE = "\"'\\@<>&{}"
"""Characters that one scene language or another cannot have in a file's name."""


def save_scene(
    sky: ColourSky,
    path: str | PathLike[str],
    height: int = 1024,
    *,
    map_path: str | PathLike[str] | None = None,
    space: RGBSpace = SRGB,
    ground_albedo: Any = None,
    exposure: float | None = None,
    white_luminance: float | None = None,
    metadata: dict[str, Any] | None = None,
) -> SkyScene:
    """Write the scene of a sky for a renderer, and the map beside it; what was written, as a `SkyScene`.

    The ending of `path` names the renderer: .usda (USD), .py (Blender), .xml (Mitsuba 3), .pbrt (pbrt-v4), .js
    (three.js), .rad (Radiance), .gltf (KHR_lights_punctual). The map, `map_path` or the same name with .exr (.hdr for
    Radiance), has `height` rows in the renderer's layout and lacks the sun, whose disc becomes a lamp: nothing is
    doubled. The map's ground is lit by the sun too. `exposure`, per cd m-2, is for the view, by the map unless given;
    `white_luminance`, cd m-2 of RGB (1, 1, 1) in the map's file, scales map and lamp together.

    >>> import skydome as sd, tempfile
    >>> sky = sd.HosekWilkie(sd.direction(azimuth=4.0, elevation=0.7), turbidity=3.0)
    >>> folder = Path(tempfile.mkdtemp())
    >>> scene = sd.save_scene(sky + sd.SunDisc.of(sky), folder / "noon.usda", height=64)
    >>> sorted(file.name for file in folder.iterdir()), round(scene.lamp.illuminance, -3)
    (['noon.exr', 'noon.usda'], 82000.0)
    """
    require_kind(sky, Sky, "sky", "HosekWilkie(sun, turbidity=3.0)")
    require_kind(metadata, dict | None, "metadata", "{}")
    kind, path = scene_format(path), Path(path)
    if map_path is not None:
        require_path(map_path, "a map")
    beside = path.with_suffix(kind.map_suffix) if map_path is None else Path(map_path)
    require_scene(path, beside, white_luminance, exposure)
    own = {"projection": kind.target.projection, "space": space, "ground_albedo": ground_albedo, "metadata": metadata}
    picture = render(sky, height, disc=False, **own)
    return write_scene(sky, picture, path, beside, exposure, white_luminance)


def require_scene(
    path: Path, map_path: Path, white_luminance: float | None = None, exposure: float | None = None
) -> None:
    """ValueError or OSError, before any work, for a scene or a map that cannot be written so."""
    kind = scene_format(path)
    require_place(path)
    require_place(map_path)
    require_choices(map_path, False, white_luminance, None, "white")
    if map_path.suffix.lower() != kind.map_suffix:
        raise ValueError(f"{kind.name} takes the map as {kind.map_suffix}, got {map_path.name!r}")
    if not map_path.name.isprintable() or set(map_path.name) & set(UNNAMABLE):
        raise ValueError(
            f"a scene names its map, which must have none of {UNNAMABLE!r} in its name, got {map_path.name!r}"
        )
    if exposure is not None:
        require("exposure", exposure, EXPOSURE)
        require_one("exposure", exposure)


def write_scene(
    sky: ColourSky,
    picture: EnvironmentMap,
    path: Path,
    map_path: Path,
    exposure: float | None = None,
    white_luminance: float | None = None,
    gamut: Gamut = "white",
) -> SkyScene:
    """Write a map that was rendered without the discs of `sky`, and the scene that lights with both."""
    kind = scene_format(path)
    white = file_white(picture, map_path, kind.target, False, white_luminance) or 1.0
    diffuse, direct = (float(light[1]) for light in horizontal_xyz(sky))
    scene = SkyScene(
        map_name=Path(os.path.relpath(map_path, path.parent)).as_posix(),
        white=white,
        space=space_in_file(picture, map_path, kind.target),
        lamp=SunLamp.of(sky),
        exposure=exposure or usual_exposure(picture),
        horizontal=(diffuse, direct),
        about=tuple(about(sky, picture.metadata)),
    )
    picture.save(map_path, target=kind.target_name, white_luminance=white_luminance, gamut=gamut)
    with appearing(path) as hidden:
        hidden.write_text(kind.text(scene), encoding="utf-8")
    return scene


def about(sky: ColourSky, metadata: Mapping[str, Any]) -> Iterator[str]:
    """What sky it is, in plain lines: the model in words, then what else the map carries."""
    yield f"sky: {parameters_text(sky.parameters())}"
    yield from (f"{name}: {value}" for name, value in metadata.items() if name not in ("model", "software"))
