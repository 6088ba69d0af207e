"""A photograph laid onto land: its place, its gamma, its level, and every fault that it may have."""

import json
import warnings

import numpy as np
import pytest
from PIL import Image

import skydome as sd
from skydome import deg
from skydome.eye.view import Camera
from skydome.land.elevation import Elevation
from skydome.land.picture import render_terrain
from skydome.land.reading import read_elevation
from skydome.land.texture import read_texture
from skydome.light.colour import SRGB, decode_srgb

rasterio = pytest.importorskip("rasterio")
LUMINANCE = np.asarray(SRGB.to_xyz[1])
RED, GREEN, BLUE, GREY = (200, 40, 40), (40, 160, 40), (50, 60, 180), (90, 90, 90)


def raster(path, values, crs="EPSG:32617", transform=(30.0, 0, 500000.0, 0, -30.0, 4000000.0), **more):
    """Write values (bands, h, w) as a GeoTIFF."""
    from rasterio.transform import Affine

    shape = {"count": values.shape[0], "height": values.shape[1], "width": values.shape[2], "dtype": values.dtype}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        place = {"crs": crs, "transform": Affine(*transform)} if crs else {}
        with rasterio.open(path, "w", driver="GTiff", **shape, **place, **more) as file:
            file.write(values)
    return path


def quarters(size=40):
    """A photo (size, size, 3): red in the north-west, green north-east, blue south-west, grey south-east."""
    photo = np.zeros((size, size, 3), np.uint8)
    half = size // 2
    photo[:half, :half], photo[:half, half:] = RED, GREEN
    photo[half:, :half], photo[half:, half:] = BLUE, GREY
    return photo


def corners(albedo):
    """Which of the four colours each corner has, north-west first."""
    hues = np.array([decode_srgb(np.array(c) / 255) for c in (RED, GREEN, BLUE, GREY)])
    hues = hues / hues.sum(axis=-1, keepdims=True)
    found = albedo[[2, 2, -3, -3], [2, -3, 2, -3]]
    found = found / found.sum(axis=-1, keepdims=True)
    return [int(np.abs(hues - one).sum(axis=-1).argmin()) for one in found]


@pytest.fixture
def land(tmp_path):
    """60 x 60 heights of 30 m in UTM zone 17."""
    heights = np.random.default_rng(0).uniform(0, 50, (1, 60, 60)).astype(np.float32)
    return read_elevation(raster(tmp_path / "land.tif", heights))


def test_the_extent_is_that_of_the_outer_heights(land):
    assert (land.extent.west, land.extent.north) == (500015.0, 3999985.0)
    assert (land.extent.east, land.extent.south) == (501785.0, 3998215.0)


@pytest.mark.parametrize("name", ["a.png", "a.jpg"])
def test_pictures_are_stretched_over_the_map(land, tmp_path, name):
    Image.fromarray(quarters()).save(tmp_path / name, quality=95)
    albedo, notes = read_texture(tmp_path / name, land)
    assert corners(albedo) == [0, 1, 2, 3]
    assert (albedo @ LUMINANCE).mean() == pytest.approx(0.115, rel=1e-6)
    assert "40 x 40 texels stretched over the map" in notes[0]
    if name == "a.png":  # without gamma: ratios of light, not of code values
        linear = decode_srgb(np.array([RED, GREEN]) / 255)
        assert albedo[2, 2] / albedo[2, -3] == pytest.approx(linear[0] / linear[1], rel=1e-6)


def test_a_geotiff_is_laid_on_by_its_georeference(land, tmp_path):
    """A photo of twice the land, in degrees; its quarters meet in the middle of the land."""
    from rasterio.warp import transform

    lon, lat = transform("EPSG:32617", "EPSG:4326", [500900 - 1800, 500900 + 1800], [3999100 + 1800, 3999100 - 1800])
    step = ((lon[1] - lon[0]) / 120, (lat[1] - lat[0]) / 120)
    photo = np.moveaxis(quarters(120), -1, 0)
    raster(tmp_path / "p.tif", photo, "EPSG:4326", (step[0], 0, lon[0], 0, step[1], lat[0]))
    albedo, notes = read_texture(tmp_path / "p.tif", land)
    assert "laid on by its georeference" in notes[0]
    assert corners(albedo) == [0, 1, 2, 3]
    row, column = albedo.shape[0] // 2, albedo.shape[1] // 2
    assert corners(albedo[row - 4 : row + 5, column - 4 : column + 5]) == [0, 1, 2, 3]
    moved = raster(tmp_path / "q.tif", photo, "EPSG:4326", (step[0], 0, lon[0] + 30 * step[0], 0, step[1], lat[0]))
    assert corners(read_texture(moved, land)[0]) == [0, 0, 2, 2]
    sixteen = raster(
        tmp_path / "s.tif", photo.astype(np.uint16) * 257, "EPSG:4326", (step[0], 0, lon[0], 0, step[1], lat[0])
    )
    assert read_texture(sixteen, land)[0] == pytest.approx(albedo, abs=0.005)  # 8 bits where colours meet


def test_one_without_georeference_or_on_land_without_is_stretched(land, tmp_path):
    photo = np.moveaxis(quarters(), -1, 0)
    for path, ground in (
        (raster(tmp_path / "bare.tif", photo, None), land),
        (raster(tmp_path / "far.tif", photo), Elevation(land.heights, 30.0, 30.0)),
    ):
        albedo, notes = read_texture(path, ground)
        assert corners(albedo) == [0, 1, 2, 3]
        assert "stretched over the map" in notes[0]


