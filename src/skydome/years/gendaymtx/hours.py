"""What gendaymtx reads of a year, and where it puts the sun: a tape of dates, hours and irradiances."""

from os import PathLike
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from skydome.years.weather.calendar import check_dates, month_day_hour, tell_a_cut_day, usual_step
from skydome.years.weather.tape import (
    DEW_POINT,
    FIRST_LINE,
    HORIZONTAL_DIRECT,
    PHOTOMETRIC,
    TITLES,
    read_tape,
)
from skydome.years.weather.text import Text, text_of

if TYPE_CHECKING:
    from skydome.years.weather.weather import Weather

DAYS_BEFORE = np.array([0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334])
SUN_RADIUS = np.radians(0.533 / 2)


class Tape(NamedTuple):
    """What gendaymtx reads of a year: date, standard time, direct normal and diffuse irradiance, dew point, each (T,).

    NaN where an irradiance is missing: such an hour is black. `day_of_year` (T,) is by `days_of_year`. Latitude and
    longitude in degrees, north and east positive; hours east of UTC. `photometric`: illuminances, lx, in the
    irradiances' place.
    """

    month: np.ndarray
    day: np.ndarray
    hour: np.ndarray
    day_of_year: np.ndarray
    direct: np.ndarray
    diffuse: np.ndarray
    dew_point: np.ndarray
    latitude: float
    longitude: float
    utc_offset: float
    photometric: bool = False

    @property
    def missing(self) -> np.ndarray:
        """True where an irradiance is missing, (T,)."""
        unknown: np.ndarray = np.isnan(self.direct) | np.isnan(self.diffuse)
        return unknown

    def rows(self, chosen: np.ndarray) -> "Tape":
        """The hours `chosen` by a mask or indices."""
        names = ("month", "day", "hour", "day_of_year", "direct", "diffuse", "dew_point")
        return self._replace(**{name: getattr(self, name)[chosen] for name in names})


def days_of_year(month: np.ndarray, day: np.ndarray) -> np.ndarray:
    """Day of the year, 1-366, (T,): 29 February is the 60th, and all rows after one count it, as gendaymtx does.

    >>> days_of_year(np.array([2, 2, 3]), np.array([28, 29, 1])).tolist()
    [59, 60, 61]
    """
    leap = (month == 2) & (day == 29)
    after = np.cumsum(leap) > 0
    found: np.ndarray = DAYS_BEFORE[month.astype(np.int64) - 1] + day.astype(np.int64) + (after & ~leap)
    return found


def solar_time(tape: Tape) -> np.ndarray:
    """Hours of solar time, (T,)."""
    day = tape.day_of_year
    correction = 0.170 * np.sin(4 * np.pi / 373 * (day - 80)) - 0.129 * np.sin(2 * np.pi / 355 * (day - 8))
    found: np.ndarray = tape.hour + correction + 12 / 180 * (tape.longitude - 15 * tape.utc_offset)
    return found


def declination(day: np.ndarray) -> np.ndarray:
    """The sun's declination, radians, (T,)."""
    found: np.ndarray = 0.4093 * np.sin(2 * np.pi / 365 * (day - 81))
    return found


