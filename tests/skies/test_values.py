"""Skies are values: they stay what they were, and two of the same parameters are equal."""

import numpy as np
import pytest

import skydome as sd

SUN = np.array([0.0, 0.6, 0.8])
AIR = sd.Atmosphere()
MADE = {
    "Preetham": lambda sun: sd.Preetham(sun, np.array(3.0)),
    "HosekWilkie": lambda sun: sd.HosekWilkie(sun, np.array(3.0), albedo=np.array(0.2)),
    "CIE": lambda sun: sd.CIE(sun, 12, illuminance=np.array(1e4)),
    "Perez": lambda sun: sd.Perez(sun, -1.0, -0.3, 10.0, -3.0, 0.45, illuminance=1e4),
    "PerezAllWeather": lambda sun: sd.PerezAllWeather(sun, np.array(700.0), np.array(100.0)),
    "SunDisc": lambda sun: sd.SunDisc(sun, 3.0),
    "DiscreteOrdinates": lambda sun: sd.DiscreteOrdinates(sun, AIR),
    "PhysicalSky": lambda sun: sd.PhysicalSky(sun),
    "NeuralSky": lambda sun: sd.NeuralSky.load("hosek-wilkie", sun, 3.0, albedo=0.2),
    "sum": lambda sun: sd.Preetham(sun, 3.0) + 0.5 * sd.Uniform(np.array(10.0)),
    "Daylight": lambda sun: sd.Daylight(sd.MoonSpencer(zenith_luminance=np.array(9e3))),
}


@pytest.mark.parametrize("name", MADE)
def test_a_sky_stays_what_it_was(name):
    given = SUN.copy()
    sky = MADE[name](given)
    before = np.asarray(sky.luminance(sd.direction(1.0, 0.5))).copy()
    given[:] = 0.6, 0.0, 0.8
    assert np.array_equal(sky.luminance(sd.direction(1.0, 0.5)), before)


def test_parameters_and_lists_are_its_own_too():
    turbidity, sun = np.array([2.0, 3.0]), [0.0, 0.6, 0.8]
    sky, listed = sd.Preetham(SUN, turbidity), sd.Preetham(sun, 3.0)
    turbidity[0], sun[0] = 6.0, 0.5
    assert np.array_equal(sky.turbidity, [2.0, 3.0])
    assert listed.sun == [0.0, 0.6, 0.8]


@pytest.mark.parametrize("name", MADE)
def test_skies_of_the_same_parameters_are_equal(name):
    one, other, third = MADE[name](SUN), MADE[name](SUN.copy()), MADE[name](sd.direction(1.0, 0.7))
    assert one == other
    assert hash(one) == hash(other)
    assert len({one, other, third}) == (1 if name == "Daylight" else 2)
    assert one != sd.Uniform(1.0)


def test_equal_numbers_are_equal_however_they_are_written():
    assert sd.Preetham(SUN, 3) == sd.Preetham(SUN, np.float32(3.0))
    assert hash(sd.Preetham(SUN, 3)) == hash(sd.Preetham(SUN, np.array(3.0)))
    assert sd.Preetham(SUN, 3.0) != sd.Preetham(SUN, 3.1)
    assert sd.Preetham(SUN, 3.0) != sd.Preetham(SUN, 3.0, check="clamp")


def test_many_suns_are_not_taken_for_one():
    """A disc of shape (2,) on one plane gave the first one's light, without a word."""
    with pytest.raises(ValueError, match="give many suns an axis of 1"):
        sd.illuminance(sd.SunDisc(SUN, np.array([2.0, 3.0])), sd.ZENITH)
    each = [float(sd.illuminance(sd.SunDisc(SUN, t), sd.ZENITH)) for t in (2.0, 3.0)]
    many = sd.SunDisc(np.broadcast_to(SUN, (2, 1, 3)), np.array([[2.0], [3.0]]))
    np.testing.assert_allclose(sd.illuminance(many, sd.ZENITH), each)


def test_half_float_directions_round_nothing_of_the_sky():
    """Directions of float16 brought the sky's own constants to 11 bits: light off by 4e-4."""
    sky = sd.HosekWilkie(SUN, 3.0)
    seen = sky.luminance(sd.ZENITH.astype(np.float16))
    assert seen == pytest.approx(float(sky.luminance(sd.ZENITH)), rel=1e-12)