def test_what_the_photo_lacks_gets_its_mean(land, tmp_path):
    whole = np.dstack([quarters(), np.full((40, 40), 255, np.uint8)])
    whole[:10, :, 3] = 0
    Image.fromarray(whole).save(tmp_path / "hole.png")
    albedo, notes = read_texture(tmp_path / "hole.png", land)
    assert "25 % not in the photo" in notes[-1]
    assert albedo[:10] == pytest.approx(np.broadcast_to(albedo[10:].mean(axis=(0, 1)), (10, 40, 3)))


def test_snow_ends_at_nine_tenths_and_grey_is_a_photo_too(land, tmp_path):
    photo = np.full((30, 30), 10, np.uint8)
    photo[:3] = 255
    Image.fromarray(photo).save(tmp_path / "snow.png")
    albedo, _ = read_texture(tmp_path / "snow.png", land, 0.3)
    assert albedo.max() == 0.9
    assert (albedo[..., 0] == albedo[..., 2]).all()


def test_faults_in_one_line(land, tmp_path):
    photo = np.moveaxis(quarters(), -1, 0)
    faults = {
        "none.png": "a texture must be a file that exists",
        "text.png": "damaged or no picture",
        "text.tif": "damaged or no GeoTIFF",
        "photo.gif": "must end in .tif, .png or .jpg",
        "away.tif": "must show at least half of the elevation model, got 0 %",
        "float.tif": "8 or 16 bits a band",
        "deep.png": "8 bits a band",
        "black.png": "is black all over",
        "dot.png": "2 x 2 pixels or more",
    }
    for name in ("text.png", "text.tif", "photo.gif"):
        (tmp_path / name).write_text("no picture")
    raster(tmp_path / "away.tif", photo, transform=(30.0, 0, 600000.0, 0, -30.0, 4000000.0))
    raster(tmp_path / "float.tif", photo.astype(np.float32))
    Image.fromarray(np.full((9, 9), 40000, np.uint16)).save(tmp_path / "deep.png")
    Image.fromarray(np.zeros((9, 9), np.uint8)).save(tmp_path / "black.png")
    Image.fromarray(np.full((1, 1), 90, np.uint8)).save(tmp_path / "dot.png")
    for name, message in faults.items():
        with pytest.raises((ValueError, FileNotFoundError), match=message) as caught:
            read_texture(tmp_path / name, land)
        assert "\n" not in str(caught.value)
    with pytest.raises(ValueError, match="mean reflectance must lie"):
        read_texture(tmp_path / "black.png", land, 1.5)


def test_land_with_a_texture_shows_it_and_has_its_mean_beyond_the_map(land, tmp_path):
    pytest.importorskip("numba")
    Image.fromarray(quarters()).save(tmp_path / "a.png")
    albedo, _ = read_texture(tmp_path / "a.png", land)
    flat = Elevation(np.zeros((60, 60)), 30.0, 30.0)
    sun = sd.direction(azimuth=180 * deg, elevation=60 * deg)
    sky = sd.Daylight(sd.Uniform(1000.0)) + sd.SunDisc(sun)
    down = {"above_ground": 50.0, "elevation": -85 * deg, "width": 4, "height": 4, "field_of_view": 5 * deg}
    seen = [
        render_terrain(flat, Camera(east=e, north=n, **down), sky, albedo=albedo, samples=1).rgb.mean(axis=(0, 1))
        for e, n in ((-500, 500), (500, 500), (-500, -500), (500, -500))
    ]
    same = [seen[k] / seen[3] for k in range(4)]
    wanted = [albedo[r, c] / albedo[-3, -3] for r, c in ((2, 2), (2, -3), (-3, 2), (-3, -3))]
    assert np.array(same) == pytest.approx(np.array(wanted), rel=0.02)
    far = Camera(
        east=-800, above_ground=400, azimuth=270 * deg, elevation=-20 * deg, width=4, height=4, field_of_view=5 * deg
    )
    beyond = render_terrain(flat, far, sky, albedo=albedo, samples=1).rgb.mean(axis=(0, 1))
    mean = albedo.mean(axis=(0, 1))
    assert beyond / beyond.sum() == pytest.approx(
        seen[3] * mean / albedo[-3, -3] / (seen[3] * mean / albedo[-3, -3]).sum(), rel=0.02
    )


def test_turned_elevation_is_refused(tmp_path):
    heights = np.zeros((1, 20, 20), np.float32)
    for name, transform in (
        ("up.tif", (30.0, 0, 500000.0, 0, 30.0, 4000000.0)),
        ("turned.tif", (21.0, 21.0, 500000.0, 21.0, -21.0, 4000000.0)),
    ):
        with pytest.raises(ValueError, match="must have north at the top"):
            read_elevation(raster(tmp_path / name, heights, transform=transform))


def test_command(tmp_path):
    pytest.importorskip("numba")
    from typer.testing import CliRunner

    from skydome.cli.main import app

    heights = np.random.default_rng(0).uniform(0, 50, (1, 60, 60)).astype(np.float32)
    raster(tmp_path / "land.tif", heights)
    Image.fromarray(quarters()).save(tmp_path / "photo.png")
    usual = ["terrain", str(tmp_path / "land.tif"), "--sun", "240,35", "--model", "preetham", "--turbidity", "4"]
    small = ["--size", "40,30", "--samples", "1", "--json", "-o", str(tmp_path / "p.png"), "--texture"]
    done = CliRunner().invoke(app, [*usual, *small, str(tmp_path / "photo.png")])
    assert done.exit_code == 0, done.output
    assert "texels stretched over the map" in " ".join(json.loads(done.stdout)["notes"])
    failed = CliRunner().invoke(app, [*usual, *small, str(tmp_path / "none.png")])
    assert failed.exit_code == 2
    assert "a texture must be a file that exists" in failed.output.replace("\n", " ")
