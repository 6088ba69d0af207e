"""What daylight does on planes: melanopic illuminance (CIE S 026), photosynthetic photons, daily light integrals."""

from typing import TYPE_CHECKING, Any

import numpy as np

from skydome.ground.arrays import safe_divide
from skydome.ground.directions import direction
from skydome.ground.extras import required
from skydome.ground.units import deg
from skydome.light.action_spectra import melanopic_edi, photosynthetic_photons
from skydome.light.spectrum import xyz_weights
from skydome.skies.suns.preetham_sun import PreethamSun

if TYPE_CHECKING:
    import xarray

EVERY = np.arange(380.0, 721.0, 5.0)
"""Wavelengths, nm: beyond 720, where the disc of the sun is not known, there is neither photosynthesis nor sight."""
NEEDED = ("diffuse_melanopic_edi", "diffuse_photosynthetic_photons")


def doses(light: "xarray.Dataset", skies: "xarray.Dataset", turbidity: float = 3.0) -> "xarray.Dataset":
    """Melanopic EDI, lx, and photosynthetic photons, micromoles m-2 s-1, on planes, (time, plane), and daily integrals.

    `light` of `on_planes`, `skies` the year it is of, made with a colour and wavelengths: `sd.year(site,
    colour="hosek-wilkie", wavelengths=[550])`. The sky's light has the ratios of the horizontal diffuse light, the
    sun's those of clear air of `turbidity` (Preetham 1999, A.1) at the sun's height, what is reflected, by grey
    surfaces, those of both. `daily_light_integral` (date, plane), mol m-2; `melanopic_dose`, klx h of melanopic EDI
    (CIE S 026:2018). ValueError for a year without colour.
    """
    required("xarray", "year", "doses of light")
    import xarray

    if any(name not in skies for name in NEEDED):
        raise ValueError('doses need a year with spectra: sd.year(site, colour="hosek-wilkie", wavelengths=[550])')
    found: dict[str, Any] = {}
    texts = {"melanopic_edi": ("lx", "melanopic EDI (CIE S 026)")}
    texts["photosynthetic_photons"] = ("umol m-2 s-1", "photosynthetic photons, 400-700 nm")
    suns = direction(skies["sun_azimuth"].values * deg, skies["sun_elevation"].values * deg)
    for name, of_sun in sun_ratios(suns, turbidity).items():
        diffuse, level = skies[f"diffuse_{name}"].values, skies["diffuse_horizontal_illuminance"].values
        of_sky = safe_divide(diffuse, level)
        sky, sun, reflected = (light[f"{part}_illuminance"].values for part in ("sky", "sun", "reflected"))
        direct = skies["direct_normal_illuminance"].values * np.maximum(suns[:, 2], 0)
        of_both = safe_divide(diffuse + direct * of_sun, level + direct)
        values = sky * of_sky[:, None] + sun * of_sun[:, None] + reflected * of_both[:, None]
        unit, text = texts[name]
        found[name] = (("time", "plane"), values, {"units": unit, "long_name": f"{text} on the plane"})
    data = xarray.Dataset(found, light.coords, light.attrs)
    day = data["local_time"].dt.floor("D").rename("date")
    seconds = data["interval_hours"] * 3600
    integral = (data["photosynthetic_photons"] * seconds * 1e-6).groupby(day).sum("time")
    dose = (data["melanopic_edi"] * data["interval_hours"] / 1000).groupby(day).sum("time")
    data["daily_light_integral"] = integral.assign_attrs(units="mol m-2", long_name="daily light integral (PAR)")
    data["melanopic_dose"] = dose.assign_attrs(units="klx h", long_name="daily dose of melanopic EDI")
    return data


def sun_ratios(suns: np.ndarray, turbidity: float) -> dict[str, np.ndarray]:
    """Melanopic EDI and photosynthetic photons per lx of the sun's direct light, (T,) each; 0 at night."""
    up = np.flatnonzero(suns[:, 2] > 0)
    spectrum = np.asarray(PreethamSun(suns[up], turbidity, check="clamp").irradiance(EVERY))
    light = spectrum @ xyz_weights(EVERY)[:, 1]
    kinds = {"melanopic_edi": melanopic_edi, "photosynthetic_photons": photosynthetic_photons}
    found = {name: np.zeros(len(suns)) for name in kinds}
    for name, action in kinds.items():
        found[name][up] = safe_divide(action(spectrum, EVERY), light)
    return found
