"""The spectral mismatch of photovoltaic cells: pvlib's on the same spectra, and near its models of whole spectra."""

import numpy as np
import pandas as pd
import pytest
from pvlib import atmosphere
from pvlib import spectrum as pv

import skydome as sd
from skydome import deg
from skydome.light.spectrum import Spectrum
from skydome.years.metrics.spectral_mismatch import mismatch_on_planes, spectra_on_planes, spectral_mismatch

WAVES = np.concatenate([np.arange(300.0, 1100.0, 20.0), np.arange(1100.0, 2501.0, 50.0)])
SILICON = pv.get_example_spectral_response()
CELL = Spectrum(SILICON.index.to_numpy(), SILICON.to_numpy())
CLEAR_DAY, COVERED_DAY = 62, 132


def of_day(greensboro, day, clouds=None):
    skies = sd.year(
        greensboro.rows(slice(24 * day + 6, 24 * day + 20)), colour="physical", wavelengths=WAVES, turbidity=2.5,
        clouds=clouds,
    )  # fmt: skip
    return skies, sd.on_planes(skies, [sd.Plane(0.0), sd.Plane(35 * deg, 180 * deg)])


@pytest.fixture(scope="module")
def clear(greensboro):
    return of_day(greensboro, CLEAR_DAY)


@pytest.fixture(scope="module")
def covered(greensboro):
    return of_day(greensboro, COVERED_DAY, clouds=1.0)


def test_it_is_pvlibs_on_the_same_spectra(clear):
    skies, light = clear
    lit = light.irradiance.values[:, 1] > 20
    ours = mismatch_on_planes(light, skies, CELL).values[lit, 1]
    theirs = pv.calc_spectral_mismatch_field(
        SILICON, pd.DataFrame(spectra_on_planes(light, skies)[lit, 1], columns=WAVES)
    )
    np.testing.assert_allclose(ours, theirs.to_numpy(), rtol=1e-12)
    assert np.isnan(mismatch_on_planes(light, skies, CELL).values[~lit, 0]).any()


def test_the_reference_has_no_mismatch():
    table = pv.get_reference_spectra()["global"]
    assert float(spectral_mismatch(table.to_numpy(), table.index.to_numpy(), CELL)) == pytest.approx(1.0, abs=1e-12)


def test_clear_hours_are_near_pvlibs_models(clear):
    """First Solar's model knows water and air mass, Caballero's aerosol too; the air of both has ours."""
    skies, light = clear
    height = skies.sun_elevation.values
    high = height > 15
    mass = atmosphere.get_relative_airmass(90 - height[high]) * 0.97
    ours = mismatch_on_planes(light, skies, CELL).values[high, 1]
    np.testing.assert_allclose(ours, pv.spectral_factor_firstsolar(1.42, mass, "monosi"), atol=0.02)
    np.testing.assert_allclose(ours, pv.spectral_factor_caballero(1.42, mass, 0.15, "monosi"), atol=0.02)


def test_the_spectrum_has_the_energy_that_was_measured(clear, covered):
    """Levels come from illuminance; over 300-2500 nm light is then near the file's, sun above 15 degrees."""
    for (skies, light), width in ((clear, 0.08), (covered, 0.10)):
        lit = (light.irradiance.values[:, 1] > 20) & (skies.sun_elevation.values > 15)
        whole = np.trapezoid(spectra_on_planes(light, skies)[lit, 1], WAVES)
        np.testing.assert_allclose(whole / light.irradiance.values[lit, 1], 1.0, atol=width)


def test_what_cannot_be_is_refused(greensboro):
    skies = sd.year(greensboro.rows(slice(8, 20)))
    with pytest.raises(ValueError, match="year with wavelengths"):
        spectra_on_planes(sd.on_planes(skies, sd.Plane()), skies)
