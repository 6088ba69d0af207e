"""Light that glows all over the sky, as air scatters it: the physical sky under a sun in every direction it comes from.

Scattering is linear: what comes from a view is the sum, over the directions that light comes from, of what the physical
sky has there under a sun in each, for as much light. No share, no fit: near the horizon, where little is left of the
straight light, this is what is seen.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.directions import azimuth, direction
from skydome.ground.quadrature import crowded
from skydome.skies.all_air.sky import PhysicalSky

RINGS, TURNS = 12, 32
"""Elevations, crowded at the horizon, and azimuths of sources: twice as many change airglow by .3, starlight by 1 %."""

VIEWS = np.linspace(0.0, 1.0, 28) ** 2
"""Sines of elevations at which the light is known."""

WAVELENGTHS = np.array([340.0, 380.0, 420.0, 460.0, 500.0, 550.0, 600.0, 650.0, 700.0, 745.0])
"""Wavelengths at which it is known, nm; the ends are held."""


@dataclass(frozen=True, eq=False)
class GlowScattering:
    """`harmonics` (V, S, A, W): along azimuth, of the light toward a view for that of 1 from each of the sources."""

    harmonics: np.ndarray

    @classmethod
    def of(cls, air: Atmosphere) -> "GlowScattering":
        """That of an air over its ground, whatever its sunlight is."""
        plain = replace(air, sun_scale=1.0, sunlight=None)
        try:
            return known(plain)
        except TypeError:  # it holds arrays, such as an albedo by wavelength
            return known.__wrapped__(plain)

    def field(self, outside: Callable[[np.ndarray], np.ndarray]) -> np.ndarray:
        """Light scattered toward `VIEWS` and azimuths (V, A, W), of a glow `outside` by directions (..., 3)."""
        rings, _ = sources()
        light = outside(np.asarray(direction(turns()[None, :], np.arcsin(rings)[:, None])))
        found = np.einsum("vsaw,sa->vaw", self.harmonics, np.fft.rfft(light, axis=1))
        return np.fft.irfft(found, TURNS, axis=1)


@lru_cache(maxsize=8)
def known(air: Atmosphere) -> GlowScattering:
    """Made once for an air."""
    rings, weights = sources()
    half = TURNS // 2 + 1
    suns = np.asarray(direction(turns()[None, :half], np.arcsin(rings)[:, None]))
    views = np.asarray(direction(0.0, np.arcsin(VIEWS)))
    sky = PhysicalSky(suns[:, :, None, :], air).without_refusal("clamp")  # taught at 380-780 nm, held at the ends
    light = np.asarray(sky.radiance(views, WAVELENGTHS))
    light = light / np.asarray(air.sun_at(WAVELENGTHS)) * weights[:, None, None, None]
    whole = np.concatenate([light, light[:, half - 2 : 0 : -1]], axis=1)  # the other side is its mirror image
    return GlowScattering(np.fft.rfft(whole.transpose(2, 0, 1, 3), axis=2).real)


def sources() -> tuple[np.ndarray, np.ndarray]:
    """Sines of the elevations (S,), and the solid angle of a source in each, sr, (S,)."""
    sines, weights = crowded(RINGS)
    return sines, weights * 2 * np.pi / TURNS


def turns() -> np.ndarray:
    """Azimuths, (A,)."""
    return np.arange(TURNS) * 2 * np.pi / TURNS


def at_bands(field: np.ndarray, bands: np.ndarray) -> np.ndarray:
    """A field (..., W) at other wavelengths (B,), (..., B)."""
    place = np.clip(np.searchsorted(WAVELENGTHS, bands) - 1, 0, WAVELENGTHS.size - 2)
    share = np.clip((bands - WAVELENGTHS[place]) / np.diff(WAVELENGTHS)[place], 0.0, 1.0)
    return np.asarray(field[..., place] * (1 - share) + field[..., place + 1] * share)


def toward(field: np.ndarray, views: np.ndarray) -> np.ndarray:
    """A field (V, A, C) toward views (..., 3), linear between, (..., C)."""
    row = np.sqrt(np.clip(views[..., 2], 0.0, 1.0)) * (VIEWS.size - 1)
    column = np.asarray(azimuth(views)) / (2 * np.pi) * TURNS
    i, j = np.minimum(row.astype(np.int64), VIEWS.size - 2), column.astype(np.int64)
    a, b, j, k = (row - i)[..., None], (column - j)[..., None], j % TURNS, (j + 1) % TURNS
    lower = field[i, j] * (1 - b) + field[i, k] * b
    upper = field[i + 1, j] * (1 - b) + field[i + 1, k] * b
    return np.asarray(lower * (1 - a) + upper * a)
