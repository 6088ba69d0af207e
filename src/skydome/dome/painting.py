"""The light of skies written into the pixels of a map, whole or some rows at a time."""

from typing import Any

import numpy as np

from skydome.dome.sources import Source
from skydome.maps.projections import Equirectangular, Projection

CHUNK = 1 << 17
"""Texels evaluated at a time in float64: about 25 MB of scratch memory."""


def takes_kernels(pixels: np.ndarray) -> bool:
    """Whether compiled kernels can write into an array."""
    return bool(pixels.dtype == np.float32 and pixels.flags.c_contiguous)


def paint_rows(
    pixels: np.ndarray, sources: list[Source], ground: np.ndarray, projection: Projection, height: int, rows: slice
) -> None:
    """Write the given rows of a map into `pixels` (r, W, 3): the sum of skies above the horizon, `ground` (3,) below.

    Texels that the layout does not use are let be.
    """
    if isinstance(projection, Equirectangular) and sources and all(source.has_rows for source in sources):
        paint_level_rows(pixels, sources, ground, projection, height, range(*rows.indices(height)))
        return
    step = max(1, CHUNK // pixels.shape[1])
    for start in range(rows.start, rows.stop, step):
        block = slice(start, min(rows.stop, start + step))
        here = pixels[start - rows.start : block.stop - rows.start]
        directions, valid = projection.directions(height, block), projection.valid(height, block)
        paint_texels(here, sources, ground, directions, valid)


def paint_level_rows(
    pixels: np.ndarray,
    sources: list[Source],
    ground: np.ndarray,
    projection: Equirectangular,
    height: int,
    rows: range,
) -> None:
    """An equirectangular map's rows: whole rows of sky, then whole rows of ground."""
    horizon = max(rows.start, min(rows.stop, height // 2))
    seen = pixels[: horizon - rows.start]
    row_of_ground = np.broadcast_to(ground, pixels.shape[1:]).astype(pixels.dtype)
    pixels[horizon - rows.start :] = row_of_ground
    for index, source in enumerate(sources):
        whole = source.kernel is not None and index == 0
        step = max(1, len(seen) if whole else CHUNK // pixels.shape[1])
        for start in range(0, len(seen), step):
            block = seen[start : start + step]
            here = range(rows.start + start, rows.start + start + len(block))
            target = block if index == 0 else np.empty_like(block)
            source.paint(projection, height, here, target)
            if index:
                block += target


def paint_texels(
    pixels: np.ndarray,
    sources: list[Source],
    ground: np.ndarray,
    directions: np.ndarray,
    valid: np.ndarray,
) -> None:
    """Any projection's texels: their directions (r, W, 3), whether they are `valid` (r, W); others are left alone."""
    below = directions[..., 2] < 0
    pixels[below & valid] = ground
    above = ~below & valid
    if not above.any():
        return
    seen = directions if above.all() else directions[above]
    light: Any = np.zeros((1, 1), pixels.dtype)
    for source in sources:
        light = light + source.toward(seen)
    pixels[above] = np.broadcast_to(light, seen.shape).reshape(-1, 3)
