"""The evaluation: reads both layouts, reproduces known measures, refuses what is broken."""

import json
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.evaluation.evaluation import band_mean, compared, relative_rms
from skydome.evaluation.measured_sky import MeasuredSky, turned_to_sun
from skydome.evaluation.model_fit import fitted
from skydome.evaluation.models import EvaluatedModel, model_of
from skydome.evaluation.runs import evaluated
from skydome.ground.quadrature import hemisphere
from skydome.ground.units import deg

HERE = Path(os.environ.get("SKYDOME_DATA", Path(__file__).parents[3] / "shared" / "data"))
FILE = HERE / "kider2014_open.nc"
needs_data = pytest.mark.skipif(not FILE.exists(), reason="the measured sky (kider2014_open.nc) is not at hand")
pytest.importorskip("scipy")


@pytest.fixture(scope="module")
def sky():
    return MeasuredSky.open(FILE)


def ring_views():
    """The 81 directions of a scan, their azimuths as named: counter-clockwise, by rings from the horizon up."""
    counts, elevations = (32, 24, 16, 8, 1), (12.1151, 33.749, 53.3665, 71.9187, 90.0)
    return [(360.0 * k / n, e) for n, e in zip(counts, elevations, strict=True) for k in range(n)]


def write_scan(folder, name, light, samples=81, wavelengths=(400, 550, 700)):
    place = folder / name[:10] / "RADIANCE" / f"{name[:10]}___{name[11:].replace(':', '.')}"
    place.mkdir(parents=True)
    for k, (azimuth, elevation) in enumerate(ring_views()[:samples]):
        toward = sd.direction(-azimuth * deg, elevation * deg)  # the names' azimuths run counter-clockwise
        stem = f"{name[:10]}___{name[11:].replace(':', '.')}_-_{k}____{azimuth}___{elevation}.asd.rad.txt"
        rows = "\n".join(f"{w}\t{light(toward):.8g}" for w in wavelengths)
        (place / stem).write_text(f"Wavelength\tRadiance\n{rows}\n")
    return place


@needs_data
@pytest.mark.parametrize(
    ("name", "expected", "tolerance"),
    [("preetham", 1.27, 0.01), ("hosek-wilkie", 0.56, 0.02), ("discrete-ordinates", 0.141, 0.004)],
)
def test_known_measures_at_the_usual_numbers(sky, name, expected, tolerance):
    if name == "discrete-ordinates":
        pytest.importorskip("nanodisort")
    model = model_of(name)
    light = np.stack([band_mean(model.sky_of()(s), v) for s, v in zip(sky.suns, sky.directions, strict=True)])
    assert relative_rms(light, sky.band(), sky.valid).mean() == pytest.approx(expected, abs=tolerance)


@needs_data
def test_figures_of_the_measured_sky_against_itself(sky):
    one = sky.some([0])
    assert len(one) == 1
    model = compared("hosek-wilkie", one, model_of("hosek-wilkie").sky_of())
    figures = model.figures()
    assert 0.4 < figures["error"] < 0.7
    assert figures["chromaticity_error"] < 0.03
    assert model.far.sum() < one.valid.sum()


@needs_data
def test_the_symmetry_of_a_scan_gives_back_the_known_azimuth_correction(sky):
    from scipy.io import netcdf_file

    with netcdf_file(FILE, "r", mmap=False) as stored:
        nominal = np.array(stored.variables["direction_azimuth_nominal"][:], dtype=float)
        zenith = np.array(stored.variables["direction_zenith"][:], dtype=float)
        correction = np.array(stored.variables["azimuth_correction"][:], dtype=float)
    for k in (0, 5, 11):
        views = sd.direction(np.broadcast_to(nominal, sky.band().shape)[k] * deg, (90 - zenith) * deg)
        found = turned_to_sun(views, sky.band()[k], sky.suns[k])
        turn = np.degrees(sd.azimuth(found) - sd.azimuth(views))[0] % 360
        assert turn == pytest.approx(correction[k], abs=4)


def test_published_folder_is_read_clockwise_and_turned_to_the_sun(tmp_path):
    from skydome.evaluation.measured_sky import CORNELL

    sun = sd.sun_direction(CORNELL, "2013-05-27T09:32:51-04:00")
    sky = sd.HosekWilkie(sun, 3.0)
    write_scan(tmp_path, "2013-05-27T09:30:00", lambda v: float(sky.luminance(v)))
    read = MeasuredSky.open(tmp_path)
    assert read.radiance.shape == (1, 81, 3)
    assert not read.valid[0, 0]
    np.testing.assert_allclose(read.radiance[0, 1:, 0], sky.luminance(read.directions[0, 1:]), rtol=0.03)


