"""`skydome weather`: how good a weather file's light is, a picture of it, its repair, and minutes made of its hours."""

import warnings
from pathlib import Path
from typing import Annotated, Any

from typer import Argument, Option

from skydome.cli.doors import progress, refuse_idle, require_output
from skydome.cli.options import AsJson
from skydome.cli.printing import show
from skydome.cli.quantities import minutes
from skydome.ground.extras import required

MONTHS = ("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")


def weather(
    file: Annotated[Path, Argument(help="EPW, WEA, TMY3, TM2, NSRDB, SAM or PVGIS file.")],
    repair: Annotated[
        Path | None, Option("--repair", help="Write it repaired, each repair flagged: site.epw or table.csv.")
    ] = None,
    downscale: Annotated[
        Path | None, Option("--downscale", help="Write it in steps of minutes, clouds made up: site.wea.")
    ] = None,
    step: Annotated[str, Option(metavar="MINUTES", help="The steps of --downscale: 1min to 30min.")] = "5min",
    seed: Annotated[int, Option(help="Of --downscale: another seed, other clouds.")] = 0,
    plot: Annotated[Path | None, Option(help="A picture of the record: quality.png, .svg or .pdf.")] = None,
    place: Annotated[
        str | None, Option(metavar="LAT,LON[,ALT]", help="For a table that tells of no site; else in its stead.")
    ] = None,
    utc_offset: Annotated[float, Option(metavar="HOURS", help="Hours east of UTC, for such a table.")] = 0.0,
    shift: Annotated[
        str | None, Option(metavar="auto|MINUTES", help="Move the irradiances later, so that they fit the sun.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Tell how good a weather file's light is: gaps, light at night, shifts, limits, clearness; repair it if asked.

    With --downscale its hours, repaired first where --repair is asked for too, become minutes of the same energy.
    """
    from skydome.sun.place import Place
    from skydome.years.quality.repaired_file import write_repaired
    from skydome.years.quality.repairs import repaired
    from skydome.years.quality.report import quality
    from skydome.years.weather.reading import read_weather

    require_files(file, repair, downscale, plot)
    if downscale is None:
        refuse_idle({"step": step, "seed": seed}, {"step": "5min", "seed": 0}, "without --downscale")
    fine = minutes_of(step)
    moved: Any = minutes(shift)
    spot = None if place is None else Place.parse(place)
    with warnings.catch_warnings(record=True) as caught, progress("a look at the weather"):
        warnings.simplefilter("always", UserWarning)
        record = read_weather(file, shift=moved, place=spot, utc_offset=utc_offset)
        report = quality(record)
        facts = facts_of(report)
        if repair is not None:
            done = repaired(record)
            write_repaired(done, file, repair)
            facts["repaired_hours"] = done.counts
            record = done.weather
        if downscale is not None:
            facts["downscaled"] = write_downscaled(record, downscale, fine, seed)
        if plot is not None:
            draw(report, plot)
    facts["notes"] = [str(warning.message) for warning in caught if warning.category is UserWarning]
    facts["files"] = [str(path) for path in (repair, downscale, plot) if path is not None]
    show(facts, rows_of(facts), as_json)


def require_files(file: Path, repair: Path | None, downscale: Path | None, plot: Path | None) -> None:
    """ValueError for files that cannot be written, or in whose place the weather that is read lies."""
    from skydome.figures.skies import FORMATS

    require_output(repair, "--repair", (".epw", ".csv", ".gz"), file)
    require_output(downscale, "--downscale", (".wea",), file)
    require_output(plot, "a plot's file", FORMATS)
    if plot is not None:
        required("matplotlib", "plot", "a plot")


def draw(report: Any, path: Path) -> None:
    """Save the record's picture."""
    from skydome.figures.skies import save_figure
    from skydome.figures.weather import weather_figure

    save_figure(weather_figure(report), path)


def minutes_of(step: str) -> int:
    """Minutes of a step such as 5min or 5; ValueError for other words.

    >>> minutes_of("5min"), minutes_of("10")
    (5, 10)
    """
    digits = step.removesuffix("min").strip()
    if not digits.isdecimal():
        raise ValueError(f"--step must be minutes such as 5min, got {step!r}")
    return int(digits)


def write_downscaled(record: Any, path: Path, step: int, seed: int) -> dict[str, Any]:
    """What is told of the record's minutes, once written as a tape."""
    from skydome.years.downscaling.downscaled import downscaled
    from skydome.years.quality.report import quality
    from skydome.years.weather.wea import write_wea

    fine = downscaled(record, step, seed)
    write_wea(fine, path)
    report = quality(fine)
    sums = {name: round(value, 1) for name, value in report.sums.items()}
    return {
        "step_min": step,
        "seed": seed,
        "rows": fine.count,
        "irradiation_kwh_m2": sums,
        "variability": round(report.variability, 4),
    }


def facts_of(report: Any) -> dict[str, Any]:
    """The report in numbers, lists and strings."""
    record, closure = report.looked.weather, report.closure
    return {
        "site": record.name,
        "place": {name: getattr(record.place, name) for name in ("latitude", "longitude", "altitude")},
        "rows": record.count,
        "first_local": str(record.local[0]),
        "last_local": str(record.local[-1]),
        "irradiation_kwh_m2": {name: round(value, 1) for name, value in report.sums.items()},
        "hours_with": report.counts,
        "missing_rows_h": report.missing_rows,
        "closure_error": None if closure is None else closure.error,
        "closure_shift_min": None if closure is None else closure.shift,
        "closure": None if closure is None else closure.text,
        "linke_turbidity": [None if value != value else round(float(value), 2) for value in report.linke],
        "hours_by_clearness": [float(value) for value in report.clearness],
        "variability": round(report.variability, 4),
        "clear_share": round(report.clear_share, 4),
        "overcast_share": round(report.overcast_share, 4),
        "decomposition": record.decomposition or None,
        "sentences": report.sentences,
    }


def rows_of(facts: dict[str, Any]) -> dict[str, str]:
    """The same for people."""
    place = facts["place"]
    known = [(name, value) for name, value in zip(MONTHS, facts["linke_turbidity"], strict=True) if value is not None]
    rows = {
        "site": f"{facts['site']}, {place['latitude']:g}, {place['longitude']:g}, {place['altitude']:g} m",
        "rows": f"{facts['rows']:,}, {facts['first_local']} to {facts['last_local']}",
        "irradiation": ", ".join(f"{name} {value:,.0f}" for name, value in facts["irradiation_kwh_m2"].items())
        + " kWh m⁻²",
        "to look at": "\n".join(facts["sentences"]) or "nothing",
        "clear, overcast": f"{facts['clear_share']:.0%}, {facts['overcast_share']:.0%} of hours with the sun above 15°",
        "variability": f"{facts['variability']:.3f} of the clear sky's light, hour to hour",
        "turbidity": "Linke, clearest hours: " + ", ".join(f"{name} {value:.1f}" for name, value in known),
    }
    texts = {
        "downscaled": downscaled_text(facts["downscaled"]) if "downscaled" in facts else "",
        "repaired": ", ".join(f"{count:,} h {name}" for name, count in facts.get("repaired_hours", {}).items()),
        "files": ", ".join(facts["files"]),
        "notes": "\n".join(facts["notes"]),
    }
    return rows | {name: text for name, text in texts.items() if text}


def downscaled_text(made: dict[str, Any]) -> str:
    """What is told of the minutes, for people."""
    sums = ", ".join(f"{name} {value:,.0f}" for name, value in made["irradiation_kwh_m2"].items())
    return (
        f"{made['rows']:,} rows of {made['step_min']} min, seed {made['seed']}: {sums} kWh m⁻²; variability "
        f"{made['variability']:.3f} from step to step"
    )
