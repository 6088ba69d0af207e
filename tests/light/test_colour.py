import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

import skydome as sd
from skydome.light.colour import (
    ACESCG,
    D65,
    IEC_XYZ_TO_SRGB,
    RADIANCE,
    REC2020,
    SRGB,
    decode_srgb,
    encode_srgb,
    rgb_from_xyz,
    xyY_from_xyz,
    xyz_from_rgb,
    xyz_from_xyY,
    xyz_of_white,
)

SPACES = [SRGB, REC2020, ACESCG, ACESCG.adapted(None), RADIANCE]
colours = arrays(np.float64, (5, 3), elements=st.floats(0, 1e5))


@pytest.mark.parametrize("space", SPACES, ids=lambda space: f"{space.name}-{space.adapted_from}")
def test_matrices_are_inverses_and_white_is_one(space):
    np.testing.assert_allclose(space.to_xyz @ space.from_xyz, np.eye(3), atol=1e-12)
    white = space.adapted_from or space.white
    np.testing.assert_allclose(rgb_from_xyz(xyz_of_white(white), space), 1.0, atol=1e-12)
    np.testing.assert_allclose(xyz_from_rgb(np.ones(3), space)[1], 1.0, atol=1e-12)


@given(colours)
@pytest.mark.parametrize("space", SPACES, ids=lambda space: f"{space.name}-{space.adapted_from}")
def test_round_trip(space, xyz):
    np.testing.assert_allclose(xyz_from_rgb(rgb_from_xyz(xyz, space), space), xyz, rtol=1e-12, atol=1e-12 * 1e5)


def test_white_of_srgb_is_white_in_acescg_and_rec2020():
    white = xyz_from_rgb(np.ones(3))
    for space in (REC2020, ACESCG):
        np.testing.assert_allclose(rgb_from_xyz(white, space), 1.0, atol=1e-12)


def test_seed_matrix_differs_from_the_derived_as_stated():
    assert 3.4e-4 < np.abs(SRGB.from_xyz - IEC_XYZ_TO_SRGB).max() < 3.5e-4
    assert 1.7e-4 < np.abs(IEC_XYZ_TO_SRGB @ xyz_of_white(D65) - 1).max() < 1.8e-4


@pytest.mark.parametrize(
    ("space", "name"),
    [(SRGB, "sRGB"), (REC2020, "ITU-R BT.2020"), (ACESCG.adapted(None), "ACEScg")],
)
def test_matrices_against_colour_science(colour, space, name):
    theirs = colour.RGB_COLOURSPACES[name].copy()
    theirs.use_derived_transformation_matrices(True)
    np.testing.assert_allclose(space.to_xyz, theirs.matrix_RGB_to_XYZ, atol=1e-9)


def test_acescg_adaptation_against_colour_science(colour):
    theirs = colour.matrix_RGB_to_RGB("sRGB", "ACEScg", chromatic_adaptation_transform="Bradford")
    np.testing.assert_allclose(ACESCG.from_xyz @ SRGB.to_xyz, theirs, atol=1e-3)


def test_acescg_golden():
    # Linear sRGB to ACEScg by Bradford, as in the OpenColorIO ACES configuration's sRGB texture space.
    published = [
        [0.613097, 0.339523, 0.047379],
        [0.070194, 0.916354, 0.013452],
        [0.020616, 0.109570, 0.869815],
    ]
    np.testing.assert_allclose(ACESCG.from_xyz @ SRGB.to_xyz, published, atol=2e-5)


def test_radiance_luminance_weights():
    # Radiance src/common/color.h, CIE_rf, CIE_gf, CIE_bf, for a white that it writes .3333
    np.testing.assert_allclose(RADIANCE.to_xyz[1], [0.265074126, 0.670114631, 0.064811243], atol=5e-5)


@given(arrays(np.float64, (4, 3), elements=st.floats(1, 1e5)))
def test_chromaticity_round_trip(xyz):
    np.testing.assert_allclose(xyz_from_xyY(xyY_from_xyz(xyz)), xyz, rtol=1e-9)


def test_black_and_y_zero():
    np.testing.assert_array_equal(xyz_from_xyY([0.3, 0.0, 5.0]), 0)
    np.testing.assert_allclose(xyY_from_xyz([0.0, 0.0, 0.0]), [*D65, 0.0])
    assert np.isfinite(xyY_from_xyz([0.0, 0.0, 1.0])).all()


@given(arrays(np.float64, (20,), elements=st.floats(-10, 10)))
def test_encoding_round_trip_and_symmetry(linear):
    encoded = encode_srgb(linear)
    np.testing.assert_allclose(encode_srgb(-linear), -encoded, atol=0)
    np.testing.assert_allclose(decode_srgb(encoded), linear, rtol=1e-12, atol=3e-9)


def test_encoding_round_trip_is_exact_away_from_the_step():
    linear = np.concatenate([np.linspace(0, 0.0031308, 100), np.linspace(0.003132, 2, 100)])
    np.testing.assert_allclose(decode_srgb(encode_srgb(linear)), linear, atol=1e-12)


def test_encoding_against_colour_science(colour):
    linear = np.linspace(0, 1, 1001)
    np.testing.assert_allclose(encode_srgb(linear), colour.models.eotf_inverse_sRGB(linear), atol=1e-12)
    np.testing.assert_allclose(decode_srgb(linear), colour.models.eotf_sRGB(linear), atol=1e-8)


def test_float32_stays():
    assert rgb_from_xyz(np.ones((2, 3), dtype=np.float32), ACESCG).dtype == np.float32
    assert encode_srgb(np.float32(0.5)).dtype == np.float32


def test_gradients_are_finite_at_black():
    torch = pytest.importorskip("torch")
    xyz = torch.zeros(2, 3, dtype=torch.float64, requires_grad=True)
    encode_srgb(rgb_from_xyz(xyz)).sum().backward()
    assert torch.isfinite(xyz.grad).all()
    xyz.grad = None
    xyz_from_xyY(xyY_from_xyz(xyz)).sum().backward()
    assert torch.isfinite(xyz.grad).all()


@pytest.mark.parametrize("function", [xyz_from_xyY, xyY_from_xyz, rgb_from_xyz, xyz_from_rgb, encode_srgb, decode_srgb])
@pytest.mark.parametrize("library", ["torch", "jax.numpy"])
def test_other_libraries_agree(library, function):
    xp = pytest.importorskip(library)
    values = np.random.default_rng(5).uniform(0.1, 1, (4, 3)).astype(np.float32)
    theirs = function(xp.asarray(values))
    assert type(theirs) is type(xp.asarray(values))
    np.testing.assert_allclose(np.asarray(theirs), function(values), rtol=1e-5, atol=1e-6)


def test_the_printed_space_has_the_printed_matrix():
    sky = sd.Preetham(sd.direction(1.0, 0.6), 3.0)
    xyz = sky.xyz(sd.ZENITH)
    np.testing.assert_allclose(sky.rgb(sd.ZENITH, sd.SRGB_PRINTED), IEC_XYZ_TO_SRGB @ xyz, rtol=1e-12)
    np.testing.assert_allclose(sd.SRGB_PRINTED.to_xyz @ IEC_XYZ_TO_SRGB, np.eye(3), atol=1e-12)
