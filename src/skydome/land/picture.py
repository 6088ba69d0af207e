"""Pictures of real land: an elevation model under a sky, with shadows, skylight on slopes, and the air in between."""

from collections.abc import Callable
from typing import Any

import numpy as np

from skydome.dome.integrals import discs_and_rest
from skydome.eye.view import Camera
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import as_numpy, constant
from skydome.ground.compiled import shared
from skydome.ground.directions import ZENITH, direction, tangent_frame, unit
from skydome.ground.extras import required
from skydome.ground.limits.ranges import SEED, require, require_one
from skydome.ground.limits.sizes import require_count
from skydome.ground.quadrature import gauss_legendre
from skydome.ground.units import EARTH_RADIUS
from skydome.haze.aerial_perspective import AirLight
from skydome.haze.fast import FastTables
from skydome.haze.horizon_light import HORIZON, horizon_directions
from skydome.haze.ward_larson import WardLarson
from skydome.land.elevation import Elevation
from skydome.land.terrain_picture import TerrainPicture
from skydome.land.texture import surface_of
from skydome.light.colour import rgb_from_xyz
from skydome.skies.colour_sky import ColourSky
from skydome.skies.sky import Sky

REFRACTION = 7 / 6
"""By how much refraction flattens the Earth for a ray near the ground."""

SECTORS, RINGS = 16, 8
"""Azimuths of the skyline about each vertex, and elevations at which the sky is taken."""

MOST_LIT, MOST_SAMPLES = 100_000, 4096
"""Vertices whose skylight is computed; between them it is interpolated."""

ROWS_AT_A_TIME = 64
VERTICES_PER_PIECE = 1 << 10
SUN_POINTS = 4000
"""Points of the sun's disc that are laid onto the picture."""

GRASS = (0.11, 0.12, 0.07)
"""Reflectance of the ground in linear sRGB unless given: dry grass and forest."""


def render_terrain(
    elevation: Elevation,
    camera: Camera,
    sky: Sky,
    air: AirLight | WardLarson | None = None,
    albedo: Any = GRASS,
    samples: int = 16,
    curvature: bool = False,
    seed: int = 0,
    progress: Callable[[int, int], None] | None = None,
) -> TerrainPicture:
    """The view of a camera on the land under a sky (with the sun's disc added) through `air`; None is a vacuum.

    `albedo`: RGB (3,), or an image (h, w, 3) in linear sRGB stretched over the map. `samples` a pixel: a square
    number. `curvature`: lower the land, and the ground beyond it, by the Earth's curve, less refraction.
    `progress(done, rows)` is called as rows are finished. Beyond the map lies ground of the mean albedo at its lowest
    height, from which `air` measures heights. Needs Numba.

    >>> import skydome as sd
    >>> hill, sky = sd.Elevation(np.eye(9), dx=30.0, dy=30.0), sd.Preetham(sd.direction(2.0, 0.7), turbidity=3.0)
    >>> render_terrain(hill, sd.Camera(width=8, height=6), sky, samples=1).rgb.shape
    (6, 8, 3)
    """
    required("numba", "terrain", "a terrain picture")
    from skydome.land.picture_kernel import picture_rows
    from skydome.land.rays_kernel import height_at

    require_kind(elevation, Elevation, "elevation", "Elevation(heights, dx=30.0, dy=30.0) or read_elevation(file)")
    require_kind(camera, Camera, "camera", "Camera(azimuth=270 * deg)")
    require_kind(sky, Sky, "sky", "HosekWilkie(sun, turbidity=3.0)")
    require_kind(air, AirLight | WardLarson | None, "air", "AirLight(sky)")
    require_kind(curvature, bool, "curvature", "True")
    require_kind(progress, Callable | None, "progress", "print")  # type: ignore[arg-type]
    require_samples(samples)
    require("seed", seed, SEED)
    require_one("seed", seed, whole=True)
    u, v = place_on(elevation, camera)
    heights = curved(elevation, u, v) if curvature else np.ascontiguousarray(elevation.heights, dtype=np.float64)
    z, base = height_at(heights, u, v) + camera.above_ground, float(np.min(elevation.heights))
    bend = 1 / (2 * EARTH_RADIUS * REFRACTION) if curvature else 0.0
    ground = (heights, *pyramid_of(heights), float(elevation.dx), float(elevation.dy), (base, bend))
    surface = surface_of(albedo, heights.shape)
    sunlight, rest = sun_of(sky), skylight_of(sky)
    lit = lit_slopes(ground, rest, sunlight, surface[3])
    through = air_for(air, z - base)
    height, width = camera.shape
    right, up, forward = camera.axes
    background = background_of(sky, camera)
    half = camera.pixel / 2
    view = (u, v, float(z), forward, right * (half * width), up * (half * height), width, height)
    rgb, depth = np.zeros((height, width, 3), np.float32), np.zeros((height, width))
    given = (ground, view, samples, seed, background, sunlight, lit, surface, through, rgb, depth)
    for first in range(0, height, ROWS_AT_A_TIME):
        last = min(first + ROWS_AT_A_TIME, height)
        shared(lambda a, b, start=first: picture_rows(start + a, start + b, *given), last - first, last - first, (), 1)
        if progress is not None:
            progress(last, height)
    return TerrainPicture(rgb, depth.astype(np.float32))


