"""Training of neural skies: a teacher and a recipe give a network."""

import numpy as np

from skydome.skies.neural.network import Network
from skydome.training.journal import Journal
from skydome.training.lessons import Teacher, published_lesson
from skydome.training.levenberg_marquardt import Examples, Layers, forward, minimised
from skydome.training.method import Progress, Task, TrainingRecipe
from skydome.training.recipes import (
    COMPACT,
    COMPACT_RECIPE,
    DEEP_RECIPE,
    PUBLISHED_RECIPE,
    RECIPES,
    SPECTRAL_RECIPE,
)

__all__ = [
    "COMPACT",
    "COMPACT_RECIPE",
    "DEEP_RECIPE",
    "PUBLISHED_RECIPE",
    "RECIPES",
    "SPECTRAL_RECIPE",
    "Examples",
    "TrainingRecipe",
    "train",
    "train_on",
]  # fmt: skip


def train(
    teacher: Teacher,
    recipe: TrainingRecipe = PUBLISHED_RECIPE,
    seed: int = 0,
    progress: Progress | None = None,
    journal: Journal | None = None,
) -> Network:
    """A network that has learned the teacher's sky. Radiance is scaled to mean 1 over the paper's training set.

    `progress` is told the stage and the root of the mean squared residual after each step; `journal` keeps what is
    done, and goes on from there: the result is the same as without the interruption.
    """
    if len(teacher.bands or "rgb") != recipe.outputs:
        raise ValueError(
            f"this recipe gives {recipe.outputs} outputs, {teacher.name} has {len(teacher.bands or 'rgb')}"
        )
    study = recipe.lesson(teacher, seed)
    scale = float(published_lesson(teacher, 0).light.mean())
    return train_on(study.samples(recipe.inputs, scale), recipe, scale, seed, teacher.bands, progress, journal)


def train_on(
    samples: Examples,
    recipe: TrainingRecipe,
    scale: float,
    seed: int = 0,
    bands: tuple[float, ...] = (),
    progress: Progress | None = None,
    journal: Journal | None = None,
) -> Network:
    """A network from samples (light over `scale`), by the recipe."""
    layers = recipe.method.learned(Task(samples, recipe, seed, progress, journal))
    return finished(layers, samples, recipe, scale, bands)


def finished(
    layers: Layers, samples: Examples, recipe: TrainingRecipe, scale: float, bands: tuple[float, ...]
) -> Network:
    """The network in its stored precision; the last layer is fitted again after the others were rounded."""
    rounded = [(weights.astype(recipe.dtype).astype(float), biases.astype(recipe.dtype).astype(float))
               for weights, biases in layers[:-1]]  # fmt: skip
    layers = [*rounded, refitted_last(rounded, layers[-1], samples, recipe)]
    network = Network(recipe.inputs, tuple(layers), recipe.output, scale, bands)
    return network.stored_as(recipe.dtype)


def refitted_last(
    hidden: Layers, last: tuple[np.ndarray, np.ndarray], samples: Examples, recipe: TrainingRecipe
) -> tuple[np.ndarray, np.ndarray]:
    """The last layer after a few steps of its own, the hidden ones being fixed."""
    signals, _, _ = forward([*hidden, last], samples.inputs)
    layers, _ = minimised([last], Examples(signals[-1], samples.light), recipe.output, recipe.loss, 5, damping=1e-6)
    return layers[0]
