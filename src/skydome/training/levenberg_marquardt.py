"""Levenberg-Marquardt for small networks of 1 / (1 + x^2) neurons, with an exact Jacobian, in chunks."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from skydome.ground.gauss_newton import Damping
from skydome.skies.neural.network import Output
from skydome.training.losses import Loss, wanted_sums

Layers = list[tuple[np.ndarray, np.ndarray]]
CHUNK = 2048
DAMPING = Damping(least=1e-8)


@dataclass(frozen=True)
class Examples:
    """Training examples: inputs (N, q) and light (N, outputs) of mean 1."""

    inputs: np.ndarray
    light: np.ndarray


def forward(layers: Layers, inputs: np.ndarray) -> tuple[list[np.ndarray], list[np.ndarray], np.ndarray]:
    """Signals that enter each layer, sums of each hidden layer, and the last sums z."""
    signals, sums = [inputs], []
    for weights, biases in layers[:-1]:
        sums.append(signals[-1] @ weights.T + biases)
        signals.append(1 / (1 + sums[-1] ** 2))
    weights, biases = layers[-1]
    return signals, sums, signals[-1] @ weights.T + biases


def weighted_jacobian(
    layers: Layers, signals: list[np.ndarray], sums: list[np.ndarray], k: int, weight: np.ndarray
) -> np.ndarray:
    """Derivatives of the k-th sum z times `weight` (N,), single precision, (hidden numbers + width + 1, N).

    The rows are the numbers of the hidden layers and the k-th row and bias of the last: others do not touch it.
    `signals` and `sums` are those of `forward`, turned (`turned_single`): samples run along the memory.
    """
    width, end = layers[-1][0].shape[1], hidden_numbers(layers)
    jacobian = np.empty((end + width + 1, len(weight)), np.float32)
    np.multiply(signals[-1], weight, out=jacobian[end:-1])
    jacobian[-1] = weight
    back = layers[-1][0][k].astype(np.float32)[:, None] * weight
    for depth in range(len(layers) - 2, -1, -1):
        back = back * (-2 * sums[depth] * signals[depth + 1] ** 2)
        (after, before), count = layers[depth][0].shape, len(weight)
        jacobian[end - after : end] = back
        block = jacobian[end - after * (before + 1) : end - after].reshape(after, before, count)
        np.multiply(back[:, None, :], signals[depth][None, :, :], out=block)
        end -= after * (before + 1)
        if depth:
            back = layers[depth][0].astype(np.float32).T @ back
    return jacobian


def turned_single(values: list[np.ndarray]) -> list[np.ndarray]:
    """Each (N, width) as (width, N) in single precision."""
    return [value.T.astype(np.float32, order="C") for value in values]


def hidden_numbers(layers: Layers) -> int:
    """How many numbers come before the last layer."""
    return sum(weights.size + biases.size for weights, biases in layers[:-1])


def columns_of_output(layers: Layers, k: int) -> np.ndarray:
    """Where the columns of `weighted_jacobian` stand among all numbers."""
    outputs, width = layers[-1][0].shape
    hidden = hidden_numbers(layers)
    own = hidden + k * width + np.arange(width)
    return np.concatenate([np.arange(hidden), own, [hidden + outputs * width + k]])


def normal_equations(
    layers: Layers, samples: Examples, output: Output, loss: Loss
) -> tuple[np.ndarray, np.ndarray, float]:
    """J^T J, J^T r and the sum of squared residuals over all samples; slopes in single precision, twice as fast."""
    size = sum(weights.size + biases.size for weights, biases in layers)
    square, slope, cost = np.zeros((size, size)), np.zeros(size), 0.0
    columns = [columns_of_output(layers, k) for k in range(layers[-1][1].size)]
    for start in range(0, len(samples.inputs), CHUNK):
        part = slice(start, start + CHUNK)
        signals, sums, z = forward(layers, samples.inputs[part])
        residual, change = loss.residual(output, z, samples.light[part])
        cost += float((residual**2).sum())
        signals, sums = turned_single(signals), turned_single(sums)
        change, residual = turned_single([change, residual])
        for k, own in enumerate(columns):
            jacobian = weighted_jacobian(layers, signals, sums, k, change[k])
            square[own[:, None], own] += jacobian @ jacobian.T
            slope[own] += jacobian @ residual[k]
    return square, slope, cost


def cost_of(layers: Layers, samples: Examples, output: Output, loss: Loss) -> float:
    """Sum of squared residuals."""
    return float((loss.residual(output, forward(layers, samples.inputs)[2], samples.light)[0] ** 2).sum())


def flat(layers: Layers) -> np.ndarray:
    """Every number of the layers in the Jacobian's order."""
    return np.concatenate([part.ravel() for layer in layers for part in layer])


def shaped(numbers: np.ndarray, like: Layers) -> Layers:
    """Layers from a flat array."""
    layers, start = [], 0
    for weights, biases in like:
        end = start + weights.size
        layers.append((numbers[start:end].reshape(weights.shape), numbers[end : end + biases.size]))
        start = end + biases.size
    return layers


def solved_last_layer(layers: Layers, samples: Examples, output: Output) -> Layers:
    """The layers with the last one set by linear least squares on the wanted sums."""
    signals, _, _ = forward(layers, samples.inputs)
    design = np.concatenate([signals[-1], np.ones((len(samples.inputs), 1))], axis=1)
    square = design.T @ design + 1e-6 * len(design) * np.eye(design.shape[1])
    solution = np.linalg.solve(square, design.T @ wanted_sums(output, samples.light))
    return [*layers[:-1], (solution[:-1].T.copy(), solution[-1].copy())]


def random_layers(widths: list[int], rng: np.random.Generator, size: float = 1.5) -> Layers:
    """Random layers of the given widths, inputs first, outputs last; sums of hidden layers vary by about `size`."""
    layers = []
    for before, after in pairwise(widths):
        weights = rng.normal(size=(after, before)) * size / np.sqrt(before)
        layers.append((weights, rng.normal(size=after)))
    return layers


def minimised(
    layers: Layers,
    samples: Examples,
    output: Output,
    loss: Loss,
    steps: int,
    progress: Callable[[float], None] | None = None,
    damping: float = 1e-2,
) -> tuple[Layers, float]:
    """Layers after at most `steps` steps of Levenberg-Marquardt, and their mean squared residual.

    Marquardt 1963, damped by the diagonal of J^T J. `progress` is told the mean squared residual after each step.
    """

    def tried(step: np.ndarray) -> tuple[np.ndarray, float]:
        trial = numbers - step
        with np.errstate(over="ignore", invalid="ignore"):
            return trial, cost_of(shaped(trial, layers), samples, output, loss)

    numbers = flat(layers)
    square, slope, cost = normal_equations(layers, samples, output, loss)
    for _ in range(steps):
        diagonal = np.diag(square) + 1e-9 * np.trace(square) / len(square)
        step = DAMPING.step(square, slope, diagonal, damping, cost, tried)
        if step.state is None:
            break
        small = cost - step.cost < 1e-7 * cost
        numbers, damping = step.state, step.damping
        square, slope, cost = normal_equations(shaped(numbers, layers), samples, output, loss)
        if progress is not None:
            progress(cost / samples.light.size)
        if small:
            break
    return shaped(numbers, layers), cost / samples.light.size
