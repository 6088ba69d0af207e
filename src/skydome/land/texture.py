"""Reflectance of land from a photograph of it from above: laid onto the elevation model, without gamma, made plausible.

A photograph tells colours and contrasts, not reflectances: its exposure is arbitrary. So its linear values are scaled
until their mean luminance is that of land. Haze and shadows that are in the photograph stay in it.
"""

import warnings
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from skydome.ground.arguments import numbers, require_file
from skydome.ground.extras import required
from skydome.land.elevation import Elevation, Extent
from skydome.light.colour import SRGB, decode_srgb

MOST_TEXELS = 4096
"""Larger photographs are coarsened to so many texels a side."""

BRIGHTEST = 0.9
"""Highest reflectance: fresh snow."""

MEAN_REFLECTANCE = 0.115
"""Mean luminous reflectance of the land unless given: grass and forest."""


def read_texture(
    path: str | PathLike[str], elevation: Elevation, mean: float = MEAN_REFLECTANCE
) -> tuple[np.ndarray, tuple[str, ...]]:
    """Reflectance (h, w, 3) in linear sRGB from a .tif, .png or .jpg photo, row 0 north, and notes of what was done.

    A GeoTIFF is laid onto an elevation model that was read from a GeoTIFF (needs rasterio); any other photo is
    stretched over the model. Values lose the sRGB curve, are scaled to the `mean` luminance and end at 0.9. Where the
    photo has no data its mean stands in. ValueError in one line where more than half is missing.
    """
    path = require_file(path, "a texture")
    if path.suffix.lower() not in (".tif", ".tiff", ".png", ".jpg", ".jpeg"):
        raise ValueError(f"a texture must end in .tif, .png or .jpg, got {path.name!r}")
    if not 0 < mean <= BRIGHTEST:
        raise ValueError(f"the texture's mean reflectance must lie in (0, {BRIGHTEST}], got {mean:g}")
    kind = from_geotiff if path.suffix.lower() in (".tif", ".tiff") else from_picture
    encoded, known, notes = kind(path, elevation.extent)
    missing = 1 - float(known.mean())
    if missing > 0.5:
        raise ValueError(f"{path.name} must show at least half of the elevation model, got {100 - 100 * missing:.0f} %")
    if missing > 0:
        notes += (f"texture: {100 * missing:.2g} % not in the photo, given its mean",)
    return plausible(np.asarray(decode_srgb(encoded)), known, mean, path.name), notes


def plausible(linear: np.ndarray, known: np.ndarray, mean: float, name: str) -> np.ndarray:
    """Linear values (h, w, 3) scaled to a mean luminance, with the mean where nothing is known."""
    colour = linear[known].mean(axis=0)
    level = float(colour @ np.asarray(SRGB.to_xyz[1]))
    if not level > 0:
        raise ValueError(f"{name} is black all over")
    filled = np.where(known[..., None], linear, colour) * (mean / level)
    return np.ascontiguousarray(np.clip(filled, 0.0, BRIGHTEST))


def scaled(bands: np.ndarray, name: str) -> np.ndarray:
    """Bands (..., h, w) of whole numbers as 0..1; ValueError unless they have 8 or 16 bits."""
    if bands.dtype not in (np.uint8, np.uint16):
        raise ValueError(f"a texture must have 8 or 16 bits a band, got {bands.dtype} in {name}")
    result: np.ndarray = bands / float(np.iinfo(bands.dtype).max)
    return result


def from_picture(path: Path, _: Extent | None) -> tuple[np.ndarray, np.ndarray, tuple[str, ...]]:
    """Encoded values (h, w, 3), where they are known (h, w), and notes, of a .png or .jpg."""
    from PIL import Image

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", Image.DecompressionBombWarning)
        try:
            with Image.open(path) as image:
                if image.mode not in ("1", "L", "LA", "P", "PA", "RGB", "RGBA", "CMYK", "YCbCr"):
                    raise ValueError(f"a .png or .jpg texture must have 8 bits a band, got {image.mode} in {path.name}")
                image.thumbnail((MOST_TEXELS, MOST_TEXELS))
                pixels = np.asarray(image.convert("RGBA"))
        except Image.DecompressionBombError as error:
            raise ValueError(f"{path.name} is too large to be read safely; make it smaller") from error
        except (OSError, SyntaxError) as error:
            raise ValueError(f"cannot read {path.name}, which is damaged or no picture") from error
    require_texels(pixels.shape[:2], path.name)
    note = f"texture: {pixels.shape[0]} x {pixels.shape[1]} texels stretched over the map"
    return scaled(pixels[..., :3], path.name), pixels[..., 3] > 0, (note,)


