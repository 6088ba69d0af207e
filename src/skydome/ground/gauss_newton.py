"""A damped Gauss-Newton step (Levenberg 1944, Marquardt 1963): for networks and for families of curves."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, TypeVar

import numpy as np

State = TypeVar("State")


@dataclass(frozen=True)
class Step(Generic[State]):
    """What a step led to, None where none helped: its state, cost, and the damping to begin the next one with."""

    state: State | None
    cost: float
    damping: float


@dataclass(frozen=True)
class Damping:
    """How damping changes: it rises by a factor until a step lowers the cost, falls by another then, not below `least`.

    A step is given up after `tries`, or where damping reaches `most`.
    """

    rise: float = 4.0
    fall: float = 5.0
    least: float = 0.0
    tries: int = 8
    most: float = np.inf

    def step(
        self,
        square: np.ndarray,
        slope: np.ndarray,
        diagonal: np.ndarray,
        damping: float,
        cost: float,
        tried: Callable[[np.ndarray], tuple[State, float]],
    ) -> Step[State]:
        """The first step -(J^T J + damping diag(diagonal))^-1 J^T r that brings a cost below `cost`.

        `square` J^T J (n, n), `slope` J^T r and `diagonal` (n,). `tried(x)` is the state, and its cost, x (n,) down
        from the present one.

        >>> tried = lambda x: (3 - x, float((3 - x).sum()) ** 2)
        >>> step = Damping().step(np.eye(1), np.array([3.0]), np.ones(1), 0.0, 9.0, tried)
        >>> step.state.tolist(), step.cost
        ([0.0], 0.0)
        """
        for _ in range(self.tries):
            if damping >= self.most:
                break
            state, new = tried(np.linalg.solve(square + damping * np.diag(diagonal), slope))
            if new < cost:
                return Step(state, new, max(damping / self.fall, self.least))
            damping *= self.rise
        return Step(None, cost, damping)
