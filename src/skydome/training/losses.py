"""What a network's training makes small: residuals of its sums z against light, with their slopes."""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from skydome.skies.neural.network import ExponentialOutput, Output


def slope(output: Output, z: np.ndarray) -> np.ndarray:
    """Derivative of the light with respect to z, same shape."""
    return output.light(z) if isinstance(output, ExponentialOutput) else z


class Loss(ABC):
    """A residual for each sum z and light L (both (N, outputs)), and its derivative with respect to z."""

    @abstractmethod
    def residual(self, output: Output, z: np.ndarray, light: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Residual and slope, each (N, outputs)."""


class SumLoss(Loss):
    """z against the sum that would give the light: linear in the last layer, so a good beginning."""

    def residual(self, output: Output, z: np.ndarray, light: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Z - sqrt(2 L), or z - ln L for exponential output."""
        return z - wanted_sums(output, light), np.ones_like(z)


class TargetLoss(Loss):
    """The paper's: y = 1 / (1 + 2 L) against that of the light (eq. 7 and 9)."""

    def residual(self, output: Output, z: np.ndarray, light: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Difference of the scaled targets."""
        y = 1 / (1 + 2 * output.light(z))
        return y - 1 / (1 + 2 * light), -2 * slope(output, z) * y * y


@dataclass(frozen=True)
class MixedLoss(Loss):
    """Relative error whose denominator keeps a share of the mean light (which is 1): even-handed, never explosive."""

    share: float = 0.2

    def residual(self, output: Output, z: np.ndarray, light: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(L(z) - L) / (L + share)."""
        weight = 1 / (light + self.share)
        return (output.light(z) - light) * weight, slope(output, z) * weight


def wanted_sums(output: Output, light: np.ndarray) -> np.ndarray:
    """The z that would give the light."""
    if isinstance(output, ExponentialOutput):
        logarithm: np.ndarray = np.log(np.maximum(light, 1e-6))
        return logarithm
    root: np.ndarray = np.sqrt(2 * np.maximum(light, 0.0))
    return root
