"""The path tracer: against discrete ordinates and single scattering, reproducible, resumable, in twilight."""

import numpy as np
import pytest

import skydome as sd
from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Aerosol, Molecules, Ozone
from skydome.air.phase_laws import CornetteShanks
from skydome.air.profiles import Tabulated
from skydome.ground import compiled
from skydome.ground.quadrature import hemisphere
from skydome.skies.path_tracing.sky import PathTraced
from skydome.skies.physical.nishita import Nishita93

pytest.importorskip("numba")
W = np.array([550.0])
VIEWS = sd.direction(np.radians([180.0, 180, 0, 90, 0, 45]), np.radians([20.0, 70, 30, 50, 89, 10]))
AIR = Atmosphere.standard(aerosol_depth=0.1)


def sun_at(elevation):
    return sd.direction(np.pi, elevation * sd.deg)


def check(tracing, expected, limit=4.0):
    """Within `limit` standard errors everywhere, and about one in the mean square: an error that is told truly."""
    away = (tracing.radiance - expected) / tracing.standard_error
    assert np.abs(away).max() < limit
    assert 0.4 < np.sqrt((away**2).mean()) < 1.8


def test_one_bounce_is_single_scattering():
    wavelengths = np.array([360.0, 550.0, 700.0])
    found = PathTraced(sun_at(40.0), AIR, orders=1, exact_first=False).job(VIEWS, wavelengths).start().more(32)
    check(found, Nishita93(sun_at(40.0), AIR).radiance(VIEWS, wavelengths))


def test_first_order_by_quadrature_or_by_paths_is_the_same():
    jobs = [
        PathTraced(sun_at(30.0), AIR, exact_first=e, seed=int(e), paths_per_pass=32).job(VIEWS, [400.0, 600.0])
        for e in (True, False)
    ]
    exact, drawn = (job.start().more(40) for job in jobs)
    away = (exact.radiance - drawn.radiance) / np.hypot(exact.standard_error, drawn.standard_error)
    assert np.abs(away).max() < 4
    assert exact.standard_error.mean() < drawn.standard_error.mean()


def test_ozone_table_cornette_shanks_and_tabulated_aerosol():
    pytest.importorskip("nanodisort")
    aerosol = Aerosol(0.2, phase=CornetteShanks(0.7), profile=Tabulated((0.0, 1000.0, 5000.0), (1.0, 1.0, 0.0)))
    flat = Atmosphere((Molecules(depolarisation=0.0), aerosol, Ozone(400.0)), 0.2, radius=6.371e9)
    found = PathTraced(sun_at(45.0), flat, exact_first=False, paths_per_pass=128).job(VIEWS, [600.0]).start().more(48)
    expected = sd.DiscreteOrdinates(sun_at(45.0), flat, 32).radiance(VIEWS, [600.0])
    np.testing.assert_allclose(found.radiance, expected, atol=0, rtol=0.05)
    assert np.median(np.abs(found.radiance / expected - 1)) < 0.015


def test_the_same_seed_gives_the_same_light_whatever_the_threads(monkeypatch):
    job = PathTraced(sun_at(30.0), AIR, seed=5).job(VIEWS, W)
    found = []
    for threads in (1, 2, 7):
        monkeypatch.setattr(compiled, "workers", lambda threads=threads: threads)
        found.append(job.start().more(2).mean)
    np.testing.assert_array_equal(found[0], found[1])
    np.testing.assert_array_equal(found[0], found[2])
    assert (PathTraced(sun_at(30.0), AIR, seed=6).job(VIEWS, W).start().more(2).mean != found[0]).any()


def test_interrupted_stored_resumed_and_merged_is_the_same(tmp_path):
    job = PathTraced(sun_at(30.0), AIR).job(VIEWS, W)
    whole = job.start().more(6)
    job.start().more(4).save(tmp_path / "half.npz")
    resumed = job.start().resumed(tmp_path / "half.npz").more(2)
    np.testing.assert_allclose(resumed.mean, whole.mean, rtol=1e-13)
    np.testing.assert_allclose(resumed.standard_error, whole.standard_error, rtol=1e-9)
    with pytest.raises(ValueError, match="share the pass 0"):
        whole.merged(whole)
    other = PathTraced(sun_at(31.0), AIR).job(VIEWS, W)
    with pytest.raises(ValueError, match="holds another tracing"):
        other.start().resumed(tmp_path / "half.npz")
    with pytest.raises(ValueError, match="only tracings of one job"):
        other.start().more(1).merged(job.start().resumed(tmp_path / "half.npz"))


def test_until_reaches_the_error_asked_for_and_tells_it_truly():
    job = PathTraced(sun_at(50.0), AIR).job(hemisphere(3, 5)[0], W)
    found = job.start().until(0.01)
    assert found.relative_error <= 0.01
    other = PathTraced(sun_at(50.0), AIR, seed=9).job(job.directions, W).start().until(0.01)
    assert np.median(np.abs(found.radiance / other.radiance - 1)) < 0.03


def test_shapes_and_bad_input():
    sky = PathTraced(sun_at(30.0), AIR, relative_error=0.05)
    assert sky.radiance(VIEWS.reshape(2, 3, 3), W).shape == (2, 3, 1)
    assert (sky.radiance(-VIEWS, W) == 0).all()
    with pytest.raises(ValueError, match="one sun of shape"):
        PathTraced(np.stack([sd.ZENITH, sd.ZENITH]), AIR)
    with pytest.raises(ValueError, match=r"relative_error must lie in"):
        PathTraced(sun_at(30.0), AIR, relative_error=0.0)
    with pytest.raises(ValueError, match=r"guide must lie in \[0, 0.95\], got 1"):
        PathTraced(sun_at(30.0), AIR, guide=1.0)
