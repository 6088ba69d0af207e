"""Maps of spectra: Radiance's own programs find the sky's light in .hsr, OpenEXR its channels."""

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

import skydome as sd
from skydome.cli.main import app
from skydome.maps.equirectangular import Equirectangular

BANDS = np.arange(390.0, 711.0, 20.0)
SKY = sd.HosekWilkie(sd.direction(azimuth=2.0, elevation=0.6), turbidity=3.0)
DIRECTIONS = Equirectangular().directions(16)


def test_radiance_finds_the_luminance_and_the_colours(tmp_path):
    """`rmtxop` turns the picture into X, Y, Z: luminance within 1 % in all, chromaticity within .015."""
    folder = Path(pytest.importorskip("pyradiance").__file__).parent
    sd.save_spectra(SKY, tmp_path / "sky.hsr", BANDS, height=16)
    command = [folder / "bin" / "rmtxop", "-fa", "-c", "XYZ", tmp_path / "sky.hsr"]
    text = subprocess.run(
        command, capture_output=True, check=True, env={**os.environ, "RAYPATH": str(folder / "lib")}
    ).stdout
    theirs = np.array(text.partition(b"\n\n")[2].split(), dtype=float).reshape(16, 32, 3)
    luminance = SKY.luminance(DIRECTIONS)
    up = DIRECTIONS[..., 2] > 0
    np.testing.assert_allclose(theirs[up][:, 1], luminance[up], rtol=0.02)
    assert theirs[up][:, 1].sum() == pytest.approx(luminance[up].sum(), rel=0.01)
    ours = SKY.xyz(DIRECTIONS)[up]
    np.testing.assert_allclose(
        theirs[up] / theirs[up].sum(axis=-1, keepdims=True), ours / ours.sum(axis=-1, keepdims=True), atol=0.015
    )
    assert not theirs[~up].any()


def test_openexr_has_a_channel_for_each_wavelength(tmp_path):
    exr = pytest.importorskip("OpenEXR")
    sd.save_spectra(SKY, tmp_path / "sky.exr", [412.5, 550.0, 700.0], height=16)
    file = exr.File(str(tmp_path / "sky.exr"), separate_channels=True)
    light = SKY.radiance(DIRECTIONS, [412.5, 550.0, 700.0])
    for k, name in enumerate(("S0.412,5nm", "S0.550,0nm", "S0.700,0nm")):
        np.testing.assert_allclose(file.channels()[name].pixels, light[..., k], rtol=1e-6)
    assert file.header()["spectralLayoutVersion"] == "1.0"
    assert file.header()["emissiveUnits"] == "W.m^-2.sr^-1"
    np.testing.assert_allclose(file.channels()["R"].pixels, SKY.rgb(DIRECTIONS)[..., 0], rtol=1e-5)


def test_what_cannot_be_is_refused(tmp_path):
    for path, bands, words in (
        ("sky.png", BANDS, ".hsr or .exr"),
        ("sky.hsr", [400.0, 500.0, 700.0], "even bands"),
        ("sky.exr", [500.0, 400.0], "rising numbers"),
    ):
        with pytest.raises(ValueError, match=words):
            sd.save_spectra(SKY, tmp_path / path, bands)
    with pytest.raises(TypeError, match="SpectralSky"):
        sd.save_spectra(sd.Uniform(1000.0), tmp_path / "sky.hsr", BANDS)
    assert not list(tmp_path.iterdir())


def test_the_disc_is_left_out_with_a_word(tmp_path):
    """What is left out is told, and nothing of it is in the file."""
    disc = sd.SunDisc.of(SKY)
    light = float(sd.illuminance(disc))
    with pytest.warns(UserWarning, match=f"left out of a map of spectra: {light:,.6g} lx"):
        sd.save_spectra(SKY + disc, tmp_path / "both.hsr", BANDS, height=16)
    sd.save_spectra(SKY, tmp_path / "sky.hsr", BANDS, height=16)
    assert (tmp_path / "both.hsr").read_bytes() == (tmp_path / "sky.hsr").read_bytes()
    with pytest.raises(ValueError, match="of nothing else"):
        sd.save_spectra(disc, tmp_path / "disc.hsr", BANDS, height=16)


def test_many_skies_are_refused(tmp_path):
    suns = sd.direction(azimuth=[1.0, 2.0], elevation=[0.5, 0.6])
    many = sd.HosekWilkie(suns[:, None, :], turbidity=3.0)
    for sky in (many, many + sd.SunDisc.of(many)):
        with pytest.raises(ValueError, match="a map shows one sky at a time"):
            sd.save_spectra(sky, tmp_path / "sky.exr", BANDS, height=16)


def test_the_command_writes_spectra(tmp_path):
    sun = ("--place", "45,8", "--time", "2026-06-21T12:00Z", "--model", "hosek-wilkie", "--height", "16")
    words = ["render", *sun, "--wavelengths", "390,710,20", "--json", "-o"]
    for name in ("sky.hsr", "sky.exr"):
        result = CliRunner().invoke(app, [*words, str(tmp_path / name)])
        assert result.exit_code == 0, result.stderr
        facts = json.loads(result.stdout, parse_constant=pytest.fail)
        assert facts["wavelengths_nm"] == BANDS.tolist()
        assert facts["bytes"] == (tmp_path / name).stat().st_size
        assert any("disc is not in" in note for note in facts["notes"])
    assert b"NCOMP=17\n" in (tmp_path / "sky.hsr").read_bytes()[:200]
    for more, told in (("sky.hdr", ".hsr or .exr"), ("sky.hsr", "no --half")):
        result = CliRunner().invoke(app, [*words, str(tmp_path / more), *(["--half"] if "half" in told else [])])
        assert result.exit_code == 2
        assert told in result.stderr
