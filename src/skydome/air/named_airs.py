"""Clear air of the earth by what people know of it: a kind of aerosol, its depth, how far one sees, Linke's factor.

All of them are `Atmosphere.of_aerosol`: molecules and ozone by height as they are in the standard atmosphere, one
aerosol near the ground, and the background aerosol of the stratosphere, which is a part of the depth given.
"""

from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from skydome.air.constituents import Aerosol, Constituent, Molecules, NitrogenDioxide, Ozone
from skydome.air.cross_sections import STANDARD_PRESSURE, rayleigh_depth
from skydome.air.gases.gases import STANDARD_WATER, Gases
from skydome.air.phase_laws import Haze, HenyeyGreenstein
from skydome.air.profiles import STRATOSPHERIC_LAYER, Exponential
from skydome.air.turbidity import TURBIDITY, from_linke, from_meteorological_range, meteorological_range
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import floating, is_numpy, namespace
from skydome.ground.labels import keeps_labels
from skydome.ground.limits.ranges import Range, require, require_one
from skydome.light.spectrum import Spectrum

BACKGROUND_DEPTH = 0.006
"""Optical depth at 550 nm of the stratosphere's aerosol between great eruptions."""


def visibilities() -> Range:
    """How far one may see through the air of a turbidity.

    >>> str(visibilities())
    '[784.324, 279968] m'
    """
    far, near = (float(meteorological_range(np.asarray(end))) for end in (TURBIDITY.low, TURBIDITY.high))
    return Range(near, far, "m")


class AerosolKind(NamedTuple):
    """At 550 nm and 80 % of relative humidity: usual depth, share scattered, g; Angstrom's exponent of the light."""

    depth: float
    albedo: float
    asymmetry: float
    angstrom: float

    @property
    def aerosol(self) -> Aerosol:
        """The aerosol, with one Henyey-Greenstein lobe."""
        return Aerosol(self.depth, self.angstrom, self.albedo, HenyeyGreenstein((self.asymmetry,)))


CONTINENTAL_AVERAGE = AerosolKind(0.151, 0.925, 0.703, 1.27)
MARITIME_CLEAN = AerosolKind(0.096, 0.997, 0.772, 0.10)
DESERT = AerosolKind(0.286, 0.888, 0.729, 0.19)
URBAN = AerosolKind(0.643, 0.817, 0.689, 1.29)
"""Hess, Koepke and Schult 1998 (OPAC), tables 4 and 5; the exponent is the mean of those of 350-500 and 500-800 nm."""


CONTINENTAL = Aerosol()
"""The usual aerosol: one Henyey-Greenstein lobe of g 0.76, of which 0.92 is scattered, scale height 1.5 km."""

KINDS = {
    "usual": CONTINENTAL,
    "continental": CONTINENTAL_AVERAGE.aerosol,
    "maritime": MARITIME_CLEAN.aerosol,
    "desert": DESERT.aerosol,
    "urban": URBAN.aerosol,
}
"""Aerosols by a word: the usual one, and those of OPAC."""

PREETHAM_HAZE = Aerosol(albedo=1.0, phase=Haze(), profile=Exponential(1200.0))
"""The haze of Preetham's A.1: it scatters all, by Bullrich's table, with a scale height of 1.2 km."""


def background(depth: Any = BACKGROUND_DEPTH) -> Aerosol:
    """The aerosol of the stratosphere, of an optical depth at 550 nm: it scatters all, g 0.7, at 12-28 km."""
    return Aerosol(depth, 1.3, 1.0, HenyeyGreenstein((0.7,)), STRATOSPHERIC_LAYER)


def shared_out(aerosol: Aerosol, stratospheric_depth: Any) -> tuple[Aerosol, ...]:
    """An aerosol of a whole depth as two: near the ground and in the stratosphere, what is nothing left out."""
    if isinstance(aerosol.optical_depth, Spectrum):
        whole = aerosol.optical_depth
        rest = np.maximum(whole.values - background(stratospheric_depth).depth(whole.wavelengths), 0.0)
        return replace(aerosol, optical_depth=Spectrum(whole.wavelengths, rest)), background(stratospheric_depth)
    low, high = low_and_high(aerosol.optical_depth, stratospheric_depth)
    if is_numpy(high) and not np.any(high):
        return (aerosol,)
    return replace(aerosol, optical_depth=low), background(high)


