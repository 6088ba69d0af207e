"""Recipes by name: sizes from 492 bytes to 20 kB."""

import numpy as np

from skydome.skies.neural.network import ExponentialOutput
from skydome.training.backpropagation import Backpropagation
from skydome.training.halving import Halving
from skydome.training.lessons import even_sequence, published_lesson, rich_lesson, spectral_lesson
from skydome.training.losses import MixedLoss, SumLoss
from skydome.training.method import TrainingRecipe
from skydome.training.pruning import GrowAndPrune
from skydome.training.variable_projection import VariableProjection

COMPACT = ("sqrt_turbidity", "sqrt_sun_elevation", "inverse_up", "distance", "sqrt_distance", "sqrt_up")
"""Six inputs that follow the sky's own symmetry and steep places better than the paper's six."""

SPECTRAL = (
    "turbidity", "log_turbidity", "albedo", "cbrt_sun_elevation", "sqrt_up", "log_up", "inverse_up", "distance",
    "log_distance", "cos_angle",
)  # fmt: skip


BACKPROPAGATION_RECIPE = TrainingRecipe(lesson=published_lesson, method=Backpropagation())
AS_PUBLISHED_DATA = TrainingRecipe(lesson=published_lesson, method=Halving())
PUBLISHED_RECIPE = TrainingRecipe(
    starts=24, start_steps=25, rounds=((8, 4), (3, 6), (1, 14)), steps=100, start_samples=2048, most_samples=16_384,
    lesson=even_sequence, method=GrowAndPrune(), sequence=True, mirrored=("view_y",), bias_spread=2.0,
)  # fmt: skip
COMPACT_RECIPE = TrainingRecipe(
    COMPACT, (24,), ExponentialOutput(), MixedLoss(0.25), starts=16, rounds=((6, 30), (2, 80)), steps=250,
    most_samples=24_000, dtype=np.float16, lesson=rich_lesson, method=Halving(),
)  # fmt: skip
DEEP_RECIPE = TrainingRecipe(
    COMPACT, (16, 16), ExponentialOutput(), MixedLoss(), starts=12, rounds=((5, 30), (2, 60)), steps=200,
    start_samples=3000, most_samples=24_000, lesson=rich_lesson, method=Halving(),
)  # fmt: skip
SPECTRAL_RECIPE = TrainingRecipe(
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


def recipe_named(name: str) -> TrainingRecipe:
    """The recipe by name; ValueError with the names there are."""
    if name not in RECIPES:
        raise ValueError(f"recipe must be one of {', '.join(RECIPES)}, got {name!r}")
    return RECIPES[name]
