"""A sky model of one's own: the nine numbers as quintic Bezier curves in the cube root of the sun's elevation.

For each wavelength all suns, turbidities and albedos are fitted together. Between turbidities the numbers are mixed,
so they must change smoothly: curves that bend from turbidity to turbidity cost, as a weak spring does. The first guess
goes from turbidity to turbidity, each beginning at its neighbour's answer; all are then moved together
(Levenberg-Marquardt).
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from skydome.ground.arrays import Array
from skydome.ground.gauss_newton import Damping
from skydome.own_air.bezier_fit import AllSuns, State
from skydome.own_air.family import SkyFamily
from skydome.own_air.refit import LIMITS
from skydome.skies.formula.sky_tables import POINTS, SkyTables

SCALE = np.repeat((1.0, 0.3, 3.0, 0.2), POINTS)
LOW, HIGH = (np.repeat(limit, POINTS) + inset for limit, inset in zip(LIMITS, (1e-3, -1e-3), strict=True))
DAMPING = Damping(rise=5.0, tries=100, most=1e6)
SLOPE, BEND = 1e-4, 3e-3
"""Residuals that stand for a change, and for a change of it, of one `SCALE` from turbidity to turbidity."""
FIRST = 1e-2
"""The same for a change from the neighbour that a first guess begins at."""


def bezier_family(family: SkyFamily, progress: Callable[[int, int], None] | None = None) -> SkyTables:
    """The tables fitted to a family of skies; `HosekWilkie(sun, turbidity, albedo, tables=...)` is their sky.

    Errors are relative, weighted by solid angle, alike for all suns. `progress(done, of)` is called after each
    wavelength. ValueError for light that is not positive, and for fewer than six suns.
    """
    if family.elevations.size < POINTS or not (family.radiance > 0).all():
        raise ValueError(f"six suns or more and light over 0 are needed, got {family.elevations.size} suns, "
                         f"least light {family.radiance.min():g}")  # fmt: skip
    control, error = [], []
    for w in range(family.wavelengths.size):
        airs = [AllSuns.of(family, light[..., w]) for light in family.radiance]
        found = together(airs, guessed(airs))
        parts = [air.points(x) for air, x in zip(airs, found, strict=True)]
        control.append([points for points, _ in parts])
        error.append([errors for _, errors in parts])
        if progress is not None:
            progress(w + 1, family.wavelengths.size)
    nodes = family.turbidities, family.albedos, family.wavelengths
    points, errors = np.moveaxis(np.array(control), 0, 3), np.moveaxis(np.array(error), 0, 2)
    return SkyTables(*nodes, points, errors, float(family.elevations.min()))


def guessed(airs: list[AllSuns]) -> Array:
    """A first guess of the control points, (T, 24): from the third turbidity up, then down, each near the last."""
    first = min(2, len(airs) - 1)
    found = {first: together([airs[first]], airs[first].middle()[None])[0]}
    for k in [*range(first + 1, len(airs)), *range(first - 1, -1, -1)]:
        near = found[k - 1 if k > first else k + 1]
        found[k] = together([airs[k]], near[None], FIRST)[0]
    return np.stack([found[k] for k in range(len(airs))])


def together(airs: list[AllSuns], start: np.ndarray, held: float = 0.0, rounds: int = 30) -> Array:
    """Control points (T, 24) that make squared differences and springs least, by Levenberg-Marquardt from a start.

    `held` ties them to the start.
    """

    def tried(step: np.ndarray) -> tuple[tuple[np.ndarray, list[State]], float]:
        points = np.clip(x - step.reshape(x.shape), LOW, HIGH)
        states = [air.solved(row) for air, row in zip(airs, points, strict=True)]
        return (points, states), springs.cost(states, points)

    springs = Springs.of(start, held)
    x, damping = np.clip(start, LOW, HIGH), 1e-4
    now = [air.solved(row) for air, row in zip(airs, x, strict=True)]
    cost = springs.cost(now, x)
    for _ in range(rounds):
        before, (hessian, gradient) = cost, normal_equations(airs, springs, now, x)
        step = DAMPING.step(hessian, gradient, np.tile(SCALE**-2, len(airs)), damping, cost, tried)
        damping, cost = step.damping, step.cost
        if step.state is not None:
            x, now = step.state
        if before - cost < 1e-5 * cost:
            break
    return x


@dataclass(frozen=True, eq=False)
class Springs:
    """Half the springs' energy is x stiff x / 2 - drawn x, for control points x, flat."""

    stiff: np.ndarray
    drawn: np.ndarray

    @classmethod
    def of(cls, start: np.ndarray, held: float) -> "Springs":
        """Between turbidities, of changes and of changes of changes; and to the start (T, 24), as `held` says."""
        slopes = np.diff(np.eye(len(start)), axis=0)
        pull = np.concatenate([SLOPE * slopes, BEND * np.diff(slopes, axis=0), held * np.eye(len(start))])
        return cls(np.kron(pull.T @ pull, np.diag(SCALE**-2)), (held**2 * start / SCALE**2).ravel())

    def cost(self, states: list[State], x: np.ndarray) -> float:
        """Half the squared differences and the springs' energy."""
        flat, own = x.ravel(), sum(float((state[0] ** 2).sum()) for state in states)
        return 0.5 * own + 0.5 * float(flat @ self.stiff @ flat) - float(self.drawn @ flat)


def normal_equations(
    airs: list[AllSuns], springs: Springs, states: list[State], x: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Curvature (T x 24, T x 24) and slope (T x 24,) of the cost."""
    hessian, gradient = springs.stiff.copy(), springs.stiff @ x.ravel() - springs.drawn
    for k, (air, (differences, linear, bases)) in enumerate(zip(airs, states, strict=True)):
        own = slice(k * SCALE.size, (k + 1) * SCALE.size)
        rates = air.jacobian(x[k], linear, bases).reshape(-1, SCALE.size)
        hessian[own, own] += rates.T @ rates
        gradient[own] += rates.T @ differences.ravel()
    return hessian, gradient
