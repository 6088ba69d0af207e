"""A map in another layout or size, its light conserved: areas are averaged, suns are carried over as flux."""

import math

import numpy as np

from skydome.ground.limits.sizes import require_memory
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.integrals import row_chunks
from skydome.maps.lookup import bilinear, nearest
from skydome.maps.projection import Projection, from_first_centre, texel_centre

SUN_CONTRAST = 30.0  # texels this much brighter than their surroundings are carried over as flux
SAMPLES = 1 << 18  # directions at a time: about 60 MB


def resample(
    pixels: np.ndarray, source: Projection, destination: Projection, height: int, sun_contrast: float = SUN_CONTRAST
) -> np.ndarray:
    """Pixels (H', W', C) of the map (H, W, C) in the destination's layout and height, same dtype; 0 outside the source.

    Each destination texel is the average of the source over its solid angle, by directions at least twice as dense
    as the source's texels. What a texel has beyond `sun_contrast` times its surroundings (a sun) is taken off first
    and its flux, radiance x solid angle, is laid down where it belongs: sizes may change by any factor, and the sum
    of radiance x solid angle stays. From sphere to sphere the few 1e-4 that sampling leaves are made up for by one
    factor per channel. Where only whole texels move (a quarter turn, mirroring) the values are copied.
    Memory: both maps and about 100 MB.
    """
    rows, columns = destination.shape(height)
    require_memory(rows * columns * 3 * 16 + pixels.nbytes, f"a map of {rows} x {columns} texels")
    copied = copied_columns(source, destination, pixels.shape[0], height)
    if copied is not None:
        return pixels[:, copied]
    calm, i, j = without_suns(pixels, sun_contrast)
    result = averaged(calm, source, destination, height)
    result *= balance(calm, source, result, destination)
    excess = pixels[i, j].astype(np.float64) - calm[i, j]
    flux = excess * np.broadcast_to(source.solid_angles(pixels.shape[0]), pixels.shape[:2])[i, j][:, None]
    lay_flux(result, flux, (i, j), source, destination, pixels.shape[0])
    return result.reshape(rows, columns, -1).astype(pixels.dtype, copy=False)


def copied_columns(source: Projection, destination: Projection, height: int, new_height: int) -> np.ndarray | None:
    """Source columns (W,) that the destination's columns equal, or None where texels do not fall on texels."""
    if height != new_height:
        return None
    if source == destination:
        return np.arange(source.shape(height)[1])
    if not (isinstance(source, Equirectangular) and isinstance(destination, Equirectangular)):
        return None
    width = source.shape(height)[1]
    turn = destination.azimuths(texel_centre(np.arange(width)), height) - source.azimuth_left
    column = from_first_centre((-turn if source.mirrored else turn) / (2 * np.pi) * width)
    whole = np.rint(column)
    return np.mod(whole, width).astype(np.intp) if np.allclose(column, whole, rtol=0, atol=1e-6) else None


def flux(pixels: np.ndarray, projection: Projection) -> np.ndarray:
    """Sum of value x solid angle, shape (C,), float64."""
    angles = np.broadcast_to(projection.solid_angles(len(pixels)), pixels.shape[:2])
    total: np.ndarray = np.einsum("ij,ijc->c", angles, pixels)
    return total


def balance(before: np.ndarray, source: Projection, after: np.ndarray, destination: Projection) -> np.ndarray:
    """Factor per channel, shape (C,), that gives `after` the flux of `before`; 1 where one is less than the sphere."""
    extents = [extent(source, len(before)), extent(destination, len(after))]
    whole = min(extents) > 4 * np.pi * (1 - 1e-9)
    had, has = flux(before, source), flux(after, destination)
    usable = (had > 0) & (has > 0) & whole
    return np.where(usable, had / np.where(usable, has, 1.0), 1.0)


def density(projection: Projection, height: int) -> float:
    """Texels per 4 pi sr: a measure of fineness."""
    return 4 * np.pi * np.count_nonzero(projection.valid(height)) / extent(projection, height)


def extent(projection: Projection, height: int) -> float:
    """Solid angle of the whole map, sr."""
    return float(np.broadcast_to(projection.solid_angles(height), projection.shape(height)).sum())


