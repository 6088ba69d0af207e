"""Scenes of triangles: closed rooms, a long street, files, and what is refused."""

import numpy as np
import pytest

import skydome as sd
from skydome.surroundings.radiosity import parallel_rectangles, perpendicular_rectangles

pytest.importorskip("trimesh")
pytest.importorskip("embreex")
ROOM = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], dtype=float)
SIDES = [[0, 1, 2, 3], [4, 7, 6, 5], [0, 4, 5, 1], [3, 2, 6, 7], [0, 3, 7, 4], [1, 5, 6, 2]]
FACES = [[side[i] for i in three] for side in SIDES for three in ((0, 1, 2), (0, 2, 3))]


def test_factors_in_a_closed_room():
    room = sd.MeshScene(ROOM, FACES, 0.5)
    np.testing.assert_allclose(room.factors.sum(axis=1), 1.0, atol=1e-9)
    flux = room.areas[:, None] * room.factors
    np.testing.assert_allclose(flux, flux.T, atol=0.02)
    between = room.factors[:2].mean(axis=0)
    assert between[2:4].sum() == pytest.approx(parallel_rectangles(1, 1, 1), abs=0.01)
    assert between[4:6].sum() == pytest.approx(perpendicular_rectangles(1, 1, 1), abs=0.01)
    assert room.illuminance(sd.Uniform(1000.0), [[0.5, 0.5, 0.0]]).total[0] == 0


def test_a_street_of_triangles_is_the_endless_one():
    corners = np.array(
        [[-5, y, z] for y in (-500, 500) for z in (0, 10)] + [[5, y, z] for y in (-500, 500) for z in (0, 10)]
    )
    faces = [[0, 2, 3], [0, 3, 1], [4, 7, 6], [4, 5, 7]]
    lit = sd.MeshScene(corners, faces).illuminance(sd.Uniform(1 / np.pi), [[0, 0, 0], [3, 0, 0]]).sky
    np.testing.assert_allclose(lit, sd.StreetCanyon(10.0, 10.0).point_view_factor([0.0, 3.0]), atol=2e-4)


def test_the_sun_and_open_ground_about_a_wall():
    wall = sd.MeshScene([[-50, 5, 0], [50, 5, 0], [50, 5, 6], [-50, 5, 6]], [[0, 1, 2], [0, 2, 3]], 0.0, 0.2)
    for azimuth, lit in ((0.0, False), (np.pi, True)):
        sun = sd.direction(azimuth, 0.5)
        whole = sd.Uniform(1000.0) + sd.SunDisc(sun, 3.0)
        received = wall.illuminance(whole, [[0, 0, 0.0]])
        assert received.sun[0] == pytest.approx(float(sd.SunDisc(sun, 3.0).illuminance(sd.ZENITH)) * lit)
    south = wall.illuminance(sd.Uniform(1000.0), [[0, 4, 2.0]], sd.SOUTH)
    assert south.reflected[0] == pytest.approx(0.2 * 1000 * np.pi / 2, rel=1e-3)


def test_a_scene_is_read_and_cut(tmp_path):
    lines = ["v {} {} {}".format(*corner) for corner in ROOM] + [
        "f {} {} {}".format(*(i + 1 for i in f)) for f in FACES
    ]
    path = tmp_path / "room.obj"
    path.write_text("\n".join(lines))
    room = sd.MeshScene.read(path, 0.3)
    assert len(room.faces) == 12
    fine = room.finer(0.5)
    assert len(fine.faces) > 48
    assert fine.areas.sum() == pytest.approx(6.0)
    assert set(fine.reflectance) == {0.3}


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"faces": np.zeros((0, 3), int)}, "N >= 1"),
        ({"faces": [[0, 1, 99]]}, r"whole numbers in \[0, 8\), got 0 to 99"),
        ({"faces": [[0, 1, 1]]}, "must have an area"),
        ({"vertices": np.full((8, 3), np.nan)}, "must be finite"),
        ({"reflectance": 1.0}, r"reflectance must lie in \[0, 1\)"),
    ],
)
def test_bad_scenes_are_refused(change, said):
    with pytest.raises(ValueError, match=said):
        sd.MeshScene(**({"vertices": ROOM, "faces": FACES} | change))
    with pytest.raises(ValueError, match="3 finite numbers"):
        sd.MeshScene(ROOM, FACES).at((0, np.nan, 0))
