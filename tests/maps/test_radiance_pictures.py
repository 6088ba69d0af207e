"""Radiance pictures: our own code against Radiance's programs, mitsuba and the format's description."""

import subprocess
from pathlib import Path

import numpy as np
import pytest

from skydome.ground import hdr
from skydome.ground.hdr import decode_rgbe, encode_rgbe
from skydome.light.colour import RADIANCE
from skydome.maps.environment_map import EnvironmentMap


@pytest.mark.parametrize("columns", [4, 8, 127, 128, 129, 300])
def test_rgbe_scanlines_come_back_within_half_a_step(columns, tmp_path):
    rng = np.random.default_rng(columns)
    pixels = 10 ** rng.uniform(-30, 30, (5, columns, 1)) * rng.random((5, columns, 3))
    pixels[0, 0] = 0
    hdr.write(tmp_path / "x.hdr", pixels, {"EXPOSURE": 2.0, "note": "two\nlines"})
    back, header = hdr.read(tmp_path / "x.hdr")
    assert (np.abs(back - pixels) <= pixels.max(axis=-1, keepdims=True) / 255).all()
    assert (back[0, 0] == 0).all()
    assert (header["EXPOSURE"], header["note"]) == ("2.0", "two lines")


def test_rgbe_is_unbiased_and_clamps_negatives():
    values = np.random.default_rng(3).uniform(0.5, 1, (200, 200, 3))
    assert np.mean(decode_rgbe(encode_rgbe(values)) / values) == pytest.approx(1, abs=1e-4)
    assert (encode_rgbe(np.array([[[-1.0, -2.0, -3.0]]])) == 0).all()
    with pytest.raises(ValueError, match=r"below 2\^127"):
        encode_rgbe(np.full((1, 1, 3), 1e39))


def test_run_length_coded_files_of_others_are_read(tmp_path):
    head = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\nEXPOSURE=.5\n\n-Y 1 +X 8\n"
    line = bytes([2, 2, 0, 8, 128 + 8, 10, 3, 1, 2, 3, 128 + 5, 4, 8, *range(8), 128 + 8, 136])
    (tmp_path / "x.hdr").write_bytes(head + line)
    pixels, header = hdr.read(tmp_path / "x.hdr")
    assert header["EXPOSURE"] == "1.0"
    np.testing.assert_allclose(pixels[0, :, 0], 10.5)
    np.testing.assert_allclose(pixels[0, :, 1], np.array([1, 2, 3, 4, 4, 4, 4, 4]) + 0.5)
    np.testing.assert_allclose(pixels[0, :, 2], np.arange(8) + 0.5)


def radiance_program(name):
    pyradiance = pytest.importorskip("pyradiance")
    return str(Path(pyradiance.__file__).parent / "bin" / name)


@pytest.mark.slow
@pytest.mark.parametrize("columns", [200, 6])
def test_radiance_reads_our_pictures(columns, tmp_path):
    """Radiance's own pvalue gives our values; mitsuba's reader agrees but for the half step that it leaves out."""
    pixels = np.random.default_rng(4).random((10, columns, 3)) * 100 + 1
    hdr.write(tmp_path / "x.hdr", pixels)
    command = [radiance_program("pvalue"), "-h", "-H", "-d", str(tmp_path / "x.hdr")]
    seen = np.loadtxt(subprocess.run(command, capture_output=True, check=True, text=True).stdout.splitlines())
    stored, _ = hdr.read(tmp_path / "x.hdr")
    np.testing.assert_allclose(seen.reshape(10, columns, 3), stored, rtol=2e-3)
    mi = pytest.importorskip("mitsuba")
    mi.set_variant("scalar_rgb")
    theirs = np.array(mi.Bitmap(str(tmp_path / "x.hdr")), dtype=np.float32)
    assert (np.abs(theirs - pixels) <= pixels.max(axis=-1, keepdims=True) / 127).all()


@pytest.mark.slow
def test_radiance_sees_our_luminance(tmp_path):
    """pvalue -b gives Radiance's brightness after -o undoes EXPOSURE: times 179 our cd m-2, in Radiance's primaries."""
    pixels = 3000 * np.random.default_rng(5).random((32, 64, 3)).astype(np.float32)
    original = EnvironmentMap(pixels, space=RADIANCE)
    original.save(tmp_path / "x.hdr")
    command = [radiance_program("pvalue"), "-h", "-H", "-d", "-b", "-o", str(tmp_path / "x.hdr")]
    seen = np.loadtxt(subprocess.run(command, capture_output=True, check=True, text=True).stdout.splitlines())
    np.testing.assert_allclose(seen.reshape(32, 64) * 179, original.luminance(), rtol=8e-3, atol=5000 / 256)


@pytest.mark.parametrize(
    ("head", "words"),
    [
        (b"#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 4 +X 8\n", "FORMAT must be 32-bit_rle_rgbe"),
        (b"#?RADIANCE\n\n+X 8 -Y 4\n", "the size must read -Y rows"),
        (b"#?RADIANCE\n\n-Y 0 +X 8\n", "must have rows and columns"),
        (b"#?RADIANCE\nEXPOSURE=much\n\n-Y 4 +X 8\n", "EXPOSURE must be a positive number"),
        (b"P6 4 8\n\n", "expected a Radiance picture"),
    ],
)
def test_other_radiance_headers(head, words, tmp_path):
    path = tmp_path / "odd.hdr"
    path.write_bytes(head + b"\0" * 128)
    with pytest.raises(ValueError, match=words) as caught:
        hdr.read(path)
    assert "\n" not in str(caught.value)


def test_radiances_own_lines_are_never_folded(tmp_path):
    """A VIEW line in two is no view: evalglare measured 661 lx for 5,171."""
    view, note = "rvu -vta -vd " + 40 * "0.123 ", 200 * "x"
    hdr.write(tmp_path / "a.hdr", np.ones((2, 8, 3)), {"VIEW": view, "skydome:note": note})
    lines = (tmp_path / "a.hdr").read_bytes().split(b"\n\n")[0].decode().splitlines()
    assert f"VIEW={view.strip()}" in lines
    assert max(len(line) for line in lines if not line.startswith("VIEW")) <= hdr.LONGEST_LINE
    assert hdr.header(tmp_path / "a.hdr")[0]["skydome:note"] == note
