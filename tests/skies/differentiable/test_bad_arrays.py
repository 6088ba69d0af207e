"""What arrays are refused, and in which words: mixed libraries and devices, wrong lengths, NaN, shapes."""

import numpy as np
import pytest

import skydome as sd

torch = pytest.importorskip("torch")
jax = pytest.importorskip("jax")

SUN = sd.direction(2.4, 0.7)


def torch_sky(make):
    return make(torch.tensor(SUN), torch.tensor(1.0, dtype=torch.float64))


def test_numpy_directions_with_a_torch_sky(make):
    sky = torch_sky(make)
    if not hasattr(sky, "sun"):
        pytest.skip("no direction of its own to mix with")
    with pytest.raises(TypeError, match="arrays of different libraries cannot be mixed, got numpy and torch"):
        sky.luminance(np.stack([sd.ZENITH, sd.NORTH]))
    with pytest.raises(TypeError, match=r"cannot be mixed, got jax.* and torch"):
        sky.luminance(jax.numpy.asarray(sd.ZENITH))
    with pytest.raises(TypeError, match="cannot be mixed"):
        sd.illuminance(sky, np.array([0.0, 1.0, 0.0]))


@pytest.mark.parametrize("model", [sd.HosekWilkie, sd.HosekWilkieRGB, sd.Preetham, sd.SunDisc])
def test_parameters_of_two_libraries(model):
    with pytest.raises(TypeError, match="cannot be mixed, got numpy and torch"):
        model(SUN, torch.tensor(3.0))


def test_two_precisions_meet_in_the_finer(make):
    for first, second in ((torch.float32, torch.float64), (torch.float64, torch.float32)):
        sky = make(torch.tensor(SUN, dtype=first), torch.tensor(1.0, dtype=second))
        assert torch.isfinite(sky.luminance(torch.tensor(sd.ZENITH, dtype=first)))
        assert sd.illuminance(sky) > 0


def test_two_devices():
    sky = sd.HosekWilkie(torch.tensor(SUN), 3.0)
    with pytest.raises(TypeError, match="arrays on different devices cannot be mixed, got cpu and meta; move them"):
        sky.luminance(torch.empty((2, 3), dtype=torch.float64, device="meta"))


def test_integer_directions_are_exact_unit_vectors_or_refused(make):
    """Whole numbers become float64; (0, 0, 1) is a unit vector, (1, 1, 0) is none."""
    sky = make(SUN, 1.0)
    assert sky.luminance([0, 0, 1]) == sky.luminance(sd.ZENITH)
    assert sky.luminance(np.array([0, 0, 1])).dtype == np.float64
    with pytest.raises(ValueError, match=r"unit vectors within 1e-3; scale them with skydome.unit\(...\)"):
        sky.luminance(np.array([1, 1, 0]))


@pytest.mark.parametrize("length", [0.998, 1.002, 0.0, 2.0, np.nan, np.inf])
@pytest.mark.parametrize("library", [np.asarray, torch.tensor, jax.numpy.asarray], ids=["numpy", "torch", "jax"])
def test_lengths_off_by_more_than_a_thousandth(make, library, length):
    one = library(1.0)
    sky = make(library(SUN), one)
    with np.errstate(invalid="ignore"):
        wrong = library(SUN * length if np.isfinite(length) else np.array([length, 0.0, 0.0]))
    with pytest.raises(ValueError, match="finite unit vectors within 1e-3; scale them"):
        sky.luminance(wrong)
    with pytest.raises(ValueError, match="finite unit vectors within 1e-3"):
        sd.HosekWilkie(wrong, 3.0)


@pytest.mark.parametrize("length", [0.9995, 1.0005])
def test_lengths_off_by_less_are_taken(make, length):
    assert np.isfinite(make(SUN, 1.0).luminance(sd.ZENITH * length))


@pytest.mark.parametrize("shape", [(), (2,), (4,), (3, 2), (0,)])
def test_shapes(make, shape):
    with pytest.raises(ValueError, match=r"must have shape \(\.\.\., 3\), got"):
        make(SUN, 1.0).luminance(np.zeros(shape))


@pytest.mark.parametrize("library", [np.asarray, torch.tensor, jax.numpy.asarray], ids=["numpy", "torch", "jax"])
def test_nothing_asked_nothing_answered(make, library):
    sky = make(library(SUN), library(1.0))
    assert tuple(sky.luminance(library(np.zeros((0, 3)))).shape) == (0,)
    assert tuple(sky.luminance(library(np.zeros((2, 0, 3)))).shape) == (2, 0)
    if isinstance(sky, sd.ColourSky):
        assert tuple(sky.rgb(library(np.zeros((0, 3)))).shape) == (0, 3)


def test_shapes_that_do_not_broadcast(make):
    sky = make(sd.direction(np.array([1.0, 2.0]), np.array([0.4, 0.5])), np.ones(2))
    with pytest.raises(ValueError, match=r"leading shapes must fit|broadcast"):
        sky.luminance(np.broadcast_to(sd.ZENITH, (5, 3)))


def test_nan_parameters():
    with pytest.raises(ValueError, match=r"turbidity must lie in \[1, 10\], got nan"):
        sd.HosekWilkie(torch.tensor(SUN), torch.tensor(float("nan")))
