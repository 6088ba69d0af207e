"""Ozone deeper than the networks were taught, below 325 nm: the rest dims as the light scattered once does.

Ozone lies above most of the scattering, so it dims light of every order much alike: as the light scattered once toward
one view, and a little more. View and surplus are fitted to discrete ordinates, 300-325 nm; docs/models/physical.md.
"""

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import AbsorbingGas
from skydome.ground.arrays import Array, namespace, safe_divide
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.single_scattering import lit_rays
from skydome.skies.all_air.taught_air import Optics

DEEP = 325.0
"""Wavelength, nm, from which on the deepest ozone there is was taught."""
VIEW = float(np.sin(np.radians(36.0)))
"""Sine of the elevation of the view, at a right angle to the sun's azimuth."""
SURPLUS = 0.025
"""How much more the rest is dimmed, for each unit of depth."""


def held_depths(
    air: Atmosphere, wavelengths: np.ndarray, depths: list[Array], known: Optics, taught: Optics
) -> list[Array] | None:
    """Optical depths (..., W) of the constituents with ozone held to what was taught; None beyond `DEEP`."""
    if wavelengths[0] >= DEEP:
        return None
    share = safe_divide(taught.absorbers, known.absorbers)
    absorbs = (isinstance(part, AbsorbingGas) for part in air.constituents)
    return [depth * share if deep else depth for depth, deep in zip(depths, absorbs, strict=True)]


def dimming(tables: ColumnTables, sun: Array, depths: list[Array], held: list[Array], shares: list[Array]) -> Array:
    """What ozone beyond that of `held` depths leaves of the rest, (..., W); `sun` (...,) the sine of its elevation."""
    xp = namespace(sun)
    rays = lit_rays(tables, xp.full_like(sun, VIEW), sun, VIEW * sun)
    full, less = (total(rays.strengths(some), shares) for some in (depths, held))
    beyond = sum((deep - taught for deep, taught in zip(depths, held, strict=True)), 0.0)
    return safe_divide(full, less) * namespace(less).exp(-SURPLUS * beyond)


def total(strengths: list[Array], shares: list[Array]) -> Array:
    """Light scattered once by all constituents alike."""
    scattered = [strength * share for strength, share in zip(strengths, shares, strict=True)]
    return sum(scattered[1:], scattered[0])
