"""Skies of one kind of air under many suns: what whole sky models are fitted to, from any sky or a simulated store."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from skydome.air.cross_sections import solar_irradiance
from skydome.ground.directions import direction
from skydome.ground.extras import required
from skydome.ground.units import deg
from skydome.light.spectrum import checked_wavelengths
from skydome.own_air.refit import Views
from skydome.skies.colour_sky import SpectralSky

SUNS = np.array([5, 6.5, 9, 12, 16, 22, 29, 37, 46, 56, 67, 78, 90.0]) * deg
LOWEST_SUN = 5 * deg
STORED = ("turbidities", "albedos", "elevations", "zenith_angles", "azimuths", "wavelengths", "radiance")


@dataclass(frozen=True, eq=False)
class SkyFamily:
    """Radiance (T, A, E, D, W), W m-2 sr-1 nm-1, by turbidity, albedo, sun elevation, view and wavelength.

    `views` (D): the sun stands over the south (azimuth 180 degrees), `elevations` (E,) are radians.
    """

    turbidities: np.ndarray
    albedos: np.ndarray
    elevations: np.ndarray
    wavelengths: np.ndarray
    views: Views
    radiance: np.ndarray

    @classmethod
    def of(
        cls,
        sky: Callable[[np.ndarray, float, float], SpectralSky],
        turbidities: Any,
        albedos: Any = (0.0, 1.0),
        wavelengths: Any = (400.0, 550.0, 700.0),
        elevations: Any = SUNS,
        progress: Callable[[int, int], None] | None = None,
    ) -> "SkyFamily":
        """The skies that `sky(sun, turbidity, albedo)` gives, on 120 views above 2 degrees.

        `progress(done, of)` is called after each turbidity and albedo.
        """
        t, a, e = (np.atleast_1d(np.asarray(x, dtype=np.float64)) for x in (turbidities, albedos, elevations))
        w, views = checked_wavelengths(wavelengths), Views.half(12, 10)
        light = np.empty((t.size, a.size, e.size, len(views.directions), w.size))
        for done, (i, j) in enumerate(np.ndindex(t.size, a.size)):
            for k, height in enumerate(e):
                made = sky(np.asarray(direction(np.pi, height)), float(t[i]), float(a[j]))
                light[i, j, k] = made.radiance(views.directions, w)
            if progress is not None:
                progress(done + 1, t.size * a.size)
        return cls(t, a, e, w, views, light)

    @classmethod
    def from_store(cls, path: str | PathLike[str], lowest: float = LOWEST_SUN) -> "SkyFamily":
        """The skies in a store of `skydome simulate`, of suns at `lowest`, radians, or more.

        ValueError for what is no such store, and where it is not finished.
        """
        zarr = required("zarr", "scale", "a store of simulated skies")
        if not Path(path).is_dir():
            raise FileNotFoundError(f"the store of simulated skies must be a folder, got {path}")
        try:
            group: Any = zarr.open_group(path, mode="r")
            held = {name: np.asarray(group[name][...]) for name in STORED}
        except (KeyError, ValueError, FileNotFoundError) as error:
            raise ValueError(f"{path} is no store of simulated skies: {error}") from error
        open_pieces = int(np.isnan(held["radiance"]).any(axis=(2, 3, 4, 5)).sum())
        if open_pieces:
            raise ValueError(f"{path} lacks {open_pieces} pieces: run `skydome simulate` again to finish it")
        high = held["elevations"] * deg >= lowest - 1e-9
        if high.sum() < 6:
            raise ValueError(f"six suns at {lowest / deg:g} degrees or more are needed, got {high.sum()} in {path}")
        light = held["radiance"][:, :, high] * solar_irradiance(held["wavelengths"])
        parts = (held["turbidities"], held["albedos"], held["elevations"][high] * deg, held["wavelengths"])
        views = stored_views(held["zenith_angles"] * deg, held["azimuths"] * deg)
        return cls(*parts, views, light.reshape(*light.shape[:3], -1, light.shape[-1]).astype(np.float64))

    def thinned(self, suns: slice = slice(None), turbidities: slice = slice(None)) -> "SkyFamily":
        """Some of the suns and turbidities, for trying a fit on the others."""
        return replace(
            self,
            turbidities=self.turbidities[turbidities],
            elevations=self.elevations[suns],
            radiance=self.radiance[turbidities][:, :, suns],
        )


def stored_views(zenith: np.ndarray, azimuth: np.ndarray) -> Views:
    """A store's views, zenith angles x azimuths from its sun, with the sun turned to the south, and solid angles."""
    across = np.outer(cell_widths(zenith) * np.sin(zenith), cell_widths(azimuth))
    polar, turn = (x.ravel() for x in np.meshgrid(zenith, azimuth, indexing="ij"))
    return Views(np.asarray(direction(np.pi + turn, np.pi / 2 - polar)), across.ravel())


def cell_widths(nodes: np.ndarray) -> np.ndarray:
    """What each of rising nodes stands for: half of the ways to its neighbours, (N,); 1 for a single one."""
    if nodes.size == 1:
        return np.ones(1)
    steps = np.diff(nodes)
    widths: np.ndarray = (np.append(steps, 0) + np.append(0, steps)) / 2
    return widths
