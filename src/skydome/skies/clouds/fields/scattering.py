"""How cloud scatters, in channels of light: its law, the law after many small turns, and angles drawn from it.

A forward peak, the share f = g^2 of the law, is taken out of the optical depths (delta-Eddington, Joseph et al. 1976):
the law times exp(-(1 - cos) / s) for the s that makes it so much. What the rest scatters once has been turned by the
peak any number of times: with depths t of sun and eye together and moments p of the peak and r of the rest,

    [exp(-f t (1 - p)) - exp(-f t)] / ((1 - f) t) + r exp(-f t (1 - p))

are the moments of the law that it seems to follow, over the scaled depth. Thin cloud shows the law over 1 - f (the TMS
method of Nakajima and Tanaka 1988) with corona and bows; in thick cloud they are blurred.
"""

from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

import numpy as np

from skydome.air.phase_laws import PhaseLaw
from skydome.air.series.legendre import legendre
from skydome.ground.units import deg

ANGLES, SMOOTH, MOMENTS = 1025, 257, 400
"""Angles of tables; of what is blurred; Legendre moments of that."""
FADING = np.exp(-((np.arange(MOMENTS)[:, None] / 108) ** 2) / 2)
"""Of those moments where a peak of diffraction goes beyond them: blurred light is so by a bell of .53 degrees more."""
DEPTHS, FIRST, STEP = 12, 0.2, 0.337
"""Scaled depths of tables: FIRST (exp(k STEP) - 1), 0 to 8."""
SHARES = 8193
"""Of the law's integral at which scattering angles are kept."""
EVENED = (6 * deg, 30 * deg)
"""Within which the law is evened where paths that were scattered before look for the sun, and later on."""


@cache
def grid(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Scattering angles (count,) at pi t^2 for even t, and what each counts over the sphere, sr."""
    angle = np.pi * np.linspace(0, 1, count) ** 2
    step = np.pi * -np.diff(np.cos(angle))
    return angle, np.append(step, 0.0) + np.append(0.0, step)


@cache
def polynomials(count: int) -> np.ndarray:
    """Legendre polynomials at the grid's angles, (MOMENTS, count)."""
    return np.asarray(legendre(MOMENTS, np.cos(grid(count)[0])))


@dataclass(frozen=True, eq=False)
class Scattering:
    """A law (ANGLES, C) in sr-1 whose `peak` share is taken out."""

    law: np.ndarray
    peak: float
    peaked: bool = False
    """Whether the law has a peak of diffraction, as `CloudParticles.peaked`: moments fade, lest it leave rings."""

    @classmethod
    def of(
        cls, law: PhaseLaw, peak: float, wavelengths: Any, weights: np.ndarray, peaked: bool = False
    ) -> "Scattering":
        """A law in channels, weights (W, C) of light of wavelengths (W,), nm."""
        angle, solid = grid(ANGLES)
        value = np.asarray(law.value(np.cos(angle), wavelengths))
        total = weights.sum(axis=0)
        share = np.where(total > 0, weights / np.where(total > 0, total, 1.0), 1 / len(weights))
        return cls(np.ascontiguousarray(value / (solid @ value) @ share), peak, peaked)

    @cached_property
    def peaks(self) -> np.ndarray:
        """The forward peak, (ANGLES, C), of integral `peak`."""
        angle, solid = grid(ANGLES)
        away, widths = 1 - np.cos(angle), np.geomspace(1e-6, 1e6, 200)
        held = (np.exp(-away / widths[:, None]) * solid) @ self.law
        width = [np.interp(self.peak, part, np.log(widths)) for part in held.T]
        return np.asarray(self.law * np.exp(-away[:, None] / np.exp(width)))

    @cached_property
    def seeming(self) -> np.ndarray:
        """The law that light scattered once seems to follow, over the scaled depth, (DEPTHS, ANGLES, C)."""
        f, scaled = self.peak, FIRST * np.expm1(STEP * np.arange(DEPTHS))[:, None, None]
        turns, p = f / (1 - f) * scaled, self.moments(self.peaks) / max(f, 1e-9)
        rest = self.moments(self.law - self.peaks) / (1 - f)
        straight, blurred = np.exp(-turns), np.exp(-turns * (1 - p))
        none = straight * (turns * p)
        more = rest * (blurred - straight) + (blurred - straight - none) / np.maximum(scaled, 1e-9)
        order = (2 * np.arange(MOMENTS)[:, None] + 1) * (FADING if self.peaked else 1.0)
        at = np.sqrt(grid(SMOOTH)[0] / np.pi) * (ANGLES - 1)
        smooth = np.tensordot(polynomials(SMOOTH).T, order / (4 * np.pi) * more, axes=(1, 1))
        smooth = np.stack([np.interp(np.arange(ANGLES), at, row) for row in smooth.reshape(SMOOTH, -1).T])
        smooth = smooth.T.reshape(ANGLES, DEPTHS, -1).transpose(1, 0, 2)
        return np.asarray(np.maximum(self.law / (1 - f) * straight + smooth, 0.0))

    def moments(self, table: np.ndarray) -> np.ndarray:
        """Legendre moments of a table (ANGLES, C), (MOMENTS, C)."""
        return np.asarray((polynomials(ANGLES) * grid(ANGLES)[1]) @ table)

    def evened(self, within: float) -> np.ndarray:
        """The law with its mean `within` an angle of its peak, radians, (ANGLES, C)."""
        angle, solid = grid(ANGLES)
        inside = (angle < within)[:, None]
        mean = (solid @ (self.law * inside)) / (solid @ inside)
        return np.where(inside, mean, self.law)

    @cached_property
    def drawn(self) -> np.ndarray:
        """Scattering angles at even shares of the mean law's integral, (SHARES,)."""
        angle, _ = grid(ANGLES)
        value = self.law.mean(axis=1)
        step = 0.5 * np.diff(np.cos(angle))
        whole = np.append(0.0, np.cumsum(-(value[1:] + value[:-1]) * step))
        return np.asarray(np.interp(np.linspace(0, 1, SHARES), whole / whole[-1], angle))

    def once(self, cosine: np.ndarray, parts: np.ndarray) -> np.ndarray:
        """Light scattered once, of parts (D, DEPTHS) by depth that are turned by cosines (D,), (D, C)."""
        place = np.sqrt(np.arccos(np.clip(cosine, -1, 1)) / np.pi) * (ANGLES - 1)
        low = np.minimum(place.astype(int), ANGLES - 2)
        share = (place - low)[:, None]
        law = self.seeming[:, low] * (1 - share) + self.seeming[:, low + 1] * share
        return np.asarray(np.einsum("dk,kdc->dc", parts, law))
