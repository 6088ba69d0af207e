"""What a layer of cloud scatters once toward the ground, per phase function, in closed form."""

from skydome.ground.arrays import Array, at_least, namespace, safe_sqrt
from skydome.ground.units import EARTH_RADIUS
from skydome.skies.clouds.layer_optics import LayerOptics
from skydome.skies.clouds.two_streams import air_mass

LEAST = 0.02
"""Least cosine to the vertical in the cloud."""


def once(air: LayerOptics, height: float, view: Array, sun: Array) -> Array:
    """Light scattered once by the cloud for a sun of irradiance 1, over its phase function, (..., W).

    Views and sun by their cosines to the vertical (...,), numbers (..., W); `height` m of the cloud's middle, where a
    straight view that leaves the ground is steeper. The depth is the cloud's without its forward peak.
    """
    xp = namespace(view, sun, *air)
    scaled = air.cloud * (1 - air.albedo * air.peak)
    along, through = scaled / up_there(view, height)[..., None], scaled / at_least(sun, LEAST)[..., None]
    gap = xp.abs(along - through)
    lit = along * xp.exp(-xp.where(along < through, along, through)) * share_left(gap)
    seen = xp.exp(-air.below / up_there(view, height / 2)[..., None])
    return lit * seen * beam(air, sun, 0 * air.cloud) * air.albedo / (1 - air.albedo * air.peak)


def beam(air: LayerOptics, sun: Array, cloud: Array) -> Array:
    """What the clear air above, and a depth of `cloud` (..., W), leave of the sun's beam, (..., W)."""
    xp = namespace(sun, *air)
    return xp.exp(-air_mass(sun)[..., None] * (air.above + air.ozone) - cloud / at_least(sun, LEAST)[..., None])


def up_there(cosine: Array, height: float) -> Array:
    """Cosine to the vertical, at a height in m, of a view that leaves the ground with `cosine`, at least `LEAST`."""
    ratio = (EARTH_RADIUS / (EARTH_RADIUS + height)) ** 2
    return at_least(safe_sqrt(1 - ratio * (1 - cosine * cosine)), LEAST)


def share_left(x: Array) -> Array:
    """(1 - exp(-x)) / x for x >= 0; 1 at 0."""
    xp = namespace(x)
    small = x < 1e-4
    safe = xp.where(small, xp.ones_like(x), x)
    return xp.where(small, 1 - x / 2, -xp.expm1(-safe) / safe)
