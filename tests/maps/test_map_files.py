"""Maps as files: units, place, time and provenance come back; bad files and failed writing leave one clear line."""

import os
import tracemalloc
from datetime import datetime, timedelta, timezone

import numpy as np
import pytest

from skydome.ground import exr, hdr, png
from skydome.ground.writing import appearing
from skydome.light.colour import ACESCG, RADIANCE, REC2020, SRGB
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.loading import load, space_of, stated_projection
from skydome.maps.projections import CubeMap, EqualAreaSquare, Equirectangular, Equisolid, Fisheye

FACTS = {
    "latitude": 45.07, "longitude": 7.69, "altitude": 240, "time": "2026-06-21T15:00+02:00",
    "model": "HosekWilkie", "version": "0.1.0", "turbidity": 3.0, "ground": "albedo .2\nLambertian",
}  # fmt: skip


def sky(height=32, peak=1.6e9, dtype=np.float32, **changes):
    pixels = 3000 * np.random.default_rng(1).random((height, 2 * height, 3))
    pixels[5, 7] = peak
    return EnvironmentMap(pixels.astype(dtype), **{"metadata": FACTS, **changes})


def one_line(caught):
    assert "\n" not in str(caught.value)
    return str(caught.value)


def test_exr_keeps_pixels_and_header(tmp_path):
    original = sky()
    original.save(tmp_path / "sky.exr", target="openexr")
    pixels, header = exr.read(tmp_path / "sky.exr", finite=True)
    np.testing.assert_array_equal(pixels, original.pixels)
    assert header["whiteLuminance"] == 1
    assert header["latitude"] == pytest.approx(45.07)
    assert header["longitude"] == pytest.approx(7.69)
    assert header["altitude"] == 240
    assert header["capDate"] == "2026:06:21 15:00:00"
    assert header["utcOffset"] == -7200
    assert header["envmap"].name == "ENVMAP_LATLONG"
    np.testing.assert_allclose(header["chromaticities"], [0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329], rtol=1e-6)
    assert header["skydome:model"] == "HosekWilkie"
    assert header["skydome:turbidity"] == 3
    assert header["skydome:target"] == "openexr"
    assert header["skydome:orientation"] == "y up; south (+Z) at the centre; texel centres"
    assert header["compression"].name == "ZIP_COMPRESSION"


@pytest.mark.parametrize("space", [SRGB, REC2020, ACESCG, RADIANCE], ids=lambda space: space.name)
@pytest.mark.parametrize("suffix", [".exr", ".hdr"])
def test_a_map_comes_back(suffix, space, tmp_path):
    original = sky(space=space, white_luminance=2.5)
    original.save(tmp_path / f"sky{suffix}", target="blender")
    back = load(tmp_path / f"sky{suffix}", target="blender")
    assert back.space == space
    tolerance = 1e-6 if suffix == ".exr" else 4e-3
    np.testing.assert_allclose(
        back.resampled(Equirectangular()).luminance(), original.luminance(), rtol=tolerance, atol=30
    )
    np.testing.assert_allclose(back.illuminance(), original.illuminance(), rtol=tolerance)
    assert back.metadata["latitude"] == pytest.approx(45.07)
    assert back.metadata["model"] == "HosekWilkie"
    if suffix == ".exr":
        assert back.metadata["time"] == datetime(2026, 6, 21, 15, tzinfo=timezone(timedelta(hours=2)))
    back.save(tmp_path / "again.exr")
    assert exr.read(tmp_path / "again.exr")[1]["skydome:target"] in ("blender", "three")


def test_half_floats_have_one_scale_for_all_files(tmp_path):
    """Frames of a day must not jump: 100,000 cd m-2, whether the sun is in the map or not; another by choice."""
    original = sky(dtype=np.float64, white_luminance=2.0)
    for name, picture in (("sky", original), ("dim", sky(peak=60000.0))):
        picture.save(tmp_path / f"{name}.exr", half=True)
        header = exr.read(tmp_path / f"{name}.exr", finite=True)[1]
        assert header["whiteLuminance"] == 1e5
        back = load(tmp_path / f"{name}.exr").luminance()
        np.testing.assert_allclose(back, picture.luminance(), rtol=1e-3, atol=0.05)
    sky(peak=60000.0).save(tmp_path / "own.exr", half=True, white_luminance=1.0)
    assert exr.read(tmp_path / "own.exr")[1]["whiteLuminance"] == 1
    for suffix in (".exr", ".hdr"):
        sky().save(tmp_path / f"own{suffix}", white_luminance=500.0)
        assert load(tmp_path / f"own{suffix}").white_luminance == pytest.approx(500.0)
        assert float(load(tmp_path / f"own{suffix}").illuminance()) == pytest.approx(
            float(sky().illuminance()), rel=5e-3
        )


