"""The taught air's round shells, and rays through them: nodes that crowd where the air is dense.

Sunlight comes by bent rays (`air.bending`), and so does the light that reaches the eye on the ground; between two
points in the air it goes straight.

Four constituents, in the order of `Optics`: molecules, low aerosol, stratospheric aerosol, ozone; all lengths in m.
"""

from functools import cache
from typing import NamedTuple

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.profiles import OZONE_LAYER, STANDARD_1976, STRATOSPHERIC_LAYER, Exponential
from skydome.ground.extras import required
from skydome.ground.quadrature import gauss_legendre
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.single_scattering import along

RADIUS, TOP = 6_371_000.0, 100_000.0
PROFILES = (STANDARD_1976, Exponential(1_500.0), STRATOSPHERIC_LAYER, OZONE_LAYER)
DENSE = 600.0
"""A rise by which a ray's first nodes are spread."""


@cache
def tables() -> ColumnTables:
    """Columns out to space of the four, as `PhysicalSky` has them."""
    from skydome.air.constituents import Aerosol

    return ColumnTables.of(Atmosphere(tuple(Aerosol(profile=part) for part in PROFILES), radius=RADIUS, height=TOP))


def density(heights: np.ndarray) -> np.ndarray:
    """Densities of a column of 1, m-1, (..., 4)."""
    return np.stack([part.density(np.maximum(heights, 0.0)) for part in PROFILES], axis=-1)


class Rays(NamedTuple):
    """Nodes along N rays, (N, K) each: how far round the planet, radians, weight, m, height and cosine to the
    vertical; columns from the start and densities (N, K, 4); for each ray whether it meets the ground, how far round
    it goes, and its whole column (N, 4).
    """

    arc: np.ndarray
    step: np.ndarray
    height: np.ndarray
    cosine: np.ndarray
    column: np.ndarray
    density: np.ndarray
    grounded: np.ndarray
    end: np.ndarray
    whole: np.ndarray

    @classmethod
    def of(cls, heights: np.ndarray, cosines: np.ndarray, nodes: int) -> "Rays":
        """Rays from heights (N,) toward cosines to the vertical (N,)."""
        return cls(
            *map(np.stack, zip(*(ray(h, mu, nodes) for h, mu in zip(heights, cosines, strict=True)), strict=True))
        )

    @classmethod
    def to_the_eye(cls, cosines: np.ndarray, nodes: int) -> "Rays":
        """Bent rays from the ground, seen at cosines to the vertical (N,) of 0 or more."""
        straight = cls.of(np.zeros(len(cosines)), cosines, nodes)
        before, after = along(tables(), cosines, straight.height)
        denser = before / after
        column = np.stack([bent_columns(mu, row) for mu, row in zip(cosines, straight.height, strict=True)])
        turn = tables().turned(np.zeros_like(cosines), cosines)[:, None] - tables().turned(straight.height, after)
        arc = np.arccos(cosines)[:, None] + turn - np.arccos(after)
        return straight._replace(arc=arc, step=straight.step * denser, cosine=after, column=column)


def ray(height: float, cosine: float, nodes: int) -> tuple[np.ndarray, ...]:
    """The row of `Rays` of one ray."""
    r = RADIUS + height
    least = r * r * (1 - cosine * cosine)
    if cosine >= 0:
        t, step, fine, length = rising(r, cosine, nodes)
    elif least < RADIUS**2:
        t, step, fine, length = to_the_ground(r, cosine, least, nodes)
    else:
        t, step, fine, length = past_the_ground(r, cosine, np.sqrt(least), nodes)
    reached = np.sqrt(r * r + t * t + 2 * r * cosine * t)
    column, whole = columns_along(r, cosine, fine, t)
    h = np.maximum(reached - RADIUS, 0.0)
    toward = np.clip((r * cosine + t) / reached, -1, 1)
    grounded = np.array(cosine < 0 and least < RADIUS**2)
    level = np.sqrt(max(1 - cosine * cosine, 0.0))
    arc, end = (np.arctan2(level * d, r + cosine * d) for d in (t, np.array(length)))
    return arc, step, h, toward, column, density(h), grounded, end, whole


