"""Skies in bases: errors, irradiance, rotation, gradients; Habel's polynomials against the integrals."""

import numpy as np
import pytest

import skydome as sd
from skydome.dome.bases.basis import flat_nodes
from skydome.dome.bases.sky_basis import KINDS, PLANES
from skydome.ground.directions import rotate_about_vertical
from skydome.ground.quadrature import hemisphere

SUN = sd.direction(2.0, 30 * sd.deg)
SKY = sd.HosekWilkie(SUN, 3.0)
ORDERS = {"spherical": 4, "hemispherical": 4, "legendre": 4, "steerable": 4, "gaussians": 32}
every_kind = pytest.mark.parametrize("kind", KINDS)


@pytest.mark.parametrize(
    ("kind", "expected"),
    [
        ("spherical", {2: 0.61, 4: 0.46, 6: 0.38}),
        ("hemispherical", {2: 0.28, 4: 0.17, 6: 0.11}),
        ("legendre", {2: 0.21, 4: 0.10, 6: 0.06}),
        ("steerable", {2: 0.21, 4: 0.105, 6: 0.053}),
        ("gaussians", {8: 0.58, 16: 0.44, 32: 0.21}),
    ],
)
def test_error_falls_with_the_order(kind, expected):
    """The figures of docs/models/bases.md, and that the errors told are those of the light."""
    found = {order: sd.SkyBasis.fit(SKY, kind, order).errors(SKY) for order in expected}
    for order, rms in expected.items():
        assert found[order].rms == pytest.approx(rms, rel=0.15)
    sizes = [errors.rms for errors in found.values()]
    assert sizes == sorted(sizes, reverse=True)
    views = hemisphere(40, 80)[0]
    shares = hemisphere(40, 80)[1] / (2 * np.pi)
    true, small = SKY.luminance(views), sd.SkyBasis.fit(SKY, kind, min(expected)).luminance(views)
    rms = np.sqrt(shares @ (true - small) ** 2) / (shares @ true)
    assert rms == pytest.approx(found[min(expected)].rms, rel=0.01)


@every_kind
def test_irradiance_from_the_coefficients_is_the_integral_of_the_functions(kind):
    small = sd.SkyBasis.fit(SKY, kind, ORDERS[kind])
    if kind == "spherical":  # whose lobe is that of the whole sphere
        whole = sd.SphericalHarmonics.of(SKY, 4)
        np.testing.assert_allclose(small.irradiance(PLANES), whole.irradiance(PLANES), rtol=1e-3)
        return
    nodes, solid_angles = hemisphere(120, 240)
    direct = (np.maximum(PLANES @ nodes.T, 0) * solid_angles) @ small.at(nodes)
    np.testing.assert_allclose(small.irradiance(PLANES), direct, rtol=2e-3)
    np.testing.assert_allclose(small.irradiance(), sd.illuminance(SKY), rtol=0.05)


@every_kind
def test_a_turned_sky_is_the_sky_of_a_turned_sun(kind):
    small = sd.SkyBasis.fit(SKY, kind, ORDERS[kind])
    angle = 0.8
    matrix = rotate_about_vertical(np.eye(3), angle).T
    turned = small.rotated(matrix)
    views = hemisphere(10, 20)[0]
    np.testing.assert_allclose(turned.at(rotate_about_vertical(views, angle)), small.at(views), rtol=1e-8, atol=1e-6)
    if kind in ("hemispherical", "legendre"):
        with pytest.raises(ValueError, match="about the vertical only"):
            small.rotated(np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]]))


@pytest.mark.parametrize("kind", ["spherical", "steerable", "gaussians"])
def test_lobes_steer_any_way(kind):
    from scipy.spatial.transform import Rotation

    matrix = Rotation.from_rotvec([0.3, -0.5, 0.9]).as_matrix()
    small = sd.SkyBasis.fit(SKY, kind, ORDERS[kind])
    views = np.random.default_rng(1).normal(size=(50, 3))
    views /= np.linalg.norm(views, axis=1)[:, None]
    np.testing.assert_allclose(small.rotated(matrix).at(views @ matrix.T), small.at(views), rtol=1e-7, atol=1e-4)


