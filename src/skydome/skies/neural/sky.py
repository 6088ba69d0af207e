"""The neural sky of Satilmis et al. (2017): a sky in 492 bytes, and wider and spectral ones."""

from abc import abstractmethod
from dataclasses import dataclass
from os import PathLike
from typing import Any, ClassVar

import numpy as np

from skydome.air.atmosphere import USUAL_ALBEDO
from skydome.ground.arguments import numbers
from skydome.ground.arrays import Array, as_numpy, constant, floating, is_numpy, limited, namespace, settled
from skydome.ground.directions import checked_directions
from skydome.ground.limits.ranges import Range, require
from skydome.light.colour import SRGB, RGBSpace, rgb_from_xyz, xyz_from_rgb
from skydome.light.spectrum import Spectrum, xyz_weights
from skydome.skies.colour_sky import ColourSky, SpectralSky
from skydome.skies.neural.files import load_network, shipped_network
from skydome.skies.neural.folding import Folded, folded
from skydome.skies.neural.network import Network, conditions, features
from skydome.skies.sky import SunlitSky


@dataclass(frozen=True, eq=False)
class NeuralForm(SunlitSky):
    """What neural skies share. Turbidity and albedo are ignored by networks that were trained without them."""

    network: Network
    turbidity: Any = 3.0
    albedo: Any = USUAL_ALBEDO
    ranges: ClassVar = {"turbidity": Range(1.0, 10.0), "albedo": Range(0.0, 1.0)}
    source: ClassVar[str] = "Satilmis et al. 2017"

    @property
    def haze(self) -> Any:
        """The turbidity."""
        return self.turbidity

    def outputs(self, directions: Array) -> Array:
        """The network's light toward each direction, (..., outputs); 0 below the horizon and at night.

        float32 directions under one sky take the fast single precision paths, compiled where Numba is installed.
        """
        namespace(directions, self.sun)
        directions = checked_directions(directions, like=self.sun)
        if self.is_one_numpy_sky and isinstance(directions, np.ndarray) and directions.dtype == np.float32:
            return self.single_outputs(directions)
        sun = floating(self.sun, like=directions)
        turbidity = limited(floating(self.turbidity, like=directions), 1.0, 10.0)
        albedo = limited(floating(self.albedo, like=directions), 0.0, 1.0)
        inputs = features(self.network.features, conditions(directions, sun, turbidity, albedo))
        return self.blanked(self.network.light(inputs), directions)

    @property
    def is_one_numpy_sky(self) -> bool:
        """Whether the conditions are single numbers by day, in NumPy's hands and inside the ranges."""
        parts = (self.sun, self.turbidity, self.albedo)
        if not all(is_numpy(part) for part in parts) or [np.ndim(part) for part in parts] != [1, 0, 0]:
            return False
        return bool(np.all(self.is_day)) and (self.check != "nan" or bool(np.all(self.valid)))

    def single_outputs(self, directions: np.ndarray) -> np.ndarray:
        """`outputs` in float32 by the folded network."""
        from skydome.skies.neural.fast import light_toward

        light = light_toward(self.folded(), directions.reshape(-1, 3))
        return light.reshape(*directions.shape[:-1], -1)

    def folded(self) -> Folded:
        """The network under this one sky: what the float32 paths and shaders evaluate."""
        turbidity, albedo = (as_numpy(floating(value)) for value in (self.turbidity, self.albedo))
        return folded(self.network, self.sun, np.clip(turbidity, 1.0, 10.0), np.clip(albedo, 0.0, 1.0))

    @abstractmethod
    def rgb_matrix(self, space: RGBSpace = SRGB) -> np.ndarray:
        """What takes the network's outputs to linear RGB with white of 1 cd m-2 being (1, 1, 1), (3, outputs)."""

    def parameters(self) -> dict[str, Any]:
        """Parameters for provenance: the network by its inputs and size; no albedo where it does not ask for one."""
        network = f"{len(self.network.features)} inputs, {self.network.bytes} bytes"
        told = super().parameters() | {"network": network}
        return told if "albedo" in self.network.features else {n: v for n, v in told.items() if n != "albedo"}


