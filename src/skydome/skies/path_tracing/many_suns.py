"""The path tracer's other way to find the sun: by chance, with many suns in the sky at once.

Air and ground are alike all round the vertical, so a path that leaves toward a sun at another azimuth is, turned about
the vertical, a path toward the sun: of one ring of views all round at one elevation, each path serves any.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.ground.arrays import Array
from skydome.ground.compiled import shared
from skydome.ground.extras import required
from skydome.ground.limits.ranges import Range, require
from skydome.ground.units import deg
from skydome.light.spectrum import checked_wavelengths
from skydome.skies.path_tracing.sky import PATHS_PER_PIECE, PathTraced
from skydome.skies.path_tracing.tables import law_tables, shells

PARTS = 16


@dataclass(frozen=True, eq=False)
class Rings:
    """Light of views at elevations (E,) and azimuths (N,) counted from the sun's, mean over the sun's disc.

    `radiance` and `standard_error` in W m-2 sr-1 nm-1, shape (E, N, W). Of a direction without a hit the radiance is 0
    and the error an upper bound: that of one hit.
    """

    elevations: np.ndarray
    azimuths: np.ndarray
    radiance: np.ndarray
    standard_error: np.ndarray


def many_suns(
    sky: PathTraced, elevations: Any, wavelengths: Any, paths: int = 1 << 20, radius: float = 0.25 * deg
) -> Rings:
    """The light of rings of views at `elevations` (E,), radians, by paths that hit one of many suns of `radius`, rad.

    As many suns as have room side by side at the sun's elevation, 720 at the horizon (Hosek and Wilkie 2012, section
    3). `paths` for each ring and wavelength. Without next-event estimation: for tests and for air that has no aimed
    light; over 1000 times slower than `PathTraced` itself. The sun's disc is not seen directly.
    """
    required("numba", "fast", "many_suns")
    from skydome.skies.path_tracing.many_suns_kernel import hits

    require("radius", radius, Range(1e-3, 0.2, "rad"))
    w, rings = checked_wavelengths(wavelengths), np.atleast_1d(np.asarray(elevations, dtype=np.float64))
    air, laws = shells(sky.atmosphere, w), law_tables(sky.atmosphere, w)
    sine = float(sky.sun[2])
    suns, each = suns_with_room(sine, radius), -(-paths // PARTS)
    mean, error = np.empty((rings.size, suns, w.size)), np.empty((rings.size, suns, w.size))
    for e, height in enumerate(rings):
        view = np.array([np.cos(height), 0.0, np.sin(height)])
        for j in range(w.size):
            seed = sky.seed + 7919 * (e * w.size + j + 1)
            found = np.zeros((PARTS, 2, suns))
            given = (view, sine, suns, np.cos(radius), j, air, laws, seed, each, found)
            shared(hits, PARTS, PARTS * each, given, PATHS_PER_PIECE)
            mean[e, :, j], error[e, :, j] = estimate(found.sum(axis=0), each * PARTS, radius)
    views = np.stack([np.cos(rings), 0 * rings, np.sin(rings)], axis=-1)
    sunlight = sky.sunlight(views[:, None, :], w)
    return Rings(rings, 2 * np.pi * np.arange(suns) / suns, mean * sunlight, error * sunlight)


def suns_with_room(sine: float, radius: float) -> int:
    """How many suns of an angular radius stand side by side round the horizon at an elevation of that sine."""
    level = np.sqrt(1 - sine * sine)
    return int(np.pi / np.arcsin(min(np.sin(radius) / level, 1.0))) if level > np.sin(radius) else 1


def estimate(sums: np.ndarray, paths: int, radius: float) -> tuple[Array, Array]:
    """Radiance and standard error for a sun of irradiance 1, sr-1, (N,), from sums of weights and squares (2, N).

    A direction without a hit has light 0 and, as its error, what one more hit of the ring's usual weight would have
    given: an upper bound, infinite where nothing of the ring was hit.
    """
    solid_angle = 2 * np.pi * (1 - np.cos(radius))
    mean = sums[0] / paths
    variance = np.maximum(sums[1] / paths - mean**2, 0.0) / paths
    one_hit = sums[1].sum() / sums[0].sum() / paths if sums[0].any() else np.inf
    error = np.where(sums[0] > 0, np.sqrt(variance), one_hit)
    return mean / solid_angle, error / solid_angle
