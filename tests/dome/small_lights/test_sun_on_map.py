"""The sun's disc on texels: energy, place and the light on the ground, wherever it stands; larger suns."""

import numpy as np
import pytest

import skydome as sd

PLACES = [(az, el) for az in (0.0, 1.3, 217.3) for el in (0.4, 1.0, 3.0, 12.7, 45.3, 88.0, 90.0)]


def alone(azimuth, elevation, height, projection=None, size=None):
    disc = sd.SunDisc(sd.direction(azimuth * sd.deg, elevation * sd.deg), 3.0)
    disc = disc if size is None else disc.of_size(size)
    return sd.render(disc, height, projection=projection, ground_albedo=0.0), disc


@pytest.mark.parametrize("height", [32, 64, 256])
@pytest.mark.parametrize("place", PLACES, ids=str)
def test_horizontal_light_at_every_height(place, height):
    """Before, a sun of 3 degrees on 64 rows gave 1.33 times its light to the ground."""
    lit, disc = alone(*place, height)
    flux = float((lit.luminance() * lit.projection.solid_angles(height)).sum())
    assert flux == pytest.approx(float(disc.illuminance(disc.sun)), rel=2e-4)
    assert float(lit.illuminance()) == pytest.approx(float(disc.illuminance(sd.ZENITH)), rel=5e-3)
    assert lit.pixels.max() > 0


LAYOUTS = [(sd.EqualAreaSquare(), 96), (sd.EqualAreaSquare(), 32), (sd.CubeMap(), 192), (sd.CubeMap(), 96),
           (sd.CubeMap(), 48), (sd.Fisheye(), 128), (sd.Fisheye(), 32)]  # fmt: skip


@pytest.mark.parametrize(("projection", "height"), LAYOUTS, ids=str)
@pytest.mark.parametrize("place", PLACES, ids=str)
def test_horizontal_light_in_other_layouts(place, projection, height):
    """Before, at 0.4 degrees: 2 times its light on a square of 32 rows, up to 20 times on a fisheye."""
    lit, disc = alone(*place, height, projection)
    assert float(lit.illuminance()) == pytest.approx(float(disc.illuminance(sd.ZENITH)), rel=5e-3)


@pytest.mark.parametrize(("projection", "height"), LAYOUTS[:5], ids=str)
def test_its_energy_in_layouts_of_the_sphere(projection, height):
    """Exact but at the zenith of coarse faces, whose texels look aside; 1.7 % there, at eight texels a face."""
    for place in PLACES[:-2]:
        lit, disc = alone(*place, height, projection)
        flux = float((lit.luminance() * lit.projection.solid_angles(height)).sum())
        assert flux == pytest.approx(float(disc.illuminance(disc.sun)), rel=0.02 if height == 48 else 3e-3), place


@pytest.mark.parametrize("height", [32, 64, 128, 512])
def test_the_centre_of_light_is_the_suns(height):
    """Within 2 % of a texel above the lowest row; before, up to half a texel of 5.6 degrees."""
    for azimuth, elevation in [(217.3, 12.7), (100.1, 33.3), (3.0, 61.7)]:
        lit, disc = alone(azimuth, elevation, height)
        centre = lit.vector_illuminance()
        off = float(sd.angle_between(centre / np.linalg.norm(centre), disc.sun))
        assert off < 0.02 * np.pi / height


def test_the_brightest_texel_changes_smoothly_as_the_sun_moves():
    peaks = [alone(100.0 + step * 0.05, 30.0 + step * 0.02, 64)[0].luminance().max() for step in range(60)]
    assert np.max(np.abs(np.diff(peaks))) < 0.06 * max(peaks)


@pytest.mark.parametrize("kind", ["published", "preetham", "atmosphere"])
@pytest.mark.parametrize("width", [0.1, 2.0, 10.0])
def test_a_disc_of_another_size_has_the_same_light(kind, width):
    from skydome.skies.suns.atmosphere_sun import AtmosphereSun
    from skydome.skies.suns.preetham_sun import PreethamSun

    sun = sd.direction(2.0, 0.6)
    disc = {"published": sd.SunDisc(sun, 3.0), "preetham": PreethamSun(sun, 3.0), "atmosphere": AtmosphereSun(sun)}[
        kind
    ]
    other = disc.of_size(width / 2 * sd.deg)
    assert type(other) is type(disc)
    np.testing.assert_allclose(other.normal_xyz, disc.normal_xyz, rtol=1e-12)
    thinned = (np.sin(disc.angular_radius) / np.sin(width / 2 * sd.deg)) ** 2
    assert float(other.luminance(sun)) == pytest.approx(float(disc.luminance(sun)) * thinned, rel=1e-9)
    lit = sd.render(other, 256, ground_albedo=0.0)
    assert float(lit.illuminance()) == pytest.approx(float(disc.illuminance(sd.ZENITH)), rel=2e-3)


def test_the_size_by_radius_alone_keeps_the_radiance():
    sun = sd.direction(2.0, 0.6)
    wide, narrow = sd.SunDisc(sun, 3.0, 5 * sd.deg), sd.SunDisc(sun, 3.0)
    assert float(wide.luminance(sun)) == pytest.approx(float(narrow.luminance(sun)))
    assert float(wide.illuminance(sun)) > 300 * float(narrow.illuminance(sun))