@dataclass(frozen=True, eq=False)
class NeuralSky(NeuralForm, ColourSky):
    """A sky from a network that gives linear sRGB: the paper's, or a wider one.

    >>> import skydome as sd
    >>> sky = sd.NeuralSky.load("hosek-wilkie", sd.direction(azimuth=1.0, elevation=0.7), turbidity=3.0)
    >>> red, green, blue = sky.rgb(sd.ZENITH)
    >>> bool(blue > green > red)
    True
    """

    @classmethod
    def load(cls, network: str | PathLike[str], sun: Array, turbidity: Any = 3.0, **others: Any) -> "NeuralSky":
        """A sky of a network file, or of a network that the package carries, by name."""
        return cls(sun, read_network(network), turbidity, **others)

    def rgb(self, directions: Array, space: RGBSpace = SRGB) -> Array:
        """Linear RGB toward each direction, white of 1 cd m-2 being (1, 1, 1), shape (..., 3)."""
        light = self.outputs(directions)
        return light if space is SRGB else rgb_from_xyz(xyz_from_rgb(light), space)

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction, Y in cd m-2, shape (..., 3)."""
        light = self.outputs(directions)
        return light @ constant(srgb_to_xyz(), light)

    def rgb_matrix(self, space: RGBSpace = SRGB) -> np.ndarray:
        """From linear sRGB to the space, (3, 3)."""
        return np.eye(3) if space is SRGB else np.asarray(rgb_from_xyz(xyz_from_rgb(np.eye(3)), space)).T


@dataclass(frozen=True, eq=False)
class NeuralSpectralSky(NeuralForm, SpectralSky):
    """A sky from a network that gives spectral radiance in bands, linear in wavelength between them.

    >>> import skydome as sd
    >>> sky = NeuralSpectralSky.load("hosek-wilkie-spectral", sd.direction(180 * sd.deg, 40 * sd.deg), turbidity=3.0)
    >>> sky.radiance(sd.ZENITH, [450.0, 650.0]).shape
    (2,)
    """

    @classmethod
    def load(
        cls, network: str | PathLike[str], sun: Array, turbidity: Any = 3.0, albedo: Any = USUAL_ALBEDO, **others: Any
    ) -> "NeuralSpectralSky":
        """A sky of a spectral network file, or of one that the package carries, by name."""
        return cls(sun, read_network(network), turbidity, albedo, **others)

    @property
    def bands(self) -> np.ndarray:  # type: ignore[override]
        """The network's wavelengths, nm."""
        return np.asarray(self.network.bands)

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction, W m-2 sr-1 nm-1, shape (..., W); ValueError outside the bands."""
        wavelengths = np.atleast_1d(numbers(wavelengths, "wavelengths"))
        require("wavelengths", wavelengths, Range(self.bands[0], self.bands[-1], "nm"))
        light = self.outputs(directions)
        return light @ constant(Spectrum(self.bands, np.eye(self.bands.size)).at(wavelengths), light)

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction, Y in cd m-2, of the spectrum linear between the bands, shape (..., 3)."""
        light = self.outputs(directions)
        return light @ constant(bands_to_xyz(self.network.bands), light)

    def rgb_matrix(self, space: RGBSpace = SRGB) -> np.ndarray:
        """From the bands' spectral radiances, linear between them, to RGB, (3, bands)."""
        return np.asarray(rgb_from_xyz(xyz_weights(self.bands), space)).T


@settled
def srgb_to_xyz() -> np.ndarray:
    """From linear sRGB to XYZ, as rows times this (3, 3)."""
    return SRGB.to_xyz.T


@settled
def bands_to_xyz(bands: tuple[float, ...]) -> np.ndarray:
    """From spectral radiances in bands, nm, to XYZ, as rows times this (bands, 3)."""
    return xyz_weights(bands)


def read_network(network: str | PathLike[str]) -> Network:
    """The network of a file (.safetensors), or one that the package carries, by name."""
    if str(network).endswith(".safetensors"):
        return load_network(network)[0]
    return shipped_network(str(network))[0]
