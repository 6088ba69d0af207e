"""Gradients of every sky against central differences in float64, away from the edges."""

import numpy as np
import pytest

import skydome as sd
from skydome.ground.quadrature import hemisphere
from skydome.light.colour import encode_srgb, xyY_from_xyz

torch = pytest.importorskip("torch")
jax = pytest.importorskip("jax")

STEP = 1e-5
VIEWS = hemisphere(5, 7)[0]
AZIMUTHS, ELEVATIONS = sd.azimuth(VIEWS), np.arcsin(VIEWS[:, 2])
WEIGHTS = np.random.default_rng(4).uniform(0.5, 1.5, len(VIEWS))
SUN = (137 * sd.deg, 41 * sd.deg)


@pytest.fixture
def double():
    with jax.enable_x64(True):
        yield


def light(make, one, sun_azimuth, sun_elevation, azimuths, elevations):
    sky = make(sd.direction(sun_azimuth, sun_elevation), one)
    if isinstance(sky, sd.SunDisc):  # seen across its own face
        away = sd.SunDisc(sd.direction(sun_azimuth, sun_elevation), sky.turbidity, 0.1)
        return away.luminance(sd.direction(SUN[0] + 0.01 * azimuths, SUN[1] + 0.04 * (elevations - 0.7)))
    return sky.luminance(sd.direction(azimuths, elevations))


def central(function, leaves, k):
    """Central difference in leaf k, each element by itself where the light of each view is its own."""
    up, down = list(leaves), list(leaves)
    up[k], down[k] = leaves[k] + STEP, leaves[k] - STEP
    return (function(*up) - function(*down)) / (2 * STEP)


LEAVES = (np.array(1.0), np.array(SUN[0]), np.array(SUN[1]), AZIMUTHS, ELEVATIONS)


def expected_gradients(function):
    each = [WEIGHTS * central(function, LEAVES, k) for k in range(5)]
    return [np.sum(part) if k < 3 else part for k, part in enumerate(each)]


def scale_of(function, k):
    """What a gradient may be off by at most: rounding of the central difference, and its third-order term."""
    size = np.abs(function(*LEAVES)).max()
    return size * (1e-7 if k >= 3 else 1e-6)


def compare(function, gradients):
    for k, (got, expected) in enumerate(zip(gradients, expected_gradients(function), strict=True)):
        got = np.zeros(np.shape(expected)) if got is None else np.asarray(got)
        assert got.shape == np.shape(expected)
        np.testing.assert_allclose(got, expected, rtol=2e-6, atol=scale_of(function, k), err_msg=f"leaf {k}")


def test_torch(make):
    leaves = [torch.tensor(leaf, dtype=torch.float64, requires_grad=True) for leaf in LEAVES]
    value = light(make, *leaves)
    assert value.dtype == torch.float64
    (value * torch.tensor(WEIGHTS)).sum().backward()
    compare(lambda *x: light(make, *x), [leaf.grad for leaf in leaves])
    assert leaves[0].grad != 0


def test_jax_jit_of_grad(make, double):
    def total(*leaves):
        return jax.numpy.sum(light(make, *leaves) * WEIGHTS)

    gradients = jax.jit(jax.grad(total, argnums=tuple(range(5))))(*map(jax.numpy.asarray, LEAVES))
    assert gradients[0].dtype == np.float64
    compare(lambda *x: light(make, *x), gradients)


@pytest.mark.parametrize("normal", [None, sd.direction(2.0, 0.4)], ids=["level", "tilted"])
def test_illuminance(make, normal):
    """Gradients of illuminance in the model's level and the sun's direction; the sun's own disc in closed form."""

    def value(one, azimuth, elevation):
        sky = make(sd.direction(azimuth, elevation), one)
        if normal is None:
            return sd.illuminance(sky)
        return sd.illuminance(sky, torch.tensor(normal) if torch.is_tensor(one) else normal)

    leaves = [torch.tensor(float(leaf), dtype=torch.float64, requires_grad=True) for leaf in LEAVES[:3]]
    result = value(*leaves)
    assert result.shape == ()
    assert result.dtype == torch.float64
    plain = make(sd.direction(*LEAVES[1:3]), LEAVES[0])
    held = plain.for_maps is not plain  # NumPy's sum is over a table of the sky
    np.testing.assert_allclose(result.item(), value(*LEAVES[:3]), rtol=1e-5 if held else 1e-10)
    result.backward()
    for k, leaf in enumerate(leaves):
        got = 0.0 if leaf.grad is None else leaf.grad.item()
        expected = central(value, LEAVES[:3], k)
        assert got == pytest.approx(expected, rel=2e-4, abs=1e-5 * result.item())  # nodes cross the cut to black