def averaged(pixels: np.ndarray, source: Projection, destination: Projection, height: int) -> np.ndarray:
    """Mean (rows, columns, C) float64 of the source over each destination texel, weighted by solid angle.

    Going to fewer texels the source counts as piecewise constant, to more it is blended between texel centres.
    """
    ratio = math.sqrt(density(source, pixels.shape[0]) / density(destination, height))
    smaller = ratio > math.sqrt(1.5)
    fine = max(2, math.ceil(2 * round(ratio, 3))) if smaller else 2
    look = nearest if smaller else bilinear
    rows, columns = destination.shape(height)
    result = np.zeros((rows, columns, pixels.shape[-1]))
    for part in row_chunks(rows, columns, max(1, SAMPLES // fine**2)):
        sub = slice(part.start * fine, part.stop * fine)
        row, column = destination.centres(height * fine, sub)
        down, right = scattered(row, column) if smaller else (0.0, 0.0)  # else a diagonal horizon falls between samples
        values, covered = look(pixels, source, destination.toward(row + down, column + right, height * fine))
        weight = np.broadcast_to(destination.relative_solid_angles(height * fine, sub), covered.shape) * covered
        shape = (part.stop - part.start, fine, columns, fine)
        total = (values * weight[..., None]).reshape(*shape, -1).sum(axis=(1, 3))
        weights = weight.reshape(shape).sum(axis=(1, 3))
        result[part] = total / np.where(weights > 0, weights, 1.0)[..., None]
        result[part] *= (destination.valid(height, part) & (weights > 0))[..., None]
    return result


def scattered(row: np.ndarray, column: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Offsets in -.5..+.5 for each (row, column), evenly spread and always the same (Roberts 2018, the R2 sequence)."""
    along = np.mod(row * 0.7548776662466927 + column * 0.5698402909980532, 1.0) - 0.5
    across = np.mod(row * 0.5698402909980532 + column * 0.7548776662466927 * 3, 1.0) - 0.5
    return along, across


def without_suns(pixels: np.ndarray, contrast: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The map with its brightest texels held at `contrast` times their surroundings, and the rows and columns held."""
    bright = pixels.max(axis=-1)
    limit = contrast * surroundings(bright)
    i, j = np.nonzero(bright > limit)
    calm = pixels.copy()
    calm[i, j] *= (limit[i, j] / bright[i, j])[:, None]
    return calm, i, j


def surroundings(bright: np.ndarray) -> np.ndarray:
    """Usual brightness (H, W) around each texel: the largest median of the nine blocks about it, H / 16 texels wide."""
    rows, columns = bright.shape
    side = max(2, min(rows, columns) // 16)
    down, across = -(-rows // side), -(-columns // side)
    padded = np.pad(bright, ((0, down * side - rows), (0, across * side - columns)), mode="edge")
    blocks = padded.reshape(down, side, across, side).swapaxes(1, 2).reshape(down, across, -1)
    medians = np.pad(np.median(blocks, axis=-1), 1, mode="edge")
    widest = np.max([medians[a : a + down, b : b + across] for a in range(3) for b in range(3)], axis=0)
    return np.repeat(np.repeat(widest, side, axis=0), side, axis=1)[:rows, :columns]


def lay_flux(
    result: np.ndarray,
    flux: np.ndarray,
    place: tuple[np.ndarray, np.ndarray],
    source: Projection,
    destination: Projection,
    source_height: int,
) -> None:
    """Add flux (n, C) of the source texels at `place` to the destination's texels they cover, in place."""
    if not len(flux):
        return
    rows, columns = result.shape[:2]
    finer = math.sqrt(density(destination, rows) / density(source, source_height))
    count = max(4, math.ceil(4 * finer))
    angles = np.broadcast_to(destination.solid_angles(rows), (rows, columns))
    offsets = texel_centre(np.arange(count)) / count
    step = max(1, SAMPLES // count**2)
    for k in range(0, len(flux), step):
        i, j = place[0][k : k + step, None, None], place[1][k : k + step, None, None]
        toward = source.toward(i + offsets[:, None], j + offsets, source_height)
        row, column, covered = destination.pixels(toward, rows)
        row, column = row.astype(np.intp), column.astype(np.intp)
        covered &= angles[row, column] > 0
        share = np.broadcast_to((flux[k : k + step] / count**2)[:, None, None, :], (*covered.shape, flux.shape[-1]))
        row, column = row[covered], column[covered]
        np.add.at(result, (row, column), share[covered] / angles[row, column][:, None])
