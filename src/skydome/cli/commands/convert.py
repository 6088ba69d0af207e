"""`skydome convert`: a map from one renderer's layout and file format to another's."""

from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from skydome.cli.doors import progress
from skydome.cli.map_file import FileOptions, file_facts, file_rows
from skydome.cli.numbers_of_light import notes_row
from skydome.cli.options import AsJson, taking
from skydome.cli.printing import show

From = Annotated[
    str | None,
    Option("--from", help="The layout of the file that is read, where its header is silent. [default: native]"),
]


@taking(FileOptions)
def convert(
    file: FileOptions,
    source: Annotated[Path, Argument(help="A map to read: .exr or .hdr.", metavar="IN")],
    output: Annotated[Path, Option("--output", "-o", help="The map to write: .exr, .hdr, or .png for a preview.")],
    layout: From = None,
    height: Annotated[int | None, Option(help="Rows. [default: texels of about the same size]")] = None,
    as_json: AsJson = False,
) -> None:
    """Bring a map into another renderer's layout, its light conserved."""
    from skydome.ground.arguments import require_word
    from skydome.maps.files import layout_of, save
    from skydome.maps.loading import load
    from skydome.maps.targets import TARGETS

    wanted = file.layout(output)
    if layout is not None:
        require_word(layout, [known.name for known in TARGETS], "--from")
    picture = load(source, layout)
    rows = picture.height_in(wanted.projection) if height is None else height
    with progress(f"resampling to {rows} rows") as report:
        result = picture.resampled(wanted.projection, rows)
        shown = file.seen(result)
        before, after = float(picture.illuminance()), float(result.illuminance())
        written = save(shown, output, **file.choices, report=report)
    found = layout_of(picture.projection)
    facts = {
        "source": str(source),
        "from": layout or (found.name if found else repr(picture.projection)),
        "illuminance_lx": {"source": before, "file": after},
        **file_facts(output, shown, wanted, file, written),
    }
    rows_shown = {
        "source": f"{source} ({facts['from']})",
        "global horizontal": f"{before:,.0f} lx before, {after:,.0f} after",
    }
    show(facts, rows_shown | file_rows(facts) | notes_row(facts["notes"]), as_json)