def require_samples(samples: int) -> None:
    """ValueError unless a square number."""
    require_kind(samples, int, "samples", "16")
    require_count(samples, MOST_SAMPLES, "samples a pixel")
    if samples < 1 or round(samples**0.5) ** 2 != samples:
        raise ValueError(f"samples must be a square number such as 1, 4, 9 or 16, got {samples}")


def place_on(elevation: Elevation, camera: Camera) -> tuple[float, float]:
    """The camera's place in cells (u, v); ValueError off the map."""
    rows, columns = elevation.heights.shape
    u = (columns - 1) / 2 + camera.east / elevation.dx
    v = (rows - 1) / 2 - camera.north / elevation.dy
    if not (0 <= u <= columns - 1 and 0 <= v <= rows - 1):
        half = (columns - 1) / 2 * elevation.dx, (rows - 1) / 2 * elevation.dy
        raise ValueError(
            f"the camera must stand on the map, within {half[0]:.0f} m east or west and {half[1]:.0f} m north or south "
            f"of its middle, got {camera.east:g}, {camera.north:g}"
        )
    return float(u), float(v)


def curved(elevation: Elevation, u: float, v: float) -> np.ndarray:
    """Heights lowered by the Earth's curve as seen from (u, v)."""
    rows, columns = elevation.heights.shape
    y, x = np.meshgrid((np.arange(rows) - v) * elevation.dy, (np.arange(columns) - u) * elevation.dx, indexing="ij")
    return np.ascontiguousarray(elevation.heights - (x * x + y * y) / (2 * EARTH_RADIUS * REFRACTION))


