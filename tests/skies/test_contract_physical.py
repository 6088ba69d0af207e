"""The contract of skies that compute in NumPy: physical, refitted, held and captured ones."""

import importlib.util
import json
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.ground.directions import rotate_about_vertical

pytest.importorskip("nanodisort")
spec = importlib.util.spec_from_file_location("catalogue", Path(__file__).with_name("catalogue.py"))
catalogue = importlib.util.module_from_spec(spec)
spec.loader.exec_module(catalogue)

SUNS = [0.5, 3.0, 20.0, 89.9, 90.0]
TURN = np.arange(14.0) % (2 * np.pi)
VIEWS = np.concatenate(
    [sd.direction(TURN, np.linspace(0.03, 1.5, 14)), sd.direction(TURN[:3], np.zeros(3)), sd.ZENITH[None]]
)
TRACED = ("path-traced", "physical")
every_sky = pytest.mark.parametrize("name", catalogue.PHYSICAL)


def sun_at(elevation, azimuth=137.0):
    return sd.direction(azimuth * sd.deg, elevation * sd.deg)


def make(name, sun):
    return catalogue.PHYSICAL[name](sun)


@every_sky
@pytest.mark.parametrize("elevation", SUNS)
def test_finite_and_not_negative_everywhere(name, elevation):
    sun = sun_at(elevation)
    sky = make(name, sun)
    views = np.concatenate([VIEWS, sun[None], (sun * [-1, -1, 1])[None]])
    light = sky.radiance(views, [450.0])[..., 0] if name in TRACED else sky.luminance(views)
    assert light.shape == (len(views),)
    assert np.isfinite(light).all()
    assert (light >= 0).all()
    assert light.max() > 0
    assert bool(sky.valid) or (name == "refitted" and elevation < 1)


@every_sky
def test_black_below_the_horizon(name):
    below = -VIEWS[:14]
    sky = make(name, sun_at(30.0))
    assert (sky.luminance(below) == 0).all()
    assert (sky.xyz(below) == 0).all()


@pytest.mark.parametrize("name", [name for name in catalogue.PHYSICAL if name not in catalogue.ANY_SUN])
@pytest.mark.parametrize("beyond", [1.5, -0.3])
def test_light_and_validity_end_at_the_same_sun(name, beyond):
    sun = sun_at(catalogue.LOWEST.get(name, 0.0) + beyond)
    sky, views = make(name, sun), np.concatenate([VIEWS, sun[None]])
    light = sky.radiance(views, [450.0]) if name in TRACED else sky.luminance(views)
    assert np.isfinite(light).all()
    assert (light >= 0).all()
    assert bool(sky.valid) == bool(sky.is_day) == (light.max() > 0) == (beyond > 0)


@every_sky
def test_rungs_agree(name):
    sky = make(name, sun_at(35.0))
    np.testing.assert_allclose(sky.luminance(VIEWS), sky.xyz(VIEWS)[..., 1], rtol=1e-10)
    y = sky.rgb(VIEWS) @ np.array([0.2126, 0.7152, 0.0722])
    np.testing.assert_allclose(y, sky.luminance(VIEWS), rtol=2e-4)
    if isinstance(sky, sd.SpectralSky):
        light = sky.radiance(VIEWS.reshape(2, 9, 3), [450.0, 550.0])
        assert light.shape == (2, 9, 2)
        assert (light >= 0).all()


@every_sky
def test_turning_sky_and_view_changes_nothing(name):
    sun, turn = sun_at(25.0), 2 * np.pi / 8  # of maps, 16 columns of 128
    turned = make(name, rotate_about_vertical(sun, turn)).luminance(rotate_about_vertical(VIEWS, turn))
    # the tracer's random numbers know the compass, as the cells of clouds do; maps know it to a texel, and the ground
    # begins within one
    own = {"path-traced": 0.6, "captured-with-sun": 1e-3, "captured-square": 0.03, "cloudy": 1e-4}
    rtol = own.get(name, 1e-6)
    seen = slice(2, 14) if name == "captured-square" else slice(None)
    np.testing.assert_allclose(turned[seen], make(name, sun).luminance(VIEWS)[seen], rtol=rtol)


@every_sky
def test_single_precision_is_close(name):
    sun = sun_at(40.0)
    light = make(name, sun.astype(np.float32)).luminance(VIEWS.astype(np.float32))
    rtol = 0.6 if name == "path-traced" else 1e-4
    np.testing.assert_allclose(light, make(name, sun).luminance(VIEWS), rtol=rtol)


@every_sky
def test_a_day_of_suns_at_once(name):
    elevations = np.array([-10.0, 6.0, 20.0, 60.0])
    suns = sun_at(elevations)[:, None, :]
    if name in catalogue.ONE_SUN:
        with pytest.raises((ValueError, IndexError), match=r"one sun|shape \(3,\)|index|truth value"):
            make(name, suns)
        return
    if name == "physical":
        suns, elevations = suns[1:], elevations[1:]  # low suns one at a time, as its error says
    light = make(name, suns).luminance(VIEWS)
    if name in ("captured-square", "scanned"):
        assert light.shape == (len(VIEWS),)  # a photograph, or a scan, has one sun, its own
        return
    assert light.shape == (len(elevations), len(VIEWS))
    for k, elevation in enumerate(elevations):
        np.testing.assert_allclose(light[k], make(name, sun_at(elevation)).luminance(VIEWS), rtol=1e-9, atol=1e-12)
    if name == "refitted":  # the others take seconds for it
        assert sd.illuminance(make(name, suns), sd.ZENITH).shape == (len(elevations),)


@every_sky
def test_sums_and_multiples(name):
    sky = make(name, sun_at(35.0))
    doubled, mixed = sky * 2.0, sky + sd.Daylight(sd.Uniform(100.0))
    np.testing.assert_allclose(doubled.luminance(VIEWS), 2 * sky.luminance(VIEWS), rtol=1e-12)
    np.testing.assert_allclose(mixed.luminance(VIEWS), sky.luminance(VIEWS) + 100.0, rtol=1e-6)
    blend = sd.blend(sky, sd.Daylight(sd.Uniform(100.0)), 0.25)
    np.testing.assert_allclose(blend.luminance(VIEWS), 0.75 * sky.luminance(VIEWS) + 25.0, rtol=1e-6)


@every_sky
def test_parameters_are_plain_data(name):
    assert '"model"' in json.dumps(make(name, sun_at(40.0)).parameters())


def test_every_public_sky_is_under_the_contract():
    """Each class of sky has its line in the catalogue; those of the night have tests of their own."""
    public = {name for name in sd.__all__ if isinstance(kind := getattr(sd, name), type) and issubclass(kind, sd.Sky)}
    made = {type(part).__name__ for sky in catalogue.PHYSICAL.values() for part in members(sky(sun_at(35.0)))}
    made |= {type(part).__name__ for sky in catalogue.SKIES.values() for part in members(sky(sun_at(35.0), 1.0))}
    abstract = {"Sky", "ColourSky", "SpectralSky", "Combination"}
    of_the_night = {
        "Moonlight",
        "MoonDisc",
        "Stars",
        "Planets",
        "Starlight",
        "ZodiacalLight",
        "Airglow",
        "SkyGlow",
        "WholeSky",
    }
    assert public - abstract - of_the_night - made == set()


def members(sky):
    """The sky and all that it is made of."""
    found = [sky]
    for part in getattr(sky, "members", ()):
        found += members(part)
    return found
