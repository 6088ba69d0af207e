"""CapturedSky answers as a sky: light of the map, integrals, turning, relighting, sampling, refusals."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.skies.captured import CapturedSky


def photograph(height=128, elevation=40.0, disc=True):
    sun = sd.direction(137 * deg, elevation * deg)
    sky = sd.HosekWilkie(sun, 3.0)
    whole = sky + sd.SunDisc.of(sky) if disc else sky
    return sd.render(whole, height=height), sun, sky, whole


def test_light_is_the_models_light():
    picture, sun, sky, _ = photograph(disc=False)
    views = sd.direction(np.linspace(0, 6, 40), np.linspace(0.1, 1.5, 40))
    captured = CapturedSky(picture, sun)
    np.testing.assert_allclose(captured.luminance(views), sky.luminance(views), rtol=0.02)
    np.testing.assert_allclose(captured.rgb(views), sky.rgb(views), rtol=0.03, atol=0.01 * sky.rgb(views).max())
    np.testing.assert_allclose(captured.luminance(views), captured.xyz(views)[..., 1])
    assert (captured.luminance(-views) == 0).all()


def test_integrals_with_the_sun_are_the_models():
    picture, sun, _, whole = photograph()
    captured = CapturedSky(picture, sun)
    assert float(captured.illuminance()) == pytest.approx(float(sd.illuminance(whole)), rel=2e-3)
    exchanged = captured.with_disc()
    assert float(sd.illuminance(exchanged)) == pytest.approx(float(sd.illuminance(whole)), rel=0.02)
    facing = sd.direction(137 * deg, 0.0)
    assert float(sd.illuminance(exchanged, facing)) == pytest.approx(float(sd.illuminance(whole, facing)), rel=0.02)


def test_turning_and_relighting():
    picture, sun, _, _ = photograph(disc=False)
    captured = CapturedSky(picture, sun)
    turned = captured.rotated(0.7)
    view = sd.direction(1.0, 0.5)
    assert float(turned.luminance(sd.direction(1.7, 0.5))) == pytest.approx(float(captured.luminance(view)), rel=1e-6)
    assert np.allclose(turned.sun, sd.direction(137 * deg + 0.7, 40 * deg))
    assert float(captured.relit(1234.0).illuminance()) == pytest.approx(1234.0)


def test_sampling_estimates_the_illuminance():
    picture, sun, _, _ = photograph(disc=False)
    captured = CapturedSky(picture, sun)
    directions, density = sd.sample(captured, 4000, seed=3, normal=sd.ZENITH)
    estimate = np.mean(captured.luminance(directions) * directions[:, 2] / density)
    assert estimate == pytest.approx(float(sd.illuminance(captured)), rel=0.01)


def test_a_sky_without_a_known_sun_and_other_libraries():
    torch = pytest.importorskip("torch")
    captured = CapturedSky(photograph(64)[0])
    assert bool(captured.valid)
    assert float(sd.illuminance(captured)) > 0
    view = torch.tensor([0.0, 0.0, 1.0])
    assert captured.xyz(view).dtype == torch.float32
    assert "512" not in str(captured.parameters())


def test_bad_input():
    picture, sun, _, _ = photograph(32)
    broken = picture.pixels.copy()
    broken[3, 3, 0] = np.nan
    with pytest.raises(ValueError, match="must be finite, got 1 values of NaN"):
        CapturedSky(sd.EnvironmentMap(broken))
    with pytest.raises(TypeError, match="map must be an EnvironmentMap, got ndarray"):
        CapturedSky(broken)
    with pytest.raises(ValueError, match="is not known"):
        CapturedSky(picture).with_disc()
    with pytest.raises(ValueError, match="illuminance must be positive"):
        CapturedSky(picture, sun).relit(-1.0)
