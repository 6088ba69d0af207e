"""The light of a map on its way into a file: its colours and its unit there, and what was seen of it on the way."""

import math
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from skydome.ground.exr import HALF_MAXIMUM
from skydome.ground.limits.sizes import row_parts
from skydome.light.colour import RGBSpace
from skydome.light.gamut import count_outside, within_gamut
from skydome.maps.by_rows.map_rows import MapRows, blocks_of

COARSE = 0.01
"""Share of a map's light that the rounding to half floats may move."""
ROUNDING = 1e-6
"""Share of a map's brightest value by which luminance may be below 0."""
TEXELS_IN_WORK = 1 << 18
"""Brought into a file's colours and unit, and compressed, at a time."""
Gamut = Literal["white", "none"]
"""What becomes of colours outside the RGB space: moved toward its white, or written as they are."""
Report = Callable[[float, float], None]
"""Takes how many rows are written, of how many."""


@dataclass
class NegativeLight:
    """Texels whose luminance is below 0, by more than rounding."""

    weights: np.ndarray
    low: float = 0.0
    peak: float = 0.0
    kept: list[np.ndarray] = field(default_factory=list)

    def see(self, pixels: np.ndarray) -> None:
        """Look at some rows."""
        self.peak = max(self.peak, float(pixels.max(initial=0.0)))
        self.low = min(self.low, float(pixels.min(initial=0.0)))
        for part in row_parts(len(pixels)) if self.low < 0 else ():
            if pixels[part].min() < -self.rounding:
                light = pixels[part] @ self.weights
                self.kept.append(light[light < -self.rounding].astype(np.float32))

    @property
    def rounding(self) -> float:
        """What counts as 0."""
        return ROUNDING * max(self.peak, -self.low)

    def tell(self, texels: int, name: str) -> None:
        """A warning where texels turn black in the file `name`; ValueError where nothing else is in the map."""
        below = sum(int((light < -self.rounding).sum()) for light in self.kept)
        kept = '.exr with gamut="none"'
        if below and not self.peak > 0:
            raise ValueError(f"the light of a map must be above 0 somewhere, got none for {name}; {kept} has it")
        if below:
            share = below / texels
            warnings.warn(
                f"{share:.2%} of the texels have light below 0, black in {name}; {kept} keeps it", stacklevel=5
            )


def watched(source: MapRows, name: str) -> Iterator[np.ndarray]:
    """The map's blocks; in the end negative light, which the file `name` cannot show, is told or refused."""
    negative, (rows, columns) = NegativeLight(source.space.to_xyz[1]), source.size
    for block in source.blocks():
        negative.see(block)
        yield block
    negative.tell(rows * columns, name)


@dataclass
class LightInFile:
    """A map's light in a file's RGB space and unit, `white` cd m-2 of RGB (1, 1, 1), as `half` floats or not.

    Once all blocks are taken: `outside`, texels whose colours lie outside that space.
    """

    source: MapRows
    space: RGBSpace
    gamut: Gamut
    white: float
    half: bool = False
    outside: int = 0
    peak: float = 0.0
    total: float = 0.0
    lost: float = 0.0

    @property
    def factor(self) -> float:
        """What the map's numbers are multiplied by."""
        return self.source.white_luminance / self.white

    def coloured(self, pixels: np.ndarray) -> np.ndarray:
        """Some rows in the space of the file, within it where that is asked for."""
        matrix = self.source.matrix_to(self.space)
        shown = pixels if matrix is None else pixels @ matrix
        count = count_outside(shown)
        self.outside += count
        return within_gamut(shown, self.space) if count and self.gamut != "none" else shown

    def scaled(self, pixels: np.ndarray) -> np.ndarray:
        """Some rows in the unit of the file."""
        light: np.ndarray = pixels * pixels.dtype.type(self.factor) if self.factor != 1 else pixels
        self.peak = max(self.peak, largest(light))
        if self.half:
            self.total += float(np.abs(light).sum(dtype=np.float64))
            with np.errstate(over="ignore"):
                self.lost += float(np.abs(light.astype(np.float16) - light.astype(np.float64)).sum())
        return light

    def blocks(self, seen: Iterator[np.ndarray], kind: Any, report: Report) -> Iterator[np.ndarray]:
        """The map's blocks of rows (r, W, 3) as that type of numbers; ValueError for light that no file can have."""
        for part, pixels in zip(self.source.parts(), seen, strict=True):
            for rows in blocks_of(len(pixels), pixels.shape[1], TEXELS_IN_WORK):
                yield self.brought(pixels[rows], kind)
                report(part.start + rows.stop, self.source.height)
        if self.half:
            self.require_half()
        elif self.peak > np.finfo(kind).max:
            raise ValueError(f"pixels must not exceed {np.finfo(kind).max:g} in this file, got {self.peak:g}")

    def brought(self, pixels: np.ndarray, kind: Any) -> np.ndarray:
        """Some rows as the file has them."""
        light = np.empty(pixels.shape, kind)
        for rows in row_parts(len(pixels)):
            with np.errstate(over="ignore"):  # told in the end
                light[rows] = self.scaled(self.coloured(pixels[rows]))
        return light

    def require_half(self) -> None:
        """ValueError where half floats end below the light, or are too coarse for most of it."""
        if self.peak > HALF_MAXIMUM:
            raise ValueError(
                f"half floats end at {HALF_MAXIMUM:g}, got {self.peak:g} at a white luminance of {self.white:g} "
                f"cd m-2; {half_white(self.peak * self.white):g} holds it"
            )
        if self.lost > COARSE * self.total:
            most = self.peak * self.white
            raise ValueError(
                f"half floats are too coarse for light of at most {most:.3g} cd m-2 at a white luminance of "
                f"{self.white:g} cd m-2; {half_white(most):g} suits it"
            )


def largest(light: np.ndarray) -> float:
    """The largest size; ValueError where light is not finite."""
    peak = float(max(np.max(light, initial=0.0), -np.min(light, initial=0.0)))
    if not math.isfinite(peak):
        raise ValueError("pixels must be finite to be written, got NaN or infinity")
    return peak


def half_white(peak: float) -> float:
    """The smallest power of ten, as cd m-2 of RGB (1, 1, 1), at which half floats hold light of `peak` cd m-2.

    >>> half_white(1.6e9), half_white(60000.0)
    (100000.0, 1.0)
    """
    return float(10.0 ** math.ceil(math.log10(peak / HALF_MAXIMUM)))
