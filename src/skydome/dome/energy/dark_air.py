"""Air that sends down less diffuse light than the usual: aerosol that absorbs, and soot over dark ground."""

from dataclasses import replace
from typing import Any, cast

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Aerosol
from skydome.air.phase_laws import HenyeyGreenstein
from skydome.light.spectrum import Spectrum

DARK = (0.0, 0.5, 1.0, 2.0)
"""Darknesses that are looked among, the usual air first."""
ABSORBING = 0.6
"""Share that aerosol scatters of what it takes, at a darkness of 1."""
SOOT, GROUND = 0.5, 0.5
"""Its asymmetry at a darkness of 2, and the share of the ground's albedo that is left there."""


def dark_air(air: Atmosphere, depth: float, darkness: float) -> Atmosphere:
    """The air with an aerosol of so much depth at 550 nm, `darkness` from 0, the air's own, over 1 to 2.

    Up to 1 the aerosol scatters less of what it takes; on to 2 it is made of ever smaller grains, which scatter to all
    sides, and the ground is darker.

    >>> from skydome.skies.all_air.taught_air import clear_air
    >>> [round(float(dark_air(clear_air(), 0.1, dark).albedo_at([550.0])[0]), 2) for dark in (1.0, 2.0)]
    [0.2, 0.1]
    """
    low = next(n for n, part in enumerate(air.constituents) if isinstance(part, Aerosol))
    parts = list(air.constituents)
    aerosol = replace(cast(Aerosol, parts[low]), optical_depth=depth)
    first, second = min(darkness, 1.0), max(darkness - 1.0, 0.0)
    if first > 0:
        usual = float(np.asarray(aerosol.scattered([550.0]))[0])
        aerosol = replace(aerosol, albedo=usual + (min(ABSORBING, usual) - usual) * first)
    if second > 0:
        mean = float(np.asarray(aerosol.phase_law.mean_cosine([550.0]))[0])
        aerosol = replace(aerosol, phase=HenyeyGreenstein((mean + (min(SOOT, mean) - mean) * second,)))
    parts[low] = aerosol
    return replace(air, constituents=tuple(parts), albedo=darker(air.albedo, 1 - (1 - GROUND) * second))


def darker(albedo: Any, share: float) -> Any:
    """A share of an albedo, a number or a `Spectrum`."""
    if isinstance(albedo, Spectrum):
        return replace(albedo, values=share * np.asarray(albedo.values))
    return albedo * share