def test_truncated_and_mixed_folders_are_refused(tmp_path):
    with pytest.raises(ValueError, match="no measurements"):
        MeasuredSky.open(tmp_path)
    place = write_scan(tmp_path / "a", "2013-05-27T09:30:00", lambda v: 1.0, samples=60)
    with pytest.raises(ValueError, match="lacks 21 of 81 samples, the first is number 60"):
        MeasuredSky.open(tmp_path / "a")
    place = write_scan(tmp_path / "b", "2013-05-27T09:30:00", lambda v: 1.0 + v[2])
    victim = sorted(place.iterdir())[5]
    victim.write_text("Wavelength\tRadiance\n400\t1.0\n")
    with pytest.raises(ValueError, match="do not have the same wavelengths"):
        MeasuredSky.open(tmp_path / "b")
    victim.write_text("Wavelength\tRadiance\n400\tbroken\n")
    with pytest.raises(ValueError, match="cannot be read"):
        MeasuredSky.open(tmp_path / "b")
    (place / "stray.rad.txt").write_text("")
    with pytest.raises(ValueError, match="not named as the measurements are"):
        MeasuredSky.open(tmp_path / "b")


def test_broken_netcdf_is_refused(tmp_path):
    path = tmp_path / "sky.nc"
    with pytest.raises(FileNotFoundError, match="not there"):
        MeasuredSky.open(path)
    path.write_bytes(b"CDF\x01 cut short")
    with pytest.raises(ValueError, match=r"cannot be read|can be read whole|netCDF-3"):
        MeasuredSky.open(path)


def made_up_sky(turbidity=3.0):
    """A measured sky that is Hosek and Wilkie's."""
    views = np.broadcast_to(hemisphere(6, 12)[0], (2, 72, 3))
    suns = sd.direction(np.radians([120.0, 160.0]), np.radians([35.0, 50.0]))
    wavelengths = np.arange(360.0, 721.0, 5)
    light = np.stack([sd.HosekWilkie(s, turbidity).radiance(v, wavelengths) for s, v in zip(suns, views, strict=True)])
    angles = np.arccos(np.clip(np.einsum("cdk,ck->cd", views, suns), -1, 1))
    names = ("2013-05-27T09:30:00", "2013-05-27T10:30:00")
    times = np.array([name + "-04:00" for name in names])
    return MeasuredSky(names, times, suns, views, wavelengths, light, np.ones((2, 72), bool), angles)


def test_a_fit_finds_the_turbidity_a_sky_was_made_with():
    model = EvaluatedModel(
        "hw", lambda sun, turbidity: sd.HosekWilkie(sun, turbidity), {"turbidity": 2.0}, {"turbidity": (1, 10)}, ""
    )
    assert fitted(model, made_up_sky(4.3))["turbidity"] == pytest.approx(4.3, abs=0.02)


@needs_data
def test_preethams_turbidity_is_fitted(sky):
    all_scans, half = (evaluated(sky, ["preetham"], fit)[0] for fit in ("all", "half"))
    assert all_scans.numbers["turbidity"] == pytest.approx(2.32, abs=0.01)
    assert half.numbers["turbidity"] == pytest.approx(2.34, abs=0.01)
    assert 1.2 < all_scans.comparison.figures()["error"] < 1.25
    assert len(half.comparison.sky) == 6


@needs_data
@pytest.mark.slow
@pytest.mark.parametrize(
    ("model", "fit", "scans", "most"),
    [
        ("discrete-ordinates", "no", slice(None), 0.145),
        ("refitted", "no", slice(None), 0.16),
        ("two-lobe-air", "half", slice(4, 8, 2), 0.12),
        ("discrete-ordinates", "each", slice(4, 8, 2), 0.11),
    ],
)
def test_how_near_physical_skies_come(sky, model, fit, scans, most):
    """Fits to a few scans, for time; those to all twelve are in docs/evaluation.md."""
    pytest.importorskip("nanodisort")
    figures = evaluated(sky.some(scans), [model], fit)[0].comparison.figures()
    assert figures["error"] <= most
    assert figures["error_beyond_20_degrees"] <= most


