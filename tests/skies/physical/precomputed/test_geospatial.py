"""Our textures of three-geospatial's air against those that its own program made and ships."""

import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.air.constituents import Ozone
from skydome.air.phase_laws import CornetteShanks
from skydome.air.profiles import Exponential
from skydome.skies.physical.precomputed.grid import Sizes
from skydome.skies.physical.precomputed.textures import BANDS, GEOSPATIAL, GEOSPATIAL_LOWEST_SUN

pytest.importorskip("numba")
PACKAGE = os.environ.get("SKYDOME_GEOSPATIAL")
pytestmark = pytest.mark.skipif(
    PACKAGE is None, reason="needs SKYDOME_GEOSPATIAL, the unpacked npm package @takram/three-atmosphere (0.19.1)"
)
SUN = np.array([1.474, 1.8504, 1.91198])
"""W m-2 nm-1 at 680, 550 and 440 nm: `solarIrradiance` of its AtmosphereParameters, from which the air below is too."""
LESS_WORK = Sizes(32, 128, 32, 8, directions=16, samples=16)


@dataclass(frozen=True, eq=False)
class Absorber(Ozone):
    """Its ozone: a tent of 15 km times the coefficients at the top."""

    def depth(self, wavelengths):
        return np.interp(wavelengths, BANDS, np.array([0.000085, 0.001881, 0.00065]) * 15)


def air():
    depths = sd.Spectrum(np.array(BANDS), np.array([0.0331, 0.013558, 0.005802]) * 8)
    molecules = sd.Molecules(profile=Exponential(8000.0), depolarisation=0.0, optical_depth=depths)
    haze = sd.Aerosol(0.00444 * 1.2, 0.0, 0.9, CornetteShanks(0.8), Exponential(1200.0))
    return sd.Atmosphere((molecules, haze, Absorber()), 0.1, radius=6_360_000.0, height=60_000.0)


def test_texels_are_those_of_the_reader():
    """Half numbers, 4 orders there and all here: transmittance within .004; of a hundred texels 98 within 8 %."""
    theirs, sky = GEOSPATIAL.load(Path(PACKAGE) / "assets"), air()
    ours = sd.ScatteringTextures.of(sd.ScatteringTables.of(sky, BANDS, 4, LESS_WORK, GEOSPATIAL_LOWEST_SUN))
    level = SUN / sky.sun_at(np.array(BANDS))[::-1]
    np.testing.assert_allclose(ours.transmittance, theirs.transmittance, atol=4e-3)
    day = slice(34, None)  # suns above the horizon
    np.testing.assert_allclose(ours.irradiance[0, day, :3] * level, theirs.irradiance[0, day, :3], rtol=0.08)
    for channel, scale in enumerate([*level, level[0]]):
        there = theirs.scattering[..., channel]
        bright = there > 0.01 * there.max()
        ratio = ours.scattering[..., channel][bright] * scale / there[bright]
        assert np.median(ratio) == pytest.approx(1, abs=0.03)
        low, high = np.percentile(ratio, [1, 99])
        assert low > 0.92
        assert high < 1.08