def sun_of(tape: Tape, minutes: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """Altitude and azimuth (clockwise from north), radians, each (T,).

    With `minutes` of an interval (`-i`) the sun of a row in which it rises or sets is taken in the lit part.
    """
    hour = within_daylight(tape, solar_time(tape), minutes / 120) if minutes > 0 else solar_time(tape)
    latitude, turn = np.radians(tape.latitude), hour * (np.pi / 12)
    level, rise = np.cos(declination(tape.day_of_year)), np.sin(declination(tape.day_of_year))
    sine = np.sin(latitude) * rise - np.cos(latitude) * level * np.cos(turn)
    south = -np.cos(latitude) * rise - np.sin(latitude) * level * np.cos(turn)
    return np.arcsin(np.clip(sine, -1, 1)), np.pi - np.arctan2(level * np.sin(turn), south)


def within_daylight(tape: Tape, hour: np.ndarray, half: float) -> np.ndarray:
    """Solar time, moved to the middle of the lit part of an interval of twice `half` hours in which the sun turns up.

    Sunrise by the day of the year without leap days, as there.
    """
    day = DAYS_BEFORE[tape.month.astype(np.int64) - 1] + tape.day
    cosine = -np.tan(np.radians(tape.latitude)) * np.tan(declination(day))
    with np.errstate(invalid="ignore"):
        noon_to_set = np.arccos(np.where(np.abs(cosine) <= 1, cosine, np.nan)) * (12 / np.pi)
    rises, sets = 12 - noon_to_set, 12 + noon_to_set
    rising, setting = np.abs(rises - hour) <= half, np.abs(sets - hour) < half
    return np.where(rising, (hour + half + rises) / 2, np.where(setting, (hour - half + sets) / 2, hour))


def in_the_sky(altitude: np.ndarray) -> np.ndarray:
    """True where part of the sun's disc is above the horizon, (T,)."""
    up: np.ndarray = altitude > -SUN_RADIUS
    return up


def tape_of(path: "str | PathLike[str] | Text") -> Tape:
    """The tape in a WEA file, as gendaymtx reads it; units 1 and 2 are irradiances, 3 illuminances.

    A warning tells of a file that is cut short.
    """
    text = text_of(path)
    head, rows = read_tape(text)
    month, day, hour, direct, diffuse = np.ascontiguousarray(rows.T)
    check_dates(month, day, lambda row: f"{text.name}, line {FIRST_LINE + row}")
    wrong = np.flatnonzero((hour < 0) | (hour > 24))
    if wrong.size:
        where = f"{text.name}, line {FIRST_LINE + wrong[0]}, column 3 ({TITLES[2]})"
        raise ValueError(f"{where}: hour must lie in [0, 24], got {hour[wrong[0]]:g}")
    number = days_of_year(month, day)
    tell_of_end(text.name, number, hour)
    units = head["weather_data_file_units"]
    tape = Tape(
        month, day, hour, number, direct, diffuse, np.full(len(rows), DEW_POINT), head["latitude"], -head["longitude"],
        -head["time_zone"] / 15, units == PHOTOMETRIC,
    )  # fmt: skip
    if units != HORIZONTAL_DIRECT:
        return tape
    sine = np.sin(sun_of(tape)[0])
    return tape._replace(direct=np.where(sine > 0, direct / np.maximum(sine, 1e-9), direct))


def tell_of_end(name: str, number: np.ndarray, hour: np.ndarray) -> None:
    """Warn where the tape stops within a day."""
    seconds = np.rint(number * 86400 + hour * 3600).astype(np.int64)
    times = seconds.astype("datetime64[s]") + (np.datetime64("2022-12-31", "s") - np.datetime64(0, "s"))
    tell_a_cut_day(name, times, usual_step(times))


def tape_from(weather: "Weather") -> Tape:
    """The tape that gendaymtx makes of a `Weather`: of an EPW with the mean dew point of three hours, else its own."""
    direct, diffuse = weather.irradiances
    photometric = weather.direct_illuminance is not None and weather.diffuse_illuminance is not None
    if weather.direct_illuminance is not None and weather.diffuse_illuminance is not None:
        direct, diffuse = weather.direct_illuminance, weather.diffuse_illuminance
    direct, diffuse = (np.where(weather.missing, np.nan, value) for value in (direct, diffuse))
    ended = weather.label == "end"
    dew_point = three_hours(weather.dew_point) if ended else np.nan_to_num(weather.dew_point, nan=DEW_POINT)
    month, day, hour = month_day_hour(weather.local)
    return Tape(
        month, day, hour, days_of_year(month, day), direct, diffuse, dew_point, weather.place.latitude,
        weather.place.longitude, weather.utc_offset, photometric,
    )  # fmt: skip


def three_hours(dew_point: np.ndarray) -> np.ndarray:
    """Means of each row's dew point and the two before it, (T,); the last mean where it is missing, 11 before any.

    >>> three_hours(np.array([9.0, 12.0, np.nan, 3.0])).tolist()
    [9.0, 10.0, 10.0, 3.0]
    """
    means, last, before = np.empty(dew_point.size), DEW_POINT, None
    for k, now in enumerate(dew_point.tolist()):
        if now != now:
            before = None
        else:
            earlier, late = before or (now, now)
            last, before = (earlier + late + now) / 3, (late, now)
        means[k] = last
    return means
