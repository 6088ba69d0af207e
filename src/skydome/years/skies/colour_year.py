"""Colour and spectrum for a year of measured skies, at Perez's luminance: a clear sky's and clouds', mixed."""

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from skydome.dome.patches import Patches
from skydome.ground.arrays import safe_divide
from skydome.light.action_spectra import melanopic_edi, photosynthetic_photons
from skydome.light.colour_temperature import colour_temperature
from skydome.light.spectrum import checked_wavelengths, xyz_weights
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.model import Model
from skydome.years.skies.clouds import cloud_share
from skydome.years.skies.overcast_light import WAVELENGTHS, overcast_spectra, overcast_xyz
from skydome.years.skies.perez_year import PerezYear
from skydome.years.skies.sun_spectra import continued, sun_spectra

if TYPE_CHECKING:
    import xarray

VALUES_AT_ONCE = 1 << 21
EVERY = np.arange(380.0, 781.0, 10.0)


def lender(kind: str) -> Model:
    """The clear model that lends its colour; ValueError for another name."""
    from skydome.skies.catalogue import CATALOGUE

    lenders = {model.name: model for model in CATALOGUE if model.is_clear_spectrum}
    if kind not in lenders:
        raise ValueError(f"colour must be one of {', '.join(lenders)}, got {kind!r}")
    return lenders[kind]


def clear_sky(kind: str, suns: np.ndarray, turbidity: Any, altitude: float) -> SpectralSky:
    """The clear sky that lends its colour under suns (K, 3) of a site so many metres above the sea.

    Parameters are (K, 1), or a number where it is one.
    """
    haze = np.broadcast_to(np.asarray(turbidity, dtype=np.float64), (len(suns),))
    one = len(haze) > 0 and bool((haze == haze[0]).all())
    model = lender(kind)
    given = {"turbidity": float(haze[0]) if one else haze[:, None]} | model.at_altitude(altitude)
    sky: Any = model.make(suns[:, None], given)
    clear: SpectralSky = sky
    return clear


