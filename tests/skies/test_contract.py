"""One contract for every sky: shapes, broadcasting, finite, non-negative, rotation, precisions, libraries."""

import importlib.util
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.ground.directions import rotate_about_vertical
from skydome.ground.quadrature import hemisphere

spec = importlib.util.spec_from_file_location("catalogue", Path(__file__).with_name("catalogue.py"))
catalogue = importlib.util.module_from_spec(spec)
spec.loader.exec_module(catalogue)
SKIES = catalogue.SKIES
SUNS = [0.001, 0.3, 5.0, 40.0, 89.999, 90.0]
VIEWS = np.concatenate([hemisphere(8, 12)[0], sd.direction(np.arange(6.0), np.zeros(6)), sd.ZENITH[None]])

every_sky = pytest.mark.parametrize("make", SKIES.values(), ids=SKIES.keys())


def sun_at(elevation, azimuth=137.0):
    return sd.direction(azimuth * sd.deg, elevation * sd.deg)


def views_with_sun(sun):
    return np.concatenate([VIEWS, sun[None], (sun * [-1, -1, 1])[None]])


@every_sky
@pytest.mark.parametrize("elevation", SUNS)
def test_finite_and_not_negative_everywhere(make, elevation):
    sun = sun_at(elevation)
    sky = make(sun, 1.0)
    light = sky.luminance(views_with_sun(sun))
    assert light.shape == (len(VIEWS) + 2,)
    assert np.isfinite(light).all()
    assert (light >= 0).all()
    assert light.max() > 0
    assert bool(sky.valid)


@every_sky
def test_black_below_the_horizon_and_at_night(make):
    sun = sun_at(30.0)
    assert (make(sun, 1.0).luminance(-VIEWS[:-7]) == 0).all()
    night = make(sun_at(-5.0), 1.0)
    if hasattr(night, "sun") or not night.is_day:
        assert not night.valid
        assert (night.luminance(VIEWS) == 0).all()


@every_sky
def test_a_day_of_suns_at_once(make):
    elevations = np.array([-10.0, 2.0, 20.0, 60.0])
    suns = sun_at(elevations)[:, None, :]
    sky = make(suns, np.ones((4, 1)))
    light = sky.luminance(VIEWS)
    assert light.shape == (4, len(VIEWS))
    for k, elevation in enumerate(elevations):
        np.testing.assert_allclose(light[k], make(sun_at(elevation), 1.0).luminance(VIEWS), rtol=1e-10, atol=1e-12)
    if isinstance(sky, sd.ColourSky):
        assert sky.xyz(VIEWS).shape == (4, len(VIEWS), 3)
    if isinstance(sky, sd.SpectralSky):
        assert sky.radiance(VIEWS, [450.0, 550.0]).shape == (4, len(VIEWS), 2)
    assert sd.illuminance(sky, sd.ZENITH).shape == (4,)
    assert sd.illuminance(sky, VIEWS[:5]).shape == (4, 5)


@every_sky
def test_rungs_agree(make):
    sky = make(sun_at(35.0), 1.0)
    if isinstance(sky, sd.ColourSky):
        np.testing.assert_allclose(sky.luminance(VIEWS), sky.xyz(VIEWS)[..., 1], rtol=1e-10)
        np.testing.assert_allclose(
            sky.rgb(VIEWS) @ np.array([0.2126, 0.7152, 0.0722]), sky.luminance(VIEWS), rtol=2e-4, atol=1e-9
        )


@every_sky
def test_turning_sky_and_view_changes_nothing(make):
    sun, turn = sun_at(25.0), 1.234
    turned = make(rotate_about_vertical(sun, turn), 1.0).luminance(rotate_about_vertical(VIEWS, turn))
    np.testing.assert_allclose(turned, make(sun, 1.0).luminance(VIEWS), rtol=1e-9, atol=1e-9)


@every_sky
def test_float32_stays_float32_and_close(make):
    sun = sun_at(40.0)
    views = views_with_sun(sun)[: len(VIEWS) + (0 if make is SKIES["sun-disc"] else 1)]
    reference = make(sun, 1.0).luminance(views)
    light = make(sun.astype(np.float32), np.float32(1.0)).luminance(views.astype(np.float32))
    assert light.dtype == np.float32
    np.testing.assert_allclose(light, reference, rtol=3e-5, atol=1e-5 * reference.max() if reference.max() else 0)


@every_sky
def test_torch_gives_the_same_with_gradients(make):
    torch = pytest.importorskip("torch")
    sun = sun_at(40.0)
    one = torch.tensor(1.0, dtype=torch.float64, requires_grad=True)
    toward = torch.tensor(sun, requires_grad=True)
    views = torch.tensor(views_with_sun(sun), requires_grad=True)
    sky = make(toward, one)
    light = sky.luminance(views)
    np.testing.assert_allclose(light.detach().numpy(), make(sun, 1.0).luminance(views_with_sun(sun)), rtol=1e-10)
    light.sum().backward()
    for leaf in (one, toward, views):
        assert leaf.grad is None or torch.isfinite(leaf.grad).all()
    assert one.grad is not None


