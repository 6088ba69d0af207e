"""Fits find the conditions of synthetic skies, say how well they know them, and say so when they cannot."""

import numpy as np
import pytest

import skydome as sd

SUNS = {"low": (2.1, 6.0), "middle": (4.0, 35.0), "high": (0.3, 71.0)}
MODELS = (sd.HosekWilkie, sd.HosekWilkieRGB, sd.Preetham)


def toward(name):
    azimuth, elevation = SUNS[name]
    return sd.direction(azimuth, elevation * sd.deg)


def degrees_off(found, sun):
    return float(sd.angle_between(found.parameters["sun"], sun)) / sd.deg


def spiral(count, lowest=0.01):
    k = np.arange(count)
    turn = k * np.pi * (3 - np.sqrt(5)) % (2 * np.pi)
    return sd.direction(turn, np.arcsin(lowest + (1 - lowest) * (k + 0.5) / count))


@pytest.mark.parametrize("sun", SUNS)
@pytest.mark.parametrize("turbidity", [2.4, 3.0, 5.5])
@pytest.mark.parametrize("model", MODELS)
def test_a_clean_map(model, turbidity, sun):
    picture = sd.render(model(toward(sun), turbidity), height=48)
    found = sd.fit(model, picture)
    assert found.success
    assert found.determined
    assert abs(found.parameters["turbidity"] - turbidity) < 1e-3
    assert degrees_off(found, toward(sun)) < 0.01
    assert found.relative_rms < 1e-4
    assert isinstance(found.residual, sd.EnvironmentMap)
    assert np.abs(found.residual.pixels).max() < 1e-3 * picture.pixels.max()


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize("half", ["with-sun", "east", "west"])
@pytest.mark.parametrize("sun", SUNS)
@pytest.mark.parametrize("model", MODELS)
def test_noise_of_a_tenth_and_half_of_the_sky_masked(model, sun, half, seed):
    turbidity = {1: 3.3, 2: 4.6}[seed]
    picture = sd.render(model(toward(sun), turbidity), height=96)
    random = np.random.default_rng(seed)
    noisy = sd.EnvironmentMap(
        picture.pixels * (1 + 0.1 * random.standard_normal(picture.pixels.shape)).astype(np.float32)
    )
    views = picture.projection.directions(96)
    facing = {"with-sun": toward(sun) * [1, 1, 0], "east": sd.EAST, "west": sd.WEST}[half]
    found = sd.fit(model, noisy, mask=views @ facing > 0)
    assert found.success
    assert abs(found.parameters["turbidity"] - turbidity) < 0.1
    assert degrees_off(found, toward(sun)) < 0.5


@pytest.mark.parametrize(
    "free", [("sun", "turbidity", "albedo"), ("sun", "turbidity", "scale"), ("turbidity", "albedo")]
)
def test_albedo_and_scale_too(free):
    sun, views = toward("middle"), spiral(900)
    sky = sd.HosekWilkie(sun, 3.7, 0.45) * (1.6 if "scale" in free else 1.0)
    initial = {} if "albedo" in free else {"albedo": 0.45}
    initial |= {} if "sun" in free else {"sun": sun}
    found = sd.fit(sd.HosekWilkie, views, sky.rgb(views), free=free, initial=initial)
    assert found.parameters["turbidity"] == pytest.approx(3.7, abs=1e-3)
    assert found.parameters.get("albedo", 0.45) == pytest.approx(0.45, abs=1e-3)
    assert found.parameters.get("scale", 1.6) == pytest.approx(1.6, abs=1e-3)
    assert set(found.parameters) == set(free)
    np.testing.assert_allclose(found.sky.rgb(views), sky.rgb(views), rtol=1e-4)


@pytest.mark.parametrize(
    "letters", [(-1.0, -0.32, 10.0, -3.0, 0.45), (-0.9, -0.2, 3.0, -2.0, 0.2), (-1.0, -0.55, 16.0, -3.0, 0.3)]
)
def test_perez_letters_and_level(letters):
    sun, views = toward("middle"), spiral(800)
    sky = sd.Perez(sun, *letters, illuminance=14_000.0)
    found = sd.fit(sd.Perez, views, sky.luminance(views))
    assert found.success
    assert degrees_off(found, sun) < 0.01
    for name, letter in zip("abcde", letters, strict=True):
        assert found.parameters[name] == pytest.approx(letter, abs=2e-3 * (1 + abs(letter)))
    assert found.parameters["illuminance"] == pytest.approx(14_000.0, rel=1e-3)


