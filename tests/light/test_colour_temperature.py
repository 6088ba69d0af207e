import numpy as np
import pytest

from skydome.light.colour import xyz_from_xyY
from skydome.light.colour_temperature import colour_temperature, duv, planck
from skydome.light.spectrum import xyz_from_radiance

WAVELENGTHS = np.arange(360.0, 831.0)
TEMPERATURES = np.geomspace(1500, 40000, 80)


def xyz_of_uv(uv):
    total = 2 * uv[..., 0] - 8 * uv[..., 1] + 4
    return xyz_from_xyY(np.stack([3 * uv[..., 0] / total, 2 * uv[..., 1] / total, np.ones_like(total)], axis=-1))


def test_a_black_body_has_its_own_temperature():
    xyz = xyz_from_radiance(planck(WAVELENGTHS, TEMPERATURES), WAVELENGTHS)
    np.testing.assert_allclose(colour_temperature(xyz), TEMPERATURES, rtol=5e-5)
    np.testing.assert_allclose(duv(xyz), 0, atol=1e-6)


@pytest.mark.parametrize("offset", [-0.03, -0.01, 0.0, 0.01, 0.03])
def test_against_colour_science(colour, offset):
    from colour.temperature import CCT_to_uv, uv_to_CCT

    uv = np.array([CCT_to_uv([kelvin, offset], method="Ohno 2013") for kelvin in TEMPERATURES])
    theirs = np.array([uv_to_CCT(point, method="Ohno 2013") for point in uv])
    np.testing.assert_allclose(colour_temperature(xyz_of_uv(uv)), theirs[:, 0], rtol=2e-4)
    np.testing.assert_allclose(duv(xyz_of_uv(uv)), offset, atol=2e-6)


def test_illuminant_a_and_d65():
    # CIE 15: illuminant A is 2856 K (2855.5 K with today's c2), D65 6504 K.
    xy = np.array([[0.44758, 0.40745, 1.0], [0.31272, 0.32903, 1.0]])
    np.testing.assert_allclose(colour_temperature(xyz_from_xyY(xy)), [2855.5, 6503.5], atol=2)


def test_bluer_than_every_black_body_is_infinite():
    endless = xyz_from_radiance(planck(WAVELENGTHS, 1e9), WAVELENGTHS)
    assert colour_temperature(endless) > 1e7
    assert colour_temperature([40.0, 40.0, 90.0]) == np.inf
    assert np.isfinite(duv([40.0, 40.0, 90.0]))


def test_black_and_too_red_are_nan():
    assert np.isnan(colour_temperature([0.0, 0.0, 0.0]))
    assert np.isnan(duv([0.0, 0.0, 0.0]))
    assert np.isnan(colour_temperature(xyz_from_radiance(planck(WAVELENGTHS, 700.0), WAVELENGTHS)))


def test_shapes_and_level():
    xyz = np.random.default_rng(1).uniform(50, 60, (4, 5, 3))
    assert colour_temperature(xyz).shape == (4, 5)
    np.testing.assert_allclose(colour_temperature(1e-6 * xyz), colour_temperature(xyz), rtol=1e-9)


def test_planck_obeys_stefan_boltzmann():
    wavelengths = np.geomspace(100, 1e6, 20001)
    total = np.trapezoid(planck(wavelengths, 5772.0), wavelengths)
    assert total == pytest.approx(5.670374419e-8 * 5772.0**4 / np.pi, rel=1e-4)


def test_planck_edges():
    assert planck(WAVELENGTHS, np.full((2, 3), 5000.0)).shape == (2, 3, WAVELENGTHS.size)
    assert np.isfinite(planck([1.0, 1e9], [1.0, 1e12])).all()
    with pytest.raises(ValueError, match=r"> 0 K, got -1\.0"):
        planck([500], -1.0)
