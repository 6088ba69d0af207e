"""Rows of an equirectangular map of one neural sky: what a row shares goes into the biases, its mirror half is copied.

The distance to the sun is a number of the row plus one of the row times one of the column (see `sky_rows`). Networks
that tell left of the sun from right (the published inputs have a view_y) are evaluated on every column, others on half.
"""

from typing import Any, NamedTuple

import numpy as np

from skydome.dome.sky_rows import columns_from_sun
from skydome.ground.arrays import as_numpy
from skydome.ground.compiled import shared
from skydome.ground.directions import azimuth, zenith_angle
from skydome.light.colour import RGBSpace
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.projection import texel_centre
from skydome.skies.neural.fast import (
    LEAST_DIRECTIONS,
    compiled_kernel,
    prepared,
    row_biases,
    single,
    through,
)
from skydome.skies.neural.folding import INPUTS, Folded, steadied
from skydome.skies.neural.sky import NeuralForm
from skydome.skies.sky import Sky

TEXELS = 1 << 13
"""Texels that NumPy takes at a time: what they need stays in the second-level cache."""


class NetworkLight(NamedTuple):
    """A network under one sky, and the matrix (3, outputs) from its light to RGB."""

    network: Folded
    matrix: np.ndarray


def rgb_network(sky: Sky, space: RGBSpace) -> NetworkLight | None:
    """The network of one neural sky by day, also of one multiplied; None for others."""
    inner, factor = sky.single
    if not isinstance(inner, NeuralForm) or not inner.is_one_numpy_sky:
        return None
    return NetworkLight(inner.folded(), float(as_numpy(factor)) * inner.rgb_matrix(space))


def map_columns(network: Folded, projection: Equirectangular, height: int) -> tuple[np.ndarray, np.ndarray]:
    """Columns (3, n) and segments (s, 4) as the kernel reads them: half of the columns where the sky is symmetric."""
    if "east" not in network.inputs:
        symmetric = columns_from_sun(projection, height, network.sun)
        turn = symmetric.turn[0]
        return np.stack([turn, 0 * turn, 0 * turn]), symmetric.segments
    width = 2 * height
    angles = projection.azimuths(texel_centre(np.arange(width)), height)
    turn = 2 * np.sin((angles - float(azimuth(network.sun))) / 2) ** 2
    return np.stack([turn, np.sin(angles), np.cos(angles)]), np.array([(0, width, 0, -1)])


def row_numbers(network: Folded, height: int, rows: range) -> tuple[np.ndarray, np.ndarray]:
    """Of each row above the horizon: cos t (r,), and 1 - cos(t - ts), sin t sin ts, sin t (r, 3)."""
    zenith = np.pi * texel_centre(np.arange(rows.start, rows.stop)) / height
    sun = float(zenith_angle(network.sun))
    level = np.sin(zenith)
    return np.sin(np.pi / 2 - zenith), np.stack([2 * np.sin((zenith - sun) / 2) ** 2, level * np.sin(sun), level], -1)


def network_kernel(light: NetworkLight, texels: int) -> Any:
    """The compiled networks' module where a map of so many texels of sky should take it, else None."""
    return compiled_kernel(light.network) if texels >= LEAST_DIRECTIONS else None


def paint_network(
    kernel: Any, light: NetworkLight, projection: Equirectangular, height: int, rows: range, out: np.ndarray
) -> None:
    """Write one neural sky's light into `out` (r, W, 3), contiguous float32: given rows, all above the horizon.

    `kernel`: the compiled networks' module; None: NumPy in float32.
    """
    cosine, numbers = row_numbers(light.network, height, rows)
    along, biases = row_biases(steadied(light.network), cosine)
    columns, segments = map_columns(light.network, projection, height)
    numbers, biases, columns = (part.astype(np.float32) for part in (numbers, biases, columns))
    if kernel is None:
        paint_by_numpy(along, light.matrix, numbers, biases, columns, segments, out)
    else:
        paint_by_kernel(kernel, along, light.matrix, numbers, biases, columns, segments, out)


def paint_by_numpy(
    network: Folded, matrix: np.ndarray, numbers: np.ndarray, biases: np.ndarray, columns: np.ndarray,
    segments: np.ndarray, out: np.ndarray,
) -> None:  # fmt: skip
    """A few rows at a time, which stay in the processor's cache."""
    (weights, _), *rest = single(network)
    gain, step = (matrix * network.scale).astype(np.float32), max(1, TEXELS // columns.shape[1])
    for start in range(0, len(numbers), step):
        block = slice(start, min(len(numbers), start + step))
        base, lever, level = numbers[block].T[:, :, None]
        place = {"x": level * columns[1], "y": level * columns[2], "distance": np.sqrt(2 * (base + lever * columns[0]))}
        signal = np.stack([INPUTS[name](place) for name in network.inputs])
        sums = (weights @ signal.reshape(len(signal), -1)).reshape(len(weights), len(base), -1)
        sums += biases[block].T[:, :, None]
        shown = gain @ network.output.light(through(rest, sums.reshape(len(weights), -1)))
        mirrored(shown.reshape(3, len(base), -1).transpose(1, 2, 0), segments, out[block])


def mirrored(shown: np.ndarray, segments: np.ndarray, out: np.ndarray) -> None:
    """Write evaluated columns (r, n, 3) to their places and mirror images."""
    for start, count, column, image in segments:
        part = shown[:, start : start + count]
        out[:, column : column + count] = part
        if image >= 0:
            out[:, image : image + count] = part[:, ::-1]


def paint_by_kernel(
    kernel: Any, network: Folded, matrix: np.ndarray, numbers: np.ndarray, biases: np.ndarray, columns: np.ndarray,
    segments: np.ndarray, out: np.ndarray,
) -> None:  # fmt: skip
    """The same compiled, rows shared among threads."""
    ready, flat, width = prepared(network, matrix), out.reshape(-1), out.shape[1]
    lifted = np.zeros((len(biases), int(ready.widths[1])), np.float32)
    lifted[:, : biases.shape[1]] = biases

    def job(first: int, last: int) -> None:
        kernel.whole_map(first, last, numbers, lifted, columns, segments, ready, ready.scratch(kernel), width, flat)

    shared(job, len(numbers), out.size)
