"""Back-propagation as published: one sample at a time, momentum 0.9, learning rate 0.01 (section IV)."""

from dataclasses import dataclass

import numpy as np

from skydome.ground.extras import required
from skydome.skies.neural.network import RationalOutput
from skydome.training.levenberg_marquardt import Layers
from skydome.training.losses import TargetLoss
from skydome.training.method import Method, Task


@dataclass(frozen=True)
class Backpropagation(Method):
    """The paper's training, of one hidden layer with rational output. `epochs` passes over all samples."""

    epochs: int = 400
    rate: float = 0.01
    momentum: float = 0.9
    name = "back-propagation"

    def learned(self, task: Task) -> Layers:
        """Layers after all epochs; TypeError for recipes that the paper does not have, ImportError without Numba."""
        recipe = task.recipe
        if len(recipe.hidden) != 1 or not isinstance(recipe.output, RationalOutput):
            raise TypeError("back-propagation trains one hidden layer with rational output and the target loss only")
        if not isinstance(recipe.loss, TargetLoss):
            raise TypeError(f"back-propagation trains the target loss only, got {type(recipe.loss).__name__}")
        required("numba", "fast", "back-propagation")
        from skydome.training.backpropagation_kernel import epoch

        epochs, layers, moments = begun(task)
        inputs = np.ascontiguousarray(task.samples.inputs)
        wanted, report = 1 / (1 + 2 * task.samples.light), task.reporter("epochs")
        for k in range(epochs, self.epochs):
            order = np.random.default_rng((task.seed, 2, k)).permutation(len(inputs))
            cost = epoch(inputs, wanted, order, *layers, *moments, self.rate, self.momentum)
            if report is not None:
                report(cost / wanted.size)
            if task.journal is not None and k % 10 == 9:
                numbers = {f"number{i}": value for i, value in enumerate((*layers, *moments))}
                task.journal.write(epochs=np.array(k + 1), **numbers)
        return [(layers[0], layers[1]), (layers[2], layers[3])]


def begun(task: Task) -> tuple[int, list[np.ndarray], list[np.ndarray]]:
    """Epochs done, the numbers and their moments: from the journal, or a random start."""
    state = None if task.journal is None else task.journal.read()
    if state is not None:
        numbers = [state[f"number{i}"] for i in range(8)]
        return int(state["epochs"]), numbers[:4], numbers[4:]
    layers = [np.ascontiguousarray(part) for layer in task.random_start(0) for part in layer]
    return 0, layers, [np.zeros_like(part) for part in layers]
