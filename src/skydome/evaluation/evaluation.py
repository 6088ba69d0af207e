"""Models against a measured sky: the light of each in every direction measured, and how far it is off.

The measure of a scan is sqrt(mean over valid directions (model - measured)^2) / mean measured, of radiance averaged
over 400-700 nm; with all valid directions, and with those beyond 20 degrees from the sun, where pointing errors of
1-3 degrees do not rule.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.air.cross_sections import solar_irradiance
from skydome.evaluation.measured_sky import MeasuredSky
from skydome.ground.arrays import Array
from skydome.ground.quadrature import gauss_legendre
from skydome.ground.units import deg
from skydome.light.spectrum import xyz_from_radiance
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.physical.atmosphere_sky import AtmosphereSky

NEAR_SUN = 20 * deg
BAND = (400.0, 700.0)

SkyOf = Callable[[np.ndarray, float], SpectralSky]
"""From the direction toward the sun (3,) and its distance, AU, to a sky."""


@dataclass(frozen=True, eq=False)
class Comparison:
    """A model and the measured sky: radiance averaged over 400-700 nm (C, D) of both, and XYZ of both (C, D, 3)."""

    name: str
    sky: MeasuredSky
    model: np.ndarray
    model_xyz: np.ndarray

    @property
    def far(self) -> Array:
        """Valid and beyond 20 degrees from the sun, (C, D)."""
        return self.sky.valid & (self.sky.sun_angles > NEAR_SUN)

    def errors(self, beyond: bool = False) -> Array:
        """The measure of each scan, (C,)."""
        return relative_rms(self.model, self.sky.band(), self.far if beyond else self.sky.valid)

    def figures(self) -> dict[str, float]:
        """Every figure of the table: means over the scans, and the spread of the measure."""
        own, light = self.model_xyz[..., 1], measured_xyz(self.sky)
        valid = self.sky.valid
        errors, far = self.errors(), self.errors(beyond=True)
        return {
            "error": float(errors.mean()),
            "error_least": float(errors.min()),
            "error_most": float(errors.max()),
            "error_beyond_20_degrees": float(far.mean()),
            "bias": float(
                (np.where(valid, self.model, 0).sum(1) / np.where(valid, self.sky.band(), 0).sum(1)).mean() - 1
            ),
            "luminance_error": float(relative_rms(own, light[..., 1], valid).mean()),
            "chromaticity_error": float(chromaticity_distance(self.model_xyz, light)[valid].mean()),
            "zenith_luminance_bias": float((own[:, -1] / light[:, -1, 1]).mean() - 1),
            "illuminance_bias": float((cosine_sum(self.sky, own) / cosine_sum(self.sky, light[..., 1])).mean() - 1),
        }


def relative_rms(model: np.ndarray, measured: np.ndarray, use: np.ndarray) -> Array:
    """sqrt(mean (model - measured)^2) / mean measured over the samples to use, shape (C,)."""
    count = np.maximum(use.sum(axis=1), 1)
    square = np.where(use, (model - measured) ** 2, 0).sum(axis=1) / count
    return np.sqrt(square) / (np.where(use, measured, 0).sum(axis=1) / count)


def measured_xyz(sky: MeasuredSky) -> Array:
    """CIE XYZ of the measured spectra, Y in cd m-2, (C, D, 3)."""
    inside = (sky.wavelengths >= 360) & (sky.wavelengths <= 830)
    return xyz_from_radiance(sky.radiance[..., inside], sky.wavelengths[inside])


def chromaticity_distance(a: np.ndarray, b: np.ndarray) -> Array:
    """Distance in CIE 1976 u', v' of XYZ a and b, (...,)."""

    def uv(xyz: np.ndarray) -> np.ndarray:
        total = xyz @ np.array([1.0, 15.0, 3.0])
        both: np.ndarray = xyz[..., :2] * np.array([4.0, 9.0]) / np.where(total > 0, total, 1.0)[..., None]
        return both

    return np.linalg.norm(uv(a) - uv(b), axis=-1)


def cosine_sum(sky: MeasuredSky, luminance: np.ndarray) -> Array:
    """Luminance times cosine summed over the valid directions, (C,): illuminance up to a factor."""
    return (luminance * sky.directions[..., 2] * sky.valid).sum(axis=1)


def compared(name: str, sky: MeasuredSky, sky_of: SkyOf) -> Comparison:
    """A model in the directions and under the suns of a measured sky."""
    light, colour = [], []
    for sun, distance, directions in zip(sky.suns, sky.sun_distances, sky.directions, strict=True):
        model = sky_of(sun, float(distance))
        light.append(band_mean(model, directions))
        colour.append(np.asarray(model.xyz(directions)))
    return Comparison(name, sky, np.stack(light), np.stack(colour))


def band_mean(model: SpectralSky, directions: np.ndarray) -> Array:
    """A model's radiance averaged over 400-700 nm, W m-2 sr-1 nm-1, (D,)."""
    if isinstance(model, AtmosphereSky):
        return band_mean_by_transfer(model, directions)
    wavelengths = np.arange(BAND[0], BAND[1] + 1, 10.0)
    return np.trapezoid(np.asarray(model.radiance(directions, wavelengths)), wavelengths, axis=-1) / (BAND[1] - BAND[0])


def band_mean_by_transfer(model: AtmosphereSky, directions: np.ndarray) -> Array:
    """The same from five wavelengths: what the air does is smooth, the sun's spectrum is not and is known."""
    wavelengths, weights = transfer_rule()
    transfer = model.radiance(directions, wavelengths) / model.atmosphere.sun_at(wavelengths)
    return transfer @ (weights * model.atmosphere.sun_scale)


def transfer_rule(count: int = 5) -> tuple[np.ndarray, np.ndarray]:
    """Wavelengths and weights that give the mean over 400-700 nm of sunlight times any smooth transfer."""
    fine = np.arange(BAND[0], BAND[1] + 0.5, 5.0)
    place = 2 * (fine - BAND[0]) / (BAND[1] - BAND[0]) - 1
    nodes = 2 * gauss_legendre(count)[0] - 1
    moments = np.trapezoid(solar_irradiance(fine) * np.vander(place, count, increasing=True).T, fine, axis=-1)
    weights = np.linalg.solve(np.vander(nodes, count, increasing=True).T, moments) / (BAND[1] - BAND[0])
    return BAND[0] + (nodes + 1) / 2 * (BAND[1] - BAND[0]), weights


def as_rows(comparisons: list[Comparison]) -> list[dict[str, Any]]:
    """One dictionary of plain numbers for each model."""
    return [{"model": item.name} | item.figures() for item in comparisons]


__all__ = ["Comparison", "as_rows", "band_mean", "compared", "relative_rms", "transfer_rule"]
