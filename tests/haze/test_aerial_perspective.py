"""Aerial perspective: the default against adaptive quadrature, physics, the published form's errors, bad input."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.air.atmosphere import PREETHAM_HAZE
from skydome.air.scattering import gas_total, haze_total
from skydome.haze import aerial_perspective as module
from skydome.haze.aerial_perspective import AirLight, aerial_perspective
from skydome.haze.integrals import FewNodes, Ray, coefficients_like, mean_fall, optical_depth
from skydome.haze.light import sky_nodes
from skydome.haze.published import AdaptiveQuadrature, PublishedClosedForm
from skydome.haze.ward_larson import WardLarson, WardLarsonMeanSky
from skydome.light.colour import rgb_from_xyz, xyz_from_rgb

ZENITHS = (
    np.unique(np.concatenate([np.arange(0, 121, 5.0), np.arange(85, 95.1, 0.5), [89.9, 89.99, 90.01, 90.1]])) * deg
)
DISTANCES = np.logspace(2, 5, 13)
WAVELENGTHS = [450.0, 550.0, 650.0]
SUN = sd.direction(azimuth=250 * deg, elevation=25 * deg)


def case(turbidity, height, dtype=np.float64):
    distance, cosine = (a.astype(dtype) for a in np.meshgrid(DISTANCES, np.cos(ZENITHS), indexing="ij"))
    haze_550, gas_550 = float(haze_total([550.0], turbidity)[0]), float(gas_total([550.0])[0])
    air = coefficients_like(haze_total(WAVELENGTHS, turbidity), gas_total(WAVELENGTHS), haze_550, gas_550, distance)
    return Ray.at(distance, cosine, np.asarray(height, dtype)), air


def sunny(turbidity=3.0, sun=SUN):
    sky = sd.Preetham(sun, turbidity)
    return sky + sd.SunDisc.of(sky)


@pytest.mark.parametrize("height", [0.0, 3000.0])
@pytest.mark.parametrize("turbidity", [2.0, 4.0, 6.0])
def test_default_stays_within_two_thousandths_of_quadrature(turbidity, height):
    ray, air = case(turbidity, height)
    reference = AdaptiveQuadrature().integrals(ray, air)
    for dtype in (np.float64, np.float32):
        found = FewNodes().integrals(*case(turbidity, height, dtype))
        for own, true in zip(found, reference, strict=True):
            assert own.dtype == dtype
            assert np.abs(own / true - 1).max() < 2e-3
            assert np.abs(own / true - 1)[:, np.cos(ZENITHS) >= 0].max() < 1e-4  # level and up: far better


def test_reference_is_scipy_quad():
    """One steep and one level ray by scipy's plain quad, written out."""
    from scipy.integrate import quad

    ray, air = case(4.0, 0.0)
    found = AdaptiveQuadrature().integrals(ray, air)
    for i, j in ((8, 3), (6, 30), (5, -4)):
        s, c = DISTANCES[i], np.cos(ZENITHS[j])

        def seen(x, c=c):
            a, b = (d * c for d in (0.8333e-3, 0.1136e-3))
            columns = [-np.expm1(-k * x) / k if k else x for k in (a, b)]
            return np.exp(-a * x - air.haze[1] * columns[0] - air.gas[1] * columns[1])

        assert found[0][i, j, 1] == pytest.approx(quad(seen, 0, s, epsrel=1e-10, limit=500)[0], rel=1e-8)


def test_published_closed_form_has_the_documented_errors():
    ray, air = case(4.0, 0.0)
    reference = AdaptiveQuadrature().integrals(ray, air)
    found = PublishedClosedForm().integrals(ray, air)
    worst = np.max([np.abs(a / b - 1).max(axis=(1, 2)) for a, b in zip(found, reference, strict=True)], axis=0)
    assert worst[DISTANCES <= 1000].max() < 0.05
    assert worst[DISTANCES <= 3000].max() < 0.15
    assert worst[DISTANCES >= 30000].max() > 10  # why it is not the default


