"""Maps of spectra: Radiance 6's pictures (.hsr), and OpenEXR in the spectral layout of Fichet et al. (JCGT 10/3, 2021).

A pixel of .hsr is one byte for each band, from long waves to short, and their exponent, scanlines flat, as Radiance's
`color.c` reads them. Texels hold the light toward their centres: the sun's disc is left to a light of its own.
"""

import warnings
from functools import reduce
from operator import add
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.dome.integrals import discs_and_rest, extended, points_of
from skydome.dome.map_rows import require_one_condition
from skydome.ground import exr, hdr
from skydome.ground.arguments import numbers, require_kind
from skydome.ground.directions import ZENITH
from skydome.ground.limits.sizes import require_memory
from skydome.ground.writing import appearing
from skydome.light.radiance_bands import band_weights, scaled, splits_of
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.projection import Projection
from skydome.skies.colour_sky import SpectralSky

MOST_BANDS = 512


def save_spectra(
    sky: SpectralSky,
    path: str | PathLike[str],
    wavelengths: ArrayLike,
    height: int = 128,
    projection: Projection | None = None,
) -> Path:
    """The path of a map of a sky's spectra, written whole or not at all: `sky.hsr` (Radiance 6) or `sky.exr`.

    `wavelengths` (W,), nm: of .hsr at least 4 and even. The map is equirectangular, or of another `projection`.
    A pixel of .hsr is W m-2 sr-1 of white as Radiance counts it, scaled so that its luminance times 179 is the sky's;
    one of .exr is W m-2 sr-1 nm-1 in channels `S0.550,0nm`, and R, G, B to look at. The sun's disc and points of light
    are left out, and a UserWarning says how much light that is. ValueError for other endings, or many skies.

    >>> import skydome as sd, tempfile
    >>> sky = sd.HosekWilkie(sd.direction(azimuth=0.0, elevation=0.7), turbidity=3.0)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     save_spectra(sky, f"{folder}/sky.hsr", np.arange(390.0, 711.0, 20.0), height=16).name
    'sky.hsr'
    """
    require_kind(sky, SpectralSky, "sky", "HosekWilkie(sun, turbidity=3.0)")
    require_kind(path, str | PathLike, "path", "'sky.hsr'")
    require_kind(projection, Projection | None, "projection", "Equirectangular()")
    final, bands = Path(path), np.atleast_1d(numbers(wavelengths, "wavelengths"))
    if final.suffix not in WRITERS:
        raise ValueError(f"spectra go into .hsr or .exr, got {final.name!r}")
    if bands.ndim != 1 or not 1 <= bands.size <= MOST_BANDS or not (np.diff(bands) > 0).all():
        raise ValueError(f"wavelengths must be 1 to {MOST_BANDS} rising numbers, nm, got {brief_list(bands)}")
    layout = projection or Equirectangular()
    rows, columns = layout.shape(height)
    require_memory(8.0 * rows * columns * (bands.size + 6), f"spectra of {columns} x {rows} texels")
    require_one_condition(sky)
    WRITERS[final.suffix](without_small_lights(sky), final, bands, layout.directions(height))
    return final


def without_small_lights(sky: SpectralSky) -> SpectralSky:
    """The sky less discs and points, with a UserWarning of their light; ValueError where nothing else shines."""
    discs, rest = discs_and_rest(sky)
    wide = extended(rest)
    if len(wide) == len(sky.parts):
        return sky
    light = sum(float(disc.illuminance(ZENITH)) * float(factor) for disc, factor in discs)
    light += sum(float(points.illuminance(ZENITH)) * float(factor) for points, factor in points_of(rest))
    if not wide:
        raise ValueError("a map of spectra leaves out discs and points of light, got a sky of nothing else")
    warnings.warn(
        f"discs and points of light are left out of a map of spectra: {light:,.6g} lx on the horizontal; "
        "a lamp or sd.render shows them",
        stacklevel=3,
    )
    left = reduce(add, wide)
    assert isinstance(left, SpectralSky)
    return left


def brief_list(values: np.ndarray) -> str:
    """The first of them, and how many there are."""
    return f"{values.size}: {values.ravel()[:4].tolist()} ..."


def write_hsr(sky: SpectralSky, path: Path, bands: np.ndarray, directions: np.ndarray) -> None:
    """Radiance's picture of spectra."""
    splits = splits_of(bands)
    light = np.nan_to_num(np.asarray(sky.radiance(directions, bands), dtype=np.float64))
    luminance = np.asarray(sky.luminance(directions), dtype=np.float64)
    pixels = scaled(np.maximum(light, 0.0), luminance, band_weights(bands))
    rows, columns, count = pixels.shape
    head = f"#?RADIANCE\nNCOMP={count}\nWAVELENGTH_SPLITS= {' '.join(f'{edge:g}' for edge in splits)}\n"
    head += f"FORMAT=Radiance_spectra\n\n-Y {rows} +X {columns}\n"
    with appearing(path) as beside:
        beside.write_bytes(head.encode("ascii") + hdr.encode_shared(pixels).tobytes())


def write_exr(sky: SpectralSky, path: Path, bands: np.ndarray, directions: np.ndarray) -> None:
    """OpenEXR's layers of Stokes' first component, one a wavelength."""
    light = np.asarray(sky.radiance(directions, bands), dtype=np.float32)
    channels = {channel_name(wave): light[..., k] for k, wave in enumerate(bands)}
    preview = {"RGB": np.asarray(sky.rgb(directions), dtype=np.float32)}
    facts: dict[str, Any] = {
        "spectralLayoutVersion": "1.0",
        "emissiveUnits": "W.m^-2.sr^-1",
        "comments": "emission is per nm; latitude-longitude maps have north at the left, seen from inside",
    }
    exr.write(path, preview | channels, facts)


def channel_name(wavelength: float) -> str:
    """A channel's name, its decimals after a comma, as a point parts layers.

    >>> channel_name(550.0), channel_name(412.5)
    ('S0.550,0nm', 'S0.412,5nm')
    """
    return f"S0.{str(float(wavelength)).replace('.', ',')}nm"


WRITERS = {".hsr": write_hsr, ".exr": write_exr}
