"""`skydome year sites.csv`: the years of many sites in one store."""

from pathlib import Path
from typing import Any

from skydome.cli.doors import STORE, progress, refuse_idle
from skydome.ground.extras import required


def require_sites(alone: dict[str, Any]) -> None:
    """ValueError for options of one weather file (`alone`) beside a table of sites; ImportError without Dask."""
    refuse_idle(alone, dict.fromkeys(alone) | {"utc_offset": 0.0, "sun_in_patch": False}, "for a table of sites")
    required("dask.distributed", "scale", "the years of many sites")


def years_of_sites(
    path: Path,
    output: Path | None,
    folder: Path | None,
    scheduler: str | None,
    workers: int,
    choices: dict[str, Any],
) -> dict[str, Any]:
    """The years of all sites in one Zarr store, with progress; the facts to print."""
    from skydome.years.stores.sites import read_sites, run_sites

    if output is None or output.suffix.lower() != STORE:
        raise ValueError("many sites need -o skies.zarr")
    sites, bad = read_sites(path, folder)
    if not sites:
        raise ValueError(f"{path.name} has no usable site: {'; '.join(bad) or 'it is empty'}")
    with progress("site-years") as report:
        notes = run_sites(output, sites, scheduler, workers, report, **choices)
    failed = [line for line in notes if "warning:" not in line]
    return {
        "sites": len(sites),
        "done": len(sites) - len(failed),
        "failed": len(failed) + len(bad),
        "files": [str(output)],
        "notes": bad + notes,
    }
