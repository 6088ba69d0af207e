"""What the light under a layer of cloud depends on at one wavelength: a few optical numbers, none of which is it."""

from functools import reduce
from typing import NamedTuple

import numpy as np

from skydome.air.clouds.cloud import Cloud
from skydome.air.clouds.particles import CloudParticles
from skydome.air.constituents import Constituent
from skydome.ground.arrays import Array, as_numpy, is_concrete, namespace
from skydome.ground.limits.ranges import Range, inside
from skydome.ground.units import EARTH_RADIUS

PEAK = 32
"""The Legendre moment from which on scattering counts as straight on: the streams of the teacher."""

TAUGHT = {
    "above": Range(0.0, 1.35),
    "below": Range(0.0, 1.0),
    "ozone": Range(0.0, 0.42),
    "cloud": Range(0.9, 75.0),
    "albedo": Range(0.85, 1.0),
    "asymmetry": Range(0.76, 0.94),
    "peak": Range(0.0, 0.85),
    "ground": Range(0.0, 1.0),
    "height": Range(25.0, 14_000.0, "m"),
    "thickness": Range(50.0, 4000.0, "m"),
}
NAMES = {
    "above": "optical depth of molecules above the cloud",
    "below": "optical depth of molecules below the cloud",
    "ozone": "optical depth of ozone",
    "cloud": "optical depth of the cloud",
    "albedo": "single scattering albedo of the cloud",
    "asymmetry": "asymmetry of the cloud",
    "peak": "forward peak of the cloud",
    "ground": "albedo of the ground",
    "height": "height of the cloud's middle",
    "thickness": "thickness of the cloud",
}


class LayerOptics(NamedTuple):
    """The numbers of `TAUGHT`, each (..., W) or (1,): optical depths, the cloud's numbers, the ground's albedo."""

    above: Array
    """Of molecules, from the middle of the cloud up."""
    below: Array
    ozone: Array
    cloud: Array
    albedo: Array
    asymmetry: Array
    peak: Array
    """Moment number `PEAK` of the phase function."""
    ground: Array
    height: Array
    """Of the cloud's middle, m."""
    thickness: Array
    """Of the cloud, m."""

    @property
    def scaled(self) -> Array:
        """The cloud's depth without its forward peak, (..., W)."""
        return self.cloud * (1 - self.albedo * self.peak)

    @property
    def bend(self) -> Array:
        """What the earth's roundness adds to a low sun's sine, (..., W).

        A beam of sine s leaves s + T / (R t) on each unit of the level area of a round layer of thickness T, radius R
        and depth t, where it ends in the layer.
        """
        return self.thickness / (EARTH_RADIUS * self.scaled)

    @property
    def allowed(self) -> Array:
        """True where all numbers (..., W) lie in `TAUGHT`, (...,)."""
        xp = namespace(*self)
        each = (xp.all(inside(number, TAUGHT[name]), axis=-1) for name, number in self._asdict().items())
        return reduce(lambda a, b: a & b, each)


def layer_optics(
    molecules: Constituent, ozone: Constituent, cloud: Cloud, ground: Array, wavelengths: np.ndarray
) -> LayerOptics:
    """The numbers of an air at wavelengths (W,) nm, each (..., W) in its own library; `ground` (..., W)."""
    seen, air = cloud.optics(wavelengths), molecules.depth(wavelengths)
    share = float(molecules.profile.above(np.asarray(cloud.profile.mean_height)))
    peak = cloud.phase_law.moments(PEAK + 1, wavelengths)[PEAK]
    depths = ozone.depth(wavelengths), cloud.depth(wavelengths)
    place = (np.array([number]) for number in (cloud.profile.mean_height, cloud.thickness))
    return LayerOptics(air * share, air * (1 - share), *depths, seen.albedo, seen.asymmetry, peak, ground, *place)


def require_known(kind: CloudParticles) -> None:
    """ValueError in one line for particles whose scattering is made otherwise than that of those that were taught."""
    if kind.peaked:
        raise ValueError(
            f"the overcast sky was taught Water() and Ice(), got {kind}; DiscreteOrdinates takes it, and "
            "CloudySky (--clouds cirrus --cloud-kind hexagonal)"
        )


def require_taught(numbers: LayerOptics) -> None:
    """ValueError in one line where a number of the air was not taught."""
    for name, number in numbers._asdict().items():
        if not is_concrete(number):
            continue
        found, interval = np.asarray(as_numpy(number)), TAUGHT[name]
        wrong = ~((found >= interval.low) & (found <= interval.high * (1 + 1e-6)))
        if wrong.any():
            raise ValueError(f"{NAMES[name]} must lie in {interval}, got {found[wrong].flat[0]:.4g}")
