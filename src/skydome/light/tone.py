"""From scene to screen: exposure, and curves that bring any brightness into 0..1 without turning a hue."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.limits.ranges import Bounded, Range

MIDDLE_GREY = 0.18
DUSK, KEY_FALLS = 0.1, 0.25
"""Usual luminance, cd m-2, below which a picture is darker than middle grey, and by which power of it.

So that nights look like nights: a moonless one of .0003 cd m-2 two stops darker, one of a full moon one. Keys that fall
with adaptation are Krawczyk et al. 2005's idea (theirs falls by 2.6 stops, most of it in dusk); this law is by eye.
"""
EXPOSURE = Range(1e-15, 1e9, "per cd m-2")
"""From beyond all light, 50 EV, to far below the darkest night, -30 EV."""
BLEACH = 4.0  # peak value at which a colour has lost a quarter of its saturation


class Curve(ABC):
    """A rising curve from scene values (0 and more; middle grey .18) to display-linear values in 0..1."""

    @abstractmethod
    def __call__(self, x: Any) -> np.ndarray:
        """Display-linear value of each scene value, same shape."""


@dataclass(frozen=True)
class Reinhard(Bounded, Curve):
    """x (1 + x / white^2) / (1 + x), held at 1 from `white` on (Reinhard et al. 2002, eq. 4).

    >>> Reinhard(white=4.0)(np.array([0.0, 1.0, 4.0, 1e9])).tolist()
    [0.0, 0.53125, 1.0, 1.0]
    """

    white: float = 8.0
    bounds: ClassVar = {"white": Range(1e-3, 1e12)}

    def __post_init__(self) -> None:
        """Validate only."""
        self.require_bounds()

    def __call__(self, x: Any) -> np.ndarray:
        """Display-linear value of each scene value, same shape."""
        x = np.minimum(x, self.white)
        held: np.ndarray = x * (1 + x / self.white**2) / (1 + x)
        return held


@dataclass(frozen=True)
class Filmic(Curve):
    """Narkowicz's fit of the ACES film curve, with toe and shoulder (2015, "ACES Filmic Tone Mapping Curve").

    >>> Filmic()(np.array([0.0, 0.18, 1e9])).round(3).tolist()
    [0.0, 0.267, 1.0]
    """

    def __call__(self, x: Any) -> np.ndarray:
        """Display-linear value of each scene value, same shape."""
        x = np.minimum(x, 1e6)
        held: np.ndarray = np.minimum(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1.0)
        return held


def tone_mapped(rgb: np.ndarray, curve: Curve) -> np.ndarray:
    """Display-linear RGB (..., 3) in 0..1 of exposed scene RGB (..., 3).

    The curve is applied to the largest channel and the others keep their ratio to it, so that no channel is cut off
    and the hue stays; the brightest colours then fade to white, along the line to white, as film bleaches the sun.
    """
    rgb = np.maximum(rgb, 0.0)
    peak = rgb.max(axis=-1, keepdims=True)
    mapped = curve(peak)
    coloured = rgb * (mapped / np.where(peak > 0, peak, 1.0))
    fade = (peak / (peak + BLEACH)) ** 2
    shown: np.ndarray = coloured + fade * (mapped - coloured)
    return shown


def key(luminance: float) -> float:
    """What a usual luminance, cd m-2, is brought to in a picture: middle grey, and less below `DUSK`.

    >>> [round(key(light), 3) for light in (5000.0, 0.1, 0.1 / 256)]
    [0.18, 0.18, 0.045]
    """
    return float(MIDDLE_GREY * min(1.0, (luminance / DUSK) ** KEY_FALLS))


def auto_exposure(luminance: np.ndarray, solid_angles: ArrayLike = 1.0) -> float:
    """Factor that brings the scene's usual luminance, its logarithmic mean, to its `key` (Reinhard 2002, eq. 1).

    `luminance` (H, W), cd m-2, counts by `solid_angles` (broadcast). Left out: what is black or below a thousandth of
    the brightest tenth (black ground), and the brightest hundredth of the solid angle (the sun). 1 where all is black.

    >>> round(auto_exposure(np.array([[0.0, 2000.0, 2000.0, 1.6e9]]), [1.0, 1.0, 1.0, 1e-5]) * 2000, 9)
    0.18
    """
    weights = np.broadcast_to(np.asarray(solid_angles, dtype=np.float64), luminance.shape)
    stride = thinning(luminance.size)
    values, weights = luminance[::stride, ::stride].ravel(), weights[::stride, ::stride].ravel()
    lit = np.isfinite(values) & (values > 0) & (weights > 0)
    if not lit.any():
        return 1.0
    order = np.argsort(values[lit])
    values, weights = values[lit][order].astype(np.float64), weights[lit][order]
    usual = values >= at_share(values, weights, 0.9) / 1000
    values, weights = values[usual], weights[usual]
    usual = values <= at_share(values, weights, 0.99)
    mean = float(np.exp(np.average(np.log(values[usual]), weights=weights[usual])))
    return key(mean) / mean


def thinning(size: int) -> int:
    """Of so many values every how many-th row and column is enough for an exposure."""
    return max(1, int((size / 200_000) ** 0.5))


def at_share(values: np.ndarray, weights: np.ndarray, share: float) -> float:
    """The value below which that share of the weight lies; values (n,) ascending."""
    total = np.cumsum(weights)
    return float(values[np.searchsorted(total, share * total[-1])])
