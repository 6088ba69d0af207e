"""The search along the course of fields for a diffuse irradiance, with the sun's share that is asked for."""

from dataclasses import dataclass, replace
from typing import Self

import numpy as np

from skydome.dome.energy.cloud_course import COURSE, END, SEEN, leaving, on_course, share_left
from skydome.dome.energy.measured_air import Clear, Measure
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.sky import CloudySky

CLOSE, MET = 0.03, 0.01
"""Parts by which the diffuse irradiance may be off in the end, and in the search."""
TRIES, ROUNDS = 5, 3
BRIGHT = 8
"""Knot from which on the sky is too dark for an open sun."""
HALF = 0.5
OPEN_SUN, HIDDEN_SUN = 0.85, 0.05
"""Shares of the sun above which few clouds are likely, below which many."""


@dataclass(frozen=True, eq=False)
class Step:
    """A place of the course, the field there that leaves the sun's share, and its diffuse irradiance, W m-2."""

    place: float
    field: CloudField
    light: float


@dataclass(frozen=True, eq=False)
class Search:
    """What was found so far, in the order of the course."""

    dhi: float
    share: float
    clear: Clear
    start: CloudField
    found: tuple[Step, ...] = ()
    barred: tuple[float, ...] = ()
    """Places whose field cannot hide the sun so far."""

    @property
    def sun(self) -> np.ndarray:
        """Where the sun is seen."""
        return np.asarray(self.clear.sky.seen_sun, np.float64)

    @property
    def measure(self) -> Measure:
        """What it is sought by."""
        return self.clear.quick if self.share <= 1 else self.clear.fine

    @property
    def last(self) -> float:
        """The end of the course."""
        return float(BRIGHT) if self.share > HALF else END

    def field_at(self, place: float) -> CloudField:
        """The field there, with so much before the sun that its share is left."""
        return leaving(on_course(self.start, place), self.share, self.sun)

    def tried(self, place: float) -> Self:
        """With one more place tried, or barred where the field there cannot hide the sun so far."""
        field = self.field_at(place)
        if field.cover > 0 and share_left(field, self.sun, None) > max(1.05 * self.share, SEEN):
            return replace(self, barred=(*self.barred, place))
        more = Step(place, field, self.measure.behind(field))
        return replace(self, found=tuple(sorted((*self.found, more), key=lambda each: each.place)))

    def off(self, step: Step) -> float:
        """How far the light is off, as a logarithm."""
        return float(np.log(step.light / self.dhi))

    @property
    def best(self) -> Step:
        """The nearest so far."""
        return min(self.found, key=lambda each: abs(self.off(each)))

    def pair(self) -> tuple[Step, Step] | None:
        """Neighbours between which the irradiance lies, such first as have no barred place between them."""
        both = zip(self.found[:-1], self.found[1:], strict=True)
        return min(((a, b) for a, b in both if self.off(a) * self.off(b) <= 0), key=self.is_barred, default=None)

    def is_barred(self, pair: tuple[Step, Step]) -> bool:
        """Whether a barred place lies between neighbours."""
        return any(pair[0].place < place < pair[1].place for place in self.barred)

    def outward(self, first: float | None = None) -> Self:
        """With knots tried from a likely one, or the first, outward, until two hold the light between them."""
        if self.share > 1:
            return self.tried(0.0)
        search = self
        likely = 2.0 if self.share > OPEN_SUN else 4.0 if self.share > HIDDEN_SUN else 9.0
        middle = min(max(round(likely if first is None else first), 1), int(self.last))
        for step in range(len(COURSE)):
            for knot in sorted({middle - step, middle + step}):
                if 1 <= knot <= self.last:
                    search = search.tried(float(knot))
            both = search.pair()
            if both is not None and not search.is_barred(both):
                break
        return search.between()

    def between(self) -> Self:
        """With places tried between those two."""
        search = self
        for _ in range(TRIES):
            both = search.pair()
            if both is None or abs(search.off(search.best)) < MET:
                break
            a, b = both
            part = np.clip(search.off(a) / (search.off(a) - search.off(b)), 0.1, 0.9)
            search = search.tried(a.place + (b.place - a.place) * float(part))
        return search

    def finely(self, step: Step) -> tuple[Step, CloudySky]:
        """A step by the finer grid, moved until its light is near there too."""
        near = sorted(self.found, key=lambda each: abs(each.place - step.place))[:2]
        slope = (self.off(near[1]) - self.off(near[0])) / (near[1].place - near[0].place) if len(near) > 1 else 0.0
        best, place = None, step.place
        for _ in range(ROUNDS):
            field = self.field_at(place) if self.share <= 1 else step.field
            cloudy = CloudySky(self.clear.sky, field)
            now = Step(place, field, self.clear.fine.lit(cloudy.lit))
            if best is None or abs(self.off(now)) < abs(self.off(best[0])):
                best = now, cloudy
            if abs(self.off(now)) < CLOSE or abs(slope) < 0.02 or self.share > 1:
                break
            place = float(np.clip(place - np.clip(self.off(now) / slope, -0.5, 0.5), 0.5, self.last))
        assert best is not None
        return best
