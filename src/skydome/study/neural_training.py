"""Training of neural skies: as published, and by Levenberg-Marquardt from many starts (the default)."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from skydome.skies.network import PUBLISHED, ExponentialOutput, Network, Output, RationalOutput
from skydome.study.levenberg_marquardt import (
    Layers,
    Samples,
    forward,
    minimised,
    random_layers,
    solved_last_layer,
)
from skydome.study.network_losses import Loss, MixedLoss, SumLoss, TargetLoss
from skydome.study.neural_data import Lesson, Teacher, published_lesson, rich_lesson

COMPACT = ("sqrt_turbidity", "sqrt_sun_elevation", "inverse_up", "distance", "sqrt_distance", "sqrt_up")
"""Six inputs that follow the sky's own symmetry and steep places better than the paper's six."""

Progress = Callable[[str, float], None]


@dataclass(frozen=True)
class Recipe:
    """What is trained and how: inputs, hidden widths, output, loss, starts, steps, precision, and the lesson."""

    inputs: tuple[str, ...] = PUBLISHED
    hidden: tuple[int, ...] = (12,)
    output: Output = field(default_factory=RationalOutput)
    loss: Loss = field(default_factory=TargetLoss)
    starts: int = 6
    start_steps: int = 60
    steps: int = 150
    start_samples: int = 3000
    dtype: Any = np.float32
    rich: bool = False


PUBLISHED_RECIPE = Recipe()
COMPACT_RECIPE = Recipe(COMPACT, (24,), ExponentialOutput(), MixedLoss(), dtype=np.float16, rich=True)
DEEP_RECIPE = Recipe(COMPACT, (16, 16), ExponentialOutput(), MixedLoss(), starts=5, rich=True)
RECIPES = {"published": PUBLISHED_RECIPE, "compact": COMPACT_RECIPE, "deep": DEEP_RECIPE}


def lesson_for(recipe: Recipe, teacher: Teacher, seed: int) -> Lesson:
    """The recipe's training data."""
    return rich_lesson(teacher, seed) if recipe.rich else published_lesson(teacher, seed)


def subset(samples: Samples, count: int, rng: np.random.Generator) -> Samples:
    """A random part of the samples."""
    if count >= len(samples.inputs):
        return samples
    chosen = rng.choice(len(samples.inputs), count, replace=False)
    return Samples(samples.inputs[chosen], samples.light[chosen])


def train(
    teacher: Teacher, recipe: Recipe = PUBLISHED_RECIPE, seed: int = 0, progress: Progress | None = None
) -> Network:
    """A network that has learned the teacher's sky: the best of several starts, then refined on all samples.

    Each start has its last layer solved linearly, spends a third of its steps on the sums (a nearly linear problem),
    the rest on the recipe's loss. Radiance is scaled to mean 1 over the training set. `progress` is told the stage and
    the root of the mean squared residual after each step.
    """
    study = lesson_for(recipe, teacher, seed)
    scale = float(study.light.mean())
    return train_on(study.samples(recipe.inputs, scale), recipe, scale, seed, teacher.bands, progress)


def train_on(
    samples: Samples,
    recipe: Recipe,
    scale: float,
    seed: int = 0,
    bands: tuple[float, ...] = (),
    progress: Progress | None = None,
) -> Network:
    """A network from samples (light over `scale`), by the recipe's starts and steps."""
    rng = np.random.default_rng(seed)
    few = subset(samples, recipe.start_samples, rng)
    widths = [len(recipe.inputs), *recipe.hidden, samples.light.shape[1]]
    centre, spread = samples.inputs.mean(axis=0), samples.inputs.std(axis=0) + 1e-9
    best: tuple[float, Layers] | None = None
    for k in range(recipe.starts):
        layers = unstandardised(random_layers(widths, rng), centre, spread)
        layers, cost = begun(layers, few, recipe, reporter(progress, f"start {k + 1} of {recipe.starts}"))
        if best is None or cost < best[0]:
            best = (cost, layers)
    assert best is not None
    layers, _ = minimised(best[1], samples, recipe.output, recipe.loss, recipe.steps, reporter(progress, "refining"))
    return finished(layers, samples, recipe, scale, bands)


def begun(
    layers: Layers, samples: Samples, recipe: Recipe, report: Callable[[float], None] | None
) -> tuple[Layers, float]:
    """One start: last layer solved, then the sums, then the loss."""
    layers = solved_last_layer(layers, samples, recipe.output)
    layers, _ = minimised(layers, samples, recipe.output, SumLoss(), recipe.start_steps // 3, report)
    return minimised(layers, samples, recipe.output, recipe.loss, recipe.start_steps, report)


def finished(layers: Layers, samples: Samples, recipe: Recipe, scale: float, bands: tuple[float, ...]) -> Network:
    """The network in its stored precision; the last layer is fitted again after the others were rounded."""
    rounded = [(weights.astype(recipe.dtype).astype(float), biases.astype(recipe.dtype).astype(float))
               for weights, biases in layers[:-1]]  # fmt: skip
    layers = [*rounded, refitted_last(rounded, layers[-1], samples, recipe)]
    network = Network(recipe.inputs, tuple(layers), recipe.output, scale, bands)
    return network.stored_as(recipe.dtype)


def refitted_last(
    hidden: Layers, last: tuple[np.ndarray, np.ndarray], samples: Samples, recipe: Recipe
) -> tuple[np.ndarray, np.ndarray]:
    """The last layer after a few steps of its own, the hidden ones being fixed."""
    signals, _, _ = forward([*hidden, last], samples.inputs)
    fixed = Samples(signals[-1], samples.light)
    layers, _ = minimised([last], fixed, recipe.output, recipe.loss, 5)
    return layers[0]


def unstandardised(layers: Layers, centre: np.ndarray, spread: np.ndarray) -> Layers:
    """Layers made for inputs of mean 0 and deviation 1, rewritten for the inputs as they are."""
    weights, biases = layers[0]
    return [(weights / spread, biases - weights @ (centre / spread)), *layers[1:]]


def reporter(progress: Progress | None, stage: str) -> Callable[[float], None] | None:
    """A listener for one stage."""
    return None if progress is None else lambda cost: progress(stage, float(np.sqrt(cost)))
