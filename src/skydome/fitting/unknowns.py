"""What a fit may change: a model's parameters by name, where they start, how far they may go, what a large step is."""

from collections.abc import Mapping, Sequence
from dataclasses import MISSING, dataclass, fields
from typing import Any

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.directions import checked_directions, tangent_frame
from skydome.skies.catalogue import usually_fitted
from skydome.skies.sky import Sky
from skydome.skies.validity import Check

LEVELS = ("scale", "zenith_luminance", "illuminance")
"""Parameters that multiply the light as a whole."""


@dataclass(frozen=True)
class Unknown:
    """A number that a fit looks for: its start, its limits, and the span that a person would call all of it."""

    start: float
    low: float
    high: float
    span: float
    tries: tuple[float, ...] = ()


KNOWN = {
    "turbidity": Unknown(3.0, 1.0, 10.0, 5.0, (2.0, 3.0, 4.5, 6.0, 9.0)),
    "albedo": Unknown(0.2, 0.0, 1.0, 1.0),
    "scale": Unknown(1.0, 0.0, np.inf, 1.0),
    "zenith_luminance": Unknown(5e3, 0.0, np.inf, 5e3),
    "illuminance": Unknown(1.5e4, 0.0, np.inf, 1.5e4),
    "aerosol_depth": Unknown(0.1, 0.0, 1.0, 0.3, (0.03, 0.1, 0.3)),
    "ozone": Unknown(330.0, 0.0, 600.0, 300.0),
    "a": Unknown(-1.0, -20.0, 20.0, 2.0),
    "b": Unknown(-0.3, -20.0, 0.0, 1.0),
    "c": Unknown(5.0, -5.0, 200.0, 10.0),
    "d": Unknown(-2.0, -20.0, 5.0, 5.0),
    "e": Unknown(0.3, -10.0, 20.0, 1.0),
}
"""The parameters that can be looked for, next to "sun". The letters are those of Perez's and the CIE's formula."""


def unknown_of(model: type[Sky], name: str) -> Unknown:
    """The unknown `name`, its limits narrowed to the model's own range: all of it where nothing else is known."""
    interval = model.ranges.get(name) or model.numbers_of_air.get(name)
    if interval is None:
        return KNOWN[name]
    known = KNOWN.get(name)
    if known is None:
        middle, width = (interval.low + interval.high) / 2, interval.high - interval.low
        known = Unknown(middle, interval.low, interval.high, width / 2)
    low, high = max(known.low, interval.low), min(known.high, interval.high)
    tries = tuple(value for value in known.tries if low <= value <= high)
    return Unknown(min(max(known.start, low), high), low, high, known.span, tries)


@dataclass(frozen=True, eq=False)
class Problem:
    """A model with the names that are free and the values of all others; turns vectors of numbers into skies."""

    model: type[Sky]
    free: tuple[str, ...]
    fixed: Mapping[str, Any]
    start: Mapping[str, Any]

    @classmethod
    def of(cls, model: type[Sky], free: Sequence[str] | None, initial: Mapping[str, Any] | None) -> "Problem":
        """The problem as a caller words it; ValueError for names that the model does not have or that nothing fits."""
        require_kind(model, type, "model", "HosekWilkie")
        given = dict({} if initial is None else initial) if isinstance(initial, Mapping | None) else None
        require_kind(given, dict, "initial", '{"turbidity": 3.0}')
        require_kind(free, Sequence | None, "free", '["turbidity"]')
        own = [*(item.name for item in fields(model) if item.name != "check"), *model.numbers_of_air]
        free = usually_fitted(model) if free is None else tuple(free)
        if not free:
            raise ValueError(f"free must name what is to be found of {model.__name__}, from {', '.join(own)}, scale")
        for name in (*free, *given):
            if name not in (*own, "scale"):
                allowed = ", ".join([*own, "scale"])
                raise ValueError(f"{model.__name__} has no parameter {name!r}; allowed are {allowed}")
        known = list(
            dict.fromkeys(
                [*KNOWN, *(name for name, span in model.ranges.items() if span.is_finite), *model.numbers_of_air]
            )
        )
        unfit = [name for name in free if name != "sun" and name not in known]
        if unfit or len(set(free)) < len(free):
            raise ValueError(f"free may name sun, {', '.join(known)}, each once; got {', '.join(free)}")
        if "sun" in given:
            sun = checked_directions(np.asarray(given["sun"], dtype=np.float64), "the initial sun")
            if sun.shape != (3,):
                raise ValueError(f"the initial sun must have shape (3,), got {sun.shape}")
            given["sun"] = sun
        needed = [
            item.name
            for item in fields(model)
            if item.default is item.default_factory is MISSING and item.name not in (*free, *given)
        ]
        if needed:
            raise ValueError(f"{model.__name__} needs {', '.join(needed)}: name them in free, or hold them by initial")
        fixed = {name: value for name, value in given.items() if name not in free}
        return cls(model, free, fixed, {name: value for name, value in given.items() if name in free})

    @property
    def numbers(self) -> tuple[str, ...]:
        """The names of the numbers that are varied: the sun has two, across (level) and up, in radians."""
        sun = ("sun_across", "sun_up") if "sun" in self.free else ()
        return sun + tuple(name for name in self.free if name != "sun")

    @property
    def unknowns(self) -> list[Unknown]:
        """The unknown behind each number."""
        tangent = Unknown(0.0, -1.0, 1.0, 1.0)
        return [tangent if n.startswith("sun_") else unknown_of(self.model, n) for n in self.numbers]

    def values(self, x: np.ndarray, about: np.ndarray) -> dict[str, Any]:
        """Parameters by name from the numbers x (p,), the sun's being steps on the tangent plane at `about` (3,)."""
        found: dict[str, Any] = dict(zip(self.numbers, (float(number) for number in x), strict=True))
        if "sun" in self.free:
            across, up = level_frame(about)
            toward = about + found.pop("sun_across") * across + found.pop("sun_up") * up
            found["sun"] = toward / np.linalg.norm(toward)
        return found

    def sky(self, values: Mapping[str, Any], check: Check = "raise") -> Sky:
        """The sky of the parameters `values`, the fixed ones added, times its scale."""
        everything = dict(self.fixed) | dict(values)
        scale = everything.pop("scale", 1.0)
        sky = self.model.from_numbers(**everything, check=check)
        return sky if isinstance(scale, float) and scale == 1.0 else sky * scale


def level_frame(axis: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Two unit vectors square to `axis` (3,): a level one, to the left of it, and one that points up."""
    across, up = tangent_frame(axis)
    return across, up
