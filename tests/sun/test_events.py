from dataclasses import fields
from datetime import date, datetime

import numpy as np
import pandas as pd
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from skydome.ground.units import deg
from skydome.sun.day_events import EVENTS
from skydome.sun.events import sun_events
from skydome.sun.place import Place
from skydome.sun.position import sun_angles

MINUTE, DAY = np.timedelta64(1, "m"), np.timedelta64(1, "D")
PLACES = [
    (Place(45.07, 7.69), "Europe/Rome"),
    (Place(-33.87, 151.21), "Australia/Sydney"),
    (Place(0.0, -78.5), "America/Guayaquil"),
    (Place(59.9, 10.75), "Europe/Oslo"),
    (Place(1.87, -157.4), "Pacific/Kiritimati"),
    (Place(39.47, 75.99), "Asia/Shanghai"),
]


@pytest.mark.parametrize(("place", "zone"), PLACES)
@pytest.mark.parametrize("day", ["2024-02-29", "2026-03-29", "2026-06-21", "2026-12-21", "1950-09-01", "2099-05-05"])
def test_against_pvlib(place, zone, day):
    from pvlib.solarposition import sun_rise_set_transit_spa

    events = sun_events(place, day)
    days = pd.DatetimeIndex(events.noon.astype("M8[D]") + np.arange(-1, 2)).tz_localize("UTC")
    theirs = sun_rise_set_transit_spa(days, place.latitude, place.longitude, delta_t=None)
    for name, column in (("sunrise", "sunrise"), ("noon", "transit"), ("sunset", "sunset")):
        # pvlib may put the right time of one day on the day before or after: compare times of day over three days
        peers = theirs[column].dt.tz_localize(None).to_numpy()
        apart = (getattr(events, name) - peers) % DAY
        assert np.minimum(apart, DAY - apart).min() < MINUTE, (name, getattr(events, name), peers)


@given(st.floats(-90, 90), st.floats(-180, 180), st.integers(-25567, 47847))
@settings(deadline=None, max_examples=40)
def test_events_are_roots_to_a_second(latitude, longitude, day):
    place = Place(latitude, longitude)
    events = sun_events(place, np.datetime64(day, "D"))
    for name, (level, rises) in EVENTS.items():
        root = getattr(events, name)
        if root is None:
            continue
        before, after = sun_angles(place, root + np.array([-1, 1], dtype="m8[s]"))[1] - level
        assert (before < 0 < after) if rises else (before > 0 > after)


def test_noon_lies_on_the_date_of_the_zone():
    for place, zone in PLACES:
        noon = pd.Timestamp(sun_events(place, "2026-06-21", zone).noon, tz="UTC").tz_convert(zone)
        assert str(noon.date()) == "2026-06-21"


def test_order_of_a_day():
    events = sun_events(Place(45.07, 7.69), date(2026, 3, 20), "Europe/Rome")
    names = ["astronomical_dawn", "nautical_dawn", "civil_dawn", "sunrise", "noon"]
    names += ["sunset", "civil_dusk", "nautical_dusk", "astronomical_dusk"]
    order = [getattr(events, name) for name in names]
    assert order == sorted(order)
    assert {field.name for field in fields(events)} == {*names, "noon_elevation", "zone"}
    assert all(time.dtype == np.dtype("datetime64[us]") for time in order)


def test_published_times_of_greenwich():
    # HM Nautical Almanac Office, London (51.5 N, 0.1 W), 21 June 2026: sunrise 03:43, sunset 20:21 UTC
    events = sun_events(Place(51.5, -0.117), "2026-06-21", "Europe/London")
    assert abs(events.sunrise - np.datetime64("2026-06-21T03:43")) <= MINUTE
    assert abs(events.sunset - np.datetime64("2026-06-21T20:21:30")) <= MINUTE


