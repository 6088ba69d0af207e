"""Light of one neural sky toward many float32 directions: blocks of NumPy, or the compiled kernel where it pays."""

from typing import Any, NamedTuple

import numpy as np

from skydome.ground.compiled import has_numba, shared
from skydome.skies.neural.folding import INPUTS, OF_THE_ROW, Folded, columns_of, steadied

LEAST_DIRECTIONS = 1 << 19
"""Fewer directions than this take NumPy and do not wait for a compiler."""
BLOCK = 2048
KERNEL_INPUTS = (
    "east", "north", "view_z", "distance", "sqrt_distance", "log_distance", "cos_angle",
    "sqrt_up", "log_up", "inverse_up",
)  # fmt: skip
"""What the kernel knows, in the order of its codes."""
KERNEL_OUTPUTS = ("rational", "exponential")
LARGEST_SUM = 1e4
"""The kernel multiplies four neurons' 1 + x^2 before it divides: with sums up to here the product is a float32."""


class Prepared(NamedTuple):
    """A network as the kernel reads it: codes of its inputs, padded widths, weights and biases in a row, and output."""

    codes: np.ndarray
    widths: np.ndarray
    weights: np.ndarray
    biases: np.ndarray
    outputs: int
    exponential: bool
    scale: np.float32
    held: np.float32
    matrix: np.ndarray

    @property
    def size(self) -> int:
        """Numbers of light in each direction."""
        return len(self.matrix) if self.matrix.size else self.outputs

    def scratch(self, kernel: Any) -> np.ndarray:
        """Scratch memory for the kernel."""
        most = max(int(self.widths.max()), len(self.matrix))
        return np.zeros((4 + 2 * most) * kernel.BLOCK, np.float32)


def single(network: Folded) -> list[tuple[np.ndarray, np.ndarray]]:
    """The layers in float32."""
    return [(np.ascontiguousarray(w, np.float32), np.ascontiguousarray(b, np.float32)) for w, b in network.layers]


