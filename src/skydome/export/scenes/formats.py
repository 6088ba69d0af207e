"""Every kind of scene by the ending of its file."""

from os import PathLike
from pathlib import Path

from skydome.export.scenes.blender import BlenderScene
from skydome.export.scenes.gltf import GLTFScene
from skydome.export.scenes.mitsuba import MitsubaScene
from skydome.export.scenes.pbrt import PbrtScene
from skydome.export.scenes.radiance import RadianceScene
from skydome.export.scenes.scene import SceneFormat
from skydome.export.scenes.three import ThreeScene
from skydome.export.scenes.usd import USDScene
from skydome.ground.arguments import require_path

FORMATS: tuple[SceneFormat, ...] = (
    USDScene(),
    BlenderScene(),
    MitsubaScene(),
    PbrtScene(),
    ThreeScene(),
    RadianceScene(),
    GLTFScene(),
)


def endings() -> str:
    """The endings there are, each with its renderer.

    >>> endings()[:25]
    '.usda (USD), .py (Blender'
    """
    return ", ".join(f"{kind.suffix} ({kind.name})" for kind in FORMATS)


def scene_format(path: str | PathLike[str]) -> SceneFormat:
    """The kind of scene by the ending of its file; ValueError lists the endings there are.

    >>> scene_format("turin.usda").target_name
    'usd'
    """
    suffix = require_path(path, "a scene").suffix.lower()
    for kind in FORMATS:
        if kind.suffix == suffix:
            return kind
    raise ValueError(f"a scene's file must end in one of {endings()}; got {Path(path).name!r}")
