"""`skydome train` on a day: k-fold by whole captures, maps in every layout, a scanner's luminance; what is refused."""

import json

import numpy as np
import pytest
from typer.testing import CliRunner

import skydome as sd
from skydome import deg
from skydome.captures import capture_training
from skydome.captures.capture import Capture
from skydome.captures.capture_training import DAY_RECIPES, scans_of
from skydome.captures.capture_validation import leave_one_out, ring_weights, validated_by_folds
from skydome.captures.interpolation import FADES
from skydome.captures.luminance_scans import read_luminance_scans
from skydome.captures.scans import Scan
from skydome.cli.main import app
from skydome.skies.neural.network import RationalOutput
from skydome.training.halving import Halving
from skydome.training.losses import TargetLoss
from skydome.training.method import TrainingRecipe

QUICK = TrainingRecipe(starts=4, start_steps=8, rounds=((2, 15),), steps=0, method=Halving())
ELEVATIONS = (15, 25, 35, 45, 55)


def scans(models=ELEVATIONS):
    views = np.concatenate([sd.direction(np.arange(12) * 30 * deg, np.full(12, e * deg)) for e in (10, 30, 50, 70)])
    day = []
    for k, height in enumerate(models):
        sky = sd.HosekWilkie(sd.direction((140 + 10 * k) * deg, height * deg), 3.0)
        day.append(Scan(views, np.broadcast_to(sky.sun, views.shape), sky.rgb(views), 900.0 * k))
    return day


def call(*words):
    return CliRunner().invoke(app, [str(word) for word in words])


def test_the_published_recipe_is_the_papers_own_output_and_loss():
    recipe = DAY_RECIPES["published"]
    assert isinstance(recipe.output, RationalOutput)
    assert isinstance(recipe.loss, TargetLoss)
    assert recipe.bytes == 492


def test_rings_share_the_sky():
    views = scans()[0].directions
    weights = ring_weights(views)
    assert weights.sum() == pytest.approx(2 * np.pi)
    assert (weights * views[:, 2]).sum() == pytest.approx(np.pi, rel=0.02)  # a uniform sky's illuminance


def test_a_fold_is_not_seen():
    """The sky held out is another one in the middle of the day: its own network errs, the others do not see it."""
    day = scans()
    odd = [Scan(s.directions, s.suns, s.light * (3.0 if k == 2 else 1.0), s.time) for k, s in enumerate(day)]
    even, wrong = validated_by_folds(day, recipe=QUICK), validated_by_folds(odd, recipe=QUICK)
    assert even.relative < 0.25
    assert even.irradiance_of_means <= even.irradiance < 0.15
    assert wrong.scans[2].learned == pytest.approx(wrong.scans[2].illuminance / 3, rel=0.2)
    halves = validated_by_folds(day, recipe=QUICK, folds=2)
    assert len(halves.scans) == 5
    with pytest.raises(ValueError, match=r"folds must be from 2 to the 5 captures"):
        validated_by_folds(day, folds=6)


def test_scans_of_maps_have_times_and_scans_without_are_refused(monkeypatch):
    times = ("2026-06-21T08:00Z", "2026-06-21T09:00Z")
    suns = [sd.sun_direction(sd.Place(45.07, 7.69), t) for t in times]
    day = [Capture.of(sd.render(sd.HosekWilkie(s, 3.0), 32), sun=s, time=t) for s, t in zip(suns, times, strict=True)]
    assert [scan.time for scan in scans_of(day)] == [0.0, 3600.0]
    with pytest.raises(ValueError, match="times of scans must grow"):
        leave_one_out([Scan(s.directions, s.suns, s.light, 0.0) for s in scans()], FADES)


def luminance_file(path, day):
    with open(path, "w") as file:
        file.write("time,azimuth,elevation,luminance,sun_azimuth,sun_elevation\n")
        for scan in day:
            y = scan.light @ sd.SRGB.to_xyz[1]
            around, height = np.degrees(sd.azimuth(scan.directions)), np.degrees(sd.elevation(scan.directions))
            sun = np.degrees(sd.azimuth(scan.sun)), np.degrees(sd.elevation(scan.sun))
            for values in zip(around, height, y, strict=True):
                file.write(f"{scan.time:g},{','.join(f'{v:.6f}' for v in (*values, *sun))}\n")
    return path


def test_a_scanners_luminance_is_learned(tmp_path, monkeypatch):
    path = luminance_file(tmp_path / "scans.csv", scans())
    read = read_luminance_scans(path)
    np.testing.assert_allclose(read[1].directions, scans()[1].directions, atol=1e-7)
    assert [scan.time for scan in read] == [scan.time for scan in scans()]
    monkeypatch.setitem(capture_training.DAY_RECIPES, "published", QUICK)
    done = call("train", "--measured", path, "--validate", "-o", tmp_path / "net.safetensors", "--json")
    assert done.exit_code == 0, done.stderr
    facts = json.loads(done.stdout)
    assert facts["held_out"]["folds"] == len(facts["held_out"]["by_capture"]) == 5
    assert facts["held_out"]["irradiance"] < 0.15
    sky = sd.NeuralSky.load(tmp_path / "net.safetensors", read[2].sun)
    wanted = float(sd.HosekWilkie(read[2].sun, 3.0).luminance(sd.ZENITH))
    assert float(sky.luminance(sd.ZENITH)) == pytest.approx(wanted, rel=0.2)


@pytest.mark.parametrize("layout", ["angular", "cube"])
def test_a_folder_of_maps_is_learned(layout, tmp_path, monkeypatch):
    monkeypatch.setitem(capture_training.DAY_RECIPES, "published", QUICK)
    for k, height in enumerate((20, 35, 50)):
        sky = sd.HosekWilkie(sd.direction((150 + 15 * k) * deg, height * deg), 3.0)
        picture = sd.render(sky + sd.SunDisc.of(sky), 192, projection=sd.target(layout).projection)
        sd.EnvironmentMap(picture.pixels, picture.projection).save(tmp_path / f"{k}.exr")
    words = ("train", "--captures", tmp_path, "--layout", layout, "--validate", "-o", tmp_path / "n.safetensors")
    facts = json.loads(call(*words, "--json").stdout)
    assert facts["captures"] == ["0.exr", "1.exr", "2.exr"]
    assert len(facts["held_out"]["by_capture"]) == 3
    assert facts["learned"]["irradiance"] < 0.15


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--validate",), "goes with --captures or --measured"),
        (("--measured", "a.nc", "--captures", "b"), "give one of them"),
        (("--measured", "a.nc", "--resume"), "learned in seconds"),
        (("--measured", "a.nc", "--folds", "3"), "belongs to --validate"),
        (("--measured", "a.nc", "--recipe", "deep"), "one of published, maps"),
        (("--measured", "bad.csv"), "missing: luminance"),
        (("--measured", "worse.csv"), "elevation in line 2 of worse.csv"),
    ],
)
def test_what_does_not_go_together(words, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bad.csv").write_text("time,azimuth,elevation,sun_azimuth,sun_elevation\n0,0,0,0,0\n")
    (tmp_path / "worse.csv").write_text("time,azimuth,elevation,luminance,sun_azimuth,sun_elevation\n0,0,100,1,0,9\n")
    done = call("train", *words, "-o", tmp_path / "n.safetensors")
    assert done.exit_code == 2
    assert message in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1
