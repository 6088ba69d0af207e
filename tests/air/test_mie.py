"""Mie theory over sizes: against miepython's own single spheres, Rayleigh's limit, and Preetham's printed table."""

import sys

import numpy as np
import pytest

import skydome as sd
from skydome.air.mie import MieParticles, coefficients, phase_moments
from skydome.air.series.legendre import series_sum
from skydome.air.series.legendre_series import LegendreSeries
from skydome.air.size_distributions import GammaSizes, Junge, Lognormal, SizeDistribution
from skydome.ground.tables import columns
from skydome.light.spectrum import Spectrum

mie = pytest.importorskip("miepython")
NODES, WEIGHTS = np.polynomial.legendre.leggauss(2000)
ANGLES = np.cos(np.radians([0.0, 5.0, 30.0, 60.0, 90.0, 120.0, 150.0, 180.0]))
SIZES = [Lognormal(0.1e-6, 1.8), Junge(4.0), GammaSizes(1.5e-6, 0.25)]


@pytest.mark.parametrize("x", [0.01, 1.0, 10.0, 100.0])
@pytest.mark.parametrize("index", [1.33, 1.5 - 0.01j, 2.5 - 1j])
def test_one_sphere_is_miepythons(x, index):
    moments = phase_moments(*coefficients(complex(index), np.array([x])), np.array([1.0]))[0]
    expected = mie.i_unpolarized(index, x, ANGLES, norm="one")
    np.testing.assert_allclose(series_sum(moments[:, None], ANGLES)[:, 0], expected, rtol=1e-6)
    assert moments[1] == pytest.approx(mie.efficiencies_mx(index, x)[3], abs=1e-9)


@pytest.mark.parametrize("sizes", SIZES, ids=str)
def test_a_mixture_is_the_sum_of_its_spheres(sizes):
    # the same sizes one by one, by miepython's efficiencies and intensities
    radius, share = sizes.nodes(60)
    extinction = scattering = 0.0
    seen = np.zeros(ANGLES.size)
    for r, n in zip(radius, share, strict=True):
        x = 2 * np.pi * r / 550e-9
        there = mie.efficiencies_mx(1.5 - 0.004j, x)
        extinction += n * there[0] * np.pi * r**2
        scattering += n * there[1] * np.pi * r**2
        seen += n * there[1] * np.pi * r**2 * mie.i_unpolarized(1.5 - 0.004j, x, ANGLES, norm="one")
    ours = MieParticles(sizes, 1.5, 0.004, count=60).optics([550.0])
    assert ours.extinction[0] == pytest.approx(extinction, rel=1e-9)
    assert ours.albedo[0] == pytest.approx(scattering / extinction, rel=1e-9)
    np.testing.assert_allclose(series_sum(ours.moments, ANGLES)[:, 0], seen / scattering, rtol=1e-6)


@pytest.mark.parametrize("sizes", SIZES, ids=str)
def test_phase_functions_integrate_to_one(sizes):
    law = MieParticles(sizes, 1.5, 0.01).optics([400.0, 500.0, 700.0]).phase_law
    wavelengths = [380.0, 450.0, 650.0, 750.0]  # between and beyond the known ones too
    total = 2 * np.pi * WEIGHTS @ law.value(NODES, wavelengths)
    np.testing.assert_allclose(total, 1, atol=1e-6)
    assert law.value(NODES, wavelengths).min() > 0
    assert law.value(np.zeros((2, 3)), wavelengths).shape == (2, 3, 4)


def test_preethams_table_is_mie_theory():
    """Table 1 is index 1.5, radii 0.04-10 um, dn = 0.434 c r^-5 dr: eta = 2 beta(theta) / (0.434 c k^2), K as well."""
    table = columns("preetham_1999_table_1")
    wavelengths = np.array([400.0, 450.0, 550.0, 650.0, 850.0])
    haze = Junge(4.0, 0.04e-6, 10e-6)
    seen = MieParticles(haze).optics(wavelengths)
    number = (haze.smallest**-4 - haze.largest**-4) / 4  # particles per 0.434 c
    square = (2 * np.pi / (wavelengths * 1e-9)) ** 2
    phase = seen.phase_law.value(np.cos(np.radians(table["theta_deg"])), wavelengths)
    eta = 2 * phase * seen.scattering * number / square
    printed = np.stack([table[f"{w:.0f}"] for w in wavelengths], axis=-1)
    off = np.abs(eta / printed - 1)
    assert off[:-1].max() < 2e-3
    assert off[-1].max() < 0.012  # straight back, where the sum over sizes converges last
    second = columns("preetham_1999_table_2")
    seen = MieParticles(haze).optics(second["wavelength_nm"][::8])
    square = (2 * np.pi / (seen.wavelengths * 1e-9)) ** 2
    np.testing.assert_allclose(seen.scattering * number / (np.pi * square), second["K"][::8], rtol=6e-3)  # 3 digits


