"""Fields of cloud by night and in twilight: against the overcast layer, against the day, against no cloud at all."""

import numpy as np
import pytest

import skydome as sd
from skydome.skies.clouds.fields.kinds import Slab
from skydome.skies.night.clouds.behind_field import lit_by
from skydome.skies.night.clouds.remembered import RememberedField

pytest.importorskip("numba")
PLACE = sd.Place(50.0, 8.0)
MOONLESS, FULL, DUSK, NOON = "2026-01-18T22:00Z", "2026-01-03T22:00Z", "2026-01-18T16:20Z", "2026-06-29T12:00Z"
VIEWS = sd.direction(np.linspace(0.0, 6.2, 40), np.linspace(0.1, 1.5, 40))


def slab(depth):
    """A layer of water of an optical depth, 1-2 km up, everywhere the same."""
    return sd.CloudField(Slab(sd.Water()), cover=1.0, extinction=depth / 1000.0)


@pytest.mark.parametrize("time", [MOONLESS, FULL, NOON, DUSK])
def test_a_whole_cover_has_the_light_of_the_overcast(time):
    clouds = sd.Cloud(20.0, thickness=1000.0), slab(20.0)
    layer, field = (float(sd.illuminance(sd.sky_at(PLACE, time, clouds=over))) for over in clouds)
    print(f"{time}: the field has {field / layer:.3f} of the layer's light")
    assert field == pytest.approx(layer, rel=0.06)


def test_light_under_an_overcast_falls_without_a_step_through_dusk():
    """The steps of a tenth of a degree, as logarithms, change by no more than 3 % from one to the next."""
    times = np.datetime64("2026-04-16T18:14") + np.arange(18) * np.timedelta64(40, "s")
    light = np.array([sd.illuminance(sd.sky_at(PLACE, f"{time}Z", clouds=20.0)) for time in times])
    steps = np.diff(np.log(light))
    assert (steps < 0).all()
    assert np.abs(np.diff(steps)).max() < 0.03


def test_without_cover_a_night_is_the_clear_one():
    night, clear = (sd.sky_at(PLACE, FULL, clouds=clouds) for clouds in (sd.CloudField(cover=0.0), None))
    np.testing.assert_array_equal(night.xyz(VIEWS), clear.xyz(VIEWS))


def test_the_moon_lights_clouds_as_the_sun_does():
    """Of the same air and height, by wavelength to rounding; their luminance by 1 %, since moonlight is redder."""
    field = sd.CloudField(Slab(sd.Water()), cover=1.0, extinction=0.003)
    moonlit = sd.sky_at(PLACE, FULL, clouds=field)["moonlight"]
    sunlit = sd.CloudySky(sd.PhysicalSky(moonlit.clear.toward), field)
    night, day = (sky.radiance(VIEWS, [550.0]) / sky.clear.radiance(VIEWS, [550.0]) for sky in (moonlit, sunlit))
    np.testing.assert_allclose(night, day, rtol=1e-9)
    night, day = (sky.luminance(VIEWS) / sky.clear.luminance(VIEWS) for sky in (moonlit, sunlit))
    np.testing.assert_allclose(night, day, rtol=0.015)


def test_a_day_below_a_field_is_the_sky_of_clouds():
    field = slab(3.0)
    day, clear = sd.sky_at(PLACE, NOON, clouds=field), sd.sky_at(PLACE, NOON)
    assert day.names == ("sky", "sun")
    assert isinstance(day["sky"], sd.CloudySky)
    np.testing.assert_allclose(day["sky"].luminance(VIEWS), sd.CloudySky(clear["sky"], field).luminance(VIEWS))
    passed = float(day["sun"].normal_xyz[1] / clear["sun"].normal_xyz[1])
    assert passed == pytest.approx(np.exp(-3.0 / clear["sun"].sun[2]), rel=0.02)
    assert day.notes[-1].startswith("clouds: slab, cover 1.00, 1000 to 2000 m")


