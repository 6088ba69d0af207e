"""Hosek and Wilkie's clear sky (2012): nine numbers for each band or channel, fitted to a path tracer.

deviation from the paper | here | why
chi(g, alpha), I alpha^(1/2) as scanned | chi(H, g), I cos^(1/2) t | scanning damage of eq. 8
- | cos t + 0.01 in the gradation | as in the authors' program, to which the tables belong
spectral form ends at 720 nm | `xyz` is the authors' XYZ fit, `radiance` their bands | both are native
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from os import PathLike
from typing import Any, ClassVar

import numpy as np

from skydome.air.atmosphere import USUAL_ALBEDO
from skydome.ground.arguments import numbers, require_kind
from skydome.ground.arrays import Array, constant, floating, limited, namespace, settled
from skydome.ground.directions import elevation
from skydome.ground.interpolation import weights
from skydome.ground.limits.ranges import Range, require
from skydome.ground.tables import archive
from skydome.ground.units import LUMINOUS_EFFICACY
from skydome.light.colour import SRGB, RGBSpace
from skydome.light.spectrum import Spectrum, cie_1931, xyz_weights
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.formula.formula_sky import ColourFormulaSky, Recipe
from skydome.skies.formula.quantity import Quantity
from skydome.skies.formula.sky_tables import SkyTables, blended, control_weights
from skydome.skies.validity import plain

BANDS = np.arange(320.0, 721.0, 40.0)
"""Wavelengths of the spectral form's bands, nm."""

TURBIDITIES = np.arange(1.0, 11.0)
"""Those that the tables hold."""

ALBEDO = Range(0.0, 1.0)
ORDER = np.array([0, 1, 2, 3, 4, 5, 6, 8, 7])
"""From A..I to the tables' columns, which stand in the order A B C D E F G I H."""


def interpolated_coefficients(form: str, turbidity: Array, albedo: Array, sun_elevation: Array) -> Array:
    """R A ... I of every channel, shape (..., channels, 10), of the form "spectral", "xyz" or "rgb".

    `albedo` (...,) or (..., channels) broadcasts against the channels.
    """
    xp = namespace(turbidity, sun_elevation)
    return blended(
        published(form),
        weights(TURBIDITIES, turbidity),
        xp.stack([1 - albedo, albedo], axis=-1),
        control_weights(sun_elevation),
    )


@settled
def published(form: str) -> np.ndarray:
    """The authors' control points of R A ... I, (turbidity, albedo, control, channel, 10)."""
    stored = archive("hosek_wilkie_2013")
    return np.concatenate([stored[f"{form}_radiance"][..., None], stored[f"{form}_parameters"][..., ORDER]], axis=-1)


@settled
def band_weights(wavelengths: Any, bands: np.ndarray = BANDS) -> np.ndarray:
    """Linear interpolation from bands (B,) to wavelengths (W,) nm among them, matrix (B, W); ValueError outside."""
    wavelengths = np.atleast_1d(numbers(wavelengths, "wavelengths"))
    if not wavelengths.size:
        raise ValueError("wavelengths must be one or more, got none")
    require("wavelengths", wavelengths, Range(float(bands[0]), float(bands[-1]), "nm"))
    between: np.ndarray = weights(bands, wavelengths).T
    return between


def channel_albedo(albedo: Any, form: str, like: Array, bands: np.ndarray = BANDS) -> Array:
    """The albedo of each channel: a number or array (...,) for all, (..., 1); of a Spectrum each channel's mean."""
    if not isinstance(albedo, Spectrum):
        return floating(albedo, like=like)[..., None]
    if form == "spectral":
        return constant(albedo.at(bands), like)
    grid = np.arange(380.0, 781.0, 5.0)
    response = cie_1931(grid)
    if form == "rgb":
        response = np.maximum(response @ SRGB.from_xyz.T, 0.0)
    return constant((albedo.at(grid) @ response) / response.sum(axis=0), like)


@dataclass(frozen=True, eq=False)
class HosekWilkieForm(ColourFormulaSky):
    """What the native forms share: sun, turbidity 1-10, and ground albedo 0-1 (a number, an array, or a `Spectrum`)."""

    turbidity: Any
    albedo: Any = USUAL_ALBEDO
    ranges: ClassVar = {"turbidity": Range(1.0, 10.0), "albedo": ALBEDO}
    offset: ClassVar[float] = 0.01
    source: ClassVar[str] = "Hosek and Wilkie 2012, eq. 8; tables of 2013, version 1.4a"

    @property
    def haze(self) -> Any:
        """The turbidity."""
        return self.turbidity

    def form_coefficients(self, form: str) -> Array:
        """R A ... I of the channels of a form, shape (..., channels, 10)."""
        turbidity = self.parameter("turbidity")
        albedo = channel_albedo(self.albedo, form, turbidity)
        if self.check != "raise":
            albedo = limited(albedo, 0.0, 1.0)
        return interpolated_coefficients(form, turbidity, albedo, elevation(self.sun))