def test_no_seam():
    """I1 and I2 change evenly with the zenith angle and the distance: no step where up turns into down."""
    zenith = np.linspace(80, 100, 40001) * deg
    _, air = case(4.0, 0.0)
    ray = Ray.at(np.full(zenith.shape, 2e4), np.cos(zenith), np.asarray(0.0))
    for values in FewNodes().integrals(ray, air):
        slope = np.diff(np.log(values), axis=0) / np.diff(zenith)[:, None]
        assert np.abs(np.diff(slope, axis=0)).max() < 0.02 * np.abs(slope).max()


def test_energy_identity_is_exact():
    ray, air = case(3.0, 0.0)
    first, second = FewNodes().integrals(ray, air)
    tau = np.exp(-optical_depth(ray, air))
    assert air.haze * first + air.gas * second == pytest.approx(1 - tau, rel=1e-12)


def test_transmittance_falls_with_distance_up_level_and_down():
    """The printed sign of K would make it rise."""
    for elevation in (60, 5, 0, -1, -20):
        air = aerial_perspective(sunny(), np.logspace(1, 5, 60), sd.direction(azimuth=0.0, elevation=elevation * deg))
        assert np.all(np.diff(air.transmittance, axis=0) <= 0)
        assert np.all((air.transmittance >= 0) & (air.transmittance <= 1))
        assert np.all(np.diff(air.inscattered, axis=0) >= -1e-9)


def test_no_distance_changes_nothing():
    air = aerial_perspective(sunny(), 0.0, sd.EAST, wavelengths=[450.0, 550.0])
    assert np.abs(air.transmittance - 1).max() < 1e-12
    assert np.abs(air.inscattered).max() < 1e-12


def test_uniform_light_stays_uniform():
    """In a white furnace (sky and ground the same) the veil of an endless ray is the furnace."""
    furnace = sd.Daylight(sd.Uniform(1000.0))
    air = aerial_perspective(furnace, 5e5, sd.direction(0.3, np.array([0.0, -0.02])), turbidity=3.0, ground_albedo=1.0)
    assert air.inscattered == pytest.approx(1000.0, rel=0.01)


HORIZON = sd.direction(np.arange(0, 360, 15) * deg, 1e-3)
"""As low as flat layers of air have a sky."""


def chromaticity(light):
    """CIE x, y of linear sRGB."""
    xyz = xyz_from_rgb(np.asarray(light))
    return xyz[..., :2] / xyz.sum(axis=-1, keepdims=True)


@pytest.mark.parametrize("elevation", [5, 10, 20, 45, 70])
@pytest.mark.parametrize("turbidity", [2.0, 3.0, 4.0, 6.0])
def test_far_rays_take_the_colour_of_the_horizon_sky(turbidity, elevation):
    """Chromaticity toward every azimuth within 15 %, though Preetham's sky and air were not made for each other."""
    sun = sd.direction(azimuth=180 * deg, elevation=elevation * deg)
    sky = sd.Preetham(sun, turbidity)
    far = aerial_perspective(sky + sd.PreethamSun(sun, turbidity), 1e6, HORIZON * [1, 1, 0]).inscattered
    assert chromaticity(far) == pytest.approx(chromaticity(sky.rgb(HORIZON)), rel=0.15)


@pytest.mark.parametrize(("turbidity", "elevation"), [(2.0, 5), (2.0, 45), (4.0, 10), (6.0, 20)])
def test_far_rays_take_the_light_of_the_horizon_of_a_physical_sky(turbidity, elevation):
    """Energy: sky, sun and ground of one atmosphere give its own horizon, in luminance and in colour, all around."""
    pytest.importorskip("nanodisort")
    sun = sd.direction(azimuth=180 * deg, elevation=elevation * deg)
    atmosphere = sd.Atmosphere.from_turbidity(turbidity, PREETHAM_HAZE, albedo=0.1)
    sky = sd.DiscreteOrdinates(sun, atmosphere)
    air = AirLight(sky + sd.AtmosphereSun(sun, atmosphere), ground_albedo=0.1, meets_horizon=False)
    far, horizon = air.at(1e6, HORIZON * [1, 1, 0]).inscattered, sky.rgb(HORIZON)
    assert chromaticity(far) == pytest.approx(chromaticity(horizon), rel=0.02)
    to_luminance = np.array([0.2126, 0.7152, 0.0722])
    assert far @ to_luminance == pytest.approx(horizon @ to_luminance, rel=0.07 if elevation == 5 else 0.025)


