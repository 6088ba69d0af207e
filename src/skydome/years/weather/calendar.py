"""Rows of weather on the calendar: the year they are laid in, their local times, the intervals that they stand for."""

from typing import Literal

import numpy as np

Label = Literal["end", "start", "middle", "instant"]
"""Where a row's time stands in the interval that it describes."""

COMMON_YEAR, LEAP_YEAR = 2023, 2024
"""The years that typical years made of several ones are laid in: the leap one where they have a 29 February."""


def calendar_year(years: np.ndarray, months: np.ndarray, days: np.ndarray, year: int | None) -> int:
    """The year in which the rows are laid; ValueError where it has no 29 February and the rows do."""
    leap_day = bool(((months == 2) & (days == 29)).any())
    if year is None:
        one = years.size > 0 and years[0] > 0 and bool((years == years[0]).all())
        year = int(years[0]) if one else LEAP_YEAR if leap_day else COMMON_YEAR
    if leap_day and not (year % 4 == 0 and (year % 100 != 0 or year % 400 == 0)):
        raise ValueError(f"the rows have a 29 February, which {year} has not; give a leap year, such as {LEAP_YEAR}")
    return year


def local_minutes(year: int, months: np.ndarray, days: np.ndarray, minutes: np.ndarray) -> np.ndarray:
    """Local times, datetime64[s], of months, days and minutes since midnight (fractions count), each (T,)."""
    month = np.datetime64(f"{year}", "M") + (months.astype(np.int64) - 1).astype("timedelta64[M]")
    day = month.astype("datetime64[D]") + (days.astype(np.int64) - 1).astype("timedelta64[D]")
    local: np.ndarray = day.astype("datetime64[s]") + np.rint(minutes * 60).astype("timedelta64[s]")
    return local


def interval(times: np.ndarray, seconds: float, label: Label, utc_offset: float) -> tuple[np.ndarray, np.ndarray]:
    """Start and end, UTC datetime64[s], of intervals of `seconds` labelled by local times."""
    before = {"end": 1.0, "middle": 0.5, "start": 0.0, "instant": 0.0}[label] * seconds
    length = 0.0 if label == "instant" else seconds
    start = times - np.timedelta64(round(before + utc_offset * 3600), "s")
    return start, start + np.timedelta64(round(length), "s")


def usual_step(times: np.ndarray) -> float:
    """The most common difference of consecutive times, seconds; an hour for a single row."""
    steps = np.diff(times.astype(np.int64))
    steps = steps[steps > 0]
    if steps.size == 0:
        return 3600.0
    values, counts = np.unique(steps, return_counts=True)
    return float(min(values[np.argmax(counts)], 86400))


def check_dates(months: np.ndarray, days: np.ndarray, first_line: int, name: str) -> None:
    """ValueError with the line of the first row whose month or day does not exist."""
    lengths = np.array([31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31])
    fine = (months >= 1) & (months <= 12) & (months == np.floor(months)) & (days == np.floor(days))
    limit = lengths[np.clip(months, 1, 12).astype(np.int64) - 1]
    wrong = np.flatnonzero(~(fine & (days >= 1) & (days <= limit)))
    if wrong.size:
        k = wrong[0]
        raise ValueError(f"{name}, line {first_line + k}: no such date as month {months[k]:g}, day {days[k]:g}")


def month_day_hour(local: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Month (1-12), day (1-31) and hour (0-24, with fraction) of local times, datetime64[s], each (T,)."""
    midnight, month = local.astype("datetime64[D]"), local.astype("datetime64[M]")
    day = (midnight - month.astype("datetime64[D]")).astype(np.int64) + 1
    return month.astype(np.int64) % 12 + 1, day, (local - midnight).astype(np.int64) / 3600
