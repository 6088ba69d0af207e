"""Daylight in buildings by EN 17037:2018+A1:2021: provision, sunlight, glare. The view stays out.

what | clause | minimum, medium, high
daylight provision | 5.1, A.2, Table A.1 | 300, 500, 750 lx on half of it, 100, 300, 500 lx on 95 %, half the hours
exposure to sunlight | 5.3, A.4, Table A.6 | 1.5, 3, 4 h on a day between 1 February and 21 March, without clouds
protection from glare | 5.4, A.5, Table A.7 | probability .45, .40, .35 exceeded in at most 5 % of the time of use
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.directions import elevation
from skydome.sun.place import Place
from skydome.sun.position import sun_direction
from skydome.surroundings.intervals import Surroundings
from skydome.years.metrics.autonomy import daylight_autonomy

LEVELS = ("", "minimum", "medium", "high")

TARGETS = ((300.0, 100.0), (500.0, 300.0), (750.0, 500.0))
"""Target illuminance and minimum target illuminance, lx (Table A.1)."""

OF_TARGET, OF_MINIMUM, OF_HOURS = 0.5, 0.95, 0.5
"""Shares of the plane, and of the hours of daylight (Table A.1)."""

SUN_HOURS = (1.5, 3.0, 4.0)
"""Table A.6."""

PROBABILITIES, EXCEEDED = (0.45, 0.40, 0.35), 0.05
"""Table A.7."""

FIRST_DAY, LAST_DAY = (2, 1), (3, 21)


@dataclass(frozen=True)
class Provision:
    """Illuminance, lx, that half of the plane (`target`) and 95 % of it (`minimum`) have in half of the hours.

    `level` is the recommendation that both reach: "", "minimum", "medium" or "high".
    """

    target: float
    minimum: float
    level: str


def daylight_provision(light: ArrayLike, hours: ArrayLike) -> Provision:
    """Daylight provision of points (P,) on the reference plane, .85 m high, .5 m off the walls, from light (T, P), lx.

    EN 17037, 5.1.3 method 2: `hours` are the daylight hours (`daylight_hours`), booleans (T,).

    >>> light = np.repeat(np.array([[350.0, 320.0, 310.0, 120.0]]), 10, axis=0)
    >>> daylight_provision(light, np.full(10, True))
    Provision(target=310.0, minimum=120.0, level='minimum')
    """
    values = np.asarray(light, dtype=np.float64)[np.asarray(hours)]
    medians = np.sort(np.quantile(values, 1 - OF_HOURS, axis=0, method="inverted_cdf"))[::-1]
    points = len(medians)
    target, minimum = (float(medians[reached(points, share)]) for share in (OF_TARGET, OF_MINIMUM))
    fulfilled = [
        shares_of_plane(light, hours, high) >= OF_TARGET and shares_of_plane(light, hours, low) >= OF_MINIMUM
        for high, low in TARGETS
    ]
    return Provision(max(target, 0.0) if points else 0.0, minimum, LEVELS[consecutive(fulfilled)])


def reached(points: int, share: float) -> int:
    """Index of the last of the points, from the brightest on, that make up a share of them."""
    return min(points - 1, int(np.ceil(share * points - 1e-9)))


def shares_of_plane(light: ArrayLike, hours: ArrayLike, target: float) -> float:
    """Share of the points that have a target, lx, in at least half of the hours."""
    return float((daylight_autonomy(light, hours, target) >= OF_HOURS).mean())


def consecutive(fulfilled: list[bool]) -> int:
    """How many of the levels, from the lowest, are fulfilled."""
    return next((k for k, done in enumerate(fulfilled) if not done), len(fulfilled))


@dataclass(frozen=True)
class Sunlight:
    """Possible sunshine on a day, `hours`, of the sun above the least elevation, and the `level` that it reaches."""

    hours: float
    level: str


def sunlight_exposure_of_day(
    view: Surroundings, place: Place, day: str, inward: ArrayLike | None = None, lowest: float = 0.0, step: float = 60.0
) -> Sunlight:
    """Hours of possible sunshine at a point on a day ("2026-03-21"), of a clear sky, by EN 17037, 5.3 and Annex D.

    `view` is what the point sees (the inner side of the aperture, 1.2 m above the floor); `inward` (3,) the normal into
    the room: the sun must stand on the other side; `lowest` the sun's least elevation, radians (by city: Table D.1).
    ValueError for a day outside 1 February to 21 March.

    >>> from skydome.surroundings.horizon import Horizon
    >>> sunlight_exposure_of_day(Horizon.level(0.1), Place(45.0, 8.0), "2026-03-21").level
    'high'
    """
    date = np.datetime64(day, "D")
    month, number = (int(part) for part in str(date).split("-")[1:])
    if not FIRST_DAY <= (month, number) <= LAST_DAY:
        raise ValueError(f"the day must lie between 1 February and 21 March, got {day}")
    noon = date.astype("datetime64[s]") + np.timedelta64(round(43200 - place.longitude * 240), "s")
    seconds = noon - np.timedelta64(43200, "s") + (np.arange(0, 86400, step) + step / 2).astype("timedelta64[s]")
    suns = sun_direction(place, seconds)
    seen = (view.seen(suns) == -1) & (elevation(suns) > lowest)
    if inward is not None:
        seen &= suns @ np.asarray(inward, dtype=np.float64) < 0
    hours = float(seen.sum() * step / 3600)
    return Sunlight(hours, LEVELS[consecutive([hours >= least for least in SUN_HOURS])])


def glare_level(probabilities: ArrayLike, hours: ArrayLike) -> tuple[float, str]:
    """The glare probability exceeded in 5 % of the hours of use, and the protection that it reaches (5.4, Table A.7).

    >>> glare_level(np.array([0.2] * 96 + [0.5] * 4), np.full(100, True))
    (0.2, 'high')
    """
    values = np.asarray(probabilities, dtype=np.float64)[np.asarray(hours)]
    exceeded = float(np.quantile(values, 1 - EXCEEDED, method="inverted_cdf"))
    return exceeded, LEVELS[consecutive([exceeded <= most for most in PROBABILITIES])]