def test_half_floats_that_would_lose_light_are_refused(tmp_path):
    with pytest.raises(ValueError, match="must not exceed 65504 in this file, got 65505"):
        exr.write(tmp_path / "no.exr", {"RGB": np.full((2, 4, 3), 65505.0)}, half=True)
    with pytest.raises(ValueError, match=r"half floats end at 65504, got 1.6e.06 .*; 100000 holds it"):
        sky().save(tmp_path / "no.exr", half=True, white_luminance=1000.0)
    with pytest.raises(ValueError, match=r"too coarse for light of at most 0.003 cd m-2 .*; 1e-07 suits it"):
        EnvironmentMap(sky(peak=1.0).pixels * 1e-6).save(tmp_path / "no.exr", half=True)
    assert not os.listdir(tmp_path)


def test_only_maps_seen_from_inside_claim_to_be_latlong(tmp_path):
    for number, layout in enumerate([Equirectangular(mirrored=True), CubeMap(), Fisheye()]):
        EnvironmentMap(np.ones((*layout.shape(12), 3)), layout).save(tmp_path / f"{number}.exr")
        assert "envmap" not in exr.read(tmp_path / f"{number}.exr")[1]


def test_tokyo_and_utc_times(tmp_path):
    for time, date, offset in [
        ("2026-06-21T15:00+09:00", "2026:06:21 15:00:00", -32400),
        (np.datetime64("2026-06-21T06:00"), "2026:06:21 06:00:00", 0),
        (datetime(2026, 1, 2, 3, 4, 5, tzinfo=timezone(timedelta(hours=-5))), "2026:01:02 03:04:05", 18000),
    ]:
        sky(metadata={"time": time}).save(tmp_path / "sky.exr")
        header = exr.read(tmp_path / "sky.exr")[1]
        assert (header["capDate"], header["utcOffset"]) == (date, offset)
    with pytest.raises(ValueError, match="time must have a UTC offset, got 2026-06-21T15:00:00"):
        sky(metadata={"time": "2026-06-21T15:00"}).save(tmp_path / "naive.exr")
    assert not (tmp_path / "naive.exr").exists()


def test_failing_writing_leaves_what_was_there(tmp_path):
    path = tmp_path / "sky.exr"
    path.write_bytes(b"before")

    def write_half_of_it():
        with appearing(path) as beside:
            beside.write_bytes(b"half")
            raise RuntimeError("the disc is full")

    with pytest.raises(RuntimeError, match="disc is full"):
        write_half_of_it()
    bad = np.full((4, 8, 3), np.nan)
    for write, pixels in ((exr.write, {"RGB": bad}), (hdr.write, bad), (png.write, bad)):
        with pytest.raises(ValueError, match="finite"):
            write(path, pixels)
    with pytest.raises(TypeError):
        exr.write(path, {"RGB": np.zeros((4, 8, 3))}, header={"model": object()})
    assert path.read_bytes() == b"before"
    assert os.listdir(tmp_path) == ["sky.exr"]


def test_headers_are_told_without_the_pixels(tmp_path):
    """A file cut off behind its header still tells what it is."""
    sky().save(tmp_path / "sky.exr")
    sky().save(tmp_path / "sky.hdr")
    whole, (rows, columns) = exr.header(tmp_path / "sky.exr"), exr.size(exr.header(tmp_path / "sky.exr"))
    assert exr.read(tmp_path / "sky.exr")[0].shape == (rows, columns, 3)
    assert whole["skydome:projection"] == repr(sky().projection)
    stated, size = hdr.header(tmp_path / "sky.hdr")
    assert size == (rows, columns)
    assert stated == hdr.read(tmp_path / "sky.hdr")[1]
    data = (tmp_path / "sky.hdr").read_bytes()
    (tmp_path / "cut.hdr").write_bytes(data[: data.index(b"+X") + 20])
    assert hdr.header(tmp_path / "cut.hdr") == (stated, size)
    with pytest.raises(ValueError, match="expected an OpenEXR file"):
        exr.header(tmp_path / "sky.hdr")


