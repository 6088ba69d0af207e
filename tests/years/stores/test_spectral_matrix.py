"""A matrix of spectra as Radiance 6 reads it: its own conversion to luminance gives the year's."""

import numpy as np
import pytest

import skydome as sd
from skydome.light.radiance_bands import band_weights, splits_of
from skydome.years.gendaymtx.text import read
from skydome.years.stores.radiance_files import write_suns
from skydome.years.stores.spectral_matrix import write_spectral_matrix


@pytest.fixture(scope="module")
def day(greensboro):
    return sd.year(greensboro.rows(slice(4008, 4032)), colour="hosek-wilkie", wavelengths=np.arange(390.0, 711.0, 20.0))


@pytest.mark.parametrize("binary", [True, False])
def test_radiance_finds_the_years_luminance(day, tmp_path, run_radiance, binary):
    path = tmp_path / "spectra.mtx"
    write_spectral_matrix(day, path, binary)
    values, facts = read(path)
    assert values.shape == (146, 24, 17)
    assert facts["WAVELENGTH_SPLITS"].split() == ["720", "588", "480", "380"]
    grey = tmp_path / "grey.mtx"
    grey.write_bytes(run_radiance("rmtxop", "-ff", "-c", "Y", path).stdout)
    luminance = read(grey)[0][1:, :, 0].T
    np.testing.assert_allclose(luminance, day.luminance.values, rtol=0.01, atol=1.0)


def test_blue_skies_are_blue_in_its_colours(day, tmp_path, run_radiance):
    path, colours = tmp_path / "spectra.mtx", tmp_path / "xyz.mtx"
    write_spectral_matrix(day, path)
    colours.write_bytes(run_radiance("rmtxop", "-ff", "-c", "XYZ", path).stdout)
    xyz = read(colours)[0][1:].transpose(1, 0, 2)
    lit = (day.luminance.values > 100) & (day.luminance.values < 1e5)
    theirs, ours = (values[lit] / values[lit].sum(axis=-1, keepdims=True) for values in (xyz, day.xyz.values))
    np.testing.assert_allclose(theirs, ours, atol=0.015)


def test_the_sun_shines_in_bands_from_its_patch(day, tmp_path, run_radiance):
    found = {}
    for name, choice in (("sky", False), ("both", True)):
        path, grey = tmp_path / f"{name}.mtx", tmp_path / f"{name}.grey"
        write_spectral_matrix(day, path, with_sun=choice)
        grey.write_bytes(run_radiance("rmtxop", "-ff", "-c", "Y", path).stdout)
        found[name] = read(path)[0], read(grey)[0][1:, :, 0].T
    more = found["both"][1] - found["sky"][1]
    hours = np.flatnonzero(day.direct_normal_illuminance.values > 100)
    where = day.sun_patch.values[hours]
    of_sun = day.direct_normal_illuminance.values[hours] / day.solid_angle.values[where]
    np.testing.assert_allclose(more[hours, where], of_sun, rtol=0.01)
    assert np.count_nonzero(np.abs(more) > 1.0) == np.count_nonzero(day.direct_normal_illuminance.values > 0)
    bands = (found["both"][0] - found["sky"][0])[1:].transpose(1, 0, 2)[hours, where][:, ::-1]
    spectra = day.direct_normal_spectral_irradiance.values[hours]
    same = bands / bands.sum(axis=1, keepdims=True) / (spectra / spectra.sum(axis=1, keepdims=True))
    np.testing.assert_allclose(same, 1.0, rtol=2e-3)


def test_rtrace_has_the_suns_spectra(day, tmp_path, run_radiance):
    scene, octree = tmp_path / "suns.rad", tmp_path / "suns.oct"
    count = write_suns(day, scene)
    octree.write_bytes(run_radiance("oconv", scene).stdout)
    sampling = ("-cs", 17, "-cw", 380, 720, "-co+")
    direct = ("-h", "-I", "-ab", 0, "-dt", 0, "-dc", 1, "-ds", 0)
    text = run_radiance("rtrace", *direct, *sampling, octree, input=b"0 0 0 0 0 1\n").stdout
    values = np.array(text.split(), dtype=float)[::-1]
    sine = np.maximum(np.sin(np.radians(day.sun_elevation.values)), 0)
    shining = (day.direct_normal_illuminance.values > 0) & (sine > 0)
    assert count == shining.sum()
    spectrum = day.direct_normal_spectral_irradiance.values[shining].T @ sine[shining]
    np.testing.assert_allclose(values / values.mean(), spectrum / spectrum.mean(), rtol=5e-3)
    light = float(day.direct_normal_illuminance.values[shining] @ sine[shining])
    assert values @ band_weights(day.wavelength.values) * 179 == pytest.approx(light, rel=5e-3)


def test_what_cannot_be_is_refused(day, greensboro, tmp_path):
    with pytest.raises(ValueError, match="even bands"):
        splits_of(np.array([400.0, 420.0, 450.0, 500.0]))
    with pytest.raises(ValueError, match="year with spectra"):
        write_spectral_matrix(sd.year(greensboro.rows(slice(0, 24))), tmp_path / "x.mtx")
    assert splits_of(np.array([600.0, 610.0, 620.0, 630.0])) == pytest.approx((635, 621.667, 608.333, 595), abs=1e-3)
