"""What guides the path tracer in twilight: coarse tables of the light in the air, by height and sun."""

from typing import NamedTuple

import numpy as np

from skydome.skies.path_tracing.tables import Shells

HEIGHTS, SUNS, ROWS, TURNS, CELLS, ORDERS = 24, 48, 32, 8, 16, 4
REACH = 0.25
"""How far from the observer's the sines of the sun's elevation go, as they are elsewhere."""


class Guide(NamedTuple):
    """Tables over H heights (even in the root), S sines of the sun's elevation and 4 of the wavelengths."""

    share: float
    """Of the flights, sampled by the guide; 0: no guide."""
    turn_share: float
    """Of the directions."""
    enough: float
    """Russian roulette below this part of the radiance expected of the view."""
    cells: int
    """That a segment is cut into."""
    bands: np.ndarray
    least: float
    most: float
    multiple: np.ndarray
    """Logarithm of the light scattered before, that a metre of air scatters, sr-1 m-1, (H, S, 4)."""
    source: np.ndarray
    """The same with sunlight, (H, S, 4)."""
    extinction: np.ndarray
    """m-1, (H, 4)."""
    ground: np.ndarray
    """Radiance of the ground, sr-1, (S, 4)."""
    rows: np.ndarray
    """Running sums of the light by rows of directions from nadir to zenith, (H, S, rows)."""
    turns: np.ndarray
    """... and within a row by azimuth from the sun's, (H, S, rows, turns)."""


def guide_for(air: Shells, sine: float, share: float, turn_share: float = 0.7, enough: float = 0.7) -> Guide:
    """The guide of an observer on the ground whose sun's elevation has that sine."""
    h, s, rows, turns, cells = (HEIGHTS, SUNS, ROWS, TURNS, CELLS) if share > 0 else (2, 2, 1, 1, 1)
    bands = np.round(np.linspace(0, air.bands - 1, 4)).astype(np.int64)
    tables = np.zeros((h, s, 4)), np.zeros((h, s, 4)), np.zeros((h, 4)), np.zeros((s, 4))
    turned = np.zeros((h, s, rows)), np.zeros((h, s, rows, turns))
    guide = Guide(share, turn_share, enough, cells, bands, sine - REACH, sine + REACH, *tables, *turned)
    if share > 0:
        fill_guide(air, guide)
    return guide


def fill_guide(air: Shells, guide: Guide) -> None:
    """Fill the guide's tables: order by order, as if air scattered alike all round."""
    from skydome.skies.path_tracing.guide_tables_kernel import direct_light, fill_tables, gathered, summed_up

    shape = guide.multiple.shape
    direct, mean, scattering = np.zeros(shape), np.zeros(shape), np.zeros((shape[0], 4))
    count = air.rates.size
    direct_light(air, guide, direct, scattering, np.empty(count), np.empty(count), np.empty(air.albedo.size))
    own, weight = (shape[1] - 1) // 2, np.ones(4)
    for _ in range(ORDERS):
        fill_tables(air, guide, direct, scattering, mean)
        gathered(
            air, guide, weight, mean, np.ones(4), np.zeros((4, 4)), np.zeros(guide.cells + 1), np.zeros(guide.cells + 2)
        )
        weight = 1 / np.maximum(mean[0, own], 1e-290)
    fill_tables(air, guide, direct, scattering, mean)
    summed_up(guide)
