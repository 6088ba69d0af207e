"""`skydome render`: an environment map of the sky in a file."""

from pathlib import Path
from typing import Annotated, Any

from typer import Option

from skydome.cli.doors import progress, require_output
from skydome.cli.numbers_of_light import light_facts, light_rows, notes_row
from skydome.cli.options import AsJson, Half, SkyOptions, Target, taking
from skydome.cli.printing import show
from skydome.cli.scene import scene_of

SPACES = {"srgb": "SRGB", "rec2020": "REC2020", "acescg": "ACESCG"}
USUAL_TEXELS = 2 * 1024**2


@taking(SkyOptions)
def render(
    options: SkyOptions,
    output: Annotated[Path, Option("--output", "-o", help="sky.exr, sky.hdr, or sky.png for a preview.")],
    target: Target = "native",
    height: Annotated[int | None, Option(help="Rows. [default: 1024, or texels of about that size]")] = None,
    half: Half = False,
    space: Annotated[str, Option(metavar="srgb|rec2020|acescg", help="Linear RGB space of the file.")] = "srgb",
    ground: Annotated[
        str | None, Option(metavar="black|ALBEDO", help="Ground below the horizon. [default: --albedo]")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Write an environment map of the sky and print its numbers."""
    import skydome as sd
    from skydome.maps.files import FORMATS

    layout = sd.target(target)
    rows = layout.projection.height_for(USUAL_TEXELS) if height is None else height
    layout.projection.shape(rows)  # refuses a height before the work
    require_output(output, "a map's file", FORMATS)
    colours = space_named(space)
    albedo = ground_albedo(ground, options)
    scene = scene_of(options)
    metadata = {} if scene.moment is None else scene.moment.metadata
    metadata["software"] = f"skydome {sd.__version__}"
    with progress(f"rendering {rows} rows"):
        picture = sd.render(
            scene.whole, rows, projection=layout.projection, space=colours, ground_albedo=albedo, metadata=metadata
        )
        picture.save(output, target=target, half=half)
    facts = light_facts(scene) | file_facts(output, picture.pixels.shape, layout, colours.name)
    show(facts, light_rows(facts) | file_rows(facts) | notes_row(facts["notes"]), as_json)


def space_named(name: str) -> Any:
    """The RGB space by name; ValueError lists the names there are."""
    import skydome as sd

    if name not in SPACES:
        raise ValueError(f"space must be one of {', '.join(SPACES)}, got {name!r}")
    return getattr(sd, SPACES[name])


def ground_albedo(ground: str | None, options: SkyOptions) -> float | None:
    """The ground's albedo: --ground, else --albedo, else None for the sky's own."""
    if ground is None or ground == "black":
        return options.albedo if ground is None else 0.0
    try:
        return float(ground)
    except ValueError:
        raise ValueError(f"ground must be black or an albedo in [0, 1], got {ground!r}") from None


def file_facts(path: Path, shape: tuple[int, ...], layout: Any, space: str) -> dict[str, Any]:
    """What was written, and where the renderer has north."""
    return {
        "file": str(path),
        "bytes": path.stat().st_size,
        "height": shape[0],
        "width": shape[1],
        "target": layout.name,
        "orientation": layout.note,
        "space": space,
    }


def file_rows(facts: dict[str, Any]) -> dict[str, str]:
    """The same for people."""
    size = f"{facts['width']} x {facts['height']}, {facts['space']}, {facts['bytes'] / 1e6:.1f} MB"
    return {"file": facts["file"], "size": size, "target": f"{facts['target']}: {facts['orientation']}"}
