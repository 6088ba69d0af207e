"""A held sky's table made fine, so that straight lines do between its nodes: in NumPy, or compiled for many views.

Nodes are even in a measure of the view's elevation that crowds at the horizon, and in the azimuth from the sun; phase
functions are even in the half chord between view and sun, so that they are fine where the aureole is steep.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.ground.compiled import shared
from skydome.ground.interpolation import lagrange_about
from skydome.skies.physical.cosine_series import LEAST_COSINE, position

ROWS, TURNS, CHORDS = 193, 181, 4096
"""Nodes in elevation, in azimuth and in the half chord."""
MANY = 4096
"""From so many directions on straight lines between fine nodes are taken, not the series itself."""
LEAST_DIRECTIONS = 1 << 16
"""Fewer directions than this take NumPy and do not wait for a compiler."""


@dataclass(frozen=True, eq=False)
class HeldFields:
    """Fields (rows, turns, shapes + 1, 3) of a sky under a `sun` (3,), and its shapes over the half chord, float32."""

    sun: np.ndarray
    fields: np.ndarray
    phases: np.ndarray
    """(chords, shapes)."""

    @classmethod
    def of(cls, sun: np.ndarray, series: np.ndarray, shapes: Any) -> "HeldFields":
        """From coefficients (nodes, terms, shapes + 1, 3) and `shapes(cosines)` (shapes, N); those without light go."""
        lit = [k for k in range(series.shape[2] - 1) if np.any(series[:, :, k] != 0)]
        kept = series[:, :, [*lit, -1]]
        nodes, weights = lagrange_about(len(kept), np.linspace(0, 1, ROWS))
        hats = np.zeros((ROWS, len(kept)))
        np.put_along_axis(hats, nodes, weights, axis=1)
        waves = np.cos(np.linspace(0, np.pi, TURNS)[:, None] * np.arange(kept.shape[1]))
        risen = (hats @ kept.reshape(len(kept), -1)).reshape(ROWS, kept.shape[1], -1)
        fields = np.matmul(waves, risen).reshape(ROWS, TURNS, *kept.shape[2:])
        chord = np.linspace(0, 1, CHORDS)
        phases = shapes(1 - 2 * chord**2)[lit].T
        single = (np.ascontiguousarray(part, np.float32) for part in (sun, fields, phases))
        return cls(*single)

    def light(self, views: np.ndarray) -> np.ndarray:
        """XYZ toward views (D, 3), (D, 3) float64; below the horizon what the horizon has."""
        row = position(np.maximum(views[:, 2], LEAST_COSINE)) * (ROWS - 1)
        turn = turns_of(views, np.asarray(self.sun, np.float64)) * (TURNS - 1)
        difference = views - self.sun
        chord = np.sqrt(np.einsum("dk,dk->d", difference, difference)) / 2 * (CHORDS - 1)
        (i, a), (j, b), (k, c) = (split(v, n) for v, n in ((row, ROWS), (turn, TURNS), (chord, CHORDS)))
        flat = self.fields.reshape(ROWS * TURNS, -1)
        at = i * TURNS + j
        low = flat[at] * (1 - b)[:, None] + flat[at + 1] * b[:, None]
        high = flat[at + TURNS] * (1 - b)[:, None] + flat[at + TURNS + 1] * b[:, None]
        found = (low + (high - low) * a[:, None]).reshape(len(views), -1, 3)
        phases = self.phases[k] + (self.phases[k + 1] - self.phases[k]) * c[:, None]
        light: np.ndarray = found[:, -1] + np.einsum("ds,dsc->dc", phases, found[:, :-1])
        result: np.ndarray = np.maximum(light, 0.0)
        return result

    def light_in_single(self, views: np.ndarray, matrix: np.ndarray) -> np.ndarray:
        """`matrix` (3, 3) times XYZ toward float32 views (D, 3), (D, 3) float32, compiled; 0 below the horizon."""
        from skydome.skies.physical.held_kernel import shine

        fields = np.ascontiguousarray(self.fields @ matrix.T.astype(np.float32)).reshape(ROWS, TURNS, -1)
        out = np.empty((len(views), 3), np.float32)

        shared(shine, len(views), out.size, (views, self.sun, fields, self.phases, out))
        return out


def turns_of(views: np.ndarray, sun: np.ndarray) -> np.ndarray:
    """Azimuth of views (D, 3) from the sun, 0 toward it to 1 opposite, (D,)."""
    level = views[:, 0] * sun[0] + views[:, 1] * sun[1]
    cross = views[:, 0] * sun[1] - views[:, 1] * sun[0]
    result: np.ndarray = np.arctan2(np.abs(cross), level) / np.pi
    return result


def split(place: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """The node below each place, so that there is one above, and the rest."""
    first = np.clip(place.astype(np.int64), 0, count - 2)
    return first, place - first
