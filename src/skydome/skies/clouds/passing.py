"""What a layer of cloud alone, with no air about it, makes of light from any height, as at night."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from skydome.air.clouds.cloud import Cloud
from skydome.air.clouds.particles import CloudParticles
from skydome.ground.quadrature import gauss_legendre
from skydome.light.spectrum import interpolated
from skydome.skies.clouds.doubling import NODES, Cosines

SOURCES = np.sin(np.radians(np.linspace(0.0, 90.0, 19)))
"""Sines of the elevations from which light is known to pass."""
PLACES = np.linspace(0.0, np.pi / 2, 41)
VIEWS = np.sin(PLACES) ** 2
"""Sines of the elevations toward which it is known, dense at horizon and zenith: light is straight in `place_of`."""


def place_of(sines: np.ndarray) -> np.ndarray:
    """What light is straight in, (...,), from sines of elevation (...,)."""
    return np.asarray(np.arcsin(np.sqrt(np.clip(sines, 0.0, 1.0))))


def at_views(places: np.ndarray) -> np.ndarray:
    """Weights of `VIEWS` for light toward places (N,), (N, V)."""
    return np.asarray(interpolated(places, PLACES, np.eye(PLACES.size)).T)


def shares_of_heights(sines: np.ndarray) -> np.ndarray:
    """How light from sines (N,) is shared among `SOURCES`, (N, S).

    >>> shares_of_heights(np.sin(np.radians([4.0])))[0, :4].round(3).tolist()
    [0.2, 0.8, 0.0, 0.0]
    """
    elevation = np.arcsin(np.clip(sines, 0.0, 1.0))
    return np.asarray(interpolated(elevation, np.arcsin(SOURCES), np.eye(SOURCES.size)).T)


def level_areas() -> np.ndarray:
    """Irradiance on the level of radiance 1 toward each of `VIEWS`, as it is between them, (V,); pi in all."""
    t, weights = gauss_legendre(4)
    places = (np.arange(PLACES.size - 1)[:, None] + t) * PLACES[1]
    each = 4 * np.pi * PLACES[1] * weights * np.sin(places) ** 3 * np.cos(places)
    return np.asarray(each.ravel() @ at_views(places.ravel()))


AREAS = level_areas()


@dataclass(frozen=True, eq=False)
class PassingLight:
    """`table` (S, V, W): radiance toward `VIEWS`, all azimuths alike, of light from `SOURCES`, sr-1.

    The light has irradiance 1 on a plane that faces it; nothing comes from below.
    """

    table: np.ndarray
    up: np.ndarray
    """Share of light from `SOURCES` that is sent back up, (S, W)."""
    even: np.ndarray
    """Radiance toward `VIEWS` of even light from above of irradiance 1, ..."""
    below: np.ndarray
    """... and of even light from below, sr-1, (V, W)."""
    through: np.ndarray
    """Share of even light that goes through, ..."""
    back: np.ndarray
    """... and that is sent back, (W,)."""

    def radiance(self, coming: np.ndarray) -> np.ndarray:
        """Radiance toward `VIEWS` (V, W) of light `coming` (S, W) from `SOURCES`, in its units over sr."""
        return np.asarray(np.einsum("svw,sw->vw", self.table, coming))


@lru_cache(maxsize=8)
def passing(depth: float, kind: CloudParticles, radius: float, wavelengths: tuple[float, ...]) -> PassingLight:
    """Of a layer of a `depth`, of particles of an effective `radius`, m, at (W,) nm.

    What goes straight on, mostly in the forward peak, is spread between the two views about its own, so that no glow
    falls between the directions.
    """
    cosines = Cosines.seen(VIEWS, SOURCES)
    layer = cosines.of(Cloud(depth, effective_radius=radius, kind=kind), np.array(wavelengths))
    views, sources = slice(NODES, NODES + VIEWS.size), slice(NODES + VIEWS.size, None)
    falls, back = cosines.shares(layer.through) + layer.straight, cosines.shares(layer.sent_back)
    scattered = SOURCES[:, None, None] * layer.through[:, views, sources].transpose(2, 1, 0) / np.pi
    straight = (SOURCES[:, None] * layer.straight[:, sources].T)[:, None]
    return PassingLight(
        scattered + straight * (at_views(place_of(SOURCES)) / AREAS)[..., None],
        back[:, sources].T,
        falls[:, views].T / np.pi,
        back[:, views].T / np.pi,
        cosines.even(falls),
        cosines.even(back),
    )
