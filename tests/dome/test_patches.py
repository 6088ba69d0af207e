"""Patches: solid angles, order, bounds, means; Radiance's own numbering by its reinhart.cal."""

import subprocess
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.dome.patches import Patches, equal_area, patches, reinhart, tregenza


@pytest.mark.parametrize("name", ["tregenza", "reinhart:3", "equal-area:2", "mf:6"])
def test_solid_angles_and_horizontal_weights_add_up(name):
    sky = patches(name)
    assert np.isclose(sky.solid_angles.sum(), 2 * np.pi, rtol=1e-13)
    assert np.isclose(sky.horizontal_solid_angles.sum(), np.pi, rtol=1e-13)
    assert np.allclose(np.linalg.norm(sky.directions, axis=-1), 1)


@pytest.mark.parametrize("sky", [tregenza(), reinhart(4), equal_area(3)], ids=lambda sky: sky.name)
def test_every_centre_and_sample_lies_in_its_own_patch(sky):
    assert np.array_equal(sky.index(sky.directions), np.arange(sky.count))
    inside, weights = sky.samples(3, 4)
    assert np.array_equal(sky.index(inside), np.repeat(np.arange(sky.count)[:, None], 12, axis=1))
    assert np.allclose(weights.sum(axis=-1), 1)


def test_means_of_samples_are_exact_for_the_sine_of_elevation():
    sky = reinhart(2)
    inside, weights = sky.samples()
    mean = (inside[..., 2] * weights).sum(axis=-1)
    assert np.allclose(mean * sky.solid_angles, sky.horizontal_solid_angles, rtol=1e-12)


def test_tregenza_has_the_published_rows():
    sky = tregenza()
    assert sky.counts.tolist() == [30, 30, 24, 24, 18, 12, 6, 1]  # Tregenza 1987, figure 1
    assert np.allclose(np.degrees(np.unique(sky.elevations)), [6, 18, 30, 42, 54, 66, 78, 90])
    assert np.isclose(sky.solid_angles[0], 2 * np.pi / 30 * np.sin(np.radians(12)))


@pytest.mark.parametrize("division", [1, 4])
def test_numbering_is_that_of_reinhart_cal(division):
    import pyradiance

    folder = Path(pyradiance.__file__).parent
    random = np.random.default_rng(7).normal(size=(400, 3))
    toward = random / np.linalg.norm(random, axis=-1, keepdims=True)
    text = "\n".join(" ".join(map(repr, row)) for row in toward.tolist())
    definitions = [f"MF:{division}", "-f", "reinhart.cal", "-e", "Dx=$1;Dy=$2;Dz=$3;$1=rbin"]
    command = [folder / "bin" / "rcalc", "-e", *definitions]
    environment = {"RAYPATH": str(folder / "lib")}
    answer = subprocess.run(command, input=text, capture_output=True, text=True, env=environment, check=True)
    theirs = np.array(answer.stdout.split(), dtype=float).astype(int)
    assert np.array_equal(reinhart(division).index(toward), theirs - 1)


@pytest.mark.parametrize("name", ["", "tregenza:2", "reinhart:0", "reinhart:13", "reinhart:x", "klems"])
def test_bad_names_tell_what_is_allowed(name):
    with pytest.raises(ValueError, match="patches must be tregenza, reinhart:N or equal-area:N"):
        patches(name)


def test_bad_rows_are_refused():
    with pytest.raises(ValueError, match="edges must rise"):
        Patches("mine", np.array([0.0, 1.0]), np.array([1]))


def test_a_uniform_sky_has_uniform_means():
    inside, weights = tregenza().samples()
    assert np.allclose((sd.Uniform(2.0).luminance(inside) * weights).sum(axis=-1), 2.0)