@pytest.mark.parametrize("elevation", [20, 45, 70])
@pytest.mark.parametrize("turbidity", [3.0, 6.0])
def test_far_rays_have_the_mean_luminance_of_preethams_horizon_where_it_fits(turbidity, elevation):
    """Within 15 % over a ground of albedo .1; not at turbidity 2, nor for low suns: see the next test."""
    sun = sd.direction(azimuth=180 * deg, elevation=elevation * deg)
    sky = sd.Preetham(sun, turbidity)
    air = AirLight(sky + sd.PreethamSun(sun, turbidity), ground_albedo=0.1)
    far = xyz_from_rgb(air.at(1e6, HORIZON * [1, 1, 0]).inscattered)
    assert far[:, 1].mean() == pytest.approx(sky.xyz(HORIZON)[:, 1].mean(), rel=0.15)


@pytest.mark.parametrize(("elevation", "least", "most"), [(5, 0.3, 0.5), (20, 0.55, 1.0), (45, 0.6, 1.05)])
def test_published_sky_is_brighter_than_its_own_air_allows(elevation, least, most):
    """Why luminance does not tend to Preetham's horizon at turbidity 2 and low suns: the fit is too bright there."""
    pytest.importorskip("nanodisort")
    sun = sd.direction(azimuth=180 * deg, elevation=elevation * deg)
    for turbidity, factor in ((2.0, 1.5), (6.0, 0.9)):
        sky = sd.Preetham(sun, turbidity)
        far = aerial_perspective(sky + sd.PreethamSun(sun, turbidity), 1e6, HORIZON * [1, 1, 0]).inscattered
        published = sky.xyz(HORIZON)[:, 1].mean()
        assert least < xyz_from_rgb(far)[:, 1].mean() / published < most
        physical = sd.DiscreteOrdinates(sun, sd.Atmosphere.from_turbidity(turbidity, PREETHAM_HAZE, albedo=0.1))
        assert published > factor * physical.xyz(HORIZON)[:, 1].mean()


def test_blue_away_from_a_low_sun_and_warm_toward_it():
    """Paper, section 5; Ward-Larson's fog cannot tell east from west."""
    sun = sd.direction(azimuth=270 * deg, elevation=5 * deg)
    sky = sd.Preetham(sun, 6.0)
    light = AirLight(sky + sd.SunDisc.of(sky))
    east, west = (light.at(2e4, view).inscattered for view in (sd.EAST, sd.WEST))
    assert east[2] / east[0] > 1.3 * west[2] / west[0]
    fog = WardLarson(light)
    assert fog.at(2e4, sd.EAST).inscattered == pytest.approx(fog.at(2e4, sd.WEST).inscattered)
    assert fog.at(1000.0, sd.EAST).transmittance == pytest.approx(light.at(1000.0, sd.EAST).transmittance)


def test_table_and_kernel_agree_with_the_plain_form():
    pytest.importorskip("numba")
    rng = np.random.default_rng(3)
    views = sd.unit(rng.normal(size=(12000, 3)) * [1, 1, 0.3])
    views[0] = SUN
    distance = 10 ** rng.uniform(1, 5, 12000)
    light = AirLight(sunny())
    fast = light.at(distance, views, 500.0)
    plain = light.at(distance[:400], views[:400], 500.0)  # few: without table and kernel
    assert fast.inscattered.dtype == np.float32
    assert fast.transmittance[:400] == pytest.approx(plain.transmittance, abs=2e-6)
    assert fast.inscattered[:400] == pytest.approx(plain.inscattered, rel=4e-3)
    table = light.at(distance[:600], views[:600], 500.0)  # more than MANY: with the table
    assert table.inscattered[:400] == pytest.approx(plain.inscattered, rel=2e-3)
    assert len(views) >= module.MANY_PIXELS


