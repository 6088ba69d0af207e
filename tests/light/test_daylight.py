import numpy as np
import pytest

import skydome as sd
from skydome.ground.tables import columns
from skydome.light.colour import xyY_from_xyz, xyz_from_xyY
from skydome.light.daylight import daylight_basis, daylight_spectrum
from skydome.light.spectrum import xyz_from_radiance

TENS = np.arange(380.0, 781.0, 10.0)

# CIE 15:2004, Table T.1, D65 at 10 nm from 380 nm, 100 at 560 nm
D65 = """49.9755 54.6482 82.7549 91.4860 93.4318 86.6823 104.865 117.008 117.812 114.861 115.923 108.811 109.354 107.802
104.790 107.689 104.405 104.046 100.000 96.3342 95.7880 88.6856 90.0062 89.5991 87.6987 83.2886 83.6992 80.0268 80.2146
82.2778 78.2842 69.7213 71.6091 74.3490 61.6040 69.8856 75.0870 63.5927 46.4182 66.8054 63.3828"""
D65 = np.array(D65.split(), dtype=float)


def literal_a5(x, y):
    """Preetham 1999, A.5, as printed."""
    table = columns("preetham_1999_table_2")
    below = 0.0241 + 0.2562 * x - 0.7341 * y
    m1 = (-1.3515 - 1.7703 * x + 5.9114 * y) / below
    m2 = (0.0300 - 31.4424 * x + 30.0717 * y) / below
    return table["S0"] + m1 * table["S1"] + m2 * table["S2"]


def relative(x, y):
    spectrum = daylight_spectrum(xyz_from_xyY([x, y, 5000.0]), TENS)
    return 100 * spectrum / spectrum[18]


@pytest.mark.parametrize(("x", "y"), [(0.31272, 0.32903), (0.25, 0.26), (0.40, 0.39), (0.2661, 0.2807)])
def test_shape_is_that_of_the_paper(x, y):
    literal = literal_a5(x, y)
    np.testing.assert_allclose(relative(x, y), 100 * literal / literal[18], rtol=1e-11)


def test_d65_is_the_published_one():
    # From CIE's chromaticity of the locus at 6503.6 K; its M1 and M2 are rounded to three decimals.
    kelvin = 6500 * 1.4388 / 1.4380
    x = 0.244063 + 0.09911e3 / kelvin + 2.9678e6 / kelvin**2 - 4.6070e9 / kelvin**3
    np.testing.assert_allclose(relative(x, -3 * x**2 + 2.87 * x - 0.275), D65, rtol=2e-3)
    # From the chromaticity that D65 has, 1e-4 away in y, which is what the digits of A.5 leave.
    np.testing.assert_allclose(relative(0.31272, 0.32903), D65, rtol=5e-3)


def test_published_values_are_those_of_colour_science(colour):
    np.testing.assert_allclose(D65, colour.SDS_ILLUMINANTS["D65"][TENS], rtol=1e-6)


@pytest.mark.parametrize("kelvin", [4000, 5000, 6500, 10000, 24900])
def test_colour_comes_back(colour, kelvin):
    x, y = colour.temperature.CCT_to_xy_CIE_D(kelvin * 1.4388 / 1.4380)
    xyz = xyz_from_radiance(daylight_spectrum(xyz_from_xyY([x, y, 3000.0]), TENS), TENS)
    np.testing.assert_allclose(xyY_from_xyz(xyz)[:2], [x, y], atol=1e-4)
    assert xyz[1] == pytest.approx(3000.0, rel=1e-12)


def test_luminance_is_kept_on_a_fine_grid():
    fine = np.arange(380.0, 781.0)
    xyz = np.random.default_rng(3).uniform([90, 100, 60], [100, 110, 200], (50, 3))
    np.testing.assert_allclose(xyz_from_radiance(daylight_spectrum(xyz, fine), fine)[:, 1], xyz[:, 1], rtol=1e-3)


def test_shapes_black_and_bounds():
    assert daylight_spectrum(np.ones((2, 4, 3)), [400, 500]).shape == (2, 4, 2)
    np.testing.assert_array_equal(daylight_spectrum([0.0, 0.0, 0.0], TENS), 0)
    for wavelengths in ([379.9, 500], [500, 780.1]):
        with pytest.raises(ValueError, match=r"must lie in \[380, 780\] nm, got"):
            daylight_basis(wavelengths)


def test_table_2_marks_what_the_paper_leaves_out():
    table = columns("preetham_1999_table_2")
    assert np.isnan(table["sun_radiance"][-3:]).all()
    assert np.isfinite(table["sun_radiance"][:-3]).all()
    assert table["sun_radiance"][17] == 25503.8
    assert table["k_o"][0] == 0
    assert table["k_wa"][34] == 100


def test_gradient_flows_and_is_finite():
    torch = pytest.importorskip("torch")
    xyz = torch.tensor([[95.0, 100.0, 108.0], [0.0, 0.0, 0.0]], dtype=torch.float64, requires_grad=True)
    daylight_spectrum(xyz, TENS).sum().backward()
    assert torch.isfinite(xyz.grad).all()


def test_jax_compiles_it():
    jax = pytest.importorskip("jax")
    xyz = np.array([[95.0, 100.0, 108.0]])
    compiled = jax.jit(lambda colour: daylight_spectrum(colour, TENS))
    np.testing.assert_allclose(compiled(jax.numpy.asarray(xyz)), daylight_spectrum(xyz, TENS), rtol=1e-4)


@pytest.mark.parametrize("elevation", [1.0, 4.0, 8.0, 15.0, 20.0, 24.9])
def test_no_spectrum_is_negative_and_luminance_is_kept(elevation):
    """The series of a low sun's saturated colours is cut at 0 (before: 2 to 25 % of directions negative somewhere)."""
    sun = sd.direction(3.0, np.radians(elevation))
    views = sd.direction(*np.random.default_rng(1).uniform((0, 0), (6.28, 1.57), (500, 2)).T)
    table = np.arange(380.0, 781.0, 10.0)
    for turbidity in (2.0, 3.0, 6.0):
        sky = sd.Preetham(sun, turbidity)
        light = sky.radiance(views, table)
        assert light.min() >= 0
        luminance = xyz_from_radiance(light, table)[..., 1]
        np.testing.assert_allclose(luminance, sky.luminance(views), rtol=2e-3)
        np.testing.assert_allclose(sky.radiance(views, [450.0, 650.0]), light[:, [7, 27]], rtol=1e-9, atol=1e-12)


def test_above_the_limit_the_quick_form_is_the_whole_one():
    sky = sd.Preetham(sd.direction(3.0, np.radians(26.0)), 3.0)
    views = sd.direction(*np.random.default_rng(1).uniform((0, 0), (6.28, 1.57), (500, 2)).T)
    wavelengths = [400.0, 550.0, 700.0]
    whole = sd.daylight_spectrum(sky.xyz(views), wavelengths)
    np.testing.assert_allclose(sky.radiance(views, wavelengths), whole, rtol=1e-9)
