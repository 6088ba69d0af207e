"""The sun over some days for any place on the earth: interpolated from one look a day, quick for many instants."""

from dataclasses import dataclass

import numpy as np

from skydome.ground.interpolation import lagrange
from skydome.sun.geocentric import earth_fixed
from skydome.sun.place import Place
from skydome.sun.position import seen_from

DAY = 86400.0


@dataclass(frozen=True, eq=False)
class SunTrack:
    """The sun over some days, for any place on the earth: SPA once a day, cubic interpolation between.

    `slow` (D, 3) is the sun from the earth's centre, AU, at each midnight, UTC, in axes that turn once in 86,400 s, in
    which it moves a degree a day: within 1e-6 degrees of SPA. `distance` (D,), AU, then.

    >>> track = SunTrack.over(np.datetime64("2026-06-21"), np.datetime64("2026-06-22"))
    >>> noon = np.datetime64("2026-06-21T11:31", "s").astype(float)
    >>> track.directions(Place(45.07, 7.69), noon).round(4).tolist()
    [0.0002, -0.3687, 0.9296]
    """

    first: float
    slow: np.ndarray
    distance: np.ndarray

    @classmethod
    def over(cls, start: np.datetime64, end: np.datetime64) -> "SunTrack":
        """The track from a day before `start` to a day after `end`."""
        first = start.astype("datetime64[D]") - 2
        days = first + np.arange(int((end.astype("datetime64[D]") - first).astype(np.int64)) + 4)
        seconds = float(first.astype("datetime64[s]").astype(np.int64))
        slow = np.asfortranarray(earth_fixed(days.astype("datetime64[us]")))
        return cls(seconds, slow, np.linalg.norm(slow, axis=-1))

    def distances(self, seconds: np.ndarray) -> np.ndarray:
        """Distance to the sun at the midnight before, AU, (...,)."""
        day: np.ndarray = np.floor((seconds - self.first) / DAY).astype(np.int64)
        return np.asarray(self.distance[day])

    def earth_fixed(self, seconds: np.ndarray) -> np.ndarray:
        """The sun from the earth's centre, AU (..., 3), as `geocentric.earth_fixed`, at seconds since 1970 (UTC)."""
        days = (seconds - self.first) / DAY
        before = np.clip(np.floor(days).astype(np.int64), 1, len(self.slow) - 3)
        weights = lagrange(days - (before - 1))
        x, y, z = (
            sum(w * column[before + k] for k, w in zip((-1, 0, 1, 2), weights, strict=True)) for column in self.slow.T
        )
        turn = 2 * np.pi * (days - np.floor(days))
        c, s = np.cos(turn), np.sin(turn)
        return np.stack([c * x + s * y, c * y - s * x, z], axis=-1)

    def directions(self, place: Place, seconds: np.ndarray) -> np.ndarray:
        """Unit vectors toward the sun (..., 3), x east, y north, z up, at a place and seconds since 1970 (UTC)."""
        return seen_from(place, self.earth_fixed(seconds))
