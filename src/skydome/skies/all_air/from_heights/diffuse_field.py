"""The light inside an atmosphere: what comes to every height from all sides under every sun, as Legendre moments."""

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Self

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.rays import ColumnTable
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array
from skydome.light.spectrum import checked_wavelengths
from skydome.skies.all_air.from_heights.blunted import BluntedAir
from skydome.skies.all_air.from_heights.harmonics import associated
from skydome.skies.all_air.from_heights.layers import FlatLayers
from skydome.skies.all_air.from_heights.views import Places, roots
from skydome.skies.physical.precomputed.grid import Shell, shell_of
from skydome.skies.physical.precomputed.observer import Lines
from skydome.skies.physical.precomputed.tables import LOWEST_SUN, spectrum_of_tables

TERMS = 12
"""Legendre moments, and waves in the azimuth."""
SUNS = np.sign(EVEN := np.linspace(-2.45, np.sqrt(90.0), 48)) * EVEN**2
"""Elevations of the suns, degrees: even in their roots."""


@dataclass(frozen=True, eq=False)
class DiffuseField:
    """Light inside an `atmosphere` at `wavelengths` (W,), for a sun of irradiance 1, at all heights under all suns.

    Light scattered to and fro goes through flat layers, sunlight and views through round ones. Every order at once: a
    linear equation for the moments at all heights, one for each wave in the azimuth.

    >>> import skydome as sd
    >>> field = DiffuseField.of(sd.Atmosphere.standard(), [450.0, 650.0])
    >>> sunlit = field.falling(np.sin(np.radians([5.0, 60.0])))  # irradiance of the ground, sun and sky
    >>> sunlit.round(2).tolist()
    [[0.04, 0.05], [0.77, 0.82]]
    """

    atmosphere: Atmosphere
    wavelengths: np.ndarray
    air: BluntedAir = field(repr=False)
    columns: ColumnTable = field(repr=False)
    moments: np.ndarray = field(repr=False)
    """Of light that comes from all sides: for each wave m of the azimuth those of degrees m ... L - 1, all in a row,
    (heights, suns, L (L + 1) / 2, W).
    """
    ground: np.ndarray = field(repr=False)
    """Irradiance of the ground, sun and sky together, (suns, W)."""

    @classmethod
    def of(cls, atmosphere: Atmosphere, wavelengths: Any) -> Self:
        """The field at wavelengths (W,) nm, of one air without layers of cloud."""
        require_kind(atmosphere, Atmosphere, "atmosphere", "Atmosphere.standard()")
        atmosphere.require_no_layers(cls.__name__)
        atmosphere.require_one(cls.__name__)
        w = checked_wavelengths(wavelengths)
        air = BluntedAir.of(atmosphere, w, TERMS)
        layers, suns = FlatLayers(air), sines()
        table = ColumnTable.of(atmosphere, 144, 128)
        sunny = sunlight(table, air, layers.inside, suns)
        level = sunlight(table, air, np.zeros(1), suns)[:, 0] * np.maximum(suns, 0.0)[:, None]
        ground, first = even(layers, sunny, level)
        waves = [first, *(waving(layers, sunny, wave) for wave in range(1, TERMS))]
        moments = np.concatenate([np.moveaxis(wave, (0, 3), (3, 1)) for wave in waves], axis=2)
        return cls(atmosphere, w, air, table, np.ascontiguousarray(moments), ground.T)

    @cached_property
    def shell(self) -> Shell:
        """The shell of air."""
        return shell_of(self.atmosphere, LOWEST_SUN)

    @cached_property
    def heights(self) -> np.ndarray:
        """Heights of the moments, m."""
        return FlatLayers(self.air).heights

    def again(self, line: Lines) -> Array:
        """Light (N, W) along lines that is scattered more than once, sr-1."""
        return Places.of(self.air, line, self.heights, SUNS).seen(self.air, self.moments)

    def falling(self, cos_sun: Array) -> Array:
        """Irradiance of the ground under suns (N,), sun and sky together, for a sun of 1, (N, W)."""
        elevation = np.degrees(np.arcsin(np.clip(cos_sun, -1.0, 1.0)))
        return np.stack([np.interp(roots(elevation), roots(SUNS), light) for light in self.ground.T], axis=-1)

    def spectrum(self, wavelengths: np.ndarray) -> Array:
        """How light at wavelengths (W,) follows from that at the field's own, (nodes, W)."""
        return spectrum_of_tables(self.wavelengths, wavelengths)


def sines() -> np.ndarray:
    """Sines of the elevations of the suns, (S,)."""
    return np.asarray(np.sin(np.radians(SUNS)))


def sunlight(table: ColumnTable, air: BluntedAir, heights: np.ndarray, suns: np.ndarray) -> Array:
    """What is left of sunlight at heights (F,), (S, F, W)."""
    column, blocked = table.look_up(*np.broadcast_arrays(heights, suns[:, None]))
    return np.where(blocked[..., None], 0.0, np.exp(-(np.moveaxis(column, 0, -1) @ air.depths)))


def scattered_first(layers: FlatLayers, sunny: Array, wave: int) -> Array:
    """Moments of the direction of sunlight at the nodes, (W, F (L - m), S)."""
    functions = associated(TERMS, wave, sines())
    light = (1 if wave == 0 else 2) / (2 * np.pi) * np.einsum("ls,sfw->wfls", functions, sunny)
    return light.reshape(light.shape[0], -1, light.shape[-1])


def waving(layers: FlatLayers, sunny: Array, wave: int) -> Array:
    """Moments of one wave in the azimuth, (W, H, L - m, S)."""
    sent = layers.sent(wave)
    first = sent.reshape(*sent.shape[:1], -1, sent.shape[-2] * sent.shape[-1]) @ scattered_first(layers, sunny, wave)
    returns = layers.of_heights(sent).reshape(len(first), first.shape[1], -1)
    found = np.linalg.solve(np.eye(first.shape[1]) - returns, first)
    return found.reshape(*sent.shape[:3], -1)


def even(layers: FlatLayers, sunny: Array, level: Array) -> tuple[Array, Array]:
    """Irradiance of the ground (W, S) and the moments that are alike at all azimuths, (W, H, L, S).

    `level` (S, W): sunlight on the level ground. The irradiance is one more unknown beside the moments.
    """
    sent, source = layers.sent(0), scattered_first(layers, sunny, 0)
    many = len(source)
    first = sent.reshape(many, -1, sent.shape[-2] * sent.shape[-1]) @ source
    falls, count = layers.falling(), first.shape[1]
    bright = layers.air.atmosphere.albedo_at(layers.air.wavelengths) / np.pi
    equation = np.zeros((many, count + 1, count + 1))
    equation[:] = np.eye(count + 1)
    equation[:, :-1, :-1] -= layers.of_heights(sent).reshape(many, count, count)
    equation[:, :-1, -1] = -bright[:, None] * layers.rising().reshape(many, -1)
    equation[:, -1, :-1] = -layers.of_heights(falls).reshape(many, -1)
    known = np.concatenate([first, level.T[:, None] + falls.reshape(many, 1, -1) @ source], axis=1)
    found = np.linalg.solve(equation, known)
    return found[:, -1], found[:, :-1].reshape(*sent.shape[:3], -1)
