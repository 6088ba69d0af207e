"""CapturedSky in torch and JAX: the same light, with gradients, batches and jit; integrals, turning, sampling."""

import importlib

import numpy as np
import pytest

import skydome as sd
from skydome.skies.captured import CapturedSky

SUN = sd.direction(2.0, 0.7)
PICTURE = sd.render(sd.HosekWilkie(SUN, 3.0), height=64)
LAYOUTS = {
    "native": PICTURE,
    "turned": PICTURE.rotated(0.9),
    "mirrored": PICTURE.resampled(sd.Equirectangular(azimuth_left=1.0, mirrored=True)),
}
# Everywhere: about the seam, at and about the zenith, on the horizon, below.
AROUND = sd.direction(np.linspace(-0.1, 6.3, 60), np.tile([0.0, 0.003, 0.4, 1.2, 1.56, -0.2], 10))
VIEWS = np.concatenate([AROUND, sd.ZENITH[None]]).reshape(1, -1, 3) * np.ones((2, 1, 1))


@pytest.fixture(params=["torch", "jax"])
def convert(request):
    """NumPy to an array of the library (JAX: float32)."""
    pytest.importorskip(request.param)
    if request.param == "torch":
        return importlib.import_module("torch").as_tensor
    return importlib.import_module("jax.numpy").asarray


def close(got, wanted, tolerance=2e-5):
    got = np.asarray(got.detach() if hasattr(got, "detach") else got)
    np.testing.assert_allclose(got, wanted, rtol=tolerance, atol=tolerance * np.abs(wanted).max())


@pytest.mark.parametrize("layout", LAYOUTS)
def test_the_same_light(layout, convert):
    sky = CapturedSky(LAYOUTS[layout], SUN)
    views = convert(VIEWS)
    for light in (sky.luminance, sky.xyz, sky.rgb):
        assert type(light(views)) is type(views)
        close(light(views), light(VIEWS), 1e-4)
    assert float(np.abs(np.asarray(sky.xyz(views))[VIEWS[..., 2] < 0]).max()) == 0


def test_gradients_with_respect_to_directions():
    torch = pytest.importorskip("torch")
    sky = CapturedSky(PICTURE, SUN)
    start = sd.direction(np.array([1.0, 2.2, 4.0]), np.array([0.3, 0.8, 1.3]))
    views = torch.tensor(start, requires_grad=True)
    sky.luminance(views).sum().backward()
    step = 1e-5 * np.eye(3)
    ends = [[sky.luminance(sd.unit(start + sign * s)) for s in step] for sign in (-1, 1)]
    slopes = (np.array(ends[1]) - np.array(ends[0])).T / 2e-5
    along = views.grad.numpy() - np.sum(views.grad.numpy() * start, axis=1, keepdims=True) * start
    np.testing.assert_allclose(along, slopes, rtol=1e-4, atol=1e-4 * np.abs(slopes).max())
    upright = torch.tensor(sd.ZENITH, requires_grad=True)
    sky.luminance(upright).backward()
    assert torch.isfinite(upright.grad).all()


def test_jit_vmap_and_grad_in_jax():
    jax = pytest.importorskip("jax")
    sky = CapturedSky(PICTURE, SUN)
    views = jax.numpy.asarray(VIEWS[0])
    close(jax.jit(sky.luminance)(views), sky.luminance(VIEWS[0]), 1e-4)
    close(jax.vmap(sky.luminance)(views), sky.luminance(VIEWS[0]), 1e-4)
    slope = jax.grad(lambda view: sky.luminance(view))(views[2])
    assert np.isfinite(np.asarray(slope)).all()


def test_integrals_turning_relighting_and_sums(convert):
    sky = CapturedSky(PICTURE, SUN).rotated(0.5).relit(20_000.0)
    normals = sd.direction(np.array([0.0, 1.0, 4.0]), np.array([1.5, 0.2, 0.7]))
    wanted = sd.illuminance(sky, normals)
    close(sd.illuminance(sky, convert(normals)), wanted, 1e-4)
    half = 0.5 * sky
    close(half.luminance(convert(VIEWS)), 0.5 * sky.luminance(VIEWS), 1e-4)
    directions, density = sd.sample(sky, 4000, seed=3, normal=convert(np.array(sd.ZENITH)))
    received = sky.luminance(directions) * directions[..., 2] / density
    assert float(np.mean(np.asarray(received))) == pytest.approx(float(sd.illuminance(sky)), rel=0.01)


def test_the_sun_exchanged_for_a_disc(convert):
    whole = sd.HosekWilkie(SUN, 3.0)
    picture = sd.render(whole + sd.SunDisc.of(whole), height=64)
    wanted = sd.illuminance(CapturedSky(picture, SUN).with_disc())
    exchanged = CapturedSky(picture, convert(SUN)).with_disc()
    close(sd.illuminance(exchanged), wanted, 1e-4)


def test_other_layouts_answer_without_gradients_and_say_so():
    torch, jax = pytest.importorskip("torch"), pytest.importorskip("jax")
    sky = CapturedSky(PICTURE.resampled(sd.Fisheye(), 64), SUN)
    close(sky.xyz(torch.as_tensor(VIEWS)), sky.xyz(VIEWS))
    with pytest.raises(TypeError, match="captured Fisheye map is looked up in NumPy, not traced"):
        jax.jit(sky.xyz)(jax.numpy.asarray(VIEWS[0]))