def test_depth_may_be_infinite_and_light_may_not(tmp_path):
    light, depth = np.ones((2, 4, 3)), np.full((2, 4), np.inf)
    exr.write(tmp_path / "deep.exr", {"RGB": light, "Z": depth})
    assert exr.read(tmp_path / "deep.exr")[0].tolist() == light.tolist()
    for channels in ({"RGB": light * np.inf, "Z": depth}, {"RGB": light, "Z": depth * np.nan}):
        with pytest.raises(ValueError, match="finite"):
            exr.write(tmp_path / "deep.exr", channels)


def test_written_files_have_the_usual_permissions(tmp_path):
    (tmp_path / "plain").write_text("")
    sky().save(tmp_path / "sky.hdr")
    assert (tmp_path / "sky.hdr").stat().st_mode == (tmp_path / "plain").stat().st_mode


@pytest.mark.parametrize("suffix", [".exr", ".hdr", ".png"])
def test_places_that_cannot_be_written(suffix, tmp_path):
    with pytest.raises(FileNotFoundError, match="the folder to write to must exist") as caught:
        sky().save(tmp_path / "missing" / f"sky{suffix}")
    one_line(caught)
    (tmp_path / f"folder{suffix}").mkdir()
    with pytest.raises(IsADirectoryError, match="must not be a folder") as caught:
        sky().save(tmp_path / f"folder{suffix}")
    one_line(caught)


def test_wrong_requests(tmp_path):
    for request, words in [
        ({"path": "sky.tiff"}, r"must end in \.exr, \.hdr, \.png, got 'sky.tiff'"),
        ({"path": "sky.hdr", "half": True}, r"half floats exist in \.exr alone"),
        (
            {"path": "sky.png", "white_luminance": 2.0},
            r"white luminance goes with \.exr and \.hdr alone, got 'sky.png'",
        ),
        ({"path": "sky.exr", "exposure": 2.0}, r"exposure goes with \.png alone, got 'sky.exr'"),
        ({"path": "sky.exr", "white_luminance": 0.0}, r"white luminance must lie in \[1e-12, 1e\+12\] cd m-2, got 0"),
        (
            {"path": "sky.exr", "white_luminance": 1e45},
            r"white luminance must lie in \[1e-12, 1e\+12\] cd m-2, got 1e\+45",
        ),
        ({"path": "sky.hdr", "white_luminance": 1e-13}, r"white luminance must lie in \[1e-12, 1e\+12\] cd m-2"),
        ({"path": "sky.exr", "gamut": "clip"}, "gamut must be one of white, none, got 'clip'"),
        ({"path": "sky.exr", "target": "maya"}, "target must be one of"),
        ({"path": "sky.exr", "target": "cube", "height": 100}, "multiple of 6"),
        ({"path": "sky.exr", "height": 33}, "multiple of 2"),
    ]:
        with pytest.raises(ValueError, match=words) as caught:
            sky().save(tmp_path / request.pop("path"), **request)
        one_line(caught)
    assert not os.listdir(tmp_path)


def test_the_outermost_whites_come_back(tmp_path):
    for ending in (".exr", ".hdr"):
        for white in (1e-12, 1e12):
            sky().save(tmp_path / f"sky{ending}", white_luminance=white)
            back = load(tmp_path / f"sky{ending}").luminance()
            np.testing.assert_allclose(back.max(), sky().luminance().max(), rtol=0.01)


