"""`skydome render`: an environment map of the sky in a file."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from typer import Option

from skydome.cli.doors import progress
from skydome.cli.map_file import FileOptions, file_facts, file_rows
from skydome.cli.numbers_of_light import light_facts, light_rows, notes_row
from skydome.cli.options import AsJson, SkyOptions, taking
from skydome.cli.printing import show
from skydome.cli.scene import scene_of

if TYPE_CHECKING:
    from skydome.maps.targets import Target

SPACES = {"srgb": "SRGB", "rec2020": "REC2020", "acescg": "ACESCG"}
USUAL_TEXELS = 2 * 1024**2


@taking(SkyOptions, FileOptions)
def render(
    options: SkyOptions,
    file: FileOptions,
    output: Annotated[Path, Option("--output", "-o", help="sky.exr, sky.hdr, or sky.png for a preview.")],
    height: Annotated[int | None, Option(help="Rows. [default: 1024, or texels of about that size]")] = None,
    space: Annotated[str, Option(metavar="srgb|rec2020|acescg", help="Linear RGB space of the file.")] = "srgb",
    ground: Annotated[
        str | None, Option(metavar="black|ALBEDO", help="Ground below the horizon. [default: --albedo]")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Write an environment map of the sky and print its numbers."""
    import skydome as sd

    layout = file.layout(output)
    rows = layout.projection.height_for(USUAL_TEXELS) if height is None else height
    layout.projection.shape(rows)  # refuses a height before the work
    colours = space_named(space, layout)
    albedo = ground_albedo(ground, options)
    scene = scene_of(options)
    metadata = {} if scene.moment is None else scene.moment.metadata
    metadata["software"] = f"skydome {sd.__version__}"
    with progress(f"rendering {rows} rows"):
        picture = sd.render(
            scene.whole, rows, projection=layout.projection, space=colours, ground_albedo=albedo, metadata=metadata
        )
        picture.save(output, **file.choices)
    written = file_facts(output, picture, layout, file)
    facts = light_facts(scene)
    facts |= written | {"notes": facts["notes"] + written["notes"]}
    show(facts, light_rows(facts) | file_rows(facts) | notes_row(facts["notes"]), as_json)


def space_named(name: str, layout: "Target") -> Any:
    """The RGB space by name; ValueError lists the names there are, and where the target would read it as another."""
    import skydome as sd

    if name not in SPACES:
        raise ValueError(f"space must be one of {', '.join(SPACES)}, got {name!r}")
    space = getattr(sd, SPACES[name])
    if not layout.takes(space):
        allowed = " or ".join(key for key, value in SPACES.items() if layout.takes(getattr(sd, value)))
        raise ValueError(
            f"--space for {layout.name}, which reads its numbers in no other, must be {allowed}, got {name}"
        )
    return space


def ground_albedo(ground: str | None, options: SkyOptions) -> float | None:
    """The ground's albedo: --ground, else --albedo, else None for the sky's own."""
    if ground is None or ground == "black":
        return options.albedo if ground is None else 0.0
    try:
        return float(ground)
    except ValueError:
        raise ValueError(f"ground must be black or an albedo in [0, 1], got {ground!r}") from None
