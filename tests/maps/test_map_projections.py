"""Projections: directions and texels are each other's inverse, and texels tile the sphere."""

from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from skydome.ground.directions import EAST, NORTH, SOUTH, WEST, ZENITH, direction
from skydome.maps.lookup import bilinear
from skydome.maps.projections import (
    CubeMap,
    EqualAreaSquare,
    Equidistant,
    Equirectangular,
    EquirectangularOfWidth,
    Equisolid,
    Fisheye,
    Projection,
    SkyView,
)

WHOLE = [
    (Equirectangular(), 32),
    (Equirectangular(azimuth_left=1.3, mirrored=True), 18),
    (EqualAreaSquare(), 32),
    (EqualAreaSquare(), 33),
    (CubeMap(), 6 * 16),
    (CubeMap(), 6 * 7),
    (Fisheye(2 * np.pi, Equisolid()), 32),
    (Fisheye(2 * np.pi, Equidistant()), 33),
    (EquirectangularOfWidth(width=13), 9),
    (EquirectangularOfWidth(width=40), 7),
    (SkyView(width=24), 18),
    (SkyView(width=13, azimuth_left=0.4, mirrored=True), 7),
]
PARTIAL = [(Fisheye(), 32), (Fisheye(2.0, Equisolid()), 31)]
EVERY = WHOLE + PARTIAL
names = [f"{projection}-{height}" for projection, height in EVERY]


@pytest.mark.parametrize(("projection", "height"), EVERY, ids=names)
def test_texel_centres_come_back(projection, height):
    toward = projection.directions(height)
    row, column, covered = projection.pixels(toward, height)
    centre_row, centre_column = projection.centres(height)
    valid = projection.valid(height)
    assert toward.shape == (*projection.shape(height), 3)
    np.testing.assert_allclose(np.linalg.norm(toward, axis=-1), 1, atol=1e-14)
    np.testing.assert_allclose(row[valid], np.broadcast_to(centre_row, valid.shape)[valid], atol=1e-10)
    np.testing.assert_allclose(column[valid], np.broadcast_to(centre_column, valid.shape)[valid], atol=1e-10)
    assert covered[valid].all()


@pytest.mark.parametrize(("projection", "height"), WHOLE, ids=names[: len(WHOLE)])
@given(turn=st.floats(0, 7), climb=st.floats(-np.pi / 2, np.pi / 2))
def test_any_direction_comes_back(projection, height, turn, climb):
    toward = direction(turn, climb)
    row, column, covered = projection.pixels(toward, height)
    rows, columns = projection.shape(height)
    assert covered
    assert 0 <= row < rows
    assert 0 <= column < columns
    slack = 3e-7 if climb < -1.5 else 1e-9  # the nadir is the whole rim of a mirror ball: ill-conditioned there
    np.testing.assert_allclose(projection.toward(row, column, height), toward, atol=slack)


@pytest.mark.parametrize(("projection", "height"), EVERY, ids=names)
def test_rows_are_slices_of_the_whole(projection, height):
    part = slice(3, 7)
    shape = projection.shape(height)
    for method in (projection.directions, projection.valid, projection.vector_solid_angles):
        np.testing.assert_array_equal(method(height, part), method(height)[part])
    angles = np.broadcast_to(projection.solid_angles(height), shape)
    part_angles = np.broadcast_to(projection.solid_angles(height, part), (4, shape[1]))
    np.testing.assert_allclose(part_angles, angles[part], rtol=1e-14)


@pytest.mark.parametrize(("projection", "height"), EVERY, ids=names)
def test_solid_angles_add_up_and_equal_their_numeric_integral(projection, height):
    angles = np.broadcast_to(projection.solid_angles(height), projection.shape(height))
    cap = 4 * np.pi * np.sin(getattr(projection, "coverage", 2 * np.pi) / 4) ** 2
    assert angles.sum() == pytest.approx(cap, rel=1e-12)
    assert ((angles > 0) == projection.valid(height)).all()
    row, column = (np.broadcast_to(x, angles.shape) for x in projection.centres(height))
    step = 1e-4  # texels: a small parallelogram about 8 x 8 points of each texel, as the map stretches it
    total = np.zeros(angles.shape)
    for down, right in product(np.arange(-3.5, 4) / 8, repeat=2):
        i, j = row + down, column + right
        across = projection.toward(i, j + step, height) - projection.toward(i, j - step, height)
        along = projection.toward(i + step, j, height) - projection.toward(i - step, j, height)
        total += np.linalg.norm(np.cross(across, along), axis=-1) / (4 * step**2) / 64
    middle = np.ones(angles.shape, dtype=bool)
    if isinstance(projection, Fisheye):  # one factor makes up for the rim's whole texels
        middle = projection.radii(height) < 0.9
        factor = np.mean(total[middle] / angles[middle])
        assert factor == pytest.approx(1, abs=1 / height)
        total /= factor
    np.testing.assert_allclose(total[middle], angles[middle], rtol=4e-3)


