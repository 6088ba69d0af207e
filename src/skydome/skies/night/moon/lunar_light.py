"""The moon's light above the air: the ROLO model of its disc's reflectance (Kieffer and Stone 2005)."""

from dataclasses import dataclass

import numpy as np

from skydome.air.cross_sections import solar_irradiance
from skydome.ground.tables import columns
from skydome.ground.units import deg
from skydome.light.spectrum import Spectrum, xyz_weights
from skydome.moon.phase import MoonPhase

MEAN_DISTANCE, SOLID_ANGLE = 384_400_000.0, 6.4177e-5
"""The distance, m, and the size of the disc, sr, that the model is given at."""

OF_LIBRATION = (0.00034115, -0.0013425, 0.00095906, 0.00066229)
"""c: of the observer's longitude and latitude, degrees, and of the sun's longitude (rad) times them."""

OF_PHASE = (4.06054, 12.8802, -30.5858, 16.7498)
"""p, degrees."""

FARTHEST = 97.0 * deg
"""Phase angle to which the model was fitted; beyond, the moon fades as Krisciunas and Schaefer 1991 have it."""

BANDS = np.arange(300.0, 2501.0, 10.0)
"""Wavelengths at which the light is known, nm."""


def reflectance(
    wavelengths: np.ndarray,
    phase: np.ndarray,
    longitude_of_sun: np.ndarray,
    longitude: np.ndarray,
    latitude: np.ndarray,
) -> np.ndarray:
    """Disc-equivalent reflectance of the moon at wavelengths (W,), nm, (..., W): Kieffer and Stone 2005, eq. 10.

    Scaled to the shape of Apollo 16's samples (Roman et al. 2020), which the bands scatter about by 3 %. Phase
    angle and selenographic places (...,) in radians. Linear between the bands; the ends of 350-2384 nm are held.

    >>> reflectance(np.array([553.8]), np.array(0.2), np.array(0.2), np.array(0.0), np.array(0.0)).round(3).tolist()
    [0.087]
    """
    table = columns("rolo_2005")
    given = (phase, longitude_of_sun, longitude, latitude)
    g, turn, along, across = (np.asarray(value, np.float64)[..., None] for value in given)
    near, turn = np.minimum(np.abs(g), FARTHEST), np.clip(turn, -FARTHEST, FARTHEST)
    c, p = OF_LIBRATION, OF_PHASE
    logarithm = sum(table[f"a{i}"] * near**i for i in range(4))
    logarithm = logarithm + sum(table[f"b{j}"] * turn ** (2 * j - 1) for j in (1, 2, 3))
    logarithm = logarithm + (c[0] * along + c[1] * across + turn * (c[2] * along + c[3] * across)) / deg
    degrees = near / deg
    logarithm = logarithm + table["d1"] * np.exp(-degrees / p[0]) + table["d2"] * np.exp(-degrees / p[1])
    logarithm = logarithm + table["d3"] * np.cos((degrees - p[2]) / p[3])
    bands = np.exp(logarithm) * table["apollo"] * beyond(np.abs(g))
    knots = table["wavelength_nm"]
    right = np.clip(np.searchsorted(knots, wavelengths), 1, knots.size - 1)
    share = np.clip((wavelengths - knots[right - 1]) / (knots[right] - knots[right - 1]), 0.0, 1.0)
    found: np.ndarray = bands[..., right - 1] * (1 - share) + bands[..., right] * share
    return found


def beyond(phase: np.ndarray) -> np.ndarray:
    """What a thinner moon has of the light at 97 degrees: Krisciunas and Schaefer 1991, .026 g + 4e-9 g^4 mag."""
    far, edge = np.maximum(phase, FARTHEST) / deg, FARTHEST / deg
    fainter = 0.026 * (far - edge) + 4e-9 * (far**4 - edge**4)
    return np.asarray(10.0 ** (-0.4 * fainter))


@dataclass(frozen=True, eq=False)
class LunarLight:
    """The moon's spectral irradiance above the air, W m-2 nm-1 at `BANDS`, of its lit side and of its earthshine.

    >>> import skydome as sd
    >>> full = LunarLight.of(sd.moon_phase(sd.Place(50.0, 8.0), "2026-01-03T22:00Z"))
    >>> round(float(full.illuminance), 2)
    0.31
    """

    lit: np.ndarray
    """(..., W)."""
    earthshine: np.ndarray
    """(..., W): the earth's light on the whole disc."""

    @classmethod
    def of(cls, phase: MoonPhase) -> "LunarLight":
        """That of a moon as it is seen from a place."""
        sun = solar_irradiance(BANDS)
        places = (phase.longitude_of_sun, phase.longitude, phase.latitude)
        nearness = SOLID_ANGLE / np.pi * (MEAN_DISTANCE / phase.distance) ** 2
        lit = reflectance(BANDS, phase.phase_angle, *places) * sun
        lit = lit * (nearness / phase.sun_distance**2)[..., None]
        zero = np.full_like(phase.phase_angle, 2 * deg)
        dark = reflectance(BANDS, zero, zero, phase.longitude, phase.latitude) * sun
        dark = dark * (nearness / phase.sun_distance**2 * earth_seen(np.pi - phase.phase_angle))[..., None]
        return cls(lit, dark)

    @property
    def whole(self) -> np.ndarray:
        """Both together, (..., W)."""
        return np.asarray(self.lit + self.earthshine)

    @property
    def illuminance(self) -> np.ndarray:
        """On a plane that faces the moon, above the air, lx, (...,)."""
        return np.asarray((self.whole @ xyz_weights(BANDS))[..., 1])

    @property
    def spectrum(self) -> Spectrum:
        """The spectrum of one moon."""
        return Spectrum(BANDS, self.whole)


GEOMETRIC_ALBEDO, EARTH_RADIUS_IN_DISTANCES = 0.37, 6_371_000.0 / MEAN_DISTANCE
"""Of the earth (mean of the visible, with its clouds)."""


def earth_seen(phase: np.ndarray) -> np.ndarray:
    """Light of the earth on the moon over that of the sun, (...,): a Lambertian sphere at a phase angle in radians."""
    fading = (np.sin(phase) + (np.pi - phase) * np.cos(phase)) / np.pi
    return np.asarray(GEOMETRIC_ALBEDO * EARTH_RADIUS_IN_DISTANCES**2 * fading)
