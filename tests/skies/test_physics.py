"""What must hold for any sky: closed forms, levels, energy."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import skydome as sd
from skydome.ground.quadrature import hemisphere
from skydome.skies.formula.perez_formula import horizontal_integral
from skydome.skies.suns.sun_disc import PUBLISHED_RADIUS, limb_mean


def test_uniform_sky_gives_pi():
    assert float(sd.illuminance(sd.Uniform(1.0))) == pytest.approx(np.pi, rel=1e-12)
    assert float(sd.illuminance(sd.Uniform(1.0), sd.NORTH)) == pytest.approx(np.pi / 2, rel=1e-4)
    assert float(sd.illuminance(sd.Uniform(1.0), -sd.ZENITH)) == 0


def test_overcast_sky_gives_seven_ninths_pi():
    assert float(sd.illuminance(sd.MoonSpencer(zenith_luminance=1.0))) == pytest.approx(7 * np.pi / 9, rel=1e-12)


def dense_illuminance(sky):
    directions, weights = hemisphere(1500, 1440)
    return float(np.sum(sky.luminance(directions) * directions[:, 2] * weights))


@pytest.mark.slow
@pytest.mark.parametrize("elevation", [0.5, 20.0, 89.5])
@pytest.mark.parametrize("kind", [1, 6, 12, 15])
def test_level_by_illuminance_is_exact_on_the_cies_skies(kind, elevation):
    sky = sd.CIE(sd.direction(1.0, elevation * sd.deg), kind, illuminance=1.0)
    assert dense_illuminance(sky) == pytest.approx(1.0, rel=1e-4)
    assert float(sd.illuminance(sky)) == pytest.approx(1.0, rel=1e-4)


@settings(max_examples=60, deadline=None)
@given(st.floats(0.5, 89.5), st.floats(0.0, 950.0), st.floats(1.0, 400.0))
def test_perez_keeps_the_given_irradiance(elevation, direct, diffuse):
    sun = sd.direction(2.0, elevation * sd.deg)
    sky = sd.PerezAllWeather(sun, direct, diffuse, check="clamp")
    directions, weights = hemisphere(300, 400)
    light = sky.broadband_radiance(directions)
    assert (light >= 0).all()
    assert light.any() == sky.valid  # a sky that is black all over is not valid
    if not light.any():
        return
    whole = light.all()
    if not whole:  # the edge of a partly black sky asks the rule that checks for more nodes
        directions, weights = hemisphere(1000, 1000)
        light = sky.broadband_radiance(directions)
    assert float(np.sum(light * directions[:, 2] * weights)) == pytest.approx(diffuse, rel=4e-4 if whole else 1e-3)


def test_perez_level_against_a_dense_rule():
    sun = sd.direction(2.0, 35 * sd.deg)
    directions, weights = hemisphere(1500, 1440)
    for direct, diffuse in ((0.0, 80.0), (100.0, 200.0), (400.0, 180.0), (850.0, 90.0)):
        for compat in ("paper", "gendaylit"):
            sky = sd.PerezAllWeather(sun, direct, diffuse, compat=compat)
            total = float(np.sum(sky.broadband_radiance(directions) * directions[:, 2] * weights))
            assert total == pytest.approx(diffuse, rel=1e-4)


def test_disc_irradiance_is_the_integral_of_its_radiance():
    sun = sd.direction(0.3, 0.8)
    disc = sd.SunDisc(sun, 3.0, PUBLISHED_RADIUS)
    t = (np.arange(4000) + 0.5) / 4000
    angle = t * PUBLISHED_RADIUS
    u = np.cross(sun, sd.ZENITH)
    u /= np.linalg.norm(u)
    views = np.cos(angle)[:, None] * sun + np.sin(angle)[:, None] * u
    ring = 2 * np.pi * np.sin(angle) * np.cos(angle) * PUBLISHED_RADIUS / 4000
    total = ring @ disc.radiance(views, [400.0, 550.0])
    np.testing.assert_allclose(total, disc.irradiance([400.0, 550.0]), rtol=1e-5)
    assert (limb_mean([400.0, 700.0]) < 1).all()


def test_disc_points_carry_the_disc():
    disc = sd.SunDisc(sd.direction(0.3, 0.8), 4.0)
    directions, light = disc.points(5000)
    np.testing.assert_allclose(light.sum(axis=0), disc.normal_xyz, rtol=1e-12)
    assert float(sd.angle_between(directions, disc.sun).max()) <= disc.angular_radius
    assert float(np.linalg.norm(directions.mean(axis=0) - disc.sun)) < 1e-5


def test_disc_of_a_given_irradiance():
    sun = sd.direction(0.3, 0.8)
    assert float(sd.SunDisc.from_irradiance(sun, 850.0, efficacy=100.0).illuminance(sun)) == pytest.approx(85_000)
    perez = sd.PerezAllWeather(sun, 700.0, 120.0)
    disc = sd.SunDisc.of(perez)
    assert float(disc.illuminance(sun)) == pytest.approx(float(perez.direct_normal_illuminance))
    with pytest.raises(TypeError, match=r"CIE does not tell how bright its sun is; give SunDisc"):
        sd.SunDisc.of(sd.CIE(sun, 12, zenith_luminance=1.0))


def test_sum_and_blend():
    sun = sd.direction(0.3, 0.8)
    sky, disc = sd.HosekWilkie(sun, 3.0), sd.SunDisc(sun, 3.0)
    views = np.stack([sun, sd.ZENITH, sd.NORTH])
    both = sky + disc
    np.testing.assert_allclose(both.luminance(views), sky.luminance(views) + disc.luminance(views))
    np.testing.assert_allclose(both.radiance(views, [500]), sky.radiance(views, [500]) + disc.radiance(views, [500]))
    expected = float(sd.illuminance(sky)) + float(disc.illuminance(sd.ZENITH))
    assert float(sd.illuminance(both)) == pytest.approx(expected)
    assert float(sd.illuminance((sky + disc) * 2.0)) == pytest.approx(2 * expected)
    grey = sd.Daylight(sd.MoonSpencer(zenith_luminance=5000.0))
    half = sd.blend(sky, grey, 0.25)
    np.testing.assert_allclose(half.xyz(views), 0.75 * sky.xyz(views) + 0.25 * grey.xyz(views), rtol=1e-12)


def test_spectral_albedo_lies_between_the_flat_ones():
    sun = sd.direction(0.3, 0.8)
    grass = sd.Spectrum([320, 500, 550, 600, 680, 720], [0.03, 0.05, 0.11, 0.07, 0.05, 0.4])
    sky = sd.HosekWilkie(sun, 3.0, grass)
    low, high = sd.HosekWilkie(sun, 3.0, 0.03), sd.HosekWilkie(sun, 3.0, 0.4)
    light = [model.radiance(sd.ZENITH, [320, 520, 720]) for model in (low, sky, high)]
    assert light[1][0] == pytest.approx(light[0][0], rel=1e-12)
    assert light[1][2] == pytest.approx(light[2][2], rel=1e-12)
    assert light[0][1] < light[1][1] < light[2][1]
    flat = sd.Spectrum([300, 800], [0.3, 0.3])
    for form in (sd.HosekWilkie, sd.HosekWilkieRGB):
        np.testing.assert_allclose(form(sun, 3.0, flat).xyz(sd.ZENITH), form(sun, 3.0, 0.3).xyz(sd.ZENITH), rtol=1e-12)


def test_preetham_spectrum_keeps_its_luminance():
    sky = sd.Preetham(sd.direction(0.3, 0.8), 3.0)
    wavelengths = np.arange(380.0, 781.0, 5.0)
    views = hemisphere(6, 8)[0]
    from skydome.light.spectrum import xyz_weights

    xyz = sky.radiance(views, wavelengths) @ xyz_weights(wavelengths)
    np.testing.assert_allclose(xyz[:, 1], sky.luminance(views), rtol=1e-3)
    np.testing.assert_allclose(xyz, sky.xyz(views), rtol=2e-2)


def test_horizontal_integral_of_every_perez_bin_is_that_of_a_dense_rule():
    from skydome.skies.formula.perez_formula import evaluate, from_perez, view_geometry
    from skydome.skies.formula.perez_table import distribution_letters

    directions, weights = hemisphere(1000, 1000)
    for epsilon in (1.0, 1.1, 1.3, 1.7, 2.2, 3.5, 5.0, 8.0):
        zenith = np.array(0.9)
        a, b, c, d, e = distribution_letters(np.array(epsilon), np.array(0.2), zenith)
        coefficients = from_perez(np.array(1.0), a, np.minimum(b, 0), c, d, e)
        view = view_geometry(directions, sd.direction(0.0, np.pi / 2 - 0.9))
        dense = float(np.sum(evaluate(coefficients, *view)[..., 0] * directions[:, 2] * weights))
        assert float(horizontal_integral(coefficients, zenith)[0]) == pytest.approx(dense, rel=1e-4)
