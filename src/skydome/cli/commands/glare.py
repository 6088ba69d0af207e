"""`skydome glare`: what an eye, or a camera, makes of a map's sun, side by side with the bare view."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from typer import Argument, Option

from skydome.cli.commands.convert import From
from skydome.cli.doors import progress, require_picture
from skydome.cli.map_file import Exposure
from skydome.cli.options import AsJson, numbers
from skydome.cli.printing import show
from skydome.ground.extras import required

if TYPE_CHECKING:
    from skydome.eye.eye import Eye, Seen
    from skydome.eye.view import Camera
    from skydome.maps.environment_map import EnvironmentMap

SPREADS = ("stiles-holladay", "cie", "photopic", "mesopic", "scotopic")
LOW_RANGE = (".png", ".jpg", ".jpeg", ".bmp", ".gif", ".tif", ".tiff", ".webp")


def glare(
    source: Annotated[Path, Argument(help="A map with its light in cd m-2: .exr or .hdr.", metavar="SKY")],
    view: Annotated[str, Option(metavar="AZ,EL", help="Where the eye looks: azimuth and elevation, degrees.")],
    output: Annotated[
        Path | None, Option("--output", "-o", help="eye.png: without and with, side by side; eye.exr: with, linear.")
    ] = None,
    fov: Annotated[float, Option(help="Width of the view, degrees, 1-150.")] = 60.0,
    age: Annotated[float, Option(help="Age of the eye, years, 5-100.")] = 35.0,
    iris: Annotated[
        str | None, Option(help="Colour of the iris: black, brown, green or blue; the spread is then CIE 135/1.")
    ] = None,
    spread: Annotated[
        str | None,
        Option(
            help="How the eye spreads light: " + ", ".join(SPREADS) + ". [default: stiles-holladay; cie with --iris]"
        ),
    ] = None,
    pupil: Annotated[float | None, Option(help="Diameter of the pupil, mm. [default: by the light]")] = None,
    size: Annotated[int, Option(help="Pixels along a side of the view.")] = 1024,
    seed: Annotated[int, Option(help="Which needles the eye has.")] = 0,
    exposure: Exposure = None,
    white: Annotated[float | None, Option(help="cd m-2 of RGB (1, 1, 1), where the file does not tell.")] = None,
    target: From = None,
    lens_flare: Annotated[bool, Option("--lens-flare", help="Through a camera's lens instead of an eye.")] = False,
    as_json: AsJson = False,
) -> None:
    """Show and measure the glare of a map: veil, halo and needles about the sun; glare probability, illuminance."""
    from skydome.eye.glare import glare as measured
    from skydome.eye.lens_flare import LensFlare
    from skydome.eye.view import Camera, require_view_of_glare
    from skydome.ground.units import deg

    azimuth, elevation = numbers(view, 2, "--view", "180,20")
    looker = eye_of(age, iris, pupil, spread, seed)
    frame = Camera(azimuth % 360 * deg, elevation * deg, fov * deg, size)
    require_view_of_glare(frame)
    require_picture(output)
    required("scipy", "eye", "glare")
    environment = bright_map(source, target, white)
    with progress("measuring the glare"):
        numbers_of_glare = measured(environment, frame.azimuth, frame.elevation, age)
    facts = glare_facts(numbers_of_glare) | {"source": str(source), "view_deg": [azimuth, elevation], "fov_deg": fov}
    facts |= {"age": age, "iris": iris, "spread": str(looker.own_spread)}
    if output is not None:
        with progress("painting the view"):
            seen = (LensFlare(seed=seed) if lens_flare else looker).look(environment, frame)
            save_seen(output, seen, frame, exposure)
        facts |= {"file": str(output), "suns_in_map": len(seen.sources)}
    show(facts, glare_rows(facts), as_json)


def eye_of(age: float, iris: str | None, pupil: float | None, spread: str | None, seed: int) -> "Eye":
    """The eye that the options describe; ValueError for a spread unknown, or one that knows no iris."""
    from skydome.eye import point_spread
    from skydome.eye.eye import Eye
    from skydome.eye.streaks import Needles

    needles = Needles(seed=seed)
    if spread is not None and spread not in SPREADS:
        raise ValueError(f"--spread must be one of {', '.join(SPREADS)}, got {spread!r}")
    if spread is None or (spread == "cie" and iris):
        return Eye(age, iris, pupil, needles=needles)
    if spread == "cie":
        return Eye(age, "brown", pupil, needles=needles)
    if iris is not None:
        raise ValueError(f"--iris goes with --spread cie, which knows irises, got --spread {spread}")
    chosen = None if spread == "stiles-holladay" else getattr(point_spread, spread.upper())
    return Eye(age, pupil=pupil, spread=chosen, needles=needles)


def bright_map(path: Path, target: str | None, white: float | None) -> "EnvironmentMap":
    """The map in a file, in cd m-2; ValueError where the file cannot hold a sun's light, or does not tell its unit."""
    from dataclasses import replace

    from skydome.maps.loading import load

    if path.suffix.lower() in LOW_RANGE:
        raise ValueError(
            f"glare needs light in cd m-2 (.exr or .hdr), which 8 or 16 bit pictures lack; got {path.name!r}"
        )
    environment = load(path, target=target)
    if white is not None:
        environment = replace(environment, white_luminance=white)
    brightest = float(environment.luminance().max())
    if not brightest > 1:
        raise ValueError(
            f"glare needs luminance in cd m-2, got a map of at most {brightest:g}; give --white CD for RGB (1, 1, 1)"
        )
    return environment


