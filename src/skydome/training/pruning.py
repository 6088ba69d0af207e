"""Neurons added and taken away again, the network trained in between: a way out of poor minima.

A minimum for 12 neurons is seldom one for 14. Grown by the two that help most (as in cascade correlation, Fahlman and
Lebiere 1990), trained, and cut back by those that are missed least (the optimal brain surgeon, Hassibi and Stork 1993,
for whole neurons), a network comes back to its size lower than it left, nearly every time.
"""

from dataclasses import dataclass

import numpy as np

from skydome.skies.neural.network import Output
from skydome.training.halving import Halving, Pool
from skydome.training.levenberg_marquardt import (
    Examples,
    Layers,
    cost_of,
    flat,
    forward,
    minimised,
    normal_equations,
    shaped,
)
from skydome.training.losses import Loss
from skydome.training.method import Task

CANDIDATES = 30
"""Random neurons of which the one that helps most is added."""
TIMID = 0.5
"""Share of its best strength with which a new neuron begins."""


@dataclass(frozen=True)
class GrowAndPrune(Halving):
    """Successive halving whose rounds are (how many are kept, cycles of each) of growing and pruning.

    A cycle adds `more` neurons to the one hidden layer, takes `grown` steps, and `between` after each that is taken
    away, `after` the last one. It is kept if the cost has fallen.
    """

    more: int = 2
    grown: int = 15
    between: int = 10
    after: int = 20
    name = "Levenberg-Marquardt, grown and pruned"

    def chosen(self, task: Task) -> tuple[int, Pool]:
        """The stage reached and the pool, as of halving; TypeError for more than one hidden layer."""
        if len(task.recipe.hidden) != 1:
            raise TypeError(f"growing and pruning needs one hidden layer, got {len(task.recipe.hidden)}")
        return super().chosen(task)

    def further(self, task: Task, pool: Pool, number: int, steps: int) -> Pool:
        """Each of the pool some cycles on."""
        recipe, few, results = task.recipe, task.some(task.recipe.start_samples), []
        report = task.reporter(f"round {number} of {len(recipe.rounds)}")
        for place, (cost, layers) in enumerate(pool):
            for cycle in range(steps):
                rng = np.random.default_rng((task.seed, 4, number, place, cycle))
                trial, trial_cost = self.cycle(task, few, layers, rng)
                if trial_cost < cost:
                    layers, cost = trial, trial_cost
                if report is not None:
                    report(cost)
            results.append((cost, layers))
        return results

    def cycle(self, task: Task, few: Examples, layers: Layers, rng: np.random.Generator) -> tuple[Layers, float]:
        """Grown, trained, pruned to its size; the layers and their mean squared residual."""
        output, loss, width = task.recipe.output, task.recipe.loss, len(layers[0][1])
        for _ in range(self.more):
            layers = grown(layers, few, output, loss, task.random_neurons(CANDIDATES, rng))
        layers, cost = minimised(layers, few, output, loss, self.grown)
        while len(layers[0][1]) > width:
            layers = pruned(layers, few, output, loss)
            steps = self.between if len(layers[0][1]) > width else self.after
            layers, cost = minimised(layers, few, output, loss, steps, damping=1e-3)
        return layers, cost


def grown(
    layers: Layers, samples: Examples, output: Output, loss: Loss, candidates: tuple[np.ndarray, np.ndarray]
) -> Layers:
    """The layers with that one of the candidates (weights (n, q), biases (n,)) that lowers the linearised cost most."""
    (weights, biases), (last, last_biases) = layers
    residual, slope = loss.residual(output, forward(layers, samples.inputs)[2], samples.light)
    some, some_biases = candidates
    signal = 1 / (1 + (samples.inputs @ some.T + some_biases) ** 2)
    middle = signal.mean(axis=0)
    signal -= middle
    along, across = (residual * slope).T @ signal, (slope**2).T @ signal**2
    chosen = int((along**2 / across).sum(axis=0).argmax())
    strength = -TIMID * along[:, chosen] / across[:, chosen]
    first = (np.vstack([weights, some[chosen]]), np.append(biases, some_biases[chosen]))
    return [first, (np.column_stack([last, strength]), last_biases - strength * middle[chosen])]


def pruned(layers: Layers, samples: Examples, output: Output, loss: Loss) -> Layers:
    """The layers without the neuron that is missed least, the others changed to make up for it.

    For each neuron its last weights are made 0 with the least rise of the quadratic model (Hassibi and Stork, eq. 5,
    for several weights at once); the true cost decides which, and whether the change helps.
    """
    square, _, _ = normal_equations(layers, samples, output, loss)
    ridge = 1e-4 * np.diag(square) + 1e-9 * np.trace(square) / len(square)
    inverse, numbers = np.linalg.inv(square + np.diag(ridge)), flat(layers)
    hidden, (outputs, width) = layers[0][0].size + layers[0][1].size, layers[1][0].shape
    trials = []
    for k in range(width):
        own = hidden + width * np.arange(outputs) + k
        change = inverse[:, own] @ np.linalg.solve(inverse[np.ix_(own, own)], numbers[own])
        for candidate in (shaped(numbers - change, layers), layers):
            trial = without(candidate, k)
            trials.append((cost_of(trial, samples, output, loss), trial))
    return min(trials, key=lambda entry: entry[0])[1]


def without(layers: Layers, k: int) -> Layers:
    """The layers without the k-th hidden neuron."""
    (weights, biases), (last, last_biases) = layers
    return [(np.delete(weights, k, axis=0), np.delete(biases, k)), (np.delete(last, k, axis=1), last_biases)]
