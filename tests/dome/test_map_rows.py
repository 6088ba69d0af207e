"""Maps told by rows: the pixels and the files of maps that are held, bit by bit, in little memory."""

import tracemalloc

import numpy as np
import pytest

import skydome as sd
from skydome.dome import painting
from skydome.ground import exr
from skydome.ground.limits.sizes import granting
from skydome.maps.by_rows import light_in_file, map_rows
from skydome.maps.files import save

SUN = sd.direction(azimuth=2.3, elevation=0.05)
HAZE = sd.HosekWilkie(SUN, turbidity=6.0)
SKIES = {
    "formula": HAZE + sd.SunDisc.of(HAZE),
    "two": HAZE + 0.5 * sd.Preetham(SUN, turbidity=3.0),
    "network": sd.NeuralSky.load("hosek-wilkie", SUN, turbidity=3.0),
    "physical": sd.PhysicalSky(SUN) + sd.SunDisc.of(HAZE),
    "cie": sd.Daylight(sd.CIE(SUN, 12, illuminance=12_000.0)),
    "night": sd.Stars.over(sd.Place(45, 7), "2026-06-21T23:00Z"),
}
LAYOUTS = {"latlong": None, "square": sd.target("pbrt").projection, "fisheye": sd.target("fisheye").projection}


@pytest.fixture
def small_blocks(monkeypatch):
    """64 rows, the least, at a time."""
    monkeypatch.setattr(map_rows, "TEXELS", 1)
    monkeypatch.setattr(light_in_file, "TEXELS_IN_WORK", 1)


@pytest.mark.parametrize("layout", LAYOUTS)
@pytest.mark.parametrize("name", SKIES)
def test_rows_are_those_of_the_whole_map(name, layout, monkeypatch):
    """Blocks of 64 rows and one block of all: the sun's texels, stars and the horizon fall into one or between two.

    The physical sky takes few directions another way than many, to 2e-4: there both maps have the same blocks.
    """
    made = sd.render_rows(SKIES[name], 136, projection=LAYOUTS[layout])
    assert len(made.parts()) == 1
    if name == "physical" and layout != "latlong":
        monkeypatch.setattr(map_rows, "TEXELS", 1)
    whole = sd.render(SKIES[name], 136, projection=LAYOUTS[layout]).pixels
    monkeypatch.setattr(map_rows, "TEXELS", 1)
    blocks = list(made.blocks())
    assert [len(block) for block in blocks] == [64, 64, 8]
    np.testing.assert_array_equal(np.concatenate(blocks), whole)


@pytest.mark.parametrize(
    ("name", "choices"),
    [
        ("a.exr", {}),
        ("a.exr", {"half": True}),
        ("a.exr", {"gamut": "none"}),
        ("a.hdr", {"white_luminance": 1e3}),
        ("a.png", {}),
        ("a.exr", {"target": "pbrt", "height": 80}),
    ],
)
def test_files_are_those_of_the_whole_map(tmp_path, small_blocks, name, choices):
    """Byte by byte; the exposure of a picture, and that colours were moved, are known when all rows have been seen."""
    held = sd.render(SKIES["formula"], 136, space=sd.SRGB, metadata={"title": "dawn"})
    held.save(tmp_path / f"held-{name}", **choices)
    steps = []
    made = sd.render_rows(SKIES["formula"], 136, metadata={"title": "dawn"})
    save(made, tmp_path / name, **choices, report=lambda *rows: steps.append(rows))
    assert (tmp_path / name).read_bytes() == (tmp_path / f"held-{name}").read_bytes()
    assert steps[-1] == ((80, 80) if "height" in choices else (136, 136))
    assert len(list(tmp_path.iterdir())) == 2


@pytest.mark.parametrize("half", [False, True])
def test_strips_make_the_file_that_openexr_makes(tmp_path, small_blocks, half):
    """Also where the last rows alone lie outside the RGB space, so that the header grows when all else is written."""
    pixels = sd.render(SKIES["formula"], 136).pixels
    pixels[130, 5] = -1.0, 5.0, 2.0
    sd.EnvironmentMap(pixels).save(tmp_path / "rows.exr", half=half)
    seen, header = exr.read(tmp_path / "rows.exr")
    assert header["skydome:gamut"] == "colours outside the RGB space moved toward its white, luminance kept"
    kept = {k: v for k, v in header.items() if k == "whiteLuminance" or (isinstance(v, str) and k != "type")}
    kept["chromaticities"] = tuple(sd.SRGB.chromaticities)
    exr.write(tmp_path / "whole.exr", {"RGB": seen}, kept, half, latlong=True)
    assert (tmp_path / "rows.exr").read_bytes() == (tmp_path / "whole.exr").read_bytes()


@pytest.mark.parametrize(("name", "choices"), [("a.exr", {}), ("a.hdr", {}), ("a.png", {"exposure": 1e-5})])
def test_little_memory(tmp_path, small_blocks, monkeypatch, name, choices):
    """Less than the map would take alone, although this one is small."""
    monkeypatch.setattr(painting, "CHUNK", 1 << 13)
    sky = sd.render_rows(sd.HosekWilkie(SUN, turbidity=3.0), 512)
    tracemalloc.start()
    sky.save(tmp_path / name, **choices)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 512 * 1024 * 12


def test_what_cannot_be_is_refused_and_leaves_nothing(tmp_path, small_blocks):
    made = sd.render_rows(SKIES["formula"], 136)
    with pytest.raises(ValueError, match=r"half floats end at 65504, got .*; 1000 holds it"):
        made.save(tmp_path / "a.exr", half=True, white_luminance=1.0)
    dark = sd.render_rows(-1.0 * SKIES["cie"], 136)
    with pytest.raises(ValueError, match=r"must be above 0 somewhere, got none for a\.hdr"):
        dark.save(tmp_path / "a.hdr")
    with pytest.raises(ValueError, match="at most 2147483648 texels in a map"):
        sd.render_rows(SKIES["cie"], 1 << 16)
    with granting(1 << 20), pytest.raises(ValueError, match="would take"):
        sd.render_rows(SKIES["cie"], 512)
    assert list(tmp_path.iterdir()) == []
