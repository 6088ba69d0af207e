"""Radiance's own makers of spectral skies, `genssky` and `gensdaymtx`, run beside ours.

They first compute an atmosphere for 90 seconds, unless its tables lie in `atmos_data`. So they get tables here: air of
one scattering coefficient everywhere, whose sky is a spectrum times the phase function of molecules. What is compared
is how they write light and how they take clouds; their own clear sky is compared in `benchmarks/genssky.py`.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

import skydome as sd
from skydome.dome.patches import patches
from skydome.ground.arrays import floating
from skydome.light.colour import xyz_from_xyY
from skydome.light.daylight import daylight_spectrum
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.sky import SunlitSky
from skydome.years.gendaymtx.text import read
from skydome.years.skies.overcast_light import overcast_spectra
from skydome.years.stores.spectral_matrix import write_spectral_matrix

WAVES = np.arange(390.0, 771.0, 20.0)
SPECTRUM = np.linspace(0.1, 0.3, 20)
AT = ("-a", 45, "-o", 0, "-m", 0)


@dataclass(frozen=True, eq=False)
class OfOneCoefficient(SunlitSky, SpectralSky):
    """The sky of those tables."""

    sun: Any

    def radiance(self, directions, wavelengths):
        cosine = np.asarray(floating(directions)) @ self.sun
        phase = 3 / (16 * np.pi) * (1 + cosine**2)
        return phase[..., None] * np.interp(wavelengths, WAVES, SPECTRUM)


def write_table(path, axes, values):
    """Radiance's data file of `values` (20,) at both ends of each of the other axes."""
    head = [f"{axes + 1}", *["0 1 2"] * axes, "0 19 20"]
    path.write_text("\n".join([*head, *(f"{value:.9e}" for value in np.tile(values, 2**axes))]) + "\n")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    place = tmp_path_factory.mktemp("spectral")
    tables = place / "atmos_data"
    tables.mkdir()
    for name, axes, values in (
        ("scat", 4, SPECTRUM), ("scat1m", 4, 0 * SPECTRUM), ("tau", 2, 1 + 0 * SPECTRUM), ("irrad", 2, 0 * SPECTRUM)
    ):  # fmt: skip
        write_table(tables / f"{name}_ms_mie_ca_0.12.dat", axes, values)
    return place


def read_hsr(path):
    """Header lines, values (rows, columns, bands) from short waves to long, and genssky's directions, (..., 3).

    The first and the last of its rows and columns lie on the edges of the map.
    """
    head, rest = path.read_bytes().split(b"\n\n", 1)
    line, pixels = rest.split(b"\n", 1)
    rows, columns = int(line.split()[1]), int(line.split()[3])
    bytes_of = np.frombuffer(pixels, np.uint8).reshape(rows, columns, -1)
    scale = np.ldexp(1.0, bytes_of[..., -1].astype(int) - 136)
    turn = (np.arange(columns) / (columns - 1) * 2 - 1) * np.pi  # 'Atan2(Dy,Dx)/PI+1', '1-Acos(Dz)/PI'
    height = np.cos(np.arange(rows) / (rows - 1) * np.pi)[:, None]
    level = np.sqrt(1 - height**2)
    towards = np.stack(np.broadcast_arrays(level * np.cos(turn), level * np.sin(turn), height), axis=-1)
    return head.decode().splitlines(), ((bytes_of[..., :-1] + 0.5) * scale[..., None])[..., ::-1], towards


def test_genssky_writes_a_sky_as_we_do(folder, run_radiance):
    scene = run_radiance("genssky", 6, 21, 10, "-y", 2020, *AT, "-r", 32, "-f", "clear", cwd=folder).stdout.decode()
    numbers = scene.split("solar source sun\n0\n0\n4 ")[1].split()[:3]
    sky = OfOneCoefficient(np.array(numbers, dtype=float))
    head, theirs, towards = read_hsr(folder / "clear_sky.hsr")
    sd.save_spectra(sky, folder / "ours.hsr", WAVES, height=32)
    ours, ours_read, _ = read_hsr(folder / "ours.hsr")
    assert [line for line in ours if "=" in line] == [line for line in head if "=" in line]
    assert "NCOMP=20" in head
    assert "WAVELENGTH_SPLITS= 780 588 480 380" in head
    assert ours_read.shape == (32, 64, 20)
    up = towards[..., 2] > 0.05
    light = sky.radiance(towards[up], WAVES) * 400  # genssky: spectral radiance times the 400 nm of its bands
    np.testing.assert_allclose(theirs[up] / light, 1.0, rtol=0.015)  # a byte a band
    factor = np.asarray(sky.luminance(towards[up])) / 179 / (light @ band_shares())
    assert factor == pytest.approx(683.002 * 106.857 / (179 * 400), rel=0.01)  # ours has the luminance: 2 % more


