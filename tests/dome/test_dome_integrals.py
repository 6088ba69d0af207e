"""Light on any plane, spectral too; exact patch means; spherical harmonics."""

import numpy as np
import pytest
from scipy.special import sph_harm_y

import skydome as sd
from skydome import deg
from skydome.dome.harmonics import cosine_lobe, harmonics
from skydome.dome.patches import patches
from skydome.ground.quadrature import hemisphere
from skydome.light.spectrum import xyz_weights

SUN = sd.direction(200 * deg, 40 * deg)
NORMALS = np.array([sd.direction(a * deg, t * deg) for a in range(0, 360, 45) for t in (-60, 0, 30, 60, 90)])


def spectral():
    sky = sd.HosekWilkie(SUN, turbidity=3.0, albedo=0.2)
    return sky, sky + sd.SunDisc.of(sky)


def test_spectral_irradiance_weighs_to_illuminance():
    bands = np.arange(380.0, 721.0, 10.0)
    sky, whole = spectral()
    light = sd.irradiance(sky, bands, NORMALS)
    assert light.shape == (len(NORMALS), len(bands))
    np.testing.assert_allclose((light @ xyz_weights(bands))[:, 1], sum_of_spectrum(sky, NORMALS, bands), rtol=1e-9)
    direct = sd.irradiance(whole, bands, SUN) - sd.irradiance(sky, bands, SUN)
    np.testing.assert_allclose(direct, sd.SunDisc.of(sky).irradiance(bands), rtol=1e-9)


def sum_of_spectrum(sky, normals, bands):
    """Illuminance from the spectral radiance toward the nodes, weighed first and summed then."""
    nodes, solid_angles = hemisphere(96, 192)
    luminance = (sky.radiance(nodes, bands) @ xyz_weights(bands))[:, 1]
    return np.maximum(normals @ nodes.T, 0) @ (luminance * solid_angles)


def test_ground_adds_its_share():
    sky, whole = spectral()
    level = float(sd.illuminance(whole))
    for tilt in (0, 60, 90, 180):
        normal = sd.direction(180 * deg, (90 - tilt) * deg)
        added = sd.illuminance(whole, normal, ground_albedo=0.3) - sd.illuminance(whole, normal)
        assert added == pytest.approx(0.3 * level * (1 - np.cos(tilt * deg)) / 2, abs=1e-9)
    grass = sd.Spectrum([400.0, 700.0], [0.1, 0.4])
    spectrum = [450.0, 550.0, 650.0]
    added = sd.irradiance(sky, spectrum, sd.SOUTH, ground_albedo=grass) - sd.irradiance(sky, spectrum, sd.SOUTH)
    np.testing.assert_allclose(added, sd.irradiance(sky, spectrum) * [0.15, 0.25, 0.35] / 2, rtol=1e-9)


def test_irradiance_of_a_day_and_in_torch():
    torch = pytest.importorskip("torch")
    suns = sd.direction(np.linspace(1.8, 4.5, 3), np.linspace(0.2, 0.9, 3))[:, None, :]
    sky = sd.HosekWilkie(suns, turbidity=3.0)
    whole = sky + sd.SunDisc.of(sky)
    day = sd.irradiance(whole, [450.0, 650.0], np.stack([sd.ZENITH, sd.SOUTH]), ground_albedo=0.2)
    assert day.shape == (3, 2, 2)
    assert sd.irradiance(whole, [450.0, 650.0]).shape == (3, 2)
    one = sd.HosekWilkie(torch.as_tensor(suns[1, 0]), turbidity=3.0)
    alone = sd.irradiance(one + sd.SunDisc.of(one), [450.0, 650.0], ground_albedo=0.2)
    np.testing.assert_allclose(alone.numpy(), day[1, 0], rtol=1e-9)


