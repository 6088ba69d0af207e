"""Diffusion of light through a coarse grid of cloud, on grids from coarse to fine: what hastens discrete ordinates."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

SWEEPS, NOTHING = 2, np.float32(1e-9)
"""Sweeps on each grid; a share that is as good as none."""
SMEARED = 0.25
"""Diffusivity of ordinates' rays that hop from cell to cell, in widths of a cell, and the least that keeps the
hastening of dense cells steady, in heights of them.
"""


@dataclass(frozen=True, eq=False)
class Diffusion:
    """Diffusion through cells (north, east, up) of `steps` (width, height), m: D from level to level is `upward`, m,
    and `level` on one; `absorbed` in m-1. Nothing comes in from outside (Marshak's boundary).
    """

    upward: np.ndarray
    level: np.ndarray
    absorbed: np.ndarray
    steps: tuple[float, float]

    @classmethod
    def of(cls, extinction: np.ndarray, absorbed: np.ndarray, steps: tuple[float, float]) -> "Diffusion":
        """By transport extinction above 0, m-1."""
        level, upward = (np.hypot(np.float32(1 / 3) / extinction, np.float32(SMEARED * step)) for step in steps)
        return cls(upward, level, absorbed, steps)

    @cached_property
    def coarser(self) -> "Diffusion | None":
        """By cells twice as wide, down to one column, from which nothing goes to its sides."""
        if len(self.upward) == 1:
            return None
        (dx, dz), cells = self.steps, (self.upward, self.level, self.absorbed)
        upward, level, absorbed = (paired(part) for part in cells)
        return Diffusion(upward, level if len(level) > 1 else NOTHING * level, absorbed, (2 * dx, dz))

    @cached_property
    def tables(self) -> np.ndarray:
        """What passes between cells, (5, north, east, up)."""
        from skydome.skies.clouds.fields.transport.diffusion_kernel import joined_up

        tables = np.empty((5, *self.upward.shape), np.float32)
        joined_up(self.upward, self.level, self.absorbed, *self.steps, tables)
        return tables

    def fluence(self, source: np.ndarray) -> np.ndarray:
        """Of a `source` (north, east, up), m-1, by -div(D grad fluence) + absorbed fluence = source, float32."""
        from skydome.skies.clouds.fields.transport.diffusion_kernel import relaxed

        if self.coarser is None:
            found = np.zeros(source.shape, np.float32)
        else:
            found = self.coarser.fluence(paired(source)).repeat(2, axis=0).repeat(2, axis=1)
        relaxed(self.tables, source, SWEEPS, found)
        return found


def paired(cells: np.ndarray) -> np.ndarray:
    """Means of two by two cells to north and east."""
    return np.ascontiguousarray(0.25 * (cells[::2, ::2] + cells[1::2, ::2] + cells[::2, 1::2] + cells[1::2, 1::2]))
