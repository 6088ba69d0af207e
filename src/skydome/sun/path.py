"""The sun's path through a day, to be drawn on a sky or read as a table."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from skydome.ground.directions import azimuth, elevation
from skydome.ground.extras import required
from skydome.ground.limits.ranges import Range, require, require_one
from skydome.ground.units import deg
from skydome.sun.events import calendar_date
from skydome.sun.place import Place
from skydome.sun.position import sun_direction

if TYPE_CHECKING:
    from matplotlib.axes import Axes


STEPS = Range(0.1, 120.0, "minutes")
"""Between the points of a path."""


@dataclass(frozen=True, eq=False)
class SunPath:
    """The sun toward `directions` (N, 3) at `times` (N,), datetime64, UTC, seen from a place.

    >>> path = sun_path(Place(45.07, 7.69), "2026-06-21")
    >>> round(float(path.elevations.max()), 1), round(path.daylight_hours, 1)
    (68.4, 15.4)
    """

    place: Place
    times: np.ndarray
    directions: np.ndarray

    @property
    def elevations(self) -> np.ndarray:
        """Elevation of the sun's centre, degrees, (N,)."""
        return np.asarray(elevation(self.directions)) / deg

    @property
    def azimuths(self) -> np.ndarray:
        """Azimuth, degrees clockwise from north, (N,)."""
        return np.asarray(azimuth(self.directions)) / deg

    @property
    def daylight_hours(self) -> float:
        """Hours with the sun's centre above the horizon, without refraction."""
        return 24.0 * float((self.directions[:, 2] > 0).mean())

    def plot(self, ax: "Axes | None" = None, **style: Any) -> "Axes":
        """The path above the horizon on a sky's axes (`ax=sky.plot()`), looking up, else elevation by azimuth.

        Axes without a picture, and those of its own where `ax` is None, show elevation by azimuth.
        `style` is what Matplotlib's lines take.
        """
        required("matplotlib", "plot", "a plot")
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

        up = self.directions[:, 2] > 0
        height, turn = np.where(up, self.elevations, np.nan), self.azimuths * deg
        if ax is None:
            figure = Figure(figsize=(7, 3.5), layout="constrained")
            FigureCanvasAgg(figure)
            ax = figure.add_subplot()
        if not ax.images:
            ax.plot(self.azimuths, height, **style)
            ax.set(xlabel="azimuth, degrees from north", ylabel="elevation, degrees", xlim=(0, 360), ylim=(0, 90))
            return ax
        radius = 1 - height / 90
        drawn: dict[str, Any] = {"color": "white", "lw": 1.4, "zorder": 4} | style
        ax.plot(-radius * np.sin(turn), radius * np.cos(turn), **drawn)
        return ax


def sun_path(place: Place, day: Any, step: float = 5.0) -> SunPath:
    """The `SunPath` of a day, an ISO date or datetime64, every `step` minutes from one mean solar midnight to the next.

    The day is that of the place's own meridian, so that no time zone is asked for. ValueError for a step outside
    0.1-120 minutes.

    >>> sun_path(Place(-33.9, 151.2), "2026-12-21", step=30).times.shape
    (48,)
    """
    Place.required(place)
    require("step", step, STEPS)
    require_one("step", step)
    ahead = np.timedelta64(round(place.longitude * 240e3), "ms")
    midnight = np.datetime64(calendar_date(day), "D").astype("datetime64[ms]") - ahead
    count = round(1440 / step)
    times = midnight + (np.arange(count) * 86_400_000 // count).astype("timedelta64[ms]")
    return SunPath(place, times, sun_direction(place, times))
