"""Recipes: which network is trained, on what and how; sizes from 492 bytes to 20 kB."""

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np

from skydome.skies.neural.network import PUBLISHED, ExponentialOutput, Output, RationalOutput
from skydome.training.backpropagation import Backpropagation
from skydome.training.halving import Halving
from skydome.training.lessons import (
    Lesson,
    Teacher,
    dense_lesson,
    even_sequence,
    published_lesson,
    rich_lesson,
    spectral_lesson,
)
from skydome.training.losses import Loss, MixedLoss, SumLoss, TargetLoss
from skydome.training.method import Method
from skydome.training.pruning import GrowAndPrune
from skydome.training.variable_projection import VariableProjection

COMPACT = ("sqrt_turbidity", "sqrt_sun_elevation", "inverse_up", "distance", "sqrt_distance", "sqrt_up")
"""Six inputs that follow the sky's own symmetry and steep places better than the paper's six."""

SPECTRAL = (
    "turbidity", "log_turbidity", "albedo", "cbrt_sun_elevation", "sqrt_up", "log_up", "inverse_up", "distance",
    "log_distance", "cos_angle",
)  # fmt: skip


@dataclass(frozen=True)
class Recipe:
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
    method: Method = field(default_factory=Halving)
    sequence: bool = False
    mirrored: tuple[str, ...] = ()
    bias_spread: float = 1.0

    @property
    def bytes(self) -> int:
        """Bytes of the network's numbers."""
        widths = [len(self.inputs), *self.hidden, self.outputs]
        count: int = sum((before + 1) * after for before, after in pairwise(widths))
        return count * int(np.dtype(self.dtype).itemsize)


BACKPROPAGATION_RECIPE = Recipe(lesson=published_lesson, method=Backpropagation())
AS_PUBLISHED_DATA = Recipe(lesson=published_lesson)
PUBLISHED_RECIPE = Recipe(
    starts=24, start_steps=25, rounds=((8, 4), (3, 6), (1, 14)), steps=100, start_samples=2048, most_samples=16_384,
    lesson=even_sequence, method=GrowAndPrune(), sequence=True, mirrored=("view_y",), bias_spread=2.0,
)  # fmt: skip
COMPACT_RECIPE = Recipe(
    COMPACT, (24,), ExponentialOutput(), MixedLoss(0.25), starts=16, rounds=((6, 30), (2, 80)), steps=250,
    most_samples=24_000, dtype=np.float16, lesson=rich_lesson,
)  # fmt: skip
DEEP_RECIPE = Recipe(
    COMPACT, (16, 16), ExponentialOutput(), MixedLoss(), starts=12, rounds=((5, 30), (2, 60)), steps=200,
    start_samples=3000, most_samples=24_000, lesson=rich_lesson,
)  # fmt: skip
SPECTRAL_RECIPE = Recipe(
    SPECTRAL, (32, 32), ExponentialOutput(), SumLoss(), starts=1, steps=120, most_samples=60_000,
    lesson=spectral_lesson, outputs=11, method=VariableProjection(),
)  # fmt: skip
RECIPES = {
    "published": PUBLISHED_RECIPE,
    "published-data": AS_PUBLISHED_DATA,
    "backpropagation": BACKPROPAGATION_RECIPE,
    "compact": COMPACT_RECIPE,
    "deep": DEEP_RECIPE,
    "spectral": SPECTRAL_RECIPE,
}


def recipe_named(name: str) -> Recipe:
    """The recipe by name; ValueError with the names there are."""
    if name not in RECIPES:
        raise ValueError(f"recipe must be one of {', '.join(RECIPES)}, got {name!r}")
    return RECIPES[name]