def test_refusals():
    with pytest.raises(ValueError, match="ground_albedo must lie"):
        sd.illuminance(sd.Uniform(1.0), ground_albedo=1.2)
    with pytest.raises(ValueError, match="ground_albedo must lie"):
        sd.irradiance(spectral()[0], [500.0], ground_albedo=-0.1)
    with pytest.raises(TypeError, match="Uniform knows no spectrum"):
        sd.irradiance(sd.Uniform(1.0), [500.0])
    with pytest.raises(ValueError, match="tolerance must lie"):
        sd.patch_means(sd.Uniform(1.0), tolerance=0.0)
    with pytest.raises(ValueError, match="order must be"):
        sd.SphericalHarmonics.of(sd.Uniform(1.0), 99)
    with pytest.raises(ValueError, match="coefficients must have shape"):
        sd.SphericalHarmonics(np.zeros(7))
    with pytest.raises(ValueError, match="must be a rotation"):
        sd.SphericalHarmonics(np.zeros(9)).rotated(np.diag([1.0, 1.0, -1.0]))


@pytest.mark.parametrize("division", ["tregenza", "reinhart:2", "equal-area:2"])
@pytest.mark.parametrize("name", ["cie-12", "hosek-wilkie"])
def test_patch_means_against_a_brute_sum(division, name):
    sky = sd.CIE(SUN, 12, zenith_luminance=4000.0) if name == "cie-12" else spectral()[0]
    cut = patches(division)
    means = sd.patch_means(sky, cut, tolerance=1e-5)
    some = np.unique(np.append(np.arange(0, cut.count, 7), cut.index(SUN[None])))
    bounds = cut.bounds[some]
    u = (np.arange(300) + 0.5) / 300
    z = np.sin(bounds[:, 0, None]) + (np.sin(bounds[:, 1]) - np.sin(bounds[:, 0]))[:, None] * u
    turn = bounds[:, 2, None] + (bounds[:, 3] - bounds[:, 2])[:, None] * u
    for k, patch in enumerate(some):
        nodes = sd.direction(turn[k][None, :], np.arcsin(z[k])[:, None])
        assert means[patch] == pytest.approx(sky.luminance(nodes).mean(), rel=1e-4)
    directions, solid_angles = hemisphere(300, 600)
    assert means @ cut.solid_angles == pytest.approx(sky.luminance(directions) @ solid_angles, rel=2e-5)


def test_patch_means_of_a_day_leave_the_disc_out():
    suns = sd.direction(np.linspace(1.8, 4.5, 4), np.linspace(0.2, 0.9, 4))[:, None, :]
    sky = sd.HosekWilkie(suns, turbidity=3.0)
    day = sd.patch_means(sky + sd.SunDisc.of(sky))
    assert day.shape == (4, 145)
    np.testing.assert_allclose(day[2], sd.patch_means(sd.HosekWilkie(suns[2, 0], turbidity=3.0)), rtol=2e-4)


def test_patch_means_of_a_disc_alone_are_dark():
    suns = sd.direction(np.zeros(2), np.array([0.3, 0.6]))
    for sun, shape in ((suns[0], (145,)), (suns[:, None], (2, 145))):
        means = sd.patch_means(sd.SunDisc(sun, direct_normal_illuminance=1e5))
        assert means.shape == shape
        assert not means.any()


def test_harmonics_are_orthonormal_and_scipys():
    upper, solid_angles = hemisphere(40, 80)
    both = np.concatenate([upper, upper * [1, 1, -1]])
    every = harmonics(both, 6)
    np.testing.assert_allclose(every.T @ (every * np.tile(solid_angles, 2)[:, None]), np.eye(49), atol=1e-12)
    theta, phi = np.arccos(both[:, 2]), np.arctan2(both[:, 1], both[:, 0])
    for degree in range(7):
        for m in range(-degree, degree + 1):
            known = sph_harm_y(degree, abs(m), theta, phi)
            real = known.real if m >= 0 else known.imag
            scale = (-1) ** m * np.sqrt(2) if m else 1.0
            np.testing.assert_allclose(every[:, degree**2 + degree + m], scale * real, atol=1e-12)


