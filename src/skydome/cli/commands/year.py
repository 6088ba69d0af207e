"""`skydome year`: a weather file in, a year of skies out; or many sites on a cluster."""

import warnings
from pathlib import Path
from typing import Annotated, Any

from typer import Argument, Option

from skydome.cli.doors import STORE, progress, refuse_idle, require_output
from skydome.cli.many_sites.table import is_sites
from skydome.cli.many_sites.years import require_sites, years_of_sites
from skydome.cli.options import AsJson
from skydome.cli.printing import show_facts
from skydome.cli.quantities import minutes
from skydome.cli.spectral_map import steps
from skydome.ground.extras import required
from skydome.ground.limits.sizes import MOST_WORKERS

ENDINGS = {".zarr": "zarr", ".nc": "h5netcdf", ".mtx": "xarray"}
"""Endings of the file to write, and the library that each needs."""
PLAIN = {
    "weather_folder": None,
    "scheduler": None,
    "workers": 2,
    "turbidity": 3.0,
    "ascii": False,
    "sun_in_patch": False,
}
"""Defaults of options that may change nothing."""


def year(
    weather: Annotated[Path, Argument(help="EPW, WEA, TMY3, TM2, NSRDB, SAM or PVGIS file; or sites.csv (name,file).")],
    output: Annotated[
        Path | None, Option("--output", "-o", help="year.zarr, year.nc or year.mtx (Radiance, floats).")
    ] = None,
    patches: Annotated[str, Option(help="tregenza, reinhart:N or equal-area:N.")] = "tregenza",
    compat: Annotated[str, Option(metavar="paper|gendaylit|gendaymtx", help="Whose rules.")] = "paper",
    smooth: Annotated[bool, Option("--smooth", help="Blend neighbouring bins of clearness (ours).")] = False,
    colour: Annotated[
        str | None,
        Option(metavar="MODEL", help="Clear sky that lends its colours: physical (twilight too), preetham ..."),
    ] = None,
    turbidity: Annotated[float, Option(help="Haze of that clear sky.")] = 3.0,
    wavelengths: Annotated[
        str | None, Option(metavar="FROM,TO,STEP", help="Spectra too, nm, with --colour: 380,720,20.")
    ] = None,
    ascii_text: Annotated[bool, Option("--ascii", help="Write .mtx as text.")] = False,
    sun_in_patch: Annotated[bool, Option("--sun-in-patch", help="Put the sun's light into .mtx too.")] = False,
    suns: Annotated[Path | None, Option(help="Write the suns as Radiance sources: suns.rad.")] = None,
    plot: Annotated[Path | None, Option(help="Heat map and monthly domes: year.png, .svg or .pdf.")] = None,
    kinds: Annotated[
        Path | None, Option(help="Write the kind of each hour's sky, overcast to clear, as a table: kinds.csv.")
    ] = None,
    label: Annotated[
        str | None,
        Option(metavar="end|start|middle", help="Where rows' times stand, if not where the format has them."),
    ] = None,
    shift: Annotated[
        str | None, Option(metavar="auto|MINUTES", help="Move the irradiances later, so that they fit the sun.")
    ] = None,
    place: Annotated[
        str | None, Option(metavar="LAT,LON[,ALT]", help="For a table that tells of no site; else in its stead.")
    ] = None,
    utc_offset: Annotated[float, Option(metavar="HOURS", help="Hours east of UTC, for such a table.")] = 0.0,
    weather_folder: Annotated[Path | None, Option(help="Where the files of sites.csv lie.")] = None,
    scheduler: Annotated[str | None, Option(metavar="ADDRESS", help="A Dask scheduler, for sites.csv.")] = None,
    workers: Annotated[
        int, Option(min=1, max=MOST_WORKERS, help="Worker processes here, where no scheduler is given.")
    ] = 2,
    overwrite: Annotated[bool, Option("--overwrite", help="Replace the year that is in -o X.zarr.")] = False,
    as_json: AsJson = False,
) -> None:
    """Make the skies of a year from a weather file, on patches of the dome."""
    from skydome.sun.place import Place

    choices = {"patches": patches, "compat": compat, "smooth": smooth, "colour": colour, "turbidity": turbidity}
    choices["wavelengths"] = None if wavelengths is None else steps(wavelengths)
    reading = {"label": label, "shift": minutes(shift), "place": None if place is None else Place.parse(place)}
    reading["utc_offset"] = utc_offset
    sites = is_sites(weather)
    require_output(output, "-o", tuple(ENDINGS), overwrite=overwrite, goes_on=sites)
    require_outputs(suns, plot, kinds)
    check_extras(output, plot)
    given = {"weather_folder": weather_folder, "scheduler": scheduler, "workers": workers, "turbidity": turbidity}
    refuse_unused(given | {"ascii": ascii_text, "sun_in_patch": sun_in_patch}, sites, output, colour)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", UserWarning)
        if sites:
            alone = {"colour": colour, "wavelengths": wavelengths, "suns": suns, "plot": plot, "kinds": kinds}
            require_sites(reading | alone | {"sun_in_patch": sun_in_patch})
            choices = {name: choices[name] for name in ("patches", "compat", "smooth")}
            facts = years_of_sites(weather, output, weather_folder, scheduler, workers, choices)
        else:
            facts = single(weather, reading, choices, output, ascii_text, sun_in_patch, suns, plot, kinds, overwrite)
    notes = [str(warning.message) for warning in caught if warning.category is UserWarning]
    facts["notes"] = facts.get("notes", []) + notes
    show_facts(facts, as_json)
    if facts.get("failed"):
        raise ValueError(f"{facts['failed']} of the sites could not be done; see the notes")


