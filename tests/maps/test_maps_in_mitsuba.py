"""Light of our files in Mitsuba itself: what a white floor and a white wall receive, and where the sun stands."""

import numpy as np
import pytest
from typer.testing import CliRunner

import skydome as sd
from skydome.cli.main import app
from skydome.maps.loading import load

pytestmark = pytest.mark.slow


def irradiance_in_mitsuba(path, normals):
    """What planes with our normals receive under `envmap`, in the file's own luminance, by its own eval."""
    mi = pytest.importorskip("mitsuba")
    mi.set_variant("scalar_rgb")
    sky = mi.load_dict({"type": "scene", "sky": {"type": "envmap", "filename": str(path)}}).environment()
    rows = 512
    layout = sd.Equirectangular()
    toward = layout.directions(rows)[: rows // 2]
    looks = sd.target("mitsuba").frame_vectors(toward)
    interaction = mi.SurfaceInteraction3f()
    light = np.zeros(toward.shape)
    for place in np.ndindex(toward.shape[:2]):
        interaction.wi = mi.Vector3f(*(-looks[place]))
        light[place] = np.array(sky.eval(interaction)).ravel()
    flux = (light @ sd.SRGB.to_xyz[1]) * layout.solid_angles(rows)[: rows // 2]
    return [float((flux * np.maximum(toward @ normal, 0)).sum()) for normal in normals]


@pytest.mark.parametrize(("height", "elevation", "tolerance"), [(64, 3.0, 0.025), (64, 25.0, 0.01), (128, 12.0, 0.005)])
def test_sunlight_on_floor_and_wall(height, elevation, tolerance, tmp_path):
    """Mitsuba blends between texels, rows H - 1 apart: of a sun one row up that moves 2 % of its light (before: 33 %)."""
    sun = sd.direction(217.3 * sd.deg, elevation * sd.deg)
    disc = sd.SunDisc(sun, 3.0)
    sd.render(disc, height, ground_albedo=0.0).save(tmp_path / "sky.exr", target="mitsuba")
    wall = sd.direction(217.3 * sd.deg, 0.0)
    floor, facing = irradiance_in_mitsuba(tmp_path / "sky.exr", [sd.ZENITH, wall])
    assert floor == pytest.approx(float(disc.illuminance(sd.ZENITH)), rel=tolerance)
    assert facing == pytest.approx(float(disc.illuminance(wall)), rel=0.02)


def test_a_map_made_for_blender_and_converted_has_its_sun_in_place(tmp_path):
    """Nobody says what the file's layout is: its header does."""
    sun = sd.direction(100 * sd.deg, 35 * sd.deg)
    sky = sd.HosekWilkie(sun, 3.0)
    sd.render(sky + sd.SunDisc.of(sky), 64, ground_albedo=0.0).save(tmp_path / "a.exr", target="blender")
    words = ["convert", f"{tmp_path}/a.exr", "--target", "mitsuba", "-o", f"{tmp_path}/b.exr"]
    assert CliRunner().invoke(app, words).exit_code == 0
    walls = [sd.direction(azimuth * sd.deg, 0.0) for azimuth in (100, 280, 10, 190)]
    got = irradiance_in_mitsuba(tmp_path / "b.exr", walls)
    expected = [float(load(tmp_path / "a.exr").illuminance(wall)) for wall in walls]
    expected_in_front = float(sd.illuminance(sky + sd.SunDisc.of(sky), walls[0]))
    assert got[0] == pytest.approx(expected_in_front, rel=0.01)
    assert got == pytest.approx(expected, rel=0.02)
