"""The sun's path through a day, as numbers and on axes."""

import numpy as np
import pytest

import skydome as sd

TURIN = sd.Place(45.07, 7.69, 240)


def test_the_path_is_the_suns_and_noon_is_in_its_middle():
    path = sd.sun_path(TURIN, "2026-06-21")
    np.testing.assert_array_equal(path.directions, sd.sun_direction(TURIN, path.times))
    events = sd.sun_events(TURIN, "2026-06-21", "Europe/Rome")
    highest = path.times[np.argmax(path.elevations)]
    assert abs(highest - events.noon) <= np.timedelta64(150, "s")
    hours = (events.sunset - events.sunrise) / np.timedelta64(1, "h")
    assert path.daylight_hours == pytest.approx(hours, abs=0.3)  # their sunrise is the refracted upper limb's


def test_far_east_the_day_is_the_places_own():
    fiji = sd.Place(-18.0, 178.0)
    highest = np.argmax(sd.sun_path(fiji, "2026-03-21", step=10).elevations)
    assert 71 <= highest <= 73


def test_a_step_out_of_range():
    with pytest.raises(ValueError, match=r"step must lie in \[0.1, 120\] minutes, got 0"):
        sd.sun_path(TURIN, "2026-06-21", step=0)


def test_on_a_skys_axes_it_goes_through_the_sun():
    """Looking up: east at the left, the horizon at 1."""
    path = sd.sun_path(TURIN, "2026-06-21")
    k = 170
    axes = sd.Preetham(path.directions[k], turbidity=3.0).plot()
    line = path.plot(ax=axes).lines[-1].get_xydata()
    height, turn = path.elevations[k], np.radians(path.azimuths[k])
    np.testing.assert_allclose(line[k], (1 - height / 90) * np.array([-np.sin(turn), np.cos(turn)]))
    own = path.plot().lines[-1].get_xydata()
    both = path.plot(ax=path.plot())
    np.testing.assert_array_equal(both.lines[1].get_xydata(), own)
    assert np.nanmax(own[:, 1]) == pytest.approx(path.elevations.max())
