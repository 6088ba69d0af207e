"""The fine structure of glare: the needles of the ciliary corona, and the colours of the lenticular halo.

Simpson 1953, "Ocular halos and coronas", describes what is seen; Spencer et al. 1995 draw it as random radial lines.
Here every ring keeps its light: needles only move it along the ring.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np

from skydome.eye.point_spread import lenticular_halo, ring_weights, rings
from skydome.ground.limits.ranges import SEED, SHARE, Bounded, Range
from skydome.ground.units import deg
from skydome.light.colour import D65, SRGB, RGBSpace, rgb_from_xyz, xyz_of_white
from skydome.light.daylight import daylight_spectrum
from skydome.light.spectrum import xyz_weights

REFERENCE = 568.0
CHANNEL_WAVELENGTHS = (610.0, 550.0, 465.0)
"""Wavelengths, nm, at which the needles' length is taken for red, green and blue: diffraction grows with wavelength."""

TURNS, RINGS = 4096, 256
NEAR, FAR = 0.05 * deg, 60 * deg


@dataclass(frozen=True)
class Needles(Bounded):
    """`count` radial needles of random direction, brightness and reach (seeded) as a factor on a spread.

    As many as the ring at 5 degrees has room for: 2 pi 5 degrees over a pupil's diffraction, 0.55 um / 2.2 mm. Each is
    `width` radians across (angle about the source) and is washed out by the source's `radius`. The factor's
    mean along every ring is 1. `contrast` 0..1 tells how much of the light near the source is in needles; it falls off
    with the angle as exp(-(angle / extent)^2).
    """

    count: int = 2000
    seed: int = 0
    width: float = 0.3 * deg
    radius: float = 0.0
    contrast: float = 0.65
    extent: float = 12 * deg
    bounds: ClassVar = {
        "count": Range(1, 100_000),
        "seed": SEED,
        "width": Range(1e-6, 1.0, "rad"),
        "radius": Range(0.0, 1.0, "rad"),
        "contrast": SHARE,
        "extent": Range(1e-6, 10.0, "rad"),
    }

    def __post_init__(self) -> None:
        self.require_bounds()

    @property
    def angles(self) -> np.ndarray:
        """Angles from the source at which the pattern is tabulated, (RINGS,)."""
        return np.geomspace(NEAR, FAR, RINGS)

    @cached_property
    def table(self) -> np.ndarray:
        """The pattern (RINGS, TURNS) float32: a ring a row, its mean 1."""
        random = np.random.default_rng(self.seed)
        where = random.integers(0, TURNS, self.count)
        brightness = random.exponential(size=self.count)
        reach = 6 * deg * random.lognormal(sigma=0.7, size=self.count)
        angle = self.angles
        rows = np.zeros((RINGS, TURNS))
        strength = brightness * np.exp(-angle[:, None] / reach)
        for k in range(self.count):
            rows[:, where[k]] += strength[:, k]
        across = np.hypot(self.width, self.radius / 2 / np.sin(angle))  # a disc's width is blurred as by R / 2
        order = np.arange(TURNS // 2 + 1)
        rows = np.fft.irfft(np.fft.rfft(rows) * np.exp(-((order * across[:, None]) ** 2) / 2), n=TURNS)
        rows /= rows.mean(axis=1, keepdims=True)
        share = self.contrast * np.exp(-((angle / self.extent) ** 2))[:, None]
        return np.maximum(1 + share * (rows - 1), 0.0).astype(np.float32)

    def factor(self, angle: np.ndarray, turn: np.ndarray) -> np.ndarray:
        """Factor (..., 3) for red, green, blue at each angle from the source and turn about it, radians; float32."""
        step = np.float32(np.log(FAR / NEAR) / (RINGS - 1))
        column = (turn * np.float32(TURNS / (2 * np.pi))).astype(np.int32) % TURNS
        ring = np.rint(np.log(np.maximum(angle, np.float32(NEAR)) / np.float32(NEAR)) / step).astype(np.int32)
        result = np.empty((*np.shape(angle), 3), dtype=np.float32)
        for channel, wavelength in enumerate(CHANNEL_WAVELENGTHS):
            shift = round(float(np.log(REFERENCE / wavelength) / step))
            result[..., channel] = self.table[np.clip(ring + shift, 0, RINGS - 1), column]
        return result


def halo_colours(angle: np.ndarray, space: RGBSpace = SRGB) -> np.ndarray:
    """Spencer's lenticular halo of white daylight, as linear RGB per steradian, (N, 3): each channel integrates to 1.

    Each wavelength has its own ring; daylight of 6500 K is spread over them. Colours beyond the space are negative.
    """
    wavelengths = np.arange(400.0, 701.0, 5.0)
    light = daylight_spectrum(xyz_of_white(D65), wavelengths)[:, None] * xyz_weights(wavelengths)

    def ring(at: np.ndarray) -> np.ndarray:
        return np.asarray(rgb_from_xyz(lenticular_halo(at[:, None], wavelengths) @ light, space))

    knots = rings()
    coloured: np.ndarray = ring(angle) / (ring_weights(knots) @ ring(knots))
    return coloured
