"""Minutes made of hours: the hours' energy is kept, they swing as measured minutes do, and the seed tells all."""

import json
from dataclasses import replace

import numpy as np
import pytest
from typer.testing import CliRunner

import skydome as sd
from skydome.cli.main import app
from skydome.years.downscaling.series import clear_indices
from skydome.years.downscaling.skartveit_olseth import CLASSES
from skydome.years.quality.checks import Looked
from skydome.years.quality.clear_sky import ineichen
from skydome.years.quality.report import monthly_turbidity
from skydome.years.weather.reading import read_weather

PAYERNE = {1: (0.067, 0.142, 0.249), 5: (0.064, 0.132, 0.211)}
"""Standard deviation of the clear-sky index within the hour, for hours of index below 0.3, 0.6, 0.9, of minutes and of
5 minutes, sun above 15 degrees: measured at Payerne in June 2016 (BSRN; `benchmarks/minutes.py`)."""


def on_level(weather):
    """Direct and diffuse light on the horizontal, as years of skies count them, W m-2."""
    direct, diffuse = weather.irradiances
    return direct * np.maximum(Looked.at(weather).sun.directions[:, 2], 0), diffuse


@pytest.fixture(scope="module")
def made(greensboro):
    """The year in steps of 1 and of 5 minutes."""
    return {step: sd.downscaled(greensboro, minutes=step, seed=7) for step in (1, 5)}


@pytest.mark.parametrize("step", [1, 5])
def test_every_hour_keeps_its_energy(greensboro, made, step):
    fine = made[step]
    hourly, short = on_level(greensboro), on_level(fine)
    beam, sky = (light.reshape(-1, 60 // step).mean(axis=1) for light in short)
    np.testing.assert_allclose(beam + sky, sum(hourly), rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(fine.global_horizontal, sum(short), rtol=1e-12)
    apart = np.abs(sky - hourly[1]) > 1e-6
    assert apart.mean() < 0.005
    assert (sky - hourly[1])[apart].min() > 0  # what clean air does not let through is diffuse
    assert sky.sum() == pytest.approx(hourly[1].sum(), rel=3e-4)
    assert fine.direct_normal.sum() * step / 60 == pytest.approx(greensboro.direct_normal.sum(), rel=0.02)
    assert (fine.diffuse_horizontal >= 0).all()


def test_the_seed_tells_all(greensboro, made):
    day = greensboro.rows(slice(4008, 4104))
    first, again, other = (sd.downscaled(day, 5, seed) for seed in (3, 3, 4))
    np.testing.assert_array_equal(first.direct_normal, again.direct_normal)
    assert np.abs(first.direct_normal - other.direct_normal).max() > 50
    of_minutes = made[1].diffuse_horizontal.reshape(-1, 5).mean(axis=1)
    np.testing.assert_allclose(of_minutes, made[5].diffuse_horizontal, atol=2.0)


@pytest.mark.parametrize("step", [1, 5])
def test_hours_swing_as_measured_ones(greensboro, made, step):
    fine = made[step]
    looked = Looked.at(fine)
    linke = monthly_turbidity(Looked.at(greensboro))[np.arange(fine.count) * 12 // fine.count]
    clear = ineichen(looked.zenith, looked.extraterrestrial, fine.place.altitude, linke).global_horizontal
    high = looked.cosine > 0.26
    index = np.where(high, fine.global_horizontal / np.where(high, clear, 1.0), np.nan).reshape(-1, 60 // step)
    index = index[np.isfinite(index).all(axis=1)]
    group, spread = np.searchsorted(CLASSES, index.mean(axis=1)), index.std(axis=1)
    for k, measured in enumerate(PAYERNE[step]):
        assert spread[group == k].mean() == pytest.approx(measured, rel=0.35)
    assert spread[group == 3].mean() < 0.06  # clear hours are calm


def test_series_go_on_from_hour_to_hour():
    hourly = np.tile([0.5, 0.6, 0.55], 200)
    follows = np.arange(600) > 0
    joined = clear_indices(hourly, follows, np.random.default_rng(1))
    apart = clear_indices(hourly, np.zeros(600, bool), np.random.default_rng(1))
    within = np.abs(np.diff(joined, axis=1)).mean()
    jump, torn = (np.abs(made[1:, 0] - made[:-1, -1]).mean() for made in (joined, apart))
    assert jump < 3 * within < torn
    np.testing.assert_allclose(joined.mean(), hourly.mean(), rtol=0.05)


def test_a_year_of_steps_has_the_level_planes_year(greensboro):
    week = greensboro.rows(slice(4008, 4176))
    level = sd.Plane(0.0)
    hourly, short = (sd.on_planes(weather, [level], patches="tregenza") for weather in (week, sd.downscaled(week, 10)))
    of_hours = short.irradiance.values.reshape(-1, 6).mean(axis=1)
    np.testing.assert_allclose(of_hours, hourly.irradiance.values[:, 0], rtol=1e-4, atol=0.5)


def test_gaps_light_at_night_and_illuminances(greensboro, files):
    day = greensboro.rows(slice(4008, 4032))
    torn = day.direct_normal.copy()
    torn[12], torn[1] = np.nan, 30.0
    fine = sd.downscaled(replace(day, direct_normal=torn), 20)
    assert fine.missing.reshape(-1, 3)[12].all()
    assert fine.missing.sum() == 3
    np.testing.assert_array_equal(fine.direct_normal.reshape(-1, 3)[1], 30.0)
    light = read_weather(files["light"]).rows(slice(4008, 4032))
    short = sd.downscaled(light, 20)
    whole = short.diffuse_illuminance.reshape(-1, 3).mean(axis=1)
    np.testing.assert_allclose(whole, light.diffuse_illuminance, rtol=1e-3, atol=5.0)


def test_a_stressed_tape_stays_within_what_can_be(files):
    tape = read_weather(files["stress"])
    fine = sd.downscaled(tape, 5)
    beam, sky = (light.reshape(-1, 12).mean(axis=1) for light in on_level(fine))
    hourly = sum(on_level(tape))
    np.testing.assert_allclose(beam + sky, hourly, rtol=1e-9, atol=1e-9)
    assert fine.direct_normal.max() < 1420


def test_what_cannot_be_is_refused(greensboro):
    with pytest.raises(ValueError, match="must be one of 1, 2, 3"):
        sd.downscaled(greensboro, 7)
    with pytest.raises(ValueError, match="hourly rows, got one of 5 min"):
        sd.downscaled(sd.downscaled(greensboro.rows(slice(0, 24)), 5), 1)


def test_the_command_writes_a_tape_of_minutes(files, tmp_path):
    path = tmp_path / "short.wea"
    words = ["weather", str(files["epw"]), "--downscale", str(path), "--step", "10min", "--seed", "2", "--json"]
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 0, result.stderr
    facts = json.loads(result.stdout, parse_constant=pytest.fail)
    assert facts["downscaled"]["rows"] == 52_560
    sums = facts["irradiation_kwh_m2"]
    assert facts["downscaled"]["irradiation_kwh_m2"]["diffuse"] == pytest.approx(sums["diffuse"], abs=0.2)
    back = read_weather(path)
    assert back.count == 52_560
    assert (back.end - back.start == np.timedelta64(600, "s")).all()
    wrong = CliRunner().invoke(app, [*words[:3], str(path), "--step", "soon"])
    assert wrong.exit_code == 2
    assert "--step must be minutes" in wrong.stderr
