"""Rows of weather on the calendar: the years they are laid in, their local times, the intervals that they stand for."""

import re
import warnings
from collections.abc import Callable, Sequence
from typing import Literal, get_args

import numpy as np

from skydome.ground.arrays import brief

Label = Literal["end", "start", "middle", "instant"]
"""Where a row's time stands in the interval that it describes."""

COMMON_YEAR, LEAP_YEAR = 2023, 2024
"""The years that typical years made of several ones are laid in: the leap one where they have a 29 February."""

HALF_A_YEAR = 6
"""Months by which the rows step back where they pass from one year into the next."""


def check_label(label: str) -> None:
    """ValueError for what is none of the labels."""
    if not isinstance(label, str) or label not in get_args(Label):
        raise ValueError(f'label must be "end", "start", "middle" or "instant", got {brief(label, typed=False)}')


def laid_years(years: np.ndarray, months: np.ndarray, days: np.ndarray, year: int | None) -> np.ndarray:
    """The calendar year (T,) in which each row is laid; ValueError where it has no 29 February and the rows do.

    The file's own years where they follow one another. Else (typical years, years of 0) one year, and the next one
    where the rows pass from December into January. `year` lays the first row in that one.
    """
    leap_day = (months == 2) & (days == 29)
    if year is None and follow_one_another(years, months):
        laid = years.astype(np.int64)
    else:
        passed = np.concatenate([[0], np.cumsum(np.diff(months) <= -HALF_A_YEAR)])[: months.size]
        leap = LEAP_YEAR - int(passed[leap_day][0]) if leap_day.any() else COMMON_YEAR - int(passed.max(initial=0))
        laid = passed + (leap if year is None else year)
    wrong = np.flatnonzero(leap_day & ~((laid % 4 == 0) & ((laid % 100 != 0) | (laid % 400 == 0))))
    if wrong.size:
        raise ValueError(
            f"the rows have a 29 February, which {laid[wrong[0]]} has not; give a leap year, such as {LEAP_YEAR}"
        )
    return laid


def follow_one_another(years: np.ndarray, months: np.ndarray) -> bool:
    """True where the years given are those of one course of time: each new one comes later, at an earlier month.

    The months of a typical year come from several years, and go on where the year changes.
    """
    change = np.diff(years)
    turns = change != 0
    return bool((years > 0).all() and (change >= 0).all() and (np.diff(months)[turns] < 0).all())


def local_minutes(years: "np.ndarray | int", months: np.ndarray, days: np.ndarray, minutes: np.ndarray) -> np.ndarray:
    """Local times, datetime64[s], of years, months, days and minutes since midnight (fractions count), each (T,)."""
    year = (np.asarray(years, dtype=np.int64) - 1970).astype("datetime64[Y]").astype("datetime64[M]")
    month = year + (months.astype(np.int64) - 1).astype("timedelta64[M]")
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


def check_dates(months: np.ndarray, days: np.ndarray, where: Callable[[int], str]) -> None:
    """ValueError that says `where` the first row is whose month or day does not exist."""
    lengths = np.array([31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31])
    fine = (months >= 1) & (months <= 12) & (months == np.floor(months)) & (days == np.floor(days))
    limit = lengths[np.clip(months, 1, 12).astype(np.int64) - 1]
    wrong = np.flatnonzero(~(fine & (days >= 1) & (days <= limit)))
    if wrong.size:
        k = int(wrong[0])
        raise ValueError(f"{where(k)}: no such date as month {months[k]:g}, day {days[k]:g}")


