"""Terrain: rays against brute force, light against closed form, files with every fault."""

import json

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.eye.view import Camera
from skydome.ground import exr
from skydome.haze.aerial_perspective import AirLight
from skydome.land.elevation import Elevation, without_holes
from skydome.land.picture import pyramid_of, render_terrain
from skydome.land.reading import read_elevation

pytest.importorskip("numba")
SUN = sd.direction(azimuth=240 * deg, elevation=35 * deg)


def sunny(turbidity=3.0):
    sky = sd.Preetham(SUN, turbidity)
    return sky + sd.SunDisc.of(sky)


def hills(seed=0, size=40):
    rng = np.random.default_rng(seed)
    return np.ascontiguousarray(rng.uniform(0, 300, (size, size + 7)))


def flat(size=30, cell=100.0):
    return Elevation(np.full((size, size), 50.0), cell, cell)


def test_march_finds_the_first_ground_like_brute_force():
    from skydome.land.rays_kernel import height_at, march

    heights = hills()
    pyramid, levels = pyramid_of(heights)
    rng = np.random.default_rng(1)
    hits = 0
    for _ in range(300):
        u, v, z = rng.uniform(1, 45), rng.uniform(1, 38), rng.uniform(305, 500)
        d = sd.unit(np.append(rng.normal(size=2), rng.uniform(-1.5, 0.05)))
        t = march(heights, pyramid, levels, u, v, z, d[0] / 50, -d[1] / 50, d[2], 1e9)
        steps = np.arange(0.0, 4000, 0.25)
        x, y = u + d[0] / 50 * steps, v - d[1] / 50 * steps
        inside = (x >= 0) & (y >= 0) & (x <= 46) & (y <= 39)
        under = [
            s
            for s, a, b in zip(steps[inside], x[inside], y[inside], strict=True)
            if height_at(heights, a, b) > z + d[2] * s
        ]
        if under:
            hits += 1
            assert t == pytest.approx(under[0], abs=0.26)
        else:
            assert t == -1 or t > steps[inside].max() - 0.3
    assert hits > 150


@pytest.mark.parametrize("elevation", [3.0, 35.0, 80.0])
@pytest.mark.parametrize("azimuth", [0.0, 90.0, 215.0], ids=["north", "east", "south-west"])
def test_shadows_soften_alike_across_and_along_the_sun(azimuth, elevation):
    """Shadow rays go to points even over the disc: variance R^2 / 4 along either tangent, none beyond R."""
    from skydome.ground.elementary_kernel import stirred
    from skydome.land.picture_kernel import point_on_sun
    from skydome.land.sky_light import sun_of

    sky = sd.Preetham(sd.direction(azimuth * deg, elevation * deg), 3.0)
    disc = sd.SunDisc.of(sky)
    sunlight = sun_of(sky + disc)
    sun, radius = sunlight[0], np.tan(disc.angular_radius)
    points = np.array([point_on_sun(sunlight, np.uint64(stirred(np.uint64(k)))) for k in range(20_000)])
    level = sd.direction((azimuth + 90) * deg, 0.0)
    across, upward, ahead = points @ level, points @ np.cross(sun, level), points @ sun
    np.testing.assert_allclose(ahead, 1, atol=1e-12)
    assert np.hypot(across, upward).max() == pytest.approx(radius, rel=1e-3)
    assert (across**2).mean() == pytest.approx(radius**2 / 4, rel=0.03)
    assert (upward**2).mean() == pytest.approx(radius**2 / 4, rel=0.03)
    assert abs((across * upward).mean()) < 0.01 * radius**2


