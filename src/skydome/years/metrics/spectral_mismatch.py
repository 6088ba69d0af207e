"""How much more or less a photovoltaic cell makes of daylight's spectrum than of the reference one (IEC 60904-7)."""

from typing import TYPE_CHECKING, Any

import numpy as np

from skydome.ground.arguments import numbers, require_kind
from skydome.ground.arrays import safe_divide
from skydome.ground.extras import required
from skydome.light.spectrum import Spectrum, checked_wavelengths

if TYPE_CHECKING:
    import xarray

NEEDED = ("radiance", "direct_normal_spectral_irradiance")


def reference_spectrum() -> Spectrum:
    """Global irradiance of ASTM G173-03 on 37 degrees, air mass 1.5, 280-4000 nm, W m-2 nm-1, as pvlib carries it."""
    required("pvlib", "weather", "the reference spectrum of photovoltaics")
    from pvlib.spectrum import get_reference_spectra

    table = get_reference_spectra()["global"]
    return Spectrum(table.index.to_numpy(), table.to_numpy())


def spectral_mismatch(
    irradiance: Any, wavelengths: Any, response: Spectrum, reference: Spectrum | None = None
) -> np.ndarray:
    """Spectral mismatch of irradiance (..., W), W m-2 nm-1, at `wavelengths` (W,), nm, (...,): 1 for the reference's.

    The share of its energy that a cell of spectral `response` (A W-1, 0 outside its samples) uses, over the share that
    it uses of the `reference` (AM1.5 global of ASTM G173-03 if None), both at the light's wavelengths and over them
    alone: IEC 60904-7, ASTM E973, as pvlib's `calc_spectral_mismatch_field` has it. NaN without light.

    >>> cell = Spectrum([300.0, 1000.0, 1200.0], [0.1, 0.7, 0.0])
    >>> flat = Spectrum([300.0, 2500.0], [1.0, 1.0])
    >>> waves = np.arange(300.0, 1201.0, 10.0)
    >>> spectral_mismatch(np.stack([np.ones(91), waves / 1000]), waves, cell, flat).round(3).tolist()
    [1.0, 1.071]
    """
    require_kind(response, Spectrum, "response", "Spectrum([300, 1000, 1200], [0.1, 0.7, 0.0])")
    require_kind(reference, Spectrum | None, "reference", "reference_spectrum()")
    w = checked_wavelengths(wavelengths)
    light = numbers(irradiance, "irradiance")
    known = reference_spectrum() if reference is None else reference
    inside = (w >= response.wavelengths[0]) & (w <= response.wavelengths[-1])
    cell = np.where(inside, response.at(w), 0.0)
    used, of_reference = (
        safe_divide(np.trapezoid(each * cell, w), np.trapezoid(each, w)) for each in (light, known.at(w))
    )
    return np.where(used > 0, used / of_reference, np.nan)


def spectra_on_planes(light: "xarray.Dataset", skies: "xarray.Dataset") -> np.ndarray:
    """Spectral irradiance on planes, W m-2 nm-1, (T, P, W), of `on_planes` and the spectral year it is of.

    The sky's part has the spectrum of the diffuse horizontal light, the sun's its own, what is reflected, by grey
    surfaces, that of both; each is as strong as its illuminance. ValueError for a year without spectra.
    """
    if any(name not in skies for name in NEEDED):
        raise ValueError('spectra need a year with wavelengths: sd.year(site, colour="physical", wavelengths=...)')
    sky = np.einsum("tpw,p->tw", skies["radiance"].values, skies["horizontal_solid_angle"].values)
    sun = skies["direct_normal_spectral_irradiance"].values.astype(np.float64)
    level, beam = (skies[f"{name}_illuminance"].values for name in ("diffuse_horizontal", "direct_normal"))
    sine = np.maximum(np.sin(np.radians(skies["sun_elevation"].values)), 0)
    both = safe_divide(sky + sun * sine[:, None], (level + beam * sine)[:, None])
    of_sky, of_sun = safe_divide(sky, level[:, None]), safe_divide(sun, beam[:, None])
    parts = {"sky": of_sky, "sun": of_sun, "reflected": both}
    found: np.ndarray = sum(
        light[f"{name}_illuminance"].values[..., None] * spectrum[:, None] for name, spectrum in parts.items()
    )
    return found


def mismatch_on_planes(
    light: "xarray.Dataset", skies: "xarray.Dataset", response: Spectrum, reference: Spectrum | None = None
) -> "xarray.DataArray":
    """Spectral mismatch of planes through a year, (time, plane), NaN at night: what a cell's current is multiplied by.

    `light` of `on_planes`, `skies` the year it is of, made with `colour="physical"` and wavelengths over the cell's
    response and well beyond, as the share of energy is of those alone: 300 to 2500 nm. As `spectral_mismatch`.
    """
    required("xarray", "year", "a spectral mismatch")
    import xarray

    waves = skies["wavelength"].values
    values = spectral_mismatch(spectra_on_planes(light, skies), waves, response, reference)
    about = {"units": "1", "long_name": "spectral mismatch (IEC 60904-7)"}
    return xarray.DataArray(values, light["irradiance"].coords, ("time", "plane"), "spectral_mismatch", about)