def damaged_copies(good: bytes):
    rng = np.random.default_rng(2)
    yield b""
    yield b"hello"
    yield good[:4]
    for cut in (20, 100, 300, len(good) // 2, len(good) - 3):
        yield good[:cut]
    for _ in range(30):
        garbled = bytearray(good)
        for place in rng.integers(0, min(len(good), 400), 3):
            garbled[place] = rng.integers(0, 256)
        yield bytes(garbled)


def complaint_of(read, path):
    """The error's text, None where the file is read; any other error than ValueError goes through."""
    try:
        read(path, max_bytes=1 << 22)
    except ValueError as error:
        return str(error)
    return None


@pytest.mark.parametrize(("suffix", "read"), [(".exr", exr.read), (".hdr", hdr.read)])
def test_damaged_files_are_refused_in_one_line(suffix, read, tmp_path):
    sky().save(tmp_path / f"good{suffix}")
    good = (tmp_path / f"good{suffix}").read_bytes()
    path = tmp_path / f"bad{suffix}"
    for number, content in enumerate(damaged_copies(good)):
        path.write_bytes(content)
        complaint = complaint_of(read, path)
        assert complaint is not None or number > 7, "a file cut short was read"
        assert "\n" not in (complaint or "")
        assert path.name in (complaint or path.name)


def test_huge_headers_are_refused_before_memory_is_taken(tmp_path):
    path = tmp_path / "huge.hdr"
    path.write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 400000 +X 30000\n\x02\x02")
    with pytest.raises(ValueError, match="pixels must take at most") as caught:
        hdr.read(path)
    one_line(caught)
    path.write_bytes(b"#?RADIANCE\n\n-Y 10000 +X 10000\n\x02\x02")
    with pytest.raises(ValueError, match="needs more than the 32 bytes"):
        hdr.read(path)
    sky().save(tmp_path / "sky.exr")
    with pytest.raises(ValueError, match="pixels must take at most 1000 bytes, got 64 x 32"):
        exr.read(tmp_path / "sky.exr", max_bytes=1000)


def test_exr_without_rgb_and_with_nan(tmp_path):
    import OpenEXR

    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, {"Y": np.ones((4, 8), dtype=np.float32)}).write(str(tmp_path / "grey.exr"))
    with pytest.raises(ValueError, match="channels R, G and B are needed, got Y"):
        exr.read(tmp_path / "grey.exr")
    planes = {name: np.full((4, 8), np.nan, dtype=np.float32) for name in "RGBA"}
    OpenEXR.File(header, planes).write(str(tmp_path / "nan.exr"))
    assert np.isnan(exr.read(tmp_path / "nan.exr")[0]).all()
    with pytest.raises(ValueError, match="pixels must be finite"):
        load(tmp_path / "nan.exr")


def test_primaries_of_files():
    assert space_of(None, RADIANCE, "PRIMARIES", "a.hdr") == RADIANCE
    assert space_of([0.7, 0.3, 0.2, 0.7, 0.1, 0.1, 0.3, 0.3], SRGB, "PRIMARIES", "a.hdr").green == (0.2, 0.7)
    with pytest.raises(ValueError, match="must be eight numbers, got 3"):
        space_of([1.0, 2.0, 3.0], SRGB, "PRIMARIES", "a.hdr")


PROJECTIONS = [
    Equirectangular(azimuth_left=1.0, mirrored=True), CubeMap(), EqualAreaSquare(), Fisheye(2.0, Equisolid()),
]  # fmt: skip


@pytest.mark.parametrize("suffix", [".exr", ".hdr"])
@pytest.mark.parametrize("layout", PROJECTIONS, ids=repr)
def test_the_header_tells_the_layout(layout, suffix, tmp_path):
    """What saving wrote is read back, so that nobody need say it again; a contradiction is refused."""
    path = tmp_path / f"sky{suffix}"
    EnvironmentMap(np.ones((*layout.shape(24), 3)), layout).save(path)
    assert load(path).projection == layout
    with pytest.raises(ValueError, match=r"says that its layout is .*, got blender; leave that out") as caught:
        load(path, "blender")
    one_line(caught)


def test_layouts_that_are_the_same_do_not_contradict_and_silent_files_are_as_told(tmp_path):
    sky().save(tmp_path / "sky.exr", target="usd")
    assert load(tmp_path / "sky.exr", "mitsuba").projection == Equirectangular()
    exr.write(tmp_path / "bare.exr", {"RGB": sky().pixels})
    assert load(tmp_path / "bare.exr").projection == Equirectangular()
    assert load(tmp_path / "bare.exr", "blender").projection.azimuth_left == 1.5 * np.pi
    for words in ("__import__('os')", "Equirectangular(1, 2)", "Path(x=1)", "1 +"):
        assert stated_projection({"skydome:projection": words}) is None


