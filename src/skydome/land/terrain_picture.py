"""A finished picture of land: its light, its depth, and the files that hold them."""

from dataclasses import dataclass
from os import PathLike
from pathlib import Path

import numpy as np

from skydome.ground import exr, png
from skydome.ground.limits.ranges import require
from skydome.light.colour import SRGB, encode_srgb
from skydome.light.tone import EXPOSURE, Curve, Filmic, auto_exposure, tone_mapped
from skydome.maps.files import light_unit


@dataclass(frozen=True, eq=False)
class TerrainPicture:
    """Linear sRGB `rgb` (H, W, 3), a white of 1 cd m-2 being (1, 1, 1), and `depth` (H, W), m, infinite in the sky.

    >>> TerrainPicture(np.full((2, 2, 3), 500.0), np.ones((2, 2))).encoded().shape
    (2, 2, 3)
    """

    rgb: np.ndarray
    depth: np.ndarray

    def exposure(self) -> float:
        """The factor that brings the usual luminance to its key."""
        return auto_exposure(np.maximum(self.rgb, 0) @ np.asarray(SRGB.to_xyz[1]))

    def encoded(self, exposure: float | None = None, curve: Curve | None = None) -> np.ndarray:
        """sRGB values (H, W, 3) in 0..1 for the screen."""
        if exposure is not None:
            require("exposure", exposure, EXPOSURE)
        factor = self.exposure() if exposure is None else exposure
        encoded: np.ndarray = encode_srgb(tone_mapped(np.maximum(self.rgb, 0.0) * factor, curve or Filmic()))
        return encoded

    def save(self, path: str | PathLike[str], exposure: float | None = None) -> None:
        """Write a .png (tone-mapped) or an .exr (linear, with the depth in channel Z)."""
        suffix = Path(path).suffix.lower()
        if suffix == ".png":
            png.write(path, self.encoded(exposure))
        elif suffix == ".exr":
            exr.write(path, {"RGB": self.rgb, "Z": self.depth}, light_unit(SRGB))
        else:
            raise ValueError(f"a terrain picture must end in .png or .exr, got {Path(path).name!r}")
