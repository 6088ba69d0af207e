"""Discrete ordinates through a coarse grid of cloud: fluence and flux of all light scattered; gaps are as they are.

Twelve directions down and twelve up (three slants of Gauss, four azimuths) through cells that scatter
(1 + 3 g cos) / 4 pi of what meets them. Each step is one sweep of rays, and diffusion of what it changed (diffusion
synthetic acceleration, Alcouffe 1977): sweeps alone would have to be hundreds in thick cloud. Steps begin with what
cells twice as wide have, and those with still wider ones: three steps do for seven. Nothing in it is fitted.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from skydome.skies.clouds.fields.transport.diffusion import Diffusion, paired

SLANTS = 3
CHANGE, WIDE_CHANGE, MOST = 8e-3, 1e-3, 24
"""Change of the mean fluence at which it is found (what is left then is less than half of it), of that in the widest
cells, and steps at most.
"""
NARROWEST = 16
"""Cells along a side of the widest cells' grid, at most."""
THIN, LEAST = 1e-2, 1e-20
"""Optical depth below which series are exact; an extinction that is none, m-1."""
FOUR_PI = 4 * np.pi


@dataclass(frozen=True, eq=False)
class Ordinates:
    """Light through cells of scaled `extinction` (north, east, up), m-1, of `steps` (width, height), m, that scatter
    an `albedo` of what meets them with a mean cosine of `asymmetry`.
    """

    extinction: np.ndarray
    steps: tuple[float, float]
    asymmetry: float
    albedo: float = 1.0

    @cached_property
    def sigma(self) -> np.ndarray:
        """The extinction (up, north, east), float32."""
        return np.ascontiguousarray(np.moveaxis(self.extinction, 2, 0), np.float32)

    @cached_property
    def wider(self) -> "Ordinates":
        """By cells twice as wide."""
        return replace(self, extinction=paired(self.extinction), steps=(2 * self.steps[0], self.steps[1]))

    def of_wider(self, first: np.ndarray) -> np.ndarray:
        """What cells twice as wide send where these send `first` (4, up, north, east)."""
        return np.asarray(halved(self.sigma * first) / np.maximum(self.wider.sigma, LEAST))

    @property
    def is_widest(self) -> bool:
        """Whether there are no wider cells."""
        return len(self.extinction) <= NARROWEST

    @cached_property
    def slants(self) -> tuple[np.ndarray, np.ndarray]:
        """Sines of the elevations of rays and their shares of a hemisphere, (SLANTS,)."""
        nodes, weights = np.polynomial.legendre.leggauss(SLANTS)
        return (nodes + 1) / 2, weights / 2

    @cached_property
    def counts(self) -> np.ndarray:
        """Steps through a level, none longer than a cell is wide, (SLANTS,)."""
        sine, (dx, dz) = self.slants[0], self.steps
        return np.asarray(np.maximum(np.ceil(np.sqrt(1 - sine**2) / sine * dz / dx), 1), np.int64)

    @cached_property
    def longs(self) -> np.ndarray:
        """How long they are, m."""
        return np.asarray(self.steps[1] / self.slants[0] / self.counts, np.float32)

    @cached_property
    def met(self) -> np.ndarray:
        """(1 - exp(-t)) / t of their optical depths t, (SLANTS, up, north, east)."""
        depth, thick = self.depths
        return np.where(depth > THIN, -np.expm1(-thick) / thick, 1 - depth / 2 + depth**2 / 6).astype(np.float32)

    @cached_property
    def bent(self) -> np.ndarray:
        """What a source that grows by 1 along such a step sends ahead over what an even one does, over t, alike."""
        depth, thick = self.depths
        more = (1 + np.exp(-thick)) / 2 + np.expm1(-thick) / thick
        return np.where(depth > THIN, more / thick, depth / 12).astype(np.float32)

    @property
    def depths(self) -> tuple[np.ndarray, np.ndarray]:
        """Optical depths of the steps, and the same held to `THIN`."""
        depth = self.longs[:, None, None, None] * self.sigma
        return depth, np.maximum(depth, np.float32(THIN))

    @cached_property
    def directions(self) -> np.ndarray:
        """Directions (east, north, up), each of which stands for four, and what they count at a step, sr, float32."""
        sine, share = self.slants
        side, q = np.repeat([-1.0, 1.0], SLANTS), np.tile(np.arange(SLANTS), 2)
        azimuth, flat = (
            np.pi / 4 * (0.5 + (np.arange(2 * SLANTS) + np.arange(2 * SLANTS) // SLANTS) % 2),
            np.sqrt(1 - sine**2),
        )
        weight = np.pi / 2 * share / self.counts
        return np.stack(
            [flat[q] * np.sin(azimuth), flat[q] * np.cos(azimuth), side * sine[q], weight[q]], axis=1
        ).astype(np.float32)

    @cached_property
    def hops(self) -> np.ndarray:
        """How many cells to east and north a ray has gone at each step, of directions and quarter turns."""
        rows, columns = self.extinction.shape[:2]
        a, b, up = np.asarray(self.directions[:, :3], np.float64).T
        each = self.steps[1] / self.steps[0] / np.abs(up) / np.tile(self.counts, 2)
        ways = np.stack([np.stack([a, -b, -a, b], 1), np.stack([b, a, -b, -a], 1)], axis=-1) * each[:, None, None]
        places = np.arange(self.counts.max() * self.extinction.shape[2]) + 0.5
        gone = np.floor(ways[:, :, None, :] * places[:, None] + 0.5).astype(np.int64)
        return np.asarray(gone % np.array([columns, rows]))

    def beam(self, light: np.ndarray, sun: np.ndarray) -> np.ndarray:
        """What a beam of so much light in each cell (north, east, up), from the sun (3,), makes them send."""
        light = np.moveaxis(light, 2, 0) * (self.albedo / FOUR_PI)
        return np.asarray([light, *(-3 * self.asymmetry * part * light for part in sun)], np.float32)

    def found(self, first: np.ndarray | None, above: float, below: float) -> tuple[np.ndarray, tuple[float, float]]:
        """Fluence and flux to east, north and up, (north, east, up, 4), float32, and the fluxes that go out of bottom
        and top, where cells send `first` besides what they scatter, and fluxes come in from above and below.
        """
        light, ray = self.solved(first, np.array([above, below], np.float32) / np.float32(np.pi))
        each = 4 * self.directions[:, 3] * np.abs(self.directions[:, 2]) * np.tile(self.counts, 2)
        down, up = (each * ray.mean(axis=(1, 2, 3))).reshape(2, SLANTS).sum(axis=1)
        light[0] = np.maximum(light[0], 0)
        return light.transpose(2, 3, 1, 0), (float(down), float(up))

    def coming_down(self, first: np.ndarray) -> tuple[float, float, float]:
        """What comes down of what cells send `first`, and of fluxes of 1 that come in from above and from below.

        By the last alone, since light goes a way as well as back: its light in a cell, turned about, tells how much of
        what the cell sends comes down, and what of it goes out above how much comes down from there.
        """
        light, (down, up) = self.found(None, 0.0, 1.0)
        about = light.transpose(3, 2, 0, 1) * np.array([1, -1, -1, -1], np.float32)[:, None, None, None]
        height = self.steps[1] * self.extinction.shape[2]
        return float(np.pi * height * (self.sigma * (first * about).sum(axis=0)).mean()), up, down

    def solved(self, first: np.ndarray | None, entering: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Fluence and flux (4, up, north, east), and radiances that go out, where `entering` ones come in."""
        ray = np.empty((len(self.directions), 4, *self.sigma.shape[1:]), np.float32)
        light, enough = self.begun(first, entering), WIDE_CHANGE if self.is_widest else CHANGE
        for _ in range(MOST):
            new = self.swept(light, first, entering, ray)
            step = new[0] - light[0]
            more = self.hastened(step)
            light, change = new, np.abs(step + more).mean()
            light[0] += more
            if change < enough * light[0].mean():
                break
        return light, ray

    def begun(self, first: np.ndarray | None, entering: np.ndarray) -> np.ndarray:
        """What cells twice as wide have, none where these are the widest."""
        if self.is_widest:
            return np.zeros((4, *self.sigma.shape), np.float32)
        light, _ = self.wider.solved(None if first is None else self.of_wider(first), entering)
        return light.repeat(2, axis=2).repeat(2, axis=3)

    def swept(self, light: np.ndarray, first: np.ndarray | None, entering: np.ndarray, ray: np.ndarray) -> np.ndarray:
        """Fluence and flux (4, up, north, east) by one sweep."""
        from skydome.skies.clouds.fields.transport.ordinates_kernel import swept

        share = np.array([1, *[3 * self.asymmetry] * 3]) * (self.albedo / FOUR_PI)
        sent = light * share.astype(np.float32)[:, None, None, None]
        if first is not None:
            sent += first
        groups = np.arange(2 * SLANTS).reshape(2, SLANTS, 1) + np.array([0, 1])
        out, scratch = np.zeros_like(light), np.empty((10, light.shape[3]), np.float32)
        cells, rays = (self.sigma, self.met, self.bent, sent), (self.directions, groups, self.counts, self.longs)
        swept(*cells, *rays, self.hops, entering, ray, scratch, out)
        return out

    def hastened(self, change: np.ndarray) -> np.ndarray:
        """What diffusion makes of a change of the fluence, (up, north, east)."""
        source = np.ascontiguousarray(np.moveaxis(change, 0, 2)) * (np.float32(self.albedo) * self.extinction)
        return np.moveaxis(self.diffusion.fluence(source), 2, 0)

    @cached_property
    def diffusion(self) -> Diffusion:
        """Diffusion in which light goes the grid's height at least before it is turned."""
        open_air = np.float32(1 / (self.steps[1] * self.extinction.shape[2]))
        turned = np.maximum(np.float32(1 - self.albedo * self.asymmetry) * self.extinction, open_air)
        return Diffusion.of(turned, np.float32(1 - self.albedo) * self.extinction, self.steps)


def halved(cells: np.ndarray) -> np.ndarray:
    """Means of two by two cells to north and east, of (..., north, east)."""
    pairs = cells[..., ::2, :] + cells[..., 1::2, :]
    return np.asarray(0.25 * (pairs[..., ::2] + pairs[..., 1::2]), np.float32)
