from datetime import UTC, date, datetime, timedelta, timezone
from zoneinfo import ZoneInfo

import numpy as np
import pandas as pd
import pytest
from hypothesis import given
from hypothesis import strategies as st

from skydome.sun.times import instants, local_midnight, utc_offset_seconds

NOON = np.datetime64("2026-06-21T13:00", "us")
ROME = ZoneInfo("Europe/Rome")


@pytest.mark.parametrize(
    "time",
    [
        "2026-06-21T15:00+02:00",
        "2026-06-21T13:00Z",
        "2026-06-21 13:00:00.000000+00:00",
        "20260621T130000Z",
        "2026-06-21T15:00[Europe/Rome]",
        "2026-06-21T15:00+02:00[Europe/Rome]",
        datetime(2026, 6, 21, 15, tzinfo=ROME),
        datetime(2026, 6, 21, 15, tzinfo=timezone(timedelta(hours=2))),
        pd.Timestamp("2026-06-21T15:00", tz="Europe/Rome"),
        pd.Timestamp("2026-06-21T13:00:00.000000001Z"),
        np.datetime64("2026-06-21T13", "h"),
        np.datetime64("2026-06-21T13:00", "ns"),
        np.str_("2026-06-21T13:00Z"),
    ],
)
def test_every_way_to_write_one_instant(time):
    utc = instants(time)
    assert utc.shape == ()
    assert utc.dtype == np.dtype("datetime64[us]")
    assert utc == NOON
    assert instants(time, zone="Asia/Tokyo") == NOON


@pytest.mark.parametrize(
    "times",
    [
        ["2026-06-21T13:00Z", "2026-06-21T15:00+02:00"],
        (datetime(2026, 6, 21, 15, tzinfo=ROME), "2026-06-21T13:00Z"),
        np.array(["2026-06-21T13:00Z"] * 2),
        np.array([datetime(2026, 6, 21, 15, tzinfo=ROME)] * 2, dtype=object),
        pd.DatetimeIndex(["2026-06-21T15:00+02:00"] * 2),
        pd.Series(pd.DatetimeIndex(["2026-06-21T15:00+02:00"] * 2)),
        pd.Series(["2026-06-21T15:00+02:00"] * 2),
        pd.Series(["2026-06-21T15:00+02:00"] * 2, dtype=object),
        [np.datetime64("2026-06-21T13"), datetime(2026, 6, 21, 15, tzinfo=ROME)],
    ],
)
def test_lists_and_arrays(times):
    np.testing.assert_array_equal(instants(times), [NOON, NOON])


def test_shapes():
    assert instants([["2026-06-21T13:00Z"] * 3] * 2).shape == (2, 3)
    assert instants(np.full((2, 3, 4), NOON)).shape == (2, 3, 4)
    assert instants([]).shape == (0,)


@pytest.mark.parametrize(
    "time",
    [
        "2026-06-21T15:00",
        datetime(2026, 6, 21, 15),
        pd.Timestamp("2026-06-21T15:00"),
        pd.DatetimeIndex(["2026-06-21T15:00"]),
    ],
)
def test_naive_times_are_refused_with_a_recipe_or_given_a_zone(time):
    with pytest.raises(
        ValueError, match=r"needs its zone, got 2026-06-21T15:00:00: append .*zone='Europe/Rome'"
    ) as error:
        instants(time)
    assert "\n" not in str(error.value)
    assert (instants(time, zone="Europe/Rome") == NOON).all()


def test_a_bare_date_is_naive():
    with pytest.raises(ValueError, match="needs its zone"):
        instants("2026-06-21")
    with pytest.raises(TypeError, match="time must be a datetime"):
        instants(date(2026, 6, 21))


@pytest.mark.parametrize("zone", ["Europe/Turin", "Rome", "", "../etc", "Europe", "CEST"])
def test_unknown_zone(zone):
    with pytest.raises(ValueError, match=r"zone must be an IANA name such as Europe/Rome, got"):
        instants("2026-06-21T15:00", zone=zone)


def test_unknown_zone_names_near_ones():
    with pytest.raises(ValueError, match="perhaps Europe/Rome"):
        instants("2026-06-21T15:00[Europe/Roma]")


@pytest.mark.parametrize("time", ["2026-03-29T02:30[Europe/Rome]", datetime(2026, 3, 29, 2, 30, tzinfo=ROME)])
def test_skipped_local_times_are_refused(time):
    with pytest.raises(ValueError, match="skipped 2026-03-29T02:30:00"):
        instants(time)
    with pytest.raises(ValueError, match="skipped"):
        instants("2026-03-29T02:30", zone="Europe/Rome")


def test_repeated_local_times_are_the_earlier():
    assert instants("2026-10-25T02:30", zone="Europe/Rome") == np.datetime64("2026-10-25T00:30")
    assert instants("2026-10-25T02:30+01:00[Europe/Rome]") == np.datetime64("2026-10-25T01:30")
    assert instants(datetime(2026, 10, 25, 2, 30, fold=1), zone="Europe/Rome") == np.datetime64("2026-10-25T01:30")


@pytest.mark.parametrize("time", ["2016-12-31T23:59:60Z", "2016-12-31 23:59:60.5+00:00", "20161231T235960Z"])
def test_leap_seconds_are_refused(time):
    with pytest.raises(ValueError, match="leap seconds"):
        instants(time)


@pytest.mark.parametrize("time", ["noon", "2026-13-01T00:00Z", "2026-02-29T12:00Z", "", "2026-06-21T25:00Z"])
def test_other_text_is_refused(time):
    with pytest.raises(ValueError, match="time must be ISO 8601"):
        instants(time)


def test_offset_and_zone_must_agree():
    with pytest.raises(ValueError, match="must agree"):
        instants("2026-06-21T15:00+01:00[Europe/Rome]")


@pytest.mark.parametrize("time", [np.datetime64("NaT"), pd.NaT, [NOON, np.datetime64("NaT", "us")]])
def test_nat_is_refused(time):
    with pytest.raises((ValueError, TypeError), match="NaT"):
        instants(time)


@pytest.mark.parametrize("time", [3.5, 1782046800, None, np.array([1, 2])])
def test_numbers_are_refused(time):
    with pytest.raises(TypeError, match="time must be a datetime"):
        instants(time)


@given(st.datetimes(datetime(1900, 1, 1), datetime(2100, 1, 1), timezones=st.just(UTC)))
def test_writing_and_reading_is_exact_to_the_microsecond(time):
    assert instants(time.isoformat()).item() == time.replace(tzinfo=None)
    assert instants(time.astimezone(ROME)).item() == time.replace(tzinfo=None)


def test_utc_offset_is_openexrs():
    assert utc_offset_seconds("2026-06-21T15:00+02:00") == -7200
    assert utc_offset_seconds("2026-01-21T15:00", zone="Europe/Rome") == -3600
    assert utc_offset_seconds(NOON, zone="America/New_York") == 14400
    assert utc_offset_seconds(NOON) == 0
    assert utc_offset_seconds("2026-06-21T13:00Z") == 0


def test_midnight_where_the_clock_skips_it():
    assert local_midnight(date(2026, 4, 24), ZoneInfo("Africa/Cairo")) == np.datetime64("2026-04-23T22:00")
