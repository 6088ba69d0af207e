"""A year as a picture: hours against days, of weather and of skies, on axes that are given."""

import numpy as np
import pytest

import skydome as sd

pytest.importorskip("matplotlib")


@pytest.fixture(scope="module")
def days():
    """Two days of hours in Turin, brighter by the hour; one is missing."""
    start = np.datetime64("2026-06-29T23:00", "s") + np.arange(48) * np.timedelta64(3600, "s")
    hour = np.tile(np.arange(24.0), 2)
    up = (hour > 5) & (hour < 19)
    direct, diffuse = 10 * hour * up, 50.0 * up
    direct[30] = np.nan
    step = np.timedelta64(3600, "s")
    return sd.Weather(sd.Place(45.07, 7.69), start, start + step, direct, diffuse, np.full(48, 11.0), utc_offset=1.0)


def axes():
    from matplotlib.figure import Figure

    return Figure().add_subplot()


def test_weather_is_drawn_by_the_clock_of_its_file(days):
    given = axes()
    assert days.plot(ax=given) is given
    shown = given.images[0].get_array()
    assert shown.shape == (24, 2)
    assert shown.mask[6, 1]
    assert shown.mask.sum() == 1
    up = sd.sun_direction(days.place, days.middle[12])[2]
    assert shown[12, 0] == pytest.approx(50 + 120 * up, rel=1e-3)
    assert [text.get_text() for text in given.get_xticklabels()] == ["Jul"]


def test_a_year_of_skies_is_drawn_too(days):
    pytest.importorskip("xarray")
    skies = sd.year(days, patches="tregenza")
    given = axes()
    assert skies.skydome.plot(ax=given, name="direct_normal_illuminance") is given
    shown = given.images[0].get_array()
    assert shown[12, 0] == pytest.approx(float(skies.direct_normal_illuminance[12]) / 1000)
    assert skies.skydome.plot().images[0].get_array()[12, 0] > 5
    with pytest.raises(ValueError, match="name"):
        skies.skydome.plot(name="lux")
