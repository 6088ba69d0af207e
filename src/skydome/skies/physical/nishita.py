"""Nishita's skies: light scattered once (1993) or once and twice (1996) in spherical shells of air.

deviation from the papers | here | why
two constituents, molecules and aerosol | any `Atmosphere` | ozone and absorbing aerosol come for free
trapezoid steps in shells (1993) | Gauss nodes that crowd at the eye | 32 nodes give 1e-4 by day
8 directions about the sun for the second order (1996) | `rings` x 2 `rings` directions of the sphere | 8 leave 5-10 %
volume of voxels in the sun's frame (1996) | a column of heights at the observer | the day's sky is alike in all places
ground not named | sunlight that the ground reflects is scattered once more (1996's order two) | albedo is in the air
"""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from skydome.air.rays import NODES, ColumnTable, Rays, rays
from skydome.ground.arrays import Array
from skydome.ground.directions import checked_directions
from skydome.ground.interpolation import weights
from skydome.ground.limits.ranges import Range
from skydome.ground.quadrature import gauss_legendre
from skydome.light.spectrum import checked_wavelengths
from skydome.skies.physical.atmosphere_sky import AtmosphereSky
from skydome.skies.physical.cosine_series import cosine_transform, geometry, interpolated, view_nodes
from skydome.skies.physical.discrete_ordinates import across
from skydome.sun.day import is_day

CHUNK = 2048
TWILIGHT_NODES = 128
"""Samples of a ray under a sun that has set, as the earth's shadow ends between two of them: within 0.4 % of 6,000
steps at -4 degrees, where 32 leave 6 %.
"""
RAYS = 512
"""Rays that are followed at a time: what is held of them stays in the processor's cache."""
HEIGHTS = np.array([0, 0.003, 0.01, 0.02, 0.035, 0.06, 0.1, 0.16, 0.25, 0.4, 0.65, 1.0])
"""Heights, as parts of the whole, at which the light for the second scattering is known."""