def test_rgb_agrees_with_the_spectrum():
    """RGB by three means against 35 wavelengths summed: a white wall and its veil at 1-30 km."""
    from skydome.light.colour import SRGB
    from skydome.light.daylight import daylight_spectrum
    from skydome.light.spectrum import xyz_weights

    w = np.arange(380.0, 721.0, 10.0)
    to_rgb = xyz_weights(w) @ SRGB.from_xyz.T
    views = np.broadcast_to(sd.direction(azimuth=np.array([20.0, 130, 250]) * deg, elevation=0.01), (3, 3))
    white = daylight_spectrum([0.9505, 1.0, 1.0891], w) * 5000.0
    for distance, tolerance in ((1e3, 0.01), (1e4, 0.04), (3e4, 0.12)):
        spectral = aerial_perspective(sunny(), distance, views, wavelengths=w)
        rgb = aerial_perspective(sunny(), distance, views)
        assert rgb.seen(white @ to_rgb) == pytest.approx(spectral.seen(white) @ to_rgb, rel=tolerance)


def test_gradients_pass_through_everything():
    torch = pytest.importorskip("torch")

    def value(distance, height, elevation):
        sun = torch.as_tensor(SUN)
        view = sd.direction(azimuth=torch.tensor(1.0, dtype=torch.float64), elevation=elevation)
        sky = sd.Preetham(sun, 3.0)
        air = aerial_perspective(sky + sd.SunDisc.of(sky), distance, view, height)
        return (air.transmittance + air.inscattered / 1000).sum()

    for point in ((8000.0, 100.0, -0.02), (8000.0, 100.0, 0.0), (0.0, 0.0, 0.1)):
        inputs = [torch.tensor(p, dtype=torch.float64, requires_grad=True) for p in point]
        value(*inputs).backward()
        for k, tensor in enumerate(inputs):
            assert torch.isfinite(tensor.grad)
            if point[0] > 0 and point[2] != 0:
                step = 1e-4 * max(abs(point[k]), 1e-3)
                ends = [
                    [torch.tensor(p + (d if n == k else 0), dtype=torch.float64) for n, p in enumerate(point)]
                    for d in (-step, step)
                ]
                slope = (value(*ends[1]) - value(*ends[0])) / (2 * step)
                assert float(tensor.grad) == pytest.approx(float(slope), rel=1e-4)


def test_gradient_of_turbidity_and_jax():
    torch = pytest.importorskip("torch")
    jax = pytest.importorskip("jax")
    t = torch.tensor(3.0, dtype=torch.float64, requires_grad=True)
    sky = sd.Preetham(torch.as_tensor(SUN), 3.0)
    air = aerial_perspective(sky, 8000.0, sd.EAST, turbidity=t)
    air.transmittance.sum().backward()
    assert float(t.grad) < 0
    sky = sd.Preetham(jax.numpy.asarray(SUN), 3.0)
    slope = jax.grad(lambda s: aerial_perspective(sky, s, jax.numpy.asarray(sd.EAST)).inscattered.sum())(8000.0)
    assert float(slope) > 0


@pytest.mark.parametrize("wavelengths", [None, [450.0, 650.0]])
def test_many_turbidities_at_once(wavelengths):
    """An array of turbidities broadcasts with the rays: each as if alone, in torch with a gradient for each."""
    turbidities, distances = np.array([2.0, 3.5, 6.0])[:, None], np.array([1e3, 2e4])
    views = sd.direction(np.array([1.0, 4.0]), 0.02)
    both = aerial_perspective(sunny(), distances, views, 100.0, wavelengths, turbidities)
    assert both.inscattered.shape[:2] == (3, 2)
    for k, turbidity in enumerate(turbidities[:, 0]):
        alone = aerial_perspective(sunny(), distances, views, 100.0, wavelengths, turbidity)
        assert both.transmittance[k] == pytest.approx(alone.transmittance, rel=1e-12)
        assert both.inscattered[k] == pytest.approx(alone.inscattered, rel=1e-12)
    torch = pytest.importorskip("torch")
    batch = torch.tensor(turbidities, requires_grad=True)
    sky = sd.Preetham(torch.as_tensor(SUN), 3.0)
    found = aerial_perspective(sky, 8000.0, torch.as_tensor(views), 100.0, wavelengths, batch)
    found.inscattered.sum().backward()
    assert torch.isfinite(batch.grad).all()
    assert (batch.grad != 0).all()


