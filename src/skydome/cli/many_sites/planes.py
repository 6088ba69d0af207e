"""`skydome illuminance --weather sites.csv`: planes at many sites, computed by Dask."""

from typing import Any

from skydome.cli.doors import progress


def planes_of_sites(asked: Any, planes: list[Any], ground: float) -> dict[str, Any]:
    """The facts of planes at many sites; a whole file of them, as there is no table of so many hours."""
    from skydome.years.planes.portfolio import portfolio
    from skydome.years.stores.sites import read_sites
    from skydome.years.stores.stores import write_dataset

    if asked.output is None or asked.output.suffix.lower() == ".csv":
        raise ValueError("planes at many sites need -o planes.nc or planes.zarr")
    sites, bad = read_sites(asked.weather or "", asked.weather_folder)
    with progress("sites") as report:
        data, notes = portfolio(
            sites, planes, ground, asked.transposition, asked.patches or "tregenza", asked.target,
            asked.scheduler, asked.workers, report,
        )  # fmt: skip
    write_dataset(data, asked.output)
    whole = data["irradiation"].sum("month", skipna=False).mean("site")
    failed = [note for note in notes if "warning:" not in note]
    return {
        "sites": len(sites),
        "failed": len(failed) + len(bad),
        "mean_irradiation_kwh_m2": {
            str(label): round(float(value), 1) for label, value in zip(data["plane"].values, whole.values, strict=True)
        },
        "files": [str(asked.output)],
        "notes": bad + notes,
    }
