"""A matrix of spectra as Radiance 6 reads it: its own conversion to luminance gives the year's."""

import numpy as np
import pytest

import skydome as sd
from skydome.light.radiance_bands import splits_of
from skydome.years.gendaymtx.text import read
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


def test_what_cannot_be_is_refused(day, greensboro, tmp_path):
    with pytest.raises(ValueError, match="even bands"):
        splits_of(np.array([400.0, 420.0, 450.0, 500.0]))
    with pytest.raises(ValueError, match="year with spectra"):
        write_spectral_matrix(sd.year(greensboro.rows(slice(0, 24))), tmp_path / "x.mtx")
    assert splits_of(np.array([600.0, 610.0, 620.0, 630.0])) == pytest.approx((635, 621.667, 608.333, 595), abs=1e-3)
