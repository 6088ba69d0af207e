"""sun_disc.png and the measured tables of models/sun-disc.md: the published disc beside Bird's clear-sky beam."""

import numpy as np
from drawing import keep_plot, sky_toward, table, update
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

import skydome as sd
from skydome.light.spectrum import cie_1931
from skydome.skies.suns.sun_disc import MEAN_RADIUS, PUBLISHED_RADIUS, limb_darkening, limb_mean

ELEVATIONS = (90, 60, 45, 20, 10, 5)
TURBIDITIES = (2.0, 3.0, 6.0)
PAGE = "models/sun-disc.md"
ANGSTROM_EXPONENT, WATER, OZONE, SPRING = 1.3, 1.4, 0.33, 94


def published(elevation, turbidity, radius=MEAN_RADIUS):
    """Direct normal illuminance of the disc, lx."""
    return float(sd.SunDisc(sky_toward(elevation), turbidity, radius).normal_xyz[1])


def lux(wavelengths, irradiance):
    grid = np.arange(380.0, 781.0)
    return 683 * float(np.interp(grid, wavelengths, irradiance) @ cie_1931(grid)[:, 1])


def bird(elevation, turbidity, part="dni"):
    """Illuminance, direct normal ("dni") or diffuse horizontal ("dhi"), by Bird and Riordan's SPCTRAL2 (pvlib), lx.

    Haze of optical depth (T - 1) 0.098 at 550 nm, Angstrom exponent 1.3; 1.4 cm of water, 0.33 cm of ozone.
    """
    from pvlib.atmosphere import get_relative_airmass
    from pvlib.spectrum import spectrl2

    zenith = 90.0 - elevation
    result = spectrl2(
        apparent_zenith=zenith, aoi=zenith, surface_tilt=0, ground_albedo=0.2, surface_pressure=101325,
        relative_airmass=get_relative_airmass(zenith, "kastenyoung1989"), precipitable_water=WATER, ozone=OZONE,
        aerosol_turbidity_500nm=(turbidity - 1) * 0.098 * 1.1**ANGSTROM_EXPONENT, dayofyear=SPRING,
        alpha=ANGSTROM_EXPONENT,
    )  # fmt: skip
    return lux(result["wavelength"], result[part].ravel())


def standard_beam():
    """Illuminance of the ASTM G173 direct beam (air mass 1.5), lx."""
    from pvlib.spectrum import get_reference_spectra

    spectra = get_reference_spectra(standard="ASTM G173-03")
    return lux(spectra.index.to_numpy(), spectra["direct"].to_numpy())


def levels():
    rows = []
    for elevation in ELEVATIONS:
        cells = []
        for turbidity in TURBIDITIES:
            ours, theirs = published(elevation, turbidity), bird(elevation, turbidity)
            cells.append(f"{ours / 1000:.1f} / {theirs / 1000:.1f} = {ours / theirs:.2f}")
        rows.append([f"{elevation}°", *cells])
    return table(["sun's elevation", *(f"T = {t:g}" for t in TURBIDITIES)], rows)


def limb():
    bands = np.arange(320.0, 721.0, 80.0)
    rows = [["mean / centre", *(f"{mean:.3f}" for mean in limb_mean(bands))]]
    edge = limb_darkening(np.array([0.2]), bands)[0]
    rows.append(["at 0.98 of the radius / centre", *(f"{value:.3f}" for value in edge)])
    return table(["", *(f"{band:g} nm" for band in bands)], rows)


def tables():
    return {"levels": levels(), "limb": limb(), "others": others()}


def others():
    """The smaller figures of the page."""
    ratio = published(45, 3.0, PUBLISHED_RADIUS) / published(45, 3.0)
    return table(
        ["quantity", "value"],
        [
            ["authors' radius 0.255° instead of 0.2666°: illuminance times", f"{ratio:.3f}"],
            ["ASTM G173 direct beam, air mass 1.5 (sun 41.8° high)", f"{standard_beam() / 1000:.1f} klx"],
            ["published disc, sun 41.8° high, T = 2", f"{published(41.8, 2.0) / 1000:.1f} klx"],
        ],
    )


def figure():
    sheet = Figure(figsize=(9, 3.6), layout="constrained")
    FigureCanvasAgg(sheet)
    left, right = sheet.subplots(1, 2)
    elevations = np.linspace(2, 90, 45)
    for turbidity, colour in zip(TURBIDITIES, ("tab:blue", "tab:green", "tab:red"), strict=True):
        ours = [published(elevation, turbidity) / 1000 for elevation in elevations]
        theirs = [bird(elevation, turbidity) / 1000 for elevation in elevations]
        left.plot(elevations, ours, color=colour, label=f"published, T = {turbidity:g}")
        left.plot(elevations, theirs, "--", color=colour, label=f"SPCTRAL2, T = {turbidity:g}")
    left.set(xlabel="sun's elevation, degrees", ylabel="direct normal illuminance, klx")
    across = np.linspace(0, 1, 201)
    for wavelength, colour in ((400.0, "tab:purple"), (520.0, "tab:green"), (680.0, "tab:red")):
        profile = limb_darkening(np.sqrt(1 - across**2), [wavelength])[:, 0]
        right.plot(across, profile, color=colour, label=f"{wavelength:g} nm")
    right.set(xlabel="distance from the centre, radii", ylabel="radiance over the centre's", ylim=(0, 1.05))
    for axis in (left, right):
        axis.grid(alpha=0.3)
        axis.legend(fontsize=7)
    return sheet


if __name__ == "__main__":
    keep_plot(figure(), "sun_disc")
    update(PAGE, tables())
