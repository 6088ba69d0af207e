"""A field of cloud under its lights: depths toward the sun, and diffused light of sun, sky and ground.

Fast form. Light scattered once is found along the ray with the true phase function, the forward peak taken out of the
optical depths (Nakajima and Tanaka 1988, the TMS method; delta-Eddington, Joseph et al. 1976). All higher orders are
diffusion in three dimensions over a coarse grid: -div(D grad fluence) = source, D = 1 / (3 (1 - g) extinction).
"""

from dataclasses import dataclass
from functools import cached_property
from math import ceil
from typing import Any

import numpy as np

from skydome.air.phase_laws import HenyeyGreenstein
from skydome.ground.compiled import shared
from skydome.ground.extras import required
from skydome.skies.clouds.fields.field import CloudField

ANGLES = 3601
LOWEST = 0.01
"""Sine of the elevation of the lowest sun whose shadows are let down."""
FARTHEST = 120_000.0
"""How far cloud is sought, m."""
OPEN_TO_SUN, OPEN_TO_SKY = 1.0 / 620.0, 1.0 / 4000.0
"""Transport extinction that stands for empty air, m-1, in the diffusion of sunlight, and of light from sky and ground;
fitted, as are the next, to paths traced (docs/clouds.md)."""
BLUR, BROADER = 0.35, 2.5
"""How soon many small turns blur the phase function, and to which power of its mean cosine."""
SWEEPS, OVER = 24, 1.8
RAYS_PER_PIECE = 1 << 8
WIDTHS = np.array([1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48])
"""Gaps that are told apart, in heights of a cell."""


@dataclass(frozen=True, eq=False)
class LitField:
    """A field under a sun toward `sun` (3,), ready for rays."""

    field: CloudField
    sun: np.ndarray
    coarseness: int = 2
    """Places of the shape along a side of a cell of the coarse grid."""

    @classmethod
    def of(cls, field: CloudField, sun: Any, coarseness: int = 2) -> "LitField":
        """ImportError without Numba; a lower sun than `LOWEST` lets down shadows as one there."""
        required("numba", "fast", "a field of cloud")
        sun = np.asarray(sun, np.float64)
        high = max(float(sun[2]), LOWEST)
        flat = np.sqrt(1 - high * high) / max(np.hypot(sun[0], sun[1]), 1e-12)
        return cls(field, np.array([sun[0] * flat, sun[1] * flat, high]), coarseness)

    @cached_property
    def asymmetry(self) -> float:
        """Mean cosine of the cloud's scattering angle."""
        return float(np.asarray(self.field.kind.phase.mean_cosine([550.0]))[0])

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

    def diffusivity(self, open_air: float) -> np.ndarray:
        """1 / (3 transport extinction), m, that of empty air in the gaps."""
        return np.asarray(1 / (3 * np.maximum((1 - self.asymmetry) * self.coarse, open_air)), np.float32)

    @cached_property
    def of_sky(self) -> np.ndarray:
        """Fluence for a skylight of irradiance 1 from above."""
        return self.diffused(np.zeros_like(self.coarse), self.diffusivity(OPEN_TO_SKY), 1.0, 0.0)

    @cached_property
    def of_ground(self) -> np.ndarray:
        """Fluence for ground light of irradiance 1 from below."""
        return np.float32(4) - self.of_sky  # under both it is even

    @cached_property
    def of_sun(self) -> np.ndarray:
        """Diffuse fluence for sunlight of irradiance 1 on a plane that faces it."""
        dx, dz = self.steps
        beam = self.coarse * self.kept * np.exp(-self.sun_depths)
        below = np.exp(-self.sun_depths[..., 0] - 0.5 * dz / self.sun[2] * self.kept * self.coarse[..., 0]).mean()
        beam *= self.sun[2] * (1 - below) / max(beam.mean() * self.field.thickness, 1e-30)  # what is lost is scattered
        diffusivity = self.diffusivity(OPEN_TO_SUN)
        forward = 3 * diffusivity * beam * (self.asymmetry / (1 + self.asymmetry))
        source = beam.astype(np.float32)
        for axis, (part, step) in enumerate(zip(-self.sun[[1, 0, 2]], (dx, dx, dz), strict=True)):
            before, after = np.roll(forward, 1, axis), np.roll(forward, -1, axis)
            if axis == 2:
                before[..., 0], after[..., -1] = -forward[..., 0], -forward[..., -1]
            source -= np.float32(part * (after - before) / (2 * step))
        return self.diffused(source, diffusivity, 0.0, 0.0)

    def diffused(self, source: np.ndarray, diffusivity: np.ndarray, top: float, bottom: float) -> np.ndarray:
        """The fluence, float32."""
        from skydome.skies.clouds.fields.diffusion_kernel import relaxed

        fluence = np.full(source.shape, 2.0 * (top + bottom), np.float32)
        column = np.empty((3, source.shape[2]))
        relaxed(diffusivity, source, *self.steps, top, bottom, SWEEPS, OVER, column, fluence)
        return np.maximum(fluence, 0)

    @cached_property
    def budget(self) -> tuple[float, float, float, float]:
        """What comes down below the field: of the sun straight, as a share; of sunlight and skylight of irradiance 1
        scattered, on the horizontal; and the share of light from below that is sent back down.
        """
        below = self.sun_depths[..., 0] + 0.5 * self.steps[1] / self.sun[2] * self.kept * self.coarse[..., 0]
        of_sun = self.leaving(self.of_sun, OPEN_TO_SUN, 0.0)
        of_sky, back = (self.leaving(part, OPEN_TO_SKY, j) for part, j in ((self.of_sky, 0.0), (self.of_ground, 1.0)))
        return float(np.exp(-below).mean()), of_sun, of_sky, 1 + back

    def leaving(self, fluence: np.ndarray, open_air: float, entering: float) -> float:
        """Mean net flux out of the field's bottom, where a flux `entering` comes in."""
        inner = 1 + self.steps[1] / (4 * self.diffusivity(open_air)[..., 0])
        return float(((fluence[..., 0] / 2 - 2 * entering) / inner).mean())

    @cached_property
    def light(self) -> np.ndarray:
        """What rays read, (north, east, up, 4)."""
        return np.ascontiguousarray(np.stack([self.sun_depths, self.of_sun, self.of_sky, self.of_ground], axis=-1))

    @cached_property
    def phase(self) -> np.ndarray:
        """The phase function at even angles, and what is left of it after many small turns, (2, ANGLES)."""
        cosine, blurred = np.cos(np.linspace(0, np.pi, ANGLES)), HenyeyGreenstein((self.asymmetry**BROADER,))
        return np.stack([law.value(cosine, [550.0])[:, 0] for law in (self.field.kind.phase, blurred)])

    def seen(self, directions: np.ndarray) -> np.ndarray:
        """Toward directions (D, 3): transmittance, radiance of sun, sky and ground for 1, distance: (D, 5)."""
        from skydome.skies.clouds.fields.march_kernel import marched

        views = np.ascontiguousarray(directions, np.float64)
        out = np.empty((len(views), 5))
        kind = self.field.kind
        numbers = np.array(
            [self.kept, FARTHEST, 2.0 * kind.detail, self.asymmetry, OPEN_TO_SUN, BLUR * (1 / self.kept - 1)]
        )
        given = (self.field.medium, views, self.light, self.gaps, kind.period, self.sun, self.phase, numbers, out)
        shared(marched, len(views), len(views), given, RAYS_PER_PIECE)
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
