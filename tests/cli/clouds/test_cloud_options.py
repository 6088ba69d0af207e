"""--clouds, --cover and --seed: what they make, and what is refused in one line."""

import numpy as np
import pytest

import skydome as sd
from skydome.cli.clouds.scene import field_of
from skydome.cli.options import SkyOptions
from skydome.cli.scene import scene_of

pytest.importorskip("numba")
SUN = ("--sun", "200,40")
MEASURED = (*SUN, "--clouds", "cumulus")


def test_the_clouds_are_those_asked_for():
    scene = scene_of(SkyOptions(sun="200,40", clouds="altocumulus", cover=0.3, cloud_seed=2))
    assert (type(scene.clouds.field.kind), scene.clouds.field.cover, scene.clouds.field.seed) == (
        sd.Altocumulus,
        0.3,
        2,
    )
    assert any("clouds: altocumulus, cover 0.30" in note for note in scene.notes)
    assert type(scene.sky) is sd.CloudySky
    assert scene_of(SkyOptions(sun="200,40", clouds="cirrus", cover=0.0, no_sun=True)).disc is None


def test_cirrus_may_have_a_halo():
    plane = SkyOptions(clouds="cirrus", kind="hexagonal", base=8000.0, set=["smooth=0.5", "effective_radius=80e-6"])
    cirrus = sd.Cirrus(sd.HexagonalIce(smooth=0.5), effective_radius=80e-6)
    assert field_of(plane) == sd.CloudField(cirrus, base=8000.0)
    assert field_of(SkyOptions(clouds="cumulus", kind="ice")).kind == sd.Cumulus(sd.Ice())


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ((*SUN, "--clouds", "cumulus", "--cover", 2), "cover must lie in [0, 1], got 2"),
        ((*SUN, "--clouds", "fog"), "--clouds must be one of cumulus, stratocumulus, altocumulus, cirrus, got 'fog'"),
        ((*SUN, "--clouds", "cumulus", "--seed", -1), "seed must"),
        ((*SUN, "--cover", 0.4), "--cover is of clouds: give --clouds too"),
        ((*SUN, "--seed", 3), "--seed is of clouds: give --clouds too"),
        ((*SUN, "--clouds", "cumulus", "--model", "preetham"), "--clouds stand in the physical sky"),
        ((*MEASURED, "--dni", 400), "need both --dni and --dhi"),
        ((*MEASURED, "--dni", 400, "--dhi", 200, "--cover", 0.4), "--cover is found from --dni and --dhi"),
        ((*MEASURED, "--dni", 400, "--dhi", 200, "--turbidity", 4), "--turbidity is found from --dni and --dhi"),
        ((*MEASURED, "--set", "base=20"), "base must lie in [50, 20000] m, got 20"),
        ((*MEASURED, "--set", "glow=2"), "physical has no parameter for --set, got 'glow'"),
        ((*MEASURED, "--dni", 1500, "--dhi", 100), "dni must lie in [0, 136"),
        ((*MEASURED, "--dni", 0, "--dhi", 0), "dhi must be 1 W m-2 or more"),
        ((*MEASURED, "--dni", 1200, "--dhi", 50), "through the clearest air here, got 1200"),
        (("--sun", "200,0.3", "--clouds", "cumulus", "--dni", 10, "--dhi", 5), "0.5 degrees above the horizon"),
        (("--clouds", "cumulus"), "the sun must be given"),
        ((*MEASURED, "--cloud-kind", "snow"), "--cloud-kind must be one of water, ice, hexagonal, got 'snow'"),
        ((*MEASURED, "--set", "smooth=0.5"), "--set smooth is of hexagonal ice: give --cloud-kind hexagonal too"),
        ((*MEASURED, "--cloud-kind", "hexagonal", "--set", "aspect=9"), "aspect must lie in [0.2, 5], got 9"),
        ((*MEASURED, "--set", "effective_radius=1e-4"), "effective_radius must lie in [4e-06, 2.5e-05] m"),
        ((*MEASURED, "--cloud-base", 900, "--set", "base=800"), "is the other way to say --cloud-base"),
        ((*SUN, "--cloud-kind", "ice"), "physical takes no --cloud-kind"),
        ((*SUN, "--model", "overcast", "--cloud-kind", "hexagonal"), "(--clouds cirrus --cloud-kind hexagonal)"),
    ],
)
def test_bad_options_are_one_line(refused, tmp_path, options, told):
    assert told in refused("render", *options, "--height", 16, "-o", tmp_path / "none.exr")


def test_a_shader_has_no_clouds(refused, tmp_path):
    asked = ("shader", *SUN, "--model", "physical", "--clouds", "cumulus", "-o", tmp_path / "sky.glsl")
    assert "--clouds have no shader of their own: give --basis" in refused(*asked)


def test_what_measured_light_was_made_of_is_told():
    scene = scene_of(
        SkyOptions(
            sun="200,40",
            clouds="stratocumulus",
            set=["base=600", "thickness=300"],
            direct_normal_irradiance=0.0,
            diffuse_horizontal_irradiance=150.0,
        )
    )
    air = scene.sky.members[0].clear.atmosphere
    haze = sum(part.optical_depth for part in air.constituents if isinstance(part, sd.Aerosol))
    assert [note for note in scene.notes if note.startswith("air:")] == [
        f"air: found for that light, an aerosol depth of {haze:.3f} at 550 nm, ozone 330 DU"
    ]
    assert (scene.clouds.field.base, scene.clouds.field.top) == (600.0, 900.0)


def test_land_lies_in_the_air_that_was_found(call, tmp_path):
    np.savez(tmp_path / "land.npz", elevation=np.zeros((8, 8)), dx=1e-3, dy=1e-3, xmin=7.0, ymin=45.0)
    asked = ("terrain", tmp_path / "land.npz", *MEASURED, "--dni", 400, "--dhi", 200, "--camera", "0,0,90")
    shown = call(*asked, "--size", "4,2", "-o", tmp_path / "view.png")
    assert shown.exit_code == 0, shown.stderr
    assert "an aerosol depth of 0.1" in shown.stdout


@pytest.mark.parametrize("command", ["daylight", "glare", "year", "explore", "sun", "convert"])
def test_commands_without_clouds_refuse_them(call, command):
    shown = call(command, "--clouds", "cumulus")
    assert shown.exit_code == 2
    assert "Traceback" not in shown.output


def test_clouds_without_a_word_are_heaps(call):
    named, alone = (call("light", "--sun", "200,40", "--clouds", *word, "--cover", 0.3) for word in (["cumulus"], []))
    assert alone.exit_code == 0, alone.stderr
    assert alone.stdout == named.stdout