def test_a_sky_of_many_turbidities_is_refused():
    sky = sd.Preetham(SUN, np.array([2.0, 3.0]))
    with pytest.raises(ValueError, match=r"the sky must have one turbidity, got shape \(2,\)"):
        aerial_perspective(sky, 1000.0, sd.EAST)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"distance": -1.0}, r"distance must lie in \[0, 1e\+09\] m, got -1"),
        ({"distance": np.inf}, "distance must lie in"),
        ({"distance": np.nan}, "distance must lie in"),
        ({"height": np.inf}, r"height must lie in \[-5000, 1e\+09\] m"),
        ({"direction": [0.0, 0.0, 2.0]}, "direction must be finite unit vectors"),
        ({"wavelengths": [300.0, 500.0]}, r"wavelengths must lie in \[380, 780\] nm"),
        ({"turbidity": 0.5}, r"turbidity must lie in \[1, 64\], got 0.5"),
        ({"turbidity": [2.0, 90.0]}, r"turbidity must lie in \[1, 64\], got 2 to 90"),
        ({"ground_albedo": 1.5}, r"ground_albedo must lie in \[0, 1\]"),
    ],
)
def test_bad_input(arguments, message):
    usual = {"distance": 1000.0, "direction": sd.EAST}
    with pytest.raises(ValueError, match=message):
        aerial_perspective(sunny(), **(usual | arguments))


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("height", [-5000.0, 0.0, 1e5, 1e9])
def test_extremes_give_no_nan(dtype, height):
    """The farthest rays from the lowest and highest viewers, up, level and down, by the formula and by the kernel."""
    views = sd.direction(np.linspace(0, 6, 9), np.array([-90, -60, -10, -1e-5, 0, 1e-5, 10, 60, 90]) * deg).astype(
        dtype
    )
    many = np.tile(views, (1200, 1))
    for turbidity in (1.0, 64.0):
        light = AirLight(sunny(), turbidity=turbidity)
        for distance in (0.0, 1e-30, 1e5, 1e9):
            found = [light.at(dtype(distance), views, dtype(height))]
            if pytest.importorskip("numba"):
                found.append(light.at(np.full(len(many), distance, dtype), many, height))
            for air in found:
                assert np.isfinite(air.inscattered).all()
                assert (air.inscattered >= 0).all()
                assert ((air.transmittance >= 0) & (air.transmittance <= 1.000001)).all()


def test_skies_that_know_too_little():
    with pytest.raises(ValueError, match="has no turbidity"):
        aerial_perspective(sd.Daylight(sd.Uniform(1.0)), 1000.0, sd.EAST)
    with pytest.raises(TypeError, match="knows luminance only"):
        aerial_perspective(sd.Uniform(1.0), 1000.0, sd.EAST, turbidity=3.0)
    with pytest.raises(TypeError, match="knows no spectrum"):
        aerial_perspective(sd.HosekWilkieRGB(SUN, 3.0, 0.2), 1000.0, sd.EAST, wavelengths=[500.0])
    rgb = aerial_perspective(sd.HosekWilkieRGB(SUN, 3.0, 0.2), 1000.0, sd.EAST)
    assert np.all(rgb.inscattered > 0)


def test_mean_fall_is_exact_in_both_precisions():
    z = np.concatenate([[0.0], np.geomspace(1e-12, 60, 200), -np.geomspace(1e-12, 60, 200)])
    exact = np.where(z == 0, 1.0, -np.expm1(-z) / np.where(z == 0, 1, z))
    assert mean_fall(z) == pytest.approx(exact, rel=1e-12)
    assert mean_fall(z.astype(np.float32)) == pytest.approx(exact, rel=1e-5)