def test_hemispherical_harmonics_are_orthonormal_over_the_upper_half():
    basis = KINDS["hemispherical"](6)
    nodes, solid_angles = hemisphere(64, 64)
    values = basis.functions(nodes)
    np.testing.assert_allclose(values.T @ (values * solid_angles[:, None]), np.eye(49), atol=1e-10)


def test_gaussians_are_never_negative_and_nearest():
    """Their weights are those of SciPy's non-negative least squares."""
    from scipy.optimize import nnls

    small = sd.SkyBasis.fit(SKY, "gaussians", 12)
    nodes, solid_angles = flat_nodes()
    root = np.sqrt(solid_angles)
    values = small.basis.functions(nodes) * root[:, None]
    expected = np.stack([nnls(values, SKY.xyz(nodes)[:, k] * root)[0] for k in range(3)])
    assert (small.coefficients >= 0).all()
    np.testing.assert_allclose(small.coefficients, expected, atol=1e-5 * expected.max())


def test_a_day_of_skies_with_gradients_and_without_the_disc():
    suns = sd.direction(2.0, np.array([0.2, 0.6, 1.0]))[:, None, :]
    day = sd.SkyBasis.fit(sd.HosekWilkie(suns, 3.0) + sd.SunDisc(suns, 3.0), "steerable", 4)
    assert day.coefficients.shape == (3, 1, 3, 25)
    assert day.luminance(hemisphere(4, 8)[0]).shape == (3, 32)
    one = sd.SkyBasis.fit(sd.HosekWilkie(suns[1, 0], 3.0), "steerable", 4)
    np.testing.assert_allclose(day.coefficients[1, 0], one.coefficients, rtol=1e-10)
    torch = pytest.importorskip("torch")
    turbidity = torch.tensor(3.3, dtype=torch.float64, requires_grad=True)
    sd.SkyBasis.fit(sd.HosekWilkie(torch.as_tensor(SUN), turbidity), "steerable", 4).irradiance().backward()
    step = [float(sd.SkyBasis.fit(sd.HosekWilkie(SUN, t), "steerable", 4).irradiance()) for t in (3.299, 3.301)]
    assert float(turbidity.grad) == pytest.approx((step[1] - step[0]) / 0.002, rel=1e-4)


def test_habel_polynomials_are_the_integrals():
    rng = np.random.default_rng(0)
    sun = sd.direction(rng.uniform(0, 6.28, 60), rng.uniform(0.01, 1.57, 60))
    turbidity = rng.uniform(2, 6, 60)
    fast = sd.preetham_harmonics(sun[:, None, :], turbidity[:, None])
    slow = sd.SphericalHarmonics.of_colour(sd.Preetham(sun[:, None, :], turbidity[:, None]), 5).coefficients
    off = np.linalg.norm(fast.coefficients[:, 0] - slow, axis=-1) / np.linalg.norm(slow, axis=-1)
    assert np.median(off) < 2e-3
    assert off.max() < 1.2e-2
    assert (sd.preetham_harmonics(sd.direction(1.0, -0.1), 3.0).coefficients == 0).all()


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: sd.SkyBasis.fit(SKY, "wavelets", 3), "kind must be one of spherical, .* got 'wavelets'"),
        (lambda: sd.SkyBasis.fit(SKY, "steerable", 0), r"order of SteerableBasis must be .* \[1, 12\], got 0"),
        (lambda: sd.SkyBasis(KINDS["legendre"](1), np.zeros(5)), r"coefficients must have shape \(..., 6\)"),
        (lambda: sd.SkyBasis.fit(SKY).rotated(np.diag([1.0, 1.0, -1.0])), "matrix must be a rotation"),
        (lambda: sd.preetham_harmonics(SUN, 9.0), r"turbidity must lie in \[2, 6\], got 9"),
    ],
)
def test_bad_input_says_what_got_and_allowed(call, message):
    with pytest.raises(ValueError, match=message):
        call()
