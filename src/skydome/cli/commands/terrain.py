"""`skydome terrain`: a picture of real land under a sky, with the air in between."""

from pathlib import Path
from typing import Annotated, Any

from typer import Argument, Option

from skydome.cli.doors import progress, require_picture
from skydome.cli.map_file import Exposure
from skydome.cli.models import hazed
from skydome.cli.moment import place_text
from skydome.cli.options import AsJson, SkyOptions, numbers, taking
from skydome.cli.printing import labelled_rows, show
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
    own_haze: Annotated[
        bool, Option("--own-haze", help="Leave far haze its own light, not that of the sky's horizon behind it.")
    ] = False,
    no_air: Annotated[bool, Option("--no-air", help="Without aerial perspective.")] = False,
    curvature: Annotated[
        bool, Option("--curvature", help="Lower the land, and the ground beyond it, by the Earth's curve.")
    ] = False,
    exposure: Exposure = None,
    as_json: AsJson = False,
) -> None:
    """Render an elevation model with sun, shadows, skylight and aerial perspective."""
    import numpy as np

    from skydome.haze.aerial_perspective import AirLight
    from skydome.haze.ground_air import own_air
    from skydome.land.picture import render_terrain
    from skydome.land.reading import read_elevation
    from skydome.land.texture import read_texture
    from skydome.light.colour import SRGB
    from skydome.skies.catalogue import model_named

    require_picture(output)
    required("numba", "terrain", "a terrain picture")
    albedo = np.array(numbers(ground_albedo, 3, "--ground-albedo", "0.11,0.12,0.07"))
    view = camera_of(camera, look, fov, size)
    options, seen = hazed(model_named(options.model), options)
    land, scene = read_elevation(land_file, vertical_unit), scene_of(options)
    surface, laid = (
        (albedo, ()) if texture is None else read_texture(texture, land, float(albedo @ np.asarray(SRGB.to_xyz[1])))
    )
    grey = float(np.mean(surface, axis=tuple(range(np.ndim(surface) - 1))) @ np.asarray(SRGB.to_xyz[1]))
    field, lit, whole = clouds_over(scene)
    of_sun = None if scene.disc is None else scene.disc.haze
    haze = options.turbidity or of_sun or 3.0 if own_air(whole) is None else None
    air = None if no_air else AirLight(whole, None, haze, grey, meets_horizon=not own_haze)
    with progress("rendering") as report:
        picture = render_terrain(land, view, lit, air, surface, samples, curvature, progress=report, clouds=field)
    picture.save(output, exposure) if output.suffix.lower() == ".png" else picture.save(output)
    facts = facts_of(output, land, picture) | {"sky": scene.name, "notes": [*land.notes, *laid, *seen, *scene.notes]}
    show(facts, rows_of(facts), as_json)


def clouds_over(scene: Any) -> tuple[Any, Any, Any]:
    """The clouds between sun and land, if any; the light on land, with a clear sky's sun, and on air, with its mean."""
    from skydome.skies.clouds.fields.shadows import ShadowMap

    if scene.clouds is None or scene.disc is None:
        return None, scene.whole, scene.whole
    field, disc = scene.clouds.field, scene.clouds.clear_disc
    shadows = ShadowMap.of(field, disc.sun, field.kind.period, 64)
    return field, scene.sky + disc, scene.sky + disc * float(shadows.share.mean())


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
    return Camera(azimuth % 360 * deg, elevation * deg, fov * deg, width, height, east, north, above)


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


def rows_of(facts: dict[str, Any]) -> dict[str, str]:
    """The facts as a table for people."""
    rows, columns = facts["cells"]
    east, north = facts["cell_m"]
    lowest, highest = facts["heights_m"]
    latitude, longitude = facts["middle_deg"]
    far = facts["farthest_m"]
    return labelled_rows(
        {
            "picture": facts["file"],
            "sky": facts["sky"],
            "land": f"{rows} x {columns} cells of {east:g} x {north:g} m, {columns * east / 1e3:.4g} km east to west, "
            f"{rows * north / 1e3:.4g} km north to south",
            "heights": f"{lowest:g} to {highest:g} m",
            "middle": None if latitude is None else place_text(round(latitude, 4), round(longitude, 4)),
            "land in the picture": f"{facts['land_share']:.1%} of the pixels",
            "farthest land": None if far is None else far_text(far),
            "exposure": f"{facts['exposure']:.4g} (factor on cd m-2 for the screen)",
            "notes": "\n".join(facts["notes"]),
        }
    )


def far_text(metres: float) -> str:
    """How far one sees land.

    >>> far_text(43210.0), far_text(4e8)
    ('43.21 km', 'more than 1,000 km: flat ground has no end; --curvature bends it')
    """
    if metres > 1e6:
        return "more than 1,000 km: flat ground has no end; --curvature bends it"
    return f"{metres / 1e3:.4g} km"
