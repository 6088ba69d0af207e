"""One captured sky: its map, its sun, and where it shows sky."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import ArrayLike

from skydome.captures.high_dynamic_range import require_hdr
from skydome.captures.sky_mask import sky_mask
from skydome.captures.sun_finding import find_sun, sun_pixels
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.equirectangular import Equirectangular
from skydome.skies.captured import CapturedSky, without_sun
from skydome.sun.times import Times, instants

SUN_RADIUS, SUN_TEXELS = np.radians(4.0), 2.0
"""How far from its middle a sun is taken out of a picture: an angle, or texels where they are coarse."""


@dataclass(frozen=True, eq=False)
class Capture:
    """One captured sky: its equirectangular `picture`, the direction of its `sun`, where it shows `sky`, its time.

    `sky` (H, W) leaves out ground, skyline and the sun's own texels. `calm` is the picture with the sun taken out,
    `sunlight` what was taken, linear sRGB cd m-2 sr, (3,). `time` is UTC, None where it is not known. `clipped`
    counts the negative values that became 0.
    """

    name: str
    picture: EnvironmentMap
    sun: np.ndarray
    sky: np.ndarray
    calm: EnvironmentMap
    sunlight: np.ndarray
    time: np.datetime64 | None = None
    clipped: int = 0
    visible: bool = field(default=True)

    @classmethod
    def of(
        cls,
        picture: EnvironmentMap,
        name: str = "capture",
        sun: ArrayLike | None = None,
        sky: np.ndarray | None = None,
        time: Times | None = None,
        horizon: float = 0.0,
    ) -> "Capture":
        """A capture of a map in any layout: its sun is found where none is given, its sky segmented likewise.

        Negative values become 0; NaN, 8 bit pictures, and skies without a sun are refused (ValueError).
        """
        picture, clipped = cleaned(picture, name)
        if not isinstance(picture.projection, Equirectangular):
            picture = picture.resampled(Equirectangular())
        visible = True
        if sun is None:
            try:
                found = find_sun(picture, sky_mask(picture, None, horizon) if sky is None else sky)
            except ValueError as error:
                raise ValueError(f"{name}: {error}") from None
            sun, visible = found.direction, found.visible
        sun = np.asarray(sun, dtype=np.float64)
        mask = sky_mask(picture, sun, horizon) if sky is None else sky
        calm, taken = without_sun(picture, sun, max(SUN_RADIUS, SUN_TEXELS * np.pi / picture.height))
        scale = picture.white_luminance
        return cls(
            name,
            picture,
            sun,
            mask & ~sun_pixels(picture, sun),
            replace(picture, pixels=calm),
            taken * scale,
            None if time is None else np.datetime64(instants(time).item(), "us"),
            clipped,
            visible,
        )

    def captured_sky(self) -> CapturedSky:
        """The capture as a sky."""
        return CapturedSky(self.picture, self.sun)


def cleaned(picture: EnvironmentMap, name: str) -> tuple[EnvironmentMap, int]:
    """The map in linear sRGB without negative values, and how many there were; ValueError for NaN and for LDR."""
    broken = int(np.count_nonzero(~np.isfinite(picture.pixels)))
    if broken:
        raise ValueError(f"{name}: pixels must be finite, got {broken} values of NaN or infinity; repair the capture")
    require_hdr(picture.pixels, name)
    from skydome.light.colour import SRGB

    pixels = picture.pixels
    if picture.space is not SRGB:
        pixels = (pixels @ (SRGB.from_xyz @ picture.space.to_xyz).T).astype(pixels.dtype)
    clipped = int(np.count_nonzero(pixels < 0))
    return replace(picture, pixels=np.maximum(pixels, 0), space=SRGB), clipped


def seconds_of(captures: Sequence[Capture]) -> np.ndarray:
    """Times of captures, s after the first, (n,); 0, 1, 2 ... where they have none."""
    stamps = [capture.time for capture in captures]
    if stamps[0] is None:
        return np.arange(len(stamps), dtype=np.float64)
    return np.array([(stamp - stamps[0]) / np.timedelta64(1, "s") for stamp in stamps])
