"""The light of skies written into the pixels of a map, whole or some rows at a time."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from skydome.dome.integrals import colourless
from skydome.dome.network_rows import NetworkLight, network_kernel, paint_network, rgb_network
from skydome.dome.sky_rows import paint
from skydome.ground.arrays import as_numpy
from skydome.light.colour import RGBSpace
from skydome.maps.projections import Equirectangular, Projection
from skydome.skies.colour_sky import ColourSky
from skydome.skies.formula.fast import Light, chosen, many_skies
from skydome.skies.neural.fast import light_by_kernel, light_by_numpy
from skydome.skies.sky import Sky

CHUNK = 1 << 17
"""Texels evaluated at a time in float64: about 25 MB of scratch memory."""

Source = tuple[Sky, Light | NetworkLight | None, Any]
"""A sky, its numbers where it is one of the nine-number formula or a network's, and the compiled module to take."""


def rgb_light(sky: Sky, space: RGBSpace) -> Light | None:
    """The numbers of one nine-number sky's RGB, also of one multiplied or given a colour; None for other skies."""
    inner, factor = sky.single
    light = inner.rgb_formula(space) if isinstance(inner, ColourSky) else None
    return None if light is None else light._replace(quantity=light.quantity.then(float(factor) * np.eye(light.size)))


def paint_rows(
    pixels: np.ndarray,
    skies: Sequence[Sky],
    ground: np.ndarray,
    projection: Projection,
    height: int,
    space: RGBSpace,
    rows: slice,
) -> None:
    """Write the given rows of a map into `pixels` (r, W, 3): the sum of `skies` above the horizon, `ground` (3,) below.

    float32 pixels take the compiled kernels where the whole map is a large job.
    """
    single = pixels.dtype == np.float32 and pixels.flags.c_contiguous
    texels = int(np.prod(projection.shape(height)))
    sources = [source_of(sky, space, texels if single else 0) for sky in skies]
    if isinstance(projection, Equirectangular) and sources and all(light is not None for _, light, _ in sources):
        paint_level_rows(pixels, sources, ground, projection, height, range(*rows.indices(height)))
        return
    step = max(1, CHUNK // pixels.shape[1])
    for start in range(rows.start, rows.stop, step):
        block = slice(start, min(rows.stop, start + step))
        here = pixels[start - rows.start : block.stop - rows.start]
        directions, valid = projection.directions(height, block), projection.valid(height, block)
        paint_texels(here, sources, ground, directions, valid, space)


def source_of(sky: Sky, space: RGBSpace, texels: int) -> Source:
    """A sky ready to be painted; `texels` of the whole float32 map, 0 for float64, which takes no network's numbers."""
    sky = sky.for_maps
    light = rgb_light(sky, space)
    if light is not None:
        return sky, light, chosen(3 * texels // 2, light.coefficients) if texels else None
    network = rgb_network(sky, space) if texels else None
    return sky, network, None if network is None else network_kernel(network, texels // 2)


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
    for index, (_, light, kernel) in enumerate(sources):
        whole = kernel is not None and index == 0
        step = max(1, len(seen) if whole else CHUNK // pixels.shape[1])
        for start in range(0, len(seen), step):
            block = seen[start : start + step]
            here = range(rows.start + start, rows.start + start + len(block))
            target = block if index == 0 else np.empty_like(block)
            if isinstance(light, NetworkLight):
                paint_network(kernel, light, projection, height, here, target)
            elif light is not None:
                paint(kernel, light, projection, height, here, target)
            if index:
                block += target


def paint_texels(
    pixels: np.ndarray,
    sources: list[Source],
    ground: np.ndarray,
    directions: np.ndarray,
    valid: np.ndarray,
    space: RGBSpace,
) -> None:
    """Any projection's texels: their directions (r, W, 3), whether they are `valid` (r, W); others are left alone."""
    below = directions[..., 2] < 0
    pixels[below & valid] = ground
    above = ~below & valid
    if not above.any():
        return
    seen = directions if above.all() else directions[above]
    light: Any = np.zeros((1, 1), pixels.dtype)
    for sky, numbers, kernel in sources:
        light = light + rgb_of(sky, numbers, kernel, seen, space)
    pixels[above] = np.broadcast_to(light, seen.shape).reshape(-1, 3)


def rgb_of(
    sky: Sky, numbers: Light | NetworkLight | None, kernel: Any, directions: np.ndarray, space: RGBSpace
) -> np.ndarray:
    """RGB toward directions (..., 3), by the compiled formula or network where there is a kernel."""
    if isinstance(numbers, NetworkLight):
        return rgb_of_network(numbers, kernel, directions)
    if kernel is not None and numbers is not None:
        light = np.empty(directions.shape, np.float32)
        many_skies(kernel, numbers, directions.reshape(-1, 3), light)
        return light
    if not isinstance(sky, ColourSky):
        raise TypeError(colourless(sky))
    return as_numpy(sky.rgb(directions, space))


def rgb_of_network(light: NetworkLight, kernel: Any, directions: np.ndarray) -> np.ndarray:
    """RGB of a neural sky toward directions (..., 3), float32."""
    toward = directions.reshape(-1, 3).astype(np.float32)
    if kernel is not None:
        return light_by_kernel(light.network, toward, kernel, light.matrix).reshape(directions.shape)
    shown = light_by_numpy(light.network, toward) @ light.matrix.T.astype(np.float32)
    return shown.reshape(directions.shape)
