"""The overcast sky's network made anew by its two commands: lessons go on where they were stopped, the sky takes it."""

import json

import numpy as np
import pytest
from typer.testing import CliRunner

import skydome as sd
from skydome.cli.main import app
from skydome.own_air.clouds import lessons, training


def command(*arguments: object) -> dict[str, float]:
    done = CliRunner().invoke(app, [str(part) for part in (*arguments, "--json")])
    assert done.exit_code == 0, done.output
    found: dict[str, float] = json.loads(done.stdout)
    return found


class KilledError(Exception):
    """What ends the first run."""


def killed_after_one(done: int, *_: object) -> None:
    if done == 1:
        raise KilledError


def test_lessons_and_training_by_the_command_line(tmp_path, monkeypatch):
    pytest.importorskip("torch")
    monkeypatch.setattr(lessons, "CASES", 8)
    course = training.OVERCAST._replace(steps=120, shapes=4, mean_shapes=3, width=8, terms=5)
    monkeypatch.setattr(training, "OVERCAST", course)
    monkeypatch.setattr(training, "POLISHING", 4)
    folder, output = tmp_path / "mine.lessons", tmp_path / "mine.safetensors"
    with pytest.raises(KilledError):
        lessons.make_overcast_lessons(folder, 3, 5, killed_after_one)
    first = {path: path.read_bytes() for path in folder.iterdir()}
    assert len(first) == 1
    asked = ("--batches", 3, "--seed", 5)
    assert command("simulate", "--for", "overcast", "-o", folder, *asked)["computed"] == 2
    assert all(path.read_bytes() == text for path, text in first.items())
    made = command("train", "--model", "overcast", "-o", output, *asked)
    assert made["computed"] == 0
    assert made["bytes"] == output.stat().st_size
    assert 0 < made["rms_error"] < 1
    again = tmp_path / "again.safetensors"
    command("train", "--model", "overcast", "-o", again, "--lessons", folder, *asked)
    assert again.read_bytes() == output.read_bytes()
    light = sd.OvercastSky(sd.direction(0.0, 0.7), 20.0, network=output).radiance(sd.ZENITH, [450.0, 650.0])
    truth = sd.OvercastSky(sd.direction(0.0, 0.7), 20.0).radiance(sd.ZENITH, [450.0, 650.0])
    assert np.all(np.abs(np.log(light / truth)) < 1)
