"""Clear air for measured light: of how much haze its sun and its own diffuse light come near what was measured."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.dome.energy.dark_air import DARK, dark_air
from skydome.dome.energy.weighted import weights_of
from skydome.ground.quadrature import hemisphere
from skydome.ground.tables import columns
from skydome.skies.all_air.sky import WAVELENGTHS, PhysicalSky
from skydome.skies.clouds.fields.air.channels import Channels
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.incident import Incident
from skydome.skies.clouds.fields.lit_field import LitField
from skydome.skies.clouds.fields.low_sun import seen_from
from skydome.skies.clouds.fields.sky import CloudySky
from skydome.skies.suns.sun_disc import SunDisc

HAZES = np.array([0.003, 0.01, 0.02, 0.04, 0.07, 0.1, 0.15, 0.22, 0.3, 0.4, 0.6, 0.9])
"""Optical depths of aerosol at 550 nm that are looked among."""
USUAL_HAZE = 5
FEW, FINER = 4, (0.75, 0.87, 1.15, 1.33)
"""Hazes whose sun is near enough to look at; parts of the best that are looked at too."""
CLOUDLESS = 0.85
"""Share of the clear sun from which on no cloud is taken to stand before it."""
FINE, QUICK = (1, 2, 6, 24), (5, 8, 3, 16)
"""Every so many wavelengths, coarseness, bands, and rings of nodes: of what light is set by, and what it is sought by.
"""
NEAR = 0.1
"""Greatest part by which light may be moved in the end; what needs more is refused."""


@dataclass(frozen=True, eq=False)
class Measure:
    """Energy of a clear sky's light by every so many wavelengths, and of fields of cloud before it."""

    sky: PhysicalSky
    every: int
    coarseness: int
    """Places of a field's shape along a side of the cells in which its light is diffused."""
    bands: int
    """Channels that the spectrum is told in: air and cloud are taken as one colour in each."""
    rings: int
    """Of directions of the dome, twice as many in each."""

    @cached_property
    def channels(self) -> Channels:
        """The whole spectrum's energy, in bands of as much sunlight each."""
        known = columns("spectrl2_gases")["wavelength_nm"]
        known = known[(known >= WAVELENGTHS.low) & (known <= WAVELENGTHS.high)][:: self.every]
        energy = weights_of(self.sky.atmosphere, known, np.ones_like)
        sunlight = np.cumsum(energy * self.sky.atmosphere.sun_at(known))
        band = np.minimum((self.bands * sunlight / sunlight[-1]).astype(int), self.bands - 1)
        return Channels(known, energy[:, None] * np.eye(self.bands)[band])

    @cached_property
    def nodes(self) -> tuple[np.ndarray, np.ndarray]:
        """Directions of the dome and their shares of the horizontal's light."""
        views, solid_angles = hemisphere(self.rings, 2 * self.rings, CloudySky.nodes_about(self.sky.seen_sun)[2])
        return np.asarray(views), np.asarray(solid_angles * views[:, 2])

    @cached_property
    def light(self) -> np.ndarray:
        """Radiance of the nodes by bands, W m-2 sr-1, (D, C)."""
        views = self.nodes[0]
        half = self.sky.radiance(views[: len(views) // 2], self.channels.wavelengths) @ self.channels.weights
        return np.concatenate([half, half])  # the other half mirrors it

    @cached_property
    def alone(self) -> float:
        """Diffuse horizontal irradiance without cloud, W m-2."""
        return float((self.nodes[1] @ self.light).sum())

    def behind(self, field: CloudField) -> float:
        """The same with a field before it."""
        return self.lit(LitField.of(field, seen_from(self.sky, field.middle), self.coarseness))

    def lit(self, lit: LitField) -> float:
        """The same with a lit field."""
        if lit.field.cover <= 0:
            return self.alone
        views, weights = self.nodes
        return float((weights @ Incident(self.sky, lit, self.channels).behind(self.light, views)).sum())


@dataclass(frozen=True, eq=False)
class Clear:
    """A clear sky under a sun, and its energy: by a quick measure to search with, and a fine one.

    `depth`, `darkness`: its aerosol's, as of `dark_air`.
    """

    sky: PhysicalSky
    depth: float
    darkness: float

    @property
    def toward(self) -> np.ndarray:
        """The sun."""
        return np.asarray(self.sky.toward, np.float64)

    @cached_property
    def beam(self) -> float:
        """Direct normal irradiance, W m-2, to 3,900 nm."""
        known = columns("spectrl2_gases")["wavelength_nm"]
        known = known[known <= 3900.0]
        return float(SunDisc.of(self.sky).irradiance(known) @ weights_of(self.sky.atmosphere, known, np.ones_like))

    def off(self, dni: float, dhi: float) -> float:
        """How far the sun's and the sky's own light are from those, the greater as a logarithm."""
        return float(np.abs(np.log([self.beam / dni, self.quick.alone / dhi])).max())

    @cached_property
    def quick(self) -> Measure:
        """To search with."""
        return Measure(self.sky, *QUICK)

    @cached_property
    def fine(self) -> Measure:
        """What the light is set by."""
        return Measure(self.sky, *FINE)


def airs_for(dni: float, dhi: float, sun: np.ndarray, air: Atmosphere) -> Iterator[tuple[Clear, float]]:
    """Clear skies, and the share of their sun that the clouds are to leave (over 1: no cloud), likely ones first.

    The usual air with cloud before the sun, where there is much less of it than that air lets through; air so hazy that
    nothing need stand before the sun; air that by itself comes nearest to both; and the clearest air.
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
        if dhi > same.quick.alone:
            yield same, 1.0
        yield nearest(dni, dhi, air, skies), 2.0
    yield skies[0], min(dni / beams[0], 1.0)


def nearest(dni: float, dhi: float, air: Atmosphere, skies: list[Clear]) -> Clear:
    """The clear sky whose sun and diffuse light come nearest, of airs like those of `skies` or darker."""
    depths = sorted(zip(HAZES, skies, strict=False), key=lambda each: abs(np.log(each[1].beam / dni)))[:FEW]
    tried = [hazy(air, depth, clear.toward, dark) for depth, clear in depths for dark in DARK]
    best = min(tried, key=lambda clear: clear.off(dni, dhi))
    finer = [hazy(air, best.depth * each, best.toward, best.darkness) for each in FINER]
    return min([best, *finer], key=lambda clear: clear.off(dni, dhi))


def hazy(air: Atmosphere, depth: float, sun: np.ndarray, darkness: float = 0.0) -> Clear:
    """The sky of an air with an aerosol of so much depth, and so dark."""
    return Clear(PhysicalSky(sun, dark_air(air, depth, darkness), check="clamp"), depth, darkness)
