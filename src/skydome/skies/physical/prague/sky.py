"""The Prague sky: radiance, transmittance and polarisation from a file of the user's (Wilkie et al. 2021).

deviation from the authors' program (2022) | here | why
light from every direction | black under the geometric horizon | a sky is what lies above it
a sun lower than the file's lowest counts as that | black, as every sky of the night is | else twilight never ends
a wavelength outside the file gives 0 | ValueError | no silent darkness
"""

from dataclasses import dataclass
from itertools import product
from os import PathLike
from typing import Any, ClassVar, NamedTuple

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array, as_numpy, floating
from skydome.ground.directions import checked_directions
from skydome.ground.limits.ranges import SHARE, Range
from skydome.light.spectrum import checked_wavelengths, xyz_weights
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.physical.discrete_ordinates import across
from skydome.skies.physical.prague.file import Curves, PragueFile, read_prague
from skydome.skies.physical.prague.geometry import SAFETY, Angles, Place, angles_of, dip
from skydome.skies.physical.prague.transmittance import transmittance_of
from skydome.skies.sky import SunlitSky
from skydome.sun.day import is_day

AT_ONCE = 1 << 14
"""Directions computed together."""


class Numbers(NamedTuple):
    """The parameters of one sky: its sun (3,), visibility, m, albedo, altitude, m."""

    sun: np.ndarray
    visibility: float
    albedo: float
    altitude: float


