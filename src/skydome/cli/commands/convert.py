"""`skydome convert`: a map from one renderer's layout and file format to another's."""

from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from skydome.cli.commands.render import file_facts, file_rows
from skydome.cli.doors import progress, require_output
from skydome.cli.options import AsJson, Half, Target
from skydome.cli.printing import show

From = Annotated[str, Option("--from", help="The layout of the file that is read: a renderer, as for --target.")]


def convert(
    source: Annotated[Path, Argument(help="A map to read: .exr or .hdr.", metavar="IN")],
    output: Annotated[Path, Option("--output", "-o", help="The map to write: .exr, .hdr, or .png for a preview.")],
    target: Target = "native",
    layout: From = "native",
    height: Annotated[int | None, Option(help="Rows. [default: texels of about the same size]")] = None,
    half: Half = False,
    as_json: AsJson = False,
) -> None:
    """Bring a map into another renderer's layout, its light conserved."""
    import skydome as sd
    from skydome.maps.files import FORMATS
    from skydome.maps.loading import load

    wanted = sd.target(target)
    sd.target(layout)
    require_output(output, "a map's file", FORMATS)
    picture = load(source, target=layout)
    rows = picture.height_in(wanted.projection) if height is None else height
    with progress(f"resampling to {rows} rows"):
        result = picture.resampled(wanted.projection, rows)
        result.save(output, target=target, half=half)
    before, after = float(picture.illuminance()), float(result.illuminance())
    facts = {
        "source": str(source),
        "from": layout,
        "illuminance_lx": {"source": before, "file": after},
        **file_facts(output, result.pixels.shape, wanted, result.space.name),
    }
    rows_shown = {"source": f"{source} ({layout})", "global horizontal": f"{before:,.0f} lx before, {after:,.0f} after"}
    show(facts, rows_shown | file_rows(facts), as_json)
