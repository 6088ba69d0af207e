"""The air's parts: cross sections against their sources, profiles, phase laws, atmospheres that cannot be."""

import numpy as np
import pytest

from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Aerosol, Molecules, Ozone
from skydome.air.cross_sections import (
    depolarisation,
    ozone_cross_section,
    rayleigh_cross_section,
    rayleigh_depth,
    solar_irradiance,
)
from skydome.air.phase_laws import CornetteShanks, Haze, HenyeyGreenstein, PhaseLaw, Rayleigh
from skydome.air.profiles import OZONE_LAYER, Exponential, Tabulated
from skydome.air.series.legendre_series import LegendreSeries
from skydome.ground.tables import columns
from skydome.light.spectrum import Spectrum

LAWS = [Rayleigh(), Rayleigh(0.0279), HenyeyGreenstein((0.85, 0.6), (0.4, 0.6)), CornetteShanks(0.7), Haze()]
LAWS.append(LegendreSeries([450.0, 650.0], np.stack([0.8 ** np.arange(200), 0.7 ** np.arange(200)], axis=-1)))
W = [400.0, 550.0, 700.0]


@pytest.mark.parametrize("law", LAWS, ids=repr)
def test_phase_laws_integrate_to_one(law):
    t, w = np.polynomial.legendre.leggauss(400)
    angle = np.pi * (t + 1) / 2
    total = (w * np.pi / 2 * 2 * np.pi * np.sin(angle)) @ law.value(np.cos(angle), W)
    np.testing.assert_allclose(total, 1.0, rtol=2e-6)


@pytest.mark.parametrize("law", LAWS, ids=repr)
def test_moments_rebuild_the_phase_law(law):
    cosine = np.cos(np.radians([20.0, 60.0, 120.0, 179.0]))
    moments = law.moments(200, W)
    series = np.polynomial.legendre.legval(cosine, (2 * np.arange(200) + 1)[:, None] * moments).T / (4 * np.pi)
    np.testing.assert_allclose(series, law.value(cosine, W), rtol=2e-3)


def test_exact_moments_agree_with_quadrature():
    law = HenyeyGreenstein((0.9, -0.3), (0.7, 0.3))
    np.testing.assert_allclose(law.moments(40, W), PhaseLaw.moments(law, 40, W), atol=1e-9)


def test_rayleigh_against_penndorf_and_spectrl2():
    table = columns("penndorf_1957")
    per_metre = rayleigh_cross_section(table["wavelength_nm"]) * 2.6868e25  # molecules per m3 at 0 C (Penndorf 1957)
    np.testing.assert_allclose(per_metre[:45], table["coefficient"][:45], rtol=0.02)  # 810-830 nm are a straight line
    micrometres = np.array([0.35, 0.45, 0.55, 0.7])
    spectrl2 = 1 / (
        micrometres**4 * (115.6406 - 1.335 / micrometres**2)
    )  # Leckner 1978, Bird and Riordan 1986, eq. 2-4
    np.testing.assert_allclose(rayleigh_depth(1000 * micrometres), spectrl2, rtol=0.02)


def test_golden_numbers():
    assert rayleigh_depth([550.0])[0] == pytest.approx(0.0971, abs=2e-4)  # Bodhaine et al. 1999, Table 3 interpolated
    assert depolarisation([550.0])[0] == pytest.approx(0.0279, abs=5e-4)  # Young 1980
    assert ozone_cross_section([605.0])[0] == pytest.approx(
        5.0e-25, rel=0.03
    )  # the peak of Chappuis's bands, 5e-21 cm2
    assert ozone_cross_section([320.0])[0] == pytest.approx(2.98e-24, rel=0.01)  # 0.8 per cm (Leckner 1978)
    assert np.trapezoid(solar_irradiance(np.arange(400, 701.0)), dx=1) == pytest.approx(532, rel=0.01)


def test_profiles_agree_with_quadrature():
    for profile in (Exponential(1500.0), OZONE_LAYER, Tabulated((0.0, 1000.0, 4000.0), (3.0, 1.0, 0.0))):
        heights = np.linspace(0, 80_000, 400_001)
        density = profile.density(heights)
        assert np.trapezoid(density, heights) == pytest.approx(1, abs=1e-4)
        above = 1 - np.concatenate([[0], np.cumsum((density[1:] + density[:-1]) / 2 * np.diff(heights))])
        np.testing.assert_allclose(profile.above(heights), above, atol=2e-4)


