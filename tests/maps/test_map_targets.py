"""Each renderer sees the compass where it should: its own published formula finds the marks in our files."""

import re

import numpy as np
import pytest

from skydome.ground import exr
from skydome.ground.directions import direction
from skydome.ground.units import deg
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.projections import CubeMap, EqualAreaSquare, Equirectangular, Fisheye
from skydome.maps.targets import TARGETS, target

# The facts: the renderer's axis at u = .25, .5, .75 of its map (ImfEnvmap.h, schema.usda, envmap.cpp, equirectUv,
# camera/projection.h, envmap/projections.py), read from their sources.
AXES = {
    "openexr": "+X +Z -X", "usd": "+X +Z -X", "mitsuba": "+X +Z -X", "skylibs": "-X -Z +X",
    "three": "-Z +X +Z", "blender": "+Y +X -Y", "native": "+X -Y -X", "radiance": "+X -Y -X",
}  # fmt: skip
SPOT = direction(250 * deg, 30 * deg)
COMPASS = {"north": (1.0, 0.1, 0.1), "east": (0.1, 1.0, 0.1), "south": (0.1, 0.1, 1.0), "west": (1.0, 1.0, 0.1)}


def axis(letters):
    return float(f"{letters[0]}1") * np.eye(3)["XYZ".index(letters[1])]


def card(height=64):
    """Red to the north, green east, blue south, yellow west; grey ground; a bright spot at azimuth 250, height 30."""
    toward = Equirectangular().directions(height)
    quarter = np.mod(np.rint(np.arctan2(toward[..., 0], toward[..., 1]) / (np.pi / 2)), 4).astype(int)
    pixels = np.array(list(COMPASS.values()))[quarter]
    pixels[toward[..., 2] < 0] = 0.3
    row, column, _ = Equirectangular().pixels(SPOT, height)
    pixels[int(row), int(column)] = 1000.0
    return EnvironmentMap(pixels.astype(np.float32))


@pytest.mark.parametrize("name", AXES)
def test_axes_at_the_quarters(name):
    convention = target(name)
    height = 64
    for u, letters in zip((0.25, 0.5, 0.75), AXES[name].split(), strict=True):
        native = convention.projection.toward(height / 2, u * 2 * height, height)
        np.testing.assert_allclose(convention.frame_vectors(native), axis(letters), atol=1e-14)
    assert not convention.projection.mirrored


def test_every_equirectangular_target_is_in_the_facts_and_frames_are_rotations():
    assert set(AXES) == {t.name for t in TARGETS if isinstance(t.projection, Equirectangular)}
    for convention in TARGETS:
        frame = np.array(convention.to_frame)
        np.testing.assert_array_equal(frame @ frame.T, np.eye(3))
        assert np.linalg.det(frame) == 1
        assert len({t.name for t in TARGETS}) == len(TARGETS)


def test_unknown_target():
    with pytest.raises(ValueError, match=r"target must be one of native, blender, .*got 'unreal'"):
        target("unreal")


def openexr_uv(x, y, z):  # ImfEnvmap.cpp: LatLongMap::latLong, with texel centres
    return 0.5 - np.arctan2(x, z) / (2 * np.pi), 0.5 - np.arcsin(y) / np.pi


def blender_uv(x, y, z):  # direction_to_equirectangular_range, v from the bottom
    return 0.5 - np.arctan2(y, x) / (2 * np.pi), np.arccos(z) / np.pi


def three_uv(x, y, z):  # equirectUv, v from the bottom
    return np.arctan2(z, x) / (2 * np.pi) + 0.5, 1 - (np.arcsin(y) / np.pi + 0.5)


def skylibs_uv(x, y, z):  # world2latlong
    return (1 + np.arctan2(x, -z) / np.pi) / 2, np.arccos(y) / np.pi


FORMULAS = {
    "openexr": openexr_uv, "usd": openexr_uv, "mitsuba": openexr_uv,
    "blender": blender_uv, "three": three_uv, "skylibs": skylibs_uv,
}  # fmt: skip


