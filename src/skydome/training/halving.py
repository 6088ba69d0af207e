"""Many random starts by Levenberg-Marquardt, the better part kept in each round: the default training.

Most starts end in poor minima, and show it soon: successive halving (Karnin, Koren and Somekh 2013; Jamieson and
Talwalkar 2016) spends little on those. Each start has its last layer solved linearly and takes a few steps on the sums.
"""

from dataclasses import dataclass

import numpy as np

from skydome.training.levenberg_marquardt import Layers, flat, minimised, shaped, solved_last_layer
from skydome.training.losses import SumLoss
from skydome.training.method import Method, Task

BLOCK = 50
"""Steps between two entries in the journal."""

Pool = list[tuple[float, Layers]]


@dataclass(frozen=True)
class Halving(Method):
    """Levenberg-Marquardt from many starts with successive halving, by the numbers of the recipe."""

    name = "Levenberg-Marquardt"

    def learned(self, task: Task) -> Layers:
        """Layers of the best start, refined."""
        stage, pool = self.chosen(task)
        return refined(task, best(pool, 1), stage - len(task.recipe.rounds) - 1)

    def chosen(self, task: Task) -> tuple[int, Pool]:
        """The stage reached, and those left after the last round, with their mean squared residuals."""
        stage, pool = resumed(task)
        recipe = task.recipe
        if stage == 0:
            for k in range(len(pool), recipe.starts):
                pool.append(begun(task, k))
                note(task, 0, pool)
            stage = 1
        for number, (keep, steps) in enumerate(recipe.rounds, start=1):
            if stage <= number:
                pool = self.further(task, best(pool, keep), number, steps)
                stage = number + 1
                note(task, stage, pool)
        return stage, pool

    def further(self, task: Task, pool: Pool, number: int, steps: int) -> Pool:
        """Each of the pool some steps on."""
        recipe, few, results = task.recipe, task.some(task.recipe.start_samples), []
        report = task.reporter(f"round {number} of {len(recipe.rounds)}")
        for _, layers in pool:
            layers, cost = minimised(layers, few, recipe.output, recipe.loss, steps, report, 1e-4)
            results.append((cost, layers))
        return results


def begun(task: Task, number: int) -> tuple[float, Layers]:
    """One start: last layer solved, a few steps on the sums, then on the loss."""
    recipe, few = task.recipe, task.some(task.recipe.start_samples)
    report = task.reporter(f"start {number + 1} of {recipe.starts}")
    layers = solved_last_layer(task.random_start(number), few, recipe.output)
    layers, _ = minimised(layers, few, recipe.output, SumLoss(), max(recipe.start_steps * 3 // 4, 1))
    layers, cost = minimised(layers, few, recipe.output, recipe.loss, recipe.start_steps, report)
    return cost, layers


def refined(task: Task, pool: Pool, block: int) -> Layers:
    """The best one after the recipe's last steps on most samples, in blocks, from block number `block` on."""
    recipe, many = task.recipe, task.some(task.recipe.most_samples)
    (cost, layers), blocks = pool[0], -(-recipe.steps // BLOCK)
    for k in range(max(block, 0), blocks):
        before = cost
        report = task.reporter("refining")
        layers, cost = minimised(layers, many, recipe.output, recipe.loss, BLOCK, report, 1e-4)
        note(task, len(recipe.rounds) + 2 + k, [(cost, layers)])
        if k > 0 and before - cost < 1e-4 * cost:
            break
    return layers


def best(pool: Pool, count: int) -> Pool:
    """The best of the pool."""
    return sorted(pool, key=lambda entry: entry[0])[:count]


def note(task: Task, stage: int, pool: Pool) -> None:
    """Write the stage and the pool into the journal."""
    if task.journal is not None:
        costs, numbers = np.array([cost for cost, _ in pool]), np.stack([flat(layers) for _, layers in pool])
        task.journal.write(stage=np.array(stage), costs=costs, numbers=numbers)


def resumed(task: Task) -> tuple[int, Pool]:
    """The stage and the pool from the journal, or the beginning."""
    state = None if task.journal is None else task.journal.read()
    if state is None:
        return 0, []
    like = task.random_start(0)
    pool = [
        (float(cost), shaped(numbers, like)) for cost, numbers in zip(state["costs"], state["numbers"], strict=True)
    ]
    return int(state["stage"]), pool
