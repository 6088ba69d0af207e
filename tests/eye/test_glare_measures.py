"""Glare: against evalglare run on the same picture, against Stiles and Holladay, and by hand."""

import subprocess
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.eye.eye import plainly_seen
from skydome.eye.glare import (
    GlareSource,
    daylight_glare_probability,
    glare,
    position_index,
    source_numbers,
    veiling_luminance,
)
from skydome.eye.linked_groups import linked, linked_pixels
from skydome.eye.view import HalfSphere
from skydome.ground import hdr
from skydome.light.colour import RADIANCE, rgb_from_xyz, xyz_from_rgb

SIDE = 600


def overcast():
    return sd.Daylight(sd.MoonSpencer(zenith_luminance=6000.0))


def clear(elevation, turbidity=3.0, factor=1.0, level=None):
    sun = sd.direction(180 * deg, elevation * deg)
    sky = sd.HosekWilkie(sun, turbidity)
    return sky * factor + sd.SunDisc(sun, turbidity, direct_normal_illuminance=level)


SCENES = {
    "overcast": (overcast, 180, 0),
    "overcast, from above": (overcast, 0, -20),
    "sun behind": (lambda: clear(40, factor=0.4), 0, 0),
    "veiled low sun in view": (lambda: clear(4, 8.0, 0.3, 300.0), 160, 0),
    "veiled sun above the line of sight": (lambda: clear(30, 6.0, 0.15, 400.0), 200, 0),
    "veiled low sun below the line of sight": (lambda: clear(4, 8.0, 0.3, 300.0), 180, 30),
    "sun in view": (lambda: clear(30), 180, 0),
}


def evalglare(environment, azimuth, elevation, folder):
    """DGP, illuminance and number of sources by evalglare of the map's round picture."""
    pyradiance = pytest.importorskip("pyradiance")
    frame = HalfSphere(azimuth, elevation, SIDE)
    picture = np.where(frame.solid_angles()[..., None] > 0, plainly_seen(environment, frame), 0.0)
    path = folder / "view.hdr"
    radiance = rgb_from_xyz(xyz_from_rgb(picture, environment.space), RADIANCE) / 179
    hdr.write(path, np.maximum(radiance, 0), {"VIEW": frame.radiance_view})
    program = Path(pyradiance.__file__).parent / "bin" / "evalglare"
    run = subprocess.run([program, "-d", path], capture_output=True, text=True, check=True)
    line = next(line for line in run.stdout.splitlines() if line.startswith("dgp,"))
    names, values = line.split(":")
    facts = dict(zip(names.split(","), map(float, values.split()), strict=True))
    return facts["dgp"], facts["E_v"], int(run.stdout.split()[0])


@pytest.mark.slow
@pytest.mark.parametrize("scene", SCENES)
def test_glare_probability_is_evalglare_s(scene, tmp_path):
    sky, azimuth, elevation = SCENES[scene]
    environment = sd.render(sky(), height=256)
    ours = glare(environment, azimuth * deg, elevation * deg, side=SIDE)
    probability, illuminance, sources = evalglare(environment, azimuth * deg, elevation * deg, tmp_path)
    assert ours.probability == pytest.approx(probability, rel=0.01)
    assert ours.illuminance == pytest.approx(illuminance, rel=3e-3)
    assert len(ours.sources) == sources
    if scene != "sun in view":
        assert ours.probability < 0.95  # the limit of 1 hides nothing


@pytest.mark.parametrize("angle", [1.5, 2, 3, 5, 8, 13, 20, 30])
@pytest.mark.parametrize("age", [0, 35, 60, 80])
def test_veil_of_a_point_is_stiles_and_holladay_s(angle, age):
    # a sun in a black map, found, drawn and integrated: 10 (1 + (A / 70)^4) E / angle^2
    sun = sd.direction(180 * deg, 40 * deg)
    disc = sd.SunDisc(sun, direct_normal_illuminance=50_000.0)
    environment = sd.render(sd.Daylight(sd.Uniform(1.0)) + disc, height=512, ground_albedo=0.0)
    seen = glare(environment, 180 * deg, (40 - angle) * deg, age)
    at_eye = 50_000 * np.cos(angle * deg)
    expected = 10 * (1 + (age / 70) ** 4) * at_eye / angle**2
    assert seen.veil == pytest.approx(expected, rel=0.15)
    if angle >= 3:
        assert seen.veil == pytest.approx(expected, rel=0.05)