def test_flat_ground_is_lit_as_the_sky_says():
    """Radiance = albedo / pi x the horizontal illuminance of sky and sun, by closed form."""
    sky = sunny()
    camera = Camera(above_ground=50, elevation=-80 * deg, width=8, height=8, field_of_view=10 * deg)
    picture = render_terrain(flat(), camera, sky, albedo=(0.3, 0.3, 0.3), samples=4)
    luminance = picture.rgb @ np.array([0.2126, 0.7152, 0.0722])
    assert luminance == pytest.approx(0.3 / np.pi * float(sd.illuminance(sky)), rel=0.02)
    centre = picture.depth[3:5, 3:5].mean()
    assert centre == pytest.approx(50 / np.sin(80 * deg), rel=0.01)


@pytest.mark.parametrize(("east", "share"), [(0.0, 0.0), (1600.0, 1.0)])
def test_clouds_dim_the_sun_over_the_land_place_by_place(east, share):
    """Radiance = albedo / pi x (skylight + share x sun), the share that of a ray from the place itself."""
    from skydome.skies.clouds.fields.shadows import sun_share

    field = sd.CloudField(cover=0.5, seed=7, place=(east, 0.0))
    sky, disc = sd.Daylight(sd.Uniform(3000.0)), sd.SunDisc(SUN, 3.0)
    above = Camera(above_ground=40, elevation=-89 * deg, width=2, height=2, field_of_view=2 * deg)
    picture = render_terrain(flat(), above, sky + disc, albedo=(0.3, 0.3, 0.3), samples=16, clouds=field)
    assert sun_share(field, SUN, np.zeros(3)) == pytest.approx(share, abs=1e-3)
    sunlight = float(disc.normal_xyz[1]) * SUN[2]
    got = (picture.rgb @ np.array([0.2126, 0.7152, 0.0722])).mean()
    assert got == pytest.approx(0.3 / np.pi * (3000 * np.pi + share * sunlight), rel=0.02)


def test_a_wall_shades_and_hides_the_sky():
    heights = np.zeros((60, 60))
    heights[:, :20] = 2000.0  # a cliff to the west; the sun stands in the west-southwest at 35 degrees
    land = Elevation(heights, 100.0, 100.0)
    sky = sunny()
    looks = {"azimuth": 90 * deg, "elevation": -80 * deg, "above_ground": 30, "width": 6, "height": 6}
    near = render_terrain(land, Camera(east=-700, **looks), sky, samples=4).rgb.mean()
    far = render_terrain(land, Camera(east=2800, **looks), sky, samples=4).rgb.mean()
    no_sun = render_terrain(land, Camera(east=2800, **looks), sd.Preetham(SUN, 3.0), samples=4).rgb.mean()
    assert far > 3 * near  # shadow
    assert 0.2 * no_sun < near < 0.95 * no_sun  # skylight only, and less of it under the cliff


def test_air_veils_what_is_far_and_leaves_what_is_near():
    sky = sunny(5.0)
    camera = Camera(above_ground=100, azimuth=20 * deg, width=60, height=40)
    bare, veiled = (render_terrain(flat(300), camera, sky, air, samples=4) for air in (None, AirLight(sky)))
    land = np.isfinite(bare.depth)
    change = np.abs(veiled.rgb - bare.rgb).mean(axis=-1) / bare.rgb.mean(axis=-1)
    assert np.corrcoef(np.log(bare.depth[land]), np.log(change[land]))[0, 1] > 0.9
    assert np.array_equal(veiled.rgb[~land], bare.rgb[~land])
    assert np.isfinite(veiled.rgb).all()
    from skydome.haze.aerial_perspective import aerial_perspective

    row = 30  # the kernel's air is the library's
    air = aerial_perspective(sky, bare.depth[row].astype(float), camera.directions(row, row + 1)[0], 100.0)
    assert veiled.rgb[row] == pytest.approx(air.seen(bare.rgb[row]), rel=0.03)


def test_pictures_repeat_and_are_finite_everywhere():
    land = Elevation(hills(), 200.0, 200.0)
    sky = sunny()
    camera = Camera(above_ground=60, azimuth=240 * deg, elevation=20 * deg, width=50, height=40)  # toward the sun
    pictures = [render_terrain(land, camera, sky, AirLight(sky), samples=4, curvature=True) for _ in range(2)]
    assert np.array_equal(pictures[0].rgb, pictures[1].rgb)
    assert np.isfinite(pictures[0].rgb).all()
    assert pictures[0].rgb.max() > 1e6  # the sun's disc is in the picture


