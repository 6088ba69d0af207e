"""Clouds that drift through a day of measured light: the same field, moved by its wind, its cover going smoothly."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.dome.energy.measured_air import hazy
from skydome.dome.energy.measured_clouds import MeasuredClouds
from skydome.dome.energy.nearest_clouds import nearest_clouds, on_place
from skydome.skies.all_air.taught_air import clear_air
from skydome.skies.clouds.fields.field import CloudField


@dataclass(frozen=True)
class Row:
    """What was measured about a moment: `seconds` since 1970, the `sun` (3,) then, W m-2."""

    seconds: float
    sun: tuple[float, float, float]
    dni: float
    dhi: float


@dataclass(frozen=True)
class Anchor:
    """What was found for a row: the place on the course, the air's haze, and why its factors are large, if they are."""

    place: float
    haze: float
    darkness: float
    why: str


@dataclass(frozen=True, eq=False)
class DriftingClouds:
    """The sky at any moment of a day of rows of measured light, whose clouds drift with the wind of the field `start`.

    Clouds and haze are sought for each row; between rows they change evenly, and what stands before the sun is made
    thicker or thinner until it leaves the moment's own direct light.

    >>> import skydome as sd
    >>> sun = (0.0, -0.6, 0.8)
    >>> day = DriftingClouds((Row(0.0, sun, 420.0, 210.0),), CloudField(seed=7, wind=(5.0, 0.0)))
    >>> found, _ = day.at(60.0, sun, 430.0, 205.0)
    >>> found.field.place, bool(abs(found.diffuse_factor - 1) < 0.2)
    ((-300.0, 0.0), True)
    """

    rows: tuple[Row, ...]
    start: CloudField
    known: dict[int, Anchor] = field(default_factory=dict)

    def at(
        self, seconds: float, sun: Any, dni: float, dhi: float, air: Atmosphere | None = None
    ) -> tuple[MeasuredClouds, str]:
        """The sky that carries `dni` and `dhi` then, as `nearest_clouds`; and why a row beside it has large factors."""
        air = clear_air() if air is None else air
        place, haze, darkness, why = self.between(seconds, air)
        clear = hazy(air, haze, np.asarray(sun, np.float64), darkness)
        return on_place(dni, dhi, clear, self.start.later(seconds - self.rows[0].seconds), place), why

    def between(self, seconds: float, air: Atmosphere) -> tuple[float, float, float, str]:
        """Place, haze and darkness of the air then, between the anchors before and after; why a row is none."""
        times = np.array([row.seconds for row in self.rows])
        after = int(np.clip(np.searchsorted(times, seconds), 0, len(times) - 1))
        before = max(after - 1, 0) if seconds < times[after] else after
        a, b = self.anchor(before, air), self.anchor(after, air)
        part = float(np.clip((seconds - times[before]) / max(times[after] - times[before], 1.0), 0.0, 1.0))
        haze, why = a.haze * (b.haze / a.haze) ** part, (b if part > 0.5 else a).why
        return a.place + (b.place - a.place) * part, haze, a.darkness + (b.darkness - a.darkness) * part, why

    def anchor(self, index: int, air: Atmosphere) -> Anchor:
        """What carries a row's light."""
        if index not in self.known:
            row = self.rows[index]
            there = self.start.later(row.seconds - self.rows[0].seconds)
            found, why = nearest_clouds(row.dni, row.dhi, row.sun, there, air)
            self.known[index] = Anchor(found.place, found.haze, found.darkness, why)
        return self.known[index]