def save_seen(path: Path, seen: "Seen", view: "Camera", exposure: float | None) -> None:
    """Write without and with side by side as .png under one exposure, or what the eye sees as linear .exr."""
    import numpy as np

    from skydome.ground import exr, png
    from skydome.light.colour import SRGB, encode_srgb
    from skydome.light.tone import Filmic, auto_exposure, tone_mapped
    from skydome.maps.files import light_unit

    if path.suffix.lower() == ".exr":
        exr.write(path, {"RGB": seen.eye}, light_unit(seen.space))
        return
    if exposure is None:
        exposure = auto_exposure(seen.eye @ seen.space.to_xyz[1], view.solid_angles())
    to_srgb = (SRGB.from_xyz @ seen.space.to_xyz * exposure).T.astype(np.float32)
    pictures = [encode_srgb(tone_mapped(picture @ to_srgb, Filmic())) for picture in (seen.plain, seen.eye)]
    gap = np.ones((view.shape[0], 8, 3), dtype=np.float32)
    png.write(path, np.concatenate([pictures[0], gap, pictures[1]], axis=1), {"Software": "skydome glare"})


def glare_facts(glare: Any) -> dict[str, Any]:
    """The numbers of a glare, with their units in their names."""
    return {
        "veiling_luminance_cd_m2": glare.veil,
        "daylight_glare_probability": glare.probability,
        "vertical_illuminance_lx": glare.illuminance,
        "glare_sources": [
            {
                "luminance_cd_m2": source.luminance,
                "solid_angle_sr": source.solid_angle,
                "position_index": source.position_index,
                "direction": list(source.direction),
            }
            for source in glare.sources
        ],
    }


def glare_rows(facts: dict[str, Any]) -> dict[str, str]:
    """The same for people."""
    rows = {
        "veil": f"{facts['veiling_luminance_cd_m2']:,.0f} cd m-2 (Stiles-Holladay, light over 1 degree away)",
        "glare probability": f"{facts['daylight_glare_probability']:.3f} (DGP; {len(facts['glare_sources'])} sources)",
        "at the eye": f"{facts['vertical_illuminance_lx']:,.0f} lx",
    }
    return rows | ({"file": facts["file"]} if "file" in facts else {})
