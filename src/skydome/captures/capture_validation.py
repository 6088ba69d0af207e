"""How wrong a day's network is at a capture that it has not seen: k-fold cross validation, by whole captures.

Satilmis et al. 2017, section IV-A: one image is left out, the network is trained on the others, and tested on that one.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from skydome.captures.capture_training import DAY_RECIPE, network_inputs, train_committee, train_day
from skydome.captures.interpolation import Fade, known_between
from skydome.captures.scans import Scan
from skydome.ground.directions import elevation
from skydome.light.colour import SRGB
from skydome.skies.neural.network import Network
from skydome.training.method import TrainingRecipe

Tell = Callable[[int, int], None]
"""Is told the fold, and how many there are."""


@dataclass(frozen=True)
class CaptureErrors:
    """Errors at one held-out scan: RMSE of y = 1 / (1 + 2 L) with mean L 1, and RMSE of radiance over its mean.

    `illuminance` and `learned` are the horizontal integrals (eq. 11) of the scan's light and of the network's, lx.
    """

    target: float
    relative: float
    illuminance: float
    learned: float


@dataclass(frozen=True)
class DayErrors:
    """The errors of each held-out scan in order, and their means."""

    scans: tuple[CaptureErrors, ...]

    @property
    def target(self) -> float:
        """Mean over scans of the RMSE of y (the paper's Table 1)."""
        return float(np.mean([scan.target for scan in self.scans]))

    @property
    def relative(self) -> float:
        """Mean over scans of the RMSE of radiance over its mean."""
        return float(np.mean([scan.relative for scan in self.scans]))

    @property
    def irradiance(self) -> float:
        """Mean relative error of the horizontal integral, which cannot cancel."""
        return float(np.mean([abs(scan.learned / scan.illuminance - 1) for scan in self.scans]))

    @property
    def irradiance_of_means(self) -> float:
        """Difference of the mean integrals over the reference's mean (the paper's Table 2)."""
        learned, wanted = (np.mean([getattr(s, name) for s in self.scans]) for name in ("learned", "illuminance"))
        return float(abs(learned / wanted - 1))


def errors_of(got: np.ndarray, held: Scan, scale: float) -> CaptureErrors:
    """Errors of light (D, 3) against that of a scan."""
    wanted, up = held.light, held.directions[:, 2] * ring_weights(held.directions)
    y = 1 / (1 + 2 * got / scale) - 1 / (1 + 2 * wanted / scale)
    relative = np.sqrt(np.mean((got - wanted) ** 2)) / wanted.mean()
    lux = [float(up @ (light @ SRGB.to_xyz[1])) for light in (wanted, got)]
    return CaptureErrors(float(np.sqrt(np.mean(y**2))), float(relative), *lux)


def ring_weights(directions: np.ndarray) -> np.ndarray:
    """Solid angle that each direction (D, 3) stands for, sr, (D,): bands between rings of equal height, shared evenly.

    The bands end half-way between two rings, the outermost at horizon and zenith: their sum is 2 pi.
    """
    heights, ring, count = np.unique(elevation(directions).round(6), return_inverse=True, return_counts=True)
    edges = np.sin(np.concatenate([[0.0], (heights[1:] + heights[:-1]) / 2, [np.pi / 2]]))
    weights: np.ndarray = (2 * np.pi * np.diff(edges) / count)[ring]
    return weights


def validated_by_folds(
    scans: Sequence[Scan],
    held: Sequence[Scan] | None = None,
    recipe: TrainingRecipe = DAY_RECIPE,
    seed: int = 0,
    folds: int | None = None,
    tell: Tell | None = None,
) -> DayErrors:
    """Errors at each scan of the network that was trained without its fold; a fold is one scan where None is given.

    Folds are every n-th scan. `held` are the same skies with other samples, to be tested on. ValueError for fewer folds
    than 2 or more than scans, and for fewer than three scans.
    """
    held = scans if held is None else held
    count = len(scans) if folds is None else folds
    if len(scans) < 3 or not 2 <= count <= len(scans):
        raise ValueError(
            f"folds must be from 2 to the {len(scans)} captures, of which three are needed at least, got {count}"
        )
    scale = float(np.concatenate([scan.light for scan in scans]).mean())
    errors: dict[int, CaptureErrors] = {}
    for fold in range(count):
        network = train_day([scan for k, scan in enumerate(scans) if k % count != fold], recipe, seed)
        for k in range(fold, len(scans), count):
            errors[k] = errors_of(light_at(network, held[k]), held[k], scale)
        if tell is not None:
            tell(fold + 1, count)
    return DayErrors(tuple(errors[k] for k in range(len(scans))))


def light_at(network: Network, scan: Scan) -> np.ndarray:
    """The network's light (D, 3) toward the directions of a scan."""
    suns = np.broadcast_to(scan.suns, scan.directions.shape)
    light: np.ndarray = network.light(network_inputs(network.features, scan.directions, suns))
    return light


def leave_one_out(
    scans: Sequence[Scan], fades: Sequence[Fade], recipe: TrainingRecipe = DAY_RECIPE, seed: int = 0
) -> dict[str, list[CaptureErrors]]:
    """Errors at each scan of the network trained without it ("network") and of each way between its neighbours.

    Ways that use a network have the mean of a committee, trained likewise. The first and last scans have a
    neighbour on one side alone: that is extrapolation. ValueError for scans whose times do not grow.
    """
    if not all(before.time < after.time for before, after in pairwise(scans)):
        raise ValueError(f"times of scans must grow, got {[scan.time for scan in scans]}")
    scale = float(np.concatenate([scan.light for scan in scans]).mean())
    results: dict[str, list[CaptureErrors]] = {fade.name: [] for fade in fades}
    for k, scan in enumerate(scans):
        others = [other for i, other in enumerate(scans) if i != k]
        committee, known = train_committee(others, seed=seed), known_between(others, scan.time)
        suns = np.broadcast_to(scan.suns, scan.directions.shape)
        for fade in fades:
            light = fade.with_network(committee).light(known, scan.directions, suns)
            results[fade.name].append(errors_of(light, scan, scale))
    return {"network": list(validated_by_folds(scans, recipe=recipe, seed=seed).scans), **results}