def pieces(sky: PerezYear, cut: Patches, each: int) -> list[slice]:
    """The lit hours in slices whose arrays hold about `VALUES_AT_ONCE` numbers."""
    step = max(1, VALUES_AT_ONCE // (cut.count * each))
    return [slice(k, k + step) for k in range(0, len(sky.lit), step)]


class Weathered(NamedTuple):
    """Turbidity and share of cloud of each lit hour, (K,)."""

    haze: np.ndarray
    clouds: np.ndarray

    @classmethod
    def of(cls, sky: PerezYear, count: int, turbidity: Any, clouds: Any = None) -> "Weathered":
        """From numbers, or one of each interval (T,); clouds of None are estimated. ValueError outside 0-1."""
        haze = np.broadcast_to(np.asarray(turbidity, dtype=np.float64), (count,))[sky.lit]
        if clouds is None:
            return cls(haze, cloud_share(sky.suns[sky.lit], haze, sky.direct))
        given = np.broadcast_to(np.asarray(clouds, dtype=np.float64), (count,))[sky.lit]
        if not ((given >= 0) & (given <= 1)).all():
            raise ValueError(f"clouds must lie in [0, 1], got {given[~((given >= 0) & (given <= 1))][0]}")
        return cls(haze, given)


def split(luminance: np.ndarray, clouds: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Luminance (K, N) that comes from the clear sky and that from clouds, float64, each (K, N)."""
    cloudy = luminance * clouds[:, None]
    return luminance - cloudy, cloudy


def add_colour(data: "xarray.Dataset", sky: PerezYear, cut: Patches, colour: str, air: Weathered) -> None:
    """Add `xyz` (time, patch, channel), Y the luminance, `diffuse_colour_temperature`, K, and `cloud_share` (time)."""
    luminance = data["luminance"].values
    xyz = np.zeros((*luminance.shape, 3), np.float32)
    for part in pieces(sky, cut, 12):
        rows = sky.lit[part]
        clear = np.asarray(
            clear_sky(colour, sky.suns[rows], air.haze[part], data.attrs["altitude"]).xyz(cut.directions)
        )
        blue, grey = split(luminance[rows], air.clouds[part])
        clouded = overcast_xyz(sky.suns[rows])[:, None]
        xyz[rows] = clear * safe_divide(blue, clear[..., 1])[..., None] + grey[..., None] * clouded
    xyz[np.isnan(luminance)] = np.nan
    text = f"CIE 1931 XYZ, chromaticity of {colour} and of overcast light, luminance of Perez"
    data["xyz"] = (("time", "patch", "channel"), xyz, {"units": "cd m-2", "long_name": text})
    data.coords["channel"] = list("XYZ")
    kelvin = colour_temperature(np.einsum("tpc,p->tc", xyz, cut.horizontal_solid_angles))
    text = "correlated colour temperature of the diffuse horizontal light"
    data["diffuse_colour_temperature"] = ("time", kelvin, {"units": "K", "long_name": text})
    clouds = np.where(np.isnan(luminance[:, 0]), np.nan, 0.0)
    clouds[sky.lit] = air.clouds
    data["cloud_share"] = (
        "time",
        clouds,
        {"units": "1", "long_name": "share of light that has overcast light's colour"},
    )
    data.attrs["colour"] = colour


def add_spectrum(
    data: "xarray.Dataset", sky: PerezYear, cut: Patches, colour: str, air: Weathered, wavelengths: Any
) -> None:
    """Add `radiance` (time, patch, wavelength), the sun's spectrum, melanopic EDI and PAR of diffuse horizontal light.

    Each direction's clear spectrum and overcast light are scaled so that their luminance (380-780 nm) is Perez's.
    """
    w = checked_wavelengths(wavelengths)
    luminance = data["luminance"].values
    radiance = np.zeros((*luminance.shape, w.size), np.float32)
    horizontal = np.zeros((len(luminance), EVERY.size))
    weights = xyz_weights(EVERY)[:, 1]
    altitude = data.attrs["altitude"]
    for part in pieces(sky, cut, 3 * EVERY.size + w.size):
        rows = sky.lit[part]
        clear = clear_sky(colour, sky.suns[rows], air.haze[part], altitude)
        gas: Any = clear_sky("physical", sky.suns[rows], air.haze[part], altitude)
        clouded, clouded_every = (overcast_spectra(sky.suns[rows], waves) for waves in (w, EVERY))
        clouded = continued(clouded, WAVELENGTHS[[0, -1]], gas.atmosphere, sky.suns[rows], altitude, w)
        every = visible_radiance(clear, cut)
        blue, grey = split(luminance[rows].astype(np.float64), air.clouds[part])
        factor = safe_divide(blue, every @ weights)[..., None]
        radiance[rows] = np.asarray(clear.radiance(cut.directions, w)) * factor + grey[..., None] * clouded[:, None]
        horizontal[rows] = np.einsum("tpw,p->tw", every * factor, cut.horizontal_solid_angles)
        horizontal[rows] += (grey @ cut.horizontal_solid_angles)[:, None] * clouded_every
    radiance[np.isnan(luminance)] = np.nan
    horizontal[np.isnan(luminance).any(axis=1)] = np.nan
    text = f"spectral radiance, spectrum of {colour} and of overcast light, luminance of Perez"
    unit = {"units": "W m-2 sr-1 nm-1", "long_name": text}
    data["radiance"] = (("time", "patch", "wavelength"), radiance, unit)
    data.coords["wavelength"] = ("wavelength", w, {"units": "nm"})
    add_sun(data, sky, air, w)
    add_effects(data, horizontal)


def add_sun(data: "xarray.Dataset", sky: PerezYear, air: Weathered, w: np.ndarray) -> None:
    """Add `direct_normal_spectral_irradiance` (time, wavelength), whose luminance is the direct illuminance."""
    spectra = np.zeros((data.sizes["time"], w.size), np.float32)
    spectra[np.isnan(data["direct_normal_illuminance"].values)] = np.nan
    level = data["direct_normal_illuminance"].values[sky.lit]
    shining = np.flatnonzero(level > 0)
    rows = sky.lit[shining]
    altitude = data.attrs["altitude"]
    clear: Any = clear_sky("physical", sky.suns[rows], air.haze[shining], altitude)
    spectra[rows] = sun_spectra(clear.atmosphere, sky.suns[rows], altitude, level[shining], w)
    text = "spectral irradiance of the sun on a plane facing it, spectrum of clear air, at the direct illuminance"
    unit = {"units": "W m-2 nm-1", "long_name": text}
    data["direct_normal_spectral_irradiance"] = (("time", "wavelength"), spectra, unit)


def visible_radiance(clear: SpectralSky, cut: Patches) -> np.ndarray:
    """Spectral radiance of the clear skies at `EVERY`, (K, N, 41); 0 beyond their bands, as Hosek and Wilkie's 720."""
    within = EVERY[clear.bands[-1] >= EVERY]
    known = np.asarray(clear.radiance(cut.directions, within))
    every = np.zeros((*known.shape[:-1], EVERY.size))
    every[..., : within.size] = known
    return every


def add_effects(data: "xarray.Dataset", horizontal: np.ndarray) -> None:
    """Add what the horizontal irradiance (T, 41) at `EVERY` does: melanopic EDI, photosynthetic photons."""
    melanopic, photons = melanopic_edi(horizontal, EVERY), photosynthetic_photons(horizontal, EVERY)
    text = {"units": "lx", "long_name": "melanopic EDI (CIE S 026) of the diffuse horizontal light"}
    data["diffuse_melanopic_edi"] = ("time", melanopic, text)
    text = {"units": "umol m-2 s-1", "long_name": "photosynthetic photons (400-700 nm) of the diffuse horizontal light"}
    data["diffuse_photosynthetic_photons"] = ("time", photons, text)
