"""The air of Mars: thin carbon dioxide and much dust, each number with its source.

what | number | source
radius | 3389.5 km (volumetric mean) | NASA Mars Fact Sheet
surface pressure | 636 Pa, at the mean radius | the same
gravity, mean molar mass | 3.73 m s-2, 43.34 g mol-1 | the same
scale height of the gas | 11.1 km | the same
sunlight | the earth's / 1.524^2 | the same (semimajor axis)
cross section of CO2 | eq. 4, 13 and 14 | Sneep and Ubachs 2005
dust's optical depth | 0.5, nearly the same at 450-989 nm | Smith and Lemmon 1999 (0.4-0.6 in Pathfinder's season)
dust's scale height | 11.56 +- 0.62 km: mixed with the gas | Lemmon et al. 2004
dust's extinction and single scattering albedo by wavelength | table | Wolff et al. 2009, by way of pyRT_DISORT
dust's phase function | Mie, 1.5 um, variance 0.25, index 1.5 | `scripts/make_mars_dust.py` names them
ground | 0.11 blue, 0.17 green, 0.35 red | Guinness 1981, soils at Viking 1, 5 degrees from opposition
Choices without a source: all gas counts as CO2 (it is 95 %), the ground's three bands stand at 450, 550 and 650 nm and
are taken for its albedo, the air ends at 120 km, no water ice, no refraction.
"""

import numpy as np

from skydome.air.constituents import DEPTH, Aerosol, Molecules
from skydome.air.cross_sections import carbon_dioxide_cross_section, carbon_dioxide_king_factor
from skydome.air.profiles import Exponential
from skydome.air.series.legendre_series import LegendreSeries
from skydome.ground.limits.ranges import require
from skydome.ground.tables import archive
from skydome.light.spectrum import Spectrum

RADIUS, TOP, SUN_DISTANCE = 3_389_500.0, 120_000.0, 1.524
GRAVITY, MOLECULE = 3.73, 43.34e-3 / 6.02214076e23
"""m s-2, and kg a molecule."""

GROUND = Spectrum([450.0, 550.0, 650.0], [0.11, 0.17, 0.35])


def gas(pressure: float) -> Molecules:
    """Carbon dioxide over a surface `pressure`, Pa."""
    require("pressure", pressure, Molecules.bounds["pressure"])
    wavelengths = np.arange(300.0, 1101.0, 10.0)
    depth = carbon_dioxide_cross_section(wavelengths) * (pressure / (MOLECULE * GRAVITY))
    king = float(carbon_dioxide_king_factor([550.0])[0])
    depolarisation = 6 * (king - 1) / (3 + 7 * king)
    return Molecules(pressure, Exponential(11_100.0), depolarisation, Spectrum(wavelengths, depth))


def dust(optical_depth: float) -> Aerosol:
    """The dust, of a vertical optical depth at 550 nm: 321-800 nm, the ends held outside.

    Spheres are not dust: their asymmetry is 3-6 % above Wolff's, and they scatter more straight back (a glory).
    """
    require("dust_depth", optical_depth, DEPTH)
    table = archive("mars_dust")
    wavelengths = table["wavelength_nm"]
    phase = LegendreSeries(wavelengths, table["moments"])
    depth = Spectrum(wavelengths, optical_depth * table["extinction"])
    return Aerosol(depth, albedo=Spectrum(wavelengths, table["albedo"]), phase=phase, profile=Exponential(11_560.0))
