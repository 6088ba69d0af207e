"""What two streams of light would make of a layer of cloud in its air: what the network's light is measured in."""

from typing import NamedTuple

import numpy as np

from skydome.air.optical_mass import kasten_young
from skydome.ground.arrays import Array, at_least, namespace, safe_sqrt
from skydome.ground.units import EARTH_RADIUS
from skydome.skies.clouds.layer_optics import LayerOptics

OZONE_HEIGHT = 22_000.0
"""Of the middle of the ozone, m."""
DIFFUSE = 0.6
"""Mean cosine to the vertical of skylight on the cloud."""
TO_THE_CLOUD = 0.5
"""Share of the light scattered by the air above that goes down."""
LEAST_LOST = 1e-5
"""Least share of the light that is absorbed where it is scattered: below it the formulas lose their figures."""
MEAN = 0.8
"""Mean radiance of the dome over that of an even one of the same irradiance, over a black ground."""
DARK = 1e-6
"""Light under which the network need not tell more or less from none, for a sun of irradiance 1, sr-1."""


def air_mass(sun: Array) -> Array:
    """Air on the sun's way over that on the vertical, from the sine of its elevation (...,)."""
    xp = namespace(sun)
    return kasten_young(xp.acos(xp.where(sun < 1, sun, xp.ones_like(sun))))


def ozone_mass(sun: Array, height: Array | float = 0.0) -> Array:
    """The same for ozone, which lies high: a straight way from a `height`, m, through a thin shell."""
    ratio = ((EARTH_RADIUS + height) / (EARTH_RADIUS + OZONE_HEIGHT)) ** 2
    return 1 / safe_sqrt(1 - ratio * (1 - sun * sun))


def turned(air: LayerOptics) -> Array:
    """Depth of the cloud by similarity: what is left when scattering is made even, (..., W)."""
    return air.cloud * (1 - air.albedo * air.asymmetry)


def dying(air: LayerOptics) -> Array:
    """How often light dies to 1/e on its way down, as it diffuses, (..., W)."""
    return safe_sqrt(3 * air.cloud * (1 - air.albedo) * turned(air))


class Streams(NamedTuple):
    """Shares of light, (..., W), that a cloud makes of a beam and of even light."""

    straight: Array
    """Of the beam, not scattered but by the forward peak."""
    spread: Array
    """Of the beam, scattered and gone through."""
    through: Array
    """Of even light, gone through."""
    back: Array
    """Of even light, sent back."""


def streams(air: LayerOptics, cosine: Array) -> Streams:
    """What the cloud makes of a beam of a `cosine` to the vertical (..., W), and of even light.

    Eddington's two streams (Meador and Weaver 1980, eq. 14-15 and table 1) of delta-scaled numbers (Joseph et al.
    1976), differences of like exponentials taken together, so that nothing is lost where little is absorbed.
    """
    xp, g = namespace(cosine, *air), air.asymmetry
    peak = air.albedo * g * g
    lost, depth = at_least((1 - air.albedo) / (1 - peak), LEAST_LOST), air.cloud * (1 - peak)
    w, g = 1 - lost, g / (1 + g)
    k = xp.sqrt(3 * lost * (1 - w * g))
    cosine = xp.where(k * cosine < 0.97, cosine, 0.97 / k)  # at 1 the formula is 0 / 0
    ahead, back, up = (7 - w * (4 + 3 * g)) / 4, (w * (4 - 3 * g) - 1) / 4, (2 - 3 * g * cosine) / 4
    own, straight = ahead * (1 - up) + back * up, xp.exp(-depth / cosine)
    fallen, twice = xp.exp(-k * depth), -xp.expm1(-2 * k * depth)
    whole = 2 * k + (ahead - k) * twice
    spread = 2 * k * (1 - up + own * cosine) * (fallen - straight)
    spread = spread - straight * (1 - k * cosine) * (own - k * (1 - up)) * twice
    spread = w * spread / ((1 - (k * cosine) ** 2) * whole)
    return Streams(straight, spread, 2 * k * fallen / whole, back * twice / whole)


def mirrored(air: LayerOptics) -> Array:
    """Share of even light from above that the cloud sends back, (..., W)."""
    return streams(air, DIFFUSE + 0 * air.cloud).back


class Course(NamedTuple):
    """What two streams make of sunlight of irradiance 1 on its way, (..., W)."""

    sun: Streams
    """Of the cloud, for the sun's beam."""
    beam: Array
    """Of the beam on the cloud's area."""
    sky: Array
    """Of the air above on the cloud's area."""
    again: Array
    """Share of the light below the cloud that comes back to it and down once more."""
    typical: Array
    """Radiance of the dome, the same everywhere, of what was scattered twice or more, sr-1: `DARK` or more."""


def course(air: LayerOptics, sun: Array) -> Course:
    """From the sun through air, cloud and air to the ground, and to and fro: `air` (..., W), `sun` its sine (...,)."""
    xp = namespace(sun, *air)
    mass, left, sine = (
        air_mass(sun)[..., None],
        xp.exp(-ozone_mass(sun)[..., None] * air.ozone),
        sun[..., None] + air.bend,
    )
    scattered = -xp.expm1(-mass * air.above)
    beam, sky = left * sine * (1 - scattered), left * TO_THE_CLOUD * scattered / mass
    own, even = streams(air, sine), streams(air, DIFFUSE + 0 * sine)
    straight = xp.exp(-air.scaled / sine)
    more = at_least(own.straight + own.spread - straight, 0.0) * -xp.expm1(-air.scaled / sine)
    above, below = air_mirrors(air.above), air_mirrors(air.below)
    upward = beam * at_least(own.through + own.back - own.straight - own.spread, 0.0) + sky * own.back
    first = beam * more + sky * (even.straight + even.spread) + upward * above * own.through / (1 - own.back * above)
    ground = (1 - below) / (1 - below * air.ground)
    again = own.back * (below + (1 - below) * ground * air.ground)
    typical = first * ground / (np.pi * (1 - again)) * (MEAN + (1 - MEAN) * again) + DARK
    return Course(own, beam, sky, again, typical)


def air_mirrors(depth: Array) -> Array:
    """Share of even light that clear air of an optical depth sends back."""
    return 0.75 * depth / (1 + 0.75 * depth)


def light_of(logs: Array, air: LayerOptics, sun: Array) -> Array:
    """Light scattered twice and more, sr-1, from the network's logarithms, (..., W)."""
    return at_least(namespace(logs).exp(logs) * course(air, sun).typical - DARK, 0.0)
