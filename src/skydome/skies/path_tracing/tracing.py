"""What paths have brought so far: means and standard errors of passes, which can be merged, stored and taken up."""

from collections.abc import Callable
from dataclasses import dataclass
from os import PathLike
from typing import Any, Protocol

import numpy as np

from skydome.ground.arrays import Array
from skydome.ground.files.reading import arrays_in
from skydome.ground.limits.ranges import Range, require, require_one

PASSES = Range(0, 1 << 40)
MOST_BYTES = 1 << 30
"""Of a stored tracing."""


class Job(Protocol):
    """What is traced: directions (D, 3) at wavelengths (W,)."""

    @property
    def exact(self) -> Any:
        """Light that paths leave out, known exactly, for a sun of irradiance 1, sr-1, (D, W), or 0."""

    @property
    def sunlight(self) -> Array:
        """What light for a sun of irradiance 1 is multiplied by, (W,) or (D, W)."""

    def one_pass(self, number: int) -> Array:
        """The mean of one pass's paths, sr-1, (D, W)."""

    def fingerprint(self) -> str:
        """A hash of everything that the result depends on but the passes."""


@dataclass(frozen=True, eq=False)
class Tracing:
    """What paths have given so far: count of passes, mean and sum of squared deviations of the passes, each (D, W).

    Passes are independent, so a tracing can be stopped, stored, taken up and merged with another of the same job.
    """

    job: Job
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
        """Median of standard error over radiance where paths found light (a map's clouds, not its clear sky), or 0."""
        light, error = self.radiance, self.standard_error
        found = (light > 0) & (error > 0)
        return float(np.median(error[found] / light[found])) if found.any() else 0.0

    def more(self, passes: int = 1) -> "Tracing":
        """With further passes traced, numbered on from the last."""
        require("passes", passes, PASSES)
        require_one("passes", passes, whole=True)
        found = self
        for number in range(max(self.passes, default=-1) + 1, max(self.passes, default=-1) + 1 + int(passes)):
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