def test_veil_of_an_even_ring():
    # luminance 1 from 1 to 30 degrees: 10 x integral of 2 pi sin a cos a / a^2, a in degrees below
    frame = HalfSphere(0.0, 0.0, 1200)
    angle = np.arccos(np.clip(frame.directions() @ frame.forward, -1, 1))
    a = np.linspace(1, 30, 20_001)
    ring = 10 * 2 * np.pi * np.sin(a * deg) * np.cos(a * deg) / a**2
    expected = np.sum((ring[1:] + ring[:-1]) / 2) * (a[1] - a[0]) * deg
    got = veiling_luminance(np.where((angle > 1 * deg) & (angle < 30 * deg), 1.0, 0.0), frame)
    assert got == pytest.approx(expected, rel=5e-3)


def test_position_index():
    assert position_index(0.0, 0.0, 1.0) == 1
    # straight up, Guth: ln P = (35.2 - 1.22) 1e-3 s + 21e-5 s^2
    assert position_index(0.0, np.sin(0.5), np.cos(0.5)) == pytest.approx(
        np.exp(33.98e-3 * 0.5 / deg + 21e-5 * (0.5 / deg) ** 2)
    )
    assert position_index(0.0, 1.0, 0.0) == 16
    # Guth: a source straight above disturbs least, one to the side most
    side, above, below = (position_index(*v) for v in ((0.6, 0.0, 0.8), (0.0, 0.6, 0.8), (0.0, -0.6, 0.8)))
    assert above > below > side > 1
    # the two formulas meet at the level of the eye
    assert position_index(0.6, -1e-9, 0.8) == pytest.approx(position_index(0.6, 1e-9, 0.8), rel=1e-3)
    assert position_index(0.6, 0.3, 0.74) == position_index(-0.6, 0.3, 0.74)


def test_glare_probability_by_hand():
    # Wienold 2006 with evalglare's constants, E = 2000 lx, one source of 10,000 cd m-2, 0.1 sr, P = 2
    one = GlareSource(10_000.0, 0.1, (0.0, 1.0, 0.0), 2.0)
    expected = 5.87e-5 * 2000 + 0.092 * np.log10(1 + 1e8 * 0.1 / (2000**1.87 * 4)) + 0.159
    assert daylight_glare_probability(2000.0, [one]) == pytest.approx(expected, rel=1e-12)
    assert daylight_glare_probability(1e5, [one]) == 1
    assert daylight_glare_probability(0.0, []) == 0.159


def test_sources_are_linked_and_peaks_are_their_own():
    frame = HalfSphere(0.0, 0.0, 200)
    luminance = np.full((200, 200), 500.0)
    for column in (60, 65, 120):  # 5 pixels are 0.079 rad, within 0.1; the third is far
        luminance[100, column] = 5000.0
    luminance[100, 121] = 80_000.0
    numbers = source_numbers(luminance, frame)
    assert numbers[100, 60] == numbers[100, 65] > 0
    assert len({numbers[100, 60], numbers[100, 120], numbers[100, 121]}) == 3
    assert not numbers[100, 61:65].any()
    assert source_numbers(luminance, frame, threshold=5.0).max() > 0  # a factor on the mean


def test_linking_is_that_of_all_pairs():
    random = np.random.default_rng(1)
    points = sd.unit(random.normal(size=(300, 3)))
    groups = linked(points, 0.12)
    near = np.arccos(np.clip(points @ points.T, -1, 1)) <= 0.12
    reached = near.copy()
    for _ in range(300):
        further = reached @ near
        if np.array_equal(further, reached):
            break
        reached = further
    np.testing.assert_array_equal(groups[:, None] == groups, reached)
    assert linked(np.zeros((0, 3)), 0.1).shape == (0,)
    assert not linked_pixels(np.zeros((4, 4), dtype=bool), np.zeros((4, 4, 3)), 0.1).any()


def test_small_pictures_are_refused():
    with pytest.raises(ValueError, match=r"must lie in \[100, 8192\] pixels, got 50"):
        glare(sd.EnvironmentMap(np.ones((8, 16, 3))), 0.0, 0.0, side=50)