def test_the_nine_constants_of_ramamoorthi_and_hanrahan():
    x, y, z = v = sd.unit(np.array([0.3, -0.5, 0.7]))
    own = harmonics(v, 2)
    known = [0.282095, 0.488603 * y, 0.488603 * z, 0.488603 * x]
    known += [1.092548 * x * y, 1.092548 * y * z, 0.315392 * (3 * z * z - 1), 1.092548 * x * z]
    np.testing.assert_allclose(own, [*known, 0.546274 * (x * x - y * y)], atol=1e-6)
    lobes = [3.141593, 2.094395, 0.785398, 0, -0.130900, 0, 0.049087]
    np.testing.assert_allclose(cosine_lobe(6)[np.arange(7) ** 2], lobes, atol=1e-6)


def skies():
    return {
        "uniform": (sd.Uniform(1000.0), 1e-9),
        "overcast": (sd.MoonSpencer(zenith_luminance=1000.0), 0.006),
        "cie-12": (sd.CIE(SUN, 12, zenith_luminance=1000.0), 0.015),
        "hosek-wilkie": (spectral()[0], 0.025),
    }


@pytest.mark.parametrize("name", skies())
def test_irradiance_from_nine_coefficients(name):
    sky, bound = skies()[name]
    dense = sd.illuminance(sky, NORMALS)
    errors = [
        np.abs(sd.SphericalHarmonics.of(sky, n).irradiance(NORMALS) - dense).max() / dense.max() for n in (2, 4, 8)
    ]
    assert errors[0] < max(bound, 4e-4)
    assert errors[2] < max(bound / 8, 4e-4)


def test_the_disc_in_harmonics_is_a_point():
    _, whole = spectral()
    level = float(sd.SunDisc.of(whole).normal_xyz[1])
    only = sd.SphericalHarmonics.of(sd.SunDisc.of(whole), 12)
    assert only.irradiance(SUN) == pytest.approx(level, rel=0.02)


def test_rotation_turns_the_light():
    sky, _ = spectral()
    own = sd.SphericalHarmonics.of(sky, 5)
    turn = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
    turn = turn * np.sign(np.linalg.det(turn))
    np.testing.assert_allclose(own.rotated(turn).at(NORMALS @ turn.T), own.at(NORMALS), rtol=0, atol=1e-9 * 1e4)
    np.testing.assert_allclose(own.rotated(turn).irradiance(NORMALS @ turn.T), own.irradiance(NORMALS), atol=1e-4)
    c, s = np.cos(0.5), np.sin(0.5)
    clockwise = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1.0]])
    later = sd.HosekWilkie(sd.direction(200 * deg + 0.5, 40 * deg), turbidity=3.0, albedo=0.2)
    there = sd.SphericalHarmonics.of(later, 5).coefficients
    np.testing.assert_allclose(own.rotated(clockwise).coefficients, there, atol=2e-4 * np.abs(there).max())


def test_a_day_of_harmonics_in_colour_and_with_gradients():
    torch = pytest.importorskip("torch")
    suns = sd.direction(np.linspace(1.8, 4.5, 3), np.linspace(0.2, 0.9, 3))[:, None, :]
    sky = sd.HosekWilkie(suns, turbidity=3.0)
    day = sd.SphericalHarmonics.of(sky + sd.SunDisc.of(sky), 2)
    assert day.coefficients.shape == (3, 9)
    assert day.irradiance(NORMALS).shape == (3, len(NORMALS))
    colour = sd.SphericalHarmonics.of_colour(sky, 2)
    assert colour.coefficients.shape == (3, 3, 9)
    plain = sd.SphericalHarmonics.of(sky, 2).coefficients
    np.testing.assert_allclose(colour.coefficients[:, 1], plain, rtol=1e-6, atol=1e-6 * np.abs(plain).max())
    turbidity = torch.tensor(3.0, dtype=torch.float64, requires_grad=True)
    sd.SphericalHarmonics.of(sd.HosekWilkie(torch.as_tensor(SUN), turbidity=turbidity)).irradiance(sd.SOUTH).backward()
    assert torch.isfinite(turbidity.grad)
