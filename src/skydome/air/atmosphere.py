"""An atmosphere: constituents in spherical shells over a ground, lit by a sun."""

from dataclasses import dataclass, field, replace
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from skydome.air import mars
from skydome.air.constituents import Aerosol, Constituent, Molecules, at
from skydome.air.cross_sections import STANDARD_PRESSURE, solar_irradiance
from skydome.air.gases.gases import STANDARD_WATER, Gases
from skydome.air.gases.missing import MissingBands, tell_missing_bands
from skydome.air.named_airs import BACKGROUND_DEPTH, CONTINENTAL, PREETHAM_HAZE, NamedAirs, usual
from skydome.air.phase_laws import CornetteShanks, HenyeyGreenstein, PhaseLaw
from skydome.air.profiles import Exponential, Profile
from skydome.ground.arrays import Array, is_numpy
from skydome.ground.limits.ranges import NOT_NEGATIVE, SHARE, HeldBySky, Range
from skydome.ground.quadrature import gauss_legendre
from skydome.ground.tables import columns
from skydome.ground.units import EARTH_RADIUS
from skydome.light.spectrum import Spectrum
from skydome.sun.refraction import standard_pressure

__all__ = ["CONTINENTAL", "DARK_GREEN", "PREETHAM_HAZE", "USUAL_ALBEDO", "Atmosphere", "MissingBands"]


def grass() -> Spectrum:
    """The spectral albedo of grass, 360-800 nm (Feister and Grewe 1995)."""
    table = columns("grass_albedo")
    return Spectrum(table["wavelength_nm"], table["albedo"])


USUAL_ALBEDO = 0.2
"""Albedo of the ground where nobody says, of every sky model: dry land."""


def dark_green() -> Spectrum:
    """0.04 below 500 nm, 0.08 to 690 nm, then the red edge of grass, 0.59 at 800 nm and beyond."""
    table = columns("grass_albedo")
    red = table["wavelength_nm"] > 690
    return Spectrum([499.0, 500.0, 690.0, *table["wavelength_nm"][red]], [0.04, 0.08, 0.08, *table["albedo"][red]])


DARK_GREEN = dark_green()
"""A plain picture of vegetated ground, dark to the eye; its red edge is that of grass (Feister and Grewe 1995)."""


