"""Polarisation of the physical sky: closed forms, conventions, neutral points, an independent program, gradients."""

import csv
import importlib.util
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.skies.all_air.polarised.files import load_polarisation, save_polarisation, shipped_polarisation
from skydome.skies.all_air.polarised.frame import SunFrame
from skydome.skies.all_air.taught_air import optics

ROOT = Path(__file__).parents[3]
SUN = sd.direction(azimuth=180 * sd.deg, elevation=10 * sd.deg)
NOTHING = {"aerosol_depth": 0.0, "ozone": 0.0, "albedo": 0.0, "stratospheric_depth": 0.0}


@pytest.fixture(scope="module")
def judge():
    """The script that asks sasktran2."""
    spec = importlib.util.spec_from_file_location("judge_sasktran2", ROOT / "scripts" / "judge_sasktran2.py")
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    return script


def golden(number):
    """Elevations, azimuths and Stokes I, Q, U (views, wavelengths, 3) of a sky of the judge's."""
    with (ROOT / "tests" / "golden" / "sasktran2.csv").open() as file:
        rows = [row for row in csv.DictReader(file) if int(row["sky"]) == number]
    light = np.array([[float(row[k]) for k in ("I", "Q", "U")] for row in rows])
    where = np.array([[float(row["elevation"]), float(row["azimuth"])] for row in rows])[::2]
    return where[:, 0], where[:, 1], light.reshape(len(where), 2, 3)


def degree_and_angle(stokes):
    i, q, u = np.moveaxis(stokes, -1, 0)
    return np.hypot(q, u) / i, np.degrees(np.arctan2(u, q)) / 2


def turned(a, b):
    """The angle between two fields, degrees, which have no head."""
    return np.abs((a - b + 90) % 180 - 90)


def test_thin_air_polarises_as_rayleigh_across_the_plane_of_view_and_sun():
    air = sd.clear_air(pressure=6000.0, **NOTHING)
    views = sd.direction(np.radians([0.0, 60, 100, 200, 300]), np.radians([80.0, 30, 12, 50, 5]))
    sky = sd.PhysicalSky(SUN, air)
    cosine, gamma = views @ sky.seen_sun, 0.0279 / (2 - 0.0279)
    wanted = (1 - gamma) * (1 - cosine**2) / (1 + 3 * gamma + (1 - gamma) * cosine**2)
    np.testing.assert_allclose(sky.degree_of_polarisation(views, [700.0])[:, 0], wanted, atol=0.015)
    up = np.stack([-views[:, 2:] * views[:, :2] / np.hypot(*views.T[:2])[:, None]])[0]
    up = np.concatenate([up, np.hypot(*views.T[:2])[:, None]], axis=1)
    field, left = np.cross(views, sky.seen_sun), np.cross(up, views)
    angle = np.degrees(np.arctan2((field * left).sum(-1), (field * up).sum(-1)))
    assert turned(np.degrees(sky.angle_of_polarisation(views, [700.0])[:, 0]), angle).max() < 1.0


def test_the_zenith_counts_as_a_view_to_the_north():
    sky = sd.PhysicalSky(SUN, sd.clear_air(pressure=6000.0, **NOTHING))
    near = sd.direction(0.0, 89.9999 * sd.deg)
    np.testing.assert_allclose(sky.stokes(sd.ZENITH, [550.0]), sky.stokes(near, [550.0]), rtol=1e-3, atol=1e-8)
    assert turned(np.degrees(sky.angle_of_polarisation(sd.ZENITH, [550.0])), 90.0).max() < 0.5


@pytest.mark.parametrize("elevation", [35.0, 2.0])
def test_neutral_points(elevation):
    """Q changes sign above the sun (Babinet), below a sun that is high (Brewster), above the point opposite (Arago)."""
    sky = sd.PhysicalSky(sd.direction(0.0, elevation * sd.deg), sd.clear_air(0.05))
    along = np.arange(1.0, 180.0)
    views = np.stack([0 * along, np.cos(along * sd.deg), np.sin(along * sd.deg)], axis=-1)
    q = sky.stokes(views, [450.0])[:, 0, 1]
    changes = along[1:][np.sign(q[1:]) != np.sign(q[:-1])]
    off = [10, 30] if elevation < 10 else [5, 30]
    assert ((changes > elevation + off[0]) & (changes < elevation + off[1])).sum() == 1  # Babinet
    if elevation > 30:
        assert ((changes < elevation - 5) & (changes > elevation - 30)).sum() == 1  # Brewster
    else:
        opposite = 180 + elevation  # below the horizon; Arago stands 15-25 degrees above it
        assert ((opposite - changes > 15) & (opposite - changes < 30)).sum() == 1


def test_against_sasktran2(judge):
    """Twelve skies by day, 40 views, 400 and 600 nm: see docs/models/polarisation.md."""
    degrees, angles, plain, vector = [], [], [], []
    for number, row in enumerate(judge.SKIES):
        elevations, azimuths, light = golden(number)
        air = judge.air_of(row)
        sky = sd.PhysicalSky(sd.direction(0.5, row[0] * sd.deg), air)
        views, sun = sd.direction(0.5 + azimuths * sd.deg, elevations * sd.deg), air.sun_at(judge.WAVELENGTHS)
        stokes = sky.stokes(views, judge.WAVELENGTHS) / sun[:, None]
        (p, a), (p_judge, a_judge) = degree_and_angle(stokes), degree_and_angle(light)
        degrees.append(p - p_judge)
        angles.append(turned(a, a_judge)[p_judge > 0.05])
        vector.append(stokes[..., 0] / light[..., 0] - 1)
        plain.append(sky.radiance(views, judge.WAVELENGTHS) / sun / light[..., 0] - 1)
    off, angle = np.abs(degrees), np.concatenate(angles)
    assert np.sqrt((off**2).mean()) < 0.004
    assert off.max() < 0.02
    assert np.sqrt((angle**2).mean()) < 0.5
    assert angle.max() < 2.0
    assert np.sqrt(np.mean(np.square(vector))) < 0.012
    assert np.sqrt(np.mean(np.square(plain))) > 0.015


