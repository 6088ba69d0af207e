"""Clear air for measured light: of how much haze its sun and its own diffuse light come near what was measured."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import cast

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Aerosol
from skydome.dome.energy.weighted import weights_of
from skydome.ground.quadrature import hemisphere
from skydome.ground.tables import columns
from skydome.skies.all_air.sky import WAVELENGTHS, PhysicalSky
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.incident import Channels, Incident
from skydome.skies.clouds.fields.lit_field import LitField
from skydome.skies.suns.sun_disc import SunDisc

HAZES = np.array([0.01, 0.02, 0.04, 0.07, 0.1, 0.15, 0.22, 0.3, 0.4, 0.6, 0.9])
"""Optical depths of aerosol at 550 nm that are looked among."""
USUAL_HAZE = 4
DARK = 0.75
"""Share that aerosol scatters of what it takes, where measured clear skies are darker than of the usual."""
CLOUDLESS = 0.85
"""Share of the clear sun from which on no cloud is taken to stand before it."""
RINGS, AROUND = 48, 96
"""Nodes of the dome."""
NEAR = 0.1
"""Greatest part by which light may be moved in the end; what needs more is refused."""


@dataclass(frozen=True, eq=False)
class Clear:
    """A clear sky under a sun, and its energy."""

    sky: PhysicalSky

    @cached_property
    def channels(self) -> Channels:
        """The whole spectrum's energy."""
        known = columns("spectrl2_gases")["wavelength_nm"]
        known = known[(known >= WAVELENGTHS.low) & (known <= WAVELENGTHS.high)]
        return Channels(known, weights_of(self.sky.atmosphere, known, np.ones_like)[:, None])

    @cached_property
    def beam(self) -> float:
        """Direct normal irradiance, W m-2, to 3,900 nm."""
        known = columns("spectrl2_gases")["wavelength_nm"]
        known = known[known <= 3900.0]
        return float(SunDisc.of(self.sky).irradiance(known) @ weights_of(self.sky.atmosphere, known, np.ones_like))

    @cached_property
    def nodes(self) -> tuple[np.ndarray, np.ndarray]:
        """Directions of the dome and their shares of the horizontal's light."""
        views, solid_angles = hemisphere(RINGS, AROUND)
        return np.asarray(views), np.asarray(solid_angles * views[:, 2])

    @cached_property
    def light(self) -> np.ndarray:
        """Radiance of the nodes, W m-2 sr-1, (D, 1)."""
        light = self.sky.radiance(self.nodes[0], self.channels.wavelengths)
        return np.asarray(light @ self.channels.weights)

    @cached_property
    def alone(self) -> float:
        """Diffuse horizontal irradiance without cloud, W m-2."""
        views, solid_angles = hemisphere(16, 32)
        light = self.sky.radiance(views, self.channels.wavelengths) @ self.channels.weights
        return float((solid_angles * views[:, 2]) @ light[:, 0])

    def diffuse(self, field: CloudField, coarseness: int = 4) -> float:
        """Diffuse horizontal irradiance with a field before it, W m-2."""
        views, weights = self.nodes
        lit = LitField.of(field, self.sky.seen_sun, coarseness)
        return float(weights @ Incident(self.sky, lit, self.channels).behind(self.light, views)[:, 0])


def airs_for(dni: float, dhi: float, sun: np.ndarray, air: Atmosphere) -> Iterator[tuple[Clear, float]]:
    """Clear skies, and the share of their sun that the clouds are to leave, likely ones first.

    The usual air with cloud before the sun, where there is much less of it than that air lets through; air so hazy that
    nothing need stand before the sun; and air that by itself comes nearest to both, under no cloud (share over 1).
    """
    skies = [hazy(air, depth, sun) for depth in HAZES]
    beams = np.array([clear.beam for clear in skies])
    if dni > beams[0] * (1 + NEAR):
        raise ValueError(f"dni must be at most {beams[0]:.0f} W m-2 through the clearest air here, got {dni:g}")
    usual = skies[USUAL_HAZE]
    if dni < CLOUDLESS * usual.beam:
        yield usual, dni / usual.beam
    if dni > beams[-1]:
        same = hazy(air, float(np.interp(-dni, -beams, HAZES)), sun)
        if dhi > same.alone:
            yield same, 1.0
        yield nearest(dni, dhi, [hazy(air, depth, sun, share) for depth in HAZES for share in (None, DARK)]), 2.0


def nearest(dni: float, dhi: float, skies: list[Clear]) -> Clear:
    """The clear sky whose sun and diffuse light come nearest."""
    return min(skies, key=lambda clear: max(abs(np.log(clear.beam / dni)), abs(np.log(clear.alone / dhi))))


def hazy(air: Atmosphere, depth: float, sun: np.ndarray, scattered: float | None = None) -> Clear:
    """The sky of an air with an aerosol of so much depth, of which a share is scattered."""
    low = next(n for n, part in enumerate(air.constituents) if isinstance(part, Aerosol))
    parts = list(air.constituents)
    aerosol = replace(cast(Aerosol, parts[low]), optical_depth=depth)
    parts[low] = aerosol if scattered is None else replace(aerosol, albedo=scattered)
    return Clear(PhysicalSky(sun, replace(air, constituents=tuple(parts)), check="clamp"))
