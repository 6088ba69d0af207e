"""The sky by brute force: backward Monte Carlo in spherical shells, all orders, ground, with its standard error."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from os import PathLike
from typing import Any, ClassVar

import numpy as np

from skydome.air.rays import ColumnTable
from skydome.ground.arrays import Array
from skydome.ground.compiled import shared
from skydome.ground.directions import checked_directions
from skydome.ground.extras import required
from skydome.ground.files.contents import digest_of
from skydome.ground.files.reading import arrays_in
from skydome.ground.limits.ranges import SEED, Range
from skydome.light.spectrum import checked_wavelengths
from skydome.skies.path_tracing.guide import guide_for
from skydome.skies.path_tracing.tables import law_tables, shells
from skydome.skies.physical.atmosphere_sky import AtmosphereSky
from skydome.skies.physical.nishita import scattered_once

GUIDED_BELOW = 3.0
"""Elevation of the sun, degrees, below which paths are guided: from there on it is worth what it costs."""

ALL_ORDERS = 1000

PATHS_PER_PIECE = 64
"""That are worth a thread's while."""

MOST_BYTES = 1 << 30
"""Of a stored tracing."""

PATHS = 2
"""Counted up whenever a seed comes to mean other paths, which are not to be mixed in one tracing."""


@dataclass(frozen=True, eq=False)
class Tracing:
    """What paths have given so far: count of passes, mean and sum of squared deviations of the passes, each (D, W).

    Passes are independent, so a tracing can be stopped, stored, taken up and merged with another of the same job.
    """

    job: "TracingJob"
    passes: tuple[int, ...]
    mean: np.ndarray
    deviation: np.ndarray

    @property
    def radiance(self) -> Array:
        """Spectral radiance, W m-2 sr-1 nm-1, shape (D, W)."""
        return (self.mean + self.job.exact) * self.job.sunlight

    @property
    def standard_error(self) -> Array:
        """Standard error of `radiance`, from the scatter of the passes; infinite with fewer than 2, shape (D, W)."""
        count = len(self.passes)
        if count < 2:
            return np.full_like(self.mean, np.inf)
        return np.sqrt(self.deviation / (count * (count - 1))) * self.job.sunlight

    @property
    def relative_error(self) -> float:
        """Median over directions and wavelengths of standard error over radiance."""
        light = self.radiance
        return float(np.median(self.standard_error[light > 0] / light[light > 0])) if (light > 0).any() else 0.0

    def more(self, passes: int = 1) -> "Tracing":
        """With further passes traced, numbered on from the last."""
        found = self
        for number in range(max(self.passes, default=-1) + 1, max(self.passes, default=-1) + 1 + passes):
            found = found.merged(Tracing(self.job, (number,), self.job.one_pass(number), np.zeros_like(self.mean)))
        return found

    def until(
        self, relative_error: float, most: int = 100_000, report: Callable[[float, int], None] | None = None
    ) -> "Tracing":
        """With as many passes, `most` in all, as bring the median relative standard error down to the one given.

        At least 8 passes where `most` allows. `report(relative error, passes)` is called as it goes on.
        """
        if not 0 < relative_error < 1:
            raise ValueError(f"relative_error must lie in (0, 1), got {relative_error}")
        found = self.more(max(0, min(8, most) - len(self.passes)))
        while found.relative_error > relative_error and len(found.passes) < most:
            if report is not None:
                report(found.relative_error, len(found.passes))
            wanted = min(len(found.passes) * (found.relative_error / relative_error) ** 2, most)
            found = found.more(int(np.clip(wanted - len(found.passes), 1, max(1, len(found.passes) // 4))))
        return found

    def merged(self, other: "Tracing") -> "Tracing":
        """Both together (Chan et al. 1983); ValueError where they share a pass or belong to other jobs."""
        if self.job is not other.job and self.job.fingerprint() != other.job.fingerprint():
            raise ValueError("only tracings of one job can be merged: sky, directions, wavelengths or seed differ")
        if set(self.passes) & set(other.passes):
            raise ValueError(
                f"the tracings share the pass {min(set(self.passes) & set(other.passes))}: give other seeds"
            )
        a, b = len(self.passes), len(other.passes)
        if a == 0 or b == 0:
            return other if a == 0 else self
        difference = other.mean - self.mean
        mean = self.mean + difference * (b / (a + b))
        deviation = self.deviation + other.deviation + difference**2 * (a * b / (a + b))
        return Tracing(self.job, tuple(sorted(self.passes + other.passes)), mean, deviation)

    def save(self, path: str | PathLike[str]) -> None:
        """Write to a .npz file, whole or not at all."""
        from skydome.ground.writing import appearing

        with appearing(path) as beside, beside.open("wb") as file:
            np.savez(
                file,
                passes=np.array(self.passes),
                mean=self.mean,
                deviation=self.deviation,
                job=np.array(self.job.fingerprint()),
            )

    def resumed(self, path: str | PathLike[str]) -> "Tracing":
        """Merged with what a file holds; ValueError for the file of another job."""
        held = arrays_in(path, "a tracing", {"job", "passes", "mean", "deviation"}, MOST_BYTES)
        if str(held["job"]) != self.job.fingerprint():
            raise ValueError(f"{path} holds another tracing: sky, directions, wavelengths or seed differ")
        mean, deviation = held["mean"], held["deviation"]
        whole = mean.shape == deviation.shape == self.mean.shape and np.isfinite(mean).all() and (deviation >= 0).all()
        if not whole or held["passes"].ndim != 1 or held["passes"].dtype.kind not in "iu":
            raise ValueError(f"{path} is damaged: passes {held['passes'].shape}, light {mean.shape}, {deviation.shape}")
        return self.merged(Tracing(self.job, tuple(held["passes"].tolist()), mean, deviation))


@dataclass(frozen=True, eq=False)
class TracingJob:
    """What is to be traced: a sky, directions (D, 3) and wavelengths (W,)."""

    sky: "PathTraced"
    directions: np.ndarray
    wavelengths: np.ndarray

    def start(self) -> Tracing:
        """A tracing without any pass."""
        nothing = np.zeros((len(self.directions), self.wavelengths.size))
        return Tracing(self, (), nothing, nothing)

    @property
    def sunlight(self) -> Array:
        """Irradiance above the air less what gases take, W m-2 nm-1, (W,) or (D, W)."""
        return self.sky.sunlight(self.directions, self.wavelengths)

    @cached_property
    def exact(self) -> Any:
        """The light scattered once, by quadrature, where the paths leave it out, sr-1, (D, W); else 0."""
        if not (self.sky.exact_first and self.sky.is_day):
            return 0.0
        table = ColumnTable.of(self.sky.atmosphere, 144, 128)
        start = np.full(len(self.directions), self.sky.atmosphere.radius)
        return scattered_once(table, start, self.directions, np.asarray(self.sky.sun), self.wavelengths)

    @cached_property
    def tables(self) -> tuple[Any, ...]:
        """The atmosphere, its phase laws and what guides the paths, as the kernel reads them."""
        air, sky = self.sky.atmosphere, self.sky
        geometry = shells(air, self.wavelengths)
        return geometry, law_tables(air, self.wavelengths), guide_for(geometry, float(sky.sun[2]), sky.guide_share)

    def one_pass(self, number: int) -> Array:
        """The mean of one pass's paths, sr-1, (D, W)."""
        from skydome.skies.path_tracing.loop_kernel import trace_views

        sky = self.sky
        if not sky.is_day:
            return np.zeros((len(self.directions), self.wavelengths.size))
        sun, views = np.asarray(sky.sun, dtype=np.float64), np.ascontiguousarray(self.directions, dtype=np.float64)
        paths = sky.paths_per_pass * self.wavelengths.size
        choices = sky.orders, sky.roulette, sky.exact_first, sky.seed, number, paths
        light = np.empty((len(views), self.tables[0].albedo.size))
        given = (views, sun, *self.tables, *choices, light)
        shared(trace_views, len(views), len(views) * paths, given, PATHS_PER_PIECE)
        return light[:, : self.wavelengths.size]

    def fingerprint(self) -> str:
        """A hash of everything that the result depends on but the passes."""
        sky = replace(self.sky, sun=np.asarray(self.sky.sun, dtype=np.float64))
        return digest_of(PATHS, sky, self.directions, self.wavelengths)


@dataclass(frozen=True, eq=False)
class PathTraced(AtmosphereSky):
    """The sky of an `atmosphere` by path tracing, to a `relative_error` (the median standard error) of each call.

    `orders` stops paths after so many scatterings; `exact_first` takes the first by quadrature. A share `guide` of the
    flights is guided to where light is scattered (None: 0.8 for suns below 3 degrees, else 0), which changes the noise
    and never the mean. The same `seed` gives the same light whatever the threads. Errors: Monte Carlo's, given by
    `job(...)`; Kocifaj's columns, below 0.3 %. No polarisation. Needs the extra `fast` (numba).

    >>> import skydome as sd
    >>> sky = PathTraced(sd.direction(azimuth=180 * sd.deg, elevation=45 * sd.deg), relative_error=0.02)
    >>> bool(abs(sky.radiance(sd.ZENITH, [450.0, 650.0])[0] / 0.065 - 1) < 0.05)
    True
    """

    relative_error: float = 0.01
    seed: int = 0
    orders: int = ALL_ORDERS
    exact_first: bool = True
    guide: float | None = None
    roulette: float = 0.2
    paths_per_pass: int = 8
    bounds: ClassVar = {
        "relative_error": Range(1e-6, 0.5),
        "seed": SEED,
        "orders": Range(1, ALL_ORDERS),
        "guide": Range(0, 0.95),
        "roulette": Range(0.0, 1.0),
        "paths_per_pass": Range(1, 1 << 20),
    }
    lowest_sun: ClassVar[float] = -12.0
    source: ClassVar[str] = "backward Monte Carlo, next-event estimation, spectral MIS (Wilkie et al. 2014)"
    quick_to_see: ClassVar[bool] = False

    def __post_init__(self) -> None:
        super().__post_init__()
        if not self.one_sun:
            raise ValueError(f"a path-traced sky has one sun of shape (3,), got {np.shape(self.sun)}")

    @property
    def guide_share(self) -> float:
        """Share of the flights that the guide samples."""
        if self.guide is not None:
            return self.guide
        return 0.8 if float(self.sun[2]) < np.sin(np.radians(GUIDED_BELOW)) else 0.0

    def job(self, directions: Array, wavelengths: Any) -> TracingJob:
        """The tracing of directions (D, 3) at wavelengths (W,), to be run, stored and merged by hand."""
        required("numba", "fast", "PathTraced")
        return TracingJob(self, np.asarray(directions, dtype=np.float64), checked_wavelengths(wavelengths))

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction (..., 3), W m-2 sr-1 nm-1, shape (..., W); 0 below the horizon."""
        self.tell_missing_bands(wavelengths)
        views = checked_directions(np.asarray(directions, dtype=np.float64))
        flat = views.reshape(-1, 3)
        up = flat[:, 2] >= 0
        light = np.zeros((len(flat), np.size(wavelengths)))
        if up.any():
            light[up] = self.job(flat[up], wavelengths).start().until(self.relative_error).radiance
        return light.reshape(*views.shape[:-1], -1)
