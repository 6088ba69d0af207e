"""`skydome evaluate`: sky models against a measured sky."""

from pathlib import Path
from typing import Annotated, Any

from typer import Argument, Option

from skydome.cli.doors import progress, require_folder, require_output
from skydome.cli.options import AsJson
from skydome.cli.printing import print_json
from skydome.ground.extras import required

COLUMNS = {
    "error": "error",
    "error_beyond_20_degrees": "beyond 20°",
    "bias": "bias",
    "luminance_error": "luminance",
    "chromaticity_error": "u'v'",
    "zenith_luminance_bias": "zenith",
    "illuminance_bias": "illuminance",
}
POINTED = {
    "pointed_error": "error, pointed",
    "pointed_error_beyond_20_degrees": "beyond 20°",
    "turn_least_deg": "turned from",
    "turn_most_deg": "to",
    "tilt_mean_deg": "tilt, degrees",
}
DEFAULT = "preetham,hosek-wilkie,discrete-ordinates,two-lobe-air"


def evaluate(
    measured: Annotated[Path, Argument(help="A compact netCDF file, or a folder of measurements as published.")],
    models: Annotated[str, Option(help="Names with commas, or `all`.")] = DEFAULT,
    fit: Annotated[
        str,
        Option(metavar="no|all|half|each", help="Fit each model's numbers: to all scans, to every second, to each."),
    ] = "no",
    pointing: Annotated[
        bool, Option("--pointing", help="Also point each scan anew for each model: turn and tilt, degrees.")
    ] = False,
    table: Annotated[Path | None, Option(help="Write the table as .csv.")] = None,
    figures: Annotated[Path | None, Option(help="A folder for maps, meridian and day (.png).")] = None,
    scan: Annotated[int, Option(help="The scan of maps and meridian, from 0.")] = 3,
    as_json: AsJson = False,
) -> None:
    """Hold sky models against a measured sky: error of radiance over 400-700 nm, luminance, colour; tables and maps.

    With `--fit half` the numbers are fitted to scans 0, 2, 4 ... and the table is of the others.
    """
    from skydome.evaluation.measured_sky import MeasuredSky
    from skydome.evaluation.runs import evaluated

    require_output(table, "the table")
    require_folder(figures)
    if figures is not None:
        required("matplotlib", "plot", "a figure")
    sky = MeasuredSky.open(measured)
    if not 0 <= scan < len(sky):
        raise ValueError(f"scan must lie in [0, {len(sky) - 1}], got {scan}")
    with progress("evaluating"):
        runs = evaluated(sky, [name.strip() for name in models.split(",")], fit, pointing)
    rows = [run.row() for run in runs]
    if table is not None:
        write_table(rows, table)
    if figures is not None:
        draw(runs, figures, scan)
    if as_json:
        print_json({"measured": str(measured), "scans": len(sky), "fit": fit, "models": rows})
    else:
        show_table(rows)


def write_table(rows: list[dict[str, Any]], path: Path) -> None:
    """The rows as comma-separated values, atomically."""
    import csv

    from skydome.ground.writing import appearing

    with appearing(path) as beside, beside.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)


def show_table(rows: list[dict[str, Any]]) -> None:
    """The rows as a table on stdout, and those of scans pointed anew as another."""
    show_columns(rows, COLUMNS, "numbers")
    if "pointed_error" in rows[0]:
        show_columns(rows, POINTED)


def show_columns(rows: list[dict[str, Any]], columns: dict[str, str], last: str = "") -> None:
    """A table of the rows' figures by name, under their headings; `last`: what is told in words."""
    from rich.console import Console
    from rich.table import Table

    shown = Table(box=None, pad_edge=False)
    shown.add_column("model", style="bold")
    for heading in columns.values():
        shown.add_column(heading, justify="right")
    if last:
        shown.add_column(last, overflow="fold")
    for row in rows:
        shown.add_row(row["model"], *(f"{row[key]:.3f}" for key in columns), *([row[last]] if last else []))
    Console().print(shown)


def draw(runs: list[Any], folder: Path, scan: int) -> None:
    """Maps, meridian and day as PNG files in a folder."""
    from skydome.evaluation.figures import day_figure, maps_figure, meridian_figure
    from skydome.figures.skies import save_figure

    comparisons = [run.comparison for run in runs]
    scan = min(scan, len(comparisons[0].sky) - 1)
    save_figure(maps_figure(comparisons, scan), folder / "evaluation-maps.png")
    save_figure(meridian_figure(comparisons, scan), folder / "evaluation-meridian.png")
    save_figure(day_figure(comparisons), folder / "evaluation-day.png")