def refuse_unused(given: dict[str, Any], sites: bool, output: Path | None, colour: str | None) -> None:
    """ValueError for options that would change nothing where there is no table of sites, no matrix or no colour."""
    matrix = output is not None and output.suffix.lower() == ".mtx"
    for used, names, why in (
        (sites, ("weather_folder", "scheduler", "workers"), "without a table of sites"),
        (matrix, ("ascii", "sun_in_patch"), "without -o year.mtx"),
        (colour is not None, ("turbidity",), "without --colour"),
    ):
        if not used:
            refuse_idle({name: given[name] for name in names}, PLAIN, why)


def require_outputs(suns: Path | None, plot: Path | None, kinds: Path | None) -> None:
    """ValueError or OSError, before any work, for files that could not be written in the end."""
    from skydome.figures.skies import FORMATS

    require_output(suns, "--suns", (".rad",))
    require_output(plot, "a plot's file", FORMATS)
    require_output(kinds, "--kinds", (".csv",))


def is_store(output: Path) -> bool:
    """True for a Zarr store, a folder."""
    return output.suffix.lower() == STORE


def check_extras(output: Path | None, plot: Path | None) -> None:
    """ImportError, before any work, for what the files to write need."""
    required("xarray", "year", "a year of skies")
    if output is not None:
        required(ENDINGS[output.suffix.lower()], "year", f"a year as {output.suffix}")
    if plot is not None:
        required("matplotlib", "plot", "a plot")


def single(
    path: Path,
    reading: dict[str, Any],
    choices: dict[str, Any],
    output: Path | None,
    ascii_text: bool,
    sun_in_patch: bool,
    suns: Path | None,
    plot: Path | None,
    kinds: Path | None,
    overwrite: bool,
) -> dict[str, Any]:
    """One site's year, written and drawn; the facts to print."""
    from skydome.years.skies.kinds_of_sky import write_kinds
    from skydome.years.stores.radiance_files import write_suns
    from skydome.years.stores.stores import write_year
    from skydome.years.weather.reading import read_weather

    with progress("a year of skies"):
        weather = read_weather(path, **reading)
        if output is not None and is_store(output) and choices["compat"] != "gendaymtx":
            data = write_year(weather, output, overwrite=overwrite, **choices)
        else:
            data = made_and_written(weather, choices, output, ascii_text, sun_in_patch, overwrite)
        if suns is not None:
            write_suns(data, suns)
        if plot is not None:
            from skydome.figures.skies import save_figure
            from skydome.figures.years import year_figure

            save_figure(year_figure(data), plot)
        facts = facts_of_year(data)
        if kinds is not None:
            facts["hours_by_kind"] = write_kinds(data, kinds)
    return facts | {"files": [str(file) for file in (output, suns, plot, kinds) if file is not None]}


def made_and_written(
    weather: Any, choices: dict[str, Any], output: Path | None, ascii_text: bool, sun_in_patch: bool, overwrite: bool
) -> Any:
    """The year, written as a matrix, a file or a store where an `output` is asked for."""
    from skydome.years.skies.series import year as year_of
    from skydome.years.stores.radiance_files import write_matrix
    from skydome.years.stores.spectral_matrix import write_spectral_matrix
    from skydome.years.stores.stores import write_dataset

    data = year_of(weather, **choices)
    if output is None:
        return data
    if output.suffix.lower() != ".mtx":
        write_dataset(data, output, overwrite)
    elif "radiance" in data:
        write_spectral_matrix(data, output, not ascii_text, with_sun=sun_in_patch)
    else:
        write_matrix(data, output, not ascii_text, with_sun=sun_in_patch)
    return data


def facts_of_year(data: Any) -> dict[str, Any]:
    """What is told of a year."""
    from skydome.years.skies.status import counts

    facts = {"site": data.attrs["title"], "place": place_facts(data), "hours": data.sizes["time"]}
    told = ("shift", "closure", "closure_shift", "decomposition")
    facts |= {name: data.attrs[name] for name in told if name in data.attrs}
    facts |= {"patches": data.sizes["patch"], "status": counts(data["status"].values)}
    diffuse = data["diffuse_horizontal_illuminance"]
    mean = float(diffuse.where(data["lit_share"] > 0).mean())
    return facts | {"mean_diffuse_horizontal_lx": round(mean, 1)}


def place_facts(data: Any) -> dict[str, float]:
    """Where the year is."""
    return {name: float(data.attrs[name]) for name in ("latitude", "longitude", "altitude", "utc_offset")}
