"""Light of our files in Mitsuba itself: what a white floor and a white wall receive, and where the sun stands."""

import numpy as np
import pytest
from typer.testing import CliRunner

import skydome as sd
from skydome.cli.main import app
from skydome.maps.loading import load

pytestmark = pytest.mark.slow


def irradiance_in_mitsuba(path, normals, rows=512, about=None, within=np.pi):
    """What planes with our normals receive under `envmap`, by its own eval, from what is `within` that angle."""
    mi = pytest.importorskip("mitsuba")
    mi.set_variant("scalar_rgb")
    sky = mi.load_dict({"type": "scene", "sky": {"type": "envmap", "filename": str(path)}}).environment()
    layout = sd.Equirectangular()
    toward, angles = layout.directions(rows), np.broadcast_to(layout.solid_angles(rows), (rows, 2 * rows))
    near = toward[..., 2] > 0
    if about is not None:
        near &= toward @ about > np.cos(within)
    interaction, light = mi.SurfaceInteraction3f(), []
    for look in sd.target("mitsuba").frame_vectors(toward[near]):
        interaction.wi = mi.Vector3f(*(-look))
        light.append(np.array(sky.eval(interaction)).ravel())
    flux = (np.array(light) @ sd.SRGB.to_xyz[1]) * angles[near]
    return [float((flux * np.maximum(toward[near] @ normal, 0)).sum()) for normal in normals]


@pytest.mark.parametrize("elevation", [3.0, 12.0, 40.0])
@pytest.mark.parametrize(("height", "tolerance"), [(64, 0.05), (512, 0.007)])
def test_sunlight_on_the_floor(height, elevation, tolerance, tmp_path):
    """Mitsuba spaces rows by 1 / (H - 1): a texel has 1 / H more light there, and stands up to half a texel off."""
    sun = sd.direction(217.3 * sd.deg, elevation * sd.deg)
    disc = sd.SunDisc(sun, 3.0)
    path = tmp_path / "sky.exr"
    sd.render(disc, height, ground_albedo=0.0).save(path, target="mitsuba")
    floor = irradiance_in_mitsuba(path, [sd.ZENITH], 8 * height, sun, 4 * np.pi / height)[0]
    assert floor == pytest.approx(float(disc.illuminance(sd.ZENITH)), rel=tolerance)


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