def band_shares():
    from skydome.light.radiance_bands import band_weights

    return band_weights(WAVES)


def test_genssky_s_overcast_spectrum(folder, run_radiance):
    """Theirs is CIE daylight of 6415 K; ours came through a layer of cloud, dim where gases absorb."""
    run_radiance("genssky", 6, 21, 12, "-y", 2020, *AT, "-r", 32, "-c", 1, "-f", "over", cwd=folder)
    _, theirs, towards = read_hsr(folder / "over_sky.hsr")
    spectra = theirs[towards[..., 2] > 0.2]
    shape = (spectra / spectra.mean(axis=1, keepdims=True)).mean(axis=0)
    x = 0.244063 + 0.09911 / 6.415 + 2.9678 / 6.415**2 - 4.6070 / 6.415**3  # CIE 15, eq. 4.5 and 4.7
    daylight = daylight_spectrum(xyz_from_xyY(np.array([x, -3 * x * x + 2.87 * x - 0.275, 1.0])), WAVES)
    cloud = overcast_spectra(sd.direction(0.0, np.array([45 * sd.deg])), WAVES)[0]
    for ours, most, rms in ((daylight, 0.04, 0.02), (cloud, 0.14, 0.06)):
        apart = shape / (ours / ours.mean()) - 1
        assert np.abs(apart).max() < most
        assert np.sqrt((apart**2).mean()) < rms


def test_gensdaymtx_has_our_layout_clouds_and_light(folder, greensboro, make_epw, run_radiance):
    row, header = make_epw
    day = greensboro.rows(slice(4008, 4032))
    ours = sd.year(day, colour="hosek-wilkie", wavelengths=np.arange(390.0, 711.0, 20.0), clouds=1.0)
    light = ours.diffuse_horizontal_illuminance.values
    rows = []
    for hour, (direct, diffuse) in enumerate(zip(*day.irradiances, strict=True), start=1):
        cells = row(6, 17, hour, 10.0, direct, diffuse).split(",")
        cells[17], cells[18], cells[22], cells[23], cells[29] = "0", f"{light[hour - 1]:.1f}", "10", "10", "0.12"
        rows.append(",".join(cells))
    facts = {"name": "site", "offset": day.utc_offset, **vars(day.place)}
    (folder / "day.epw").write_text(header.format(**facts) + "\n".join(rows) + "\n")
    (folder / "theirs.mtx").write_bytes(run_radiance("gensdaymtx", "-s", "-of", "day.epw", cwd=folder).stdout)
    write_spectral_matrix(ours, folder / "ours.mtx")
    theirs, told = read(folder / "theirs.mtx")
    mine, said = read(folder / "ours.mtx")
    assert (told["NROWS"], told["NCOLS"], told["NCOMP"]) == (said["NROWS"], said["NCOLS"], "20")
    assert told["WAVELENGTH_SPLITS"].split()[1:] == said["WAVELENGTH_SPLITS"].split()[1:]
    noon = slice(8, 18)
    grey = {}
    for name in ("theirs", "ours"):
        (folder / "grey.mtx").write_bytes(run_radiance("rmtxop", "-ff", "-c", "Y", folder / f"{name}.mtx").stdout)
        grey[name] = patches("tregenza").horizontal_solid_angles @ read(folder / "grey.mtx")[0][1:, noon, 0]
    np.testing.assert_allclose(grey["theirs"] / light[noon], 1.0, atol=0.02)
    np.testing.assert_allclose(grey["ours"] / light[noon], 1.0, atol=0.005)
    shared = theirs[1:, noon, 3:]  # from long waves to short: the 17 bands up to 720 nm
    ratio = (shared / shared.mean(axis=-1, keepdims=True)) / (
        mine[1:, noon] / mine[1:, noon].mean(axis=-1, keepdims=True)
    )
    assert np.abs(ratio - 1).max() < 0.15  # their daylight of 6415 K, our light through a cloud
    assert np.sqrt(((ratio - 1) ** 2).mean()) < 0.07
