"""The limits of measured irradiances stand in one place: weather, tapes and Perez's sky heed the same."""

import numpy as np
import pytest

import skydome as sd
from skydome.light.irradiance import (
    GREATEST_IRRADIANCE,
    LEAST_ELEVATION,
    SENSOR_OFFSET,
    normal_from_horizontal,
    without_offsets,
)

SUN = sd.direction(180 * sd.deg, 40 * sd.deg)


def weather(direct):
    start = np.array(["2026-06-21T10:00", "2026-06-21T11:00"], dtype="datetime64[s]")
    end, full = start + np.timedelta64(3600, "s"), np.full(2, 100.0)
    return sd.Weather(sd.Place(45.0, 8.0), start, end, np.array([direct, 100.0]), full, full * 0)


@pytest.mark.parametrize("direct", [np.nextafter(GREATEST_IRRADIANCE, 1e9), np.nextafter(SENSOR_OFFSET, -1e9)])
def test_what_cannot_be_is_refused(direct):
    with pytest.raises(ValueError, match=r"direct_normal must lie in \[-10, 2000\] W m-2, got .* in row 1 of the data"):
        weather(direct)
    with pytest.raises(ValueError, match=r"direct_normal_irradiance must lie in \[0, 2000\]"):
        sd.PerezAllWeather(SUN, direct, 100.0)


def test_limits_themselves_pass_and_offsets_count_as_0():
    assert weather(GREATEST_IRRADIANCE).irradiances[0].tolist() == [2000.0, 100.0]
    assert weather(SENSOR_OFFSET).irradiances[0].tolist() == [0.0, 100.0]
    assert np.isnan(without_offsets(np.array([np.nan])))[0]


def test_clamp_holds_at_the_limit():
    held = sd.PerezAllWeather(SUN, 5000.0, 100.0, check="clamp")
    assert (
        held.direct_normal_illuminance == sd.PerezAllWeather(SUN, GREATEST_IRRADIANCE, 100.0).direct_normal_illuminance
    )


def test_a_low_sun_counts_as_one_degree():
    assert np.isclose(normal_from_horizontal(10.0, -0.1), 10.0 / np.sin(LEAST_ELEVATION), rtol=1e-15)
