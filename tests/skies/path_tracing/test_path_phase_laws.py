"""Paths that carry all wavelengths where each has its own phase function."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import pytest

import skydome as sd
from skydome.air.atmosphere import PREETHAM_HAZE, Atmosphere
from skydome.air.constituents import Aerosol, Molecules
from skydome.air.phase_functions import henyey_greenstein
from skydome.air.phase_laws import Haze, HenyeyGreenstein, PhaseLaw
from skydome.air.profiles import Exponential
from skydome.ground.quadrature import hemisphere
from skydome.skies.path_tracing.sky import PathTraced

pytest.importorskip("numba")
W = np.array([400.0, 550.0, 700.0])
VIEWS = hemisphere(5, 8)[0]
MIXED = Exponential(1500.0)
SUN = sd.direction(np.pi, 40 * sd.deg)


@dataclass(frozen=True)
class Changing(PhaseLaw):
    """Henyey-Greenstein whose g goes from 0.4 at 400 nm to 0.85 at 700 nm."""

    wavelengths_alike: ClassVar[bool] = False

    def g(self, wavelengths):
        return np.interp(wavelengths, [400.0, 700.0], [0.4, 0.85])

    def value(self, cosine, wavelengths):
        return henyey_greenstein(np.asarray(cosine)[..., None], self.g(wavelengths))

    def moments(self, count, wavelengths):
        return self.g(wavelengths) ** np.arange(count)[:, None]


def flat(law):
    aerosol = Aerosol(0.2, albedo=0.95, phase=law, profile=MIXED)
    return Atmosphere((Molecules(depolarisation=0.0, profile=MIXED), aerosol), 0.3, radius=6.371e9)


def check(tracing, expected, error=0.0):
    away = (tracing.radiance - expected) / np.hypot(tracing.standard_error, error)
    assert np.abs(away).max() < 4
    assert 0.6 < (away**2).mean() < 1.6


@pytest.mark.parametrize("law", [Changing(), Haze()], ids=["g by wavelength", "haze"])
@pytest.mark.parametrize("exact", [True, False])
def test_against_discrete_ordinates(law, exact):
    pytest.importorskip("nanodisort")
    tracing = PathTraced(SUN, flat(law), exact_first=exact, paths_per_pass=64, seed=1).job(VIEWS, W).start().more(40)
    expected = sd.DiscreteOrdinates(SUN, flat(law), 64).radiance(VIEWS, W)
    assert np.abs((tracing.radiance / expected).mean(axis=0) - 1).max() < 0.01
    check(tracing, expected)


@pytest.mark.parametrize("law", [Changing(), Haze()], ids=["g by wavelength", "haze"])
def test_all_together_or_one_by_one(law):
    sky = PathTraced(SUN, flat(law), exact_first=False, paths_per_pass=64, seed=2)
    together = sky.job(VIEWS, W).start().more(24)
    alone = [sky.job(VIEWS, [w]).start().more(40) for w in W]
    expected, error = (np.concatenate([getattr(t, n) for t in alone], axis=-1) for n in ("radiance", "standard_error"))
    check(together, expected, error)


def test_a_table_or_a_formula_is_the_same():
    """Henyey-Greenstein of one g, told wavelength by wavelength and read from tables, or by its formula."""

    class Table(PhaseLaw):
        def value(self, cosine, wavelengths):
            return HenyeyGreenstein((0.7,)).value(cosine, wavelengths)

    one, other = (
        PathTraced(SUN, flat(law), exact_first=False, paths_per_pass=64, seed=seed).job(VIEWS, W).start().more(24)
        for seed, law in enumerate((HenyeyGreenstein((0.7,)), Table()))
    )
    check(one, other.radiance, other.standard_error)


@pytest.mark.parametrize(
    "air", [Atmosphere.from_turbidity(3.0, PREETHAM_HAZE), Atmosphere.mars()], ids=["turbidity", "mars"]
)
def test_air_by_turbidity_and_of_mars_can_be_traced_by_day_and_in_twilight(air):
    for elevation in (30.0, -4.0):
        sky = PathTraced(sd.direction(np.pi, elevation * sd.deg), air)
        found = sky.job(VIEWS, W).start().more(8)
        assert (found.radiance > 0).all()
        assert found.relative_error < 0.3
