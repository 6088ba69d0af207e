"""What is written for Radiance, read back by Radiance's own programs."""

import numpy as np
import pytest

import skydome as sd
from skydome.years.gendaymtx.text import read, write
from skydome.years.skies.series import year
from skydome.years.stores.radiance_files import SUN_SIZE, write_matrix, write_sky, write_suns

SUN = sd.direction(azimuth=150 * sd.deg, elevation=40 * sd.deg)


@pytest.fixture(scope="module")
def week(greensboro):
    return year(greensboro.rows(slice(4300, 4400)), colour="preetham")


@pytest.mark.parametrize("binary", [True, False])
def test_a_matrix_read_by_rmtxop(run_radiance, week, tmp_path, binary):
    write_matrix(week.drop_vars("xyz"), tmp_path / "a.mtx", binary)
    (tmp_path / "b.mtx").write_bytes(run_radiance("rmtxop", "-fd", tmp_path / "a.mtx").stdout)
    values, facts = read(tmp_path / "b.mtx")
    assert values.shape == (146, 100, 3)
    expected = week.luminance.values.T / 179
    assert np.allclose(values[1:, :, 1], expected, rtol=1e-6 if binary else 6e-3)
    assert float(facts["LATLONG"].split()[1]) == pytest.approx(-79.95)


def test_horizontal_illuminance_by_dctimestep(run_radiance, week, tmp_path):
    """A sensor that sees the whole sky: the matrix of horizontal solid angles times the skies."""
    write_matrix(week, tmp_path / "sky.mtx")
    row = np.concatenate([[0.0], week.horizontal_solid_angle.values])
    with (tmp_path / "sensor.mtx").open("wb") as file:
        write(file, [np.repeat(row[None, :, None], 3, axis=-1)], (1, row.size), (0.0, 0.0), "float")
    answer = run_radiance("dctimestep", "-h", "-od", tmp_path / "sensor.mtx", tmp_path / "sky.mtx").stdout
    rgb = np.frombuffer(answer[-100 * 3 * 8 :], np.float64).reshape(100, 3)
    light = 179 * rgb @ sd.RADIANCE.to_xyz[1]
    assert np.allclose(light, week.diffuse_horizontal_illuminance, rtol=1e-4, atol=1e-3)


def test_the_sun_in_its_patch_adds_its_light(week, tmp_path):
    for name, with_sun in (("sky", False), ("both", True)):
        write_matrix(week.drop_vars("xyz"), tmp_path / f"{name}.mtx", with_sun=with_sun)
    (sky, _), (both, _) = read(tmp_path / "sky.mtx"), read(tmp_path / "both.mtx")
    added = ((both - sky)[1:, :, 1] * week.solid_angle.values[:, None]).sum(axis=0) * 179
    assert np.allclose(added, week.direct_normal_illuminance, rtol=1e-4, atol=1e-2)


def test_one_sky_traced_by_rtrace(run_radiance, tmp_path):
    sky = sd.PerezAllWeather(SUN, 600.0, 150.0)
    write_sky(sky, tmp_path / "noon.rad")
    (tmp_path / "noon.oct").write_bytes(run_radiance("oconv", "noon.rad", cwd=tmp_path).stdout)
    random = np.random.default_rng(5).normal(size=(300, 3))
    toward = random / np.linalg.norm(random, axis=-1, keepdims=True)
    toward[:, 2] = np.abs(toward[:, 2])
    toward = toward[sd.angle_between(toward, SUN) > 0.01]
    lines = "\n".join("0 0 0 " + " ".join(map(repr, row)) for row in toward.tolist()) + "\n"
    answer = run_radiance("rtrace", "-h", "-w", "-ab", "0", "noon.oct", cwd=tmp_path, input=lines.encode()).stdout
    traced = np.array(answer.split(), dtype=float).reshape(-1, 3)[:, 1] * 179
    assert np.allclose(traced, sky.luminance(toward), rtol=2e-4)


def test_one_sky_and_its_sun_light_a_plane(run_radiance, tmp_path):
    sky = sd.PerezAllWeather(SUN, 600.0, 150.0)
    write_sky(sky, tmp_path / "noon.rad")
    (tmp_path / "noon.oct").write_bytes(run_radiance("oconv", "noon.rad", cwd=tmp_path).stdout)
    options = ["-h", "-w", "-I", "-ab", "1", "-ad", "16384", "-lw", "1e-6"]
    answer = run_radiance("rtrace", *options, "noon.oct", cwd=tmp_path, input=b"0 0 0 0 0 1\n").stdout
    light = float(answer.split()[1]) * 179
    expected = sky.diffuse_illuminance + sky.direct_normal_illuminance * SUN[2]
    assert abs(light / float(expected) - 1) < 0.01


def test_suns_are_sources_that_oconv_takes(run_radiance, week, tmp_path):
    count = write_suns(week, tmp_path / "suns.rad")
    assert count == int(((week.direct_normal_illuminance > 0) & (week.sun_elevation > 0)).sum())
    text = (tmp_path / "suns.rad").read_text()
    assert text.count("source sun") == count
    first = float(text.split()[6])
    hour = int(np.flatnonzero(week.direct_normal_illuminance.values > 0)[0])
    assert first * SUN_SIZE * 179 == pytest.approx(float(week.direct_normal_illuminance[hour]), rel=1e-3)
    assert run_radiance("oconv", tmp_path / "suns.rad").stdout.startswith(b"#?RADIANCE")


def test_bad_requests(week, tmp_path):
    with pytest.raises(ValueError, match="Tregenza's or Reinhart's"):
        write_matrix(week.assign_attrs(patches="equal-area:1"), tmp_path / "a.mtx")
    sky = sd.PerezAllWeather(SUN, 600.0, 150.0)
    with pytest.raises(ValueError, match=r"must end in \.rad"):
        write_sky(sky, tmp_path / "a.txt")
    with pytest.raises(ValueError, match="one sky is written at a time"):
        write_sky(sd.PerezAllWeather(SUN[None], 600.0, 150.0), tmp_path / "a.rad")
    with pytest.raises(FileNotFoundError, match="the folder to write to must exist"):
        write_matrix(week, tmp_path / "missing" / "a.mtx")
    assert list(tmp_path.iterdir()) == []
