"""Polarised light of lit air: I, Q and U over the intensity without polarisation, scattered once and more than once."""

from collections.abc import Callable

import numpy as np

from skydome.air.phase_laws import PhaseLaw
from skydome.ground.arrays import Array, is_numpy, namespace, safe_divide
from skydome.skies.all_air.blocks import blocks, part_of
from skydome.skies.all_air.lit_air import LitAir
from skydome.skies.all_air.low_aerosol import same
from skydome.skies.all_air.polarised.frame import SunFrame
from skydome.skies.all_air.polarised.network import PolarisedRest

BLOCK = 4096
"""Views at a time, of all suns together."""


def stokes_shares(
    network: PolarisedRest,
    laws: list[PhaseLaw],
    rest: Array,
    once: list[Array],
    lit: LitAir,
    sun: Array,
    seen: Array,
    views: Array,
) -> Array:
    """I, Q and U over the intensity without polarisation, (..., W, 3).

    `rest`: what is scattered more than once, without polarisation; `once`: what each constituent scatters once, per
    phase function, (..., W) each; suns (..., 3) where they stand, and where they are seen, which phase functions go by.
    """
    xp = namespace(sun, views)
    frame, glow, plain = SunFrame.of(sun, views), xp.sum(seen * views, axis=-1), rest
    excess, q, u = (rest * part for part in network.fields(lit.numbers, sun[..., 2], views[..., 2], frame))
    strength = 0.0 * plain
    for law, amount in zip(laws, once, strict=True):
        plain = plain + amount * same(law.value(glow, lit.wavelengths), plain)
        strength = strength + amount * same(law.polarised(glow, lit.wavelengths), plain)
    q_once, u_once = SunFrame.of(seen, views).across(strength)
    stacked = xp.stack(list(xp.broadcast_arrays(plain + excess, q + q_once, u + u_once)), axis=-1)
    return safe_divide(stacked, plain[..., None])


def in_blocks(shares: Callable[[Array, Array, LitAir], Array], sun: Array, views: Array, lit: LitAir) -> Array:
    """Stokes shares (..., W, 3) of suns and views (..., 3) in lit air: in NumPy some of them at a time."""
    if not is_numpy(sun):
        return shares(sun, views, lit)
    shape = np.broadcast_shapes(sun.shape[:-1], views.shape[:-1], *(depth.shape[:-1] for depth in lit.depths))
    found = np.zeros((*shape, len(lit.wavelengths), 3))
    for block in blocks(shape, BLOCK):
        found[block] = shares(part_of(sun, block), part_of(views, block), lit.part(block))
    return found