def test_a_target_that_reads_one_space_gets_it(tmp_path):
    """Mitsuba takes every number as Rec.709's: the light of an ACEScg map is turned into that."""
    grey = EnvironmentMap(np.full((4, 8, 3), [1.0, 2.0, 3.0]), space=ACESCG)
    grey.save(tmp_path / "sky.exr", target="mitsuba")
    back = load(tmp_path / "sky.exr")
    assert back.space == SRGB
    np.testing.assert_allclose(back.pixels @ SRGB.to_xyz.T, grey.pixels @ ACESCG.to_xyz.T, rtol=1e-6)
    grey.save(tmp_path / "sky.exr", target="blender")
    assert load(tmp_path / "sky.exr").space == ACESCG


@pytest.mark.parametrize("target", ["three"])
def test_three_gets_half_floats_and_their_scale(target, tmp_path):
    """Its loaders end at 65504, in .exr and .hdr: one scale, stated, keeps every texel below."""
    import OpenEXR

    for suffix in (".exr", ".hdr"):
        sky().save(tmp_path / f"sky{suffix}", target=target)
        back = load(tmp_path / f"sky{suffix}")
        assert back.pixels.max() < 65504
        assert back.white_luminance == pytest.approx(1e5)
        assert float(back.illuminance()) == pytest.approx(float(sky().illuminance()), rel=5e-3)
    assert OpenEXR.File(str(tmp_path / "sky.exr")).channels()["RGB"].pixels.dtype == np.float16


def test_colours_outside_the_space_move_toward_white(tmp_path):
    original = sky()
    original.pixels[3, 4] = [4e4, 1.5e4, -1.7e4]
    for suffix in (".exr", ".hdr"):
        original.save(tmp_path / f"sky{suffix}")
        back = load(tmp_path / f"sky{suffix}")
        assert back.pixels.min() >= 0
        tolerance = {".exr": 1e-6, ".hdr": 8e-3}[suffix]
        np.testing.assert_allclose(back.luminance()[3, 4], original.luminance()[3, 4], rtol=tolerance)
        assert "moved toward its white" in back.metadata["gamut"]
    inside = np.ones((32, 64), bool)
    inside[3, 4] = False
    np.testing.assert_array_equal(load(tmp_path / "sky.exr").pixels[inside], original.pixels[inside])
    original.save(tmp_path / "sky.exr", gamut="none")
    np.testing.assert_array_equal(load(tmp_path / "sky.exr").pixels, original.pixels)


def test_light_below_zero_is_told_or_refused(tmp_path):
    """A difference of skies is light below 0 where the other is brighter: black in files, which must not be silent."""
    pixels = np.full((8, 16, 3), -2330.0, np.float32)
    for name in ("sky.exr", "sky.hdr", "sky.png"):
        with pytest.raises(
            ValueError, match="the light of a map must be above 0 somewhere, got none for sky"
        ) as caught:
            EnvironmentMap(pixels).save(tmp_path / name)
        assert one_line(caught)
        assert not (tmp_path / name).exists()
    EnvironmentMap(pixels).save(tmp_path / "kept.exr", gamut="none")
    np.testing.assert_array_equal(load(tmp_path / "kept.exr").pixels, pixels)
    pixels[:4] = 100.0
    with pytest.warns(UserWarning, match="50.00% of the texels have light below 0, black in half.hdr"):
        EnvironmentMap(pixels).save(tmp_path / "half.hdr")
    EnvironmentMap(np.zeros_like(pixels)).save(tmp_path / "night.exr")


@pytest.mark.parametrize(
    ("name", "choices", "most"),
    [("a.exr", {}, 0.5), ("a.exr", {"half": True}, 0.6), ("a.hdr", {}, 0.55), ("a.png", {}, 0.7)],
)
def test_a_map_is_written_some_rows_at_a_time(tmp_path, name, choices, most):
    """Beside its own memory a few times an eighth of a map of that size, whatever a larger one's."""
    rows = np.random.default_rng(3).random((1024, 1, 3), dtype=np.float32) - np.float32(0.02)
    image = EnvironmentMap(np.ascontiguousarray(np.broadcast_to(100 * rows, (1024, 2048, 3))))
    tracemalloc.start()
    image.save(tmp_path / name, target="native", **choices)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < most * image.pixels.nbytes
    assert image.pixels.min() < 0  # the map itself stays as it is
