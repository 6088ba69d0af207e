"""What the light of sun and sky carries beside what eyes see: broadband irradiance, the UV index, photons for plants.

The sky is one that knows its air and its spectrum from 300 to 2500 nm: the physical sky, with or without its sun's
disc. What the air leaves of the sunlight is taken as linear between some wavelengths, the sunlight as it is tabulated.
"""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.gases.skylight import air_mass
from skydome.dome.integrals import discs_and_rest
from skydome.ground.arrays import Array, constant, namespace
from skydome.ground.interpolation import weights
from skydome.ground.quadrature import hemisphere
from skydome.ground.tables import columns
from skydome.light.action_spectra import UV_INDEX_OF_A_WATT, erythemal_action, photosynthetic_action
from skydome.skies.all_air.sky import WAVELENGTHS, PhysicalSky
from skydome.skies.all_air.taught_air import same
from skydome.skies.sky import Sky
from skydome.skies.suns.atmosphere_sun import AtmosphereSun
from skydome.skies.validity import Check

RINGS, COLUMNS = 16, 32
ULTRAVIOLET = np.arange(290.0, 401.0, 2.0)
PLANTS = np.arange(400.0, 701.0, 10.0)
LONGEST = 3900.0
"""Of the beam, nm; beyond 2500 nm the sky's own light is nothing."""


@dataclass(frozen=True)
class Broadband:
    """Irradiance over the whole spectrum, W m-2, each (...,).

    >>> Broadband(diffuse_horizontal=80.0, direct_horizontal=500.0, direct_normal=800.0).global_horizontal
    580.0
    """

    diffuse_horizontal: Any
    direct_horizontal: Any
    direct_normal: Any

    @property
    def global_horizontal(self) -> Any:
        """Of sky and sun on the horizontal."""
        return self.diffuse_horizontal + self.direct_horizontal


def broadband(sky: Sky) -> Broadband:
    """Irradiance of sun and sky over the whole spectrum, W m-2: the sky's of 300-2500 nm, the sun's of 300-3900 nm.

    `sky`: a `PhysicalSky`, alone or with its sun's disc. What lies outside is below 2 W m-2. In the ultraviolet, where
    air may be deeper than was taught, the networks' numbers are held at the edge. TypeError for other skies.

    >>> import skydome as sd
    >>> sky = sd.PhysicalSky(sd.direction(azimuth=0.0, elevation=45 * sd.deg))
    >>> light = broadband(sky + sd.SunDisc.of(sky))
    >>> round(float(light.direct_normal), -1), round(float(light.diffuse_horizontal), -1)
    (900.0, 110.0)
    """
    known = columns("spectrl2_gases")["wavelength_nm"]
    diffuse, _, _ = parts_of(sky, known[known <= WAVELENGTHS.high], np.ones_like, check="clamp")
    _, direct, normal = parts_of(sky, known[known <= LONGEST], np.ones_like, beam_alone=True)
    return Broadband(diffuse, direct, normal)


def uv_index(sky: Sky) -> Any:
    """UV index on the horizontal, (...,), of a `PhysicalSky` alone or with its sun's disc: 290-400 nm.

    Erythemal irradiance (CIE S 007) times 40. Below 300 nm, where 2-6 % of it lies, the sky's light goes as the beam's.
    TypeError for other skies.

    >>> import skydome as sd
    >>> sky = sd.PhysicalSky(sd.direction(azimuth=0.0, elevation=60 * sd.deg), sd.clear_air(ozone=300.0, albedo=0.05))
    >>> round(float(uv_index(sky + sd.SunDisc.of(sky))), 1)
    8.1
    """
    diffuse, direct, _ = parts_of(sky, ULTRAVIOLET, erythemal_action)
    return UV_INDEX_OF_A_WATT * (diffuse + direct)