@pytest.mark.parametrize("width", [40, 333])
def test_the_sun_in_the_picture_has_its_energy(width):
    from skydome.land.sky_light import background_of

    disc = sd.SunDisc(SUN, 3.0)
    camera = Camera(azimuth=230 * deg, elevation=30 * deg, width=width, height=width)
    image = background_of(disc, camera)
    solid_angle = camera.solid_angles()
    total = (image * solid_angle[..., None]).sum(axis=(0, 1)) @ np.array([0.2126, 0.7152, 0.0722])
    assert total == pytest.approx(float(disc.normal_xyz[1]), rel=4e-3)


def test_progress_and_files(tmp_path):
    seen = []
    camera = Camera(width=20, height=150, above_ground=100)
    picture = render_terrain(flat(), camera, sunny(), samples=1, progress=lambda done, rows: seen.append((done, rows)))
    assert seen[-1] == (150, 150)
    assert len(seen) > 1
    picture.save(tmp_path / "a.png")
    picture.save(tmp_path / "a.exr")
    import OpenEXR

    channels = OpenEXR.File(str(tmp_path / "a.exr"), separate_channels=True).channels()
    assert channels["Z"].pixels == pytest.approx(picture.depth)
    assert channels["R"].pixels == pytest.approx(picture.rgb[..., 0])
    stated = exr.header(tmp_path / "a.exr")
    assert stated["whiteLuminance"] == 1
    assert stated["chromaticities"] == pytest.approx(sd.SRGB.chromaticities)
    with pytest.raises(ValueError, match=r"must end in \.png or \.exr"):
        picture.save(tmp_path / "a.jpg")


def test_real_elevation_of_matplotlib():
    from matplotlib.cbook import get_sample_data

    land = read_elevation(get_sample_data("jacksboro_fault_dem.npz", asfileobj=False))
    assert land.heights.shape == (344, 403)
    assert land.dx == pytest.approx(74.4, abs=0.5)  # 3 seconds of arc at 36.6 degrees north
    assert land.dy == pytest.approx(92.7, abs=0.5)
    assert (land.heights.min(), land.heights.max()) == (236, 1076)
    fine = land.refined(2)
    assert fine.heights[::2, ::2] == pytest.approx(land.heights, abs=1.0)
    assert "smoothed" in fine.notes[-1]


def geotiff(path, heights, crs="EPSG:32617", transform=(30.0, 0, 500000.0, 0, -30.0, 4000000.0), **more):
    rasterio = pytest.importorskip("rasterio")
    from rasterio.transform import Affine

    profile = {
        "driver": "GTiff",
        "height": heights.shape[0],
        "width": heights.shape[1],
        "count": 1,
        "dtype": heights.dtype,
    }
    if crs:
        profile |= {"crs": crs, "transform": Affine(*transform)}
    units = more.pop("units", None)
    with rasterio.open(path, "w", **profile, **more) as file:
        file.write(heights, 1)
        if units:
            file.units = (units,)