def test_a_cie_sky_is_found_as_perez_letters():
    """C of the CIE is not 1, so the letters come out divided by it, and the light agrees."""
    sun, views = toward("middle"), spiral(800)
    sky = sd.CIE(sun, 12, zenith_luminance=4000.0)
    found = sd.fit(sd.Perez, views, sky.luminance(views), free=("sun", "a", "b", "c", "d", "e", "zenith_luminance"))
    np.testing.assert_allclose(found.sky.luminance(views), sky.luminance(views), rtol=1e-4)
    assert found.relative_rms < 1e-5


@pytest.mark.parametrize("quantity", ["luminance", "xyz", "rgb"])
def test_every_quantity(quantity):
    sun, views = toward("high"), spiral(600)
    observed = getattr(sd.HosekWilkie(sun, 3.3), quantity)(views)
    found = sd.fit(sd.HosekWilkie, views, observed, space=None if quantity == "xyz" else sd.SRGB)
    assert abs(found.parameters["turbidity"] - 3.3) < 1e-3
    assert found.residual.shape == observed.shape


def test_standard_errors_tell_the_scatter():
    """Over thirty noisy fits the errors are as large as each fit says, within the scatter of thirty."""
    sun, views = toward("middle"), spiral(400)
    clean = sd.HosekWilkie(sun, 3.4).luminance(views)
    random = np.random.default_rng(11)
    fits = [
        sd.fit(sd.HosekWilkie, views, clean * (1 + 0.05 * random.standard_normal(400)), initial={"sun": sun})
        for _ in range(30)
    ]
    pulls = [(found.parameters["turbidity"] - 3.4) / found.standard_errors["turbidity"] for found in fits]
    assert 0.65 < np.std(pulls) < 1.4
    assert abs(np.mean(pulls)) < 0.75
    offs = np.array([degrees_off(found, sun) * sd.deg / found.standard_errors["sun"] for found in fits])
    assert 0.65 < np.sqrt(np.mean(offs**2)) < 1.4
    assert fits[0].covariance.shape == (3, 3)
    assert fits[0].names == ("sun_across", "sun_up", "turbidity")
    assert fits[0].relative_rms == pytest.approx(0.05, rel=0.15)


def test_weights_and_mask_leave_out_what_is_wrong():
    sun, views = toward("middle"), spiral(500)
    observed = sd.Preetham(sun, 3.3).luminance(views)
    cloud = views @ sd.NORTH > 0.7
    observed[cloud] *= 4
    clean = sd.fit(sd.Preetham, views, observed, mask=~cloud)
    weighted = sd.fit(sd.Preetham, views, observed, weights=np.where(cloud, 0.0, 1 / observed**2))
    for found in (clean, weighted):
        assert abs(found.parameters["turbidity"] - 3.3) < 1e-3
        assert degrees_off(found, sun) < 0.01
    assert np.isnan(clean.residual[cloud]).all()
    assert np.isfinite(clean.residual[~cloud]).all()
    observed[cloud] = np.nan
    assert abs(sd.fit(sd.Preetham, views, observed, mask=~cloud).parameters["turbidity"] - 3.3) < 1e-3


def test_two_levels_cannot_be_told_apart():
    views = spiral(300)
    sky = sd.Perez(toward("middle"), -1.0, -0.32, 10.0, -3.0, 0.45, illuminance=9000.0)
    held = {"sun": toward("middle"), "a": -1.0, "b": -0.32, "c": 10.0, "d": -3.0, "e": 0.45}
    found = sd.fit(sd.Perez, views, sky.luminance(views), free=("scale", "illuminance"), initial=held)
    assert not found.determined
    assert not found.success
    assert set(found.degenerate) == {"scale", "illuminance"}
    assert np.isnan(found.parameters["scale"])
    assert found.standard_errors["scale"] == np.inf
    assert "do not determine" in found.message
    np.testing.assert_allclose(found.sky.luminance(views), sky.luminance(views), rtol=1e-6)


def test_a_uniform_sky_tells_no_sun():
    views = spiral(300)
    found = sd.fit(sd.Perez, views, np.full(300, 2000.0), free=("sun", "illuminance"),
                   initial={"a": 0.0, "b": -1.0, "c": 0.0, "d": -1.0, "e": 0.0})  # fmt: skip
    assert found.degenerate == ("sun",)
    assert np.isnan(found.parameters["sun"]).all()
    assert found.parameters["illuminance"] == pytest.approx(2000 * np.pi, rel=1e-3)