def month_day_hour(local: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Month (1-12), day (1-31) and hour (0-24, with fraction) of local times, datetime64[s], each (T,)."""
    midnight, month = local.astype("datetime64[D]"), local.astype("datetime64[M]")
    day = (midnight - month.astype("datetime64[D]")).astype(np.int64) + 1
    return month.astype(np.int64) % 12 + 1, day, (local - midnight).astype(np.int64) / 3600


def year_of(local: np.ndarray) -> np.ndarray:
    """Calendar year of local times, datetime64[s], (T,)."""
    return local.astype("datetime64[Y]").astype(np.int64) + 1970


def relaid(starts: np.ndarray, year: int | None) -> np.ndarray:
    """Local times, datetime64[s], (T,), of whatever years, laid in years that follow one another (`laid_years`)."""
    months, days, hours = month_day_hour(starts)
    return local_minutes(laid_years(year_of(starts), months, days, year), months, days, hours * 60)


def tell_missing_rows(name: str, ends: np.ndarray, periods: Sequence[str], per_hour: int) -> None:
    """Warn where rows are missing of the periods that a header names by their first and last days.

    `ends` (T,) are the local ends of the rows; `periods` the cells "first day, last day" of each, four apart.
    """
    whole = 0
    for first, last in zip(periods[0::4], periods[1::4], strict=False):
        length = days_from(day_of(first), day_of(last))
        if length is None:
            return
        whole += length * 24 * per_hour
    months, days, _ = month_day_hour(ends - np.timedelta64(1, "s"))
    whole += 24 * per_hour * ((whole == 8760 * per_hour) and bool(((months == 2) & (days == 29)).any()))
    lacking = whole - len(ends)
    if lacking > 0:
        last_time = str(ends[-1].astype("datetime64[m]")).replace("T", " ")
        warnings.warn(
            f"{name}: {lacking} of the {whole} rows are missing of the period that the header names "
            f"({periods[0].strip()} to {periods[1].strip()}); the last row ends at {last_time}",
            stacklevel=4,
        )


def day_of(text: str) -> tuple[int, int, int] | None:
    """Year (0 where there is none), month and day of "1/ 1", "2015/12/31" or "12/31/2015"; None for other text.

    >>> day_of(" 1/ 1"), day_of("2015/12/31"), day_of("12/31/2015"), day_of("")
    ((0, 1, 1), (2015, 12, 31), (2015, 12, 31), None)
    """
    numbers = [int(part) for part in re.findall(r"\d+", text)]
    if len(numbers) == 2:
        return 0, numbers[0], numbers[1]
    if len(numbers) != 3:
        return None
    return (numbers[0], numbers[1], numbers[2]) if numbers[0] > 31 else (numbers[2], numbers[0], numbers[1])


def days_from(first: tuple[int, int, int] | None, last: tuple[int, int, int] | None) -> int | None:
    """How many days there are from the first to the last, both counted, of years without 29 February if not given.

    None where they are no days.

    >>> days_from((0, 1, 1), (0, 12, 31)), days_from((0, 12, 1), (0, 1, 31)), days_from((2019, 7, 1), (2020, 6, 30))
    (365, 62, 366)
    """
    if first is None or last is None:
        return None
    both = first[0] > 0 and last[0] > 0
    years = (first[0], last[0]) if both else (COMMON_YEAR - 1, COMMON_YEAR - 1 + (last[1:] < first[1:]))
    try:
        start, end = (
            np.datetime64(f"{y:04}-{day[1]:02}-{day[2]:02}") for y, day in zip(years, (first, last), strict=True)
        )
    except ValueError:
        return None
    length = int((end - start).astype(np.int64)) + 1
    return length if 0 < length <= 40_000 else None


def tell_a_cut_day(name: str, middles: np.ndarray, seconds: float) -> None:
    """Warn where a record without a period in its header stops within a day, and the days before are whole."""
    whole = round(86400 / seconds)
    days, counts = np.unique(middles.astype("datetime64[D]"), return_counts=True)
    if len(days) > 1 and counts[-1] < whole and (counts[:-1] == whole).all():
        last_time = str(middles[-1].astype("datetime64[m]")).replace("T", " ")
        warnings.warn(
            f"{name}: the last row is of {last_time}, where {whole - counts[-1]} of the {whole} rows of its day are "
            f"missing ({len(middles)} rows in all): is the file cut short?",
            stacklevel=4,
        )
