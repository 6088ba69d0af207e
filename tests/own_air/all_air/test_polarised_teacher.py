"""The teacher of polarisation: harmonics of spin two, sasktran2's numbers, lessons and training in small."""

import csv
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("numba")
pytest.importorskip("scipy")

import skydome as sd
from skydome.own_air.all_air.airs import AIRS
from skydome.own_air.all_air.harmonics import legendre
from skydome.own_air.all_air.phases import depths, scattered
from skydome.own_air.all_air.places import Places, sun_along
from skydome.own_air.all_air.polarised.lessons import PolarisedLessons, make_polarised_lessons
from skydome.own_air.all_air.polarised.solver import PolarisedSolver, by_molecules, polarised_phase
from skydome.own_air.all_air.polarised.spin_harmonics import spin_two
from skydome.own_air.all_air.polarised.training import Course, train_polarisation
from skydome.own_air.all_air.shells import Rays
from skydome.own_air.all_air.solver import Solver
from skydome.own_air.all_air.sunlight import Sunlight, seen_sines
from skydome.skies.all_air.polarised.files import load_polarisation
from skydome.skies.all_air.taught_air import Optics, optics

TINY = Places(10, 9, 22, 6, 5, nodes=8, nodes_once=12, rising=5, falling=3)
SMALL = Places(13, 11, 30, 7, 6, nodes=10, nodes_once=16, rising=6, falling=4)
GOLDEN = Path(__file__).parents[2] / "golden" / "sasktran2.csv"


@pytest.fixture(scope="module")
def solver():
    return PolarisedSolver(Solver.of(SMALL))


def test_functions_of_spin_two_are_orthonormal():
    cosine, weight = np.polynomial.legendre.leggauss(24)
    sums, gaps = spin_two(cosine, 8)
    for m in range(4):
        whole = np.einsum("lj,kj,j->lk", sums[m], sums[m], weight) + np.einsum("lj,kj,j->lk", gaps[m], gaps[m], weight)
        across = np.einsum("lj,kj,j->lk", sums[m], gaps[m], weight)
        np.testing.assert_allclose(whole, np.diag(np.arange(8) >= max(m, 2)), atol=1e-12)
        np.testing.assert_allclose(across + across.T, 0, atol=1e-12)


def test_rayleighs_second_degree_polarises_across_the_sun():
    """Modes of I about the sun, taken as E, are polarised by sin^2 across the plane of view and sun, in Q and in U."""
    cosine, weight = np.polynomial.legendre.leggauss(12)
    sine, azimuth = np.sin(0.6), np.linspace(0, np.pi, 60)
    between = cosine[:, None] * sine + np.sqrt(1 - cosine[:, None] ** 2) * np.cos(0.6) * np.cos(azimuth)
    second, plain, (sums, gaps) = (3 * between**2 - 1) / 2, legendre(cosine, 3), spin_two(cosine, 3)
    step = np.full(60, np.pi / 59)
    step[[0, -1]] /= 2
    q = u = 0.0
    for m in range(3):
        wave = second @ (np.cos(m * azimuth) * step) * (1 if m == 0 else 2) / np.pi
        mode = (plain[m, 2] * weight) @ wave
        q = q + mode * sums[m, 2][:, None] * np.cos(m * azimuth)
        u = u + mode * gaps[m, 2][:, None] * np.sin(m * azimuth)
    wanted = np.stack([np.stack(polarised_phase(c, np.array([sine]), azimuth))[:, 0, :, 0] for c in cosine], axis=1)
    size = np.sqrt(3 / 8) / (3 / (16 * np.pi)) / ((1 - 0.0279) / (1 + 0.0279 / 2))
    np.testing.assert_allclose(np.stack([q, u]), size * wanted, atol=1e-5)


def test_the_teacher_against_sasktran2(solver):
    """Q and U over I of skies by day, on a small grid: the shipped one errs by a fifth of this."""
    number, azimuth = 6, np.linspace(0, np.pi, 37)
    with GOLDEN.open() as file:
        rows = [row for row in csv.DictReader(file) if int(row["sky"]) == number and row["nm"] == "400"]
    own = optics(sd.clear_air(0.05, asymmetry=0.7, ozone=400.0), np.array([400.0]), np.zeros(1))
    air = Optics(*(np.full(AIRS, float(part[0])) for part in own))
    sines = np.array([np.sin(np.radians(22.0))])
    cosines = np.array([np.sin(np.radians(float(row["elevation"]))) for row in rows[:8]])
    light = solver.at_ground(solver.solve(air), sines, cosines, azimuth)
    close = Rays.to_the_eye(cosines, 64)
    for n, row in enumerate(rows[:8]):
        sun = Sunlight.of(close.height[n], sun_along(close.arc[n], sines, azimuth)[0])
        once = by_molecules(close, n, sun, depths(air), scattered(air))
        turn = float(row["azimuth"]) % 360
        phase = polarised_phase(cosines[n], seen_sines(sines), azimuth)
        for k, rest in enumerate((light.q, light.u)):
            share = ((rest[n] + once * phase[k]) / (light.rest[n] + light.once[n]))[0, :, 0]
            found = np.interp(np.radians(min(turn, 360 - turn)), azimuth, share) * (-1 if k and turn > 180 else 1)
            assert found == pytest.approx(float(row["QU"[k]]) / float(row["I"]), abs=0.012)


def test_lessons_and_training(tmp_path):
    assert make_polarised_lessons(tmp_path / "lessons", 1, places=TINY) == 1
    assert make_polarised_lessons(tmp_path / "lessons", 1, places=TINY) == 0
    lessons = PolarisedLessons.load(tmp_path / "lessons")
    assert lessons.fields.shape == (AIRS * 28, 3, 260)
    assert np.isfinite(lessons.fields).all()
    assert 0 < lessons.held.sum() < len(lessons.held) / 4
    pytest.importorskip("torch")
    course, path = Course(shapes=6, terms=4, width=12, steps=100), tmp_path / "own.safetensors"
    errors = train_polarisation(tmp_path / "lessons", path, course)
    assert max(errors.values()) < 0.1
    assert load_polarisation(path).shapes.shape == (3, 6, 20, 4)
    with pytest.raises(ValueError, match="must hold lessons"):
        PolarisedLessons.load(tmp_path)
