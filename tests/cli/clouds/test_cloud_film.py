"""`skydome animate --weather`: every frame has a row's light, by clouds that have it or the nearest ones."""

import json
from dataclasses import dataclass

import numpy as np
import pytest

import skydome as sd
from skydome.cli.clouds import film as films
from skydome.cli.clouds.film import LightOrder, light_film
from skydome.cli.clouds.kinds import kind_named

pytest.importorskip("numba")
TAPE = """place Turin
latitude 45.07
longitude -7.69
time_zone -15
site_elevation 240
weather_data_file_units 1
6 20 12.500 800 100
6 21 3.500 0 0
6 21 4.500 150 2
6 21 12.500 860 120
6 21 23.500 0 0
"""


@dataclass(frozen=True)
class Coarse(sd.Cumulus):
    """Cumulus of few places, so that a try costs little."""

    count, levels = 64, 16


@pytest.fixture(autouse=True)
def coarse(monkeypatch):
    """Cumulus by name is the coarse one: what a film does is the same."""
    monkeypatch.setattr(films, "kind_named", lambda name, *of: Coarse() if name == "cumulus" else kind_named(name, *of))


@pytest.fixture
def tape(tmp_path):
    path = tmp_path / "two.wea"
    path.write_text(TAPE)
    return path


def test_frames_of_a_day_are_taken_up_again(call, tape, tmp_path):
    film = ("animate", "--weather", tape, "--date", "2026-06-21", "--clouds", "cumulus", "--height", "16", "--json")
    shown = call(*film, "-o", tmp_path / "frames")
    facts = json.loads(shown.stdout)
    assert facts["made"] == ["sky.0001.exr", "sky.0002.exr"]
    told = [line for line in shown.stderr.splitlines() if "nearest clouds" in line]
    assert len(told) == 1
    assert "150 direct, 2 W m-2 diffuse: the direct light times" in told[0]
    record = json.loads((tmp_path / "frames" / "sky.frames.json").read_text())["frames"]
    assert [frame["light"]["dhi"] for frame in record.values()] == [2.0, 120.0]
    again = json.loads(call(*film, "-o", tmp_path / "frames").stdout)
    assert again["made"] == []
    tape.write_text(TAPE.replace("860", "850"))
    orders = light_film(tape, "2026-06-21", "cumulus", 0, tmp_path / "frames", 16, None)
    assert orders.done() == {}


def test_a_frame_has_the_light_of_its_row(tape, tmp_path):
    order = list(light_film(tape, "2026-06-21", "cumulus", 0, tmp_path, 16, None))[1]
    assert isinstance(order, LightOrder)
    light = sd.broadband(order.scene().whole)
    assert light.direct_normal == pytest.approx(860, rel=0.01)
    assert light.diffuse_horizontal == pytest.approx(120, rel=0.01)


def test_steps_between_rows_keep_the_energy_of_each(tape, tmp_path):
    film = light_film(tape, "2026-06-21", "cumulus", 0, tmp_path, 16, None, "5min")
    noon = [order.light.dni for order in film if order.options.time.startswith("2023-06-21T12:")]
    assert len(noon) == 12
    assert np.mean(noon) == pytest.approx(860, rel=0.01)
    assert film.day.start.wind == (6.0, 2.0)


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("--date", "2026-06-21"), "--clouds cumulus"),
        (("--date", "2026-06-21", "--clouds", "fog"), "cumulus, stratocumulus, altocumulus, cirrus, got 'fog'"),
        (("--date", "2026-12-21", "--clouds", "cirrus"), "no row with light on 21 December"),
        (("--date", "noon", "--clouds", "cirrus"), "--date must be a day such as 2026-06-21, got 'noon'"),
        (("--clouds", "cirrus"), "give --date and --clouds"),
        (("--date", "2026-06-21", "--clouds", "cirrus", "--step", "soon"), "--step must be a length of time"),
        (("--date", "2026-06-21", "--clouds", "cirrus", "--wind", "west"), "--wind"),
        (("--date", "2026-06-21", "--clouds", "cirrus", "--wind", "900,0"), "wind must lie in [-200, 200] m s-1"),
    ],
)
def test_films_that_cannot_be(refused, tape, tmp_path, arguments, told):
    assert told in refused("animate", "--weather", tape, *arguments, "-o", tmp_path / "none")
