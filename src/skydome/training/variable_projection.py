"""Gauss-Newton for sums that should equal given ones, with the last layer eliminated: wide spectral networks.

The loss is linear in the last layer, which is solved for whatever the hidden layers are (Golub and Pereyra 1973, in
Kaufman's 1975 form). Bands are turned to their principal components first: the few with large weights make the matrix,
the gradient is exact. Single precision, matrix on a changing part of the samples, gradient and cost on all of them.
"""

from dataclasses import dataclass

import numpy as np

from skydome.ground.gauss_newton import Damping
from skydome.training.levenberg_marquardt import (
    Layers,
    flat,
    forward,
    hidden_numbers,
    shaped,
    turned_single,
    weighted_jacobian,
)
from skydome.training.losses import SumLoss, wanted_sums
from skydome.training.method import Method, Task

CHUNK = 4096
DAMPING = Damping(fall=3.0, least=1e-7)


@dataclass(frozen=True)
class VariableProjection(Method):
    """Training of `SumLoss` by Gauss-Newton on the hidden layers. `matrix_samples`: those that make the matrix."""

    matrix_samples: int = 6000
    components: int = 5
    name = "variable projection"

    def learned(self, task: Task) -> Layers:
        """Layers after the recipe's steps; TypeError for another loss."""
        recipe = task.recipe
        if not isinstance(recipe.loss, SumLoss):
            raise TypeError(f"variable projection trains the loss of sums only, got {type(recipe.loss).__name__}")
        many = task.some(recipe.most_samples)
        wanted, report = wanted_sums(recipe.output, many.light), task.reporter("steps")
        step, damping, layers = begun(task)
        layers, cost = projected(layers, many.inputs, wanted)
        for k in range(step, recipe.steps):
            chosen = np.random.default_rng((task.seed, 3, k)).choice(len(wanted), min(self.matrix_samples, len(wanted)))
            square = self.matrix(layers, many.inputs[chosen]) * (len(wanted) / len(chosen))
            layers, new_cost, damping = stepped(layers, many.inputs, wanted, square, cost, damping)
            if report is not None:
                report(new_cost / wanted.size)
            if task.journal is not None and k % 5 == 4:
                task.journal.write(step=np.array(k + 1), damping=np.array(damping), numbers=flat(layers))
            if damping > 1e8:
                break
            cost = new_cost
        return layers

    def matrix(self, layers: Layers, inputs: np.ndarray) -> np.ndarray:
        """J^T J of the hidden numbers, the part that the last layer can follow taken away (Kaufman's form)."""
        weights, size = layers[-1][0], hidden_numbers(layers)
        _, strength, turned = np.linalg.svd(weights, full_matrices=False)
        rows = (strength[:, None] * turned)[: self.components]
        layers = [*layers[:-1], (rows, np.zeros(len(rows)))]
        signals, sums, _ = single_forward(layers, inputs)
        design = with_one(signals[-1])
        signals, sums = turned_single(signals), turned_single(sums)
        root = np.linalg.cholesky(ridged(design.T @ design)).astype(np.float32)
        square = np.zeros((size, size))
        for k in range(len(rows)):
            jacobian = weighted_jacobian(layers, signals, sums, k, np.ones(len(inputs), np.float32))[:size]
            followed = np.linalg.solve(root, (jacobian @ design).T)
            square += jacobian @ jacobian.T - followed.T @ followed
        return square


def begun(task: Task) -> tuple[int, float, Layers]:
    """Steps done, damping and layers: from the journal, or a random start."""
    state = None if task.journal is None else task.journal.read()
    layers = task.random_start(0)
    if state is None:
        return 0, 1e-1, layers
    return int(state["step"]), float(state["damping"]), shaped(state["numbers"], layers)


def stepped(
    layers: Layers, inputs: np.ndarray, wanted: np.ndarray, square: np.ndarray, cost: float, damping: float
) -> tuple[Layers, float, float]:
    """Layers after one damped step, their cost and the next damping; the old ones where no step helps."""
    slope, size = gradient(layers, inputs, wanted), hidden_numbers(layers)
    numbers, diagonal = flat(layers), np.abs(np.diag(square))

    def tried(step: np.ndarray) -> tuple[Layers, float]:
        trial = numbers.copy()
        trial[:size] -= step
        return projected(shaped(trial, layers), inputs, wanted)

    step = DAMPING.step(square, slope, diagonal + 1e-6 * diagonal.mean(), damping, cost, tried)
    return (layers, cost, step.damping * 16) if step.state is None else (step.state, step.cost, step.damping)


def gradient(layers: Layers, inputs: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """J^T r of the hidden numbers; the last layer being solved, its own part is 0."""
    total = [[np.zeros(weights.shape), np.zeros(biases.shape)] for weights, biases in layers[:-1]]
    for start in range(0, len(inputs), CHUNK):
        signals, sums, z = single_forward(layers, inputs[start : start + CHUNK])
        back = (z - wanted[start : start + CHUNK]).astype(np.float32) @ layers[-1][0].astype(np.float32)
        for depth in range(len(layers) - 2, -1, -1):
            back = back * (-2 * sums[depth] * signals[depth + 1] ** 2)
            total[depth][0] += back.T @ signals[depth]
            total[depth][1] += back.sum(axis=0)
            back = back @ layers[depth][0].astype(np.float32)
    return np.concatenate([part.ravel() for pair in total for part in pair])


def projected(layers: Layers, inputs: np.ndarray, wanted: np.ndarray) -> tuple[Layers, float]:
    """The layers with the last one solved for all samples, and the sum of squared residuals."""
    width, energy = layers[-1][0].shape[1] + 1, float((wanted**2).sum())
    square, right = np.zeros((width, width)), np.zeros((width, wanted.shape[1]))
    for start in range(0, len(inputs), CHUNK):
        signals, _, _ = single_forward(layers, inputs[start : start + CHUNK])
        design = with_one(signals[-1]).astype(np.float64)
        square, right = square + design.T @ design, right + design.T @ wanted[start : start + CHUNK]
    solution = np.linalg.solve(ridged(square), right)
    cost = energy - 2 * float((solution * right).sum()) + float((solution * (square @ solution)).sum())
    return [*layers[:-1], (solution[:-1].T.copy(), solution[-1].copy())], cost


def single_forward(layers: Layers, inputs: np.ndarray) -> tuple[list[np.ndarray], list[np.ndarray], np.ndarray]:
    """`levenberg_marquardt.forward` in single precision."""
    single = [(weights.astype(np.float32), biases.astype(np.float32)) for weights, biases in layers]
    return forward(single, inputs.astype(np.float32))


def with_one(signal: np.ndarray) -> np.ndarray:
    """The signal and a column of ones."""
    return np.concatenate([signal, np.ones((len(signal), 1), signal.dtype)], axis=1)


def ridged(square: np.ndarray) -> np.ndarray:
    """The matrix with a trace of its mean diagonal, so that it can be solved."""
    result: np.ndarray = square + 1e-7 * np.trace(square) / len(square) * np.eye(len(square))
    return result