SUNSET = sd.sun_direction(sd.Place(latitude=40.36, longitude=-105.70, altitude=2800), "2026-07-01T20:00-06:00")
"""Half an hour before sunset in summer, the sun of Figure 8: 5.3 degrees high."""
EAST_AND_WEST = sd.direction(np.array([90.0, 270.0]) * deg, -0.01)


def slopes(sky, disc):
    """The light, RGB (2, 3), of steep grey land in the east and west that faces the viewer, out of haze."""
    nodes, solid_angles = sky_nodes()
    normals = -sd.direction(np.array([90.0, 270.0]) * deg, 0.0)
    facing = np.maximum(normals @ nodes.T, 0) * solid_angles
    sun = np.maximum(normals @ disc.sun, 0)[:, None] * rgb_from_xyz(np.asarray(disc.normal_xyz))
    return (facing @ np.asarray(sky.rgb(nodes)) + sun) * 0.13 / np.pi


@pytest.mark.parametrize("turbidity", [2.0, 3.0, 4.0, 6.0])
def test_at_sunset_air_turns_the_east_blue_and_the_west_yellow(turbidity):
    """Preetham 1999, section 5: "the east view always has a blue-shift in the hue", the west a yellowish one.

    The change of colour that 20 km of air bring to what is seen through them. The fog turns both ways blue.
    """
    sky, disc = sd.Preetham(SUNSET, turbidity), sd.PreethamSun(SUNSET, turbidity)
    light = AirLight(sky + disc)
    bare = slopes(sky, disc)
    turned, fogged = (
        chromaticity(air.at(2e4, EAST_AND_WEST, 800.0).seen(bare))[:, 0] - chromaticity(bare)[:, 0]
        for air in (light, WardLarson(light))
    )
    assert turned[0] < -0.02
    assert turned[1] > 0.03
    assert (fogged < -0.02).all()


def sky_of_figure_8(name):
    """The published sky at turbidity 6, or the sky of the same air by discrete ordinates, with its sun."""
    if name == "Preetham":
        return sd.Preetham(SUNSET, 6.0) + sd.PreethamSun(SUNSET, 6.0)
    pytest.importorskip("nanodisort")
    atmosphere = sd.Atmosphere.from_turbidity(6.0, PREETHAM_HAZE, albedo=0.12)
    return sd.DiscreteOrdinates(SUNSET, atmosphere) + sd.AtmosphereSun(SUNSET, atmosphere)


@pytest.mark.parametrize("name", ["Preetham", "physical"])
def test_figure_8_veil_against_the_fog_of_the_zenith(name):
    """West is warmer than the fog, east bluer than west and than the sky behind; none is as blue as the zenith's fog.

    So the veil toward the east is *not* bluer than that fog, in the published light or in the physical.
    """
    whole = sky_of_figure_8(name)
    light = AirLight(whole)
    east, west = chromaticity(light.at(2e4, EAST_AND_WEST, 800.0).inscattered)[:, 0]
    fog = chromaticity(WardLarson(light).at(2e4, EAST_AND_WEST, 800.0).inscattered)[0, 0]
    sky_east, sky_west = chromaticity(whole.parts[0].rgb(sd.direction(np.array([90.0, 270.0]) * deg, 3 * deg)))[:, 0]
    assert west > fog + 0.05
    assert fog < east < west - 0.02
    assert east < sky_east
    assert west < sky_west


def test_figure_8_veil_against_the_fog_of_the_mean_sky():
    """In physical light the veil is bluer to the east and warmer to the west than fog of the mean sky's colour.

    By Preetham's sky, whose horizon in the east is redder than the physical one by 0.08 in x, the east is no bluer.
    """
    found = {}
    for name in ("Preetham", "physical"):
        light = AirLight(sky_of_figure_8(name))
        veils = [air.at(2e4, EAST_AND_WEST, 800.0).inscattered for air in (light, WardLarsonMeanSky(light))]
        found[name] = [chromaticity(veil)[:, 0] for veil in veils]
    (east, west), (fog, same) = found["physical"]
    assert fog == same
    assert east < fog - 0.005
    assert west > fog + 0.035
    (east, west), (fog, _) = found["Preetham"]
    assert east == pytest.approx(fog, abs=0.005)
    assert west > fog + 0.03


