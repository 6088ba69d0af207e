"""Fields of cloud for the explorer's page, data/clouds.json: `python scripts/export_clouds.py`.

The kinds' numbers, the constants of the fast form, and columns of air between the eye, the clouds and the sun. The page
makes the clouds themselves from the same hash; their shapes are written out once more there.
"""

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.cross_sections import rayleigh_depth
from skydome.air.named_airs import BACKGROUND_DEPTH, KINDS, background
from skydome.ground.units import EARTH_RADIUS
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.spectral_nodes import NODES, bands_from_nodes
from skydome.skies.clouds.fields import field, lit_field, low_sun, march_kernel, scattering, shadows
from skydome.skies.clouds.fields.air.before import LEVELS, VIEWS, AirBefore
from skydome.skies.clouds.fields.kinds import Altocumulus, Cirrus, CloudKind, Cumulus, Stratocumulus
from skydome.skies.physical.sky_colours import SkyColours
from skydome.skies.suns.sun_disc import MEAN_RADIUS

PATH = Path(__file__).resolve().parent.parent / "explorer" / "src" / "data" / "clouds.json"
SINES = np.linspace(0.0, 1.0, VIEWS) ** 2
DIFFUSION = {"open": [600.0, 4.0], "sweeps": 16, "over": 1.7, "fewest": 8}
"""The page's own way: how empty air scatters in it (docs/decisions.md), sweeps, how far beyond, cells at the fewest."""
STANDING = -4.0 + 94.0 * np.linspace(0.0, 1.0, 64) ** 2
"""True elevations of suns, degrees."""
FIGURES = 5


def plain(values: Any, figures: int = FIGURES) -> Any:
    """Numbers as lists, to so many figures."""
    rounded = [float(f"{value:.{figures}g}") for value in np.asarray(values, np.float64).ravel()]
    return np.reshape(rounded, np.shape(values)).tolist()


def numbers_of(kind: CloudKind) -> dict[str, Any]:
    """What the page knows of a kind."""
    names = ("base", "thickness", "extinction", "period", "count", "levels", "erosion", "detail", "edge")
    profile = kind.profile((np.arange(kind.levels) + 0.5) / kind.levels)
    asymmetry = float(np.asarray(kind.law.mean_cosine([550.0]))[0])
    told = {name: getattr(kind, name) for name in names}
    return told | {"particles": kind.particles.name, "asymmetry": asymmetry, "profile": plain(profile, 7)}


def columns_of(air: Atmosphere, kind: CloudKind) -> tuple[np.ndarray, np.ndarray]:
    """Vertical columns of molecules, haze and ozone between the eye and the heights of a kind, (VIEWS, LEVELS, 3).

    And of suns at `STANDING`, as seen from its middle, the share that the ground leaves, and columns of these and of
    the stratosphere's haze, (SUNS, 5).
    """
    before = AirBefore(air, np.empty(0), kind.base, kind.base + kind.thickness)
    tables, middle = ColumnTables.of(air), np.full(STANDING.shape, before.heights[LEVELS // 2])
    seen, share = tables.seen(middle, np.radians(STANDING))
    return before.columns[..., :3], np.column_stack([share, tables.toward(middle, np.sin(seen))])


def table() -> dict[str, Any]:
    """Everything."""
    air = Atmosphere.standard(0.1)
    kinds = (Cumulus(), Stratocumulus(), Altocumulus(), Cirrus())
    columns = {kind.name: columns_of(air, kind) for kind in kinds}
    ozone = air.constituents[2]
    return {
        "kinds": {kind.name: numbers_of(kind) for kind in kinds},
        "met": field.MET,
        "closed": field.CLOSED,
        "lowest": low_sun.LOWEST,
        "farthest": lit_field.FARTHEST,
        **DIFFUSION,
        "widths": lit_field.WIDTHS.tolist(),
        "gone": march_kernel.GONE,
        "dense": march_kernel.DENSE,
        "earth": EARTH_RADIUS,
        "depths": scattering.DEPTHS,
        "first": scattering.FIRST,
        "step": scattering.STEP,
        "angles": scattering.ANGLES,
        "smooth": scattering.SMOOTH,
        "moments": scattering.MOMENTS,
        "points": shadows.POINTS,
        "discRadius": MEAN_RADIUS,
        "views": VIEWS,
        "wavelengths": NODES.tolist(),
        "colours": plain(SkyColours.of(air, bands_from_nodes().T).whole, 7),
        "rayleigh": float(rayleigh_depth([550.0])[0]),
        "molecules": plain(rayleigh_depth(NODES)),
        "ozone": plain(ozone.depth(NODES) / ozone.column, 5),
        "angstrom": {name: kind.angstrom for name, kind in KINDS.items()},
        "background": [BACKGROUND_DEPTH, background().angstrom],
        "between": {name: plain(each[0], 4) for name, each in columns.items()},
        "sunward": {name: plain(each[1]) for name, each in columns.items()},
        "standing": [STANDING[0], STANDING[-1]],
        "ground": plain(ColumnTables.of(air).toward(np.zeros(SINES.shape), SINES)),
    }


if __name__ == "__main__":
    PATH.write_text(json.dumps(table(), separators=(",", ":")) + "\n", "utf-8")
    sys.exit(0)
