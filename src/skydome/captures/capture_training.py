"""A neural sky for one day: the published network trained on captures turned to a common azimuth."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from skydome.captures.captures import Capture
from skydome.captures.interpolation import Committee, Fade, known_between
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

UNUSED = ("sqrt_turbidity", "turbidity", "log_turbidity", "albedo")


def scan_of(capture: Capture, count: int = SAMPLES, seed: int = 0) -> Scan:
    """Directions of the capture's sky drawn evenly in solid angle, a quarter more about the sun, with their light.

    The sun's own texels count with the level of the ring about them, so that the network stays calm there.
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
    chosen = np.concatenate([drawn(sky, sizes, count, rng), drawn(about, sizes, count // 4, rng)])
    directions = toward.reshape(-1, 3)[chosen]
    light = picture.pixels.reshape(-1, 3)[chosen].astype(np.float64) * picture.white_luminance
    return Scan(directions, np.broadcast_to(capture.sun, directions.shape), light, 0.0)


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
    return train_day([scan_of(capture, seed=seed + k) for k, capture in enumerate(captures)], recipe, seed, progress)


def day_sky(network: Network, sun: np.ndarray) -> NeuralSky:
    """The day's sky for any sun of it."""
    return NeuralSky(sun, network)


@dataclass(frozen=True)
class CaptureErrors:
    """Errors at one held-out scan: RMSE of y = 1 / (1 + 2 L) with mean L 1, and RMSE of radiance over its mean."""

    target: float
    relative: float


def errors_of(got: np.ndarray, wanted: np.ndarray, scale: float) -> CaptureErrors:
    """Errors of light (D, 3)."""
    y = 1 / (1 + 2 * got / scale) - 1 / (1 + 2 * wanted / scale)
    relative = np.sqrt(np.mean((got - wanted) ** 2)) / wanted.mean()
    return CaptureErrors(float(np.sqrt(np.mean(y**2))), float(relative))


def leave_one_out(
    scans: Sequence[Scan], fades: Sequence[Fade], recipe: TrainingRecipe = DAY_RECIPE, seed: int = 0
) -> dict[str, list[CaptureErrors]]:
    """Errors at each scan of the network trained without it ("network") and of each way between its neighbours.

    Ways that use a network have the mean of a committee, trained likewise. The first and last scans have a
    neighbour on one side alone: that is extrapolation.
    """
    scale = float(np.concatenate([scan.light for scan in scans]).mean())
    results: dict[str, list[CaptureErrors]] = {name: [] for name in ["network", *(fade.name for fade in fades)]}
    for k, held in enumerate(scans):
        others = [scan for i, scan in enumerate(scans) if i != k]
        network, committee = train_day(others, recipe, seed), train_committee(others, seed=seed)
        suns = np.broadcast_to(held.suns, held.directions.shape)
        alone = network.light(network_inputs(network.features, held.directions, suns))
        results["network"].append(errors_of(alone, held.light, scale))
        for fade in fades:
            known = known_between(others, held.time)
            light = fade.with_network(committee).light(known, held.directions, suns)
            results[fade.name].append(errors_of(light, held.light, scale))
    return results