def fours(count: int) -> int:
    """The next whole multiple of four."""
    return -(-count // 4) * 4


def prepared(network: Folded, matrix: np.ndarray | None = None) -> Prepared:
    """The network for the kernel, hidden layers and inputs padded with zeros to whole fours; its light times `matrix`.

    The exponential's log2 e, or the square's half, go into the last layer.
    """
    exponential = network.output.name == "exponential"
    gain = np.log2(np.e) if exponential else np.sqrt(0.5)
    widths, weights, biases = [fours(len(network.inputs))], [], []
    for depth, (w, b) in enumerate(network.layers):
        rows, factor = fours(len(b)), gain if depth + 1 == len(network.layers) else 1.0
        wide = np.pad(factor * w, ((0, rows - len(b)), (0, widths[-1] - w.shape[1])))
        weights.append(wide.reshape(rows // 4, 4, -1, 4).swapaxes(1, 2).reshape(-1))  # tiles of four by four
        biases.append(np.pad(factor * b, (0, rows - len(b))))
        widths.append(rows)
    codes = [KERNEL_INPUTS.index(name) for name in network.inputs]
    scale, matrix = split(network.scale, matrix)
    return Prepared(
        np.array(codes, np.int64),
        np.array(widths, np.int64),
        np.concatenate(weights).astype(np.float32),
        np.concatenate(biases).astype(np.float32),
        len(network.layers[-1][1]),
        exponential,
        np.float32(scale),
        np.float32(30 * np.log2(np.e)),
        np.ascontiguousarray(matrix, np.float32),
    )


def split(scale: float, matrix: np.ndarray | None) -> tuple[float, np.ndarray]:
    """Scale and matrix; an empty one, where it is but a number times the unit matrix, which the scale takes up."""
    none = np.zeros((0, 0))
    if matrix is None:
        return scale, none
    rows, columns = matrix.shape
    if rows == columns and (matrix == matrix[0, 0] * np.eye(rows)).all():
        return scale * float(matrix[0, 0]), none
    return scale, matrix


def light_toward(network: Folded, directions: np.ndarray, matrix: np.ndarray | None = None) -> np.ndarray:
    """Light toward float32 directions (N, 3), float32 (N, outputs), times `matrix` (K, outputs); 0 below the horizon.

    Single precision: an error of about 1e-6 of the sky's brightest.
    """
    kernel = compiled_kernel(network) if len(directions) >= LEAST_DIRECTIONS else None
    if kernel is not None:
        return light_by_kernel(network, directions, kernel, matrix)
    light = light_by_numpy(network, directions)
    return light if matrix is None else light @ matrix.T.astype(np.float32)


def compiled_kernel(network: Folded) -> Any:
    """The compiled module, None where Numba is missing or the network is not of its kind."""
    known = all(name in KERNEL_INPUTS for name in network.inputs) and network.output.name in KERNEL_OUTPUTS
    if not known or len(network.layers) < 2 or largest_sum(network) > LARGEST_SUM or not has_numba():
        return None
    from skydome.skies.neural import kernel

    return kernel


def largest_sum(network: Folded) -> float:
    """A bound on the sums of hidden neurons, from inputs of at most 10 and signals of at most 1."""
    reach = [10.0] + [1.0] * len(network.layers)
    sums = [np.abs(w).sum(axis=1) * most + np.abs(b) for (w, b), most in zip(network.layers[:-1], reach, strict=False)]
    return float(max(each.max() for each in sums))


def light_by_numpy(network: Folded, directions: np.ndarray) -> np.ndarray:
    """The same in blocks that stay in the processor's cache."""
    layers, sun = single(network), network.sun.astype(np.float32)
    light = np.empty((len(directions), layers[-1][1].size), np.float32)
    for start in range(0, len(directions), BLOCK):
        part = directions[start : start + BLOCK]
        columns = columns_of(part, sun)
        (weights, biases), rest = layers[0], layers[1:]
        signal = weights @ np.stack([INPUTS[name](columns) for name in network.inputs])
        signal += biases[:, None]
        shown = network.output.light(through(rest, signal)) * np.float32(network.scale)
        light[start : start + BLOCK] = np.where(part[:, 2] >= 0, shown, np.float32(0)).T
    return light


def through(layers: list[tuple[np.ndarray, np.ndarray]], sums: np.ndarray) -> np.ndarray:
    """The last layer's sums from the first layer's (neurons, n), which are overwritten."""
    for weights, biases in layers:
        np.multiply(sums, sums, out=sums)
        sums += np.float32(1)
        np.reciprocal(sums, out=sums)
        sums = weights @ sums
        sums += biases[:, None]
    return sums


def light_by_kernel(
    network: Folded, directions: np.ndarray, kernel: Any, matrix: np.ndarray | None = None
) -> np.ndarray:
    """The same compiled, shared among threads."""
    ready, count = prepared(steadied(network), matrix), len(directions)
    toward = np.ascontiguousarray(directions, np.float32).reshape(-1)
    light, sun = np.empty((count, ready.size), np.float32), network.sun.astype(np.float32)

    def job(first: int, last: int) -> None:
        kernel.shine(first, last, toward, sun, ready, ready.scratch(kernel), light.reshape(-1))

    shared(job, count, light.size)
    return light


def row_biases(network: Folded, cosine: np.ndarray) -> tuple[Folded, np.ndarray]:
    """The network without what is the same along a row, and the first layer's biases with it, (r, hidden).

    `cosine` (r,): cosines of the rows' zenith angles.
    """
    (weights, biases), rest = network.layers[0], network.layers[1:]
    of_row = [k for k, name in enumerate(network.inputs) if name in OF_THE_ROW]
    left = [k for k in range(len(network.inputs)) if k not in of_row]
    heights = [INPUTS[network.inputs[k]]({"up": cosine}) for k in of_row]
    lifted = biases + sum(np.outer(h, weights[:, k]) for h, k in zip(heights, of_row, strict=True))
    inputs = tuple(network.inputs[k] for k in left)
    rows = np.broadcast_to(lifted, (len(cosine), len(biases)))
    layers = ((weights[:, left], biases), *rest)
    return Folded(inputs, layers, network.output, network.scale, network.sun), rows
