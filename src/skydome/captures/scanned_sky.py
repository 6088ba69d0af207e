"""A sky measured by a scanner, as a sky: bicubic on the sphere between samples (Kider et al. 2014), cubic in time."""

from dataclasses import dataclass
from os import PathLike
from typing import Any, ClassVar

import numpy as np

from skydome.captures.interpolation import BicubicFade, Known
from skydome.captures.scans import Scan, read_scans
from skydome.ground.arrays import Array, as_numpy
from skydome.ground.directions import checked_directions
from skydome.ground.extras import required
from skydome.ground.limits.ranges import FINITE
from skydome.light.colour import xyz_from_rgb
from skydome.skies.colour_sky import ColourSky


@dataclass(frozen=True, eq=False)
class ScannedSky(ColourSky):
    """The sky of `scans` on rings of equal height, at `time` (in the scans' own unit; the first scan's where None).

    Splines along each ring and across the rings; between scans the cubic through the nearest four. Below the lowest
    ring and above the highest their own values. No sun in it: samples near it are usually left out. Needs SciPy;
    answers in NumPy. TypeError for what are no scans.

    >>> import skydome as sd
    >>> around = np.arange(12) * np.pi / 6
    >>> views = np.concatenate([sd.direction(around, np.full(12, height)) for height in (0.2, 0.7, 1.2)])
    >>> samples = np.repeat(views[:, 2:], 3, axis=1)
    >>> sky = ScannedSky((Scan(views, np.broadcast_to(sd.SOUTH, views.shape), samples, 0.0),))
    >>> round(float(sky.luminance(sd.direction(azimuth=0.1, elevation=0.5))), 2)
    0.48
    """

    scans: tuple[Scan, ...]
    time: float | None = None
    bounds: ClassVar = {"time": FINITE}
    source: ClassVar[str] = "Kider, Knowlton, Newlin, Li and Greenberg 2014"

    def __post_init__(self) -> None:
        """Validate only."""
        required("scipy.interpolate", "captures", "a scanned sky")
        if (
            not isinstance(self.scans, tuple)
            or not self.scans
            or not all(isinstance(scan, Scan) for scan in self.scans)
        ):
            raise TypeError("scans must be a tuple of one Scan or more, as `ScannedSky.read` finds in a file")
        super().__post_init__()

    @classmethod
    def read(cls, path: str | PathLike[str], time: float | None = None) -> "ScannedSky":
        """The sky of a netCDF file with the variables of Kider's open captures (`read_scans`)."""
        return cls(tuple(read_scans(path)), time)

    def rgb_light(self, directions: np.ndarray) -> np.ndarray:
        """Linear sRGB toward directions (N, 3), (N, 3), 0 or more."""
        time = self.scans[0].time if self.time is None else self.time
        return BicubicFade().light(Known(self.scans[0], self.scans[0], 0.0, self.scans, time), directions, directions)

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction (..., 3), Y in cd m-2, shape (..., 3); 0 below the horizon."""
        views = checked_directions(as_numpy(directions).astype(np.float64))
        flat = views.reshape(-1, 3)
        found = np.zeros(flat.shape)
        up = flat[:, 2] >= 0
        if up.any():
            found[up] = np.maximum(xyz_from_rgb(self.rgb_light(flat[up])), 0.0)
        return found.reshape(views.shape)

    def parameters(self) -> dict[str, Any]:
        """Parameters for provenance: how many scans, and the time."""
        return {"model": "ScannedSky", "scans": len(self.scans), "time": self.time, "check": self.check}