def test_polar_day_and_night():
    tromso = Place(69.65, 18.96)
    summer, winter = (sun_events(tromso, day, "Europe/Oslo") for day in ("2026-06-21", "2026-12-21"))
    assert summer.sunrise is summer.sunset is summer.civil_dawn is None
    assert summer.noon_elevation > 40 * deg
    assert winter.sunrise is winter.sunset is None
    assert winter.noon_elevation < -0.8333 * deg
    assert winter.civil_dawn < winter.noon < winter.civil_dusk


def test_the_pole_has_one_sunrise_a_year():
    days = [sun_events(Place(90, 0), np.datetime64("2026-03-15") + k) for k in range(8)]
    assert sum(day.sunrise is not None for day in days) == 1
    assert all(day.sunset is None for day in days)


def test_a_grazing_sun_is_found():
    """The last night before polar day at Tromso: the sun dips below for minutes only, and is not missed."""
    days = [sun_events(Place(69.65, 18.96), np.datetime64("2026-05-10") + k, "Europe/Oslo") for k in range(15)]
    nights = [day.sunrise - (day.sunset - np.timedelta64(1, "D")) for day in days if day.sunrise and day.sunset]
    assert 0 < len(nights) < 15
    assert min(nights) < np.timedelta64(90, "m")


def test_dates_and_errors():
    place = Place(45.07, 7.69)
    ways = [date(2026, 6, 21), "2026-06-21", np.datetime64("2026-06-21"), datetime(2026, 6, 21, 15)]
    assert len({sun_events(place, day).noon for day in ways}) == 1
    for wrong in ("21/06/2026", 5, "2026-02-30"):
        with pytest.raises(ValueError, match="date must read like 2026-06-21"):
            sun_events(place, wrong)
    with pytest.raises(ValueError, match="zone must be an IANA name"):
        sun_events(place, "2026-06-21", "Europe/Turin")


DAYS = np.arange("2026-01-01", "2027-01-01", dtype="datetime64[D]")


@pytest.mark.parametrize(
    ("latitude", "zone"),
    [(45.07, "Europe/Rome"), (69.65, "Europe/Oslo"), (-33.9, "Australia/Sydney"), (90.0, None), (66.56, None)],
)
def test_many_days_are_as_each_of_them(latitude, zone):
    """The quick way against the slow one, 0.022 s being the latter's own grain; the same days have no sunrise."""
    place = Place(latitude, 18.0)
    year = sun_events(place, DAYS, zone)
    for k in range(2, 365, 9):
        one = sun_events(place, DAYS[k], zone)
        assert year.daylight[k] == one.daylight
        assert np.isclose(year.noon_elevation[k], one.noon_elevation, atol=1e-7)
        for name, instant in one.instants.items():
            found = year.instants[name][k]
            assert np.isnat(found) if instant is None else abs(found - instant) < np.timedelta64(30, "ms")


def test_a_year_of_days_however_they_are_written():
    place = Place(45.07, 7.69)
    ways = [DAYS, DAYS.astype(object), list(DAYS.astype(str)), pd.DatetimeIndex(DAYS), pd.Series(DAYS)]
    years = [sun_events(place, days, "Europe/Rome").noon for days in ways]
    assert all(np.array_equal(years[0], noon) for noon in years)
    with pytest.raises(ValueError, match="date must read like"):
        sun_events(place, ["2026-06-21", "x"])
    with pytest.raises(ValueError, match="at least one"):
        sun_events(place, [])
    with pytest.raises(ValueError, match=r"shape \(1, 1\)"):
        sun_events(place, [["2026-06-21"]])


def test_the_zone_asked_for_and_words():
    tromso = Place(69.65, 18.96)
    days = sun_events(tromso, ["2026-03-29", "2026-06-21", "2026-12-21"], "Europe/Oslo")
    assert days.daylight.tolist() == ["sunrise and sunset", "polar day", "polar night"]
    assert [str(time)[-6:] for time in days.local["noon"]] == ["+02:00", "+02:00", "+01:00"]
    assert days.local["sunset"][1] is None
    one = sun_events(tromso, "2026-12-21", "Europe/Oslo")
    assert one.daylight == "polar night"
    assert one.local["noon"].isoformat()[:16] == "2026-12-21T11:42"
    assert one.local["sunrise"] is None
