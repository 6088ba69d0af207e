"""A year for Radiance: daylight matrices (.mtx), the sky of one hour (.rad with its .cal), lists of suns."""

from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from skydome.ground.directions import direction
from skydome.ground.units import RADIANCE_EFFICACY, deg
from skydome.ground.writing import appearing
from skydome.light.colour import RADIANCE, rgb_from_xyz
from skydome.light.radiance_bands import band_weights, scaled
from skydome.skies.formula.perez_formula import A, B, C, D, E, F, R
from skydome.skies.perez_all_weather import PerezAllWeather
from skydome.years.gendaymtx import text as matrix_text
from skydome.years.gendaymtx.matrix import GROUND_REFLECTANCE

if TYPE_CHECKING:
    import xarray

SUN_DIAMETER = 0.533 * deg
"""What Radiance's tools give the sun, radians."""

SUN_SIZE = 2 * np.pi * (1 - np.cos(SUN_DIAMETER / 2))
ROWS_AT_ONCE = 64


def write_matrix(
    data: "xarray.Dataset",
    path: str | PathLike[str],
    binary: bool = True,
    reflectance: float = GROUND_REFLECTANCE,
    with_sun: bool = False,
) -> None:
    """Write the skies of a year as gendaymtx would, whole or not at all: the ground's row, then the patches; R, G, B.

    Radiance's unit: luminance over 179 lm W-1; grey, or coloured where the data have `xyz`. `with_sun` spreads the
    sun's light over the patch in which it stands. Missing hours are 0. ValueError for patches that are not Reinhart's.
    """
    if not data.attrs["patches"].startswith(("tregenza", "reinhart")):
        raise ValueError(f".mtx files hold Tregenza's or Reinhart's patches, got {data.attrs['patches']}")
    shape = (data.sizes["patch"] + 1, data.sizes["time"])
    place = (data.attrs["latitude"], data.attrs["longitude"])
    with appearing(path) as beside, beside.open("wb") as file:
        matrix_text.write(
            file, matrix_rows(data, reflectance, with_sun), shape, place, "float" if binary else "ascii", "skydome year"
        )


def matrix_rows(data: "xarray.Dataset", reflectance: float, with_sun: bool) -> Any:
    """The rows, some at a time, (J, T, 3), float32."""
    sun = np.nan_to_num(data["direct_normal_illuminance"].values)
    falling = np.nan_to_num(data["diffuse_horizontal_illuminance"].values)
    falling = falling + sun * np.maximum(np.sin(data["sun_elevation"].values * deg), 0)
    yield np.repeat((reflectance / np.pi / RADIANCE_EFFICACY * falling)[None, :, None], 3, axis=-1).astype(np.float32)
    stands, size = data["sun_patch"].values, data["solid_angle"].values
    for k in range(0, data.sizes["patch"], ROWS_AT_ONCE):
        part = slice(k, k + ROWS_AT_ONCE)
        if "xyz" in data:
            light = rgb_from_xyz(data["xyz"].isel(patch=part).values, RADIANCE).transpose(1, 0, 2)
        else:
            light = np.repeat(data["luminance"].isel(patch=part).values.T[..., None], 3, axis=-1)
        light = np.nan_to_num(light) / RADIANCE_EFFICACY
        if with_sun:
            hours = np.flatnonzero((stands >= k) & (stands < k + len(light)) & (sun > 0))
            patch = stands[hours]
            light[patch - k, hours] += (sun[hours] / (RADIANCE_EFFICACY * size[patch]))[:, None]
        yield light.astype(np.float32)


def write_suns(data: "xarray.Dataset", path: str | PathLike[str]) -> int:
    """Write one light source for each hour with sun (as `gendaymtx -D` does); how many there are.

    Grey; of a year with spectra at even wavelengths each has its own spectrum, as `genssky` writes it.
    """
    sun = data["direct_normal_illuminance"].values
    hours = np.flatnonzero((sun > 0) & (data["sun_elevation"].values > 0))
    toward = sun_directions(data)[hours]
    spectra = spectra_text(data, hours) if "direct_normal_spectral_irradiance" in data else [""] * len(hours)
    lines = []
    for k, (hour, (x, y, z), spectrum) in enumerate(zip(hours, toward, spectra, strict=True), start=1):
        light = f"{sun[hour] / (RADIANCE_EFFICACY * SUN_SIZE):.3e}"
        lines.append(f"void spectrum sunlight{k}\n0\n0\n{spectrum}\nsunlight{k}" if spectrum else "void")
        lines.append(f" light solar{k}\n0\n0\n3 {light} {light} {light}\n")
        lines.append(f"solar{k} source sun{k}\n0\n0\n4 {x:.6f} {y:.6f} {z:.6f} {SUN_DIAMETER / deg:.4f}\n\n")
    with appearing(path) as beside:
        beside.write_text("".join(lines), encoding="ascii")
    return len(hours)