def photosynthetic_photon_flux(sky: Sky) -> Any:
    """Photons for plants on the horizontal, micromoles m-2 s-1 at 400-700 nm, (...,); `sky` as in `broadband`.

    >>> import skydome as sd
    >>> sky = sd.PhysicalSky(sd.direction(azimuth=0.0, elevation=60 * sd.deg))
    >>> round(float(photosynthetic_photon_flux(sky + sd.SunDisc.of(sky))), -2)
    1900.0
    """
    diffuse, direct, _ = parts_of(sky, PLANTS, photosynthetic_action)
    return diffuse + direct


def knows_energy(sky: Sky) -> bool:
    """True for skies of which `broadband` and its like can be asked."""
    discs, rest = discs_and_rest(sky)
    known = [isinstance(disc, AtmosphereSun) for disc, _ in discs]
    return all(known + [isinstance(part.single[0], PhysicalSky) for part in rest])


def parts_of(
    sky: Sky, wavelengths: np.ndarray, action: Any, beam_alone: bool = False, check: Check | None = None
) -> tuple[Any, Any, Any]:
    """What light does by an `action`: diffuse and direct on the horizontal, and direct normal, (...,) each."""
    discs, rest = discs_and_rest(sky)
    diffuse, direct, normal = 0.0, 0.0, 0.0
    for part in rest:
        inner, factor = part.single
        if not isinstance(inner, PhysicalSky):
            raise TypeError(f"{type(inner).__name__} does not know light of 300-2500 nm; PhysicalSky does")
        if not beam_alone:
            held = inner if check is None or inner.check != "raise" else replace(inner, check=check)
            each = weights_of(inner.atmosphere, wavelengths, action) * factor
            diffuse = diffuse + diffuse_of(held, wavelengths) @ constant(each, inner.toward)
    for disc, factor in discs:
        if not isinstance(disc, AtmosphereSun):
            raise TypeError(f"{type(disc).__name__} does not know light of 300-2500 nm; SunDisc.of(PhysicalSky) does")
        beam = alone(disc.irradiance(wavelengths)) @ weights_of(disc.atmosphere, wavelengths, action) * factor
        height = np.maximum(alone(disc.sun)[..., 2], 0.0)
        direct, normal = direct + beam * height, normal + beam
    return diffuse, direct, normal


def diffuse_of(sky: PhysicalSky, wavelengths: np.ndarray) -> Array:
    """Spectral irradiance of the sky on the horizontal, W m-2 nm-1, (..., W)."""
    directions, solid_angles = hemisphere(RINGS, COLUMNS)
    nodes, each = (constant(part, sky.toward) for part in (directions, solid_angles * directions[:, 2]))
    known = wavelengths >= WAVELENGTHS.low
    if known.all():
        return each @ sky.radiance(nodes, wavelengths)
    light = each @ sky.radiance(nodes, wavelengths[known])
    short = wavelengths[: np.argmax(known) + 1]
    depth = sum((same(part.depth(short), light) for part in sky.atmosphere.constituents), 0.0)
    xp, sunlight = namespace(light), sky.atmosphere.sun_at(short)
    mass = alone(air_mass(sky.toward[..., 2])[..., None])
    fall = xp.exp(-(alone(depth) - alone(depth)[..., -1:]) * mass) * constant(sunlight / sunlight[-1], light)
    return xp.concat([light[..., :1] * fall[..., :-1], light], axis=-1)


def weights_of(air: Atmosphere, wavelengths: np.ndarray, action: Any) -> np.ndarray:
    """Weights (W,) of light at `wavelengths` in its integral times an action, its share of the sunlight linear."""
    fine = np.arange(wavelengths[0], wavelengths[-1] + 0.5)
    step = np.full(fine.shape, 1.0)
    step[[0, -1]] = 0.5
    hats = weights(wavelengths, fine)
    result: np.ndarray = (step * action(fine) * air.sun_at(fine)) @ hats / air.sun_at(wavelengths)
    return result


def alone(light: Array) -> Array:
    """Numbers (..., 1, W) of suns that have an axis for views without it."""
    return light[..., 0, :] if light.ndim > 1 else light
