"""The sky of a photograph: an environment map that answers as every sky does."""

from dataclasses import dataclass, field, replace
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arrays import Array, as_numpy, constant, is_concrete, is_numpy, namespace
from skydome.ground.directions import ZENITH, angle_between, checked_directions, rotate_about_vertical
from skydome.light.colour import SRGB, RGBSpace, rgb_from_xyz
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.lookup import equirectangular
from skydome.maps.projections import Equirectangular
from skydome.skies.colour_sky import ColourSky
from skydome.skies.sky import Combination, combine
from skydome.skies.suns.sun_disc import SunDisc

GLARE = np.radians(2.5)
"""Angle about the sun within which a captured sun's light is spread: lens and texels, not the disc alone."""


@dataclass(frozen=True, eq=False)
class CapturedSky(ColourSky):
    """A sky looked up in an environment map, blended between texel centres; 0 below the horizon.

    `sun` (3,) is where the map's sun stands, None where it is not known. Other than a model's, the sky has its light
    by night too. Lookups in equirectangular maps are made in the directions' own library, with gradients; those in
    other layouts are NumPy's: other libraries get their answer back without. A map with NaN or infinity is refused.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=2.0, elevation=0.7)
    >>> photograph = sd.render(sd.HosekWilkie(sun, turbidity=3.0), height=64)
    >>> sky = CapturedSky(photograph, sun)
    >>> bool(abs(sd.illuminance(sky) / sd.illuminance(sd.HosekWilkie(sun, turbidity=3.0)) - 1) < 0.01)
    True
    """

    map: EnvironmentMap
    sun: Any = field(default=None)
    source: ClassVar[str] = "a captured environment map"

    def __post_init__(self) -> None:
        """Refuse what is no map, and maps with pixels that are no light."""
        if not isinstance(self.map, EnvironmentMap):
            raise TypeError(f"map must be an EnvironmentMap, got {type(self.map).__name__}")
        wrong = int(np.count_nonzero(~np.isfinite(self.map.pixels)))
        if wrong:
            raise ValueError(f"pixels of a captured sky must be finite, got {wrong} values of NaN or infinity")
        if self.sun is not None and np.shape(as_numpy(self.sun)) != (3,):
            raise ValueError(f"sun must have shape (3,), got {np.shape(as_numpy(self.sun))}")
        if self.sun is not None:
            super().__post_init__()

    @property
    def is_day(self) -> Array:
        """True: a photograph has its light wherever its sun stands."""
        return np.asarray(True)

    @property
    def valid(self) -> Array:
        """True."""
        return np.asarray(True)

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction (..., 3), Y in cd m-2, shape (..., 3); 0 below the horizon."""
        directions = checked_directions(directions)
        layout = self.map.projection
        if not is_numpy(directions) and isinstance(layout, Equirectangular):
            light = equirectangular(self.map.pixels, layout, directions)
            light = light @ constant(self.map.space.to_xyz.T * self.map.white_luminance, directions)
            return namespace(light).where(directions[..., 2:3] >= 0, light, light * 0)
        if not is_concrete(directions):
            name = type(layout).__name__
            raise TypeError(
                f"a captured {name} map is looked up in NumPy, not traced; resample it to Equirectangular()"
            )
        toward = as_numpy(directions)
        light = self.map.sample(toward) @ (self.map.space.to_xyz.T * self.map.white_luminance)
        return constant(np.where(toward[..., 2:3] >= 0, light, 0.0), directions)

    def rgb(self, directions: Array, space: RGBSpace = SRGB) -> Array:
        """Linear RGB toward each direction, white of 1 cd m-2 being (1, 1, 1), shape (..., 3)."""
        return rgb_from_xyz(self.xyz(directions), space)

    def rotated(self, angle: float) -> "CapturedSky":
        """The sky turned clockwise about the vertical by `angle` radians, its sun with it."""
        sun = None if self.sun is None else rotate_about_vertical(self.sun, angle)
        return replace(self, map=self.map.rotated(angle), sun=sun)

    def illuminance(self, normal: Any = ZENITH) -> np.ndarray:
        """Illuminance on planes that face `normal` (..., 3), lx, from every texel of the upper half, suns included.

        Exact for the map as it is, where `skydome.illuminance` may miss a sun of few texels between its nodes.
        """
        return self.upper_half().illuminance(normal)

    def upper_half(self) -> EnvironmentMap:
        """The map with black where its texel centres look below the horizon."""
        above = self.map.projection.directions(self.map.height)[..., 2:3] >= 0
        return replace(self.map, pixels=np.where(above, self.map.pixels, np.zeros(1, self.map.pixels.dtype)))

    def relit(self, illuminance: float) -> "CapturedSky":
        """The sky scaled so that it lights a horizontal plane with `illuminance`, lx: a unit for captures without.

        >>> import skydome as sd
        >>> round(float(CapturedSky(sd.render(sd.Daylight(sd.Uniform(1.0)), height=64)).relit(5000.0).illuminance()))
        5000
        """
        had = float(self.illuminance())
        if not 0 < illuminance < np.inf or had <= 0:
            raise ValueError(f"illuminance must be positive and the sky not black, got {illuminance} and {had} lx")
        return replace(self, map=replace(self.map, white_luminance=self.map.white_luminance * illuminance / had))

    def sun_and_calm(self, radius: float = GLARE) -> tuple["CapturedSky", np.ndarray]:
        """The sky with its sun taken out, and the light taken, RGB x sr of the map's pixels, shape (3,).

        Texels within `radius` of the sun that are brighter than the ring around (`radius` to twice it) get the
        ring's median. ValueError where the sun is not known.
        """
        if self.sun is None:
            raise ValueError("the sun of the captured sky is not known; give CapturedSky(map, sun)")
        pixels, taken = without_sun(self.map, as_numpy(self.sun), radius)
        return replace(self, map=replace(self.map, pixels=pixels)), taken

    def with_disc(self, turbidity: float = 3.0, radius: float = GLARE) -> Combination:
        """The sky with its sun exchanged for a `SunDisc` of the same direct illuminance: exact in every integral.

        The level is the capture's, the spectrum that of the disc at `turbidity`.
        """
        calm, taken = self.sun_and_calm(radius)
        level = float(self.map.space.to_xyz[1] @ taken) * self.map.white_luminance
        return combine((calm, SunDisc(self.sun, turbidity, direct_normal_illuminance=level)), (1.0, 1.0))

    def parameters(self) -> dict[str, Any]:
        """Parameters for provenance; the map by its size and layout."""
        rows, columns = self.map.pixels.shape[:2]
        sun = None if self.sun is None else as_numpy(self.sun).tolist()
        return {"model": "CapturedSky", "map": f"{columns} x {rows}, {self.map.projection}", "sun": sun}


def without_sun(picture: EnvironmentMap, sun: np.ndarray, radius: float) -> tuple[np.ndarray, np.ndarray]:
    """Pixels with the sun's glare at the level of the ring around it, and what was taken, RGB x sr, (3,)."""
    toward = picture.projection.directions(picture.height)
    angle = angle_between(toward, sun)
    ring = (angle > radius) & (angle <= 2 * radius) & (toward[..., 2] >= 0)
    within = (angle <= radius) & (toward[..., 2] >= 0)
    pixels = picture.pixels.copy()
    if not ring.any() or not within.any():
        return pixels, np.zeros(3)
    level = np.median(picture.pixels[ring], axis=0)
    calm = np.minimum(pixels[within], level)
    sizes = np.broadcast_to(picture.projection.solid_angles(picture.height), angle.shape)[within]
    taken: np.ndarray = sizes @ (pixels[within] - calm).astype(np.float64)
    pixels[within] = calm
    return pixels, taken
