"""Gradients at the edges: one-sided where there are two sides, finite everywhere."""

import numpy as np
import pytest

import skydome as sd

torch = pytest.importorskip("torch")
jax = pytest.importorskip("jax")

SUNS = [-30.0, -1e-9, 0.0, 1e-9, 0.3, 41.0, 89.9999, 90.0]
STEP = 1e-6


def double(value):
    return torch.tensor(value, dtype=torch.float64, requires_grad=True)


def edge_views(sun):
    """The sun, what lies opposite, below, beside and a hair from it; horizon, zenith and nadir."""
    hair = sd.unit(sun + 1e-9 * sd.EAST)
    fixed = [sun, -sun, sun * [1, 1, -1], sun * [-1, -1, 1], hair, sd.ZENITH, -sd.ZENITH, sd.NORTH, sd.WEST]
    return np.array(fixed)


@pytest.mark.parametrize("elevation", SUNS)
@pytest.mark.parametrize("dtype", [torch.float64, torch.float32], ids=["64", "32"])
def test_never_nan_in_torch(make, elevation, dtype):
    sun = sd.direction(2.4, elevation * sd.deg)
    for view in edge_views(sun):
        leaves = [torch.tensor(leaf, dtype=dtype, requires_grad=True) for leaf in (1.0, sun, view)]
        sky = make(leaves[1], leaves[0])
        value = sky.xyz(leaves[2]).sum() if isinstance(sky, sd.ColourSky) else sky.luminance(leaves[2])
        assert torch.isfinite(value)
        for gradient in torch.autograd.grad(value, leaves, allow_unused=True):
            assert gradient is None or torch.isfinite(gradient).all(), (view, gradient)


@pytest.mark.parametrize("elevation", [-30.0, 0.0, 90.0])
def test_never_nan_in_illuminance(make, elevation):
    leaves = double(1.0), double(sd.direction(2.4, elevation * sd.deg))
    value = sd.illuminance(make(leaves[1], leaves[0]))
    for gradient in torch.autograd.grad(value, leaves, allow_unused=True):
        assert gradient is None or torch.isfinite(gradient).all()


def test_never_nan_in_jax(make):
    def value(one, sun, view):
        return make(sun, one).luminance(view).sum()

    gradient = jax.jit(jax.vmap(jax.grad(value, argnums=(0, 1, 2)), in_axes=(None, None, 0)))
    with jax.enable_x64(True):
        for elevation in (-30.0, 0.0, 41.0, 90.0):
            sun = sd.direction(2.4, elevation * sd.deg)
            for part in gradient(1.0, jax.numpy.asarray(sun), jax.numpy.asarray(edge_views(sun))):
                assert bool(jax.numpy.isfinite(part).all())


MODELS = {
    "hosek-wilkie": lambda sun, turbidity: sd.HosekWilkie(sun, turbidity, 0.3),
    "hosek-wilkie-rgb": lambda sun, turbidity: sd.HosekWilkieRGB(sun, turbidity, 0.3),
    "preetham": lambda sun, turbidity: sd.Preetham(sun, turbidity),
}
every_model = pytest.mark.parametrize("model", MODELS.values(), ids=MODELS.keys())


@every_model
@pytest.mark.parametrize("elevation", [3.0, 41.0])
def test_view_at_the_sun(model, elevation):
    """The light has a cusp at the sun; the gradient there is that of its even part: the mean over opposite steps."""
    sun = sd.direction(2.4, elevation * sd.deg)
    view = double(sun)
    (gradient,) = torch.autograd.grad(model(torch.tensor(sun), 3.2).luminance(view), view)
    sky = model(sun, 3.2)
    u = np.array([sun[1], -sun[0], 0.0]) / np.hypot(sun[0], sun[1])
    for along in (u, np.cross(u, sun)):
        up, down = (sky.luminance(np.cos(STEP) * sun + sign * np.sin(STEP) * along) for sign in (1, -1))
        mean, side = (up - down) / (2 * STEP), (up - sky.luminance(sun)) / STEP
        assert float(gradient.detach() @ torch.tensor(along)) == pytest.approx(mean, rel=1e-4, abs=1e-6 * abs(side))


