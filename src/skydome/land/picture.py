"""Pictures of real land: an elevation model under a sky, with shadows, skylight on slopes, and the air in between."""

from collections.abc import Callable
from typing import Any

import numpy as np

from skydome.eye.view import Camera
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import as_numpy, constant
from skydome.ground.compiled import shared
from skydome.ground.directions import ZENITH
from skydome.ground.extras import required
from skydome.ground.limits.ranges import SEED, require, require_one
from skydome.ground.limits.sizes import require_count
from skydome.ground.units import EARTH_RADIUS
from skydome.haze.aerial_perspective import AirLight
from skydome.haze.fast import FastTables
from skydome.haze.horizon_light import horizon_directions
from skydome.haze.ward_larson import WardLarson
from skydome.land.cloud_shade import shade_of
from skydome.land.elevation import Elevation
from skydome.land.sky_light import background_of, skylight_of, sun_of
from skydome.land.terrain_picture import TerrainPicture
from skydome.land.texture import surface_of
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.sky import Sky

REFRACTION = 7 / 6
"""By how much refraction flattens the Earth for a ray near the ground."""

MOST_LIT, MOST_SAMPLES = 100_000, 4096
"""Vertices whose skylight is computed; between them it is interpolated."""

ROWS_AT_A_TIME = 64
VERTICES_PER_PIECE = 1 << 10

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
    clouds: CloudField | None = None,
) -> TerrainPicture:
    """The view of a camera on the land under a sky (with the sun's disc added) through `air`; None is a vacuum.

    `albedo`: RGB (3,), or an image (h, w, 3) in linear sRGB stretched over the map. `samples` a pixel: a square
    number. `curvature`: lower the land, and the ground beyond it, by the Earth's curve, less refraction.
    `progress(done, rows)` is called as rows are finished. Beyond the map lies ground of the mean albedo at its lowest
    height, from which `air` measures heights. `clouds` stand between sun and land, their heights above the ground under
    the camera: `sky` is then their `CloudySky` with the disc of the clear sky, which they dim place by place. Needs
    Numba.

    >>> import skydome as sd
    >>> hill, sky = sd.Elevation(np.eye(9), dx=30.0, dy=30.0), sd.Preetham(sd.direction(2.0, 0.7), turbidity=3.0)
    >>> render_terrain(hill, sd.Camera(width=8, height=6), sky, samples=1).rgb.shape
    (6, 8, 3)
    """
    required("numba", "terrain", "a terrain picture")
    from skydome.land.picture_kernel import picture_rows
    from skydome.land.rays_kernel import height_at

    require_scene(elevation, camera, sky, air, clouds)
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
    disc, rest = sun_of(sky), skylight_of(sky)
    shade = shade_of(clouds, disc[0], z - camera.above_ground)
    sunlight = (*disc, shade)
    lit = lit_slopes(ground, rest, sunlight, surface[3])
    background, view = background_of(sky, camera, float(shade.share[0, 0])), view_of(camera, u, v, z)
    height, width = camera.shape
    rgb, depth = np.zeros((height, width, 3), np.float32), np.zeros((height, width))
    given = (ground, view, samples, seed, background, sunlight, lit, surface, air_for(air, z - base), rgb, depth)
    for first in range(0, height, ROWS_AT_A_TIME):
        last = min(first + ROWS_AT_A_TIME, height)
        shared(lambda a, b, start=first: picture_rows(start + a, start + b, *given), last - first, last - first, (), 1)
        if progress is not None:
            progress(last, height)
    return TerrainPicture(rgb, depth.astype(np.float32))


def require_scene(elevation: Any, camera: Any, sky: Any, air: Any, clouds: Any) -> None:
    """TypeError for what is no land, camera, sky, air or field of cloud."""
    require_kind(elevation, Elevation, "elevation", "Elevation(heights, dx=30.0, dy=30.0) or read_elevation(file)")
    require_kind(camera, Camera, "camera", "Camera(azimuth=270 * deg)")
    require_kind(sky, Sky, "sky", "HosekWilkie(sun, turbidity=3.0)")
    require_kind(air, AirLight | WardLarson | None, "air", "AirLight(sky)")
    require_kind(clouds, CloudField | None, "clouds", "CloudField(cover=0.4)")


def view_of(camera: Camera, u: float, v: float, z: float) -> tuple[Any, ...]:
    """What the kernel needs of a camera at cells (u, v) and height z."""
    height, width = camera.shape
    right, up, forward = camera.axes
    half = camera.pixel / 2
    return u, v, float(z), forward, right * (half * width), up * (half * height), width, height


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


def lit_slopes(ground: Any, rest: Any, sunlight: Any, albedo: np.ndarray) -> tuple[np.ndarray, int, np.ndarray]:
    """How skylight on the vertices depends on the normal (see `skylight`), their stride, and what is bounced (3,)."""
    from skydome.land.rays_kernel import skylight

    heights, _, _, dx, dy, _ = ground
    azimuths, elevations, weights, light = rest
    level = np.einsum("m,kmc->c", weights * np.sin(elevations), light)
    bounce = albedo * (level + sunlight[3] * (max(sunlight[0][2], 0.0) * sunlight[4].share.mean()))
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
