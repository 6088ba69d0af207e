"""What the samples of a fit can tell: flat directions, rival answers, standard errors."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from skydome.fitting.unknowns import Problem, unknown_of

FLAT = 1e-6
"""A direction in the unknowns is not determined if a step of a whole span changes the light by less than this part."""

WIDE = 0.5
"""Nor if its standard error is above this part of its span."""

RIVAL = 9.0
"""Nor if an answer from another start lies that far away, its sum of squares within this many variances of the best."""


def degenerate_names(problem: Problem, jacobian: np.ndarray, sigma: float) -> tuple[str, ...]:
    """The parameters that the samples do not determine, by the singular values of the Jacobian (n, p) per whole span.

    A direction of the unknowns is flat if a whole span along it changes the light by less than FLAT, or if the noise
    `sigma` leaves it open by more than WIDE of its span. Named is what takes part in it by a tenth or more.
    """
    spans = np.array([unknown.span for unknown in problem.unknowns])
    _, strengths, turns = np.linalg.svd(jacobian * spans, full_matrices=False)
    flat = (strengths < FLAT * np.sqrt(len(jacobian))) | (sigma > WIDE * strengths)
    takes_part = (np.abs(turns[flat]) > 0.1).any(axis=0)
    named = ["sun" if n.startswith("sun_") else n for n, part in zip(problem.numbers, takes_part, strict=True) if part]
    return tuple(dict.fromkeys(named))


def rivalled_names(problem: Problem, tried: list[tuple[Any, Any]]) -> tuple[str, ...]:
    """The parameters on which answers from other starts, as good as the best within RIVAL, differ by WIDE of a span."""
    objective, best = min(tried, key=lambda pair: float(pair[1].cost))
    variance = 2 * best.cost / max(1, best.fun.size - best.x.size)
    found = final_values(problem, objective, best)
    named = []
    for other_objective, other in tried:
        if other.cost - best.cost > RIVAL * variance / 2:
            continue
        values = final_values(problem, other_objective, other)
        spans = [1.0 if name == "sun" else unknown_of(problem.model, name).span for name in problem.free]
        apart = [np.linalg.norm(np.subtract(values[name], found[name])) for name in problem.free]
        named += [name for name, far, span in zip(problem.free, apart, spans, strict=True) if far > WIDE * span]
    return tuple(dict.fromkeys(named))


def final_values(problem: Problem, objective: Any, answer: Any) -> dict[str, Any]:
    """Parameters by name of an answer: its sun is the one that the objective has moved to."""
    return problem.values(centred(problem, answer.x), objective.about)


def centred(problem: Problem, x: np.ndarray) -> np.ndarray:
    """The numbers x (p,) with the sun's two steps at 0."""
    return np.concatenate([np.zeros(2), x[2:]]) if "sun" in problem.free else x.copy()


def errors_by_name(problem: Problem, covariance: np.ndarray, degenerate: Sequence[str]) -> dict[str, float]:
    """Standard errors by parameter; of the sun both angles together, radians; infinite where degenerate."""
    variance = dict(zip(problem.numbers, np.diag(covariance), strict=True))
    if "sun" in problem.free:
        variance["sun"] = variance.pop("sun_across") + variance.pop("sun_up")
    return {name: float("inf") if name in degenerate else float(np.sqrt(variance[name])) for name in problem.free}
