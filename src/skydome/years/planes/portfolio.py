"""Many sites by many planes: monthly sums and autonomies of each, computed by Dask's workers."""

import warnings
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from skydome.dome.patches import patches as patches_named
from skydome.ground.extras import required
from skydome.sun.track import SunTrack
from skydome.years.planes.coefficients import Coefficients
from skydome.years.planes.light import check, on_known
from skydome.years.planes.plane import Plane, labels_of
from skydome.years.planes.sums import monthly_sums
from skydome.years.planes.transposition import Transposition, transposition_named
from skydome.years.skies.series import year
from skydome.years.stores.cluster import cluster_client
from skydome.years.stores.sites import track_of
from skydome.years.stores.sites_store import Site
from skydome.years.weather.closure import aligned
from skydome.years.weather.reading import as_written

if TYPE_CHECKING:
    import xarray

SITES_A_TASK = 10
PURPOSE = "the planes of many sites"
SUMS = ("sky_irradiation", "sun_irradiation", "reflected_irradiation", "irradiation", "light_exposure")


class Question(NamedTuple):
    """What is asked of every site: planes and their coefficients, found once; `target`, lx, of the share of hours."""

    planes: Sequence[Plane]
    known: Coefficients
    patches: str
    albedo: float
    model: Transposition
    target: float


class Answer(NamedTuple):
    """A site's place among them, sums (S, 12, P), shares of daylit hours at the target (P,); or what went wrong."""

    order: int
    sums: np.ndarray
    autonomy: np.ndarray
    missing: float
    note: str = ""
    failed: bool = False


def portfolio(
    sites: Sequence[Site],
    planes: Sequence[Plane],
    albedo: float = 0.2,
    transposition: "str | Transposition" = "perez-1993",
    patches: str = "tregenza",
    target: float = 10_000.0,
    scheduler: str | None = None,
    workers: int = 2,
    progress: Callable[[int, int], None] | None = None,
) -> tuple["xarray.Dataset", list[str]]:
    """Sums of planes at every site, (site, month, plane), kWh m-2 and klx h, and what is to be told of sites.

    `autonomy` (site, plane) is the share of the hours with the sun up in which a plane has `target` lx. A site that
    cannot be done is NaN, and told; the others are done. Work goes to a Dask `scheduler`, or to `workers` processes.
    ValueError for no sites, and as `on_planes`.
    """
    required("dask.distributed", "scale", PURPOSE)
    from dask.distributed import as_completed

    if not sites:
        raise ValueError("a portfolio needs at least one site, got none")
    model = transposition_named(transposition)
    check(planes, albedo, model)
    known = Coefficients.of(planes, patches_named(patches), albedo)
    question = Question(list(planes), known, patches, albedo, model, target)
    work = [(index, site.anywhere) for index, site in enumerate(sites)]
    batches = [work[k : k + SITES_A_TASK] for k in range(0, len(work), SITES_A_TASK)]
    answers: list[Answer] = []
    with cluster_client(PURPOSE, scheduler, workers) as client:
        shared: Any = client.scatter(question, broadcast=True)
        futures = [client.submit(answered, batch, shared, pure=False, retries=3) for batch in batches]
        for future in as_completed(futures):
            answers += future.result()
            if progress is not None:
                progress(len(answers), len(sites))
    answers.sort(key=lambda answer: answer.order)
    return together(sites, question, answers), [answer.note for answer in answers if answer.note]


def answered(batch: list[tuple[int, Site]], question: Question) -> list[Answer]:
    """The answers of some sites; sites of one calendar share the sun's track."""
    tracks: dict[Any, SunTrack] = {}
    return [of_site(index, site, question, tracks) for index, site in batch]


def of_site(index: int, site: Site, question: Question, tracks: dict[Any, SunTrack]) -> Answer:
    """One site's sums; what is wrong with it is told."""
    nothing = np.full((len(SUMS), 12, len(question.planes)), np.nan), np.full(len(question.planes), np.nan)
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            weather = as_written(site.file)
            track = track_of(weather, tracks)
            skies = year(aligned(weather, track=track), question.patches, track=track)
    except (ValueError, OSError) as error:
        return Answer(index, *nothing, 0.0, f"line {site.row} ({site.name}): {error}", True)
    light = on_known(skies, question.planes, question.known, question.albedo, question.model)
    sums = monthly_sums(light)
    table = np.zeros(nothing[0].shape)
    table[:, sums["month"].values - 1] = np.stack([sums[name].values for name in SUMS])
    up = (skies["lit_share"].values > 0) & np.isfinite(light["illuminance"].values).all(axis=1)
    share = (light["illuminance"].values[up] >= question.target).mean(axis=0) if up.any() else nothing[1]
    told = "; ".join(str(warning.message) for warning in caught if issubclass(warning.category, UserWarning))
    note = f"line {site.row} ({site.name}): warning: {told}" if told else ""
    return Answer(index, table, share, float(sums["missing_hours"].sum()), note)


def together(sites: Sequence[Site], question: Question, answers: Sequence[Answer]) -> "xarray.Dataset":
    """The Dataset of all sites."""
    import xarray

    units = {name: "klx h" if name == "light_exposure" else "kWh m-2" for name in SUMS}
    stacked = np.stack([answer.sums for answer in answers])
    found: dict[str, Any] = {
        name: (("site", "month", "plane"), stacked[:, k], {"units": units[name], "long_name": name.replace("_", " ")})
        for k, name in enumerate(SUMS)
    }
    text = f"share of the hours with the sun up in which the plane has {question.target:g} lx"
    found["autonomy"] = (("site", "plane"), np.stack([answer.autonomy for answer in answers]), {"long_name": text})
    found["missing_hours"] = ("site", [answer.missing for answer in answers], {"units": "h"})
    names = [site.name for site in sites]
    coordinates = {"site": names, "month": np.arange(1, 13), "plane": labels_of(question.planes)}
    about = {"albedo": question.albedo, "transposition": question.model.name, "patches": question.patches}
    return xarray.Dataset(found, coordinates, about | {"target_lx": question.target})