@dataclass(frozen=True)
class Atmosphere(NamedAirs, HeldBySky):
    """Constituents over a ground of `albedo` (number or `Spectrum`) on a planet of `radius`, m.

    `height` is the top of the air above the ground, m. `sunlight`: a `Spectrum` of the irradiance above the air,
    W m-2 nm-1 (None: ASTM G173-03), times `sun_scale`. `gases`: what absorbs by bands of lines, water, oxygen;
    the constructors of the earth's air give them, None is none.

    >>> air = Atmosphere.standard(aerosol_depth=0.06)
    >>> air.depth([550.0]).round(3).tolist()
    [0.186]
    """

    constituents: tuple[Constituent, ...] = field(default_factory=usual)
    albedo: Any = USUAL_ALBEDO
    radius: float = EARTH_RADIUS
    height: float = 100_000.0
    sunlight: Spectrum | None = None
    sun_scale: float = 1.0
    gases: Gases | None = None
    bounds: ClassVar = {
        "albedo": SHARE,
        "radius": Range(1.0, 1e12, "m"),
        "height": Range(1.0, 1e12, "m"),
        "sunlight": NOT_NEGATIVE,
        "sun_scale": Range(0.0, 1e9),
    }
    kinds: ClassVar = {
        "constituents": (tuple, "(Molecules(), Aerosol(0.1))"),
        "sunlight": (Spectrum | None, "None"),
        "gases": (Gases | None, "Gases(water=1.42)"),
    }

    def __post_init__(self) -> None:
        self.require_bounds()
        if len(self.constituents) == 0:
            raise ValueError("an atmosphere needs at least one constituent, got none")

    @classmethod
    def standard(
        cls,
        aerosol_depth: Any = 0.1,
        asymmetry: Any = 0.76,
        pressure: Any = STANDARD_PRESSURE,
        ozone: Any = 330.0,
        albedo: Any = USUAL_ALBEDO,
        phase: PhaseLaw | None = None,
        aerosol_albedo: Any = 0.92,
        sun_scale: float = 1.0,
        angstrom: Any = 1.3,
        stratospheric_depth: Any = BACKGROUND_DEPTH,
        water: Any = STANDARD_WATER,
        nitrogen_dioxide: Any = 0.0,
    ) -> "Atmosphere":
        """Clear air of the earth, its aerosol of so much depth at 550 nm, `ozone` in Dobson units, `water` in cm.

        Molecules as in the US Standard Atmosphere 1976; aerosol of a scale height of 1.5 km, of which
        `stratospheric_depth` lies at 12-28 km. `phase` replaces the one Henyey-Greenstein lobe of `asymmetry`. Numbers
        may be arrays (...,) of any library, for the skies that take many airs at once.
        """
        law = HenyeyGreenstein((asymmetry,)) if phase is None else phase
        aerosol = Aerosol(aerosol_depth, angstrom, aerosol_albedo, law)
        sky = {"pressure": pressure, "ozone": ozone, "stratospheric_depth": stratospheric_depth, "water": water}
        sky["nitrogen_dioxide"] = nitrogen_dioxide
        air: Atmosphere = cls.of_aerosol(aerosol, **sky, albedo=albedo, sun_scale=sun_scale)
        return air

    def at_altitude(self, altitude: float) -> "Atmosphere":
        """The same air over ground so many metres above the sea, such as `Place.altitude`: gases weigh less there, but
        for water vapour, which like the aerosol is what lies above that ground.

        >>> Atmosphere.standard().at_altitude(2635.0).depth([550.0]).round(3).tolist()
        [0.199]
        """
        share = standard_pressure(altitude) / standard_pressure(0.0)
        parts = (
            replace(part, pressure=part.pressure * share) if isinstance(part, Molecules) else part
            for part in self.constituents
        )
        gases = None if self.gases is None else self.gases.under(share)
        return replace(self, constituents=tuple(parts), gases=gases)

    @classmethod
    def bruneton2016(cls) -> "Atmosphere":
        """The shared air of Bruneton's evaluation (2016): no ozone, a strongly absorbing aerosol, grass.

        Penndorf's Rayleigh coefficients at 15 C over 8 km; aerosol 0.04 x micrometres^-0.8 over 1.2 km, single
        scattering albedo 0.8, Cornette-Shanks g 0.7; radius 6360 km, top at 60 km.
        """
        table = columns("penndorf_1957")
        depths = Spectrum(table["wavelength_nm"], table["coefficient"] * (273.16 / 288.16) * 8000.0)
        aerosol = Aerosol(0.04 * 0.55**-0.8, 0.8, 0.8, CornetteShanks(0.7), Exponential(1200.0))
        molecules = Molecules(profile=Exponential(8000.0), depolarisation=0.0, optical_depth=depths)
        return cls((molecules, aerosol), grass(), radius=6_360_000.0, height=60_000.0)

    @classmethod
    def mars(
        cls, dust_depth: float = 0.5, pressure: float = 636.0, albedo: ArrayLike | Spectrum = mars.GROUND
    ) -> "Atmosphere":
        """The air of Mars: carbon dioxide of a surface `pressure`, Pa, and dust of an optical depth at 550 nm.

        Every number has its source in `air/mars.py`; 0.4-0.6 is usual for dust, 0.9 after a storm. Without dust the
        sky is nearly black. The dust's phase function changes with wavelength (Mie), which makes the sky about the
        sun blue.

        >>> air = Atmosphere.mars()
        >>> [part.depth([550.0]).round(4).tolist() for part in air.constituents]
        [[0.0028], [0.5]]
        """
        parts = (mars.gas(pressure), mars.dust(dust_depth))
        return cls(parts, albedo, mars.RADIUS, mars.TOP, sun_scale=1 / mars.SUN_DISTANCE**2)

    def depth(self, wavelengths: ArrayLike) -> Array:
        """Vertical optical depth of everything above the ground, (W,); of many airs (..., W), a plain array always."""
        return sum((part.depth(wavelengths) for part in self.constituents), np.zeros(np.size(wavelengths)))

    def albedo_at(self, wavelengths: ArrayLike) -> Array:
        """The ground's albedo, (W,)."""
        return at(self.albedo, wavelengths)

    def sun_at(self, wavelengths: ArrayLike) -> np.ndarray:
        """Irradiance of the sun above the air on a plane that faces it, W m-2 nm-1, (W,)."""
        light = solar_irradiance(wavelengths) if self.sunlight is None else self.sunlight.at(wavelengths)
        return light * self.sun_scale

    def tell_missing_bands(self, wavelengths: ArrayLike) -> None:
        """`MissingBands`, a warning, where light is asked for in bands of gases that the earth's air here lacks."""
        if self.gases is None and abs(self.radius / EARTH_RADIUS - 1) < 0.01:
            tell_missing_bands(wavelengths)

    def transmittance(self, cos_zenith: ArrayLike, wavelengths: ArrayLike) -> np.ndarray:
        """Transmittance of a straight ray from the ground to space, (..., W), through spherical shells.

        `cos_zenith` (...,) is 0 or more. Quadrature over height to about 1e-5. A plain array, of labelled numbers too.

        >>> vacuum = Atmosphere((Molecules(optical_depth=0.0),))
        >>> vacuum.transmittance(0.5, [550.0]).tolist()
        [1.0]
        """
        result: np.ndarray = np.exp(-self.slant_depths(cos_zenith, wavelengths))
        if self.gases is None:
            return result
        water, mixed = (self.slant_column(profile, cos_zenith) for profile in self.gases.profiles)
        return np.asarray(result * self.gases.transmittance(water, mixed, wavelengths))

    def slant_depths(self, cos_zenith: ArrayLike, wavelengths: ArrayLike) -> np.ndarray:
        """Optical depth of the constituents on a straight ray from the ground to space, (..., W)."""
        parts = [
            self.slant_column(part.profile, cos_zenith)[..., None] * part.depth(wavelengths)
            for part in self.constituents
        ]
        return np.asarray(sum(parts))

    @property
    def has_layers(self) -> bool:
        """Whether the density of a constituent jumps, as at the edges of a cloud."""
        return any(part.profile.edges for part in self.constituents)

    def require_no_layers(self, who: str) -> None:
        """ValueError where `who`, that knows smooth air alone, is given layers."""
        if self.has_layers:
            takers = "OvercastSky, DiscreteOrdinates and sky_at(clouds=...) do"
            raise ValueError(f"{who} takes no layers such as a Cloud in its air; {takers}")

    @property
    def is_one(self) -> bool:
        """Whether this is one air, of single numbers, not many airs of arrays."""
        cosines = (part.phase_law.mean_cosine([550.0]) for part in self.constituents)
        return not any(part.of_many for part in self.held) and all(np.ndim(cosine) == 1 for cosine in cosines)

    @property
    def held(self) -> tuple[HeldBySky, ...]:
        """What holds the air's numbers: itself, its constituents, its gases."""
        return (self, *self.constituents, *(() if self.gases is None else (self.gases,)))

    def require_one(self, who: str) -> None:
        """In one line, where `who`, that knows one air of NumPy's at a time, is given arrays, or another library's."""
        cosines = [part.phase_law.mean_cosine([550.0]) for part in self.constituents]
        if any(part.of_another_library for part in self.held) or not all(map(is_numpy, cosines)):
            raise TypeError(f"{who} takes air of plain numbers, got torch's or JAX's; PhysicalSky takes those")
        if not self.is_one:
            raise ValueError(f"{who} takes one air at a time, got arrays of its numbers; PhysicalSky takes many airs")

    def nodes(self, edges: tuple[float, ...]) -> tuple[np.ndarray, np.ndarray]:
        """Heights, m, that stand for the air, and the thickness of each: dense at the ground, or between edges."""
        if not edges:
            t, w = gauss_legendre(200)
            return self.height * t**3, self.height * 3 * t * t * w
        t, w = gauss_legendre(16)
        cuts = np.unique(np.clip([0.0, *edges, self.height], 0.0, self.height))
        steps = np.diff(cuts)[:, None]
        return (cuts[:-1, None] + steps * t).ravel(), (steps * w).ravel()

    def slant_column(self, profile: Profile, cos_zenith: ArrayLike) -> np.ndarray:
        """Vertical columns of a profile on a straight ray from the ground to space, (...,)."""
        heights, steps = self.nodes(profile.edges)
        cosine = np.asarray(cos_zenith, dtype=np.float64)[..., None]
        sine_square = (1 - cosine**2) * (self.radius / (self.radius + heights)) ** 2
        paths = steps / np.sqrt(np.maximum(1 - sine_square, 1e-300))
        column: np.ndarray = paths @ profile.density(heights)
        return column
