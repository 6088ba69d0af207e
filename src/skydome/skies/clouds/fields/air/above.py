"""The air above a height, and the light of its sky on the field of cloud below it."""

from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.quadrature import hemisphere
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.clouds.fields.air.lower import escape

RINGS, COLUMNS = 8, 16
"""Nodes of the sky's light on the field."""
BRIGHT = 0.8
"""Albedo of the ground under the brighter of two skies."""


def air_above(air: Atmosphere, height: float, albedo: float) -> Atmosphere:
    """The air above a height, m, as if ground of an albedo lay there."""
    shares = ColumnTables.of(air).toward(np.array(height), np.array(1.0))
    parts = tuple(part.of_share(float(share)) for part, share in zip(air.constituents, shares, strict=True))
    gases = None if air.gases is None else air.gases.above(height)
    return replace(air, constituents=parts, albedo=albedo, gases=gases)


class Skylight(NamedTuple):
    """Irradiance of the sky on the horizontal at a field, W m-2 nm-1, (W,)."""

    whole: np.ndarray
    thick: np.ndarray
    """The even light of which thick cloud would let as much through."""

    def even(self, free: float) -> np.ndarray:
        """The even light of which a field of an open share would let as much through."""
        return np.asarray(self.thick + (self.whole - self.thick) * free)


def skylight(clear: Any, height: float, wavelengths: np.ndarray, beam: np.ndarray, mirrored: np.ndarray) -> Skylight:
    """Light of a `clear` sky at a height, m, over what sends a share `mirrored` (W,) back.

    `beam`: irradiance of the sun there, on the horizontal. The air above sends a share s of what it gets from below
    back: sun and sky together go as 1 / (1 - s albedo).
    """
    nodes, solid_angles = hemisphere(RINGS, COLUMNS)
    level = solid_angles * nodes[:, 2]
    dark, bright = (
        replace(clear, atmosphere=air_above(clear.atmosphere, height, albedo), check="clamp").radiance(
            nodes, wavelengths
        )
        for albedo in (0.0, BRIGHT)
    )
    none, much = level @ dark + beam, level @ bright + beam
    back = (1 - none / np.maximum(much, 1e-30)) / BRIGHT
    sky = none / (1 - back * mirrored) - beam
    return Skylight(sky, sky * (level * escape(nodes[:, 2]) @ dark) / np.maximum(level @ dark, 1e-30))