def pyramid_of(heights: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Maxima of 2^k x 2^k blocks of cells, flat, and (offset, rows, columns) of each level."""
    cells = np.maximum(np.maximum(heights[:-1, :-1], heights[1:, :-1]), np.maximum(heights[:-1, 1:], heights[1:, 1:]))
    levels = [cells]
    while max(levels[-1].shape) > 1:
        rows, columns = ((size + 1) // 2 for size in levels[-1].shape)
        pad = [(0, 2 * rows - levels[-1].shape[0]), (0, 2 * columns - levels[-1].shape[1])]
        levels.append(np.pad(levels[-1], pad, mode="edge").reshape(rows, 2, columns, 2).max(axis=(1, 3)))
    offsets = np.cumsum([0, *(level.size for level in levels[:-1])])
    shapes = np.array([(o, *level.shape) for o, level in zip(offsets, levels, strict=True)], dtype=np.int64)
    return np.concatenate([level.ravel() for level in levels]), shapes


def sun_of(sky: Sky) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Direction to the sun in a sky, two tangents as long as its disc's radius, and normal irradiance in RGB.

    Each (3,); dark without a disc.
    """
    discs, _ = discs_and_rest(sky)
    if not discs:
        return np.array([0.0, 0.0, 1.0]), np.zeros(3), np.zeros(3), np.zeros(3)
    disc, weight = discs[0]
    light = np.maximum(rgb_from_xyz(np.asarray(disc.normal_xyz)) * weight, 0.0)
    sun = np.asarray(disc.sun, dtype=np.float64)
    across, upward = (np.asarray(axis) * np.tan(disc.angular_radius) for axis in tangent_frame(sun))
    return sun, across, upward, light


def skylight_of(sky: Sky) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Azimuths (K,), elevations (M,), weights (M,) and the sky's RGB there (K, M, 3), without the sun's disc."""
    sines, steps = gauss_legendre(RINGS)
    azimuths, elevations = np.arange(SECTORS) * (2 * np.pi / SECTORS), np.arcsin(sines)
    nodes = direction(azimuths[:, None], elevations)
    light = np.maximum(rgb_of(discs_and_rest(sky)[1], nodes), 0.0)
    return azimuths, elevations, steps * (2 * np.pi / SECTORS), np.ascontiguousarray(light)


def rgb_of(skies: list[Sky], directions: np.ndarray) -> np.ndarray:
    """The sum of their RGB (..., 3); TypeError for a sky without colour."""
    total = np.zeros(directions.shape)
    for sky in skies:
        if not isinstance(sky, ColourSky):
            raise TypeError(f"{type(sky).__name__} knows luminance only; give it colour with Daylight(sky)")
        total = total + np.asarray(sky.rgb(directions))
    return total


def background_of(sky: Sky, camera: Camera) -> np.ndarray:
    """RGB (H, W, 3) of the sky with the sun's disc, whose energy is right at every resolution."""
    discs, rest = discs_and_rest(sky)
    height, width = camera.shape
    image = np.zeros((height, width, 3))
    for first in range(0, height, ROWS_AT_A_TIME):
        last = min(first + ROWS_AT_A_TIME, height)
        views = camera.directions(first, last)
        views[..., 2] = np.maximum(views[..., 2], HORIZON)  # a pixel on the horizon has sky in its upper part
        image[first:last] = np.maximum(rgb_of(rest, unit(views)), 0.0)
    for disc, weight in discs:
        points, light = disc.points(SUN_POINTS)
        row, column = (np.floor(place) for place in camera.place(points))  # NaN behind the camera
        seen = (row >= 0) & (row < height) & (column >= 0) & (column < width)
        radiance = (
            np.maximum(rgb_from_xyz(light) * weight, 0.0)[seen] / camera.solid_angle_toward(points[seen])[:, None]
        )
        np.add.at(image, (row[seen].astype(int), column[seen].astype(int)), radiance)
    return image


def lit_slopes(ground: Any, rest: Any, sunlight: Any, albedo: np.ndarray) -> tuple[np.ndarray, int, np.ndarray]:
    """How skylight on the vertices depends on the normal (see `skylight`), their stride, and what is bounced (3,)."""
    from skydome.land.rays_kernel import skylight

    heights, _, _, dx, dy, _ = ground
    azimuths, elevations, weights, light = rest
    level = np.einsum("m,kmc->c", weights * np.sin(elevations), light)
    bounce = albedo * (level + sunlight[3] * max(sunlight[0][2], 0.0))
    stride = max(1, int(np.ceil(np.sqrt(heights.size / MOST_LIT))))
    found = np.zeros((*((size - 1) // stride + 1 for size in heights.shape), 9))
    given = (heights, dx, dy, stride, azimuths, elevations, weights, light, bounce, found)
    shared(skylight, len(found), found.size, given, VERTICES_PER_PIECE)
    return found, stride, bounce


def air_for(air: AirLight | WardLarson | None, height: float) -> tuple[int, np.ndarray, np.ndarray, FastTables, Any]:
    """What the kernel needs to know of the air: its kind, the fog, the densities at the camera, tables, factors."""
    from skydome.land.picture_kernel import CLEAR, FOG, NOTHING

    single, densities = np.float32, np.ones(2, np.float32)
    empty = FastTables(
        np.ones(10, single), np.ones((3, 1), single), np.zeros((2, 2, 6), single), np.zeros((0, 3), single),
        np.zeros((0, 2, 6), single),
    )  # fmt: skip
    if air is None:
        return NOTHING, np.zeros(6), densities, empty, np.ones((2, 3))
    if isinstance(air, WardLarson):
        tau = np.asarray(air.at(1000.0, np.array([0.0, 1.0, 0.0]), height).transmittance)
        return FOG, np.concatenate([-np.log(tau) / 1000, np.asarray(air.ambient)]), densities, empty, np.ones((2, 3))
    fast = air.fast
    return CLEAR, np.zeros(6), fast.densities(height), fast.tables, horizon_factors(air, height)


def horizon_factors(air: AirLight, height: float) -> np.ndarray:
    """By what scattered light is multiplied: around the horizon, closed on itself, and last toward nadir and zenith.

    Shape (TURNS + 2, 3); ones of shape (2, 3) where the air keeps its own limit.
    """
    if not air.melts:
        return np.ones((2, 3))
    around = horizon_directions()
    views = np.concatenate([around, around[:1], [ZENITH]])
    return np.ascontiguousarray(as_numpy(air.factor(constant(views, air.like), constant(height, air.like))), np.float64)