FREE = {
    "hosek-wilkie-turbidity": lambda x, sun: sd.HosekWilkie(sun, x, 0.3),
    "hosek-wilkie-albedo": lambda x, sun: sd.HosekWilkie(sun, 3.2, x * 0.1),
    "hosek-wilkie-rgb-turbidity": lambda x, sun: sd.HosekWilkieRGB(sun, x, 0.3),
    "preetham-turbidity": lambda x, sun: sd.Preetham(sun, x),
    "sun-disc-turbidity": lambda x, sun: sd.SunDisc(sun, x, 0.1),
    "daylight-of-all-weather": lambda x, sun: sd.Daylight(sd.PerezAllWeather(sun, x * 200.0, 120.0)),
    "blend": lambda x, sun: sd.blend(sd.HosekWilkie(sun, 3.2), sd.Preetham(sun, 3.0), x * 0.1),
    "scaled": lambda x, sun: sd.HosekWilkie(sun, 3.2) * x + sd.SunDisc(sun, 3.0, 0.1),
}


@pytest.mark.parametrize("quantity", ["xyz", "rgb", "radiance", "xyY", "encoded"])
@pytest.mark.parametrize("free", FREE.values(), ids=FREE.keys())
def test_one_parameter_through_colour(free, quantity):
    if free is FREE["hosek-wilkie-rgb-turbidity"] and quantity == "radiance":
        pytest.skip("the RGB form knows no spectrum")

    def value(x):
        sun = sd.direction(x * 0 + SUN[0], x * 0 + SUN[1])
        views = sd.direction(x * 0 + SUN[0] + 0.02, x * 0 + SUN[1] + 0.03)
        sky = free(x, sun)
        if quantity == "radiance":
            return sky.radiance(views, [420.0, 555.0, 700.0])
        if quantity == "xyY":
            return xyY_from_xyz(sky.xyz(views))
        return encode_srgb(sky.rgb(views) / 1e4) if quantity == "encoded" else getattr(sky, quantity)(views)

    x = torch.tensor(3.4, dtype=torch.float64, requires_grad=True)
    result = value(x)
    assert result.dtype == torch.float64
    got = torch.autograd.functional.jacobian(value, x).numpy()
    expected = (value(np.array(3.4 + STEP)) - value(np.array(3.4 - STEP))) / (2 * STEP)
    np.testing.assert_allclose(result.detach().numpy(), value(np.array(3.4)), rtol=1e-9)
    np.testing.assert_allclose(got, expected, rtol=1e-6, atol=1e-6 * np.abs(expected).max())


def test_vmap_over_turbidity_and_sun(double):
    def one_sky(turbidity, elevation):
        return sd.HosekWilkie(sd.direction(elevation * 0 + 1.0, elevation), turbidity).luminance(
            jax.numpy.asarray(VIEWS)
        )

    turbidities, elevations = np.array([1.5, 3.0, 7.2]), np.array([0.1, 0.6, 1.2])
    got = jax.jit(jax.vmap(one_sky))(jax.numpy.asarray(turbidities), jax.numpy.asarray(elevations))
    expected = sd.HosekWilkie(sd.direction(np.ones(3), elevations)[:, None], turbidities[:, None]).luminance(VIEWS)
    np.testing.assert_allclose(np.asarray(got), expected, rtol=1e-9)


def test_torch_func_vmap_and_grad():
    views = torch.tensor(VIEWS)
    sun = torch.tensor(sd.direction(*SUN))

    def total(turbidity):
        return sd.HosekWilkie(sun, turbidity).luminance(views).sum()

    turbidities = torch.tensor([1.5, 3.3, 7.2], dtype=torch.float64)
    got = torch.func.vmap(torch.func.grad(total))(turbidities)
    for turbidity, slope in zip(turbidities.tolist(), got.tolist(), strict=True):
        up, down = (
            sd.HosekWilkie(sun, torch.tensor(turbidity + h, dtype=torch.float64)).luminance(views).sum()
            for h in (STEP, -STEP)
        )
        assert slope == pytest.approx(float((up - down) / (2 * STEP)), rel=1e-6)


def test_float32_stays_float32(make):
    sun = torch.tensor(sd.direction(*SUN), dtype=torch.float32)
    one = torch.tensor(1.0, dtype=torch.float32, requires_grad=True)
    sky = make(sun, one)
    views = torch.tensor(VIEWS, dtype=torch.float32)
    assert sky.luminance(views).dtype == torch.float32
    assert sd.illuminance(sky).dtype == torch.float32
    if isinstance(sky, sd.ColourSky):
        assert sky.rgb(views).dtype == torch.float32
    if isinstance(sky, sd.SpectralSky):
        assert sky.radiance(views, [450.0, 555.0]).dtype == torch.float32
    sky.luminance(views).sum().backward()
    assert torch.isfinite(one.grad)


def test_stays_on_its_device(make):
    """Every operation runs where the arrays are: on torch's "meta" device, which refuses any other's data."""
    with torch.device("meta"):
        sun, one, views = torch.ones(3), torch.ones(()), torch.ones(7, 3)
    sky = make(sun, one)
    assert sky.luminance(views).device.type == "meta"
    assert sky.luminance(views).shape == (7,)
    assert sd.illuminance(sky).device.type == "meta"
    if isinstance(sky, sd.ColourSky):
        assert sky.rgb(views).device.type == "meta"
    if isinstance(sky, sd.SpectralSky):
        assert sky.radiance(views, [450.0, 555.0]).device.type == "meta"
