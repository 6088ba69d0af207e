"""The orders of scattering one after the other (Bruneton and Neyret 2008, algorithm 4.1), for all suns at once."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.ground.arrays import Array
from skydome.ground.compiled import shared
from skydome.ground.quadrature import gauss_legendre
from skydome.skies.physical.precomputed.convolution import convolved, ring_cosines, turns
from skydome.skies.physical.precomputed.grid import Shell, Sizes, views
from skydome.skies.physical.precomputed.medium import Medium

CROWDING = 2
"""Power by which the rings of directions crowd at the horizon, where all light of a twilight comes from."""
STEADY = 0.9
"""Most of an order that the next may be where the series is closed."""


@dataclass(frozen=True, eq=False)
class Orders:
    """The nodes of the tables of a shell of air, and the steps from one order to the next."""

    shell: Shell
    sizes: Sizes
    air: Medium

    @property
    def nodes(self) -> tuple[np.ndarray, ...]:
        """Radii (R,), views (R, V), suns (S,), angles (A,)."""
        radii = np.atleast_1d(self.shell.radius(np.linspace(0, 1, self.sizes.heights)))
        suns = self.shell.sun(np.linspace(0, 1, self.sizes.suns))
        return radii, views(self.shell, radii, self.sizes.views), suns, np.linspace(-1, 1, self.sizes.angles)

    @property
    def samples(self) -> tuple[np.ndarray, np.ndarray]:
        """Parts of rays, and their weights."""
        return gauss_legendre(self.sizes.samples)

    @property
    def sphere(self) -> tuple[np.ndarray, np.ndarray, int]:
        """Cosines of the rings of half a sphere, their weights, and half the columns."""
        t, w = gauss_legendre(self.sizes.directions // 4)
        return t**CROWDING, CROWDING * t ** (CROWDING - 1) * w, self.sizes.directions // 2

    @property
    def shape(self) -> tuple[int, ...]:
        """Of a table of light, (R, V, S, A, W)."""
        sizes = self.sizes
        return sizes.heights, sizes.views, sizes.suns, sizes.angles, self.air.albedo.size

    def solve(self, count: int) -> tuple[Array, Array, Array]:
        """Light scattered once (G, ...), more than once (...), and the ground's irradiance (S, W).

        The last of `count` orders stands for all that would come after it, as a geometric series.
        """
        once, light = self.once(), np.zeros(self.shape, np.float32)
        direct = falling = self.direct()
        multiple = np.zeros_like(light)
        before: Array | None = None
        for order in range(1, count):
            source = self.give_off(order, once, light, falling)
            falling = self.fall(order, once, light)
            light = self.again(source)
            multiple += light * (series(light, before) if order == count - 1 else 1.0)
            before = light
        sky = self.fall(1, once, light) + self.fall(2, once, multiple)
        return once, multiple, direct + sky

    def direct(self) -> Array:
        """Irradiance of the ground by the sun alone, (S, W)."""
        from skydome.skies.physical.precomputed.orders_kernel import sunlight_on

        suns = self.nodes[2]
        out = np.empty((suns.size, self.air.albedo.size))
        sunlight_on(0, suns.size, np.full(suns.size, self.shell.bottom), suns, self.air, out)
        return out

    def once(self) -> Array:
        """Light scattered once."""
        from skydome.skies.physical.precomputed.orders_kernel import scatter_once

        out = np.empty((self.air.phases.shape[0], *self.shape), np.float32)
        self.by_heights(scatter_once, *self.nodes, *self.samples, self.air, out)
        return out

    def give_off(self, order: int, once: Array, light: Array, falling: Array) -> Array:
        """What the air gives off of the light of an order, for each phase law, over what scatters."""
        from skydome.skies.physical.precomputed.orders_kernel import arrive

        cosines, weights, columns = self.sphere
        radii, looks, suns, angles = self.nodes
        comes = np.empty((radii.size, suns.size, 2 * cosines.size, columns, self.air.albedo.size), np.float32)
        given = radii, suns, cosines, weights, columns, order, once, light, falling, self.air, comes
        shared(arrive, radii.size, comes.size * 16, given)
        out = np.empty_like(once)
        for i, r in enumerate(radii):
            rings = ring_cosines(self.shell, r, cosines)
            out[:, i] = convolved(comes[i], self.air.phases, rings, looks[i], turns(looks[i], suns, angles))
        return out

    def again(self, source: Array) -> Array:
        """Light of the next order."""
        from skydome.skies.physical.precomputed.orders_kernel import scatter_again

        out = np.empty(self.shape, np.float32)
        self.by_heights(scatter_again, *self.nodes, *self.samples, source, self.air, out)
        return out

    def fall(self, order: int, once: Array, light: Array) -> Array:
        """Irradiance of the ground by the sky's light of an order, (S, W)."""
        return self.fall_on(np.array([self.shell.bottom]), self.nodes[2], order, once, light)[0]

    def fall_on(self, radii: np.ndarray, suns: np.ndarray, order: int, once: Array, light: Array) -> Array:
        """Irradiance of the horizontal at radii (N,) under suns (M,) by the sky's light of an order, (N, M, W).

        Order 1 is the table `once`, any other the table `light`.
        """
        from skydome.skies.physical.precomputed.orders_kernel import fall_on_level

        out = np.empty((radii.size, suns.size, self.air.albedo.size))
        nothing = np.zeros((2, self.air.albedo.size))
        fall_on_level(0, radii.size, radii, suns, *self.sphere, order, once, light, nothing, self.air, out)
        return out

    def by_heights(self, kernel: Any, *given: Any) -> None:
        """A job over the heights, shared among threads."""
        shared(kernel, self.sizes.heights, int(np.prod(self.shape)), given, 1 << 10)


def series(light: Array, before: Array | None) -> Array | float:
    """What an order is to be multiplied by to stand for all that come after it too, by height, sun and wavelength."""
    if before is None:
        return 1.0
    mean, last = (part.mean(axis=(1, 3), keepdims=True) for part in (light, before))
    return np.asarray(1 / (1 - np.clip(mean / np.maximum(last, 1e-30), 0.0, STEADY)), dtype=np.float32)
