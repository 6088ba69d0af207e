"""What skies by tables of scattered light share: views from any height, spectra and colours from a few wavelengths."""

from abc import abstractmethod
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar, Protocol

import numpy as np

from skydome.air.rays import ColumnTable
from skydome.ground.arrays import Array, floating
from skydome.ground.directions import checked_directions
from skydome.ground.limits.ranges import Range
from skydome.light.spectrum import checked_wavelengths, xyz_weights
from skydome.skies.physical.atmosphere_sky import AtmosphereSky
from skydome.skies.physical.discrete_ordinates import across
from skydome.skies.physical.precomputed.along import scattered_once, sun_at_end
from skydome.skies.physical.precomputed.grid import Shell
from skydome.skies.physical.precomputed.observer import Lines, lines
from skydome.sun.day import is_day

RAYS = 512
"""Rays that are followed at a time."""


class Tables(Protocol):
    """What such a sky asks of its tables."""

    @property
    def wavelengths(self) -> np.ndarray:
        """Wavelengths, nm, (W,)."""

    @property
    def shell(self) -> Shell:
        """The shell of air."""

    def again(self, line: Lines) -> Array:
        """Light (N, W) along lines that is scattered more than once, sr-1."""

    def falling(self, cos_sun: Array) -> Array:
        """Irradiance of the ground under suns (N,), for a sun of 1, (N, W)."""

    def spectrum(self, wavelengths: np.ndarray) -> Array:
        """How light at wavelengths (W,) follows from that at the tables' own, (nodes, W)."""


@dataclass(frozen=True, eq=False)
class TabledSky(AtmosphereSky):
    """A sky seen from a `height` above the ground, m: scattered once along each view, the rest by tables."""

    height: float = 0.0
    bounds: ClassVar = {"height": Range(0.0, 1e9, "m")}
    lowest_sun: ClassVar[float] = -8.0
    quick_to_see: ClassVar[bool] = False

    @property
    @abstractmethod
    def known(self) -> Tables:
        """The tables given, or the sky's own."""

    @cached_property
    def columns(self) -> ColumnTable:
        """Columns of the air."""
        return ColumnTable.of(self.atmosphere, 144, 128)

    @property
    def lowest(self) -> float:
        """Elevation of the lowest sun that the sky's tables hold too, degrees."""
        return self.lowest_sun

    @property
    def is_day(self) -> Array:
        """True where the sun stands above the lowest held, boolean array (...,); in space always."""
        day = np.asarray(is_day(floating(self.sun), self.lowest))
        return day | (self.height > self.atmosphere.height)

    @property
    def direct_normal_illuminance(self) -> Array | float:
        """Illuminance of the sun at that height on a plane that faces it, lx, shape (...,); 0 when it has set there."""
        cosine = np.atleast_1d(np.asarray(self.sun, dtype=np.float64)[..., 2])
        column, blocked = self.columns.look_up(np.full(cosine.shape, min(self.height, self.atmosphere.height)), cosine)
        depths = np.stack([part.depth(self.bands) for part in self.atmosphere.constituents])
        left = np.where(blocked[..., None], 0.0, np.exp(-(np.moveaxis(column, 0, -1) @ depths)))
        level = (left * self.atmosphere.sun_at(self.bands)) @ xyz_weights(self.bands)[:, 1]
        return float(level[0]) if self.one_sun else level

    def seen(self, directions: Array) -> Array:
        """True toward directions (..., 3) that have light: from the ground those above the horizon, else all."""
        return directions[..., 2] >= (0.0 if self.height == 0 else -np.inf)

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction (..., 3), W m-2 sr-1 nm-1, shape (..., W).

        What is scattered again is known at the tables' wavelengths, and at others follows from them; ValueError where
        it cannot.
        """
        w = checked_wavelengths(wavelengths)
        self.tell_missing_bands(wavelengths)
        return self.light(directions, w, self.known.spectrum(w)) * self.atmosphere.sun_at(w)

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction (..., 3), Y in cd m-2, shape (..., 3), from the tables' wavelengths.

        ValueError where those are too few for colours.
        """
        w = self.known.wavelengths
        sunny = self.atmosphere.sun_at(self.bands)[:, None] * xyz_weights(self.bands)
        colours = self.known.spectrum(self.bands) @ sunny
        return np.asarray(self.light(directions, w, np.eye(w.size)) @ colours)

    def light(self, directions: Array, wavelengths: np.ndarray, between: np.ndarray) -> Array:
        """Light (..., W) for a sun of irradiance 1, sr-1; `between` (nodes, W) leads from the tables' wavelengths."""
        views, suns = (
            checked_directions(np.asarray(directions, dtype=np.float64)),
            np.asarray(self.sun, dtype=np.float64),
        )
        shape = np.broadcast_shapes(views.shape, suns.shape)[:-1]
        light = np.zeros((*shape, wavelengths.size))
        for index in map(tuple, np.argwhere(self.is_day)):
            place = across(index, suns.shape[:-1], shape)
            there = np.broadcast_to(views, (*shape, 3))[place]
            found = self.under_one_sun(suns[index], there.reshape(-1, 3), wavelengths, between)
            light[place] = found.reshape(*there.shape[:-1], wavelengths.size)
        return np.maximum(light, 0.0)

    def under_one_sun(self, sun: np.ndarray, views: np.ndarray, wavelengths: np.ndarray, between: np.ndarray) -> Array:
        """Light (N, W) of one sun."""
        shell, found = self.known.shell, np.zeros((len(views), wavelengths.size))
        seen = np.flatnonzero(self.seen(views) & lines(shell, self.height, views, sun).met)
        for start in range(0, len(seen), RAYS):
            part = seen[start : start + RAYS]
            line = lines(shell, self.height, views[part], sun)
            held = line.mu_s >= np.sin(np.radians(self.lowest)) - 1e-12  # as in `is_day`
            found[part] = held[:, None] * (self.known.again(line) @ between) + self.once(line, wavelengths, between)
        return found

    def depths(self, wavelengths: np.ndarray) -> np.ndarray:
        """What light meets of each constituent, as vertical optical depths, (K, W)."""
        return np.stack([part.depth(wavelengths) for part in self.atmosphere.constituents])

    def once(self, line: Lines, wavelengths: np.ndarray, between: np.ndarray) -> Array:
        """Light scattered once, and what the ground throws back, (N, W)."""
        light, left = scattered_once(self.columns, line, wavelengths, self.depths(wavelengths))
        return light + self.from_ground(line, left, wavelengths, between)

    def from_ground(self, line: Lines, left: Array, wavelengths: np.ndarray, between: np.ndarray) -> Array:
        """Light of the ground (N, W) where lines meet it, of which `left` arrives."""
        falling = self.known.falling(sun_at_end(line, self.known.shell.bottom)) @ between
        return np.asarray(line.grounded[:, None] * left * self.atmosphere.albedo_at(wavelengths) / np.pi * falling)
