"""The teacher of polarised light: successive orders of I, Q and U in the round shells of `all_air.solver`.

The plane of a ray and the vertical is the same all along a straight ray about a round planet, so that Q and U travel
as I does. Molecules polarise; aerosol does not, but passes polarisation on as spheres do. The ground's light is
unpolarised. The plane is that of the ray, the azimuth the sun's where the ray starts.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from skydome.air.phase_functions import rayleigh_polarised
from skydome.own_air.all_air.airs import AIRS
from skydome.own_air.all_air.phases import DEPOLARISATION, Scaled, depths, exact_phase, scattered
from skydome.own_air.all_air.places import Places, between, sun_along
from skydome.own_air.all_air.polarised.spin_harmonics import Light, Matrices, SpinHarmonics
from skydome.own_air.all_air.shells import Rays, density
from skydome.own_air.all_air.solver import Solver, fading, mixed, scatter_once, series_tail, weights
from skydome.own_air.all_air.sunlight import Sunlight, seen_sines
from skydome.skies.all_air.taught_air import Optics

PURITY = (1 - DEPOLARISATION) / (1 + DEPOLARISATION / 2)
"""Share of the molecules' scattering that is that of perfect dipoles (Hansen and Travis 1974, eq. 2.15)."""


class PolarisedOrders(NamedTuple):
    """A solved batch: the air, as the orders see it, and the source of I, Q and U of all orders from the second on."""

    air: Optics
    scaled: Scaled
    source: Light


class PolarisedGround(NamedTuple):
    """Light at the ground, sr-1, (V, S, P, AIRS) each: I, Q and U of the rest, and I that is scattered once."""

    rest: np.ndarray
    q: np.ndarray
    u: np.ndarray
    once: np.ndarray


@dataclass(frozen=True, eq=False)
class PolarisedSolver:
    """Orders of scattering of I, Q and U on the grid of a `Solver`."""

    scalar: Solver

    @cached_property
    def harmonics(self) -> SpinHarmonics:
        """From light to the next source."""
        return SpinHarmonics.of(self.scalar.harmonics)

    def solve(self, air: Optics, orders: int = 24, tolerance: float = 6e-3) -> PolarisedOrders:
        """All orders of a batch, as `Solver.solve`."""
        from skydome.own_air.all_air.solver_kernel import OTHER, SAME, add_ground, sweep

        own, scaled = self.scalar, Scaled.of(air, self.scalar.places.moments)
        matrices, weight = matrices_of(own.places, scaled), weights(own.rays, scaled)
        light: Light = (own.once(scaled), *self.once(scaled))
        ground = np.asarray(fading(own.rays.whole, scaled.depth) * scaled.ground / np.pi, dtype=np.float32)
        suns, azimuths, norm, end, end_norm = own.along
        total: Light = (np.zeros(1, np.float32),) * 3
        before: np.ndarray | None = None
        for order in range(2, orders + 1):
            source = self.harmonics.source(light, matrices, own.steepness)
            irradiance = own.harmonics.irradiance(light[0]) * np.exp(-own.steepness[0])[:, None]
            total = tuple(a + b for a, b in zip(total, source, strict=True))
            mean = source[0].mean(axis=(1, 3))
            tail, last = series_tail(mean, before, total[0].mean(axis=(1, 3)), tolerance)
            if last or order == orders:
                factor = tail[:, None, :, None, :].astype(np.float32)
                total = tuple(a + b * factor for a, b in zip(total, source, strict=True))
                break
            before = mean
            for part, mirror, out in zip(source, (SAME, SAME, OTHER), light, strict=True):
                sweep(part, *own.starts, suns, azimuths, norm, weight, mirror, out)
            add_ground(irradiance.astype(np.float32), end, end_norm, ground, own.rays.grounded, light[0])
        return PolarisedOrders(air, scaled, total)

    def once(self, scaled: Scaled) -> tuple[np.ndarray, np.ndarray]:
        """Q and U that molecules scatter once along all rays, (N, suns, azimuths, AIRS) each."""
        own, places = self.scalar, self.scalar.places
        q, u = (np.zeros((len(own.heights), places.suns, places.azimuths, AIRS), np.float32) for _ in range(2))
        for n, cosine in enumerate(own.cosines):
            found = by_molecules(own.rays_once, n, own.sunlight[n], scaled.depth, scaled.scattering)
            q[n], u[n] = (found * part for part in polarised_phase(cosine, places.sun_nodes, places.azimuth_nodes))
        return q, u

    def at_ground(
        self,
        orders: PolarisedOrders,
        sines: np.ndarray,
        cosines: np.ndarray,
        azimuths: np.ndarray,
        nodes: int = 26,
        fine: int = 64,
    ) -> PolarisedGround:
        """The rest's I, Q and U at the ground: see `Solver.at_ground`."""
        from skydome.own_air.all_air.solver_kernel import OTHER, SAME, sweep

        own, scaled, seen = self.scalar, orders.scaled, seen_sines(sines)
        rays, close = Rays.to_the_eye(cosines, nodes), Rays.to_the_eye(cosines, fine)
        along, weight = own.places_along(rays, sines, azimuths), weights(rays, scaled)
        starts = own.places.height_place(rays.height), own.places.view_place(rays.cosine)
        found = [np.empty((len(cosines), len(sines), len(azimuths), AIRS), np.float32) for _ in range(3)]
        for part, mirror, out in zip(orders.source, (SAME, SAME, OTHER), found, strict=True):
            sweep(part, *starts, *along, weight, mirror, out)
        once = np.zeros_like(found[0])
        whole, true = scaled.scattering / (1 - scaled.ahead), (depths(orders.air), scattered(orders.air))
        for n, cosine in enumerate(cosines):
            sun = Sunlight.of(close.height[n], sun_along(close.arc[n], sines, azimuths)[0])
            phase = exact_phase(orders.air, between(cosine, seen, azimuths))
            scatter_once(close, n, sun, *true, phase, once[n])
            cut = np.zeros_like(once[n])
            scatter_once(close, n, sun, scaled.depth, whole, phase, cut)
            found[0][n] += cut - once[n]
            more = by_molecules(close, n, sun, scaled.depth, whole) - by_molecules(close, n, sun, *true)
            for out, part in zip(found[1:], polarised_phase(cosine, seen, azimuths), strict=True):
                out[n] += more * part
        rest, q, u = found
        return PolarisedGround(rest, q, u, once)


