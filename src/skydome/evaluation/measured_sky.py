"""A measured sky: spectral radiance in many directions, scan after scan, with the sun's place in each."""

import re
from collections import defaultdict
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from skydome.ground.arrays import Array
from skydome.ground.directions import angle_between, direction
from skydome.ground.extras import required
from skydome.ground.units import deg
from skydome.sun.place import Place
from skydome.sun.position import sun_direction

CORNELL = Place(latitude=42.443449, longitude=-76.481962, altitude=280.0)
"""Where Kider et al. (2014) measured, Ithaca, New York."""

SAMPLES, SCAN_SECONDS = 81, 342.0
NAME = re.compile(
    r"(?P<date>\d{4}-\d\d-\d\d)_+(?P<hour>\d\d)\.(?P<minute>\d\d)\.(?P<second>\d\d)_-_"
    r"(?P<sample>\d+)_+(?P<azimuth>[\d.]+?)_+(?P<elevation>[\d.]+?)\.asd\.rad\.txt$"
)


@dataclass(frozen=True, eq=False)
class MeasuredSky:
    """Scans (C) of directions (D): radiance (C, D, W), W m-2 sr-1 nm-1, at wavelengths (W,) nm.

    `suns` (C, 3) is the sun at the middle of each scan, `sun_angles` (C, D) each sample's angle from the sun at its own
    time, radians; `valid` (C, D) says which samples to use; `times` (C,) are UTC; `names` are the scans'.
    """

    names: tuple[str, ...]
    times: np.ndarray
    suns: np.ndarray
    directions: np.ndarray
    wavelengths: np.ndarray
    radiance: np.ndarray
    valid: np.ndarray
    sun_angles: np.ndarray

    @classmethod
    def open(cls, path: str | PathLike[str]) -> "MeasuredSky":
        """The sky in a netCDF-3 file (`kider2014_*.nc`) or in a folder as published; ValueError for anything else."""
        place = Path(path)
        if place.is_dir():
            return cls.from_folder(place)
        if not place.exists():
            raise FileNotFoundError(
                f"the measured sky must be a netCDF file or a folder, got {place}, which is not there"
            )
        return cls.from_netcdf(place)

    @classmethod
    def from_netcdf(cls, path: Path) -> "MeasuredSky":
        """The sky in a compact netCDF-3 file."""
        netcdf_file = required("scipy.io", "fit", "a measured sky in netCDF").netcdf_file
        try:
            with netcdf_file(path, "r", mmap=False) as stored:
                held = {name: np.array(variable[:]) for name, variable in stored.variables.items()}
        except (TypeError, ValueError, OSError) as error:
            raise ValueError(f"{path.name} is no netCDF-3 file that can be read whole: {error}") from error
        missing = {"radiance", "valid", "direction_azimuth", "direction_zenith", "sun_zenith", "sun_azimuth"} - set(
            held
        )
        if missing:
            raise ValueError(f"{path.name} is no measured sky: it lacks {', '.join(sorted(missing))}")
        names = tuple(b"".join(row.astype("S1")).decode() for row in held["capture"])
        elevation = (90 - held["direction_zenith"].astype(np.float64)) * deg
        return cls(
            names,
            np.array([name + "-04:00" for name in names]),
            direction(held["sun_azimuth"] * deg, (90 - held["sun_zenith"]) * deg).astype(np.float64),
            direction(held["direction_azimuth"].astype(np.float64) * deg, elevation[None, :]),
            held["wavelength"].astype(np.float64),
            held["radiance"].astype(np.float64),
            held["valid"] == 1,
            held["sun_angle"].astype(np.float64) * deg,
        )

    @classmethod
    def from_folder(cls, folder: Path) -> "MeasuredSky":
        """The sky in a folder as published, `<date>/RADIANCE/.../<date>___<hour>_-_<sample>____<azimuth>...rad.txt`.

        Azimuths in the names run counter-clockwise from north, by a scanner whose north was off: each scan is turned
        so that it is symmetric about the sun's meridian. Times are UTC-4. The first sample of a scan is not used.
        ValueError for scans of which samples are missing, or that mix wavelengths.
        """
        scans = found_scans(folder)
        parts = [read_scan(name, files) for name, files in sorted(scans.items())]
        if any(part[0].shape != parts[0][0].shape or (part[0] != parts[0][0]).any() for part in parts):
            raise ValueError(f"the scans in {folder} do not have the same wavelengths")
        names = tuple(sorted(scans))
        middle = np.timedelta64(round(SCAN_SECONDS / 2), "s")
        times = np.array([np.datetime64(name) + middle for name in names])
        suns = sun_direction(CORNELL, times + np.timedelta64(4, "h"))
        radiance = np.stack([part[2] for part in parts])
        turned = [turned_to_sun(part[1], part[2].mean(axis=-1), sun) for part, sun in zip(parts, suns, strict=True)]
        directions = np.stack(turned)
        valid = np.ones(radiance.shape[:2], dtype=bool)
        valid[:, 0] = False
        angles = angle_between(directions, suns[:, None, :])
        stamps = np.array([f"{time}-04:00" for time in times])
        return cls(names, stamps, suns, directions, parts[0][0], radiance, valid & (angles > 5 * deg), angles)

    def __len__(self) -> int:
        return len(self.names)

    @property
    def sun_distances(self) -> np.ndarray:
        """The sun's distance in each scan, AU, (C,)."""
        from skydome.sun.position import earth_sun_distance

        return earth_sun_distance([str(time) for time in self.times])

    def band(self, low: float = 400.0, high: float = 700.0) -> Array:
        """Radiance averaged over wavelengths from low to high, W m-2 sr-1 nm-1, shape (C, D)."""
        inside = (self.wavelengths >= low) & (self.wavelengths <= high)
        return np.trapezoid(self.radiance[..., inside], self.wavelengths[inside], axis=-1) / (high - low)

    def some(self, scans: Any) -> "MeasuredSky":
        """The scans of an index array or slice."""
        index = np.arange(len(self))[scans]
        parts = (self.times, self.suns, self.directions, self.wavelengths, self.radiance, self.valid, self.sun_angles)
        chosen = [part if part is self.wavelengths else part[index] for part in parts]
        return MeasuredSky(tuple(self.names[k] for k in index), *chosen)


