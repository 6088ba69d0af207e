"""What the light under a layer of cloud depends on at one wavelength: a few optical numbers, none of which is it."""

from functools import reduce
from typing import NamedTuple

import numpy as np

from skydome.air.clouds.cloud import Cloud
from skydome.air.constituents import Constituent
from skydome.ground.arrays import Array, as_numpy, is_concrete, namespace, safe_sqrt
from skydome.ground.limits.ranges import Range, inside
from skydome.skies.all_air.rest import heights_of

PEAK = 32
"""The Legendre moment from which on scattering counts as straight on: the streams of the teacher."""

DARK = 1e-5
"""Light under which the network need not tell more or less from none, for a sun of irradiance 1, sr-1."""

TAUGHT = {
    "above": Range(0.0, 1.35),
    "below": Range(0.0, 1.0),
    "ozone": Range(0.0, 0.42),
    "cloud": Range(0.9, 75.0),
    "albedo": Range(0.85, 1.0),
    "asymmetry": Range(0.76, 0.94),
    "peak": Range(0.0, 0.85),
    "ground": Range(0.0, 1.0),
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
}


class LayerOptics(NamedTuple):
    """The numbers of `TAUGHT`, each (..., W): optical depths, the cloud's numbers, the ground's albedo."""

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
    return LayerOptics(air * share, air * (1 - share), *depths, seen.albedo, seen.asymmetry, peak, ground)


def features(air: LayerOptics, sine: Array) -> Array:
    """What the network reads, (..., W, F): optical numbers (..., W) and the sine of the sun's elevation (...,).

    Beside the numbers, what two streams of light would make of them: depths by similarity, what the cloud mirrors,
    how fast light dies in it, how much of the beam is left above and below.
    """
    xp = namespace(sine, *air)
    above = (sine + xp.sqrt(sine * sine + 0.01)) / 2
    path = (1 / (above + 0.05))[..., None]
    m, n, o, tau, w, g, f, ground = air
    turned, lost, scaled = tau * (1 - w * g), tau * (1 - w), tau * (1 - w * f)
    dying = safe_sqrt(3 * lost * turned)
    mirror = 0.75 * turned / (1 + 0.75 * turned)
    left = xp.exp(-0.3 * path * scaled)
    numbers = [
        *(m, n, o, w, g, f, ground, mirror, dying, lost, left, xp.exp(-0.3 * scaled)),
        *(xp.log(tau), xp.log(turned), xp.log(1 + 0.75 * turned), xp.log(1 + dying), xp.log(1 + lost)),
        *(xp.log(m + 0.01), xp.log(n + 0.01), ground * mirror, xp.log(1.02 - ground * mirror), ground * n),
        *(path * m, path * o, xp.exp(-path * m), xp.exp(-path * o), xp.log(1 + path * turned)),
    ]
    heights = [part[..., None] for part in heights_of(sine, above)]
    return xp.stack(list(xp.broadcast_arrays(*numbers, *heights)), axis=-1)


def require_taught(numbers: LayerOptics) -> None:
    """ValueError in one line where a number of the air was not taught."""
    for name, number in numbers._asdict().items():
        if not is_concrete(number):
            continue
        found, interval = np.asarray(as_numpy(number)), TAUGHT[name]
        wrong = ~((found >= interval.low) & (found <= interval.high * (1 + 1e-6)))
        if wrong.any():
            raise ValueError(f"{NAMES[name]} must lie in {interval}, got {found[wrong].flat[0]:.4g}")
