"""The numbers of a model that fit a measured sky best: from several starts, with a warning at a limit."""

import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.evaluation.evaluation import band_mean, relative_rms
from skydome.evaluation.measured_sky import MeasuredSky
from skydome.evaluation.models import EvaluatedModel

WIDE = 20.0
"""How many times the least the most of a number is, from which steps are taken in its logarithm."""

TRIED, KEPT = 8, 2
"""Places looked at beside the usual numbers, and how many of them a fit starts from."""

FEW_SCANS = 3
"""Scans by which starts are tried."""

NEAR = 1e-3
"""Share of its range by which a number that ends at a limit may be away from it."""


@dataclass(frozen=True, eq=False)
class FitProblem:
    """A model and a measured sky; numbers are taken as steps from 0 to 1 between their limits."""

    model: EvaluatedModel
    sky: MeasuredSky

    @property
    def names(self) -> list[str]:
        """The numbers that are fitted."""
        return list(self.model.limits)

    def numbers(self, steps: np.ndarray) -> dict[str, float]:
        """Numbers by name from steps (p,)."""
        found = {}
        for name, step in zip(self.names, np.clip(steps, 0.0, 1.0), strict=True):
            low, high = self.model.limits[name]
            wide = low > 0 and high / low > WIDE
            found[name] = float(low * (high / low) ** step if wide else low + (high - low) * step)
        return found

    def steps(self, numbers: dict[str, float]) -> np.ndarray:
        """Steps (p,) of numbers by name."""
        found = []
        for name in self.names:
            (low, high), value = self.model.limits[name], numbers[name]
            wide = low > 0 and high / low > WIDE
            found.append(np.log(value / low) / np.log(high / low) if wide else (value - low) / (high - low))
        return np.clip(found, 0.0, 1.0)

    def light(self, steps: np.ndarray) -> np.ndarray:
        """The model's radiance averaged over 400-700 nm, (C, D)."""
        make, sky = self.model.sky_of(self.numbers(steps)), self.sky
        scans = zip(sky.suns, sky.sun_distances, sky.directions, strict=True)
        return np.stack([band_mean(make(sun, float(distance)), views) for sun, distance, views in scans])

    def loss(self, steps: np.ndarray) -> float:
        """The mean measure over the scans."""
        return float(relative_rms(self.light(steps), self.sky.band(), self.sky.valid).mean())

    def residuals(self, steps: np.ndarray) -> np.ndarray:
        """Differences whose squares add up, in each scan, to the square of its measure; flat."""
        measured, use = self.sky.band(), self.sky.valid
        count = np.maximum(use.sum(axis=1), 1)
        mean = np.where(use, measured, 0).sum(axis=1) / count
        scaled = np.where(use, self.light(steps) - measured, 0) / (mean * np.sqrt(count))[:, None]
        return np.asarray(scaled).ravel()


def places(count: int, size: int) -> np.ndarray:
    """Points (count, size) spread evenly over the unit cube (Roberts 2018: an additive recurrence).

    >>> places(3, 1).round(2).ravel().tolist()
    [0.12, 0.74, 0.35]
    """
    root = 2.0
    for _ in range(30):
        root = (1 + root) ** (1 / (size + 1))
    return np.asarray((0.5 + np.arange(1, count + 1)[:, None] * root ** -np.arange(1.0, size + 1)) % 1)


def fitted(model: EvaluatedModel, sky: MeasuredSky, start: dict[str, float] | None = None) -> dict[str, Any]:
    """The numbers of a model, within its limits, that make the mean measure least over all scans of a sky.

    Least squares, on a few scans, from the usual numbers (or `start`) and from the best of some places spread over the
    limits; the best of these once more by the measure itself, on all. A number that ends at a limit is told by a
    warning.
    """
    from scipy.optimize import least_squares, minimize

    if not model.limits:
        return {}
    problem, few = FitProblem(model, sky), FitProblem(model, sky.some(slice(None, None, -(-len(sky) // FEW_SCANS))))
    usual = problem.steps(model.numbers | (start or {}))
    spread = sorted(places(TRIED, usual.size), key=few.loss)[:KEPT]
    found = [
        least_squares(
            problem.residuals, np.clip(x, 0.01, 0.99), bounds=(0, 1), diff_step=1e-3, xtol=1e-5, max_nfev=25
        ).x
        for x in (usual, *spread)
    ]
    best = min(found, key=problem.loss)
    simplex = np.clip(np.vstack([best, best + 0.02 * np.where(best < 0.5, 1, -1) * np.eye(best.size)]), 0, 1)
    options = {"xatol": 2e-4, "fatol": 2e-5, "maxfev": 40 * best.size, "initial_simplex": simplex}
    last = minimize(problem.loss, best, method="Nelder-Mead", bounds=[(0, 1)] * best.size, options=options)
    if stuck := at_limits(problem, last.x):
        warnings.warn(f"the fit of {model.name} ended at a limit: {', '.join(stuck)}", stacklevel=2)
    return problem.numbers(last.x)


def at_limits(problem: FitProblem, steps: np.ndarray) -> list[str]:
    """The numbers that stand at one of their limits, with it, in words."""
    numbers = problem.numbers(steps)
    return [
        f"{name} {numbers[name]:.4g}"
        for name, step in zip(problem.names, steps, strict=True)
        if not NEAR < step < 1 - NEAR
    ]
