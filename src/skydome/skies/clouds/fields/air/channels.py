"""What light is told in."""

from dataclasses import dataclass

import numpy as np

from skydome.light.spectrum import xyz_weights
from skydome.skies.colour_sky import SpectralSky


@dataclass(frozen=True, eq=False)
class Channels:
    """What light is told in: weights (W, C) of wavelengths (W,), nm."""

    wavelengths: np.ndarray
    weights: np.ndarray

    @classmethod
    def of_spectrum(cls, wavelengths: np.ndarray) -> "Channels":
        """Each wavelength by itself."""
        return cls(wavelengths, np.eye(len(wavelengths)))

    @classmethod
    def of_colours(cls) -> "Channels":
        """CIE XYZ."""
        return cls(SpectralSky.bands, xyz_weights(SpectralSky.bands))
