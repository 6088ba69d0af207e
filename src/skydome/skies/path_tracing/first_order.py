"""Light scattered once toward the ground, by quadrature: along straight rays, or along bent ones to bent sunlight.

Under bent rays every node has its own sun: where the sun is seen from there is what its phase functions are about
(`PhysicalSky` takes that of the ground for all of them, whatever their height).
"""

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.rays import ColumnTable
from skydome.ground.arrays import Array
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.single_scattering import arcs, cosines, sun_over, toward_sun, view_rays
from skydome.skies.physical.nishita import scattered_once

VIEWS = 256
"""Directions at a time."""


def straight_once(air: Atmosphere, sun: np.ndarray, views: np.ndarray, wavelengths: np.ndarray) -> Array:
    """Light of a sun of irradiance 1 scattered once along straight views (D, 3), sr-1, (D, W)."""
    table, start = ColumnTable.of(air, 144, 128), np.full(len(views), air.radius)
    return scattered_once(table, start, views, sun, wavelengths)


def bent_once(air: Atmosphere, sun: np.ndarray, views: np.ndarray, wavelengths: np.ndarray) -> Array:
    """The same along views as they are seen, of a `sun` (3,) as it stands without air."""
    tables = ColumnTables.of(air)
    pieces = [
        on_bent_views(tables, air, cosines(sun, views[some : some + VIEWS]), wavelengths)
        for some in range(0, len(views), VIEWS)
    ]
    return np.concatenate(pieces)


def on_bent_views(
    tables: ColumnTables, air: Atmosphere, geometry: tuple[Array, Array, Array], wavelengths: np.ndarray
) -> Array:
    """Light (D, W) of views by the cosines of view, sun and the angle between."""
    view, sun, between = geometry
    view = np.maximum(view, 0.0)
    ray = view_rays(tables, view, sun, between)
    true = sun_over(tables, view, sun, between, ray)
    seen, left = tables.seen(ray.heights, true)
    depths = np.stack([np.asarray(part.depth(wavelengths)) for part in air.constituents])
    through = np.exp(-(tables.toward(ray.heights, np.sin(seen)) + ray.behind) @ depths)
    arc, flat = arcs(tables, view, ray), toward_sun(view, sun, between)[:, None]
    ahead = (np.cos(arc) * flat - np.sin(arc) * sun) * np.cos(seen) / np.cos(true)
    cosine = np.clip(ray.local * np.sin(seen) + np.sqrt(1 - ray.local**2) * ahead, -1.0, 1.0)
    light = np.zeros((len(view), wavelengths.size))
    for k, part in enumerate(air.constituents):
        strength = depths[k] * part.scattered(wavelengths)
        if strength.any():
            reach = through * (ray.density[..., k] * ray.step * left)[..., None]
            light += strength * (part.phase_law.value(cosine, wavelengths) * reach).sum(axis=1)
    return light