@pytest.mark.filterwarnings("ignore::Warning:rasterio")
def test_geotiff_with_every_fault(tmp_path):
    heights = hills(size=50).astype(np.float32)
    geotiff(tmp_path / "good.tif", heights)
    good = read_elevation(tmp_path / "good.tif")
    assert (good.dx, good.dy) == (30.0, 30.0)
    assert good.heights == pytest.approx(heights)
    assert good.latitude == pytest.approx(36.1, abs=0.1)
    geotiff(tmp_path / "feet.tif", heights, units="ft")
    feet = read_elevation(tmp_path / "feet.tif")
    assert feet.heights == pytest.approx(heights * 0.3048, rel=1e-5)
    assert "feet" in feet.notes[-1]
    assert read_elevation(tmp_path / "good.tif", vertical_unit="ft").heights == pytest.approx(
        heights * 0.3048, rel=1e-5
    )
    holed = heights.copy()
    holed[10:20, 10:20] = -9999
    geotiff(tmp_path / "holes.tif", holed, nodata=-9999)
    filled = read_elevation(tmp_path / "holes.tif")
    assert filled.heights.min() >= heights.min() - 1
    assert "100 missing heights filled" in filled.notes[0]
    geotiff(tmp_path / "empty.tif", np.full_like(heights, -9999), nodata=-9999)
    with pytest.raises(ValueError, match=r"at most half .* may be missing, got 100 %"):
        read_elevation(tmp_path / "empty.tif")
    coarse = read_elevation(tmp_path / "good.tif", cells=700)
    assert coarse.heights.size <= 700
    assert "coarsened 3 times" in coarse.notes[0]
    assert coarse.heights.mean() == pytest.approx(heights.mean(), rel=0.05)
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        geotiff(tmp_path / "nowhere.tif", heights, crs=None)
    with pytest.raises(ValueError, match="no georeference"):
        read_elevation(tmp_path / "nowhere.tif")
    (tmp_path / "broken.tif").write_bytes(b"no tiff at all")
    with pytest.raises(ValueError, match="damaged or no GeoTIFF"):
        read_elevation(tmp_path / "broken.tif")


def test_ten_thousand_cells_a_side_are_coarsened_while_read(tmp_path):
    rasterio = pytest.importorskip("rasterio")
    from rasterio.transform import Affine

    profile = {"driver": "GTiff", "height": 10000, "width": 10000, "count": 1, "dtype": "uint8", "compress": "deflate"}
    path = tmp_path / "large.tif"
    with rasterio.open(path, "w", crs="EPSG:32617", transform=Affine(10, 0, 5e5, 0, -10, 4e6), **profile) as file:
        file.write(np.broadcast_to(np.uint8(7), (10000, 10000)), 1)
    land = read_elevation(path, cells=4_000_000)
    assert land.heights.shape == (2000, 2000)
    assert land.dx == pytest.approx(50)
    assert "coarsened 5 times" in land.notes[0]


def test_hgt_and_npz(tmp_path):
    heights = np.tile(np.arange(1201, dtype=">i2"), (1201, 1))
    heights[5, 5] = -32768
    heights.tofile(tmp_path / "S34E151.hgt")
    land = read_elevation(tmp_path / "S34E151.hgt")
    assert (land.latitude, land.longitude) == (-33.5, 151.5)
    assert land.heights[5, 5] == pytest.approx(5, abs=2)
    heights.tofile(tmp_path / "sydney.hgt")
    with pytest.raises(ValueError, match="named by its corner"):
        read_elevation(tmp_path / "sydney.hgt")
    heights[:7].tofile(tmp_path / "S34E152.hgt")
    with pytest.raises(ValueError, match="1201 x 1201 or 3601 x 3601"):
        read_elevation(tmp_path / "S34E152.hgt")
    np.savez(tmp_path / "bare.npz", elevation=hills())
    with pytest.raises(ValueError, match="it lacks dx, dy"):
        read_elevation(tmp_path / "bare.npz")
    with pytest.raises(FileNotFoundError, match="an elevation model must be a file that exists"):
        read_elevation(tmp_path / "none.tif")
    with pytest.raises(ValueError, match="must end in"):
        read_elevation(__file__)


