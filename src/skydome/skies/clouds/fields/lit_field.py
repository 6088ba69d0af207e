"""A field of cloud under its lights: depths toward the sun, and diffused light of sun, sky and ground.

Fast form. Light scattered once is found along the ray with the true phase function, the forward peak taken out of the
optical depths (Nakajima and Tanaka 1988, the TMS method; delta-Eddington, Joseph et al. 1976). All higher orders are
diffusion in three dimensions over a coarse grid: -div(D grad fluence) = source, D = 1 / (3 (1 - g) extinction). Cloud
that absorbs dims it as a whole, by what one such diffusion loses.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from math import ceil
from typing import Any, Self

import numpy as np

from skydome.ground.compiled import shared
from skydome.ground.extras import required
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.scattering import DEPTHS, Scattering

LOWEST = 0.01
"""Sine of the elevation of the lowest sun whose shadows are let down."""
FARTHEST = 400_000.0
"""How far cloud is sought, m."""
OPEN_TO_SUN, OPEN_TO_SKY = 600.0, 4.0
"""The transport length of empty air is, in the diffusion of sunlight, the root of this (m) times cover times thickness,
and in that of light from sky and ground so many thicknesses. Fitted to paths traced (docs/clouds.md)."""
SWEEPS, OVER, FEWEST = 16, 1.7, 8
"""Sweeps on each grid, how far beyond, and cells along a side of the coarsest grid, at most."""
LOST, TRIFLE, LEAST = 0.02, 1e-4, 1e-9
"""Share absorbed in the diffusion that tells how cloud absorbs; a share that is nothing; a flux that is."""
RAYS_PER_PIECE, WIDTHS = 1 << 8, np.array([1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48])
"""Rays at a time; gaps that are told apart, in heights of a cell."""


@dataclass(frozen=True, eq=False)
class LitField:
    """A field under a sun toward `sun` (3,), ready for rays."""

    field: CloudField
    sun: np.ndarray
    coarseness: int = 2
    """Places of the shape along a side of a cell of the coarse grid."""

    @classmethod
    def of(cls, field: CloudField, sun: Any, coarseness: int = 2) -> Self:
        """ImportError without Numba; a lower sun than `LOWEST` lets down shadows as one there."""
        required("numba", "fast", "a field of cloud")
        sun = np.asarray(sun, np.float64)
        high = max(float(sun[2]), LOWEST)
        flat = np.sqrt(1 - high * high) / max(np.hypot(sun[0], sun[1]), 1e-12)
        return cls(field, np.array([sun[0] * flat, sun[1] * flat, high]), coarseness)

    @cached_property
    def asymmetry(self) -> float:
        """Mean cosine of the cloud's scattering angle."""
        return float(np.asarray(self.field.kind.law.mean_cosine([550.0]))[0])

    @property
    def kept(self) -> float:
        """Share of the extinction that stays when the forward peak g^2 is taken out."""
        return 1 - self.asymmetry**2

    @property
    def cells(self) -> int:
        """Of the coarse grid along the period."""
        return max(16, self.field.kind.count // self.coarseness)

    @property
    def steps(self) -> tuple[float, float]:
        """Width and height of its cells, m."""
        kind = self.field.kind
        return kind.period / self.cells, self.field.thickness / kind.levels

    @cached_property
    def coarse(self) -> np.ndarray:
        """Mean extinction of the cells, m-1, float32."""
        from skydome.skies.clouds.fields.medium_kernel import cell_means

        out = np.empty((self.cells, self.cells, self.field.kind.levels), np.float32)
        shared(cell_means, self.cells, out.size, (self.field.medium, self.field.kind.period, out), 1 << 14)
        return out

    @cached_property
    def gaps(self) -> np.ndarray:
        """Metres around each cell that are free of cloud, 0 within it and beside it, float32."""
        dx, dz = self.steps
        taken = widened(self.coarse > 0, 1, 1)
        found, level, upward = np.zeros(taken.shape, np.float32), 0, 0
        for free in dz * WIDTHS:
            taken = widened(taken, ceil(free / dx) - level, round(free / dz) - upward)
            found[~taken] = free
            level, upward = ceil(free / dx), round(free / dz)
        return found

    @cached_property
    def sun_depths(self) -> np.ndarray:
        """Optical depth from each cell toward the sun, less the forward peak."""
        from skydome.skies.clouds.fields.medium_kernel import depths_toward_sun

        out = np.zeros_like(self.coarse)
        depths_toward_sun(np.float32(self.coarse * self.kept), *self.steps, self.sun, out)
        return out

    @property
    def open_to_sun(self) -> float:
        """Transport extinction that stands for empty air, m-1, in the diffusion of sunlight."""
        return float(1 / np.sqrt(max(self.field.cover, LEAST) * self.field.thickness * OPEN_TO_SUN))

    @property
    def open_to_sky(self) -> float:
        """The same in that of light from sky and ground."""
        return 1 / (OPEN_TO_SKY * self.field.thickness)

    def diffusivity(self, open_air: float) -> np.ndarray:
        """1 / (3 transport extinction), m, that of empty air in the gaps."""
        return np.asarray(1 / (3 * np.maximum((1 - self.asymmetry) * self.coarse, open_air)), np.float32)

    @cached_property
    def of_sky(self) -> np.ndarray:
        """Fluence for a skylight of irradiance 1 from above."""
        return self.diffused(np.zeros_like(self.coarse), self.diffusivity(self.open_to_sky), 1.0, 0.0)

    @cached_property
    def of_ground(self) -> np.ndarray:
        """Fluence for ground light of irradiance 1 from below."""
        return np.float32(4) - self.of_sky  # under both it is even

    @cached_property
    def of_sun(self) -> np.ndarray:
        """Diffuse fluence for sunlight of irradiance 1 on a plane that faces it."""
        return self.diffused(self.sun_source, self.diffusivity(self.open_to_sun), 0.0, 0.0)

    @cached_property
    def sun_source(self) -> np.ndarray:
        """What the beam gives to that diffusion, m-1, float32."""
        dx, dz = self.steps
        beam = self.coarse * self.kept * np.exp(-self.sun_depths)
        below = np.exp(-self.sun_depths[..., 0] - 0.5 * dz / self.sun[2] * self.kept * self.coarse[..., 0]).mean()
        beam *= self.sun[2] * (1 - below) / max(beam.mean() * self.field.thickness, 1e-30)  # what is lost is scattered
        forward = 3 * self.diffusivity(self.open_to_sun) * beam * (self.asymmetry / (1 + self.asymmetry))
        source = beam.astype(np.float32)
        for axis, (part, step) in enumerate(zip(-self.sun[[1, 0, 2]], (dx, dx, dz), strict=True)):
            before, after = np.roll(forward, 1, axis), np.roll(forward, -1, axis)
            if axis == 2:
                before[..., 0], after[..., -1] = -forward[..., 0], -forward[..., -1]
            source -= np.float32(part * (after - before) / (2 * step))
        return np.asarray(source)

    def diffused(
        self, source: np.ndarray, diffusivity: np.ndarray, top: float, bottom: float, lost: float = 0.0
    ) -> np.ndarray:
        """The fluence, float32, where a share `lost` of what meets the cloud is absorbed."""
        absorbed = np.float32(lost) * self.coarse
        return np.asarray(np.maximum(spread(diffusivity, absorbed, source, *self.steps, top, bottom), 0))

    @cached_property
    def losses(self) -> tuple[float, ...]:
        """Light of sun, sky and ground that comes down, over that where cloud absorbs `LOST` of what meets it."""
        nothing, open_sky = np.zeros_like(self.coarse), self.diffusivity(self.open_to_sky)
        sun = self.diffused(self.sun_source * np.float32(1 - LOST), self.diffusivity(self.open_to_sun), 0.0, 0.0, LOST)
        sky, ground = (self.diffused(nothing, open_sky, 1.0 - n, n, LOST) for n in (0.0, 1.0))
        left = self.leaving(sun, self.open_to_sun, 0.0), self.leaving(sky, self.open_to_sky, 0.0)
        downs = (*left, 1 + self.leaving(ground, self.open_to_sky, 1.0))
        return tuple(whole / max(down, LEAST) for whole, down in zip(self.budget[1:], downs, strict=True))

    def dimming(self, lost: np.ndarray) -> np.ndarray:
        """What cloud that absorbs shares `lost` (W,) leaves of the scattered light of sun, sky and ground, (3, W)."""
        if lost.max(initial=0.0) < TRIFLE:
            return np.ones((3, len(lost)))
        return np.asarray(1 / (1 + lost / LOST * (np.array(self.wider.losses)[:, None] - 1)))

    @cached_property
    def wider(self) -> "LitField":
        """By cells twice as wide: what absorption takes is near to that by its own."""
        return replace(self, coarseness=2 * self.coarseness)

    @cached_property
    def budget(self) -> tuple[float, float, float, float]:
        """Below the field: the sun straight, a share; sun and sky of 1 scattered, on the level; the share sent back."""
        of_sun = self.leaving(self.of_sun, self.open_to_sun, 0.0)
        of_sky = self.leaving(self.of_sky, self.open_to_sky, 0.0)
        back = 1 + self.leaving(self.of_ground, self.open_to_sky, 1.0)
        return self.straight(self.sun[2]), of_sun, of_sky, back

    def straight(self, sine: float) -> float:
        """Share of the sun's light that comes straight through the field, on a way through it at a sine."""
        last = 0.5 * self.steps[1] * self.kept * self.coarse[..., 0]
        return float(np.exp(-(self.sun_depths[..., 0] * self.sun[2] + last) / sine).mean())

    def leaving(self, fluence: np.ndarray, open_air: float, entering: float) -> float:
        """Mean net flux out of the field's bottom, where a flux `entering` comes in."""
        inner = 1 + self.steps[1] / (4 * self.diffusivity(open_air)[..., 0])
        return float(((fluence[..., 0] / 2 - 2 * entering) / inner).mean())

    @cached_property
    def light(self) -> np.ndarray:
        """What rays read, (north, east, up, 4)."""
        return np.ascontiguousarray(np.stack([self.sun_depths, self.of_sun, self.of_sky, self.of_ground], axis=-1))

    def scattering(self, wavelengths: Any = (550.0,), weights: Any = ((1.0,),)) -> Scattering:
        """How the cloud scatters in channels, weights (W, C) of light of wavelengths (W,), nm."""
        kind = self.field.kind
        return Scattering.of(kind.law, self.asymmetry**2, wavelengths, np.asarray(weights))

    def seen(self, directions: np.ndarray) -> np.ndarray:
        """Toward directions (D, 3), for irradiances of 1: transmittance, radiance of sunlight scattered more than once,
        of sky and ground, distance, and sunlight scattered once by depth, for `Scattering.once`: (D, 5 + DEPTHS).
        """
        from skydome.skies.clouds.fields.march_kernel import marched

        views, kind = np.ascontiguousarray(directions, np.float64), self.field.kind
        out = np.empty((len(views), 5 + DEPTHS))
        numbers = np.array([self.kept, FARTHEST, 2.0 * kind.detail, self.asymmetry, self.open_to_sun])
        given = (self.field.medium, views, self.light, self.gaps, kind.period, self.sun, numbers, out)
        shared(marched, len(views), len(views), given, RAYS_PER_PIECE)
        return out


def spread(
    diffusivity: np.ndarray, absorbed: np.ndarray, source: np.ndarray, dx: float, dz: float, top: float, bottom: float
) -> np.ndarray:
    """The fluence by `relaxed`, which begins with that of a grid twice as coarse to north and east."""
    from skydome.skies.clouds.fields.diffusion_kernel import relaxed

    if len(source) > FEWEST:
        coarser = spread(paired(diffusivity), paired(absorbed), paired(source), 2 * dx, dz, top, bottom)
        fluence = coarser.repeat(2, axis=0).repeat(2, axis=1)
    else:
        fluence = np.full(source.shape, 2.0 * (top + bottom), np.float32)
    relaxed(diffusivity, absorbed, source, dx, dz, top, bottom, SWEEPS, OVER, fluence)
    return fluence


def paired(cells: np.ndarray) -> np.ndarray:
    """Means of two by two cells to north and east."""
    return np.ascontiguousarray(0.25 * (cells[::2, ::2] + cells[1::2, ::2] + cells[::2, 1::2] + cells[1::2, 1::2]))


def widened(taken: np.ndarray, level: int, upward: int) -> np.ndarray:
    """Cells (north, east, up) within so many cells of those taken; around to north and east."""
    for axis, times in ((0, level), (1, level)):
        for _ in range(times):
            taken = taken | np.roll(taken, 1, axis) | np.roll(taken, -1, axis)
    for _ in range(upward):
        wider = taken.copy()
        wider[..., 1:] |= taken[..., :-1]
        wider[..., :-1] |= taken[..., 1:]
        taken = wider
    return taken
