"""Sky bands: closed forms, convergence to the dense integral, any plane, torch and a day at once."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.ground.quadrature import hemisphere
from skydome.surroundings.bands import Bands

SUN = sd.direction(200 * deg, 40 * deg)
PLANES = {
    "level": sd.ZENITH,
    "south wall": sd.SOUTH,
    "north wall": sd.NORTH,
    "facing the sun": SUN,
    "roof": sd.direction(300 * deg, 60 * deg),
    "overhang": sd.direction(60 * deg, -20 * deg),
}


def skies(elevation):
    sun = sd.direction(200 * deg, elevation * deg)
    return {
        "cie-12": sd.CIE(sun, 12, zenith_luminance=4000.0),
        "hosek-wilkie": sd.HosekWilkie(sun, turbidity=3.0, albedo=0.2),
        "hazy": sd.HosekWilkie(sun, turbidity=8.0, albedo=0.2),
    }


def dense(sky, normal):
    directions, solid_angles = hemisphere(500, 1000)
    return sky.luminance(directions) @ (np.maximum(directions @ normal, 0) * solid_angles)


@pytest.mark.parametrize("count", [1, 2, 7, 64])
@pytest.mark.parametrize("plane", PLANES)
def test_uniform_bands_add_up_to_pi(count, plane):
    bands = Bands.of(PLANES[plane], count)
    assert bands.uniform(np.pi, 3.0).sum() == pytest.approx(3 * np.pi, abs=1e-12)
    assert bands.weights.sum() == pytest.approx(2.0, abs=1e-13)
    assert bands.uniform(0.0).sum() == 0


def test_the_published_form_is_the_integral_of_its_derivation():
    bands = Bands.of(count=5)
    for alpha in (0.3, 1.2, 2.9):
        a = (np.arange(20_000) + 0.5) * alpha / 20_000
        by_hand = bands.weights * np.sum(np.sin(a) ** 2) * alpha / 20_000
        np.testing.assert_allclose(bands.uniform(alpha), by_hand, rtol=1e-8)
        np.testing.assert_allclose(bands.illuminance(sd.Uniform(1.0), alpha), bands.uniform(alpha), rtol=0, atol=1e-13)
    np.testing.assert_allclose(bands.weights, 2 * np.sin(bands.centres) * np.sin(bands.half_widths), rtol=1e-12)


@pytest.mark.parametrize("plane", PLANES)
def test_a_uniform_sky_is_exact_on_any_plane(plane):
    normal = PLANES[plane]
    lit = Bands.of(normal, 64).illuminance(sd.Uniform(1.0)).sum()
    assert lit == pytest.approx(np.pi * (1 + normal[2]) / 2, abs=1e-12)


@pytest.mark.parametrize("elevation", [3, 15, 40, 70])
@pytest.mark.parametrize("name", ["cie-12", "hosek-wilkie", "hazy"])
def test_64_bands_are_within_a_thousandth_of_the_dense_integral(elevation, name):
    sky = skies(elevation)[name]
    for normal in PLANES.values():
        assert Bands.of(normal, 64).illuminance(sky).sum() == pytest.approx(dense(sky, normal), rel=1e-3)


def test_bands_converge():
    sky = skies(40)["hosek-wilkie"]
    for normal in (sd.ZENITH, PLANES["roof"]):
        reference = dense(sky, normal)
        errors = [abs(Bands.of(normal, n).illuminance(sky).sum() / reference - 1) for n in (8, 32, 128)]
        assert errors[0] > 4 * errors[1] > 16 * errors[2]


def test_the_axis_does_not_matter():
    sky = skies(40)["cie-12"]
    lit = [Bands.of(sd.ZENITH, 256, sd.direction(turn, 0.0)).illuminance(sky).sum() for turn in (0.0, 0.7, 2.0)]
    np.testing.assert_allclose(lit, lit[0], rtol=2e-4)
    roof = PLANES["roof"]
    slanting = sd.unit(np.cross(roof, [0.3, -0.5, 0.8]))
    tilted = Bands.of(roof, 512, slanting).illuminance(sky).sum()
    assert tilted == pytest.approx(float(Bands.of(roof, 512).illuminance(sky).sum()), rel=3e-4)


def test_parts_of_bands_add_up():
    sky, bands = skies(40)["hosek-wilkie"], Bands.of(count=32)
    nodes, weights, _ = bands.nodes(np.arange(32), np.full(32, 1.0), np.full(32, 2.0))
    between = (bands.illuminance(sky, 2.0) - bands.illuminance(sky, 1.0)).sum()
    assert sky.luminance(nodes) @ weights == pytest.approx(float(between), rel=2e-3)


def test_a_day_at_once_and_torch():
    torch = pytest.importorskip("torch")
    suns = sd.direction(np.linspace(1.8, 4.5, 5), np.linspace(0.2, 0.9, 5))[:, None, :]
    bands = Bands.of(sd.SOUTH, 16)
    day = bands.illuminance(sd.HosekWilkie(suns, turbidity=3.0))
    assert day.shape == (5, 16)
    one = bands.illuminance(sd.HosekWilkie(suns[3, 0], turbidity=3.0))
    np.testing.assert_allclose(day[3], one, rtol=1e-12)
    turbidity = torch.tensor(3.0, dtype=torch.float64, requires_grad=True)
    lit = bands.illuminance(sd.HosekWilkie(torch.as_tensor(suns[3, 0]), turbidity=turbidity)).sum()
    lit.backward()
    assert lit.item() == pytest.approx(one.sum(), rel=1e-9)
    assert torch.isfinite(turbidity.grad)


def test_bad_bands_are_refused():
    with pytest.raises(ValueError, match="count must be a whole number"):
        Bands.of(count=0)
    with pytest.raises(ValueError, match="axis must lie in the receiving plane"):
        Bands.of(sd.ZENITH, 8, sd.direction(0.0, 0.5))
    with pytest.raises(ValueError, match=r"one normal of shape \(3,\)"):
        Bands.of(np.stack([sd.ZENITH, sd.SOUTH]))
    with pytest.raises(ValueError, match="edges must rise"):
        Bands(sd.ZENITH, sd.EAST, np.array([0.0, 2.0, 1.0, np.pi]))
    with pytest.raises(ValueError, match="alpha must lie"):
        Bands.of(count=4).illuminance(sd.Uniform(1.0), 4.0)