def test_against_sasktran2_here(judge):
    """The independent program itself, where it is installed, and the file of what it said."""
    pytest.importorskip("sasktran2", reason="sasktran2 is not installed: its stored numbers are tested alone")
    row = judge.SKIES[6]
    elevations, azimuths, light = golden(6)
    some = slice(0, 6)
    numbers = optics(judge.air_of(row), judge.WAVELENGTHS, np.zeros(1))
    found = judge.judged(numbers, row[0], elevations[some], azimuths[some], streams=8, levels=41)
    np.testing.assert_allclose(found[..., 0], light[some, :, 0], rtol=0.03)
    np.testing.assert_allclose(found[..., 1:], light[some, :, 1:], atol=0.004 * light[..., 0].max())


def test_intensity_with_polarisation():
    """`vector` is what `stokes` has for I, and rotates with the sun."""
    views = sd.direction(np.radians([20.0, 140.0]), np.radians([30.0, 70.0]))
    sky, plain = sd.PhysicalSky(SUN, vector=True), sd.PhysicalSky(SUN)
    light = sky.radiance(views, [400.0, 650.0])
    np.testing.assert_allclose(sky.stokes(views, [400.0, 650.0])[..., 0], light, rtol=1e-12)
    np.testing.assert_allclose(plain.stokes(views, [400.0, 650.0])[..., 0], light, rtol=1e-3)
    change = np.abs(light / plain.radiance(views, [400.0, 650.0]) - 1)
    assert 0.005 < change.max() < 0.09
    np.testing.assert_allclose(sky.held().xyz(views), sky.xyz(views), rtol=2e-3)
    spun = sd.PhysicalSky(sd.direction(200 * sd.deg, 10 * sd.deg))
    on = sd.direction(np.radians([40.0, 160.0]), np.radians([30.0, 70.0]))
    np.testing.assert_allclose(spun.stokes(on, [550.0]), plain.stokes(views, [550.0]), rtol=1e-9)


def test_dark_and_untaught():
    below, night = sd.direction(0.0, -0.1), sd.PhysicalSky(sd.direction(0.0, -0.4))
    assert not sd.PhysicalSky(SUN).stokes(below, [550.0]).any()
    assert night.degree_of_polarisation(sd.ZENITH, [550.0]).tolist() == [0.0]
    many = sd.PhysicalSky(np.stack([SUN, sd.direction(0.0, -0.4)])[:, None])
    assert many.stokes(np.stack([sd.ZENITH, SUN, sd.NORTH]), [450.0, 550.0]).shape == (2, 3, 2, 3)
    with pytest.raises(ValueError, match="wavelengths must lie in"):
        sd.PhysicalSky(SUN).stokes(sd.ZENITH, [200.0])


def test_gradients_and_other_libraries():
    torch = pytest.importorskip("torch")
    sun, views = torch.tensor(SUN, requires_grad=True), torch.tensor(sd.direction([0.3, 2.0], [0.4, 1.2]))
    depth = torch.tensor(0.2, dtype=torch.float64, requires_grad=True)
    light = sd.PhysicalSky(sun, sd.clear_air(depth)).stokes(views, [500.0])
    plain = sd.PhysicalSky(SUN, sd.clear_air(0.2)).stokes(views.numpy(), [500.0])
    np.testing.assert_allclose(light.detach().numpy(), plain, rtol=1e-6)
    slope = torch.autograd.grad(light[..., 1].sum(), [depth, sun])
    step = 1e-4
    there, back = (sd.PhysicalSky(SUN, sd.clear_air(0.2 + s)).stokes(views.numpy(), [500.0]) for s in (step, -step))
    np.testing.assert_allclose(float(slope[0]), ((there - back)[..., 1] / (2 * step)).sum(), rtol=1e-3)
    assert bool(torch.isfinite(slope[1]).all())


def test_the_frame():
    frame = SunFrame.of(sd.EAST, np.stack([sd.NORTH, sd.ZENITH]))
    np.testing.assert_allclose([*frame.left, *frame.up], [-1, -1, 0, 0], atol=1e-15)


def test_files(tmp_path):
    path, network = tmp_path / "own.safetensors", shipped_polarisation()
    save_polarisation(path, network, "a copy")
    assert path.stat().st_size < 40_000
    own, shipped = (sd.PhysicalSky(SUN, polarisation=p).stokes(sd.ZENITH, [500.0]) for p in (path, None))
    np.testing.assert_array_equal(own, shipped)
    path.write_bytes(path.read_bytes()[:5000])
    with pytest.raises(ValueError, match=r"own\.safetensors"):
        load_polarisation(path)
    rest = Path(sd.__file__).parent / "ground" / "data" / "physical_sky_small.safetensors"
    with pytest.raises(ValueError, match="is not a file of the sky's polarisation"):
        load_polarisation(rest)
