"""Maps: the disc's energy at every height, the sky's own integral, the ground, every projection."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import skydome as sd

BLACK = {"ground_albedo": 0.0}


def disc_alone(sun, height, projection=None):
    disc = sd.SunDisc(sun, 3.0)
    lit = sd.render(disc, height, projection=projection, **BLACK)
    return lit, disc


SUNS = {
    "zenith": (0.0, 90.0),
    "seam": (0.0, 35.0),
    "texel corner": (90.0, 45.0),
    "anywhere": (217.3, 12.7),
    "low": (271.0, 0.6),
    "near the pole": (123.0, 89.8),
}


@pytest.mark.parametrize("height", [64, 128, 512, 1024, 4096])
@pytest.mark.parametrize("place", SUNS.values(), ids=SUNS.keys())
def test_disc_keeps_its_direct_normal_illuminance(place, height):
    azimuth, elevation = place
    sun = sd.direction(azimuth * sd.deg, elevation * sd.deg)
    lit, disc = disc_alone(sun, height)
    flux = float((lit.luminance().astype(np.float64) * lit.projection.solid_angles(height)).sum())
    expected = float(disc.illuminance(sun))
    assert flux == pytest.approx(expected, rel=1e-4)
    assert float(lit.illuminance(sun)) == pytest.approx(expected, rel=1e-3)


@settings(max_examples=25, deadline=None)
@given(st.floats(0.0, 360.0), st.floats(0.3, 90.0), st.sampled_from([64, 100, 256, 1000]))
def test_disc_energy_wherever_the_sun_falls(azimuth, elevation, height):
    sun = sd.direction(azimuth * sd.deg, elevation * sd.deg)
    lit, disc = disc_alone(sun, height)
    assert float(lit.illuminance(sun)) == pytest.approx(
        float(disc.illuminance(sun)), rel=2e-3
    )  # low suns lie on two rows of a coarse map


@pytest.mark.parametrize("projection", [sd.EqualAreaSquare(), sd.CubeMap(), sd.Fisheye()])
def test_disc_energy_in_other_projections(projection):
    sun = sd.direction(1.0, 0.6)
    height = 384
    lit, disc = disc_alone(sun, height, projection)
    angles = np.broadcast_to(projection.solid_angles(height), lit.pixels.shape[:2])
    assert float((lit.luminance() * angles).sum()) == pytest.approx(float(disc.illuminance(sun)), rel=1e-3)


def test_a_fine_disc_is_smooth_and_darker_at_the_limb():
    sun = sd.direction(90.02 * sd.deg, 30.03 * sd.deg)
    lit, disc = disc_alone(sun, 4096)
    brightness = lit.luminance()
    peak = brightness.max()
    assert peak == pytest.approx(float(disc.luminance(sun)), rel=0.02)
    row, column = np.unravel_index(brightness.argmax(), brightness.shape)
    assert float(sd.angle_between(lit.projection.directions(4096, slice(row, row + 1))[0, column], sun)) < 0.003
    inside = brightness[brightness > 0.5 * peak]
    assert 100 < inside.size < 160  # pi (0.2666 / 0.0439)^2 = 116


@pytest.mark.parametrize(
    "make",
    [
        lambda sun: sd.HosekWilkie(sun, 3.0, 0.2),
        lambda sun: sd.HosekWilkieRGB(sun, 8.0, 0.8),
        lambda sun: sd.Preetham(sun, 2.5),
        lambda sun: sd.Daylight(sd.CIE(sun, 12, illuminance=20_000.0)),
        lambda sun: sd.Daylight(sd.PerezAllWeather(sun, 700.0, 120.0)),
    ],
)
@pytest.mark.parametrize("elevation", [3.0, 30.0, 88.0])
def test_map_integrates_back_to_the_sky(make, elevation):
    sky = make(sd.direction(2.0, elevation * sd.deg))
    lit = sd.render(sky, 512, **BLACK)
    for normal in (sd.ZENITH, sd.direction(2.0, 0.5), sd.direction(5.0, 0.3)):
        assert float(lit.illuminance(normal)) == pytest.approx(float(sd.illuminance(sky, normal)), rel=1e-3)


def test_ground_is_lambertian_under_sky_and_sun():
    sun = sd.direction(2.0, 0.6)
    sky = sd.HosekWilkie(sun, 3.0, 0.35)
    full = sky + sd.SunDisc.of(sky)
    lit = sd.render(full, 64)
    brightness = lit.luminance()
    assert np.ptp(brightness[32:]) < 1e-3 * brightness[32:].max()
    assert brightness[40, 3] == pytest.approx(0.35 * float(sd.illuminance(full)) / np.pi, rel=1e-3)
    assert (sd.render(full, 64, ground_albedo=0.0).pixels[32:] == 0).all()
    grass = sd.Spectrum([380, 500, 550, 600, 780], [0.02, 0.03, 0.2, 0.04, 0.04])
    red, green, blue = sd.render(full, 64, ground_albedo=grass).pixels[50, 5]
    assert green > red
    assert green > blue


def test_map_is_symmetric_about_the_solar_meridian_and_right_way_round():
    sun = sd.direction(90 * sd.deg, 30 * sd.deg)  # east
    lit = sd.render(sd.HosekWilkie(sun, 3.0), 64, **BLACK)
    _, column = np.unravel_index(lit.luminance().argmax(), (64, 128))
    assert column in (31, 32)  # u = .25
    np.testing.assert_allclose(lit.pixels[:32, :64], lit.pixels[:32, 63::-1], rtol=2e-5)
    both = sd.render(sd.HosekWilkie(sun, 3.0) + sd.SunDisc(sun), 64, **BLACK).luminance()
    row, column = np.unravel_index(both.argmax(), both.shape)
    assert row == 21
    assert column in (31, 32)


def test_wider_spaces_show_the_same_light():
    sky = sd.HosekWilkie(sd.direction(2.0, 0.6), 3.0)
    plain = sd.render(sky, 64).luminance()
    for space in (sd.REC2020, sd.ACESCG):
        np.testing.assert_allclose(sd.render(sky, 64, space=space).luminance(), plain, rtol=2e-3)


def test_bad_requests():
    sun = sd.direction(2.0, 0.6)
    with pytest.raises(TypeError, match=r"CIE knows luminance only; give it a colour on purpose: skydome.Daylight"):
        sd.render(sd.CIE(sun, 12, zenith_luminance=1.0), 64)
    with pytest.raises(ValueError, match="height of an equirectangular map must be a multiple of 2"):
        sd.render(sd.HosekWilkie(sun, 3.0), 63)
    with pytest.raises(ValueError, match=r"ground_albedo must lie in \[0, 1\], got 1.5"):
        sd.render(sd.HosekWilkie(sun, 3.0), 64, ground_albedo=1.5)
    with pytest.raises(ValueError, match="one sky at a time"):
        sd.render(sd.HosekWilkie(np.stack([sun, sun])[:, None], 3.0), 64, ground_albedo=0.0)


def test_night_is_black():
    sky = sd.HosekWilkie(sd.direction(2.0, -0.2), 3.0)
    assert (sd.render(sky + sd.SunDisc.of(sky), 32).pixels == 0).all()


@pytest.mark.parametrize("albedo", [0.0, 0.8])
def test_the_ground_under_a_physical_sky_is_its_atmospheres(albedo):
    """Bare as held, alone as in a sum or multiplied: albedo x global illuminance / pi."""
    sun, air = sd.direction(azimuth=0.0, elevation=40 * sd.deg), sd.Atmosphere.from_turbidity(3.0, albedo=albedo)
    sky = sd.Nishita93(sun, air)
    for one, factor in ((sky, 1.0), (sd.held(sky), 1.0), (2.0 * sky, 2.0), (sky + sd.Nishita93(sun, air), 2.0)):
        ground = sd.render(one, height=32).pixels[-1, 0].astype(float)
        light = ground @ sd.SRGB.to_xyz[1]
        assert light == pytest.approx(albedo * factor * float(sd.illuminance(sky)) / np.pi, rel=0.003)


@pytest.mark.parametrize("kind", ["DiscreteOrdinates", "PathTraced"])
def test_the_ground_under_other_physical_skies(kind):
    pytest.importorskip({"DiscreteOrdinates": "nanodisort", "PathTraced": "numba"}[kind])
    sun, air = sd.direction(azimuth=0.0, elevation=40 * sd.deg), sd.Atmosphere.from_turbidity(3.0, albedo=0.8)
    others = {"relative_error": 0.3} if kind == "PathTraced" else {}
    assert getattr(sd, kind)(sun, air, **others).albedo == 0.8


def test_the_ground_under_a_blend_is_the_clear_skys():
    clear, overcast = (
        sd.HosekWilkie(sd.direction(2.0, 0.7), 3.0, albedo=0.7),
        sd.Daylight(sd.MoonSpencer(zenith_luminance=9000.0)),
    )
    whole = sd.blend(clear, overcast, 0.4)
    dark, own = (sd.render(whole, height=32, ground_albedo=a).pixels[-1, 0] for a in (0.35, None))
    assert own == pytest.approx(2 * dark, rel=1e-5)


def test_the_ground_under_nishita_in_numbers():
    """Held and bare have one ground: 3320, 3583 and 4014 cd m-2 of red, green and blue under air of turbidity 3."""
    from skydome.air.atmosphere import PREETHAM_HAZE

    air = sd.Atmosphere.from_turbidity(3.0, PREETHAM_HAZE, albedo=0.8, ozone=350.0)
    sky = sd.Nishita93(sd.direction(azimuth=0.0, elevation=40 * sd.deg), air)
    assert sd.render(sky, height=32).pixels[-1, 0] == pytest.approx([3319.8, 3582.9, 4013.8], rel=1e-4)