@keeps_labels(whole=0, stratospheric=0)
def low_and_high(whole: Any, stratospheric: Any) -> tuple[Any, Any]:
    """A whole depth near the ground and in the stratosphere, each (...,)."""
    depth = floating(whole)
    other = floating(stratospheric, like=depth)
    xp = namespace(depth, other)
    high = xp.where(depth < other, depth, other)
    low, high = (float(part) if is_numpy(part) and part.ndim == 0 else part for part in (depth - high, high))
    return low, high


def usual() -> tuple[Constituent, ...]:
    """What air is made of where nobody says."""
    low, *high = shared_out(CONTINENTAL, BACKGROUND_DEPTH)
    return Molecules(), low, Ozone(), *high


class NamedAirs:
    """The constructors of `Atmosphere` for clear air of the earth."""

    @classmethod
    def of_aerosol(
        cls,
        aerosol: Aerosol,
        *,
        pressure: Any = STANDARD_PRESSURE,
        ozone: Any = 330.0,
        stratospheric_depth: Any = BACKGROUND_DEPTH,
        water: Any = STANDARD_WATER,
        nitrogen_dioxide: Any = 0.0,
        **others: Any,
    ) -> Any:
        """Air of the US Standard Atmosphere 1976, Dobson units of ozone, cm of precipitable water, and an aerosol.

        `stratospheric_depth` of the aerosol's depth at 550 nm lies in the stratosphere; `nitrogen_dioxide`, Dobson
        units, as haze (rural air 0.2, a town 1, by default left out); `others` as in `Atmosphere`.
        `gases=None` leaves water vapour, oxygen and carbon dioxide out.

        >>> import skydome as sd
        >>> air = sd.Atmosphere.of_aerosol(sd.Aerosol(0.1), pressure=80_000.0, albedo=0.3)
        >>> [round(float(part.depth([550.0])[0]), 4) for part in air.constituents]
        [0.0766, 0.094, 0.0292, 0.006]
        """
        low, *high = shared_out(aerosol, stratospheric_depth)
        none = is_numpy(nitrogen_dioxide) and not np.any(nitrogen_dioxide)
        brown = () if none else (NitrogenDioxide(nitrogen_dioxide),)
        parts: tuple[Constituent, ...] = (Molecules(pressure), low, Ozone(ozone), *high, *brown)
        return cls(parts, **({"gases": Gases(water, pressure)} | others))  # type: ignore[call-arg]

    @classmethod
    def of_kind(cls, kind: AerosolKind, aerosol_depth: Any = None, **others: Any) -> Any:
        """Air of a kind of aerosol, of its usual depth or the one given; `others` as in `of_aerosol`."""
        depth = kind.depth if aerosol_depth is None else aerosol_depth
        return cls.of_aerosol(replace(kind.aerosol, optical_depth=depth), **others)

    @classmethod
    def continental(cls, aerosol_depth: Any = None, **others: Any) -> Any:
        """Air over land: OPAC's average continental aerosol, 0.151 deep at 550 nm unless given.

        >>> import skydome as sd
        >>> sd.Atmosphere.continental().depth([550.0]).round(3).tolist()
        [0.277]
        """
        return cls.of_kind(CONTINENTAL_AVERAGE, aerosol_depth, **others)

    @classmethod
    def maritime(cls, aerosol_depth: Any = None, **others: Any) -> Any:
        """Air over the sea: OPAC's clean maritime aerosol, sea salt above all, 0.096 deep at 550 nm unless given."""
        return cls.of_kind(MARITIME_CLEAN, aerosol_depth, **others)

    @classmethod
    def desert(cls, aerosol_depth: Any = None, **others: Any) -> Any:
        """Air over deserts: OPAC's mineral dust, 0.286 deep at 550 nm unless given."""
        return cls.of_kind(DESERT, aerosol_depth, **others)

    @classmethod
    def urban(cls, aerosol_depth: Any = None, **others: Any) -> Any:
        """Air over a town: OPAC's urban aerosol, with much soot, 0.643 deep at 550 nm unless given."""
        return cls.of_kind(URBAN, aerosol_depth, **others)

    @classmethod
    def from_turbidity(cls, turbidity: float, aerosol: Aerosol = CONTINENTAL, **others: Any) -> Any:
        """Air with so much of an aerosol as the turbidity says, 1 is clean air; ValueError outside [1, 64].

        Turbidity is the vertical optical depth of molecules and aerosol over that of molecules at 550 nm (Preetham
        1999, section 2.2); the one place where it becomes air. `aerosol` tells all but the depth: `CONTINENTAL`, or
        `PREETHAM_HAZE`, which aerial perspective has too. `others` as in `of_aerosol`.

        >>> import skydome as sd
        >>> sd.Atmosphere.from_turbidity(3.0, ozone=0.0).depth([550.0]).round(3).tolist()
        [0.291]
        """
        require("turbidity", turbidity, TURBIDITY)
        require_one("turbidity", turbidity)
        require_kind(aerosol, Aerosol, "aerosol", "CONTINENTAL")
        return cls.of_aerosol(replace(aerosol, optical_depth=depth_of_turbidity(turbidity)), **others)

    @classmethod
    def from_visibility(cls, metres: float, **others: Any) -> Any:
        """Air in which one sees so far (meteorological range); ValueError outside `visibilities`.

        `others` as in `from_turbidity`.
        """
        require("metres", metres, visibilities())
        require_one("metres", metres)
        return cls.from_turbidity(float(from_meteorological_range(np.asarray(metres))), **others)

    @classmethod
    def from_linke(cls, linke: float, **others: Any) -> Any:
        """Air of Linke's turbidity factor (air mass 2, 2 cm of water); `others` as in `from_turbidity`."""
        require_one("linke", linke)
        return cls.from_turbidity(float(from_linke(linke)), **others)

    @classmethod
    def from_depths(
        cls, wavelengths: ArrayLike, depths: ArrayLike, kind: AerosolKind = CONTINENTAL_AVERAGE, **others: Any
    ) -> Any:
        """Air of aerosol depths measured at two wavelengths, nm, or more, as AERONET has them: (W,) and (W,).

        Between two of them, and beyond the last, depths follow Angstrom's law; `kind` tells all but the depth.
        ValueError unless wavelengths increase and depths are positive.

        >>> import skydome as sd
        >>> air = sd.Atmosphere.from_depths([440.0, 675.0, 870.0], [0.20, 0.12, 0.09])
        >>> low, high = air.constituents[1], air.constituents[3]
        >>> (low.depth([675.0]) + high.depth([675.0])).round(4).tolist()
        [0.12]
        """
        return cls.of_aerosol(replace(kind.aerosol, optical_depth=angstrom_through(wavelengths, depths)), **others)