def test_one_density_is_exact_on_level_rays_and_by_quadrature_of_its_own():
    """Hoffman and Preetham's form against a plain sum over a ray of even air."""
    from skydome.haze.integrals import coefficients_like
    from skydome.haze.uniform_density import HoffmanPreetham

    distance, cosine = np.array([500.0, 8000.0, 40_000.0]), np.array([0.3, 0.0, -0.2])
    air = coefficients_like(np.array([3e-5, 8e-5]), np.array([2e-5, 6e-6]), 8e-5, 1e-5, distance)
    ray = Ray.at(distance, cosine, np.array(500.0))
    haze, gas = HoffmanPreetham().integrals(ray, air)
    steps = (np.arange(20_000) + 0.5) / 20_000
    b = air.haze * ray.haze_density + air.gas * ray.gas_density
    plain = distance * np.stack([np.exp(-np.outer(steps, b_ * distance)).mean(axis=0) for b_ in b])
    np.testing.assert_allclose(haze.T, ray.haze_density * plain, rtol=1e-6)
    np.testing.assert_allclose(gas.T, ray.gas_density * plain, rtol=1e-6)
    level = Ray.at(distance, cosine * 0, np.array(500.0))
    for own, exact in zip(HoffmanPreetham().integrals(level, air), FewNodes(12).integrals(level, air), strict=True):
        np.testing.assert_allclose(own, exact, rtol=1e-9)


@pytest.mark.parametrize("wavelengths", [None, [450.0, 650.0]])
def test_the_sun_alone_lights_the_air(wavelengths):
    """As in Hoffman and Preetham's paper: what the sun adds to a sky's haze is what it gives without the sky."""
    sky, disc = sd.HosekWilkie(SUN, turbidity=3.0), sd.SunDisc(SUN, turbidity=3.0)
    views = sd.direction(azimuth=np.array([0.0, 200.0]) * deg, elevation=5 * deg)

    def veil(light):
        method = sd.HoffmanPreetham()
        return aerial_perspective(
            light, 5000.0, views, wavelengths=wavelengths, turbidity=3.0, method=method
        ).inscattered

    assert (veil(disc) > 0).all()
    np.testing.assert_allclose(veil(disc), veil(sky + disc) - veil(sky), rtol=1e-9)


def test_preethams_light_reaches_as_far_as_table_2():
    """380-780 nm under sky and sun, as smooth beyond 720 nm, where the published limb darkening ends, as before it."""
    sky = sd.Preetham(SUN, 4.0) + sd.PreethamSun(SUN, 4.0)
    light = aerial_perspective(sky, 8000.0, sd.WEST, wavelengths=np.arange(700.0, 781.0, 10.0)).inscattered
    assert (light > 0).all()
    disc = sd.PreethamSun(SUN, 4.0)
    own = disc.irradiance([770.0, 780.0]) / sd.ClearAir(4.0).irradiance(SUN, [770.0, 780.0])
    np.testing.assert_allclose(own, own[0], rtol=1e-9)


def test_a_cloud_above_is_no_part_of_the_air_below_and_one_on_the_ground_is_refused():
    sun, clear = sd.direction(0.0, 0.7), sd.Atmosphere.standard()
    found = []
    for more in ((), (sd.Cloud(10.0, base=1000.0),)):
        sky = sd.DiscreteOrdinates(sun, sd.Atmosphere((*clear.constituents, *more)), streams=8)
        found.append(np.asarray(sd.aerial_perspective(sky, 5000.0, sd.NORTH).transmittance))
    np.testing.assert_allclose(found[1], found[0], rtol=1e-12)
    fog = sd.DiscreteOrdinates(sun, sd.Atmosphere((*clear.constituents, sd.Cloud(10.0, base=0.0))), streams=8)
    with pytest.raises(ValueError, match="on the ground; LayeredFog is fog"):
        sd.aerial_perspective(fog, 5000.0, sd.NORTH)
