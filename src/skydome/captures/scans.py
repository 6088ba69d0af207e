"""Measured skies on rings: a scanner's directions of equal height, with its light and the sun at each sample."""

from dataclasses import dataclass
from os import PathLike
from typing import Any

import numpy as np

from skydome.ground.directions import angle_between, azimuth, direction, elevation
from skydome.ground.extras import required
from skydome.ground.units import deg
from skydome.light.colour import SRGB, rgb_from_xyz


@dataclass(frozen=True, eq=False)
class Scan:
    """One scan: `directions` and `suns` (D, 3), `light` (D, 3) linear sRGB cd m-2, rings by `heights` (D,), `time` s.

    Only valid samples are in it. Its sun is the sun at the middle sample.
    """

    directions: np.ndarray
    suns: np.ndarray
    light: np.ndarray
    time: float

    @property
    def sun(self) -> np.ndarray:
        """Unit vector toward the sun at the middle of the scan, (3,)."""
        middle: np.ndarray = self.suns[len(self.suns) // 2]
        return middle

    def values_at(self, values: np.ndarray, directions: np.ndarray, turned: np.ndarray | None = None) -> np.ndarray:
        """Values (D, C) of the samples, bicubic on the sphere, toward directions (N, 3), shape (N, C).

        Periodic cubic splines along each ring, then a cubic spline across the rings. `turned` (N, 3): suns; azimuths
        then count from the sun on both sides, so that the sky turns with it.
        """
        from scipy.interpolate import CubicSpline

        asked, own = azimuth(directions), azimuth(self.directions)
        if turned is not None:
            asked, own = asked - azimuth(turned), own - azimuth(self.suns)
        heights, rings = np.unique(elevation(self.directions).round(6), return_inverse=True)
        along = np.stack(
            [ring_spline(own[rings == k], values[rings == k])(asked % (2 * np.pi)) for k in range(len(heights))]
        )
        wanted = np.clip(elevation(directions), heights[0], heights[-1])
        if len(heights) == 1:
            return np.asarray(along[0])
        pieces = CubicSpline(heights, along, axis=0, bc_type="natural").c  # (4, rings - 1, N, C): each view has its own
        ring = np.clip(np.searchsorted(heights, wanted, side="right") - 1, 0, len(heights) - 2)
        cubic, step = pieces[:, ring, np.arange(len(wanted))], (wanted - heights[ring])[:, None]
        across: np.ndarray = ((cubic[0] * step + cubic[1]) * step + cubic[2]) * step + cubic[3]
        return across

    def light_at(self, directions: np.ndarray, turned: np.ndarray | None = None) -> np.ndarray:
        """Light (N, 3) toward directions (N, 3), the sky turned with the suns `turned` (N, 3) if given; see above."""
        return self.values_at(self.light, directions, turned)


def ring_spline(angles: np.ndarray, values: np.ndarray) -> Any:
    """A periodic cubic spline of values (n, C) at angles (n,), radians; a constant for a single one."""
    from scipy.interpolate import CubicSpline

    order = np.argsort(angles % (2 * np.pi))
    x, y = (angles % (2 * np.pi))[order], values[order]
    if len(x) == 1:
        return lambda asked: np.broadcast_to(y[0], (*np.shape(asked), y.shape[-1]))
    spline = CubicSpline(np.append(x, x[0] + 2 * np.pi), np.append(y, y[:1], axis=0), bc_type="periodic")
    return lambda asked: spline(x[0] + (asked - x[0]) % (2 * np.pi))


def read_scans(path: str | PathLike[str], from_sun: float = 0.0) -> list[Scan]:
    """The scans of a netCDF-3 file with the variables of Kider's open captures: radiance as CIE XYZ, suns, validity.

    `xyz` (capture, direction, 3), `direction_azimuth`, `sample_sun_zenith`, `sample_sun_azimuth`, `valid` (capture,
    direction), `direction_zenith` (direction), degrees; `sample_time`. Azimuths must already be corrected. Samples
    within `from_sun` radians of the sun are left out. ValueError for other files and where a variable is missing.
    """
    netcdf_file = required("scipy.io", "captures", "measured scans").netcdf_file
    try:
        opened = netcdf_file(str(path), "r", mmap=False)
    except (TypeError, ValueError):
        raise ValueError(f"{path} is not a netCDF-3 file of measured scans") from None
    with opened as file:
        names = (
            "xyz",
            "direction_azimuth",
            "sample_sun_zenith",
            "sample_sun_azimuth",
            "valid",
            "direction_zenith",
            "time",
        )
        missing = [name for name in names if name not in file.variables]
        if missing:
            raise ValueError(f"measured scans need the variables {', '.join(names)}; missing: {', '.join(missing)}")
        data = {name: np.array(file.variables[name].data, dtype=np.float64) for name in names}
    height = 90 * deg - np.broadcast_to(data["direction_zenith"] * deg, data["valid"].shape)
    toward = direction(data["direction_azimuth"] * deg, height)
    suns = direction(data["sample_sun_azimuth"] * deg, 90 * deg - data["sample_sun_zenith"] * deg)
    light = rgb_from_xyz(data["xyz"], SRGB)
    good = (data["valid"] > 0) & (angle_between(toward, suns) >= from_sun)
    return [Scan(toward[k][g], suns[k][g], light[k][g], float(data["time"][k])) for k, g in enumerate(good)]
