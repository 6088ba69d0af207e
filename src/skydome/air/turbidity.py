"""Turbidity from what people know: how far they see, Linke's factor, a place and a month.

Turbidity T here is Preetham's: the optical thickness of gas and haze over that of gas alone, at 550 nm.
"""

import numpy as np
from numpy.typing import ArrayLike

from skydome.air.scattering import HAZE_DECAY, gas_total, haze_total
from skydome.air.transmittance import angstrom_beta
from skydome.ground.arrays import Array, floating, namespace
from skydome.ground.extras import required
from skydome.ground.labels import keeps_labels
from skydome.ground.limits.ranges import Range, require

TURBIDITY = Range(1.0, 64.0)

CONTRAST = 0.02
"""The least contrast that an observer sees (Preetham 1999, section 2.1)."""

GAS_THICKNESS = 0.008735 * 0.55**-4.08
"""Vertical optical thickness of the molecules at 550 nm (A.1): 0.1001."""


@keeps_labels("m", turbidity=0)
def meteorological_range(turbidity: Array) -> Array:
    """How far a black target is seen against the horizon, m, same shape: ln(1 / 0.02) over the extinction at 550 nm.

    The curve of Preetham 1999, Figure 3, computed: its haze (A.3) and molecules (A.3) at the ground. ValueError for a
    turbidity outside 1-64.

    >>> [round(float(meteorological_range(t)) / 1000, 1) for t in (2.0, 4.0, 6.0)]
    [42.1, 15.6, 9.6]
    """
    require("turbidity", turbidity, TURBIDITY)
    turbidity = floating(turbidity)
    haze = haze_total([550.0], turbidity)[..., 0]
    return -np.log(CONTRAST) / (haze + float(gas_total([550.0])[0]))


def from_meteorological_range(metres: Array) -> Array:
    """Turbidity of the air in which one sees that far, the inverse of `meteorological_range`, same shape.

    ValueError unless positive and at most what molecules alone allow (about 280 km).

    >>> round(float(from_meteorological_range(meteorological_range(3.0))), 12)
    3.0
    """
    metres = floating(metres)
    if not bool(namespace(metres).all((metres > 0) & (metres <= meteorological_range(1.0)))):
        raise ValueError(
            f"a meteorological range must lie in (0, {float(meteorological_range(1.0)):.0f}] m, got {metres}"
        )
    unit = float(haze_total([550.0], 2.0)[0] - haze_total([550.0], 1.0)[0])
    clearest = float(haze_total([550.0], 1.0)[0]) + float(gas_total([550.0])[0])
    return 1 + (-np.log(CONTRAST) / metres - clearest) / unit


def from_haze_thickness(optical_thickness: Array, wavelength: float = 550.0, exponent: float = 1.3) -> Array:
    """Turbidity of an aerosol optical thickness at `wavelength` nm, same shape, by the definition at 550 nm.

    >>> float(from_haze_thickness(0.0))
    1.0
    """
    at_550 = floating(optical_thickness) * (550.0 / wavelength) ** -exponent
    return 1 + at_550 / GAS_THICKNESS


def haze_thickness(turbidity: Array) -> Array:
    """Vertical optical thickness of haze at 550 nm by A.3 and the scale height of 1.2 km, same shape."""
    return haze_total([550.0], turbidity)[..., 0] / HAZE_DECAY


def linke_of(turbidity: ArrayLike) -> np.ndarray:
    """Linke's factor at air mass 2 of the paper's clear air, same shape: all light, not the visible alone.

    Molecules, ozone and 2 cm of water by Kasten's (1996) clean dry air (1 / (9.4 + 0.9 m)); haze by Angstrom.
    """
    turbidity = np.asarray(turbidity, dtype=np.float64)
    beta = np.maximum(angstrom_beta(turbidity), 0.0)
    return kasten_1996(beta * 0.7**-1.3)


def kasten_1996(haze_thickness_at_700: np.ndarray, mass: float = 2.0, water: float = 2.0) -> np.ndarray:
    """Linke's factor of haze of that optical thickness, same shape, at an air mass and `water` cm of vapour.

    Kasten 1996, "The Linke turbidity factor based on improved values of the integral Rayleigh optical thickness", with
    the clean dry air and the vapour of Molineaux, Ineichen and O'Neill 1998.
    """
    clean_dry, vapour = -0.101 + 0.235 * mass**-0.16, 0.112 * mass**-0.55 * water**0.34
    linke: np.ndarray = (9.4 + 0.9 * mass) * (clean_dry + vapour + haze_thickness_at_700)
    return linke


def from_linke(linke: ArrayLike) -> np.ndarray:
    """Turbidity whose haze gives Linke's factor at air mass 2 with 2 cm of water, same shape, at least 1.

    By Kasten's relation between Linke's factor and the haze's thickness at 700 nm (`kasten_1996`) and Angstrom's
    formula with A.1's beta. A rule of thumb found in many programs, T = Linke, is 0-2 too high.

    >>> from_linke(linke_of([2.0, 5.0])).round(9).tolist()
    [2.0, 5.0]
    """
    linke = np.asarray(linke, dtype=np.float64)
    if not (linke > 0).all():
        raise ValueError(f"Linke's factor must be positive, got {linke.min():g}")
    clean, hazier = linke_of([1.0, 2.0])  # a straight line
    found: np.ndarray = np.maximum(1 + (linke - clean) / (hazier - clean), 1.0)
    return found


def of_place(latitude: float, longitude: float, month: int) -> float:
    """Typical turbidity of a place (degrees, north and east positive) in a month (1-12).

    From Linke's factor in the climatology of Remund et al. 2003, which pvlib carries.

    >>> 2.0 < of_place(45.07, 7.69, 6) < 5.0
    True
    """
    if not 1 <= month <= 12 or int(month) != month:
        raise ValueError(f"month must be a whole number in [1, 12], got {month}")
    if not (-90 <= latitude <= 90 and -180 <= longitude <= 180):
        raise ValueError(f"latitude and longitude must lie in [-90, 90] and [-180, 180], got {latitude}, {longitude}")
    pvlib = required("pvlib", "weather", "the climatology of Linke's factor")
    import pandas as pd

    time = pd.DatetimeIndex([pd.Timestamp(2021, int(month), 15)])
    linke = pvlib.clearsky.lookup_linke_turbidity(time, latitude, longitude, interp_turbidity=False)
    return float(from_linke(float(linke.iloc[0])))
