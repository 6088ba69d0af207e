"""Rows of an equirectangular map of smooth skies held on a grid of the dome: each row's ring once."""

import numpy as np

from skydome.maps.equirectangular import Equirectangular
from skydome.maps.projection import texel_centre
from skydome.skies.night.held_dome import columns_at, rings_at


def paint_dome(colours: np.ndarray, projection: Equirectangular, height: int, rows: range, out: np.ndarray) -> None:
    """Write the light of a grid's `colours` (RINGS, COLUMNS, 3) into `out` (r, W, 3), rows above the horizon."""
    ring, on = rings_at(projection.elevations(texel_centre(np.arange(rows.start, rows.stop)), height))
    turn = projection.azimuths(texel_centre(np.arange(out.shape[1])), height) % (2 * np.pi)
    before, share = columns_at(turn)
    share = share.astype(colours.dtype)
    for line, low, part in zip(out, ring, on.astype(colours.dtype), strict=True):
        here = colours[low] * (1 - part) + colours[low + 1] * part
        line[...] = here[before] * (1 - share) + here[before + 1] * share