@dataclass(frozen=True, eq=False)
class HosekWilkie(HosekWilkieForm, SpectralSky):
    """The clear sky of Hosek and Wilkie: spectral radiance from its 11 bands, colour from its own XYZ fit.

    Known errors: fitted without the sun's disc; 320-720 nm; the XYZ fit and the integral of the bands differ by a few
    percent (docs/models/hosek-wilkie.md gives figures). `HosekWilkieRGB` is the third native form. `tables` (a
    `SkyTables` or its file) put a family of one's own in place of the authors', with its ranges and bands.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=180 * sd.deg, elevation=45 * sd.deg)
    >>> sky = sd.HosekWilkie(sun, turbidity=3.0, albedo=0.2)
    >>> round(float(sky.luminance(sd.ZENITH)))
    2810
    >>> sky.radiance(sd.ZENITH, [400, 550, 700]).shape
    (3,)
    """

    tables: "SkyTables | str | PathLike[str] | None" = None

    def __post_init__(self) -> None:
        """Validate, the file of tables too."""
        _ = self.own
        super().__post_init__()

    @cached_property
    def own(self) -> SkyTables | None:
        """The tables of one's own, read from their file; None for the authors'."""
        given = self.tables
        require_kind(given, SkyTables | str | PathLike | None, "tables", "a SkyTables or its file")
        return given if given is None or isinstance(given, SkyTables) else SkyTables.load(given)

    @property
    def limits(self) -> Mapping[str, Range]:
        """The ranges of the tables."""
        if self.own is None:
            return self.ranges
        spans = {"turbidity": self.own.turbidities, "albedo": self.own.albedos}
        return {name: Range(float(nodes[0]), float(nodes[-1])) for name, nodes in spans.items()}

    @property
    def bands(self) -> np.ndarray:  # type: ignore[override]
        """Wavelengths of the bands, nm."""
        return BANDS if self.own is None else self.own.wavelengths

    @property
    def valid(self) -> Array:
        """True where turbidity, albedo and sun lie where they were fitted."""
        lowest = -np.pi if self.own is None else self.own.lowest - 1e-9
        return super().valid & (elevation(self.sun) >= lowest)

    def parameters(self) -> dict[str, Any]:
        """Parameters for provenance, the tables as they were read."""
        return super().parameters() | {"tables": plain(self.own)}

    def band_coefficients(self) -> Array:
        """R A ... I of each band, shape (..., W, 10)."""
        if self.own is None:
            return self.form_coefficients("spectral")
        turbidity = self.parameter("turbidity")
        albedo = channel_albedo(self.albedo, "spectral", turbidity, self.bands)
        return self.own.coefficients(turbidity, albedo, elevation(self.sun))

    def coefficients(self) -> Array:
        """R A ... I of X, Y, Z, shape (..., 3, 10); of the bands where the sky is by tables of one's own."""
        return self.form_coefficients("xyz") if self.own is None else self.band_coefficients()

    def xyz_recipe(self) -> Recipe:
        """The XYZ fit times 683 lm W-1; by tables of one's own the integral of the bands."""
        matrix = LUMINOUS_EFFICACY * np.eye(3) if self.own is None else xyz_weights(self.bands).T
        return self.coefficients(), Quantity(matrix)

    def luminance_recipe(self) -> Recipe:
        """The Y of the XYZ."""
        if self.own is not None:
            return self.coefficients(), Quantity(xyz_weights(self.bands).T[1:2])
        return self.coefficients()[..., 1:2, :], Quantity(LUMINOUS_EFFICACY * np.eye(1))

    def radiance_recipe(self, wavelengths: Any) -> Recipe:
        """The bands that the wavelengths need, and their linear interpolation."""
        between = band_weights(wavelengths, self.bands)
        used = np.flatnonzero(between.any(axis=1))
        first, last = used[0], used[-1] + 1
        return self.band_coefficients()[..., first:last, :], Quantity(between[first:last].T)

    def radiance(self, directions: Array, wavelengths: Any, out: np.ndarray | None = None) -> Array:
        """Spectral radiance at 320-720 nm, linear between bands, W m-2 sr-1 nm-1, shape (..., W). See `light`."""
        return self.light(directions, self.radiance_recipe(wavelengths), out)


@dataclass(frozen=True, eq=False)
class HosekWilkieRGB(HosekWilkieForm):
    """The clear sky of Hosek and Wilkie in its native linear sRGB form, as renderers use it.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=180 * sd.deg, elevation=45 * sd.deg)
    >>> red, green, blue = sd.HosekWilkieRGB(sun, turbidity=3.0, albedo=0.2).rgb(sd.ZENITH)
    >>> bool(blue > green > red)
    True
    """

    def coefficients(self) -> Array:
        """R A ... I of R, G, B, shape (..., 3, 10)."""
        return self.form_coefficients("rgb")

    def rgb_recipe(self, space: RGBSpace = SRGB) -> Recipe:
        """The RGB fit times 683 lm W-1, by way of XYZ in spaces other than sRGB."""
        coefficients, quantity = self.coefficients(), Quantity(LUMINOUS_EFFICACY * np.eye(3))
        return coefficients, quantity if space is SRGB else quantity.then(space.from_xyz @ SRGB.to_xyz)

    def xyz_recipe(self) -> Recipe:
        """The XYZ of the RGB fit."""
        return self.coefficients(), Quantity(LUMINOUS_EFFICACY * SRGB.to_xyz)

    def luminance_recipe(self) -> Recipe:
        """The Y of the RGB fit."""
        return self.coefficients(), Quantity(LUMINOUS_EFFICACY * SRGB.to_xyz[1:2])
