"""A field of cloud under its lights: depths toward the sun, and scattered light of sun, sky and ground.

Fast form. Light scattered once is found along the ray with the true phase function, the forward peak taken out of the
optical depths (Nakajima and Tanaka 1988, the TMS method; delta-Eddington, Joseph et al. 1976). All higher orders are
discrete ordinates in three dimensions over a coarse grid (`transport`), of which fluence and flux are read. Cloud that
absorbs dims them as a whole, by what one such transport loses.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from math import ceil
from typing import Any, Self

import numpy as np

from skydome.ground.compiled import shared
from skydome.ground.extras import required
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.low_sun import share_of, steepened
from skydome.skies.clouds.fields.scattering import DEPTHS, Scattering
from skydome.skies.clouds.fields.transport.ordinates import Ordinates

FARTHEST = 400_000.0
"""How far cloud is sought, m."""
FINE, MOST_LEVELS = 4.0, 96
"""Steps along the sun's rays, in places of fine detail, and how many there are at most."""
LOST, TRIFLE, LEAST = 0.02, 1e-4, 1e-9
"""Share absorbed where it is told how cloud absorbs; a share that is nothing; a flux that is."""
WIDEST = 32
"""Cells along a side of the grid by which that is told."""
USUAL = 2
"""Coarseness at which the sun's rays are as close as the places of the shape, and less close where it is more."""
RAYS_PER_PIECE = 1 << 8
WIDTHS = np.array([1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48])
"""Gaps that are told apart, in heights of a cell."""


