"""The sun over some days for any place on the earth: interpolated from one look a day, quick for many instants."""

from dataclasses import dataclass

import numpy as np

from skydome.ground.interpolation import lagrange
from skydome.sun.celestial import local_axes
from skydome.sun.place import Place
from skydome.sun.position import earth_sun_distance, sun_direction

DAY = 86400.0

REFERENCE = Place(0.0, 0.0)
"""There up, east and north are the earth's own axes x, y, z."""


@dataclass(frozen=True, eq=False)
class SunTrack:
    """The sun over some days, for any place on the earth: SPA once a day, cubic interpolation between.

    Held in axes that turn once in 86,400 s, in which the sun moves a degree a day. Within 0.004 degrees of SPA: the
    sun's parallax of the reference place (0.0024) is kept for every place. `distance` (D,), AU, at each midnight, UTC.
    """

    first: float
    slow: np.ndarray
    distance: np.ndarray

    @classmethod
    def over(cls, start: np.datetime64, end: np.datetime64) -> "SunTrack":
        """The track from a day before `start` to a day after `end`."""
        first = start.astype("datetime64[D]") - 2
        days = first + np.arange(int((end.astype("datetime64[D]") - first).astype(np.int64)) + 4)
        local = sun_direction(REFERENCE, days.astype("datetime64[s]"))
        seconds = float(first.astype("datetime64[s]").astype(np.int64))
        slow = np.asfortranarray(local[:, [2, 0, 1]])
        return cls(seconds, slow, np.asarray(earth_sun_distance(days.astype("datetime64[s]"))))

    def distances(self, seconds: np.ndarray) -> np.ndarray:
        """Distance to the sun at the midnight before, AU, (...,)."""
        day: np.ndarray = np.floor((seconds - self.first) / DAY).astype(np.int64)
        return np.asarray(self.distance[day])

    def earth_fixed(self, seconds: np.ndarray) -> np.ndarray:
        """Unit vectors (..., 3) in the earth's axes (longitude 0, longitude 90 east, north) at seconds since 1970."""
        days = (seconds - self.first) / DAY
        before = np.clip(np.floor(days).astype(np.int64), 1, len(self.slow) - 3)
        weights = lagrange(days - (before - 1))
        x, y, z = (
            sum(w * column[before + k] for k, w in zip((-1, 0, 1, 2), weights, strict=True)) for column in self.slow.T
        )
        turn = 2 * np.pi * (days - np.floor(days))
        c, s = np.cos(turn), np.sin(turn)
        toward: np.ndarray = np.stack([c * x + s * y, c * y - s * x, z], axis=-1)
        toward /= np.sqrt(x * x + y * y + z * z)[..., None]
        return toward

    def directions(self, place: Place, seconds: np.ndarray) -> np.ndarray:
        """Unit vectors toward the sun (..., 3), x east, y north, z up, at a place and seconds since 1970 (UTC)."""
        toward: np.ndarray = self.earth_fixed(seconds) @ local_axes(place).T
        return toward
