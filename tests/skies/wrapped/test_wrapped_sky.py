"""What a sky made of another does not tell itself is that sky's own."""

import pytest

import skydome as sd

SUN = sd.direction(2.0, 0.6)
AIR = sd.clear_air(albedo=0.35)
CLEAR = sd.PhysicalSky(SUN, AIR)
OVERCAST = sd.OvercastSky(SUN, 12.0, albedo=0.6)
NIGHT = sd.Airglow(AIR)
MADE = [
    (CLEAR.for_maps, CLEAR),
    (OVERCAST.for_maps, OVERCAST),
    (NIGHT.for_maps, NIGHT),
    (sd.CloudySky(CLEAR, sd.CloudField(cover=0.0)), CLEAR),
    (sd.Daylight(OVERCAST), OVERCAST),
]


@pytest.mark.parametrize(("sky", "other"), MADE, ids=lambda sky: type(sky).__name__)
def test_day_ground_and_night_are_the_others(sky, other):
    assert type(sky) is not type(other)
    told = ("albedo", "has_night", "is_day", "valid")
    assert [getattr(sky, name) for name in told] == [getattr(other, name) for name in told]


@pytest.mark.parametrize(("sky", "other"), MADE, ids=lambda sky: type(sky).__name__)
def test_the_sun_shines_through_the_others_air(sky, other):
    if other.sunlit is None:
        assert sky.sunlit is None
        return
    for name in ("far_air", "haze", "sun_distance", "direct_normal_illuminance"):
        assert getattr(sky.sunlit, name) == getattr(other.sunlit, name), name
    disc, own = sky.sunlit.own_disc(0.0047), other.sunlit.own_disc(0.0047)
    assert (disc is None) == (own is None)
    assert disc is None or disc.illuminance(disc.sun) == pytest.approx(own.illuminance(own.sun), rel=1e-12)
