"""The far end of a picture of land: haze and sky, the Earth's curve, cells of 30 m."""

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.eye.view import Camera
from skydome.haze.aerial_perspective import AirLight
from skydome.haze.horizon_light import HORIZON
from skydome.land import picture, reading
from skydome.land.elevation import Elevation
from skydome.land.picture import REFRACTION, render_terrain

pytest.importorskip("numba")
SUN = sd.direction(azimuth=240 * deg, elevation=35 * deg)
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


def flat(height=50.0):
    return Elevation(np.full((30, 30), height), 100.0, 100.0)


@pytest.mark.parametrize("model", ["formula", "physical"])
@pytest.mark.parametrize("azimuth", [20.0, 130.0, 240.0])
def test_far_land_melts_into_the_sky_behind_it(azimuth, model):
    sky = sd.HosekWilkie(SUN, 3.0) if model == "formula" else sd.PhysicalSky(SUN)
    camera = Camera(azimuth * deg, 0.0, 2 * deg, width=20, height=40, above_ground=300)
    whole = sky + sd.SunDisc.of(sky)
    melting, own = (
        render_terrain(flat(), camera, whole, AirLight(whole, turbidity=3.0, meets_horizon=meets), samples=4).rgb
        for meets in (True, False)
    )
    horizon = sky.rgb(sd.direction(azimuth * deg, HORIZON))
    np.testing.assert_allclose(melting[20].mean(axis=0), horizon, rtol=0.02)
    if azimuth != 240 and model == "formula":
        assert own[20].mean(axis=0) @ LUMINANCE < 0.8 * horizon @ LUMINANCE


@pytest.mark.parametrize("above", [100.0, 1000.0, 5000.0])
def test_the_horizon_dips_and_ends_as_on_the_sphere(above):
    """The farthest ground lies at sqrt(2 R h), the horizon sqrt(2 h / R) below level; R counts refraction."""
    radius = picture.EARTH_RADIUS * REFRACTION
    dip = np.sqrt(2 * above / radius)
    camera = Camera(0.0, -dip, 1 * deg, width=3, height=2001, above_ground=above)
    bent = render_terrain(flat(), camera, sd.Preetham(SUN, 3.0), samples=1, curvature=True)
    ground = np.isfinite(bent.depth[:, 1])
    edge = int(np.argmax(ground))
    assert ground[edge:].all()
    seen = camera.directions(edge, edge + 1)[0, 1, 2]
    assert seen == pytest.approx(-dip, abs=1.5 * camera.pixel)
    assert bent.depth[ground].max() <= np.sqrt(2 * radius * above) * 1.001
    row = edge + 200
    far = far_ground(above, camera.directions(row, row + 1)[0, 1, 2], radius)
    assert bent.depth[row, 1] == pytest.approx(far, rel=5e-3)


def far_ground(above, rise, radius):
    """The nearer root of above + rise t + (1 - rise^2) t^2 / 2 R = 0."""
    a = (1 - rise * rise) / (2 * radius)
    return float(np.min(np.roots([a, rise, above]).real))


def test_thirty_metres_of_four_thousand_square_kilometres_are_kept(monkeypatch, tmp_path):
    rasterio = pytest.importorskip("rasterio")
    from rasterio.transform import Affine

    profile = {"driver": "GTiff", "height": 2109, "width": 2109, "count": 1, "dtype": "uint8", "compress": "deflate"}
    path = tmp_path / "land.tif"
    with rasterio.open(path, "w", crs="EPSG:32617", transform=Affine(30, 0, 5e5, 0, -30, 4e6), **profile) as file:
        file.write(np.broadcast_to(np.uint8(7), (2109, 2109)), 1)
    monkeypatch.setattr(reading, "memory", lambda: 4 << 30)
    land = sd.read_elevation(path)
    assert (land.heights.shape, land.dx, land.notes) == ((2109, 2109), 30.0, ())
    monkeypatch.setattr(reading, "memory", lambda: 1 << 30)
    assert "coarsened 2 times, to 1054 x 1054 cells, which fit into memory" in sd.read_elevation(path).notes[0]
    with pytest.raises(ValueError, match="must keep 4 cells or more, got 0"):
        sd.read_elevation(path, cells=0)


def test_skylight_shows_single_cells_where_it_is_interpolated(monkeypatch):
    """In the shadow of the sky alone, light follows each cell's slope, however far apart the lit vertices stand."""
    rng = np.random.default_rng(2)
    y, x = np.mgrid[:120, :120]
    land = Elevation(8 * np.sin(x * 0.9) * np.cos(y * 0.8) + rng.uniform(0, 3, (120, 120)), 30.0, 30.0)
    camera = Camera(0.0, -80 * deg, 40 * deg, width=60, height=60, above_ground=1500)
    sky = sd.Preetham(SUN, 3.0)
    every = render_terrain(land, camera, sky, samples=4).rgb @ LUMINANCE
    monkeypatch.setattr(picture, "MOST_LIT", 900)
    sparse = render_terrain(land, camera, sky, samples=4).rgb @ LUMINANCE
    assert np.corrcoef(every.ravel(), sparse.ravel())[0, 1] > 0.9
    assert sparse.std() == pytest.approx(every.std(), rel=0.15)
    assert sparse.mean() == pytest.approx(every.mean(), rel=0.01)


@pytest.mark.parametrize("tilt", [0.0, 20.0, 40.0])
def test_skylight_on_a_slope_by_closed_form(tilt):
    """A uniform sky over an open slope, and its own ground: pi L ((1 + cos) / 2 + albedo (1 - cos) / 2)."""
    heights = np.repeat(np.arange(60.0)[:, None] * np.tan(tilt * deg) * 10, 60, axis=1)
    sky = sd.Daylight(sd.Uniform(1000.0))
    camera = Camera(0.0, -85 * deg, 5 * deg, width=6, height=6, above_ground=200)
    land = Elevation(heights, 10.0, 10.0)
    seen = (render_terrain(land, camera, sky, albedo=(0.3,) * 3, samples=1).rgb @ LUMINANCE).mean()
    cosine = np.cos(tilt * deg)
    assert seen == pytest.approx(0.3 * 1000 * ((1 + cosine) / 2 + 0.3 * (1 - cosine) / 2), rel=0.04)
