"""The physical sky's teacher: closed forms, energy, discrete ordinates; lessons that go on; training that learns."""

from dataclasses import replace

import numpy as np
import pytest

pytest.importorskip("numba")
pytest.importorskip("scipy")

import skydome as sd
from skydome.own_air.all_air.airs import AIRS, batch
from skydome.own_air.all_air.lessons import Lessons, make_lessons
from skydome.own_air.all_air.places import Places, between, sun_along
from skydome.own_air.all_air.shells import PROFILES, Rays
from skydome.own_air.all_air.solver import Solver, scatter_once
from skydome.own_air.all_air.sunlight import Sunlight
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.rest_files import load_rest
from skydome.skies.all_air.single_scattering import lit_rays
from skydome.skies.all_air.taught_air import TAUGHT, Optics, optics

COARSE = Places(14, 15, 30, 9, 8, 14, 24, 10, 8)


@pytest.fixture(scope="module")
def solver():
    return Solver.of(COARSE)


@pytest.fixture(scope="module")
def lessons(solver, tmp_path_factory):
    folder = tmp_path_factory.mktemp("lessons") / "lessons"
    assert make_lessons(folder, 2, places=COARSE) == 2
    return folder


def airs(**numbers):
    """A batch of molecules, and of what else is given."""
    bare = {"molecules": 0.1, "aerosol": 0.0, "stratospheric": 0.0, "absorbers": 0.0}
    whole = bare | {"aerosol_albedo": 1.0, "asymmetry": 0.7, "ground": 0.0} | numbers
    return Optics(**{name: np.broadcast_to(np.asarray(v, float), (AIRS,)).copy() for name, v in whole.items()})


def test_random_airs_are_within_what_is_taught():
    for name, numbers in batch(1, 5)._asdict().items():
        assert TAUGHT[name].low <= numbers.min() <= numbers.max() <= TAUGHT[name].high
    assert np.array_equal(batch(1, 5).ground, batch(1, 5).ground)
    assert not np.array_equal(batch(1, 5).ground, batch(2, 5).ground)


def test_columns_along_rays():
    heights, cosines = np.array([0.0, 0.0, 20_000.0]), np.array([1.0, 0.02, -1.0])
    rays = Rays.of(heights, cosines, 24)
    tables, straight = ColumnTables.of(sd.clear_air()), ColumnTables.of(sd.clear_air(), refractivity=0.0)
    above = np.stack([part.above(0.0) - part.above(100_000.0) for part in PROFILES])
    np.testing.assert_allclose(rays.whole[0], above, rtol=2e-3)
    np.testing.assert_allclose(rays.whole[1][[0, 1, 3, 2]], straight.toward(np.array(0.0), np.array(0.02)), rtol=5e-3)
    eye = Rays.to_the_eye(cosines[1:2], 24)
    np.testing.assert_allclose(eye.column[0, -1, [0, 1, 3, 2]], tables.toward(np.array(0.0), np.array(0.02)), rtol=5e-3)
    np.testing.assert_allclose(rays.whole[2], above - [part.above(20_000.0) for part in PROFILES], atol=2e-3)
    np.testing.assert_allclose((rays.density * rays.step[..., None]).sum(axis=1)[:, 0], rays.whole[:, 0], rtol=5e-3)


@pytest.mark.parametrize("elevation", [50.0, 3.0, -3.0])
def test_light_scattered_once_is_that_of_the_sky(elevation):
    """The compiled points of a ray against the arrays of `PhysicalSky`."""
    cosine, sine, azimuth = 0.3, np.sin(np.radians(elevation)), np.array([0.7])
    rays = Rays.to_the_eye(np.array([cosine]), 200)
    sun = Sunlight.of(rays.height[0], sun_along(rays.arc[0], np.array([sine]), azimuth)[0])
    depth = np.zeros((4, AIRS))
    depth[0], depth[1] = np.linspace(0.05, 0.4, AIRS), 0.1
    found = np.zeros((1, 1, AIRS), np.float32)
    scatter_once(rays, 0, sun, depth, depth[:3] * [[1], [0], [0]], np.ones((1, 1, 3, AIRS)), found)
    view, toward, angle = (np.array(x) for x in (cosine, sine, between(cosine, np.array([sine]), azimuth)[0, 0]))
    peer = lit_rays(ColumnTables.of(sd.clear_air()), view, toward, angle).strengths(
        [depth[0], depth[1], depth[3], depth[2]]
    )
    np.testing.assert_allclose(found[0, 0], peer[0], rtol=0.01)


def test_thin_air(solver):
    """Of depth 0.0001: depth x phase function / cosine of the view; next to nothing more over black ground."""
    air = airs(molecules=1e-4, ground=[0.0, 0.5] * 8)
    sines, view = np.sin(np.radians([40.0, 70.0])), np.array([0.5])
    rest, once = solver.at_ground(solver.solve(air), sines, view, np.array([np.pi / 2]))
    nu = view * sines
    phase = 3 / (16 * np.pi) * (1 + nu**2)
    np.testing.assert_allclose(once[0, :, 0, 0], 1e-4 * phase / view, rtol=0.02)
    assert rest[..., 0::2].max() < 1e-3 * once.min()
    up = 0.5 * sines / np.pi  # radiance of the ground, half of which is scattered down
    np.testing.assert_allclose(rest[0, :, 0, 1], up * 0.5 * 1e-4 / view, rtol=0.1)


