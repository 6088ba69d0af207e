"""Many sites, one Zarr store: computed by Dask workers, each site written whole, resumed where it stopped."""

import csv
import os
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from io import StringIO
from itertools import islice
from os import PathLike
from pathlib import Path
from typing import Any

from skydome.ground.arrays import brief
from skydome.ground.extras import required
from skydome.ground.files.reading import decoding, text_in
from skydome.ground.limits.sizes import require_count
from skydome.sun.track import SunTrack
from skydome.years.stores.cluster import cluster_client
from skydome.years.stores.sites_store import FAILED, HOURS, Site, is_whole, mark, open_store, write_site
from skydome.years.weather.closure import aligned
from skydome.years.weather.reading import as_written
from skydome.years.weather.weather import Weather

SITES_A_TASK = 5
MOST_SITES = 100_000
"""In a table."""


@dataclass(frozen=True)
class Outcome:
    """What came of a site: its place in the store, and what went wrong, if anything."""

    index: int
    error: str = ""


def read_sites(path: str | PathLike[str], folder: str | PathLike[str] | None = None) -> tuple[list[Site], list[str]]:
    """The sites of a CSV with columns `name` and `file`, and a line for each bad row; files lie in `folder`.

    ValueError where the columns are missing.
    """
    base = Path(folder) if folder is not None else Path(path).parent
    sites, bad = [], []
    text = StringIO(text_in(path, "a table of sites"), newline="")
    with decoding(path, "a table of sites"):
        table = csv.DictReader(text)
        titles, rows = table.fieldnames, list(islice(table, MOST_SITES + 1))
    if titles is None or not {"name", "file"} <= set(titles):
        raise ValueError(f"{Path(path).name} needs columns name and file, got {brief(titles, typed=False)}")
    require_count(len(rows), MOST_SITES, f"sites in {Path(path).name}")
    for row, cells in enumerate(rows, start=2):
        name, weather = (cells.get("name") or "").strip(), (cells.get("file") or "").strip()
        if not name or not weather:
            bad.append(f"line {row}: name and file must be given, got {name!r} and {weather!r}")
        elif not is_file(base / weather):
            bad.append(f"line {row} ({name}): no such file as {base / weather}")
        else:
            sites.append(Site(row, name, str(base / weather)))
    return sites, bad


def is_file(path: Path) -> bool:
    """True for a file; False too for a name that no file can have."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False


def make_sites(store: str, work: list[tuple[int, Site]], choices: dict[str, Any]) -> list[Outcome]:
    """Compute and write some sites; one that fails is told and the others go on. Each is marked done last of all."""
    tracks: dict[Any, SunTrack] = {}  # sites of one time zone share the sun's
    return [one_site(store, index, site, choices, tracks) for index, site in work]


def one_site(
    store: str, index: int, site: Site, choices: dict[str, Any], tracks: dict[Any, SunTrack] | None = None
) -> Outcome:
    """Compute and write one site: its arrays whole, then its state."""
    from skydome.years.skies.series import year

    try:
        weather = as_written(site.file)
        if weather.count != HOURS:
            raise ValueError(f"a year here has {HOURS} hours, got {weather.count}")
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            track = track_of(weather, tracks)
            data = year(aligned(weather, track=track), track=track, **choices)
    except (ValueError, OSError) as error:
        mark(store, index, FAILED)
        return Outcome(index, f"line {site.row} ({site.name}): {error}")
    write_site(store, index, data, weather.middle)
    warned = "; ".join(str(warning.message) for warning in caught if issubclass(warning.category, UserWarning))
    return Outcome(index, f"line {site.row} ({site.name}): warning: {warned}" if warned else "")


def track_of(weather: Weather, tracks: dict[Any, SunTrack] | None) -> SunTrack:
    """The sun over the year of a site, from those known where the days are the same."""
    days = (weather.start[0].astype("datetime64[D]"), weather.end[-1].astype("datetime64[D]"))
    tracks = {} if tracks is None else tracks
    if days not in tracks:
        tracks[days] = SunTrack.over(weather.start[0], weather.end[-1])
    return tracks[days]


def run_sites(
    store: str | PathLike[str],
    sites: list[Site],
    scheduler: str | None = None,
    workers: int = 2,
    progress: Callable[[int, int], None] | None = None,
    **choices: Any,
) -> list[str]:
    """Fill the store on a Dask cluster (`scheduler` address, or worker processes of this machine); what to tell.

    Sites that are done already, and whole, are left; a worker that dies has its sites done again by another. Every
    site's numbers are the same, whoever computes them. `progress(done, total)` is called as sites come in.
    """
    purpose = "the years of many sites"
    required("dask.distributed", "scale", purpose)
    from dask.distributed import as_completed

    with cluster_client(purpose, scheduler, workers) as client:
        group = open_store(store, sites, choices)
        open_work = [(k, site.anywhere) for k, site in enumerate(sites) if not is_whole(store, group, k)]
        batches = [open_work[k : k + SITES_A_TASK] for k in range(0, len(open_work), SITES_A_TASK)]
        notes: list[str] = []
        done = len(sites) - len(open_work)
        if progress is not None:
            progress(done, len(sites))
        where = os.path.abspath(store)  # workers may stand in other folders
        futures = [client.submit(make_sites, where, batch, choices, pure=False, retries=3) for batch in batches]
        for future in as_completed(futures):
            outcomes = future.result()
            notes += [outcome.error for outcome in outcomes if outcome.error]
            done += len(outcomes)
            if progress is not None:
                progress(done, len(sites))
    return sorted(notes)