def test_numbers_of_each_scan_are_told_as_spans():
    run = evaluated(made_up_sky(2.7), ["hosek-wilkie"], "each")[0]
    low, high = (float(run.row()["numbers"].split()[k]) for k in (1, 3))
    assert 2.3 < low <= high < 3.1
    assert run.comparison.model.shape == (2, 72)


def test_unknown_models_and_fits_are_refused():
    with pytest.raises(ValueError, match=r"model must be one of .*physical, hosek-wilkie, preetham.* got 'none'"):
        evaluated(made_up_sky(), ["none"])
    with pytest.raises(ValueError, match="fit must be one of no, all, half, each, got 'best'"):
        evaluated(made_up_sky(), ["preetham"], "best")


@needs_data
def test_the_command_writes_table_json_and_figures(tmp_path):
    command = [sys.executable, "-m", "skydome", "evaluate", str(FILE), "--models", "preetham,hosek-wilkie", "--json"]
    command += ["--figures", str(tmp_path), "--table", str(tmp_path / "t.csv")]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    rows = json.loads(done.stdout)["models"]
    assert [row["model"] for row in rows] == ["preetham", "hosek-wilkie"]
    assert rows[0]["error"] == pytest.approx(1.27, abs=0.01)
    assert sorted(p.name for p in tmp_path.iterdir())[:3] == [
        f"evaluation-{n}.png" for n in ("day", "maps", "meridian")
    ]
    assert (tmp_path / "t.csv").read_text().startswith("model,error")
    bad = subprocess.run([*command[:5], "--models", "nothing"], capture_output=True, text=True, check=False)
    assert bad.returncode == 2
    assert bad.stderr.count("\n") == 1


def made_of_air(depth, asymmetry):
    """A measured sky that is discrete ordinates' in plain air, on a day in July."""
    pytest.importorskip("nanodisort")
    sky = made_up_sky()
    make = model_of("discrete-ordinates").sky_of({"depth": depth, "asymmetry": asymmetry})
    w = np.arange(380.0, 721.0, 20)
    scans = zip(sky.suns, sky.sun_distances, sky.directions, strict=True)
    light = np.stack([make(s, float(d)).radiance(v, w) for s, d, v in scans])
    return replace(sky, wavelengths=w, radiance=light)


@pytest.mark.slow
def test_a_fit_leaves_no_local_minimum():
    """From the usual numbers alone it ended at asymmetry 0.4, its limit, with an error of 0.193."""
    sky = made_of_air(0.02, 0.75)
    found = fitted(model_of("discrete-ordinates"), sky)
    assert found["depth"] == pytest.approx(0.02, rel=0.02)
    assert found["asymmetry"] == pytest.approx(0.75, abs=0.01)
    make = model_of("discrete-ordinates").sky_of(found)
    assert compared("air", sky, make).figures()["error"] < 0.01


def test_a_fit_that_ends_at_a_limit_says_so():
    model = EvaluatedModel(
        "hw", lambda sun, turbidity: sd.HosekWilkie(sun, turbidity), {"turbidity": 2.0}, {"turbidity": (1, 4)}, ""
    )
    with pytest.warns(UserWarning, match="the fit of hw ended at a limit: turbidity 4"):
        assert fitted(model, made_up_sky(6.0))["turbidity"] == pytest.approx(4.0, abs=0.005)


def test_the_sun_s_distance_is_that_of_each_scan():
    sky = made_up_sky()
    assert np.allclose(sky.sun_distances, sd.earth_sun_distance([str(t) for t in sky.times]))
    near, far = (model_of("nishita-1993").sky_of()(sky.suns[0], d).radiance(sd.ZENITH, [550.0]) for d in (1.0, 1.0166))
    assert near[0] / far[0] == pytest.approx(1.0166**2, rel=1e-12)


@needs_data
def test_green_ground_has_its_red_edge(sky):
    """At 780 nm, beyond 20 degrees from the sun; a ground of 0.08 is 29 % too dark there."""
    pytest.importorskip("nanodisort")
    where = int(np.argmin(abs(sky.wavelengths - 780.0)))
    ratio = []
    for k in range(0, 12, 3):
        far = sky.valid[k] & (sky.sun_angles[k] > 20 * deg)
        make = model_of("discrete-ordinates").sky_of()(sky.suns[k], float(sky.sun_distances[k]))
        light = make.radiance(sky.directions[k][far], [780.0])[:, 0]
        ratio.append(light.sum() / sky.radiance[k][far][:, where].sum())
    assert abs(np.mean(ratio) - 1) < 0.05