def test_heights_that_cannot_be(tmp_path):
    """Voids that the file does not declare count as holes; files that hold none are refused in one line."""
    heights = hills(size=50).astype(np.float32)
    spoilt = heights.copy()
    spoilt[3, 3:6], spoilt[20, 20] = (-32768, -9999, 40000), -32767
    geotiff(tmp_path / "voids.tif", spoilt)
    land = read_elevation(tmp_path / "voids.tif")
    assert heights.min() <= land.heights.min()
    assert land.heights.max() <= heights.max()
    assert "4 missing heights filled" in land.notes[0]
    geotiff(tmp_path / "feet.tif", np.full((9, 9), 29000, np.float32), units="ft")  # Everest is no void
    assert read_elevation(tmp_path / "feet.tif").heights == pytest.approx(29000 * 0.3048)
    geotiff(tmp_path / "dot.tif", heights[:1, :1])
    (tmp_path / "empty.npz").write_bytes(b"")
    (tmp_path / "text.npz").write_text("no archive")
    np.save(tmp_path / "single.npy", heights)
    (tmp_path / "single.npy").rename(tmp_path / "single.npz")
    np.savez(tmp_path / "words.npz", elevation=np.full((3, 3), "high"), dx=1.0, dy=1.0)
    for name, message in (
        ("dot.tif", "must hold 2 x 2 heights or more, got 1 x 1"),
        ("empty.npz", r"damaged or not an elevation model"),
        ("text.npz", r"damaged or not an elevation model"),
        ("single.npz", "damaged or not an elevation model"),
        ("words.npz", "could not convert string to float"),
    ):
        with pytest.raises(ValueError, match=message):
            read_elevation(tmp_path / name)


def test_holes_filled_smoothly():
    slope = np.add.outer(np.arange(64.0), np.arange(64.0))
    hole = np.zeros((64, 64), bool)
    hole[20:30, 20:30] = True
    filled, notes = without_holes(np.where(hole, np.nan_to_num(slope) * 0, slope), hole)
    assert np.abs(filled - slope).max() < 16
    assert notes


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: Camera(above_ground=-5.0), "above_ground must lie in"),
        (lambda: Camera(width=0), r"width must lie in \[1, 16384\] pixels"),
        (lambda: Camera(field_of_view=3.1), "field of view must lie"),
        (lambda: render_terrain(flat(), Camera(east=1e6), sunny()), "camera must stand on the map"),
        (lambda: render_terrain(flat(), Camera(), sunny(), samples=15), "samples must be a square number"),
        (
            lambda: render_terrain(flat(), Camera(), sunny(), AirLight(sunny(), turbidity=[2, 3])),
            "air of one turbidity",
        ),
        (lambda: render_terrain(flat(), Camera(), sunny(), albedo=(2.0, 0, 0)), r"albedo must lie in \[0, 1\]"),
        (lambda: Elevation(np.array([[np.nan, 1.0], [1.0, 1.0]]), 1.0, 1.0), "heights must be finite"),
    ],
)
def test_bad_input(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_command(tmp_path):
    from typer.testing import CliRunner

    from skydome.cli.main import app

    np.savez(tmp_path / "land.npz", elevation=hills(), dx=100.0, dy=100.0)
    usual = ["terrain", str(tmp_path / "land.npz"), "--sun", "240,35", "--model", "preetham", "--turbidity", "4"]
    small = ["--size", "40,30", "--samples", "1", "--json"]
    done = CliRunner().invoke(app, [*usual, "-o", str(tmp_path / "p.png"), *small])
    assert done.exit_code == 0, done.output
    facts = json.loads(done.stdout)
    assert facts["cells"] == [40, 47]
    assert (tmp_path / "p.png").stat().st_size > 500
    for wrong, message in (
        (["-o", str(tmp_path / "p.jpg")], "must end in .png or .exr"),
        (["-o", str(tmp_path / "q.png"), "--camera", "0,0,-3"], "above_ground must lie in"),
        (
            ["-o", str(tmp_path / "q.png"), "--exposure", "0"],
            "an exposure must lie in [1e-15, 1e+09] per cd m-2",
        ),
        (["-o", str(tmp_path / "q.png"), "--size", "40.5,30"], "--size must be two whole numbers"),
    ):
        failed = CliRunner().invoke(app, [*usual, *small, *wrong])
        assert failed.exit_code == 2
        assert message in failed.output
