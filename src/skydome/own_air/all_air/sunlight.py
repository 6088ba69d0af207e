"""Sunlight along the teacher's rays: bent, thinned by the bending, and blocked by the ground."""

from functools import cache
from typing import NamedTuple

import numpy as np

from skydome.air.bending import HEIGHTS
from skydome.own_air.all_air.shells import tables
from skydome.skies.all_air.single_scattering import as_seen


class Sunlight(NamedTuple):
    """At points (K,) of a ray: place of the height (K,); sine of the suns seen there, place where their light is
    lowest, and what is left of it (0 behind the ground), each (K, S, P).
    """

    row: np.ndarray
    sine: np.ndarray
    lowest: np.ndarray
    share: np.ndarray

    @classmethod
    def of(cls, heights: np.ndarray, sines: np.ndarray) -> "Sunlight":
        """At heights (K,), m, of suns by the sine of their true elevation (K, S, P)."""
        own, high = tables(), np.broadcast_to(heights[:, None, None], sines.shape)
        seen, share = own.seen(high, np.arcsin(sines))
        sine = np.sin(seen)
        row = np.asarray(own.row(heights, HEIGHTS))
        lowest = own.lowest_place(high, sine)
        return cls(row, *(np.asarray(part, np.float32) for part in (sine, lowest, share)))

    def scattered(
        self, column: np.ndarray, depth: np.ndarray, strength: np.ndarray, phase: np.ndarray, out: np.ndarray
    ) -> None:
        """Adds what the points scatter to `out` (S, P, AIRS): see `solver_kernel.add_once`."""
        from skydome.own_air.all_air.solver_kernel import add_once

        given = (np.asarray(part, np.float32) for part in (depth, strength, phase))
        add_once(*airs_last(), *self, column, *given, out)


@cache
def airs_last() -> tuple[np.ndarray, np.ndarray]:
    """The columns of `ColumnTables`, (heights, cosines, 4), and of level rays, (heights, 4)."""
    own = tables()
    return np.ascontiguousarray(np.moveaxis(own.columns, 0, -1)), np.ascontiguousarray(own.level.T)


def seen_sines(sines: np.ndarray) -> np.ndarray:
    """Sines of the elevations at which suns of such sines are seen from the ground, same shape."""
    suns = np.stack([np.sqrt(np.maximum(1 - sines**2, 0.0)), 0 * sines, sines], axis=-1)
    return np.asarray(as_seen(tables(), suns)[..., 2])
