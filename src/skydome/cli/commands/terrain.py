"""`skydome terrain`: a picture of real land under a sky, with the air in between."""

from pathlib import Path
from typing import Annotated, Any

from typer import Argument, Option

from skydome.cli.options import AsJson, SkyOptions, numbers, taking
from skydome.cli.printing import show
from skydome.cli.scene import scene_of
from skydome.ground.extras import required


@taking(SkyOptions)
def terrain(
    options: SkyOptions,
    land_file: Annotated[Path, Argument(help="An elevation model: .tif (with georeference), .npz or .hgt.")],
    output: Annotated[Path, Option("--output", "-o", help="picture.png, or picture.exr with the depth in Z.")],
    camera: Annotated[
        str, Option(metavar="EAST,NORTH,ABOVE", help="Metres from the middle of the map, and above the ground.")
    ] = "0,0,100",
    look: Annotated[str, Option(metavar="AZ,EL", help="Where the camera looks, degrees.")] = "270,-2",
    fov: Annotated[float, Option(help="Horizontal field of view, degrees.")] = 50.0,
    size: Annotated[str, Option(metavar="W,H", help="Pixels.")] = "1000,750",
    samples: Annotated[int, Option(help="Samples a pixel, a square number.")] = 16,
    ground_albedo: Annotated[
        str, Option(metavar="R,G,B", help="Reflectance of the land; with --texture, of its mean luminance.")
    ] = "0.11,0.12,0.07",
    texture: Annotated[
        Path | None, Option(help="A photo from above, .tif, .png or .jpg, whose colours the land takes.")
    ] = None,
    vertical_unit: Annotated[str | None, Option(metavar="m|ft", help="Unit of the heights, if not stated.")] = None,
    no_air: Annotated[bool, Option("--no-air", help="Without aerial perspective.")] = False,
    curvature: Annotated[bool, Option("--curvature", help="Lower the land by the Earth's curve.")] = False,
    exposure: Annotated[float | None, Option(help="Factor on cd m-2 for a .png. [default: by the picture]")] = None,
    as_json: AsJson = False,
) -> None:
    """Render an elevation model with sun, shadows, skylight and aerial perspective."""
    import numpy as np

    from skydome.haze.aerial_perspective import AirLight
    from skydome.land.elevation import read_elevation
    from skydome.land.picture import render_terrain
    from skydome.land.texture import read_texture
    from skydome.light.colour import SRGB

    refuse_picture(output, exposure)
    required("numba", "terrain", "a terrain picture")
    albedo = np.array(numbers(ground_albedo, 3, "--ground-albedo", "0.11,0.12,0.07"))
    view = camera_of(camera, look, fov, size)
    land, scene = read_elevation(land_file, vertical_unit), scene_of(options)
    surface, laid = (
        (albedo, ()) if texture is None else read_texture(texture, land, float(albedo @ np.asarray(SRGB.to_xyz[1])))
    )
    known = any(part.sunlit is not None and part.sunlit.haze is not None for part in scene.whole.parts)
    air = None if no_air else AirLight(scene.whole, turbidity=options.turbidity or (None if known else 3.0))
    with rows_done() as progress:
        picture = render_terrain(land, view, scene.whole, air, surface, samples, curvature, progress=progress)
    picture.save(output, exposure) if output.suffix.lower() == ".png" else picture.save(output)
    facts = facts_of(output, land, picture) | {"notes": [*land.notes, *laid, *scene.notes]}
    show(facts, {name: text_of(value) for name, value in facts.items()}, as_json)


def refuse_picture(path: Path, exposure: float | None) -> None:
    """ValueError or OSError, before the work, for a picture that could not be written in the end."""
    if exposure is not None and not 0 < exposure < float("inf"):
        raise ValueError(f"--exposure must be finite and more than 0, got {exposure:g}")
    if path.suffix.lower() not in (".png", ".exr"):
        raise ValueError(f"a terrain picture must end in .png or .exr, got {path.name!r}")
    if not path.absolute().parent.is_dir():
        raise FileNotFoundError(f"the folder to write to must exist, got {path.parent}")


def camera_of(camera: str, look: str, fov: float, size: str) -> Any:
    """The camera by its options."""
    from skydome import deg
    from skydome.eye.view import Camera

    east, north, above = numbers(camera, 3, "--camera", "1200,-300,50")
    azimuth, elevation = numbers(look, 2, "--look", "270,-2")
    wide, high = numbers(size, 2, "--size", "1000,750")
    width, height = int(wide), int(high)
    if (width, height) != (wide, high):
        raise ValueError(f"--size must be two whole numbers such as 1000,750, got {size!r}")
    return Camera(azimuth * deg, elevation * deg, fov * deg, width, height, east, north, above)


def rows_done() -> Any:
    """A progress bar on stderr that is called with (rows done, rows)."""
    from contextlib import contextmanager

    from rich.console import Console
    from rich.progress import Progress

    @contextmanager
    def bar() -> Any:
        console = Console(stderr=True)
        with Progress(console=console, disable=not console.is_terminal) as progress:
            task = progress.add_task("rendering", total=None)
            yield lambda done, rows: progress.update(task, completed=done, total=rows)

    return bar()


def facts_of(path: Path, land: Any, picture: Any) -> dict[str, Any]:
    """What was read and written."""
    import numpy as np

    seen = picture.depth[np.isfinite(picture.depth)]
    return {
        "file": str(path),
        "cells": [int(size) for size in land.heights.shape],
        "cell_m": [round(float(land.dx), 2), round(float(land.dy), 2)],
        "heights_m": [float(land.heights.min()), float(land.heights.max())],
        "middle_deg": [land.latitude, land.longitude],
        "land_share": round(float(seen.size / picture.depth.size), 4),
        "farthest_m": float(seen.max()) if seen.size else None,
        "exposure": picture.exposure(),
    }


def text_of(value: Any) -> str:
    """A fact for people."""
    if isinstance(value, list):
        return "; ".join(str(item) for item in value) if value and isinstance(value[0], str) else str(value)
    return f"{value:.6g}" if isinstance(value, float) else str(value)