def spectra_text(data: "xarray.Dataset", hours: np.ndarray) -> list[str]:
    """Numbers of Radiance's `spectrum` for the sun of each of the hours: of luminance 1, from short waves to long."""
    waves = data["wavelength"].values
    light = data["direct_normal_spectral_irradiance"].values[hours].astype(np.float64)
    ones = scaled(light, np.full(len(hours), RADIANCE_EFFICACY), band_weights(waves))[:, ::-1]
    head = f"{len(waves) + 2} {waves[0]:g} {waves[-1]:g} "
    return [head + " ".join(f"{value:.4f}" for value in row) for row in ones]


def sun_directions(data: "xarray.Dataset") -> np.ndarray:
    """Unit vectors toward the sun, (T, 3)."""
    toward: np.ndarray = direction(data["sun_azimuth"].values * deg, data["sun_elevation"].values * deg)
    return toward


def write_sky(sky: PerezAllWeather, path: str | PathLike[str], reflectance: float = GROUND_REFLECTANCE) -> Path:
    """Write one Perez sky and its sun as `path` (.rad) with the formula beside it (.cal); the path of the .cal.

    Sky, sun and ground as sources that surround the scene; grey, radiance = luminance / 179 lm W-1.
    """
    final = Path(path)
    if final.suffix != ".rad":
        raise ValueError(f"a Radiance scene must end in .rad, got {final.name!r}")
    if np.ndim(sky.sun) != 1:
        raise ValueError(f"one sky is written at a time, got suns of shape {np.shape(sky.sun)}")
    formula = final.with_suffix(".cal")
    with appearing(formula) as beside:
        beside.write_text(formula_text(sky), encoding="ascii")
    with appearing(final) as beside:
        beside.write_text(scene_text(sky, formula.name, reflectance), encoding="ascii")
    return formula


def formula_text(sky: PerezAllWeather) -> str:
    """The sky's radiance as functions of Dx, Dy, Dz."""
    numbers = np.asarray(sky.coefficients(), dtype=np.float64)[0]
    level, a, b, c, d, e, f = (float(numbers[k]) for k in (R, A, B, C, D, E, F))
    x, y, z = (float(value) for value in np.asarray(sky.formula_sun))
    return f"""{{ Perez all-weather sky; radiance in W m-2 sr-1 (luminance / {RADIANCE_EFFICACY:g}) }}
up = if(Dz - {sky.floor:g}, Dz, {sky.floor:g});
cosine = Dx*({x:.9g}) + Dy*({y:.9g}) + Dz*({z:.9g});
bounded = if(cosine - 1, 1, if(-1 - cosine, -1, cosine));
gradation = 1 + ({a:.9g})*exp(if(({b:.9g})/up + 80, ({b:.9g})/up, -80));
indicatrix = ({c:.9g}) + ({d:.9g})*exp(({e:.9g})*acos(bounded)) + ({f:.9g})*bounded*bounded;
light = {level / RADIANCE_EFFICACY:.9g}*gradation*indicatrix;
skybright = if(Dz, if(light, light, 0), 0);
"""


def scene_text(sky: PerezAllWeather, formula: str, reflectance: float) -> str:
    """The sources of the scene."""
    z = float(np.asarray(sky.sun)[2])
    sun = float(sky.direct_normal_illuminance) / RADIANCE_EFFICACY
    below = reflectance / np.pi * (float(sky.diffuse_illuminance) / RADIANCE_EFFICACY + sun * max(z, 0.0))
    shining = sun_text(sky, sun) if sun > 0 and z > 0 else ""
    sources = SKY_SOURCE.format(formula=formula) + GROUND_SOURCE.format(light=below)
    return f"# Perez all-weather sky\n{shining}\n{sources}"


def sun_text(sky: PerezAllWeather, light: float) -> str:
    """The sun as a source, of a direct normal irradiance in Radiance's unit."""
    x, y, z = (float(value) for value in np.asarray(sky.sun))
    disc = f"{light / SUN_SIZE:.6e}"
    size = f"{SUN_DIAMETER / deg:.4f}"
    return f"""void light solar
0
0
3 {disc} {disc} {disc}
solar source sun
0
0
4 {x:.7f} {y:.7f} {z:.7f} {size}
"""


SKY_SOURCE = """void brightfunc skyfunc
2 skybright {formula}
0
0
skyfunc glow sky_glow
0
0
4 1 1 1 0
sky_glow source sky
0
0
4 0 0 1 180

"""

GROUND_SOURCE = """void glow ground_glow
0
0
4 {light:.6e} {light:.6e} {light:.6e} 0
ground_glow source ground
0
0
4 0 0 -1 180
"""
