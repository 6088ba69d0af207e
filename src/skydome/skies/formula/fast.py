"""The choice between the readable formula and its compiled float32 form, and the work shared among threads.

float64 asks for the formula itself, in NumPy. float32 directions, or a float32 `out`, ask for float32 light: jobs of
`LEAST_VALUES` numbers or more (a quarter of them toward any direction) take the kernels, if Numba is installed; smaller
ones the formula, rounded at the end, so that they never wait for a compiler (about 3 s once on a machine, 0.8 s once in
a process).
"""

from typing import Any, NamedTuple

import numpy as np

from skydome.ground.compiled import has_numba, shared
from skydome.skies.formula.perez_formula import A, B, C, D, E, F, G, H, I, R, evaluate, view_geometry
from skydome.skies.formula.quantity import Quantity

LEAST_VALUES = 1 << 20
"""Fewer numbers of light than this, on the rows of a map, take NumPy."""
PRICE_OF_DIRECTIONS = 4
"""What a number toward any direction costs in NumPy, in numbers on the rows of a map (at least)."""
MOST_ODD = 0.01
"""Share of skies, beyond the kernels' range, that the formula makes up for; with more the formula does all."""
RISE, FALL = 9.0, -60.0
"""Between these float32 powers hold exp(E g) with room to spare."""


class Light(NamedTuple):
    """Many skies' numbers, NumPy: coefficients (T, C, 10), suns (T, 3), states (T,): 1 day, 0 night, -1 not valid."""

    coefficients: np.ndarray
    suns: np.ndarray
    states: np.ndarray
    offset: float
    floor: float
    quantity: Quantity

    @property
    def size(self) -> int:
        """Numbers of light in each direction."""
        return self.quantity.size(self.coefficients.shape[-2])

    def part(self, some: slice) -> "Light":
        """Some of the skies."""
        return self._replace(coefficients=self.coefficients[some], suns=self.suns[some], states=self.states[some])


def kernels() -> Any:
    """The compiled formula's module, or None where Numba is not installed."""
    if not has_numba():
        return None
    from skydome.skies.formula import kernel

    return kernel


def odd_skies(coefficients: np.ndarray) -> np.ndarray:
    """Which of the skies (T, C, 10) the kernels cannot take, (T,): not finite, B > 0, or E beyond float32's powers."""
    c = coefficients
    odd = ~np.isfinite(c).all(axis=-1) | (c[..., B] > 0) | (c[..., E] > RISE) | (c[..., E] < FALL)
    found: np.ndarray = odd.any(axis=-1)
    return found


def chosen(values: int, coefficients: np.ndarray) -> Any:
    """The kernels' module where a job of so many numbers should take it, else None."""
    if values < LEAST_VALUES or np.mean(odd_skies(coefficients)) > MOST_ODD:
        return None
    return kernels()


def smaller_with(constant: np.ndarray, factor: np.ndarray) -> np.ndarray:
    """1 where constant + factor is smaller than the constant, else 0: which form of the sum keeps more digits."""
    smaller: np.ndarray = (np.abs(constant + factor) < np.abs(constant)).astype(np.float64)
    return smaller


def prepared(light: Light) -> tuple[np.ndarray, tuple[np.ndarray, bool, np.ndarray]]:
    """Letters (T, C, 13) in float32 as the kernels read them, and what is left to do: matrix, chromatic, balance."""
    c = light.coefficients
    level, matrix = c[..., R], light.quantity.matrix
    gains = light.quantity.gains
    if gains is not None:
        level, matrix = level * gains, None
    gap = np.maximum((1 - c[..., H]) ** 2, 1e-12)
    turn = np.log2(np.e)
    m, n = smaller_with(c[..., C], c[..., D]), smaller_with(np.ones_like(level), c[..., A])
    gradation = [level * (1 + n * c[..., A]), level * c[..., A], c[..., B] * turn]
    indicatrix = [c[..., C] + m * c[..., D], c[..., D], c[..., E] * turn, c[..., F], c[..., G], gap, 2 * c[..., H]]
    letters = np.stack([*gradation, *indicatrix, c[..., I], m, n], axis=-1).astype(np.float32)
    none = np.zeros((0, 0), np.float32)
    matrix = none if matrix is None else np.ascontiguousarray(matrix, dtype=np.float32)
    balance = light.quantity.balance
    return letters, (matrix, light.quantity.chromatic, np.asarray([] if balance is None else balance, np.float32))


def many_skies(kernel: Any, light: Light, directions: np.ndarray, out: np.ndarray) -> None:
    """Write the light of T skies toward D directions, (D, 3), into `out`, contiguous float32 (T, D, K)."""
    letters, rest = prepared(light)
    toward = np.ascontiguousarray(directions, dtype=np.float32).reshape(-1)
    suns, states = light.suns.astype(np.float32), light.states.astype(np.float32)
    edges = np.array([light.offset, light.floor], np.float32)
    rows = 8 + letters.shape[1] + light.size
    flat = out.reshape(-1)

    def job(first: int, last: int) -> int:
        work = np.empty((rows, kernel.BLOCK), np.float32)
        return int(kernel.many_skies(first, last, letters, suns, states, toward, edges, *rest, work, flat))

    blocks = -(-len(directions) // kernel.BLOCK)
    tiles = blocks * -(-len(letters) // kernel.SKIES_IN_TILE)
    if sum(shared(job, tiles, out.size)):
        raise ValueError("directions must be finite unit vectors within 1e-3; scale them with skydome.unit(...)")
    for sky in np.flatnonzero(odd_skies(light.coefficients) & (light.states == 1)):
        out.reshape(len(letters), -1, light.size)[sky] = formula_light(light.part(slice(sky, sky + 1)), directions)[0]


def formula_light(light: Light, directions: np.ndarray) -> np.ndarray:
    """The light of T skies toward directions (D, 3) by the readable formula, float64 (T, D, K)."""
    cosine, angle = view_geometry(directions, light.suns[:, None, :])
    channels = evaluate(light.coefficients[:, None], cosine, angle, light.offset, light.floor)
    states = light.states[:, None, None]
    result = np.where((states == 1) & (directions[:, 2:] >= 0), light.quantity.of(channels), 0.0)
    return np.where(states < 0, np.nan, result)


def checked_out(out: Any, shape: tuple[int, ...]) -> np.ndarray:
    """`out` itself; TypeError or ValueError in one line unless it is a writable float array of that shape."""
    if not isinstance(out, np.ndarray) or out.dtype not in (np.float32, np.float64):
        kind = out.dtype if isinstance(out, np.ndarray) else type(out).__name__
        raise TypeError(f"out must be a NumPy array of float32 or float64, got {kind}")
    if out.shape != shape:
        raise ValueError(f"out must have shape {shape}, got {out.shape}")
    if not out.flags.writeable:
        raise ValueError("out must be writable, got a read-only array")
    return out
