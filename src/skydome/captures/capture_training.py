"""A neural sky for one day: the published network trained on captures turned to a common azimuth."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from skydome.captures.capture import Capture, seconds_of
from skydome.captures.interpolation import Committee
from skydome.captures.scans import Scan
from skydome.captures.sun_finding import sun_pixels
from skydome.ground.directions import angle_between
from skydome.skies.neural.network import ExponentialOutput, Network, conditions, features
from skydome.skies.neural.sky import NeuralSky
from skydome.training.halving import Halving
from skydome.training.levenberg_marquardt import Examples
from skydome.training.losses import MixedLoss
from skydome.training.method import Progress, Task, TrainingRecipe
from skydome.training.train import train_on

DAY_RECIPE = TrainingRecipe(starts=40, start_steps=10, rounds=((40, 25), (16, 35)), steps=0, method=Halving())
"""The published network: many starts, none trained for long (a day's dozen suns are soon learned by heart)."""

COMMITTEE_RECIPE = TrainingRecipe(starts=20, start_steps=10, rounds=((20, 25),), steps=0, method=Halving())
"""Networks of the published form, trained still more briefly, whose mean is steadier than any of them."""

MAP_RECIPE = TrainingRecipe(
    output=ExponentialOutput(), loss=MixedLoss(0.05), starts=6, start_steps=10, rounds=(), steps=40, method=Halving()
)
"""For maps from dawn to dusk: as large, but even-handed between bright and dark skies, and never 0."""

SAMPLES = 160
"""Directions taken from each map, even in solid angle."""

ABOUT_SUN = np.radians(15.0)

DAY_RECIPES = {"published": DAY_RECIPE, "maps": MAP_RECIPE}
"""By the names that commands know: the paper's own output and loss (eq. 7 and 9), and what suits whole maps."""

UNUSED = ("sqrt_turbidity", "turbidity", "log_turbidity", "albedo")


def scan_of(capture: Capture, count: int = SAMPLES, seed: int = 0, time: float = 0.0, about_sun: float = 0.25) -> Scan:
    """Directions of the capture's sky drawn evenly in solid angle, and more, `about_sun` of them, about the sun.

    The sun's own texels count with the level of the ring about them, so that the network stays calm there. `time` is
    the scan's, s.
    """
    rng = np.random.default_rng(seed)
    picture = capture.calm
    toward = picture.projection.directions(picture.height)
    sizes = np.broadcast_to(picture.projection.solid_angles(picture.height), toward.shape[:2]).reshape(-1)
    lit = (picture.pixels.min(axis=-1) > 0).reshape(-1)
    angle = angle_between(toward, capture.sun).reshape(-1)
    sky = capture.sky.reshape(-1) & lit
    about = lit & (angle < ABOUT_SUN) & (sky | sun_pixels(capture.picture, capture.sun).reshape(-1))
    if not sky.any():
        raise ValueError(f"{capture.name}: no texel of the map is sky; check the mask and the horizon")
    chosen = np.concatenate([drawn(sky, sizes, count, rng), drawn(about, sizes, int(count * about_sun), rng)])
    directions = toward.reshape(-1, 3)[chosen]
    light = picture.pixels.reshape(-1, 3)[chosen].astype(np.float64) * picture.white_luminance
    return Scan(directions, np.broadcast_to(capture.sun, directions.shape), light, time)


def drawn(allowed: np.ndarray, sizes: np.ndarray, count: int, rng: np.random.Generator) -> np.ndarray:
    """Up to `count` places of the allowed texels, by solid angle."""
    places = np.flatnonzero(allowed)
    if not places.size:
        return places
    chance = sizes[places]
    return rng.choice(places, min(count, places.size), replace=False, p=chance / chance.sum())


def network_inputs(names: tuple[str, ...], directions: np.ndarray, suns: np.ndarray) -> np.ndarray:
    """Inputs (D, n) with the azimuth of each sun at pi; what a capture does not tell (turbidity, albedo) is 0."""
    values = conditions(directions, suns, np.ones(1), np.ones(1))
    inputs = np.array(np.broadcast_to(features(names, values), (len(directions), len(names))))
    inputs[:, [name in UNUSED for name in names]] = 0.0
    return inputs


def train_day(
    scans: Sequence[Scan], recipe: TrainingRecipe = DAY_RECIPE, seed: int = 0, progress: Progress | None = None
) -> Network:
    """The network of a day from scans of it; radiance is scaled to mean 1 over them.

    Weights of inputs that captures do not tell are 0, so that a `NeuralSky` of the network heeds no turbidity.
    """
    samples, scale = day_samples(scans, recipe)
    return unused_silenced(train_on(samples, recipe, scale, seed, (), progress))


def train_committee(scans: Sequence[Scan], recipe: TrainingRecipe = COMMITTEE_RECIPE, seed: int = 0) -> Committee:
    """Every network that the recipe's starts give, for the mean of them all; the recipe's method must be halving."""
    samples, scale = day_samples(scans, recipe)
    if not isinstance(recipe.method, Halving):
        raise TypeError(f"a committee is trained by halving, got {recipe.method.name}")
    _, pool = recipe.method.chosen(Task(samples, recipe, seed))
    networks = [unused_silenced(Network(recipe.inputs, tuple(layers), recipe.output, scale)) for _, layers in pool]
    nearest = min(float(angle_between(scan.directions, scan.suns).min()) for scan in scans)
    return Committee(tuple(networks), 2 * np.sin(nearest / 2))


def day_samples(scans: Sequence[Scan], recipe: TrainingRecipe) -> tuple[Examples, float]:
    """Samples of all scans, light over its mean, and that mean; ValueError for suns that do not move."""
    if len({tuple(scan.sun.round(6)) for scan in scans}) < 2:
        raise ValueError(f"a day needs captures of at least two suns, got {len(scans)} of one")
    light = np.concatenate([scan.light for scan in scans])
    inputs = np.concatenate([network_inputs(recipe.inputs, scan.directions, scan.suns) for scan in scans])
    scale = float(light.mean())
    return Examples(inputs, light / scale), scale


def unused_silenced(network: Network) -> Network:
    """The network with weight 0 on the inputs that captures do not tell."""
    weights, biases = network.layers[0]
    weights = np.where([name in UNUSED for name in network.features], np.zeros(1, weights.dtype), weights)
    return replace(network, layers=((weights, biases), *network.layers[1:]))


def train_captures(
    captures: Sequence[Capture], recipe: TrainingRecipe = MAP_RECIPE, seed: int = 0, progress: Progress | None = None
) -> Network:
    """The network of a day from captured maps."""
    return train_day(scans_of(captures, seed=seed), recipe, seed, progress)


def scans_of(captures: Sequence[Capture], count: int = SAMPLES, seed: int = 0, about_sun: float = 0.25) -> list[Scan]:
    """A scan of each capture (`scan_of`), at its time, s after the first."""
    times = seconds_of(captures)
    return [scan_of(capture, count, seed + k, times[k], about_sun) for k, capture in enumerate(captures)]


def day_recipe(name: str) -> TrainingRecipe:
    """The recipe for a day by name; ValueError with the names there are."""
    if name not in DAY_RECIPES:
        raise ValueError(f"recipe for captures must be one of {', '.join(DAY_RECIPES)}, got {name!r}")
    return DAY_RECIPES[name]


def day_sky(network: Network, sun: np.ndarray) -> NeuralSky:
    """The day's sky for any sun of it."""
    return NeuralSky(sun, network)