def depth_of_turbidity(turbidity: Any) -> Any:
    """Optical depth of aerosol at 550 nm, of one turbidity or many (...,)."""
    return (turbidity - 1) * float(rayleigh_depth([550.0])[0])


def angstrom_through(wavelengths: ArrayLike, depths: ArrayLike) -> Spectrum:
    """The spectrum of depths, 250-4000 nm, that follows Angstrom's law between and beyond those given."""
    w, depth = (np.asarray(part, dtype=np.float64) for part in (wavelengths, depths))
    if w.ndim != 1 or w.shape != depth.shape or len(w) < 2 or not (np.diff(w) > 0).all() or not w[0] > 0:
        raise ValueError(
            f"wavelengths must increase, with a depth for each of 2 or more, got {w.shape} and {depth.shape}"
        )
    if not ((depth > 0) & np.isfinite(depth)).all():
        raise ValueError(f"depths must be positive and finite, got {depth.tolist()}")
    x, y = np.log(w), np.log(depth)
    slopes = np.diff(y) / np.diff(x)
    fine = np.unique(np.concatenate([np.arange(250.0, 4001.0, 10.0), w]))
    place = np.clip(np.searchsorted(w, fine, side="right") - 1, 0, len(w) - 2)
    return Spectrum(fine, np.exp(y[place] + slopes[place] * (np.log(fine) - x[place])))
