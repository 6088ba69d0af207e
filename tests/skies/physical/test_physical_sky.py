"""The default physical sky, physical skies held for maps, and both in the command line."""

import json

import numpy as np
import pytest
from typer.testing import CliRunner

import skydome as sd
from skydome.air.atmosphere import PREETHAM_HAZE, Atmosphere
from skydome.cli.main import app
from skydome.ground.quadrature import hemisphere
from skydome.skies.physical.held import held

pytest.importorskip("nanodisort")
pytest.importorskip("numba")
VIEWS = hemisphere(11, 14)[0]


def sun_at(elevation):
    return sd.direction(2.1, elevation * sd.deg)


@pytest.mark.parametrize(("elevation", "kind"), [(60, "DiscreteOrdinates"), (5, "DiscreteOrdinates")])
def test_high_suns_have_discrete_ordinates(elevation, kind):
    air = Atmosphere.standard(0.05)
    sky = sd.physical_sky(sun_at(elevation), air)
    assert type(sky).__name__ == kind
    assert sky.atmosphere is air


@pytest.mark.parametrize("elevation", [4.9, 0.0, -6.0])
def test_low_suns_are_path_traced(elevation):
    sky = sd.physical_sky(sun_at(elevation), relative_error=0.03)
    assert type(sky).__name__ == "PathTraced"
    assert sky.relative_error == 0.03


def test_many_suns_must_all_be_high():
    suns = sun_at(np.array([10.0, 60.0]))[:, None]
    assert sd.physical_sky(suns).radiance(VIEWS, [550.0]).shape == (2, len(VIEWS), 1)
    with pytest.raises(ValueError, match=r"5 degrees or more, got one at 2\.00"):
        sd.physical_sky(sun_at(np.array([2.0, 60.0]))[:, None])


@pytest.mark.parametrize("elevation", [5.0, 7.0, 10.0, 15.0])
def test_how_far_the_methods_differ_near_where_they_meet(elevation):
    """A percent at every sun (docs/models/physical.md): the sun's rays and what they scatter first see round air."""
    views = VIEWS[VIEWS[:, 2] > np.sin(np.radians(5))][::8]
    traced = sd.PathTraced(sun_at(elevation)).job(views, [550.0]).start().until(0.01).radiance
    ratio = sd.physical_sky(sun_at(elevation)).radiance(views, [550.0]) / traced
    assert abs(ratio.mean() - 1) < 0.015
    assert np.sqrt(((ratio - 1) ** 2).mean()) < 0.03


@pytest.mark.parametrize("kind", ["DiscreteOrdinates", "Nishita93", "Nishita96"])
@pytest.mark.parametrize("elevation", [6.0, 45.0])
def test_a_held_sky_is_the_sky(kind, elevation):
    sky = getattr(sd, kind)(sun_at(elevation))
    np.testing.assert_allclose(held(sky).xyz(VIEWS), sky.xyz(VIEWS), rtol=5e-3)


def test_a_held_sky_in_twilight_and_below_the_horizon():
    sky = held(sd.Nishita96(sun_at(-3.0)))
    expected = sky.sky.xyz(VIEWS)[:, 1]
    found = sky.luminance(VIEWS)
    assert np.abs(found - expected).max() < 0.03 * expected.max()
    assert (sky.xyz(-VIEWS) == 0).all()
    assert sky.direct_normal_illuminance == 0
    assert sky.valid


@pytest.mark.parametrize(
    "air", [Atmosphere.from_turbidity(4.0, PREETHAM_HAZE), Atmosphere.mars()], ids=["haze", "mars"]
)
@pytest.mark.parametrize("elevation", [6.0, 45.0])
def test_a_held_sky_whose_phase_functions_change_with_wavelength(air, elevation):
    sky = sd.Nishita93(sun_at(elevation), air)
    np.testing.assert_allclose(held(sky).xyz(VIEWS), sky.xyz(VIEWS), rtol=5e-3)


def test_a_held_sky_refuses_what_it_cannot_hold():
    with pytest.raises(ValueError, match="one sun"):
        held(sd.Nishita93(sun_at(np.array([10.0, 20.0]))))


def facts(*arguments):
    result = CliRunner().invoke(app, [*map(str, arguments), "--json"])
    assert result.exit_code == 0, result.output
    return json.loads(result.stdout)


@pytest.mark.parametrize("name", ["discrete-ordinates", "nishita-1993", "nishita-1996"])
def test_light_by_name(name):
    told = facts("light", "--sun", "180,40", "--model", name, "--turbidity", 2.5)
    assert 8000 < told["illuminance_lx"]["diffuse"] < 20000
    assert 50000 < told["illuminance_lx"]["direct"] < 75000
    assert any("turbidity 2.5" in note for note in told["notes"])


def test_path_traced_by_name_until_an_error_or_a_count():
    command = ("light", "--sun", "180,40", "--model", "path-traced")
    few, many = facts(*command, "--paths", 16), facts(*command, "--until", "3%", "--paths", 64)
    ordinates = facts("light", "--sun", "180,40", "--model", "discrete-ordinates")
    for told, limit in ((few, 0.03), (many, 0.02)):
        assert told["illuminance_lx"]["diffuse"] == pytest.approx(ordinates["illuminance_lx"]["diffuse"], rel=limit)
        assert told["illuminance_lx"]["direct"] == pytest.approx(ordinates["illuminance_lx"]["direct"], rel=1e-9)


def test_twilight_by_name_and_a_map(tmp_path):
    told = facts("light", "--sun", "270,-3", "--model", "path-traced", "--paths", 16)
    assert told["valid"]
    assert 5 < told["illuminance_lx"]["diffuse"] < 300
    assert told["illuminance_lx"]["direct"] == 0
    path = tmp_path / "sky.exr"
    facts("render", "--sun", "180,40", "--model", "discrete-ordinates", "-o", path, "--height", 64)
    assert path.stat().st_size > 1000


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--model", "path-traced", "--until", "0"), "--until must be an error in (0, 50%]"),
        (("--model", "path-traced", "--paths", "3"), "skydome: paths must be 16 or more, got 3"),
        (("--model", "nishita-1996", "--paths", "30"), "nishita-1996 takes no --paths"),
        (("--model", "discrete-ordinates", "--turbidity", "0.5"), "turbidity must lie in [1, 64], got 0.5"),
        (("--model", "discrete-ordinates", "--albedo", "2"), "albedo must lie in [0, 1], got 2"),
    ],
)
def test_what_cannot_be_is_refused_in_one_line(arguments, said):
    result = CliRunner().invoke(app, ["light", "--sun", "180,40", *arguments])
    assert result.exit_code == 2
    assert said in result.stderr
    assert result.stderr.count("\n") == 1