def test_clouds_are_darker_than_a_moonless_sky():
    """As over any land without towns: a cloud has the sky's light from above alone, and hides the glow behind it."""
    night, clear = sd.sky_at(PLACE, MOONLESS, clouds=slab(30.0)), sd.sky_at(PLACE, MOONLESS)
    ratio = night["airglow"].luminance(VIEWS) / clear["airglow"].luminance(VIEWS)
    assert 0.3 < ratio[-1] < 0.6
    assert (ratio < 0.8).all()
    assert sd.illuminance(night["stars"]) < 1e-9  # and its stars
    thin = sd.sky_at(PLACE, MOONLESS, clouds=slab(1.0), only=["stars"])
    left = np.asarray(thin["stars"].carried / clear["stars"].carried)[:, 1]
    up = np.asarray(clear["stars"].directions)[:, 2]
    np.testing.assert_allclose(left[up > 0.3], np.exp(-1.0 / up[up > 0.3]), rtol=0.03)


def test_lights_share_what_is_seen_of_the_field(monkeypatch):
    asked = []
    plain = RememberedField.__mro__[1].seen
    monkeypatch.setattr(
        RememberedField.__mro__[1], "seen", lambda lit, views: asked.append(len(views)) or plain(lit, views)
    )
    night = sd.sky_at(PLACE, FULL, clouds=slab(3.0), only=["moonlight", "airglow", "starlight"])
    night.xyz(VIEWS)
    night.radiance(VIEWS, [550.0])
    assert asked == [40]


def test_high_clouds_keep_the_sun_when_the_ground_has_lost_it():
    """From 9 km the horizon lies 3 degrees lower; light changes without a step through dusk."""
    low, high = slab(3.0), sd.CloudField(Slab(sd.Ice()), cover=1.0, base=9000.0, extinction=0.0005)
    suns = [sd.direction(4.0, elevation * sd.deg) for elevation in (-2.8, -5.0, -8.0)]
    lit = [[lit_by(sd.PhysicalSky(sun), field) is not None for field in (low, high)] for sun in suns]
    assert lit == [[True, True], [False, True], [False, False]]  # the farthest cloud in sight counts
    light = []
    for elevation in np.arange(-4.4, -3.0, 0.2):
        sky = sd.PhysicalSky(sd.direction(4.0, elevation * sd.deg))
        field = lit_by(sky, high) or RememberedField.of(high, sd.ZENITH)
        beam = sd.CloudySky(sky, high).colours.sun @ np.ones(41)
        light.append(beam)
        assert (beam > 0) <= (lit_by(sky, high) is not None)
        assert field.field is high
    assert light == sorted(light)


def test_a_night_turns_before_clouds_come_over_it():
    night = sd.sky_at(PLACE, FULL, only=["moonlight", "moon", "airglow", "stars"])
    turned = night.turned(90 * sd.deg).below(slab(2.0))
    plain = night.below(slab(2.0))
    ahead = np.stack([-VIEWS[:, 1], VIEWS[:, 0], VIEWS[:, 2]], axis=-1)
    np.testing.assert_allclose(turned.xyz(ahead), plain.xyz(VIEWS), rtol=1e-3)
    with pytest.raises(TypeError, match="turn the clear sky, then put clouds over it"):
        plain.turned(1.0)
    assert plain.parameters()["clouds"].startswith("slab, cover 1.00")
    with pytest.raises(ValueError, match="stand over that sky already: slab"):
        plain.below(20.0)
    with pytest.raises(ValueError, match="must not be given together"):
        sd.sky_at(PLACE, FULL, clouds=slab(2.0), glow=sd.SkyGlow())


def test_light_through_times_below_a_field():
    light = sd.light_at(PLACE, [MOONLESS, FULL], clouds=slab(20.0))
    whole = float(sd.illuminance(sd.sky_at(PLACE, FULL, clouds=slab(20.0))))
    assert light.total[1] == pytest.approx(whole, rel=0.01)