def test_a_small_noisy_patch_far_from_the_sun_tells_little():
    sun = toward("middle")
    views = sd.unit(-sun * [1, 1, 0] + sd.ZENITH * 0.8 + 0.02 * np.random.default_rng(3).standard_normal((40, 3)))
    noisy = sd.HosekWilkie(sun, 3.0).luminance(views) * (1 + 0.3 * np.random.default_rng(5).standard_normal(40))
    found = sd.fit(sd.HosekWilkie, views, noisy, free=("sun", "turbidity", "scale"))
    assert not found.determined
    assert "sun" in found.degenerate
    assert np.isnan(found.parameters["sun"]).all()


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (
            lambda v, o: sd.fit(sd.Preetham, v[:3], o[:3]),
            "3 unknowns need more than 3 samples above the horizon, got 3",
        ),
        (lambda v, o: sd.fit(sd.Preetham, v, o, mask=np.zeros(50, bool)), "samples above the horizon, got 0"),
        (lambda v, o: sd.fit(sd.Preetham, -v, o), "samples above the horizon, got 0"),
        (lambda v, o: sd.fit(sd.Preetham, v, o[:-1]), r"observed must have shape \(50,\) or \(50, 3\)"),
        (lambda v, o: sd.fit(sd.Preetham, v, o * np.nan), "observed must be finite where it counts"),
        (lambda v, o: sd.fit(sd.Preetham, v, np.zeros((50, 3))), "observed must have light: above 0 somewhere"),
        (lambda v, o: sd.fit(sd.Preetham, v, 0 * o - 5), "got -5 to -5 with a mean of -5"),
        (lambda v, o: sd.fit(sd.Preetham, v, o, mask=np.ones(50)), "mask must be boolean"),
        (lambda v, o: sd.fit(sd.Preetham, v, o, mask=np.ones(7, bool)), r"mask must have shape \(50,\), got \(7,\)"),
        (lambda v, o: sd.fit(sd.Preetham, v, o, weights=-o), "weights must be finite and not negative"),
        (lambda v, o: sd.fit(sd.Preetham, v, o, free=("haze",)), "Preetham has no parameter 'haze'"),
        (lambda v, o: sd.fit(sd.Preetham, v, o, free=("sun", "sun")), "each once"),
        (lambda v, o: sd.fit(sd.Preetham, v, o, free=("sun",)), "Preetham needs turbidity"),
        (lambda v, o: sd.fit(sd.CIE, v, o, free=("sun", "type")), "free may name sun, turbidity"),
        (lambda v, o: sd.fit(sd.CIE, v, o), "free must name what is to be found of CIE"),
        (lambda v, o: sd.fit(sd.Preetham, v, o, initial={"sun": [0, 0, 2.0]}), "the initial sun must be finite unit"),
        (lambda v, o: sd.fit(sd.Preetham, v * 1.1, o), "directions must be finite unit vectors"),
    ],
)
def test_bad_input(call, message):
    views = spiral(50)
    with pytest.raises(ValueError, match=message) as caught:
        call(views, sd.Preetham(toward("middle"), 3.0).luminance(views))
    assert "\n" not in str(caught.value)


def test_colour_is_not_asked_of_luminance():
    views = spiral(50)
    with pytest.raises(TypeError, match="Perez knows luminance only"):
        sd.fit(sd.Perez, views, np.ones((50, 3)))
    with pytest.raises(TypeError, match="fit needs directions"):
        sd.fit(sd.Perez, views)


def test_air_of_the_physical_sky():
    """Sun and haze from a map; haze, exponent, ozone, lobe and ground from colours under a known sun."""
    sun, air = toward("middle"), {"aerosol_depth": 0.23, "albedo": 0.2}
    picture = sd.render(sd.PhysicalSky.from_numbers(sun=sun, **air), height=32)
    found = sd.fit(sd.PhysicalSky, picture, initial={"sun": sd.direction(4.05, 34 * sd.deg)})
    assert found.determined
    assert abs(found.parameters["aerosol_depth"] - 0.23) < 0.002
    assert degrees_off(found, sun) < 0.05
    low, views = toward("low"), spiral(300)
    air |= {"angstrom": 0.8, "ozone": 280.0, "asymmetry": 0.7}
    seen = sd.PhysicalSky.from_numbers(sun=low, **air).xyz(views)
    free = ("aerosol_depth", "angstrom", "ozone", "asymmetry", "albedo")
    found = sd.fit(sd.PhysicalSky, views, seen, free=free, initial={"sun": low}, space=None)
    for name in free:
        assert found.parameters[name] == pytest.approx(air[name], rel=0.03), name


def test_a_number_at_the_end_of_its_range_is_told():
    """Preetham's haze ends at turbidity 6; a sky of that much haze, and brighter still."""
    views, sun = sd.direction(np.arange(60) * 2.4 % 6.283, np.linspace(0.1, 1.5, 60)), sd.direction(2.0, 0.7)
    hazier = 1.3 * sd.Preetham(sun, 6.0).luminance(views)
    with pytest.warns(UserWarning, match="the fit of Preetham ended at a limit: turbidity"):
        sd.fit(sd.Preetham, views, hazier, initial={"sun": sun}, free=("turbidity",))