@every_model
def test_beside_the_sun_the_slope_is_one_sided(model):
    sun = sd.direction(2.4, 41 * sd.deg)
    level = np.array([sun[1], -sun[0], 0.0]) / np.hypot(sun[0], sun[1])

    def light(angle):
        c, s = (torch.cos(angle), torch.sin(angle)) if torch.is_tensor(angle) else (np.cos(angle), np.sin(angle))
        toward = [c * float(a) + s * float(b) for a, b in zip(sun, level, strict=True)]
        if torch.is_tensor(angle):
            return model(torch.tensor(sun), 3.2).luminance(torch.stack(toward))
        return model(sun, 3.2).luminance(np.array(toward))

    angle = double(1e-5)
    (slope,) = torch.autograd.grad(light(angle), angle)
    assert slope.item() == pytest.approx((light(2e-5) - light(0.0)) / 2e-5, rel=1e-4)


@every_model
def test_view_at_the_horizon(model):
    """From above; 40 m-1 steepness of exp(B / (cos t + e)) asks for a small step."""
    sun = sd.direction(2.4, 41 * sd.deg)
    height = double(1e-7)
    azimuth = double(1.0)
    light = model(torch.tensor(sun), 3.2).luminance(sd.direction(azimuth, height))
    by_azimuth, by_height = torch.autograd.grad(light, (azimuth, height))
    sky, step = model(sun, 3.2), 1e-9

    def seen(a, h):
        return sky.luminance(sd.direction(a, h))

    assert by_azimuth.item() == pytest.approx((seen(1 + STEP, 1e-7) - seen(1 - STEP, 1e-7)) / (2 * STEP), rel=1e-5)
    one_sided = (seen(1.0, 1e-7 + step) - seen(1.0, 1e-7)) / step
    assert by_height.item() == pytest.approx(one_sided, rel=2e-2)  # sqrt(cos t) bends at this scale
    exact = double(0.0)
    (at_horizon,) = torch.autograd.grad(model(torch.tensor(sun), 3.2).luminance(sd.direction(azimuth, exact)), exact)
    assert torch.isfinite(at_horizon)


@pytest.mark.parametrize("name", ["hosek-wilkie", "hosek-wilkie-rgb"])
@pytest.mark.parametrize("turbidity", [1.0, 2.0, 5.0, 9.0, 10.0])
def test_whole_turbidities(name, turbidity):
    """Tables bend at whole turbidities: the gradient is the right-hand one, at 10 the left-hand one."""
    sun, view = sd.direction(2.4, 41 * sd.deg), sd.direction(1.0, 0.4)
    t = double(turbidity)
    (slope,) = torch.autograd.grad(MODELS[name](torch.tensor(sun), t).luminance(torch.tensor(view)), t)
    h = -STEP if turbidity == 10.0 else STEP
    one_sided = (MODELS[name](sun, turbidity + h).luminance(view) - MODELS[name](sun, turbidity).luminance(view)) / h
    assert slope.item() == pytest.approx(one_sided, rel=1e-5)


@pytest.mark.parametrize(("turbidity", "h"), [(2.0, STEP), (6.0, -STEP)])
def test_limits_of_preetham(turbidity, h):
    sun, view = sd.direction(2.4, 41 * sd.deg), sd.direction(1.0, 0.4)
    t = double(turbidity)
    (slope,) = torch.autograd.grad(sd.Preetham(torch.tensor(sun), t).luminance(torch.tensor(view)), t)
    one_sided = (sd.Preetham(sun, turbidity + h).luminance(view) - sd.Preetham(sun, turbidity).luminance(view)) / h
    assert slope.item() == pytest.approx(one_sided, rel=1e-5)


@pytest.mark.parametrize(("albedo", "h"), [(0.0, STEP), (1.0, -STEP)])
def test_limits_of_albedo(albedo, h):
    sun, view = sd.direction(2.4, 41 * sd.deg), sd.direction(1.0, 0.4)
    x = double(albedo)
    (slope,) = torch.autograd.grad(sd.HosekWilkie(torch.tensor(sun), 3.2, x).luminance(torch.tensor(view)), x)
    light = [float(sd.HosekWilkie(sun, 3.2, value).luminance(view)) for value in (albedo + h, albedo)]
    assert slope.item() == pytest.approx((light[0] - light[1]) / h, rel=1e-6)


def test_outside_the_limits_a_clamped_parameter_has_no_slope():
    sun = torch.tensor(sd.direction(2.4, 0.7))
    t = double(12.0)
    light = sd.HosekWilkie(sun, t, check="clamp").luminance(torch.tensor(sd.ZENITH))
    assert torch.autograd.grad(light, t)[0].item() == 0.0