def test_slant_depth_is_the_secant_far_from_the_horizon_and_chapmans_on_it():
    flat = Atmosphere((Molecules(),), radius=6.371e11)
    np.testing.assert_allclose(flat.slant_depths(0.5, W), 2 * flat.depth(W), rtol=1e-5)
    round_ = Atmosphere((Molecules(profile=Exponential(8000.0)),), height=200_000.0)
    horizon = np.sqrt(np.pi * 6_371_000 / 2 / 8000) * (1 + 3 / 8 * 8000 / 6_371_000)  # Chapman 1931: the grazing limit
    np.testing.assert_allclose(round_.slant_depths(0.0, W) / round_.depth(W), horizon, rtol=1e-3)


def test_turbidity_means_what_preetham_means():
    for turbidity in (1.0, 2.5, 10.0):
        air = Atmosphere.from_turbidity(turbidity, ozone=0.0)
        assert air.depth([550.0])[0] / rayleigh_depth([550.0])[0] == pytest.approx(turbidity, rel=1e-12)


def test_brunetons_air_has_his_depths():
    air = Atmosphere.bruneton2016()
    molecules, aerosol = (part.depth([550.0])[0] for part in air.constituents)
    assert molecules == pytest.approx(12.26e-6 * 273.16 / 288.16 * 8000, rel=1e-6)
    assert aerosol == pytest.approx(0.04 * 0.55**-0.8, rel=1e-6)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: Atmosphere.standard(aerosol_depth=-0.1), "optical_depth must lie in .* got -0.1"),
        (lambda: Atmosphere.standard(albedo=1.2), r"albedo must lie in \[0, 1\], got 1.2"),
        (lambda: Atmosphere.standard(asymmetry=1.0), "asymmetry must lie in .-0.999999, 0.999999., got 1"),
        (lambda: Atmosphere.standard(aerosol_albedo=1.5), r"albedo must lie in \[0, 1\], got 1.5"),
        (lambda: CornetteShanks(-1.0), r"asymmetry must lie in \(-1, 1\), got -1"),
        (lambda: HenyeyGreenstein((0.5,), (-1.0,)), "weights must not be negative"),
        (lambda: Tabulated((0.0, 1.0), (1.0, -1.0)), "densities must be finite, not negative"),
        (lambda: Tabulated((1.0, 0.0), (1.0, 1.0)), "heights must increase"),
        (lambda: Exponential(0.0), r"scale_height must lie in \(0, 1e6\) m, got 0"),
        (lambda: Molecules(pressure=float("nan")), "pressure must lie in .* Pa, got nan"),
        (lambda: Ozone(-1.0), "column must lie in"),
        (lambda: Atmosphere(()), "at least one constituent"),
        (lambda: Atmosphere(radius=0.0), "radius must lie in"),
        (lambda: Atmosphere.from_turbidity(0.5), r"turbidity must lie in \[1, 64\], got 0.5"),
        (lambda: Aerosol(Spectrum([400.0, 500.0], [0.1, -0.1])), "optical_depth must lie in"),
        (lambda: solar_irradiance([200.0]), r"wavelengths must lie in \[290, 3950\] nm"),
    ],
)
def test_air_that_cannot_be_is_refused(call, message):
    with pytest.raises(ValueError, match=message) as caught:
        call()
    assert "\n" not in str(caught.value)


def test_eltermans_haze():
    """Its column at 340 nm is .38 as published with it; near the ground it falls by e in Preetham's 1.2 km."""
    from skydome.air.profiles import ELTERMAN

    assert ELTERMAN.column / 1000 == pytest.approx(0.38, abs=0.01)
    low = ELTERMAN.density(np.array([0.0, 1000.0]))
    assert 1000 / np.log(low[0] / low[1]) == pytest.approx(1200, rel=0.03)
    assert ELTERMAN.above(0.0) == pytest.approx(1.0)
    assert ELTERMAN.above(10_000.0) == pytest.approx(0.12, abs=0.03)
