"""The sun through bending air: what is seen of it, its shape, its light by points, by radiance and on maps."""

import tracemalloc

import numpy as np
import pytest

import skydome as sd
from skydome.light.spectrum import xyz_from_radiance
from skydome.skies.all_air import bent_sun
from skydome.skies.all_air.bent_sun import BentSun
from skydome.skies.suns.sun_disc import limb_darkening


def disc_at(elevation):
    return sd.SunDisc.of(sd.PhysicalSky(sd.direction(1.0, elevation * sd.deg)))


def test_high_suns_are_those_of_straight_rays():
    air, sun = sd.clear_air(), sd.direction(1.0, 50 * sd.deg)
    bent, straight = sd.SunDisc.of(sd.PhysicalSky(sun, air)), sd.AtmosphereSun(sun, air)
    assert isinstance(bent, BentSun)
    np.testing.assert_allclose(bent.normal_xyz, straight.normal_xyz, rtol=6e-4)  # columns of a table against quadrature
    np.testing.assert_allclose(sd.elevation(bent.sun) / sd.deg, 50.0 + 0.0137, atol=0.002)  # 1.0' cot(50), Bennett


def test_a_setting_sun_is_lifted_and_flat():
    """About 34' of lift and a fifth of the height gone, as every almanac has it."""
    disc = disc_at(-0.55)
    seen = disc.points(4000)[0]
    assert sd.elevation(disc.sun) / sd.deg == pytest.approx(0.0, abs=0.05)
    assert float(disc_at(-0.2).stretch) == pytest.approx(1.18, abs=0.06)
    width = np.ptp(sd.azimuth(seen)) / sd.deg
    assert width == pytest.approx(2 * disc.angular_radius / sd.deg, rel=0.02)


@pytest.mark.parametrize("elevation", [30.0, 2.0, -0.4])
def test_its_light_is_the_same_by_points_and_by_radiance(elevation):
    disc = disc_at(elevation)
    np.testing.assert_allclose(disc.points(500)[1].sum(axis=0), disc.normal_xyz, rtol=1e-9)
    side = np.linspace(-1.2, 1.2, 161) * disc.angular_radius
    across, up = sd.direction(1.0 + np.pi / 2, 0.0), np.cross(sd.direction(1.0 + np.pi / 2, 0.0), disc.sun)
    views = disc.sun + side[:, None, None] * across + side[:, None] * up
    views /= np.linalg.norm(views, axis=-1, keepdims=True)
    total = disc.xyz(views).sum(axis=(0, 1)) * (side[1] - side[0]) ** 2
    np.testing.assert_allclose(total, disc.normal_xyz, rtol=6e-3)


def test_what_has_set_gives_nothing():
    suns = sd.direction(1.0, np.array([[0.2], [-0.5], [-0.75], [-1.0]]) * sd.deg)
    light = sd.SunDisc.of(sd.PhysicalSky(suns)).normal_xyz[:, 0, 1]
    assert (np.diff(light) < 0).all()
    assert light[-1] == 0
    assert sd.PhysicalSky(suns).direct_normal_illuminance[:, 0] == pytest.approx(light)


def test_on_a_map():
    sky = sd.PhysicalSky(sd.direction(1.0, 3 * sd.deg))
    disc = sd.SunDisc.of(sky)
    with_sun, without = (sd.render(part, height=256).illuminance() for part in (sky + disc, sky))
    np.testing.assert_allclose(with_sun - without, disc.illuminance(sd.ZENITH), rtol=0.01)


def test_many_points_take_little_memory_and_have_the_same_light(monkeypatch):
    """Whole spectra of each point took 0.9 GB where maps ask for 262,144 of them."""
    disc = disc_at(1.0)
    tracemalloc.start()
    together = disc.points(1 << 14)
    whole = tracemalloc.get_traced_memory()[1]
    tracemalloc.reset_peak()
    monkeypatch.setattr(bent_sun, "AT_ONCE", 1 << 16)
    apart = disc.points(1 << 14)
    assert tracemalloc.get_traced_memory()[1] < 0.6 * whole
    tracemalloc.stop()
    np.testing.assert_array_equal(apart[0], together[0])
    np.testing.assert_allclose(apart[1], together[1], rtol=1e-12)


def test_points_of_straight_suns_have_the_limb_of_their_spectra():
    disc = sd.SunDisc(sd.direction(1.0, 0.2), 4.0)
    light = disc.points(50)[1]
    mu = np.sqrt(1 - (np.arange(50) + 0.5) / 50)
    spectra = limb_darkening(mu, disc.bands) * disc.centre_radiance(disc.bands)
    wanted = xyz_from_radiance(spectra, disc.bands)
    np.testing.assert_allclose(light / light.sum(axis=0), wanted / wanted.sum(axis=0), rtol=1e-12)