@pytest.mark.parametrize(("projection", "height"), WHOLE[:6], ids=names[:6])
def test_closed_vector_integrals_equal_sampled_ones(projection, height):
    closed = projection.vector_solid_angles(height)
    fine = np.broadcast_to(projection.solid_angles(height * 16), projection.shape(height * 16))
    toward = projection.directions(height * 16) * fine[..., None]
    rows, columns = projection.shape(height)
    sampled = toward.reshape(rows, 16, columns, 16, 3).sum(axis=(1, 3))
    error = 2e-3 if isinstance(projection, EqualAreaSquare) else 1e-4  # the square's own is sampled
    np.testing.assert_allclose(closed, sampled, atol=error * float(np.max(fine)) * 256)
    np.testing.assert_allclose(closed.sum(axis=(0, 1)), 0, atol=1e-12)


def test_compass_points_of_the_native_map():
    row, column, _ = Equirectangular().pixels(np.array([EAST, SOUTH, WEST]), 100)
    np.testing.assert_allclose(column / 200, [0.25, 0.5, 0.75])
    np.testing.assert_allclose(row, 50)
    assert Equirectangular().pixels(NORTH, 100)[1] == 0


def test_native_texels_by_the_printed_equations():
    """Eq. 20 and 21 of the equations page that docs/errata.md names.

    u = (i + .5) / W, v = (2 j + 1) / H over the sky's half, psi = 2 pi u, phi = pi / 2 (1 - v).
    """
    height, i, j = 64, 37, 11
    u, v = (i + 0.5) / 128, (2 * j + 1) / 64
    toward = direction(2 * np.pi * u, np.pi / 2 * (1 - v))
    np.testing.assert_allclose(Equirectangular().directions(height)[j, i], toward, atol=1e-15)


def test_pbrt_square_equals_pbrts_own_function():
    """EqualAreaSquareToSphere of pbrt-v4's util/math.cpp, written out for one point."""

    def literal(x, y):
        u, v = 2 * x - 1, 2 * y - 1
        up, vp = abs(u), abs(v)
        signed_distance = 1 - (up + vp)
        d = abs(signed_distance)
        r = 1 - d
        phi = (1 if r == 0 else (vp - up) / r + 1) * np.pi / 4
        z = np.copysign(1 - r * r, signed_distance)
        cos_phi, sin_phi = np.copysign(np.cos(phi), u), np.copysign(np.sin(phi), v)
        return [cos_phi * r * np.sqrt(2 - r * r), sin_phi * r * np.sqrt(2 - r * r), z]

    for x, y in np.random.default_rng(1).random((200, 2)):
        np.testing.assert_allclose(EqualAreaSquare().toward(10 * y, 10 * x, 10), literal(x, y), atol=1e-14)
    for point, axis in (((0.5, 0.5), ZENITH), ((1.0, 0.5), EAST), ((0.5, 1.0), NORTH), ((0.0, 0.0), -ZENITH)):
        np.testing.assert_allclose(EqualAreaSquare().toward(point[1], point[0], 1), axis, atol=1e-15)


def test_cube_faces_follow_opengl():
    """OpenGL 4.6, table 8.19: s_c, t_c, m_a per face for r = (X, Y, Z); s = (s_c / |m_a| + 1) / 2, t likewise."""
    table = ["-Z -Y +X", "+Z -Y -X", "+X +Z +Y", "+X -Z -Y", "+X -Y +Z", "-X -Y -Z"]
    for x, y, z in np.random.default_rng(2).normal(size=(300, 3)):
        length = np.sqrt(x * x + y * y + z * z)
        frame = {"X": x, "Y": z, "Z": -y}  # x east, y north, z up as Y-up
        parts = [[float(f"{entry[0]}1") * frame[entry[1]] for entry in line.split()] for line in table]
        face = int(np.argmax([major for _, _, major in parts]))
        sc, tc, ma = parts[face]
        row, column, _ = CubeMap().pixels(np.array([x, y, z]) / length, 60)
        np.testing.assert_allclose([row, column], [10 * face + 5 * (tc / ma + 1), 5 * (sc / ma + 1)], atol=1e-10)


