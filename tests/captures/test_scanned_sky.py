"""A scanned sky: its samples come back, a smooth sky between them, cubic in time; the measured sky where given."""

import importlib.util
import os
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.captures.scans import read_scans

spec = importlib.util.spec_from_file_location("catalogue", Path(__file__).parents[1] / "skies" / "catalogue.py")
catalogue = importlib.util.module_from_spec(spec)
spec.loader.exec_module(catalogue)
VIEWS = sd.direction(np.linspace(0, 6, 40), np.linspace(0.15, 1.45, 40))


def test_another_kind_of_file_is_refused(tmp_path):
    path = tmp_path / "scans.nc"
    path.write_bytes(b"hello world" * 100)
    with pytest.raises(ValueError, match=r"^.*scans\.nc is not a netCDF-3 file of measured scans$"):
        read_scans(path)


def test_samples_come_back_and_a_smooth_sky_lies_between():
    model = sd.Daylight(sd.CIE(sd.direction(3.0, 1.0), 8, illuminance=20_000.0))
    scan = catalogue.scan_of(model)
    sky = sd.ScannedSky((scan,))
    np.testing.assert_allclose(sky.rgb(scan.directions), scan.light, rtol=1e-6)
    np.testing.assert_allclose(sky.luminance(VIEWS), model.luminance(VIEWS), rtol=0.05)


def test_a_cubic_in_time_is_exact():
    skies = [sd.Daylight(sd.Uniform(100.0 + t**3)) for t in range(6)]
    scans = tuple(catalogue.scan_of(sky, float(t)) for t, sky in enumerate(skies))
    assert sd.ScannedSky(scans, 2.5).luminance(sd.ZENITH) == pytest.approx(100 + 2.5**3, rel=1e-9)
    assert sd.ScannedSky(scans).luminance(sd.ZENITH) == pytest.approx(100.0)


def test_what_is_no_scan():
    with pytest.raises(TypeError, match="scans must be a tuple of one Scan or more"):
        sd.ScannedSky(())
    with pytest.raises(ValueError, match=r"time must lie in .*got nan"):
        sd.ScannedSky((catalogue.scan_of(catalogue.OVERCAST_SKY),), float("nan"))


def test_the_measured_sky():
    folder = Path(os.environ.get("SKYDOME_DATA", Path(__file__).parents[2].parent / "shared" / "data"))
    if not (folder / "kider2014_open.nc").exists():
        pytest.skip("needs kider2014_open.nc (SKYDOME_DATA)")
    scans = read_scans(folder / "kider2014_open.nc")
    sky = sd.ScannedSky.read(folder / "kider2014_open.nc", scans[3].time)
    sample = np.maximum(scans[3].light, 0)
    np.testing.assert_allclose(sky.rgb(scans[3].directions), sample, rtol=1e-6, atol=1e-6 * sample.max())
    assert 5_000 < float(sd.illuminance(sky)) < 40_000
