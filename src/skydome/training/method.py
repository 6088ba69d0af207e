"""What a recipe, a task and a way of training are: from samples and a recipe to layers."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np

from skydome.skies.neural.network import PUBLISHED, Output, RationalOutput
from skydome.training.journal import Journal
from skydome.training.lessons import Lesson, Teacher, dense_lesson
from skydome.training.levenberg_marquardt import Examples, Layers, random_layers
from skydome.training.losses import Loss, TargetLoss

Progress = Callable[[str, float], None]
"""Told the stage, and the root of the mean squared residual after each step."""


@dataclass(frozen=True)
class TrainingRecipe:
    """What is trained and how.

    `starts` random networks take `start_steps` steps each on `start_samples` samples; each round (count, steps) keeps
    the best and goes on with them; the last one left takes `steps` steps on `most_samples`. `lesson` draws the data,
    `dtype` is how the numbers are stored, `outputs` 3 for linear sRGB, or how many bands. `sequence`: the lesson's
    first samples are as evenly spread as all. `mirrored`: inputs that change sign where the sky does not; their
    weights start at 0. `bias_spread`: standard deviation of the first layer's biases at the start.
    """

    inputs: tuple[str, ...] = PUBLISHED
    hidden: tuple[int, ...] = (12,)
    output: Output = field(default_factory=RationalOutput)
    loss: Loss = field(default_factory=TargetLoss)
    starts: int = 56
    start_steps: int = 12
    rounds: tuple[tuple[int, int], ...] = ((16, 30), (6, 60))
    steps: int = 150
    start_samples: int = 2500
    most_samples: int = 10_000
    dtype: Any = np.float32
    lesson: Callable[[Teacher, int], Lesson] = dense_lesson
    outputs: int = 3
    method: "Method" = field(kw_only=True)
    sequence: bool = False
    mirrored: tuple[str, ...] = ()
    bias_spread: float = 1.0

    @property
    def bytes(self) -> int:
        """Bytes of the network's numbers."""
        widths = [len(self.inputs), *self.hidden, self.outputs]
        count: int = sum((before + 1) * after for before, after in pairwise(widths))
        return count * int(np.dtype(self.dtype).itemsize)


@dataclass(frozen=True)
class Task:
    """A training to be done: the samples, the recipe, the seed, who is told and where it is written down."""

    samples: Examples
    recipe: TrainingRecipe
    seed: int = 0
    progress: Progress | None = None
    journal: Journal | None = None

    @property
    def widths(self) -> list[int]:
        """Values in each layer, inputs first."""
        return [self.samples.inputs.shape[1], *self.recipe.hidden, self.samples.light.shape[1]]

    def some(self, count: int) -> Examples:
        """At most `count` of the samples, the same ones each time."""
        if count >= len(self.samples.inputs):
            return self.samples
        if self.recipe.sequence:
            return Examples(self.samples.inputs[:count], self.samples.light[:count])
        chosen = np.random.default_rng((self.seed, count)).choice(len(self.samples.inputs), count, replace=False)
        return Examples(self.samples.inputs[chosen], self.samples.light[chosen])

    def random_start(self, number: int) -> Layers:
        """Random layers for the inputs as they are; the sums' spread is itself drawn between 0.3 and 1.5."""
        rng = np.random.default_rng((self.seed, 1_000_000, number))
        layers = random_layers(self.widths, rng, rng.uniform(0.3, 1.5))
        weights, biases = layers[0]
        return [self.adapted(weights, self.recipe.bias_spread * biases), *layers[1:]]

    def random_neurons(self, count: int, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        """Weights (count, inputs) and biases (count,) of neurons such as random starts have."""
        weights, biases = random_layers([self.widths[0], count], rng, rng.uniform(0.3, 1.5))[0]
        return self.adapted(weights, self.recipe.bias_spread * biases)

    def adapted(self, weights: np.ndarray, biases: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Weights and biases for standardised inputs made those for the inputs as they are; mirrored ones are 0."""
        weights[:, [name in self.recipe.mirrored for name in self.recipe.inputs]] = 0.0
        centre, spread = self.samples.inputs.mean(axis=0), self.samples.inputs.std(axis=0) + 1e-9
        return weights / spread, biases - weights @ (centre / spread)

    def reporter(self, stage: str) -> Callable[[float], None] | None:
        """A listener for one stage."""
        progress = self.progress
        return None if progress is None else lambda cost: progress(stage, float(np.sqrt(cost)))


class Method(ABC):
    """A way of training."""

    name: str

    @abstractmethod
    def learned(self, task: Task) -> Layers:
        """Layers that have learned the samples."""
