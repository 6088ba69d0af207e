"""How wrong a neural sky is: the paper's measures and honest ones beside them."""

from dataclasses import asdict, dataclass

import numpy as np

from skydome.skies.neural.network import Network, conditions, features
from skydome.training.lessons import Lesson, Teacher, even_lesson, held_out, held_out_by_zenith


@dataclass(frozen=True)
class NetworkErrors:
    """Errors of a network against its teacher, all dimensionless.

    `target`: RMSE of y = 1 / (1 + 2 L), L of mean 1 over the training set. `target_over_range`: the same over y's
    range. `relative`: RMSE of radiance over its mean. `median`: median |L / L_teacher - 1|. `irradiance`: mean relative
    error of the horizontal integral (the paper's eq. 11) over conditions. `per_sky`: the mean over skies (one turbidity
    and sun) of the RMSE of y in each, as the paper averages.
    """

    target: float
    target_over_range: float
    relative: float
    median: float
    irradiance: float
    per_sky: float

    def as_dict(self) -> dict[str, float]:
        """The errors by name."""
        return asdict(self)


def predicted(network: Network, test: Lesson) -> np.ndarray:
    """The network's light for a lesson, (C, D, outputs)."""
    inputs = features(network.features, conditions(test.directions, test.sun, test.turbidity, test.albedo))
    light: np.ndarray = network.light(inputs)
    return light


def errors(network: Network, test: Lesson) -> NetworkErrors:
    """Errors of the network on a lesson whose views are even in solid angle."""
    got, wanted = predicted(network, test) / network.scale, test.light / network.scale
    y_got, y_wanted = 1 / (1 + 2 * got), 1 / (1 + 2 * wanted)
    target = float(np.sqrt(np.mean((y_got - y_wanted) ** 2)))
    cosine = test.directions[..., 2:3]
    irradiance = (got * cosine).mean(axis=1) / (wanted * cosine).mean(axis=1) - 1
    return NetworkErrors(
        target=target,
        target_over_range=target / float(np.ptp(y_wanted)),
        relative=float(np.sqrt(np.mean((got - wanted) ** 2)) / wanted.mean()),
        median=float(np.median(np.abs(got / np.maximum(wanted, 1e-9) - 1))),
        irradiance=float(np.abs(irradiance).mean()),
        per_sky=float(np.sqrt(((y_got - y_wanted) ** 2).mean(axis=(1, 2))).mean()),
    )


def validated(network: Network, teacher: Teacher) -> NetworkErrors:
    """Errors on the paper's held-out conditions, views even in solid angle."""
    return errors(network, held_out(teacher))


def validated_by_zenith(network: Network, teacher: Teacher) -> NetworkErrors:
    """Errors on the paper's held-out conditions and its manner of views: more of them near the zenith.

    The irradiance of these views is not the paper's eq. 11; take `validated` for it.
    """
    return errors(network, held_out_by_zenith(teacher))


def relative_error(network: Network, teacher: Teacher) -> float:
    """Root of the mean squared L / L_teacher - 1 over every turbidity and albedo, suns from 2 to 90 degrees."""
    test = even_lesson(teacher)
    return float(np.sqrt(np.mean((predicted(network, test) / test.light - 1) ** 2)))