@pytest.mark.parametrize("name", FORMULAS)
@pytest.mark.parametrize("half", [False, True])
def test_renderers_formula_finds_compass_and_spot_in_the_file(name, half, tmp_path):
    card().save(tmp_path / "card.exr", target=name, half=half, white_luminance=1.0)
    pixels, header = exr.read(tmp_path / "card.exr")
    assert header["skydome:target"] == name

    def seen(toward):
        u, v = FORMULAS[name](*target(name).frame_vectors(toward))
        return pixels[int(v * 64), int(u % 1 * 128)]

    for azimuth, colour in zip((3, 93, 183, 273), COMPASS.values(), strict=True):
        np.testing.assert_allclose(seen(direction(azimuth * deg, 40 * deg)), colour, rtol=1e-3)
    np.testing.assert_allclose(seen(direction(1.0, -0.5)), 0.3, rtol=1e-3)
    assert seen(SPOT)[0] == 1000


@pytest.mark.slow
@pytest.mark.parametrize("name", FORMULAS)
def test_mitsuba_finds_compass_and_spot(name, tmp_path):
    """Our file in Mitsuba's `envmap`. Another renderer's file is read where that renderer's own formula points.

    Mitsuba 3.9.1 spaces rows by H - 1, columns by W: what it blends lies up to half a texel higher or lower than
    the texel centres of the file, and the one-texel spot comes out as .84 of itself.
    """
    mi = pytest.importorskip("mitsuba")
    mi.set_variant("scalar_rgb")
    card().save(tmp_path / "card.exr", target=name, half=False, white_luminance=1.0)
    sky = {"type": "envmap", "filename": str(tmp_path / "card.exr")}
    emitter = mi.load_dict({"type": "scene", "sky": sky}).environment()

    def seen(azimuth, elevation):
        look = target(name).frame_vectors(direction(azimuth * deg, elevation * deg))
        if name != "mitsuba":
            u, v = FORMULAS[name](*look)
            level = np.sin(np.pi * v)
            look = np.array([np.sin(2 * np.pi * u) * level, np.cos(np.pi * v), -np.cos(2 * np.pi * u) * level])
        interaction = mi.SurfaceInteraction3f()
        interaction.wi = mi.Vector3f(*(-look))
        return np.array(emitter.eval(interaction)).ravel()

    for azimuth, colour in zip((3, 93, 183, 273), COMPASS.values(), strict=True):
        np.testing.assert_allclose(seen(azimuth, 40), colour, rtol=1e-3)
    np.testing.assert_allclose(seen(60, -30), 0.3, rtol=1e-3)
    turns, climbs = np.meshgrid(np.arange(0, 360, 2.8125) + 1.40625, np.arange(-88.59375, 90, 2.8125))
    values = [seen(a, e)[0] for a, e in zip(turns.ravel(), climbs.ravel(), strict=True)]
    best = int(np.argmax(values))
    assert abs(turns.ravel()[best] - 250) < 1.5
    assert abs(climbs.ravel()[best] - 30) < 1.5
    assert 800 < values[best] < 1001


@pytest.mark.parametrize("name", ["pbrt", "cube", "fisheye"])
def test_compass_in_other_layouts(name, tmp_path):
    convention = target(name)
    assert type(convention.projection) in (EqualAreaSquare, CubeMap, Fisheye)
    card().save(tmp_path / "card.exr", target=name)
    pixels, header = exr.read(tmp_path / "card.exr")
    assert "envmap" not in header
    for azimuth, colour in zip((3, 93, 183, 273), COMPASS.values(), strict=True):
        row, column, _ = convention.projection.pixels(direction(azimuth * deg, 45 * deg), len(pixels))
        np.testing.assert_allclose(pixels[int(row), int(column)], colour, rtol=1e-3)
    row, column = np.unravel_index(np.argmax(pixels[..., 0]), pixels.shape[:2])
    assert convention.projection.directions(len(pixels))[row, column] @ SPOT > np.cos(3 * deg)


def test_the_command_line_names_every_target():
    from skydome.cli.options import target_help

    names = [convention.name for convention in TARGETS]
    assert re.findall(r"[\w-]+", target_help().split(": ")[1].replace(" or ", ", ")) == names