@dataclass(frozen=True, eq=False)
class Prague(SunlitSky, SpectralSky):
    """The sky of a Prague file: clear air of a `visibility`, m, over a ground of `albedo`, seen from `altitude`, m.

    `data`: a file that the authors publish, by its path (www.cgg.mff.cuni.cz, "A fitted radiance and attenuation model
    for realistic atmospheres" and "A wide spectral range sky radiance model"), or a `PragueFile`. Any part of the data
    set will do; ValueError outside what the file holds. Suns down to the file's lowest, -4.2 degrees; light in bands,
    within which it does not change. Computed in NumPy, suns one by one.

    >>> import skydome as sd
    >>> sd.Prague(sd.direction(azimuth=2.0, elevation=0.5), "none.dat")
    Traceback (most recent call last):
    FileNotFoundError: a Prague file must be a file that exists, got none.dat
    """

    data: PragueFile | str | PathLike[str]
    visibility: Any = 60_000.0
    albedo: Any = None
    altitude: Any = 0.0
    bounds: ClassVar = {"visibility": Range(1.0, 1e7, "m"), "albedo": SHARE, "altitude": Range(-500.0, 1e5, "m")}
    lowest_sun: ClassVar[float] = -4.2
    source: ClassVar[str] = "Wilkie et al. 2021; Vevoda et al. 2022"

    def __post_init__(self) -> None:
        """The file's only albedo where none is given; then validate."""
        require_kind(self.data, PragueFile | str | PathLike, "data", "'SkyModelDatasetGround.dat'")
        if self.albedo is None:
            object.__setattr__(self, "albedo", float(self.held.albedos[np.abs(self.held.albedos - 0.2).argmin()]))
        super().__post_init__()

    @property
    def lowest(self) -> float:
        """Elevation of the file's lowest sun, degrees."""
        return float(self.held.elevations[0])

    @property
    def is_day(self) -> Array:
        """True where the sun stands above the file's lowest, boolean array (...,)."""
        return is_day(floating(self.sun), self.lowest)

    @property
    def held(self) -> PragueFile:
        """What the file holds."""
        return self.data if isinstance(self.data, PragueFile) else read_prague(str(self.data))

    @property
    def limits(self) -> dict[str, Range]:
        """What the file holds of each parameter; the least altitude is the ground, 0."""
        held = self.held
        return {
            "visibility": Range(float(held.visibilities[0]), float(held.visibilities[-1]), "m"),
            "albedo": Range(float(held.albedos[0]), float(held.albedos[-1])),
            "altitude": Range(0.0, max(0.0, float(held.altitudes[-1])), "m"),
        }

    def parameters(self) -> dict[str, Any]:
        """Parameters for provenance: the file by its name."""
        return super().parameters() | {"data": self.held.path}

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction (..., 3), W m-2 sr-1 nm-1, shape (..., W): that of the band."""
        return self.at(directions, wavelengths, self.held.radiance)

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction (..., 3), Y in cd m-2, shape (..., 3): each band even over its width."""
        held = self.held
        low, high = held.bands[0] - held.band_width / 2, held.bands[-1] + held.band_width / 2
        fine = np.arange(max(low, 360.0), min(high, 830.0) + 0.5)
        band = np.minimum(((fine - low) / held.band_width).astype(int), held.bands.size - 1)
        seen, which = np.unique(band, return_inverse=True)
        weights = np.zeros((seen.size, 3))
        np.add.at(weights, which, xyz_weights(fine))
        return self.in_bands(directions, held.radiance, seen) @ weights

    def polarisation(self, directions: Array, wavelengths: Any) -> Array:
        """Degree of linear polarisation toward each direction, -1 ... 1, shape (..., W).

        Positive across the plane through sun and view. ValueError for a file without it.
        """
        if self.held.polarisation is None:
            raise ValueError(f"{self.held.path} has no polarisation: {self.held.missing}")
        return -self.at(directions, wavelengths, self.held.polarisation)

    def transmittance(self, directions: Array, wavelengths: Any, distance: Any = np.inf) -> Array:
        """What the air lets through from `distance` m away (...,) toward directions (..., 3), shape (..., W), 0-1.

        Farther than the ground or the end of the air counts as that far. ValueError for a file without it.
        """
        passage = self.held.transmittance
        if passage is None:
            raise ValueError(f"{self.held.path} has no transmittance: {self.held.missing}")
        views = checked_directions(as_numpy(directions))
        far = np.broadcast_to(np.asarray(distance, dtype=np.float64), views.shape[:-1])
        if not (far >= 0).all():
            raise ValueError(f"distance must be 0 m or more, got {np.min(far):g}")
        altitude, visibility = (float(as_numpy(value)) for value in (self.altitude, self.visibility))
        found = transmittance_of(passage, views[..., 2].ravel(), far.ravel(), altitude, visibility)
        return found.reshape(*views.shape[:-1], found.shape[-1])[..., self.bands_of(wavelengths)]

    def bands_of(self, wavelengths: Any) -> np.ndarray:
        """The bands in which wavelengths (W,) lie; ValueError outside the file's."""
        w, held = checked_wavelengths(wavelengths), self.held
        low = held.bands[0] - held.band_width / 2
        high = held.bands[-1] + held.band_width / 2
        if w[0] < low or w[-1] >= high:
            raise ValueError(f"wavelengths must lie in [{low:g}, {high:g}) nm, got {w[0]:g} to {w[-1]:g}")
        bands: np.ndarray = ((w - low) / held.band_width).astype(int)
        return bands

    def at(self, directions: Array, wavelengths: Any, curves: Curves) -> np.ndarray:
        """What the curves say toward directions (..., 3) at wavelengths (W,), (..., W)."""
        bands, which = np.unique(self.bands_of(wavelengths), return_inverse=True)
        return self.in_bands(directions, curves, bands)[..., which]

    def in_bands(self, directions: Array, curves: Curves, bands: np.ndarray) -> np.ndarray:
        """What the curves say toward directions (..., 3) in bands (B,), (..., B); 0 where the sky is not seen."""
        views = checked_directions(as_numpy(directions).astype(np.float64))
        suns = np.asarray(as_numpy(self.sun), dtype=np.float64)
        numbers = [np.asarray(as_numpy(value), float) for value in (self.visibility, self.albedo, self.altitude)]
        own = np.broadcast_shapes(suns.shape[:-1], *(number.shape for number in numbers))
        shape = np.broadcast_shapes(views.shape[:-1], own)
        found = np.zeros((*shape, bands.size))
        suns, numbers = np.broadcast_to(suns, (*own, 3)), [np.broadcast_to(number, own) for number in numbers]
        for index in np.ndindex(own):
            place = across(index, own, shape)
            some = np.broadcast_to(views, (*shape, 3))[place]
            one = Numbers(suns[index], *(float(number[index]) for number in numbers))
            found[place] = self.of_one(some.reshape(-1, 3), one, curves, bands).reshape(*some.shape[:-1], bands.size)
        return found

    def of_one(self, views: np.ndarray, one: "Numbers", curves: Curves, bands: np.ndarray) -> np.ndarray:
        """Views (N, 3) under one sky, (N, B)."""
        held = self.held
        found = np.zeros((len(views), bands.size))
        elevation = float(np.degrees(np.arcsin(np.clip(one.sun[2], -1, 1))))
        if not is_day(one.sun, self.lowest):
            return found
        values = (one.visibility, one.albedo, one.altitude + SAFETY, elevation)
        axes = (held.visibilities, held.albedos, held.altitudes, held.elevations)
        corners = list(product(*(Place.of(value, axis).ends for value, axis in zip(values, axes, strict=True))))
        up = np.flatnonzero(views[:, 2] >= (-dip(one.altitude) if one.altitude > 0 else 0.0))
        for start in range(0, up.size, AT_ONCE):
            some = up[start : start + AT_ONCE]
            angles = angles_of(views[some], one.sun, one.altitude)
            for corner in corners:
                share = float(np.prod([weight for _, weight in corner]))
                record = curves.table[tuple(entry for entry, _ in corner)][bands]
                found[some] += share * reconstructed(record, curves, angles, elevation < 0)
        return found


def reconstructed(record: np.ndarray, curves: Curves, angles: Angles, twilight: bool) -> np.ndarray:
    """A sky's records (B,) toward N views, (N, B): a sum of products of curves, times the zenith angle's emphasis."""
    terms = record["terms"]
    emphasis = record.dtype.names is not None and "emphasis" in record.dtype.names
    zenith = np.asarray(terms["zenith"], float)
    if emphasis:
        zenith = zenith / terms["scale"][..., None]
    toward_sun = Place.of(angles.sun, curves.sun_breaks).between(np.asarray(terms["sun"], float))
    across_sky = angles.shadow if twilight and emphasis else angles.zenith
    product_ = toward_sun * Place.of(across_sky, curves.zenith_breaks).between(zenith)
    total = product_.sum(axis=-2)
    if emphasis:
        level = Place.of(angles.zenith, curves.emphasis_breaks).between(np.asarray(record["emphasis"], float))
        total = np.maximum(total * level, 0.0)
    return np.asarray(total).T