def test_small_particles_scatter_as_molecules():
    small = MieParticles(GammaSizes(2e-9, 0.05), 1.5).optics([400.0, 800.0])
    assert small.scattering[0] / small.scattering[1] == pytest.approx(16, rel=2e-3)
    np.testing.assert_allclose(small.moments[:3, 0], [1, 0, 0.1], atol=2e-3)


def test_large_particles_shade_twice_their_area():
    radius = 20e-6
    drops = MieParticles(GammaSizes(radius, 0.02), 1.33, 1e-4).optics([500.0])
    area = GammaSizes(radius, 0.02)
    r, share = area.nodes()
    assert drops.extinction[0] == pytest.approx(2 * np.pi * share @ r**2, rel=0.04)


@pytest.mark.parametrize("sizes", SIZES, ids=str)
def test_tails_of_the_sizes_are_negligible(sizes):
    low, high = sizes.span
    radius, share = sizes.nodes(2000)
    edge = share * radius**2 / (share @ radius**2)
    if not isinstance(sizes, Junge):
        assert edge[0] < 1e-6
        assert edge[-1] < 1e-6
    assert radius[0] > low
    assert radius[-1] < high
    assert share.sum() == pytest.approx(1)
    assert isinstance(sizes, SizeDistribution)


def test_effective_sizes():
    assert Lognormal(0.2e-6, 1.8).effective_radius == pytest.approx(0.2e-6 * np.exp(2.5 * np.log(1.8) ** 2), rel=1e-5)
    assert GammaSizes(3e-6, 0.1).effective_variance == pytest.approx(0.1, rel=1e-4)


def test_its_aerosol_goes_into_an_atmosphere():
    dust = sd.MieParticles(Lognormal(0.2e-6, 1.8), 1.53, Spectrum([400.0, 700.0], [0.01, 0.003]))
    aerosol = dust.optics([400.0, 550.0, 700.0]).aerosol(optical_depth=0.3)
    air = sd.Atmosphere((sd.Molecules(), aerosol))
    assert not aerosol.phase.wavelengths_alike
    assert aerosol.depth([550.0])[0] == pytest.approx(0.3)
    assert np.all(np.diff(aerosol.scattered([400.0, 550.0, 700.0])) > 0)
    pytest.importorskip("nanodisort")
    sky = sd.DiscreteOrdinates(sd.direction(180 * sd.deg, 40 * sd.deg), air)
    once = sd.Nishita93(sd.direction(180 * sd.deg, 40 * sd.deg), air)
    light, least = (s.radiance(sd.ZENITH, [450.0, 600.0]) for s in (sky, once))
    assert (light > least).all()


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: Lognormal(0.0, 1.5), r"median_radius must lie in \[1e-09, 0.001\] m, got 0"),
        (lambda: Lognormal(1e-6, 1.0), r"deviation must lie in \[1.001, 4\], got 1"),
        (lambda: Lognormal(1.0, 1.5), "median_radius must lie in .* got 1"),
        (lambda: Junge(4.0, 2e-6, 1e-6), "smallest must be below largest, got 2e-06 and 1e-06 m"),
        (lambda: Junge(float("nan")), "exponent must lie in .* got nan"),
        (lambda: GammaSizes(1e-6, 0.5), r"variance must lie in \[0.001, 0.45\], got 0.5"),
        (lambda: MieParticles(Junge(), -1.5), "refractive_index must lie in .*, got -1.5"),
        (lambda: MieParticles(Junge(), 1.5, float("inf")), "absorption_index must lie in"),
        (lambda: MieParticles(Junge(), count=1), r"count must lie in \[8, 100000\], got 1"),
        (lambda: MieParticles(GammaSizes(5e-4, 0.1)).optics([400.0]), "must be at most 2000, got"),
        (lambda: MieParticles(Junge()).optics([-1.0]), "wavelengths must be finite and positive"),
        (lambda: LegendreSeries([550.0], [[0.9], [0.1]]), r"the first moment must be 1, got \[0.9\]"),
        (lambda: LegendreSeries([550.0], [[1.0], [0.9]]), "a phase function must not be negative, got"),
        (lambda: LegendreSeries([550.0], [1.0]), r"must have shape \(L, W\) with L >= 2"),
    ],
)
def test_particles_that_cannot_be(call, message):
    with pytest.raises(ValueError, match=message) as caught:
        call()
    assert "\n" not in str(caught.value)


def test_without_miepython_it_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "miepython", None)
    with pytest.raises(ImportError, match=r'MieParticles needs miepython: pip install "skydome\[mie\]"'):
        MieParticles(Junge()).optics([550.0])