def test_fisheye_is_seen_lying_on_the_back():
    row, column, _ = Fisheye().pixels(np.array([NORTH, EAST, ZENITH]), 100)
    np.testing.assert_allclose(row, [0, 50, 50], atol=1e-9)
    np.testing.assert_allclose(column, [50, 0, 50], atol=1e-9)
    assert not Fisheye().pixels(direction(1.0, -0.1), 100)[2]


@pytest.mark.parametrize(("projection", "height"), WHOLE[:6], ids=names[:6])
def test_blending_is_smooth_across_seams_poles_and_faces(projection, height):
    """A linear function of direction comes back: within a texel's curvature, or its kink at a layout's fold."""
    height *= 4
    tilt = np.array([0.3, -0.5, 0.8])
    pixels = (projection.directions(height) @ tilt)[..., None]
    rng = np.random.default_rng(3)
    toward = rng.normal(size=(4000, 3))
    toward = np.concatenate([toward / np.linalg.norm(toward, axis=-1, keepdims=True), [ZENITH, -ZENITH, NORTH, EAST]])
    values, covered = bilinear(pixels, projection, toward)
    assert covered.all()
    tolerance = 0.15 / height if isinstance(projection, Equirectangular) else 2 / height
    assert np.abs(values[..., 0] - toward @ tilt).max() < tolerance


@pytest.mark.parametrize(
    ("projection", "height"),
    [(Equirectangular(), 3), (Equirectangular(), 0), (Equirectangular(), 8.0), (CubeMap(), 16), (EqualAreaSquare(), 0),
     (Fisheye(), True), (Fisheye(), -4)],
)  # fmt: skip
def test_heights_that_a_layout_cannot_take(projection, height):
    with pytest.raises(ValueError, match="height of") as caught:
        projection.shape(height)
    assert "\n" not in str(caught.value)


def test_wrong_parameters():
    with pytest.raises(ValueError, match="coverage must lie in"):
        Fisheye(coverage=7.0)
    with pytest.raises(ValueError, match="azimuth_left must lie in"):
        Equirectangular(azimuth_left=float("nan"))


def test_the_grid_of_any_width_and_height_is_that_of_the_equations():
    """Eq. 20 and 21: u = (i + .5) / W, v = (2 j + 1) / H over floor(H / 2) rows; and light is kept on it."""
    import skydome as sd

    width, height = 37, 21
    grid = EquirectangularOfWidth(width=width).directions(height)
    i, j = np.arange(width), np.arange(height // 2)[:, None]
    turn, climb = 2 * np.pi * (i + 0.5) / width, np.pi / 2 * (1 - (2 * j + 1) / height)
    np.testing.assert_allclose(grid[: height // 2], direction(turn, climb), atol=1e-14)
    other = EquirectangularOfWidth(width=90)
    sampled = Projection.vector_solid_angles(other, 31)
    np.testing.assert_allclose(other.vector_solid_angles(31), sampled, atol=2e-3 * np.abs(sampled).max())
    picture = sd.render(sd.Daylight(sd.Uniform(1.0)), height=301, projection=EquirectangularOfWidth(width=200))
    assert picture.pixels.shape == (301, 200, 3)
    np.testing.assert_allclose(picture.illuminance(ZENITH), np.pi, rtol=0.02)


def test_a_sky_view_map_of_108_rows_holds_the_horizon_better():
    """Hillaire 2020, section 5.3: 192 x 108 texels looked up again stand nearer to the sky than even rows do."""
    import skydome as sd

    sky = sd.HosekWilkie(direction(1.0, 0.1), turbidity=3.0)
    toward = direction(np.linspace(0, 6.2, 37), np.geomspace(0.003, 1.5, 29)[:, None])

    def error(layout):
        held = sd.CapturedSky(sd.render(sky, height=108, projection=layout, dtype=np.float64), sky.sun)
        return np.sqrt(np.mean((held.luminance(toward) / sky.luminance(toward) - 1) ** 2))

    assert error(SkyView()) < 0.5 * error(EquirectangularOfWidth(width=192))
