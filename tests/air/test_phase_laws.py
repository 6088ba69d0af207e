"""Every phase law: its integral is 1, its moments are those of its values, and a sky does not ask how it is written."""

from dataclasses import replace
from inspect import isabstract

import numpy as np
import pytest

import skydome as sd
from skydome import deg
from skydome.air.clouds.particles import Ice, Water
from skydome.air.constituents import Aerosol
from skydome.air.phase_laws import CornetteShanks, Haze, HenyeyGreenstein, PhaseLaw, Rayleigh
from skydome.air.series.legendre import legendre
from skydome.air.series.legendre_series import LegendreSeries
from skydome.ground.quadrature import gauss_legendre
from skydome.skies.all_air.low_aerosol import FoldedLaw

WAVELENGTHS = np.array([450.0, 650.0])
TERMS = 160
TWO = HenyeyGreenstein((0.8, -0.5), (0.93, 0.07))
DROPS = sd.MieParticles(sd.Lognormal(0.3e-6, 1.6), 1.45, 0.003, 150).optics(WAVELENGTHS).phase_law
LAWS = {
    "Rayleigh": Rayleigh(0.03),
    "HenyeyGreenstein": HenyeyGreenstein((0.7,)),
    "two lobes": TWO,
    "CornetteShanks": CornetteShanks(0.7),
    "Haze": Haze(),
    "LegendreSeries": DROPS,
    "Droplets": Water().phase_law(10e-6),
    "OneLobe": Ice().phase_law(40e-6),
    "Prisms": sd.HexagonalIce().phase_law(10e-6),
    "FoldedLaw": FoldedLaw(sd.Atmosphere((Aerosol(0.2, phase=TWO),))),
}


def test_no_law_is_left_out():
    def kinds(kind):
        return {kind, *(below for sub in kind.__subclasses__() for below in kinds(sub))}

    ours = {kind for kind in kinds(PhaseLaw) - {PhaseLaw} if kind.__module__.startswith("skydome.")}
    assert {kind for kind in ours if not isabstract(kind)} == {type(law) for law in LAWS.values()}


@pytest.mark.parametrize("name", LAWS)
def test_a_law_is_a_law(name):
    """Its integral over the sphere is 1, and moments, mean cosine and second moment are those of its values."""
    law = LAWS[name]
    t, w = gauss_legendre(2000)
    cosine, weight = np.cos(np.pi * t), 2 * np.pi * np.pi * w * np.sin(np.pi * t)
    own = legendre(8, cosine) * weight @ law.value(cosine, WAVELENGTHS)
    # tables, of coarse steps and of narrow peaks
    tolerance = {"Haze": 5e-3, "Droplets": 2e-3, "Prisms": 1e-3}.get(name, 1e-6)
    np.testing.assert_allclose(own[0], 1.0, atol=tolerance)
    np.testing.assert_allclose(np.broadcast_to(law.moments(8, WAVELENGTHS), own.shape), own, atol=tolerance)
    np.testing.assert_allclose(law.mean_cosine(WAVELENGTHS), own[1], atol=tolerance)
    np.testing.assert_allclose(law.second_moment(WAVELENGTHS), own[2], atol=tolerance)


@pytest.mark.parametrize("name", ["HenyeyGreenstein", "two lobes", "CornetteShanks", "LegendreSeries"])
def test_the_sky_of_a_law_is_that_of_its_table(name):
    law = LAWS[name]
    table = LegendreSeries(WAVELENGTHS, np.broadcast_to(law.moments(TERMS, WAVELENGTHS), (TERMS, 2)))
    sun = sd.direction(0.0, 20 * deg)
    views = sd.direction(np.array([5.0, 60, 180]) * deg, np.array([22.0, 10, 50]) * deg)
    airs = [replace(sd.Atmosphere.of_aerosol(Aerosol(0.2, phase=one)), gases=None) for one in (law, table)]
    written, tabled = (sd.PhysicalSky(sun, air).radiance(views, WAVELENGTHS) for air in airs)
    np.testing.assert_allclose(tabled, written, rtol=2e-5)
