"""What a layer of cloud scatters once toward the ground, per phase function, in closed form."""

from skydome.ground.arrays import Array, at_least, limited, namespace, safe_sqrt
from skydome.ground.units import EARTH_RADIUS
from skydome.skies.clouds.layer_optics import LayerOptics
from skydome.skies.clouds.two_streams import air_mass, ozone_mass

LEAST = 0.02
"""Least cosine to the vertical of a view, and of the sun's beam on the ground, in the cloud."""


def once(air: LayerOptics, view: Array, sun: Array, angle: Array) -> Array:
    """Light scattered once by the cloud for a sun of irradiance 1, over its phase function, (..., W).

    Views and sun by their cosines to the vertical, and that of the angle between them, (...,); numbers (..., W). The
    cloud is a thin round shell: where the view meets its middle, the view is steeper than at the ground and the sun
    stands otherwise. The depth is the cloud's without its forward peak.
    """
    xp = namespace(view, sun, angle, *air)
    height, local = air.height, sun_there(air.height, view, sun, angle)
    along, through = air.scaled / up_there(view, height), air.scaled / (local + air.bend)
    gap = xp.abs(along - through)
    lit = along * xp.exp(-xp.where(along < through, along, through)) * share_left(gap)
    seen = xp.exp(-air.below / up_there(view, height / 2))
    came = xp.exp(-air_mass(local) * air.above - ozone_mass(local, height) * air.ozone)
    return lit * seen * came * air.albedo / (1 - air.albedo * air.peak)


def sun_there(height: Array, view: Array, sun: Array, angle: Array) -> Array:
    """Cosine of the sun to the vertical where a view (...,) meets a height (..., W), m; 0 where it is down."""
    top, view = EARTH_RADIUS + height, view[..., None]
    away = safe_sqrt(top**2 - EARTH_RADIUS**2 * (1 - view * view)) - EARTH_RADIUS * view
    return limited((EARTH_RADIUS * sun[..., None] + away * angle[..., None]) / top, 0.0, 1.0)


def beam(air: LayerOptics, sun: Array, cloud: Array) -> Array:
    """What the clear air above, and a depth of `cloud` (..., W), leave of the sun's beam, (..., W)."""
    xp = namespace(sun, *air)
    return xp.exp(-air_mass(sun)[..., None] * (air.above + air.ozone) - cloud / at_least(sun, LEAST)[..., None])


def up_there(cosine: Array, height: Array) -> Array:
    """Cosine to the vertical, at a height (..., W), m, of a view that leaves the ground with `cosine` (...,)."""
    ratio, cosine = (EARTH_RADIUS / (EARTH_RADIUS + height)) ** 2, cosine[..., None]
    return at_least(safe_sqrt(1 - ratio * (1 - cosine * cosine)), LEAST)


def share_left(x: Array) -> Array:
    """(1 - exp(-x)) / x for x >= 0; 1 at 0."""
    xp = namespace(x)
    small = x < 1e-4
    safe = xp.where(small, xp.ones_like(x), x)
    return xp.where(small, 1 - x / 2, -xp.expm1(-safe) / safe)
