"""Constants that nobody can spoil, and that go along with every library."""

import copy
import pickle

import numpy as np
import pytest

import skydome as sd
from skydome.ground.arrays import Constant, namespace

DIRECTIONS = ("ZENITH", "NORTH", "EAST", "SOUTH", "WEST")


@pytest.mark.parametrize("name", DIRECTIONS)
def test_constants_cannot_be_written_to(name):
    vector = getattr(sd, name)
    with pytest.raises(ValueError, match="read-only"):
        vector[:] = 0
    with pytest.raises(ValueError, match="read-only"):
        vector *= 2
    assert np.linalg.norm(vector) == 1


def test_what_is_computed_from_constants_is_a_plain_array():
    for found in (2 * sd.ZENITH, sd.ZENITH + sd.NORTH, np.stack([sd.ZENITH, sd.EAST]), np.asarray(sd.WEST)):
        assert type(found) is np.ndarray
    assert repr(sd.ZENITH) == repr(np.array([0.0, 0.0, 1.0]))
    for again in (copy.deepcopy(sd.ZENITH), pickle.loads(pickle.dumps(sd.ZENITH))):
        assert isinstance(again, Constant)
        assert again.tolist() == [0, 0, 1]


def library_arrays(library):
    if library == "torch":
        return pytest.importorskip("torch").tensor
    return pytest.importorskip("jax.numpy").asarray


def skies(sun):
    power = sun[..., 2] * 1000
    clear = sd.Preetham(sun, 3.0)
    return (
        clear, sd.HosekWilkie(sun, 3.0), sd.CIE(sun, 12, zenith_luminance=4e3), sd.PerezAllWeather(sun, 700.0, 90.0),
        sd.CIEClear(sun, zenith_luminance=4e3), sd.Uniform(power), sd.MoonSpencer(zenith_luminance=power),
        sd.MoonSpencer(illuminance=power), sd.SunDisc(sun, 3.0), clear + sd.SunDisc.of(clear),
        sd.Daylight(sd.Uniform(power)), sd.Preetham(sun, 3.0) * 0.5,
    )  # fmt: skip


@pytest.mark.parametrize("library", ["torch", "jax"])
def test_constants_and_lists_meet_skies_of_every_library(library):
    array = library_arrays(library)
    own = np.asarray(sd.direction(3.0, 0.7))
    sun = array(own)
    for sky, plain in zip(skies(sun), skies(own), strict=True):
        for toward in (sd.ZENITH, [0.0, 0.0, 1.0]):
            light = sky.luminance(toward)
            assert type(light) is type(sun), type(sky).__name__
            assert float(light) == pytest.approx(float(plain.luminance(sd.ZENITH)), rel=3e-5)
        assert float(sd.illuminance(sky, sd.SOUTH)) == pytest.approx(float(sd.illuminance(plain, sd.SOUTH)), rel=3e-5)
    assert float(sd.angle_between(sd.ZENITH, sun)) == pytest.approx(np.pi / 2 - 0.7, rel=1e-6)
    seen = sd.aerial_perspective(skies(sun)[0], 1000.0, sd.EAST)
    assert type(seen.transmittance) is type(sun)


@pytest.mark.parametrize("value", [{"a": 1}, object(), "south", {1.0}])
def test_what_is_no_array_is_named(value):
    with pytest.raises(TypeError, match="expected an array or a number, got " + type(value).__name__):
        namespace(value)
