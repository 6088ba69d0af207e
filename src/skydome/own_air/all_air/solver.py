"""The physical sky's teacher: successive orders of scattering in round shells, many airs and all suns at once.

A source is what the air gives off toward each view, on a grid of height, view, sun and azimuth; a sweep along rays
makes light of it, and harmonics make the next source of that light. Forward peaks are cut (delta-M) and the light
scattered once put right (TMS, Nakajima and Tanaka 1988).
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from skydome.ground.extras import required
from skydome.own_air.all_air.airs import AIRS
from skydome.own_air.all_air.harmonics import Harmonics
from skydome.own_air.all_air.phases import Scaled, depths, exact_phase, scattered
from skydome.own_air.all_air.places import Places, between, sun_along
from skydome.own_air.all_air.shells import Rays, density
from skydome.own_air.all_air.sunlight import Sunlight, seen_sines
from skydome.skies.all_air.taught_air import Optics

TYPICAL = Optics(
    *(np.geomspace(0.01, 0.8, AIRS), np.tile([0.05, 0.1, 0.2, 0.4], AIRS // 4)),
    *(np.full(AIRS, number) for number in (0.006, 0.03, 0.92, 0.76, 0.2)),
)
"""Airs whose mean light tells how steeply sources fall with height and sun."""
LEAST_SOURCE = 1e-12
"""Darker ones, in the earth's shadow, are the grid's own error."""


@dataclass(frozen=True, eq=False)
class Orders:
    """A solved batch: the air as the orders see it, and its source of all orders from the second on."""

    air: Optics
    scaled: Scaled
    source: np.ndarray
    """Divided by the solver's norm, (heights, views, suns, azimuths, AIRS)."""
    count: int


