"""Maps in the sky's own library: the same light as `render`, one map a sky, gradients as differences have them."""

import numpy as np
import pytest

import skydome as sd

SUN = (2.3, 0.6)


def full(sun, turbidity=3.0):
    sky = sd.HosekWilkie(sun, turbidity)
    return sky + sd.SunDisc.of(sky)


def lux(pixels):
    """Light on the horizontal, of NumPy maps (..., H, 2 H, 3)."""
    return np.array([float(sd.EnvironmentMap(one).illuminance()) for one in pixels.reshape(-1, *pixels.shape[-3:])])


@pytest.mark.parametrize("library", ["torch", "jax"])
def test_render_of_other_libraries_has_the_sun(library):
    """Before: 17,644 lx of 92,067."""
    arrays = pytest.importorskip(library) if library == "torch" else pytest.importorskip("jax").numpy
    expected = sd.render(full(sd.direction(*SUN)), 64)
    sun = arrays.asarray(sd.direction(*SUN))
    got = sd.render(full(sun, arrays.asarray(3.0)), 64)
    np.testing.assert_allclose(got.pixels, expected.pixels, rtol=2e-5 if library == "torch" else 2e-3, atol=1.0)
    assert float(got.illuminance()) == pytest.approx(float(sd.illuminance(full(sd.direction(*SUN)))), rel=3e-3)


@pytest.mark.parametrize("height", [32, 64])
@pytest.mark.parametrize("elevation", [1.0, 3.0, 35.0, 80.0])
def test_energy_and_horizontal_light(height, elevation):
    sky = full(sd.direction(2.3, elevation * sd.deg))
    pixels = sd.render_pixels(sky, height, ground_albedo=0.0)
    assert lux(pixels)[0] == pytest.approx(float(sd.illuminance(sky)), rel=5e-3)
    disc = sd.SunDisc(sd.direction(2.3, elevation * sd.deg), 3.0)
    alone = sd.render_pixels(disc, height, ground_albedo=0.0)
    flux = (alone @ sd.SRGB.to_xyz[1] * sd.Equirectangular().solid_angles(height)).sum()
    assert flux == pytest.approx(float(disc.illuminance(disc.sun)), rel=1e-6)


def test_away_from_the_sun_it_is_render():
    sky = full(sd.direction(*SUN))
    for layout in (sd.Equirectangular(), sd.target("blender").projection, sd.Equirectangular(1.0, mirrored=True)):
        a, b = sd.render(sky, 32, projection=layout, dtype=np.float64), sd.render_pixels(sky, 32, projection=layout)
        calm = a.pixels[..., 1] < 1e5
        assert calm.mean() > 0.99
        close = np.isclose(a.pixels, b, rtol=1e-9).all(axis=-1)
        assert (close | ~calm).mean() > 0.997  # the disc reaches a texel further
        assert np.unravel_index(a.luminance().argmax(), (32, 64)) == np.unravel_index(b[..., 1].argmax(), (32, 64))


@pytest.mark.parametrize("library", ["numpy", "torch", "jax"])
def test_one_map_a_sky(library):
    arrays = pytest.importorskip("jax").numpy if library == "jax" else pytest.importorskip(library)
    suns = sd.direction(np.array([[1.0], [2.0], [3.0]]), np.array([[0.2], [0.6], [1.2]]))
    turbidity = np.array([[2.0], [3.0], [6.0]])

    def maps(suns, turbidity):
        return sd.render_pixels(full(suns, turbidity), 32)

    once = pytest.importorskip("jax").jit(maps) if library == "jax" else maps
    pixels = np.asarray(once(arrays.asarray(suns), arrays.asarray(turbidity)))
    assert pixels.shape == (3, 32, 64, 3)
    for one, sun, haze in zip(pixels, suns[:, 0], turbidity[:, 0], strict=True):
        alone = sd.render_pixels(full(sun, haze), 32)
        np.testing.assert_allclose(one, alone, rtol=1e-9 if library != "jax" else 2e-2, atol=1.0)
    np.testing.assert_allclose(lux(pixels), np.asarray(sd.illuminance(full(suns, turbidity))).ravel(), rtol=5e-3)
    shared = sd.render_pixels(full(suns[0, 0], turbidity), 32)
    assert shared.shape == (3, 32, 64, 3)
    with pytest.raises(ValueError, match="render_pixels gives one map a sky"):
        sd.render(full(suns, turbidity), 32)


def test_gradients_are_differences():
    torch = pytest.importorskip("torch")
    weights = torch.tensor(np.random.default_rng(3).random((16, 32, 3)))

    def value(azimuth, elevation, turbidity):
        return (sd.render_pixels(full(sd.direction(azimuth, elevation), turbidity), 16) * weights).sum()

    start = [torch.tensor(v, dtype=torch.float64, requires_grad=True) for v in (2.31, 0.63, 3.3)]
    value(*start).backward()
    for k in range(3):
        ends = []
        for sign in (-1, 1):
            moved = [v.detach().clone() for v in start]
            moved[k] += sign * 1e-6
            ends.append(float(value(*moved)))
        assert float(start[k].grad) == pytest.approx((ends[1] - ends[0]) / 2e-6, rel=1e-4)


def test_jax_compiles_it():
    jax = pytest.importorskip("jax")

    def light(turbidity):
        return sd.render_pixels(full(jax.numpy.asarray(sd.direction(*SUN)), turbidity), 16).sum()

    compiled = jax.jit(jax.grad(light))(jax.numpy.asarray(3.0))
    assert np.isfinite(float(compiled))


def test_bad_requests():
    sky = full(sd.direction(*SUN))
    with pytest.raises(TypeError, match="equirectangular maps alone, got CubeMap"):
        sd.render_pixels(sky, 12, projection=sd.CubeMap())
    with pytest.raises(TypeError, match="knows luminance only"):
        sd.render_pixels(sd.Uniform(1.0), 16)
    with pytest.raises(ValueError, match=r"ground_albedo must lie in \[0, 1\], got 2"):
        sd.render_pixels(sky, 16, ground_albedo=2.0)