@dataclass(frozen=True, eq=False)
class LitField:
    """A field under a sun that is seen toward `sun` (3,) from within it, or below it, ready for rays."""

    field: CloudField
    sun: np.ndarray
    coarseness: int = USUAL
    """Places of the shape along a side of a cell of the coarse grid."""

    @classmethod
    def of(cls, field: CloudField, sun: Any, coarseness: int = USUAL) -> Self:
        """ImportError without Numba; suns near the level are as `low_sun` has them."""
        required("numba", "fast", "a field of cloud")
        return cls(field, np.asarray(sun, np.float64), coarseness)

    @cached_property
    def ray(self) -> np.ndarray:
        """Toward the sun as its rays go through the field, over or under the level, (3,)."""
        return steepened(self.sun)

    @property
    def share(self) -> float:
        """Share of the light of those rays that the sun gives."""
        return share_of(self.sun, self.field.thickness)

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
    def beams(self) -> tuple[np.ndarray, np.ndarray]:
        """Scaled optical depth toward the sun along its rays (north, east, up), and the share of the sunlight that
        meets the cloud of each cell, alike, float32. `medium_kernel.beams` tells where they lie.
        """
        from skydome.skies.clouds.fields.medium_kernel import beams

        kind, (dx, _) = self.field.kind, self.steps
        levels = min(ceil(self.field.thickness / abs(self.ray[2]) / (FINE * kind.detail)), MOST_LEVELS)
        side = max(self.cells, kind.count * USUAL // self.coarseness)
        depths = np.empty((side, side, max(levels, kind.levels) + 1), np.float32)
        met, passing = np.zeros_like(self.coarse), np.zeros_like(self.coarse)
        beams(self.field.medium, self.gaps, dx, self.kept, self.ray, depths, met, passing)
        return depths, passing / np.maximum(met, LEAST)

    def straight(self, sine: float) -> float:
        """Share of the sun's light that comes straight through the field, on a way through it at a sine."""
        high = self.ray[2]
        return float(np.exp(-self.beams[0][..., 0 if high > 0 else -1] * (abs(high) / sine)).mean())

    @cached_property
    def ordinates(self) -> Ordinates:
        """Light through the coarse grid."""
        return Ordinates(np.float32(self.kept) * self.coarse, self.steps, self.asymmetry / (1 + self.asymmetry))

    @cached_property
    def beam(self) -> np.ndarray:
        """Sunlight in each cell for an irradiance of 1 on a plane that faces it, float32; what is lost is scattered."""
        light = self.beams[1]
        met = float((self.ordinates.extinction * light).mean()) * self.field.thickness
        high = abs(self.ray[2])
        return light * np.float32(high * (1 - self.straight(high)) / max(met, 1e-30))

    @cached_property
    def first(self) -> np.ndarray:
        """What cells send of sunlight scattered once, as `ordinates` have it."""
        return self.ordinates.beam(self.beam, self.ray)

    @cached_property
    def sunlight(self) -> tuple[np.ndarray, tuple[float, float]]:
        """Fluence and flux of scattered light for sunlight of irradiance 1 on a plane that faces it, and what of it
        comes out below and above.
        """
        light, (down, up) = self.ordinates.found(self.first, 0.0, 0.0)
        return light * np.float32(self.share), (self.share * down, self.share * up)

    @cached_property
    def skylight(self) -> tuple[np.ndarray, tuple[float, float]]:
        """For a skylight of irradiance 1 from above. Under such a light from the ground too, all is even."""
        return self.ordinates.found(None, 1.0, 0.0)

    @cached_property
    def losses(self) -> tuple[float, ...]:
        """Light of sun, sky and ground that comes down, over that where cloud absorbs `LOST` of what meets it."""
        wide, first = self.ordinates, self.first
        while len(wide.extinction) > WIDEST:
            wide, first = wide.wider, wide.of_wider(first)
        dim = replace(wide, albedo=1 - LOST / self.kept)
        both = wide.coming_down(first), dim.coming_down(np.float32(dim.albedo) * first)
        return tuple(all_down / max(down, LEAST) for all_down, down in zip(*both, strict=True))

    def dimming(self, lost: np.ndarray) -> np.ndarray:
        """What cloud that absorbs shares `lost` (W,) leaves of the scattered light of sun, sky and ground, (3, W)."""
        if lost.max(initial=0.0) < TRIFLE:
            return np.ones((3, len(lost)))
        return np.asarray(1 / (1 + lost / LOST * (np.array(self.losses)[:, None] - 1)))

    @property
    def budget(self) -> tuple[float, float, float, float]:
        """What comes down below the field: of the sun straight, as a share; of sunlight and skylight of irradiance 1
        scattered, on the horizontal; and the share of light from below that is sent back down.
        """
        (of_sun, _), (of_sky, _) = self.sunlight[1], self.skylight[1]
        return self.straight(abs(self.ray[2])), of_sun, of_sky, 1 - of_sky

    @cached_property
    def light(self) -> np.ndarray:
        """What rays read, (north, east, up, 8)."""
        return np.concatenate([self.sunlight[0], self.skylight[0]], axis=-1)

    def scattering(self, wavelengths: Any = (550.0,), weights: Any = ((1.0,),)) -> Scattering:
        """How the cloud scatters in channels, weights (W, C) of light of wavelengths (W,), nm."""
        kind = self.field.kind
        return Scattering.of(kind.law, self.asymmetry**2, wavelengths, np.asarray(weights), kind.particles.peaked)

    def seen(self, directions: np.ndarray) -> np.ndarray:
        """Toward directions (D, 3), for irradiances of 1: transmittance, radiance of sunlight scattered more than once,
        of sky and ground, distance, and sunlight scattered once by depth, for `Scattering.once`: (D, 5 + DEPTHS).
        """
        from skydome.skies.clouds.fields.march_kernel import marched

        views, kind = np.ascontiguousarray(directions, np.float64), self.field.kind
        out = np.empty((len(views), 5 + DEPTHS))
        numbers = np.array([self.kept, FARTHEST, 2.0 * kind.detail, self.asymmetry])
        given = (self.field.medium, views, self.light, self.beams[0], self.gaps, kind.period, self.ray, numbers, out)
        shared(marched, len(views), len(views), given, RAYS_PER_PIECE)
        out[:, 5:] *= self.share
        return out


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
