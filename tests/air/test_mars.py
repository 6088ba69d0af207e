"""The air of Mars: its gas and dust against their sources, and a sky the colours that rovers measured."""

import numpy as np
import pytest

import skydome as sd
from skydome.air.cross_sections import (
    bodhaine,
    carbon_dioxide_cross_section,
    carbon_dioxide_king_factor,
    king_factor,
    solar_irradiance,
)
from skydome.ground.tables import archive

WAVELENGTHS = np.arange(400.0, 701.0, 50.0)


def chromaticity(sky, azimuth, elevation):
    xyz = sky.xyz(sd.direction(np.asarray(azimuth) * sd.deg, np.asarray(elevation) * sd.deg))
    return xyz[..., :2] / xyz.sum(axis=-1, keepdims=True)


def test_carbon_dioxide_scatters_as_its_refractive_index_says():
    # against the air's molecules: (n - 1)^2 and King's factor, n - 1 at 15 C, 1013.25 hPa: air 2.778e-4 (Peck and
    # Reeder 1972), carbon dioxide 4.27e-4, at 550 nm
    got = carbon_dioxide_cross_section([550.0])[0] / (bodhaine([550.0])[0] * 1e-32)
    expected = (4.27e-4 / 2.778e-4) ** 2 * carbon_dioxide_king_factor([550.0])[0] / king_factor([550.0])[0]
    assert got == pytest.approx(expected, rel=0.01)
    power = np.log(np.divide(*carbon_dioxide_cross_section([400.0, 700.0]))) / np.log(400 / 700)
    assert -4.25 < power < -4.0  # a little steeper than the fourth power: dispersion


def test_gas_is_thin_and_dust_is_flat():
    gas, dust = sd.Atmosphere.mars().constituents
    molecules = 636 / (43.34e-3 / 6.02214076e23 * 3.73)  # per m2
    np.testing.assert_allclose(gas.depth(WAVELENGTHS), carbon_dioxide_cross_section(WAVELENGTHS) * molecules, rtol=2e-3)
    assert dust.depth([550.0])[0] == 0.5
    assert np.ptp(dust.depth([450.0, 670.0])) < 0.03  # Smith and Lemmon 1999: the same in all filters
    # Wolff et al. 2009: blue is absorbed
    np.testing.assert_allclose(dust.scattered([440.0, 550.0, 700.0]), [0.793, 0.905, 0.976], atol=1e-3)
    np.testing.assert_allclose(sd.Atmosphere.mars().sun_at([550.0]), solar_irradiance([550.0]) / 1.524**2)


def test_dust_s_phase_function_is_mies_for_the_tables_albedo():
    pytest.importorskip("miepython")
    table = archive("mars_dust")
    law = sd.Atmosphere.mars().constituents[1].phase_law
    angles = np.cos(np.radians([0.0, 3.0, 20.0, 60.0, 110.0, 170.0]))
    relative = []
    for k in (1, 6, 10):  # 440, 550 and 700 nm
        wavelength = table["wavelength_nm"][k]
        seen = sd.MieParticles(sd.GammaSizes(1.5e-6, 0.25), 1.5, table["absorption_index"][k]).optics([wavelength])
        relative.append(seen.extinction[0])
        assert seen.albedo[0] == pytest.approx(table["albedo"][k], abs=2e-3)
        np.testing.assert_allclose(
            law.value(angles, [wavelength]), seen.phase_law.value(angles, [wavelength]), rtol=0.02
        )
        assert seen.asymmetry[0] == pytest.approx(table["asymmetry"][k], rel=0.07)  # spheres against Wolff's particles
    # the size that was assumed gives Wolff's extinctions
    np.testing.assert_allclose(np.array(relative) / relative[1], table["extinction"][[1, 6, 10]], rtol=0.012)


def test_phase_functions_integrate_to_one():
    nodes, weights = np.polynomial.legendre.leggauss(1000)
    law = sd.Atmosphere.mars().constituents[1].phase_law
    np.testing.assert_allclose(2 * np.pi * weights @ law.value(nodes, WAVELENGTHS), 1, atol=1e-6)


@pytest.mark.parametrize("elevation", [20.0, 50.0])
def test_the_day_is_yellowish_brown_and_blue_about_the_sun(elevation):
    # Maki et al. 1999: the sky is a yellowish brown, redder away from the sun; Ehlers et al. 2014: bluish near it
    pytest.importorskip("nanodisort")
    sky = sd.DiscreteOrdinates(sd.direction(180 * sd.deg, elevation * sd.deg), sd.Atmosphere.mars())
    far, near = chromaticity(sky, 0.0, 40.0), chromaticity(sky, 180.0, elevation + 1.0)
    assert 0.37 < far[0] < 0.43
    assert 0.36 < far[1] < 0.40
    assert near[0] < 0.3
    assert (far[0] - 0.3127) * (near[0] - 0.3127) < 0  # on the two sides of white


def test_a_setting_sun_stands_in_blue():
    sky = sd.Nishita96(sd.direction(270 * sd.deg, 2 * sd.deg), sd.Atmosphere.mars())
    near, beside, opposite = chromaticity(sky, [270.0, 270.0, 90.0], [3.0, 22.0, 20.0])
    assert near[0] < 0.30
    assert near[0] < beside[0] < opposite[0]


def test_without_dust_the_sky_is_dark_and_blue():
    clear, dusty = (sd.Nishita96(sd.direction(0.0, 0.8), sd.Atmosphere.mars(depth)) for depth in (0.0, 0.5))
    assert clear.luminance(sd.ZENITH) < 0.1 * dusty.luminance(sd.ZENITH)
    assert chromaticity(clear, 180.0, 60.0)[0] < 0.26


@pytest.mark.parametrize(
    ("choices", "message"),
    [
        ({"dust_depth": -0.1}, "dust_depth must lie in .*, got -0.1"),
        ({"pressure": float("nan")}, "pressure must lie in .* Pa, got nan"),
        ({"albedo": 1.5}, r"albedo must lie in \[0, 1\], got 1.5"),
    ],
)
def test_air_that_cannot_be(choices, message):
    with pytest.raises(ValueError, match=message):
        sd.Atmosphere.mars(**choices)