def bent_columns(cosine: float, heights: np.ndarray) -> np.ndarray:
    """Columns (K, 4) from the ground to heights (K,) along a bent ray seen at a cosine."""
    own = tables()
    whole = own.toward(np.zeros(1), np.array([cosine]))
    after = along(own, np.array([cosine]), heights[None])[1][0]
    return np.asarray(whole - own.toward(heights, after))


def spread(s: np.ndarray, first: float, length: float) -> tuple[np.ndarray, np.ndarray]:
    """Distances 0 .. length at s in [0, 1], fine within `first`, and their slopes."""
    k = np.log1p(length / first)
    return first * np.expm1(k * s), first * k * np.exp(k * s)


def rise(r: float, cosine: float, by: float) -> float:
    """Distance from radius r toward a cosine of 0 or more to rise by so much."""
    return float(-r * cosine + np.sqrt((r * cosine) ** 2 + 2 * r * by + by * by))


def rising(r: float, cosine: float, nodes: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, float]:
    """Distances, weights, fine distances and length of a ray out to space."""
    length = max(rise(r, cosine, RADIUS + TOP - r), 1.0)
    first = min(max(rise(r, cosine, DENSE), 50.0), 1000.0 + 2 * (r - RADIUS))
    s, w = gauss_legendre(nodes)
    t, slope = spread(s, first, length)
    return t, slope * w, spread(np.linspace(0, 1, 1200), first, length)[0], length


def to_the_ground(
    r: float, cosine: float, least: float, nodes: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray, float]:
    """The same for a ray that meets the ground: fine there and at its start."""
    length = max(float(-r * cosine - np.sqrt(RADIUS**2 - least)), 1e-6)
    first = min(rise(RADIUS, float(np.sqrt(max(1 - least / RADIUS**2, 1e-12))), DENSE), 1000.0)
    s, w = gauss_legendre(nodes)
    u, slope = spread(s, first, length)
    fine = [length - spread(np.linspace(0, 1, 800), first, length)[0], spread(np.linspace(0, 1, 400), first, length)[0]]
    return (length - u)[::-1], (slope * w)[::-1], np.unique(np.clip(np.concatenate(fine), 0, length)), length


def past_the_ground(
    r: float, cosine: float, lowest: float, nodes: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray, float]:
    """The same for a ray that falls and rises again: fine where it is lowest."""
    before, after = -r * cosine, float(np.sqrt((RADIUS + TOP) ** 2 - lowest**2))
    first = min(rise(lowest, 0.0, DENSE), 1000.0 + 2 * (lowest - RADIUS))
    (s, w), (s2, w2) = gauss_legendre(nodes // 2), gauss_legendre(nodes - nodes // 2)
    (u, slope), (v, slope2) = spread(s, first, before), spread(s2, first, after)
    even = np.linspace(0, 1, 600)
    fine = np.concatenate([before - spread(even, first, before)[0], before + spread(even, first, after)[0]])
    t, step = np.concatenate([(before - u)[::-1], before + v]), np.concatenate([(slope * w)[::-1], slope2 * w2])
    return t, step, np.unique(np.clip(fine, 0, before + after)), before + after


def columns_along(r: float, cosine: float, fine: np.ndarray, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Columns (K, 4) from the start to distances t, and to the end of the fine distances (4,), by Simpson's rule."""
    required("scipy", "fit", "the physical sky's teacher")
    from scipy.interpolate import CubicHermiteSpline

    def along(distance: np.ndarray) -> np.ndarray:
        return density(np.sqrt(r * r + distance**2 + 2 * r * cosine * distance) - RADIUS)

    if fine[-1] < 1e-3:
        return np.zeros((len(t), 4)), np.zeros(4)
    ends, middles = along(fine), along((fine[1:] + fine[:-1]) / 2)
    pieces = (ends[1:] + ends[:-1] + 4 * middles) / 6 * np.diff(fine)[:, None]
    sums = np.concatenate([np.zeros((1, 4)), np.cumsum(pieces, axis=0)])
    return CubicHermiteSpline(fine, sums, ends)(t), sums[-1]
