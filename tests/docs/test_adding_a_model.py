"""A model is one file and one row: the page's own, put into a copy of the package, is then in every command."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from tests.docs.test_docs import ROOT, blocks

import skydome

FITTED = """
import numpy as np, skydome as sd
from skydome.skies.soft_glow import SoftGlow
from skydome.training.lessons import published_lesson, teacher_named
from skydome.evaluation.measured_sky import MeasuredSky
from skydome.evaluation.runs import evaluated
from skydome.ground.quadrature import hemisphere

sun = sd.direction(azimuth=2.0, elevation=0.6)
views = hemisphere(12, 24)[0]
found = sd.fit(SoftGlow, views, SoftGlow(sun, 3.5, 11.0).luminance(views)).sky
print(found.turbidity, found.glow, float(sd.angle_between(found.sun, sun)))
print(*published_lesson(teacher_named("soft-glow"), 0).light.shape)
times, w = ("2013-05-27T09:30:00", "2013-05-27T10:30:00"), np.arange(380.0, 721.0, 5)
light = SoftGlow(sun, 3.5, 11.0).radiance(views, w)
both = [np.stack([part, part]) for part in (sun, views, light, np.ones(len(views), bool), sd.angle_between(views, sun))]
suns, toward, radiance, valid, angle = both
measured = MeasuredSky(times, np.array([t + "-04:00" for t in times]), suns, toward, w, radiance, valid, angle)
run = evaluated(measured, ["soft-glow"], "all")[0]
print(run.numbers["turbidity"], run.numbers["glow"])
"""


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """Python in a folder whose skydome has the page's file and row."""
    place = tmp_path_factory.mktemp("package")
    here = Path(skydome.__file__).parent
    # With what is compiled already, but for files that another worker is writing.
    shutil.copytree(here, place / "skydome", ignore=shutil.ignore_patterns("*.tmp*", "*.pyc.*"))
    file, row = [code for _, code in blocks(ROOT / "docs" / "adding-a-model.md", "python")][:2]
    (place / "skydome" / "skies" / "soft_glow.py").write_text(file)
    catalogue = place / "skydome" / "skies" / "catalogue.py"
    head, rest = catalogue.read_text().split("CATALOGUE: tuple[Model, ...] = (\n")
    row = row[row.index("Model(") :].rstrip() + ","
    head = head.replace("import Preetham\n", "import Preetham\nfrom skydome.skies.soft_glow import SoftGlow\n")
    catalogue.write_text(f"{head}CATALOGUE: tuple[Model, ...] = (\n{row}\n{rest}")
    environment = os.environ | {"PYTHONPATH": str(place), "COLUMNS": "200"}

    def called(*arguments):
        command = [sys.executable, *arguments]
        return subprocess.run(command, cwd=place, env=environment, capture_output=True, text=True, check=False)

    return called


@pytest.fixture
def facts(run):
    """What a command says with --json."""

    def said(*arguments):
        done = run("-m", "skydome", *arguments, "--json")
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)

    return said


GLOW = ("--sun", "180,40", "--model", "soft-glow")


def test_the_list_tells_it(facts):
    told = next(entry for entry in facts("models") if entry["name"] == "soft-glow")
    assert told["rung"] == "spectral"
    assert told["source"] == "an example"
    assert {"range": [0.0, 20.0], "default": 8.0}.items() <= {p["name"]: p for p in told["parameters"]}["glow"].items()


def test_light_and_its_own_parameter(facts, run):
    level = 1000 * ((1.376 * 2.5 - 1.81) * 0.8390996 + 0.38)  # Karayel's formula at 40 degrees
    plain, glowing = (facts("light", *GLOW, "--turbidity", "2.5", *more) for more in ((), ("--set", "glow=12")))
    assert plain["zenith_luminance_cd_m2"] == pytest.approx(level, rel=1e-6)
    assert glowing["illuminance_lx"]["diffuse"] != plain["illuminance_lx"]["diffuse"]
    assert plain["illuminance_lx"]["direct"] > 50000  # the disc of its turbidity
    refused = {
        "glow=30": "glow must lie in [0, 20], got 30",
        "gleam=1": "--set must name one of glow",
        "turbidity=3": "--set must name one of glow",
        "glow": "--set glow must be a number",
    }
    for wrong, said in refused.items():
        done = run("-m", "skydome", "light", *GLOW, "--set", wrong)
        assert (done.returncode, said in done.stderr) == (2, True), done.stderr


def test_maps_plots_shaders_and_planes(facts, run, tmp_path):
    sky, plot = tmp_path / "sky.exr", tmp_path / "sky.png"
    assert facts("render", *GLOW, "--height", "64", "-o", str(sky))["parameters"]["members"][0]["model"] == "SoftGlow"
    assert sky.stat().st_size > 1000
    assert run("-m", "skydome", "plot", *GLOW, "-o", str(plot)).returncode == 0
    assert plot.stat().st_size > 1000
    assert "fn skydome_rgb" in facts("shader", *GLOW, "--lang", "wgsl")["source"]
    assert facts("illuminance", *GLOW, "--plane", "45,180")


def test_a_coloured_year(run, tmp_path):
    pytest.importorskip("xarray")
    head = "place Here\nlatitude 45\nlongitude -8\ntime_zone -15\nsite_elevation 200\nweather_data_file_units 1\n"
    rows = "".join(f"6 21 {h}.5 {max(0, 700 - 60 * abs(h - 12))} {max(0, 150 - 10 * abs(h - 12))}\n" for h in range(24))
    weather = tmp_path / "day.wea"
    weather.write_text(head + rows)
    done = run("-m", "skydome", "year", str(weather), "--colour", "soft-glow", "-o", str(tmp_path / "day.nc"))
    assert done.returncode == 0, done.stderr
    done = run("-m", "skydome", "year", str(weather), "--colour", "perez", "-o", str(tmp_path / "no.nc"))
    assert "colour must be one of soft-glow, physical, hosek-wilkie, preetham, got 'perez'" in done.stderr


def test_it_is_fitted_taught_and_evaluated(run):
    pytest.importorskip("scipy")
    done = run("-c", FITTED)
    assert done.returncode == 0, done.stderr
    fit, lesson, evaluation = ([float(part) for part in line.split()] for line in done.stdout.splitlines())
    assert fit == pytest.approx([3.5, 11.0, 0.0], abs=1e-3)
    assert lesson == [100, 200, 3]  # turbidities 2-6 with 20 suns, RGB
    assert evaluation == pytest.approx([3.5, 11.0], rel=0.02)