@dataclass(frozen=True, eq=False)
class Solver:
    """Orders of scattering on a grid; `steepness` (heights, suns) is the log of a source like those to come."""

    places: Places
    steepness: np.ndarray

    @classmethod
    def of(cls, places: Places) -> "Solver":
        """A solver that reads sources divided by those of typical air, so that cubics follow them down to night."""
        required("numba", "fast", "the physical sky's teacher")
        rough = cls(places, np.zeros((places.heights, places.suns)))
        mean = rough.solve(TYPICAL).source.mean(axis=(1, 3))
        return replace(rough, steepness=np.log(np.maximum(mean, LEAST_SOURCE)).mean(axis=-1))

    def solve(self, air: Optics, orders: int = 24, tolerance: float = 6e-3) -> Orders:
        """All orders of a batch, numbers (AIRS,), until what is left is `tolerance` of the whole, or so many."""
        from skydome.own_air.all_air.solver_kernel import SAME, add_ground, sweep

        scaled, rays = Scaled.of(air, self.places.moments), self.rays
        light = self.once(scaled)
        weight = weights(rays, scaled)
        ground = np.asarray(fading(rays.whole, scaled.depth) * scaled.ground / np.pi, dtype=np.float32)
        suns, azimuths, norm, end, end_norm = self.along
        total: np.ndarray | float = 0.0
        before: np.ndarray | None = None
        for order in range(2, orders + 1):
            source = self.harmonics.source(light, mixed(self.places, scaled), self.steepness)
            irradiance = self.harmonics.irradiance(light) * np.exp(-self.steepness[0])[:, None]
            total = total + source
            mean = source.mean(axis=(1, 3))
            tail, last = series_tail(mean, before, total.mean(axis=(1, 3)), tolerance)
            if last or order == orders:
                total = total + source * tail[:, None, :, None, :].astype(np.float32)
                break
            before = mean
            sweep(source, self.starts[0], self.starts[1], suns, azimuths, norm, weight, SAME, light)
            add_ground(irradiance.astype(np.float32), end, end_norm, ground, rays.grounded, light)
        return Orders(air, scaled, np.asarray(total), order)

    def once(self, scaled: Scaled) -> np.ndarray:
        """Light scattered once or thrown back by the ground along all rays, (N, suns, azimuths, AIRS)."""
        places, rays = self.places, self.rays_once
        light = np.zeros((len(self.heights), places.suns, places.azimuths, AIRS), np.float32)
        for n, cosine in enumerate(self.cosines):
            phase = scaled.phase(between(cosine, places.sun_nodes, places.azimuth_nodes))
            scatter_once(rays, n, self.sunlight[n], scaled.depth, scaled.scattering, phase, light[n])
            if rays.grounded[n]:
                lit_ground(rays, n, self.sunlight_below[n], scaled, light[n])
        return light

    def at_ground(
        self,
        orders: Orders,
        sines: np.ndarray,
        cosines: np.ndarray,
        azimuths: np.ndarray,
        nodes: int = 26,
        fine: int = 64,
    ) -> tuple[np.ndarray, np.ndarray]:
        """The rest of the light at the ground and the light scattered once, sr-1, each (V, S, P, AIRS).

        Views as they are seen, suns as they stand.
        Suns by the sine of their elevation (S,), views by cosine to the vertical (V,), azimuths from the sun (P,).
        """
        from skydome.own_air.all_air.solver_kernel import SAME, sweep

        scaled, seen = orders.scaled, seen_sines(sines)
        rays, close = Rays.to_the_eye(cosines, nodes), Rays.to_the_eye(cosines, fine)
        suns, turns, norm = self.places_along(rays, sines, azimuths)
        rest = np.empty((len(cosines), len(sines), len(azimuths), AIRS), np.float32)
        height, view = self.places.height_place(rays.height), self.places.view_place(rays.cosine)
        sweep(orders.source, height, view, suns, turns, norm, weights(rays, scaled), SAME, rest)
        once, cut = np.zeros_like(rest), np.zeros_like(rest)
        for n, cosine in enumerate(cosines):
            sun = Sunlight.of(close.height[n], sun_along(close.arc[n], sines, azimuths)[0])
            phase = exact_phase(orders.air, between(cosine, seen, azimuths))
            scatter_once(close, n, sun, depths(orders.air), scattered(orders.air), phase, once[n])
            whole = scaled.scattering / (1 - scaled.ahead)
            scatter_once(close, n, sun, scaled.depth, whole, phase, cut[n])
        return rest + cut - once, once

    @cached_property
    def harmonics(self) -> Harmonics:
        """From light to the next source."""
        return Harmonics.of(self.places)

    @cached_property
    def heights(self) -> np.ndarray:
        """Where each ray starts, m, (N,)."""
        return np.repeat(self.places.height_nodes, self.harmonics.cosines.shape[1])

    @cached_property
    def cosines(self) -> np.ndarray:
        """Where each ray goes, (N,)."""
        return self.harmonics.cosines.ravel()

    @cached_property
    def rays(self) -> Rays:
        """Rays for light scattered more than once."""
        return Rays.of(self.heights, self.cosines, self.places.nodes)

    @cached_property
    def rays_once(self) -> Rays:
        """Rays for light scattered once."""
        return Rays.of(self.heights, self.cosines, self.places.nodes_once)

    @cached_property
    def starts(self) -> tuple[np.ndarray, np.ndarray]:
        """Places of height and view of the rays' nodes, (N, K)."""
        return self.places.height_place(self.rays.height), self.places.view_place(self.rays.cosine)

    @cached_property
    def sunlight(self) -> list[Sunlight]:
        """On the nodes of `rays_once`, ..."""
        rays, given = self.rays_once, (self.places.sun_nodes, self.places.azimuth_nodes)
        return [Sunlight.of(h, sun_along(arc, *given)[0]) for h, arc in zip(rays.height, rays.arc, strict=True)]

    @cached_property
    def sunlight_below(self) -> list[Sunlight]:
        """... and at their ends on the ground."""
        rays, given = self.rays_once, (self.places.sun_nodes, self.places.azimuth_nodes)
        return [Sunlight.of(np.zeros(1), sun_along(end[None], *given)[0]) for end in rays.end]

    @cached_property
    def along(self) -> tuple[np.ndarray, ...]:
        """Places of sun and azimuth and norm along all rays; place of sun and norm at their ends."""
        places, given = self.places, (self.places.sun_nodes, self.places.azimuth_nodes)
        end = places.sun_place(np.stack([sun_along(end[None], *given)[0][0] for end in self.rays.end]))
        return (*self.places_along(self.rays, *given), end, self.norm(np.zeros_like(end), end))

    def places_along(
        self, rays: Rays, sines: np.ndarray, azimuths: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Places of sun and azimuth, and the norm there, each (N, K, S, P)."""
        suns, turns, norms = [], [], []
        for n, arc in enumerate(rays.arc):
            sun, turn = sun_along(arc, sines, azimuths)
            suns.append(self.places.sun_place(sun))
            turns.append(self.places.azimuth_place(turn))
            row = self.places.height_place(rays.height[n])[:, None, None]
            norms.append(self.norm(np.broadcast_to(row, sun.shape), suns[-1]))
        return np.stack(suns), np.stack(turns), np.stack(norms)

    def norm(self, height: np.ndarray, sun: np.ndarray) -> np.ndarray:
        """What sources were divided by at places of height and sun, (...,)."""
        required("scipy", "fit", "the physical sky's teacher")
        from scipy.ndimage import map_coordinates

        return np.asarray(
            np.exp(map_coordinates(self.steepness, np.stack([height, sun]), order=3, mode="mirror")), dtype=np.float32
        )


def fading(column: np.ndarray, depth: np.ndarray) -> np.ndarray:
    """What is left behind columns (..., 4) of depths (4, AIRS), (..., AIRS)."""
    return np.asarray(np.exp(-np.minimum(column @ depth, 80.0)))


def weights(rays: Rays, scaled: Scaled) -> np.ndarray:
    """What of a source at the rays' nodes comes to their starts, (N, K, AIRS)."""
    scattering = rays.density[..., :3] @ scaled.scattering * rays.step[..., None]
    return np.asarray(scattering * fading(rays.column, scaled.depth), dtype=np.float32)


def mixed(places: Places, scaled: Scaled) -> np.ndarray:
    """Moments of what scatters at each height, (heights, moments, AIRS)."""
    share = density(places.height_nodes)[:, :3, None] * scaled.scattering
    return np.asarray(np.einsum("rcb,clb->rlb", share, scaled.moments) / share.sum(axis=1)[:, None], dtype=np.float32)


def scatter_once(
    rays: Rays,
    n: int,
    sun: Sunlight,
    depth: np.ndarray,
    scattering: np.ndarray,
    phase: np.ndarray,
    out: np.ndarray,
) -> None:
    """Adds what ray n scatters once to `out` (S, P, AIRS)."""
    strength = (rays.density[n, :, :3] * rays.step[n, :, None])[..., None] * scattering
    sun.scattered(rays.column[n], depth, strength, phase, out)


def lit_ground(rays: Rays, n: int, sun: Sunlight, scaled: Scaled, out: np.ndarray) -> None:
    """Adds the sunlight (1, S, P) that the ground throws back along ray n to `out` (S, P, AIRS)."""
    strength, phase = np.zeros((1, 3, AIRS), np.float32), np.zeros((*sun.sine.shape[1:], 3, AIRS), np.float32)
    strength[0, 0], phase[:, :, 0] = scaled.ground, (np.maximum(sun.sine[0], 0.0) / np.pi)[..., None]
    sun.scattered(rays.whole[n : n + 1], scaled.depth, strength, phase, out)


def series_tail(
    mean: np.ndarray, before: np.ndarray | None, total: np.ndarray, tolerance: float
) -> tuple[np.ndarray, bool]:
    """The orders to come over the last as a geometric series, (heights, suns, AIRS), and whether it may be closed."""
    if before is None:
        return np.zeros_like(mean), False
    ratio = np.clip(mean / np.maximum(before, 1e-30), 0, 0.97)
    low = slice(0, len(mean) // 2), slice(mean.shape[1] // 7, None)
    left = (mean[low] / np.maximum(total[low], 1e-30)) * ratio[low]
    return ratio / (1 - ratio), bool(left.max() < 4 * tolerance)