@dataclass(frozen=True, eq=False)
class Nishita93(AtmosphereSky):
    """The sky of light scattered once in the spherical shells of an `atmosphere`, seen from the ground.

    Known errors: too dark by a fifth (red) to a half (blue) and more over bright ground, near the horizon too blue:
    what is scattered more than once is missing. The sun may stand below the horizon.

    >>> import skydome as sd
    >>> sky = Nishita93(sd.direction(azimuth=180 * sd.deg, elevation=45 * sd.deg))
    >>> sky.radiance(sd.ZENITH, [450.0, 650.0]).round(3).tolist()
    [0.041, 0.015]
    """

    lowest_sun: ClassVar[float] = -12.0
    source: ClassVar[str] = "Nishita, Sirai, Tadamura, Nakamae 1993, eq. 4-9"
    quick_to_see: ClassVar[bool] = False

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction (..., 3), W m-2 sr-1 nm-1, shape (..., W); 0 below the horizon."""
        directions = checked_directions(np.asarray(directions, dtype=np.float64))
        suns, w = np.asarray(self.sun, dtype=np.float64), checked_wavelengths(wavelengths)
        self.tell_missing_bands(wavelengths)
        shape = np.broadcast_shapes(directions.shape, suns.shape)[:-1]
        light, table = np.zeros((*shape, w.size)), ColumnTable.of(self.atmosphere)
        for index in np.ndindex(suns.shape[:-1]):
            place = across(index, suns.shape[:-1], shape)
            views = np.broadcast_to(directions, (*shape, 3))[place]
            flat = views.reshape(-1, 3)
            up = flat[:, 2] >= 0
            found = np.zeros((len(flat), w.size))
            found[up] = self.under_one_sun(table, suns[index], flat[up], w)
            light[place] = found.reshape(*views.shape[:-1], w.size)
        return np.asarray(self.blanked(light, directions)) * self.sunlight(directions, w)

    def under_one_sun(self, table: ColumnTable, sun: np.ndarray, views: np.ndarray, wavelengths: np.ndarray) -> Array:
        """Light scattered once, for a sun of irradiance 1, sr-1, shape (D, W)."""
        start = np.full(len(views), self.atmosphere.radius)
        return scattered_once(table, start, views, sun, wavelengths)


@dataclass(frozen=True, eq=False)
class Nishita96(Nishita93):
    """The sky of light scattered once and twice, with the ground's reflection; `rings` sets the second's quadrature.

    Known errors: third and higher orders are missing, 3 % (red) to 20 % (blue) in clear air; for a sun below the
    horizon the second order takes the sun's height as the observer's everywhere.

    >>> import skydome as sd
    >>> sun = sd.direction(180 * sd.deg, 40 * sd.deg)
    >>> once, twice = Nishita93(sun).radiance(sd.ZENITH, [450.0]), Nishita96(sun).radiance(sd.ZENITH, [450.0])
    >>> bool(twice > once)
    True
    """

    rings: int = 8
    bounds: ClassVar = {"rings": Range(2, 64)}
    source: ClassVar[str] = "Nishita, Dobashi, Kaneda, Yamashita 1996, section 4"

    def under_one_sun(self, table: ColumnTable, sun: np.ndarray, views: np.ndarray, wavelengths: np.ndarray) -> Array:
        """Light scattered once and twice, for a sun of irradiance 1, sr-1, shape (D, W)."""
        once = super().under_one_sun(table, sun, views, wavelengths)
        terms = 12
        series = second_order_series(table, sun, wavelengths, self.rings, terms)
        for start in range(0, len(views), CHUNK):
            part = slice(start, start + CHUNK)
            cosine, relative, _ = geometry(views[part], sun)
            once[part] += interpolated(series, cosine, relative)
        return np.maximum(once, 0.0)


def scattered_once(
    table: ColumnTable, radius: np.ndarray, views: np.ndarray, sun: np.ndarray, wavelengths: np.ndarray
) -> Array:
    """Light scattered once toward observers at radii (N,) above the origin along views (N, 3), sr-1, shape (N, W)."""
    parts = table.air.constituents
    depths = np.stack([part.depth(wavelengths) for part in parts])
    light = np.zeros((len(views), wavelengths.size))
    for start in range(0, len(views), RAYS):
        some = slice(start, start + RAYS)
        cosine = np.clip(views[some] @ sun, -1.0, 1.0)
        path = rays(table.air, radius[some], views[some, 2], NODES if sun[2] >= 0 else TWILIGHT_NODES)
        reach = lit_columns(table, path, radius[some], sun[2], cosine, depths)
        for k, part in enumerate(parts):
            scattering = depths[k] * part.scattered(wavelengths)
            if scattering.any():
                light[some] += part.phase_law.value(cosine, wavelengths) * scattering * reach[:, k]
    return light


def lit_columns(
    table: ColumnTable,
    path: Rays,
    radius: np.ndarray,
    cos_sun: float | np.ndarray,
    cosine: np.ndarray,
    depths: np.ndarray,
) -> Array:
    """Column of each constituent on rays, each sample dimmed from the sun and to the eye, (N, K, W) (1993, eq. 4, 5).

    `depths` (K, W): vertical optical depths; `cos_sun` where rays start, a number or (N, 1); `cosine` (N,): of the
    angle between ray and sun.
    """
    local = (radius[:, None] * cos_sun + path.distance * cosine[:, None]) / (table.air.radius + path.height)
    column, blocked = table.look_up(path.height, np.clip(local, -1.0, 1.0))
    lit = np.moveaxis(column + path.column, 0, -1) @ -depths
    np.exp(lit, out=lit)
    pieces = np.where(blocked, 0.0, path.density * path.step)
    return np.asarray(np.moveaxis(pieces, 0, 1) @ lit)


def second_order_series(table: ColumnTable, sun: np.ndarray, wavelengths: np.ndarray, rings: int, terms: int) -> Array:
    """Light scattered twice, toward even view angles, as a cosine series in azimuth, (nodes, terms + 1, W)."""
    plane = np.array([np.hypot(sun[0], sun[1]), 0.0, sun[2]])
    cosines, azimuths = view_nodes(terms), np.linspace(0, np.pi, terms + 1)
    mu, relative = (v.ravel() for v in np.meshgrid(cosines, azimuths, indexing="ij"))
    sine = np.sqrt(1 - mu**2)
    views = np.stack([sine * np.cos(relative), sine * np.sin(relative), mu], axis=-1)
    light = scattered_twice(table, views, plane, wavelengths, rings)
    return np.einsum("mp,npw->nmw", cosine_transform(terms), light.reshape(len(cosines), terms + 1, -1))


def scattered_twice(
    table: ColumnTable, views: np.ndarray, sun: np.ndarray, wavelengths: np.ndarray, rings: int
) -> Array:
    """Light that reaches the ground's observer along views (D, 3) after two scatterings, sr-1, shape (D, W)."""
    air, (around, solid_angle) = table.air, sphere(rings)
    heights = HEIGHTS * air.height
    before = first_light(table, heights, around, sun, wavelengths) * solid_angle[:, None]  # (H, I, W)
    path = rays(air, np.full(len(views), air.radius), views[:, 2])
    depths = np.stack([part.depth(wavelengths) for part in air.constituents])
    through = np.exp(-np.einsum("kns,kw->nsw", path.column, depths)) * path.step[:, :, None]
    hats = weights(heights, path.height)
    total = np.zeros((len(views), wavelengths.size))
    angle = np.clip(views @ around.T, -1.0, 1.0)
    for part, density, depth in zip(air.constituents, path.density, depths, strict=True):
        scattering = depth * part.scattered(wavelengths)
        if scattering.any():
            phase = part.phase_law.value(angle, wavelengths)
            turned = np.einsum("diw,hiw->dhw", phase, before, optimize=True)
            reach = np.einsum("ns,nsh,nsw->nhw", density, hats, through, optimize=True)
            total += scattering * np.einsum("dhw,dhw->dw", turned, reach)
    return total