def from_geotiff(path: Path, extent: Extent | None) -> tuple[np.ndarray, np.ndarray, tuple[str, ...]]:
    """The same of a .tif, laid onto `extent` if both have a georeference."""
    rasterio = required("rasterio", "terrain", "reading GeoTIFF")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", rasterio.errors.NotGeoreferencedWarning)
        warnings.simplefilter("ignore", PendingDeprecationWarning)  # rasterio 1.4 multiplies transforms of affine 3
        try:
            with rasterio.open(path) as photo:
                if photo.count == 0 or any(kind not in ("uint8", "uint16") for kind in photo.dtypes):
                    raise ValueError(f"a texture must have 8 or 16 bits a band, got {photo.dtypes} in {path.name}")
                placed = extent is not None and photo.crs is not None and not photo.transform.is_identity
                bands, known = aligned(photo, extent) if placed and extent is not None else stretched(photo)
        except rasterio.errors.RasterioIOError as error:
            raise ValueError(f"cannot read {path.name}, which is damaged or no GeoTIFF") from error
    require_texels(known.shape, path.name)
    how = "laid on by its georeference" if placed else "stretched over the map"
    rgb = np.moveaxis(scaled(bands, path.name), 0, -1)
    return rgb, known, (f"texture: {known.shape[0]} x {known.shape[1]} texels {how}",)


def colour_bands(photo: Any) -> list[int]:
    """The numbers of the red, green and blue bands of an open raster: three, or the first thrice."""
    return [1, 2, 3] if photo.count >= 3 else [1, 1, 1]


def stretched(photo: Any) -> tuple[np.ndarray, np.ndarray]:
    """Bands (3, h, w) of an open raster, and where it has data (h, w)."""
    shrink = max(1.0, max(photo.shape) / MOST_TEXELS)
    shape = tuple(max(1, int(size / shrink)) for size in photo.shape)
    return photo.read(colour_bands(photo), out_shape=(3, *shape)), photo.dataset_mask(out_shape=shape) > 0


def aligned(photo: Any, extent: Extent) -> tuple[np.ndarray, np.ndarray]:
    """The same on a grid of about the photo's own resolution whose outer texels lie on the model's outer vertices."""
    from rasterio.transform import Affine
    from rasterio.warp import Resampling, calculate_default_transform, reproject

    own = calculate_default_transform(photo.crs, extent.crs, photo.width, photo.height, *photo.bounds)[0]
    spans = (extent.north - extent.south, extent.east - extent.west)
    steps = [
        min(max(round(span / abs(step)), 1), MOST_TEXELS - 1) for span, step in zip(spans, (own.e, own.a), strict=True)
    ]
    dy, dx = (span / count for span, count in zip(spans, steps, strict=True))
    shape = (steps[0] + 1, steps[1] + 1)
    grid = Affine(dx, 0, extent.west - dx / 2, 0, -dy, extent.north + dy / 2)
    target = {"dst_transform": grid, "dst_crs": extent.crs}
    source = {"src_transform": photo.transform, "src_crs": photo.crs}
    bands, known = np.zeros((3, *shape), photo.dtypes[0]), np.zeros(shape, np.uint8)
    for band, number in zip(bands, colour_bands(photo), strict=True):
        reproject(photo.read(number), band, resampling=Resampling.average, **source, **target)
    reproject(photo.dataset_mask(), known, resampling=Resampling.nearest, **source, **target)
    return bands, known > 0


def require_texels(shape: tuple[int, ...], name: str) -> None:
    """ValueError unless 2 x 2 or more."""
    if min(shape) < 2:
        raise ValueError(f"a texture must have 2 x 2 pixels or more, got {shape[0]} x {shape[1]} in {name}")


def surface_of(albedo: Any, shape: tuple[int, ...]) -> tuple[np.ndarray, float, float, np.ndarray]:
    """Reflectance (h, w, 3) of at least 2 x 2 texels, texels a cell along rows and columns, and the mean (3,)."""
    image = numbers(albedo, "albedo")
    image = np.broadcast_to(image, (2, 2, 3)) if image.ndim <= 1 and image.size in (1, 3) else image
    if image.ndim != 3 or image.shape[-1] != 3 or min(image.shape[:2]) < 2:
        raise ValueError(f"albedo must be RGB (3,) or an image (h, w, 3), got shape {np.shape(albedo)}")
    if not (np.isfinite(image).all() and image.min() >= 0 and image.max() <= 1):
        raise ValueError(f"albedo must lie in [0, 1], got {image.min():g} to {image.max():g}")
    scale = (image.shape[0] - 1) / (shape[0] - 1), (image.shape[1] - 1) / (shape[1] - 1)
    return np.ascontiguousarray(image), float(scale[0]), float(scale[1]), image.mean(axis=(0, 1))