@every_sky
def test_jax_gives_the_same_under_jit(make):
    jax = pytest.importorskip("jax")
    sun = sun_at(40.0)
    views = jax.numpy.asarray(views_with_sun(sun)[:-2])

    def light(sun, one):
        return make(sun, one).luminance(views)

    got = jax.jit(light)(jax.numpy.asarray(sun), jax.numpy.asarray(1.0))
    expected = make(sun, 1.0).luminance(views_with_sun(sun)[:-2])
    np.testing.assert_allclose(np.asarray(got), expected, rtol=2e-4, atol=2e-5 * expected.max())


@every_sky
def test_parameters_are_plain_data(make):
    import json

    text = json.dumps(make(sun_at(40.0), 1.0).parameters())
    assert '"model"' in text


def test_mixed_libraries_are_refused():
    torch = pytest.importorskip("torch")
    sky = sd.Preetham(torch.tensor(sun_at(40.0)), 3.0)
    with pytest.raises(TypeError, match="different libraries cannot be mixed, got numpy and torch"):
        sky.luminance(VIEWS)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: sd.HosekWilkie(sun_at(30), 0.5), r"turbidity must lie in \[1, 10\], got 0.5"),
        (lambda: sd.HosekWilkie(sun_at(30), 3.0, 1.2), r"albedo must lie in \[0, 1\], got 1.2"),
        (lambda: sd.Preetham(sun_at(30), 12.0), r"turbidity must lie in \[2, 6\], got 12"),
        (lambda: sd.Preetham(sun_at(30), float("nan")), "turbidity must lie in .* got nan"),
        (lambda: sd.CIE(sun_at(30), 16, zenith_luminance=1.0), "type must be an integer from 1 to 15, got 16"),
        (lambda: sd.CIE(sun_at(30), 12), "either zenith_luminance .* or illuminance .* got neither"),
        (lambda: sd.Perez(sun_at(30), -1.0, 0.2, 10, -3, 0.4, zenith_luminance=1.0), "b must lie in"),
        (lambda: sd.PerezAllWeather(sun_at(30), -5.0, 100.0), "direct_normal_irradiance must lie in"),
        (lambda: sd.PerezAllWeather(sun_at(30), 5.0, 100.0, compat="x"), "compat must be one of paper, gendaylit"),
        (lambda: sd.Uniform(-1.0), "value must lie in"),
        (lambda: sd.Preetham(sun_at(30) * 2, 3.0), "sun must be finite unit vectors"),
        (lambda: sd.Preetham([0.0, 1.0], 3.0), r"sun must have shape \(..., 3\), got \(2,\)"),
        (lambda: sd.Preetham(sun_at(30), 3.0, check="no"), "check must be one of"),
        (lambda: sd.blend(sd.Uniform(1.0), sd.Uniform(2.0), 1.5), r"fraction must lie in \[0, 1\], got 1.5"),
        (lambda: sd.Daylight(sd.Uniform(1.0), (0.0, 0.5)), "chromaticity must be"),
        (lambda: sd.HosekWilkie(sun_at(30), 3.0).radiance(sd.ZENITH, [800.0]), r"wavelengths must lie in \[320, 720\]"),
        (lambda: sd.Preetham(sun_at(30), 3.0).luminance([0.0, 0.0, 2.0]), "directions must be finite unit vectors"),
    ],
)
def test_bad_input_says_what_got_and_allowed(call, message):
    with pytest.raises(ValueError, match=message) as caught:
        call()
    assert "\n" not in str(caught.value)


def test_check_clamp_and_nan():
    sun = sun_at(30.0)
    clamped = sd.HosekWilkie(sun, 12.0, check="clamp")
    assert float(clamped.luminance(sd.ZENITH)) == float(sd.HosekWilkie(sun, 10.0).luminance(sd.ZENITH))
    assert not clamped.valid
    turbidity = np.array([[3.0], [12.0]])
    light = sd.HosekWilkie(sun, turbidity, check="nan").luminance(VIEWS)
    assert np.isfinite(light[0]).all()
    assert np.isnan(light[1]).all()
    assert sd.HosekWilkie(sun, turbidity, check="nan").valid.tolist() == [[True], [False]]
    assert sd.HosekWilkie(sun, 3.0, 1.4, check="clamp").valid.tolist() is False


def test_only_skies_add_to_skies():
    with pytest.raises(TypeError, match="only skies can be added to a sky, got float"):
        _ = sd.Uniform(1.0) + 2.0