def first_light(
    table: ColumnTable, heights: np.ndarray, around: np.ndarray, sun: np.ndarray, wavelengths: np.ndarray
) -> Array:
    """Light from all around at heights (H,): scattered once, and the sunlit ground through air, sr-1, (H, I, W)."""
    air = table.air
    radius = np.repeat(air.radius + np.maximum(heights, 0.1), len(around))
    views = np.tile(around, (len(heights), 1))
    light = scattered_once(table, radius, views, sun, wavelengths)
    if is_day(sun):
        path = rays(air, radius, views[:, 2])
        depths = np.stack([part.depth(wavelengths) for part in air.constituents])
        down, _ = table.look_up(np.zeros(1), np.array([sun[2]]))
        lit = sun[2] / np.pi * air.albedo_at(wavelengths) * np.exp(-down[:, 0] @ depths)
        light += np.where(path.grounded[:, None], lit * np.exp(-path.total.T @ depths), 0.0)
    return light.reshape(len(heights), len(around), -1)


def sphere(rings: int) -> tuple[np.ndarray, np.ndarray]:
    """Directions (I, 3) of the whole sphere, Gauss in the angle above and below the horizon, and solid angles (I,)."""
    t, w = gauss_legendre(rings)
    angle = np.concatenate([t, 1 + t]) * np.pi / 2
    weight = np.concatenate([w, w]) * np.pi / 2 * np.sin(angle)
    azimuth = (np.arange(2 * rings) + 0.5) * np.pi / rings
    polar, turn = (v.ravel() for v in np.meshgrid(angle, azimuth, indexing="ij"))
    directions = np.stack([np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn), np.cos(polar)], axis=-1)
    return directions, np.repeat(weight * np.pi / rings, 2 * rings)