def found_scans(folder: Path) -> dict[str, dict[int, Path]]:
    """Scan name (its local time) -> sample number -> file; ValueError where there are none, or some are missing."""
    scans: dict[str, dict[int, Path]] = defaultdict(dict)
    for path in sorted(folder.rglob("*.rad.txt")):
        match = NAME.search(path.name)
        if match is None:
            raise ValueError(
                f"{path.name} is not named as the measurements are: <date>___<hour>_-_<sample>____<azimuth>..."
            )
        g = match.groupdict()
        scans[f"{g['date']}T{g['hour']}:{g['minute']}:{g['second']}"][int(g["sample"])] = path
    if not scans:
        raise ValueError(f"no measurements (*.rad.txt) lie in {folder}")
    for name, files in scans.items():
        missing = sorted(set(range(SAMPLES)) - set(files))
        if missing:
            raise ValueError(
                f"the scan {name} lacks {len(missing)} of {SAMPLES} samples, the first is number {missing[0]}"
            )
    return scans


def read_scan(name: str, files: dict[int, Path]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Wavelengths (W,), directions as named but clockwise (D, 3), radiance (D, W) of one scan."""
    tables, angles = [], []
    for sample in range(SAMPLES):
        match = NAME.search(files[sample].name)
        assert match is not None
        angles.append((-float(match["azimuth"]) * deg, float(match["elevation"]) * deg))
        try:
            tables.append(np.loadtxt(files[sample], skiprows=1, ndmin=2))
        except ValueError as error:
            raise ValueError(f"{files[sample].name} cannot be read: {error}") from error
    first = tables[0]
    if any(table.shape != first.shape or (table[:, 0] != first[:, 0]).any() for table in tables) or len(first) < 2:
        raise ValueError(f"the samples of the scan {name} do not have the same wavelengths: one may be cut short")
    azimuth, elevation = np.array(angles).T
    return first[:, 0], direction(azimuth, elevation), np.stack([table[:, 1] for table in tables])


def turned_to_sun(directions: np.ndarray, light: np.ndarray, sun: np.ndarray) -> Array:
    """The directions (D, 3) turned about the vertical, by -10 to 30 degrees, to make the light (D,) symmetric."""
    from skydome.ground.directions import rotate_about_vertical

    turns = np.arange(-10.0, 30.01, 0.1) * deg
    return rotate_about_vertical(directions, turns[np.argmin([asymmetry(directions, light, sun, t) for t in turns])])


def asymmetry(directions: np.ndarray, light: np.ndarray, sun: np.ndarray, turn: float) -> float:
    """How unlike the two sides of the sun's meridian are: the sine terms of log light along each ring."""
    level = np.round(directions[:, 2], 4)
    azimuth = np.arctan2(directions[:, 0], directions[:, 1]) + turn - np.arctan2(sun[0], sun[1])
    total = 0.0
    for ring in np.unique(level):
        here = level == ring
        orders = np.arange(1, min(4, here.sum() // 2))
        terms = np.sin(orders[:, None] * azimuth[here]) @ np.log(np.maximum(light[here], 1e-12))
        total += float((terms**2).sum()) / here.sum()
    return total + (1e9 if best_side(azimuth, light) < 0 else 0)


def best_side(azimuth: np.ndarray, light: np.ndarray) -> float:
    """Positive where the brighter side lies toward the sun, so that a sky is not turned back to front."""
    return float((np.cos(azimuth) * light).sum())
