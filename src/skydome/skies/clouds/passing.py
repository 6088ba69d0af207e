"""What the overcast sky's layer alone, with no air about it, makes of light from any height, as at night."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from skydome.air.clouds.particles import CloudParticles
from skydome.air.clouds.phases import OneLobe
from skydome.air.constituents import Molecules, Ozone
from skydome.ground.directions import direction
from skydome.light.spectrum import Spectrum, interpolated
from skydome.skies.clouds.layer_optics import layer_optics
from skydome.skies.clouds.overcast import OvercastSky
from skydome.skies.clouds.two_streams import mirrored

SOURCES = np.sin(np.radians(np.linspace(0.0, 90.0, 19)))
"""Sines of the elevations from which light is known to pass."""
VIEWS = np.linspace(0.0, 1.0, 31) ** 2
"""Sines of the elevations toward which it is known, dense at the horizon."""
AZIMUTHS = np.radians(np.arange(7.5, 180.0, 15.0))


@dataclass(frozen=True, eq=False)
class PassingLight:
    """`table` (S, V, W): radiance toward `VIEWS`, all azimuths alike, of light from `SOURCES`, sr-1.

    The light has irradiance 1 on a plane that faces it; what goes to and fro between cloud and ground is counted.
    """

    table: np.ndarray
    mirrored: np.ndarray
    """Share of light from above that the layer sends back, (W,)."""

    def radiance(self, coming: np.ndarray) -> np.ndarray:
        """Radiance toward `VIEWS` (V, W) of light `coming` (S, W) from `SOURCES`, in its units over sr."""
        return np.asarray(np.einsum("svw,sw->vw", self.table, coming))


def shares_of_heights(sines: np.ndarray) -> np.ndarray:
    """How light from sines (N,) is shared among `SOURCES`, (N, S).

    >>> shares_of_heights(np.sin(np.radians([4.0])))[0, :4].round(3).tolist()
    [0.2, 0.8, 0.0, 0.0]
    """
    elevation = np.arcsin(np.clip(sines, 0.0, 1.0))
    return np.asarray(interpolated(elevation, np.arcsin(SOURCES), np.eye(SOURCES.size)).T)


@lru_cache(maxsize=8)
def passing(
    depth: float, kind: CloudParticles, radius: float, ground: tuple[float, ...], wavelengths: tuple[float, ...]
) -> PassingLight:
    """Of a layer of a `depth`, of particles of an effective `radius`, over a ground of albedo (W,), at (W,) nm.

    What the cloud scatters once goes into one lobe of its asymmetry, so that no glow falls between the directions.
    """
    w = np.array(wavelengths)
    views = direction(AZIMUTHS, np.arcsin(VIEWS)[:, None])
    suns = direction(0.0, np.arcsin(SOURCES))[:, None, None]
    sky = OvercastSky(suns, depth, effective_radius=radius, kind=kind)
    numbers = layer_optics(Molecules(pressure=0.0), Ozone(column=0.0), sky.cloud, np.array(ground), w)
    lobe = OneLobe(Spectrum(w, np.asarray(numbers.asymmetry)))
    return PassingLight(
        np.asarray(sky.light(suns, views, numbers, w, lobe)).mean(axis=2), np.asarray(mirrored(numbers))
    )
