"""Neural skies in torch and JAX: batches of conditions, gradients with respect to each, integrals, jit and vmap."""

import numpy as np
import pytest

import skydome as sd
from skydome.skies.neural.files import shipped_network
from skydome.skies.neural.sky import NeuralSpectralSky

NAMES = ("preetham", "hosek-wilkie", "hosek-wilkie-compact", "hosek-wilkie-deep", "hosek-wilkie-spectral")
SUNS = sd.direction(np.array([0.3, 2.0, 5.0]), np.array([0.05, 0.6, 1.5]))[:, None]
TURBIDITY, ALBEDO = np.array([[2.2], [3.3], [5.5]]), np.array([[0.1], [0.5], [0.9]])
VIEWS = sd.direction(np.linspace(0, 6, 20), np.tile([0.02, 0.3, 0.9, 1.5, -0.1], 4))


def sky_of(name, sun, turbidity, albedo):
    kind = NeuralSpectralSky if "spectral" in name else sd.NeuralSky
    return kind(sun, shipped_network(name)[0], turbidity, albedo)


def mean(name, sun, turbidity, albedo, views):
    """A number of everything."""
    return sky_of(name, sun, turbidity, albedo).rgb(views).mean()


@pytest.mark.parametrize("name", NAMES)
def test_batches_in_torch(name):
    torch = pytest.importorskip("torch")
    wanted = sky_of(name, SUNS, TURBIDITY, ALBEDO).rgb(VIEWS)
    assert wanted.shape == (3, 20, 3)
    for dtype, tolerance in ((torch.float64, 1e-9), (torch.float32, 2e-4)):
        parts = [torch.tensor(part, dtype=dtype) for part in (SUNS, TURBIDITY, ALBEDO)]
        light = sky_of(name, *parts).rgb(torch.tensor(VIEWS, dtype=dtype))
        assert light.dtype == dtype
        np.testing.assert_allclose(light, wanted, rtol=tolerance, atol=tolerance * wanted.max())
    one = sky_of(name, SUNS[1, 0], 3.3, 0.5).rgb(VIEWS)
    np.testing.assert_allclose(wanted[1], one, rtol=1e-9, atol=1e-9 * one.max())


@pytest.mark.parametrize("name", NAMES)
def test_every_gradient_in_torch(name):
    torch = pytest.importorskip("torch")
    given = [SUNS, TURBIDITY, ALBEDO, VIEWS]
    parts = [torch.tensor(part, requires_grad=True) for part in given]
    mean(name, *parts).backward()
    rng = np.random.default_rng(0)
    for k, part in enumerate(given):
        way = rng.normal(size=part.shape)
        if k in (0, 3):  # along the sphere
            way -= np.sum(way * part, axis=-1, keepdims=True) * part
        ends = []
        for step in (-1e-6, 1e-6):
            moved = [other + step * way if j == k else other for j, other in enumerate(given)]
            moved[0], moved[3] = sd.unit(moved[0]), sd.unit(moved[3])
            ends.append(mean(name, *moved))
        slope = (ends[1] - ends[0]) / 2e-6
        gradient = np.zeros(part.shape) if parts[k].grad is None else parts[k].grad.numpy()
        assert np.sum(gradient * way) == pytest.approx(slope, rel=1e-4, abs=1e-6 * ends[0])


@pytest.mark.parametrize("name", NAMES)
def test_jit_vmap_and_grad_in_jax(name):
    jax = pytest.importorskip("jax")
    parts = [jax.numpy.asarray(part) for part in (SUNS, TURBIDITY, ALBEDO, VIEWS)]
    wanted = sky_of(name, SUNS, TURBIDITY, ALBEDO).rgb(VIEWS)

    def light(sun, turbidity, albedo):
        return sky_of(name, sun, turbidity, albedo).rgb(parts[3])

    near = {"rtol": 3e-4, "atol": 3e-4 * wanted.max()}
    np.testing.assert_allclose(jax.jit(light)(*parts[:3]), wanted, **near)
    np.testing.assert_allclose(jax.vmap(light)(*parts[:3]), wanted, **near)
    slopes = jax.jit(jax.grad(lambda *given: mean(name, *given), argnums=(0, 1, 3)))(*parts)
    assert all(np.isfinite(np.asarray(slope)).all() and np.asarray(slope).any() for slope in slopes)


def test_vmap_and_grad_in_torch():
    torch = pytest.importorskip("torch")
    suns, turbidity = torch.tensor(SUNS[:, 0]), torch.tensor(TURBIDITY[:, 0])
    views, network = torch.tensor(VIEWS), shipped_network("hosek-wilkie-deep")[0]

    def bright(sun, turbidity):
        return sd.NeuralSky(sun, network, turbidity).rgb(views).mean()

    each = torch.func.vmap(bright)(suns, turbidity)
    slopes = torch.func.vmap(torch.func.grad(bright, argnums=1))(suns, turbidity)
    for k in range(3):
        own = turbidity[k].clone().requires_grad_()
        value = bright(suns[k], own)
        value.backward()
        assert float(each[k]) == pytest.approx(float(value.detach()), rel=1e-9)
        assert float(slopes[k]) == pytest.approx(float(own.grad), rel=1e-9)


@pytest.mark.parametrize("name", ["hosek-wilkie-compact", "hosek-wilkie-spectral"])
def test_integrals_and_disc(name):
    torch, jax = pytest.importorskip("torch"), pytest.importorskip("jax")
    plain = sky_of(name, SUNS[1, 0], 3.3, 0.5)
    wanted = float(sd.illuminance(plain + sd.SunDisc(SUNS[1, 0], 3.3)))
    turbidity = torch.tensor(3.3, dtype=torch.float64, requires_grad=True)
    sun = torch.tensor(SUNS[1, 0])
    lux = sd.illuminance(sky_of(name, sun, turbidity, 0.5) + sd.SunDisc(sun, turbidity))
    assert float(lux.detach()) == pytest.approx(wanted, rel=1e-9)
    lux.backward()
    assert torch.isfinite(turbidity.grad)
    sun = jax.numpy.asarray(SUNS[1, 0])
    assert float(sd.illuminance(sky_of(name, sun, 3.3, 0.5) + sd.SunDisc(sun, 3.3))) == pytest.approx(wanted, rel=1e-3)


def test_sampling_of_a_torch_sky():
    torch = pytest.importorskip("torch")
    sky = sky_of("hosek-wilkie-deep", torch.tensor(SUNS[1, 0]), 3.3, 0.5)
    directions, density = sd.sample(sky, 4000, seed=1, normal=sd.ZENITH)
    directions = torch.as_tensor(directions)
    estimate = (sky.luminance(directions) * directions[:, 2] / torch.as_tensor(density)).mean()
    assert float(estimate) == pytest.approx(float(sd.illuminance(sky)), rel=0.01)
