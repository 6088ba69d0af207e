"""Colour and spectrum for a year of measured skies: a clear sky's, direction by direction, at Perez's luminance."""

from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from skydome.dome.patches import Patches
from skydome.ground.arrays import safe_divide
from skydome.light.colour_temperature import colour_temperature
from skydome.light.spectrum import checked_wavelengths, xyz_weights
from skydome.skies.sky import SpectralSky
from skydome.year.action_spectra import melanopic_edi, photosynthetic_photons
from skydome.year.perez_year import PerezYear

if TYPE_CHECKING:
    import xarray

Clear = Literal["preetham", "hosek-wilkie"]
VALUES_AT_ONCE = 1 << 21
EVERY = np.arange(380.0, 781.0, 10.0)


def clear_sky(kind: str, suns: np.ndarray, turbidity: Any) -> SpectralSky:
    """The clear sky that lends its colour, parameters (K, 1); ValueError for another name."""
    from skydome.skies.hosek_wilkie import HosekWilkie
    from skydome.skies.preetham import Preetham

    haze = np.broadcast_to(np.asarray(turbidity, dtype=np.float64), (len(suns),))[:, None]
    if kind == "preetham":
        return Preetham(suns[:, None], haze)
    if kind == "hosek-wilkie":
        return HosekWilkie(suns[:, None], haze, 0.2)
    raise ValueError(f'colour must be "preetham" or "hosek-wilkie", got {kind!r}')


def pieces(sky: PerezYear, cut: Patches, each: int) -> list[slice]:
    """The lit hours in slices whose arrays hold about `VALUES_AT_ONCE` numbers."""
    step = max(1, VALUES_AT_ONCE // (cut.count * each))
    return [slice(k, k + step) for k in range(0, len(sky.lit), step)]


def hazes(turbidity: Any, sky: PerezYear, count: int) -> np.ndarray:
    """Turbidity of each lit hour (K,), from a number or one of each interval (T,)."""
    haze: np.ndarray = np.broadcast_to(np.asarray(turbidity, dtype=np.float64), (count,))[sky.lit]
    return haze


def add_colour(data: "xarray.Dataset", sky: PerezYear, cut: Patches, colour: Clear, turbidity: Any) -> None:
    """Add `xyz` (time, patch, channel), Y the luminance, and `diffuse_colour_temperature` (time), K."""
    haze = hazes(turbidity, sky, len(data.time))
    luminance = data["luminance"].values
    xyz = np.zeros((*luminance.shape, 3), np.float32)
    for part in pieces(sky, cut, 12):
        rows = sky.lit[part]
        clear = np.asarray(clear_sky(colour, sky.suns[rows], haze[part]).xyz(cut.directions))
        xyz[rows] = clear * safe_divide(luminance[rows], clear[..., 1])[..., None]
    xyz[np.isnan(luminance)] = np.nan
    unit = {"units": "cd m-2", "long_name": f"CIE 1931 XYZ, chromaticity of {colour}, luminance of Perez"}
    data["xyz"] = (("time", "patch", "channel"), xyz, unit)
    data.coords["channel"] = list("XYZ")
    kelvin = colour_temperature(np.einsum("tpc,p->tc", xyz, cut.horizontal_solid_angles))
    text = {"units": "K", "long_name": "correlated colour temperature of the diffuse horizontal light"}
    data["diffuse_colour_temperature"] = ("time", kelvin, text)
    data.attrs["colour"] = colour


def add_spectrum(
    data: "xarray.Dataset", sky: PerezYear, cut: Patches, colour: Clear, turbidity: Any, wavelengths: Any
) -> None:
    """Add `radiance` (time, patch, wavelength) and the melanopic EDI and PAR of the diffuse horizontal light.

    Each direction's clear spectrum is scaled so that its luminance (380-780 nm) is Perez's.
    """
    w = checked_wavelengths(wavelengths)
    haze = hazes(turbidity, sky, len(data.time))
    luminance = data["luminance"].values
    radiance = np.zeros((*luminance.shape, w.size), np.float32)
    horizontal = np.zeros((len(luminance), EVERY.size))
    weights = xyz_weights(EVERY)[:, 1]
    within = EVERY[(EVERY >= 380) & (EVERY <= 720)] if colour == "hosek-wilkie" else EVERY
    for part in pieces(sky, cut, 3 * EVERY.size + w.size):
        rows = sky.lit[part]
        clear = clear_sky(colour, sky.suns[rows], haze[part])
        known = np.asarray(clear.radiance(cut.directions, within))
        every = np.zeros((*known.shape[:-1], EVERY.size))
        every[..., : within.size] = known
        factor = safe_divide(luminance[rows].astype(np.float64), every @ weights)[..., None]
        radiance[rows] = np.asarray(clear.radiance(cut.directions, w)) * factor
        horizontal[rows] = np.einsum("tpw,p->tw", every * factor, cut.horizontal_solid_angles)
    radiance[np.isnan(luminance)] = np.nan
    horizontal[np.isnan(luminance).any(axis=1)] = np.nan
    unit = {"units": "W m-2 sr-1 nm-1", "long_name": f"spectral radiance, spectrum of {colour}, luminance of Perez"}
    data["radiance"] = (("time", "patch", "wavelength"), radiance, unit)
    data.coords["wavelength"] = ("wavelength", w, {"units": "nm"})
    melanopic, photons = melanopic_edi(horizontal, EVERY), photosynthetic_photons(horizontal, EVERY)
    text = {"units": "lx", "long_name": "melanopic EDI (CIE S 026) of the diffuse horizontal light"}
    data["diffuse_melanopic_edi"] = ("time", melanopic, text)
    text = {"units": "umol m-2 s-1", "long_name": "photosynthetic photons (400-700 nm) of the diffuse horizontal light"}
    data["diffuse_photosynthetic_photons"] = ("time", photons, text)