def test_energy_over_white_ground(solver):
    """Air that takes nothing: what white ground gets over what black ground gets is 1 over the mean transmittance."""
    air = airs(molecules=np.repeat(np.linspace(0.05, 0.6, 8), 2), ground=[0.0, 1.0] * 8)
    x, w = (np.polynomial.legendre.leggauss(16)[k] / 2 + (0.5, 0)[k] for k in (0, 1))
    azimuths = np.linspace(0, np.pi, 13)
    rest, once = solver.at_ground(solver.solve(air, orders=60, tolerance=1e-3), x, x, azimuths)
    turn = np.where(np.isin(np.arange(13), [0, 12]), 0.5, 1.0) * 2 * np.pi / 12
    got = np.einsum("vspb,v,p->sb", rest + once, x * w, turn)
    got += x[:, None] * np.exp(-air.molecules / x[:, None])
    mean = 2 * np.einsum("sb,s->b", got[:, 0::2], w)
    np.testing.assert_allclose((got[:, 1::2] / got[:, 0::2])[8:] * mean, 1.0, atol=0.02)


def test_by_day_it_is_the_sky_of_discrete_ordinates(solver):
    pytest.importorskip("nanodisort")
    air, sun = sd.clear_air(aerosol_depth=0.15, albedo=0.2), sd.direction(azimuth=0.0, elevation=40 * sd.deg)
    air, w = replace(air, gases=None), np.linspace(400.0, 680.0, AIRS)  # the teacher has none
    cosines, azimuths = np.sin(np.radians([8.0, 20.0, 45.0, 80.0])), np.radians([20.0, 90.0, 180.0])
    rest, once = solver.at_ground(solver.solve(optics(air, w, w)), sun[2:], cosines, azimuths)
    views = sd.direction(*np.meshgrid(azimuths, np.arcsin(cosines)))
    peer = sd.DiscreteOrdinates(sun, air).radiance(views, w) / air.sun_at(w)
    off = (rest + once)[:, 0] / peer - 1
    assert np.sqrt((off**2).mean()) < 0.015
    assert np.abs(off).max() < 0.04


def test_lessons_go_on_where_they_stopped(lessons):
    one, other = sorted(lessons.iterdir())
    whole, stamp = other.read_bytes(), one.stat().st_mtime_ns
    with np.load(other) as stored:
        before = {name: stored[name] for name in stored}
    other.unlink()
    assert make_lessons(lessons, 2, places=COARSE) == 1
    assert make_lessons(lessons, 2, places=COARSE) == 0
    assert one.stat().st_mtime_ns == stamp
    with np.load(other) as stored:
        assert all(np.array_equal(stored[name], before[name]) for name in before)
    assert len(other.read_bytes()) == len(whole)
    assert {path.suffix for path in lessons.iterdir()} == {".npz"}


def test_what_is_no_lesson_is_refused(tmp_path):
    with pytest.raises(ValueError, match="batches must be 1 or more, got 0"):
        make_lessons(tmp_path / "x", 0)
    with pytest.raises(ValueError, match="must hold lessons"):
        Lessons.load(tmp_path)
    (tmp_path / "0001-00000.npz").write_text("nothing")
    with pytest.raises(ValueError, match="damaged or not a file of lessons"):
        Lessons.load(tmp_path)


def test_training_learns(lessons, tmp_path):
    pytest.importorskip("torch")
    from skydome.own_air.all_air.training import DAY, TWILIGHT, rms_error, train_rest

    short = {"mean_shapes": 5, "width": 16}
    few, more = (
        train_rest(
            lessons, tmp_path / f"{steps}.safetensors",
            DAY._replace(steps=steps, shapes=6, **short), TWILIGHT._replace(steps=steps, shapes=6, **short),
        )
        for steps in (10, 400)
    )  # fmt: skip
    assert more["day"] < 0.7 * few["day"]
    assert more["twilight"] < few["twilight"]
    learned = Lessons.load(lessons, DAY.low, DAY.high)
    network = load_rest(tmp_path / "400.safetensors").day
    assert rms_error(network, learned.chosen(learned.held)) == pytest.approx(more["day"], rel=0.1)


@pytest.mark.parametrize("small", [False, True])
def test_one_command_trains_both_networks(lessons, tmp_path, monkeypatch, small):
    pytest.importorskip("torch")
    from typer.testing import CliRunner

    from skydome.cli.main import app
    from skydome.own_air.all_air import training

    for name in ("DAY", "TWILIGHT", "SMALL_DAY", "SMALL_TWILIGHT"):
        course = getattr(training, name)
        monkeypatch.setattr(training, name, course._replace(steps=90, shapes=4, mean_shapes=course.terms // 2))
    output = tmp_path / "own.safetensors"
    given = [
        "train",
        "--model",
        "physical",
        "-o",
        output,
        "--lessons",
        lessons,
        "--batches",
        "2",
        "--seed",
        "1",
        "--json",
    ]
    done = CliRunner().invoke(app, [str(part) for part in given] + ["--small"] * small)
    assert done.exit_code == 0, done.output
    assert '"computed": 0' in done.stdout
    assert load_rest(output).day.shapes.shape == (4 + (3 if small else 6), 32, 7 if small else 13)
    sky = sd.PhysicalSky(sd.direction(azimuth=0.0, elevation=0.5), networks=output)
    assert np.isfinite(sky.radiance(sd.ZENITH, [550.0])).all()


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["simulate", "--for", "cloud"], "--for must be one of formula, physical, overcast, got 'cloud'"),
        (["simulate", "grid.toml", "--for", "physical"], "--for physical draws its airs at random and takes no grid"),
        (["simulate"], "a grid must be named"),
    ],
)
def test_purposes_that_there_are_not(arguments, told):
    import subprocess
    import sys

    done = subprocess.run([sys.executable, "-m", "skydome", *arguments], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (2, "")
    assert told in done.stderr.replace("\n", " ")
    assert len(done.stderr.splitlines()) == 1
