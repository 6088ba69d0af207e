"""Where a fit begins: a coarse grid over suns and turbidities, judged by how well the light's shape agrees."""

from itertools import product

import numpy as np

from skydome.fitting.samples import Observations
from skydome.fitting.unknowns import LEVELS, Problem
from skydome.ground.directions import ZENITH, direction

KEPT = 3
"""Starts handed on."""

Start = tuple[np.ndarray, np.ndarray]
"""Numbers (p,) and the sun (3,) about which the first two are steps."""


def starts(problem: Problem, samples: Observations, chosen: np.ndarray) -> list[Start]:
    """The best few starts, best first: the given values, else the grid's."""
    unknowns = dict(zip(problem.numbers, problem.unknowns, strict=True))
    suns = candidate_suns(problem, samples, chosen)
    names = [name for name in problem.numbers if not name.startswith("sun_")]
    tries = []
    for name in names:
        given = problem.start.get(name)
        tries.append([float(given)] if given is not None else [*unknowns[name].tries] or [unknowns[name].start])
    ranked = []
    for sun in suns:
        for numbers in product(*tries):
            values = dict(zip(names, numbers, strict=True))
            cost, factor = shape_cost(problem, samples, chosen, values, sun)
            ranked.append((cost, start(problem, values, factor), sun))
    ranked.sort(key=lambda item: item[0])
    return [(x, sun) for _, x, sun in apart(ranked)]


def apart(ranked: list[tuple[float, np.ndarray, np.ndarray]]) -> list[tuple[float, np.ndarray, np.ndarray]]:
    """The best of the ranked starts, no two with nearly the same sun."""
    kept: list[tuple[float, np.ndarray, np.ndarray]] = []
    for item in ranked:
        if all(item[2] @ other[2] < 0.99 for other in kept):
            kept.append(item)
        if len(kept) == KEPT:
            break
    return kept


def start(problem: Problem, values: dict[str, float], factor: float) -> np.ndarray:
    """The numbers (p,), the first free level that was not given set to what the light asks for."""
    numbers = {"sun_across": 0.0, "sun_up": 0.0} | values
    level = next((name for name in LEVELS if name in values and name not in problem.start), None)
    if level is not None:
        numbers[level] = values[level] * factor
    return np.array([numbers[name] for name in problem.numbers])


def candidate_suns(problem: Problem, samples: Observations, chosen: np.ndarray) -> list[np.ndarray]:
    """Suns to try, each (3,): the given one; else the brightest part's middle and a grid over the upper hemisphere."""
    if "sun" not in problem.free:
        return [np.asarray(problem.fixed.get("sun", ZENITH), dtype=np.float64)]
    if "sun" in problem.start:
        return [problem.start["sun"]]
    light = samples.values[chosen]
    light = light if light.ndim == 1 else light.mean(axis=-1)
    brightest = np.argsort(light)[-max(1, len(light) // 200) :]
    middle = samples.directions[chosen][brightest].mean(axis=0) + 1e-9 * ZENITH
    grid = [
        direction((k + 0.5) * 2 * np.pi / count, elevation)
        for elevation, count in zip(np.radians([2, 8, 16, 28, 42, 57, 73]), [24, 24, 24, 20, 16, 12, 6], strict=True)
        for k in range(count)
    ]
    return [middle / np.linalg.norm(middle), *grid]


def shape_cost(
    problem: Problem, samples: Observations, chosen: np.ndarray, values: dict[str, float], sun: np.ndarray
) -> tuple[float, float]:
    """Mean squared difference of logarithms, and the factor on the light that makes it least.

    Where no level is free the factor is 1: absolute light tells the turbidity.
    """
    known = values | ({"sun": sun} if "sun" in problem.free else {})
    light = samples.light(problem.sky(known, "nan"), samples.directions[chosen])
    observed = samples.values[chosen]
    if light.ndim == 2:
        light, observed = light.mean(axis=-1), observed.mean(axis=-1)
    both = (light > 0) & (observed > 0)
    if not both.any():
        return np.inf, 1.0
    ratio = np.log(observed[both] / light[both])
    free_level = any(name in values and name not in problem.start for name in LEVELS)
    middle = float(np.median(ratio)) if free_level else 0.0
    return float(np.mean((ratio - middle) ** 2)) + 10.0 * float(np.mean(~both)), float(np.exp(middle))
