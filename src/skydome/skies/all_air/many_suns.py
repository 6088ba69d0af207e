"""Many suns some at a time, those of a kind together: night costs nothing, and only twilight pays for twilight."""

from collections.abc import Callable, Iterator
from enum import IntEnum
from typing import Any

import numpy as np

from skydome.ground.arguments import broadcast_shape
from skydome.ground.arrays import Array
from skydome.skies.all_air.blocks import blocks, part_of
from skydome.skies.all_air.fast import Once, chosen, compiled
from skydome.skies.all_air.lit_air import LitAir
from skydome.skies.all_air.rest import MIXED
from skydome.skies.physical.sky_colours import SkyColours, SkySpectrum

LOWEST_SUN = -18.0
"""Elevation of the sun, degrees, from which on it is night: the end of astronomical twilight."""
STEPS = (float(np.sin(np.radians(LOWEST_SUN))), *(float(np.sin(np.radians(edge))) for edge in MIXED))
"""Sines of the elevations at which a kind of sun ends and the next begins."""
FEW, MANY = 1 << 10, 1 << 14
"""Rays at a time: where nodes are made for each ray, or in arrays; and where they are those of the views."""


class Kind(IntEnum):
    """How a sun's light is made."""

    NIGHT = 0
    TWILIGHT = 1
    DUSK = 2
    DAY = 3
    MIXED = 4


def kinds_of(sines: np.ndarray) -> np.ndarray:
    """Kind of the suns along the first axis of their sines (T, ...), (T,).

    >>> kinds_of(np.array([[-0.5, -0.4], [-0.1, -0.1], [0.5, -0.1], [0.5, 0.5]])).tolist()
    [0, 1, 4, 3]
    """
    each = np.searchsorted(STEPS, sines, side="right").reshape(len(sines), -1)
    return np.where((each == each[:, :1]).all(axis=1), each[:, 0], Kind.MIXED)


def by_kind(sun: np.ndarray, shape: tuple[int, ...], compiled: bool) -> Iterator[tuple[Any, ...]]:
    """Indices that cut an array of `shape` under suns (..., 3) into pieces, of one kind of sun each; none of the night.

    A kind's suns need not stand side by side: the first index may be an array. `compiled`: whether light scattered
    once is made by the kernel.
    """
    lone = sun.ndim - 1 < max(len(shape), 1) or len(sun) == 1
    kinds = kinds_of(sun[..., 2].reshape(1, -1) if lone else sun[..., 2])
    for kind in np.unique(kinds[kinds != Kind.NIGHT]):
        most = MANY if compiled and kind in (Kind.DAY, Kind.DUSK) else FEW
        if lone:
            yield from blocks(shape, most)
            continue
        some = np.flatnonzero(kinds == kind)
        for first, *others in blocks((len(some), *shape[1:]), most):
            yield (some[first], *others)


def light_of_many(
    light: Callable[[Array, Array, LitAir, Once], Array],
    sun: np.ndarray,
    views: np.ndarray,
    lit: LitAir,
    ending: SkyColours | SkySpectrum,
) -> np.ndarray:
    """What `ending` makes of light, some views of some suns at a time, in NumPy."""
    columns = () if lit.gases is None else (lit.gases.water, lit.gases.pressure)
    many = [*(number.shape[:-1] for number in (*lit.depths, *lit.shares, *lit.numbers)), *map(np.shape, columns)]
    airs = {f"air {k + 1}": one for k, one in enumerate(many) if one}
    shape = broadcast_shape(directions=views.shape[:-1], sun=sun.shape[:-1], **airs)
    found, once = np.zeros((*shape, ending.width)), chosen(int(np.prod(shape)))
    for block in by_kind(sun, shape, once is compiled):
        here, toward, air = part_of(sun, block), part_of(views, block), lit.part(block)
        found[block] = ending.of_light(light(here, toward, air, once), air.gases, here[..., 2], toward[..., 2])
    return found