def by_molecules(rays: Rays, n: int, sun: Sunlight, depth: np.ndarray, scattering: np.ndarray) -> np.ndarray:
    """What molecules along ray n scatter once with a phase function of 1, (S, P, AIRS)."""
    shape = sun.sine.shape[1:]
    phase, out = np.zeros((*shape, 3, AIRS), np.float32), np.zeros((*shape, AIRS), np.float32)
    phase[:, :, 0] = 1
    scatter_once(rays, n, sun, depth, scattering, phase, out)
    return out


def polarised_phase(cosine: float, sines: np.ndarray, azimuths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Q and U of molecules' phase function toward a ray for suns and azimuths from them, (S, P, 1) each, sr-1."""
    level, sun_level = np.sqrt(max(1 - cosine**2, 0.0)), np.sqrt(np.maximum(1 - sines**2, 0.0))[:, None]
    up = level * sines[:, None] - cosine * sun_level * np.cos(azimuths)
    left = sun_level * np.sin(azimuths)
    strength = rayleigh_polarised(DEPOLARISATION)
    q, u = strength * (left * left - up * up), -2 * strength * left * up
    return np.asarray(q[..., None], np.float32), np.asarray(u[..., None], np.float32)


def matrices_of(places: Places, scaled: Scaled) -> Matrices:
    """The scattering matrix's moments of what scatters at each height."""
    share = density(places.height_nodes)[:, :3, None] * scaled.scattering
    molecules = np.asarray(share[:, 0] / share.sum(axis=1), np.float32)
    orders = np.arange(places.moments)[None, :, None]
    second, spin = (orders == 2) * np.float32(PURITY), np.float32(1) * (orders >= 2)
    one = mixed(places, scaled)
    others = (one - molecules[:, None] * np.where(orders == 0, 1, second / 10).astype(np.float32)) * spin
    mix, even = (molecules[:, None] * second * np.float32(size) for size in (np.sqrt(6) / 10, 0.6))
    return Matrices(one, mix.astype(np.float32), (others + even).astype(np.float32), others.astype(np.float32))
