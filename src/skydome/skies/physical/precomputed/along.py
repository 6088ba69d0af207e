"""Light along an observer's lines: scattered once, by quadrature and exactly, and thrown back by the ground."""

import numpy as np

from skydome.air.rays import ColumnTable, rays
from skydome.ground.arrays import Array
from skydome.skies.physical.nishita import lit_columns
from skydome.skies.physical.precomputed.observer import Lines

SAMPLES = 64


def scattered_once(table: ColumnTable, line: Lines, wavelengths: np.ndarray, depths: np.ndarray) -> tuple[Array, Array]:
    """Light scattered once, for sunlight of 1, sr-1, and what is left of light from the lines' ends, (N, W) each.

    `depths` (K, W): what light meets of each constituent on its way, as vertical optical depths.
    """
    parts = table.air.constituents
    path = rays(table.air, line.radius, line.mu, SAMPLES)
    reach = lit_columns(table, path, line.radius, line.mu_s[:, None], line.nu, depths)
    light = np.zeros((line.nu.size, wavelengths.size))
    for k, part in enumerate(parts):
        strength = part.depth(wavelengths) * part.scattered(wavelengths)
        if strength.any():
            light += part.phase_law.value(line.nu, wavelengths) * strength * reach[:, k]
    return light, np.exp(-(path.total.T @ depths))


def sun_at_end(line: Lines, bottom: float) -> Array:
    """Cosine of the sun's zenith angle where lines meet the ground, (N,)."""
    inside = (line.radius * line.mu) ** 2 - line.radius**2 + bottom**2
    d = -line.radius * line.mu - np.sqrt(np.maximum(inside, 0.0))
    return np.asarray(np.clip((line.radius * line.mu_s + d * line.nu) / bottom, -1.0, 1.0))
