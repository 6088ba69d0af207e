"""What two streams of light would make of a layer of cloud: what the network's light is measured in, and reads."""

import numpy as np

from skydome.air.optical_mass import kasten_young
from skydome.ground.arrays import Array, at_least, namespace, safe_sqrt
from skydome.ground.units import EARTH_RADIUS
from skydome.skies.all_air.rest import heights_of
from skydome.skies.clouds.layer_optics import LayerOptics

OZONE_HEIGHT = 22_000.0
"""Of the middle of the ozone, m."""
DIFFUSE = 0.6
"""Mean cosine to the vertical of skylight on the cloud."""
TO_THE_CLOUD = 0.5
"""Share of the light scattered by the air above that goes down."""
DARK = 1e-6
"""Light under which the network need not tell more or less from none, for a sun of irradiance 1, sr-1."""


def air_mass(sun: Array) -> Array:
    """Air on the sun's way over that on the vertical, from the sine of its elevation (...,)."""
    xp = namespace(sun)
    return kasten_young(xp.acos(xp.where(sun < 1, sun, xp.ones_like(sun))))


def ozone_mass(sun: Array) -> Array:
    """The same for ozone, which lies high: a straight way through a thin shell."""
    ratio = (EARTH_RADIUS / (EARTH_RADIUS + OZONE_HEIGHT)) ** 2
    return 1 / safe_sqrt(1 - ratio * (1 - sun * sun))


def turned(air: LayerOptics) -> Array:
    """Depth of the cloud by similarity: what is left when scattering is made even, (..., W)."""
    return air.cloud * (1 - air.albedo * air.asymmetry)


def dying(air: LayerOptics) -> Array:
    """How often light dies to 1/e on its way down, as it diffuses, (..., W)."""
    return safe_sqrt(3 * air.cloud * (1 - air.albedo) * turned(air))


def mirrored(air: LayerOptics) -> Array:
    """Share of light from below that the cloud sends back, none absorbed, (..., W)."""
    part = 0.75 * turned(air)
    return part / (1 + part)


def on_the_cloud(air: LayerOptics, sun: Array) -> tuple[Array, Array]:
    """Light of the sun's beam, and of the air above, on the level cloud, for a sun of irradiance 1, (..., W) each."""
    xp = namespace(sun, *air)
    mass, left = air_mass(sun)[..., None], xp.exp(-ozone_mass(sun)[..., None] * air.ozone)
    scattered = -xp.expm1(-mass * air.above)
    return left * sun[..., None] * (1 - scattered), left * TO_THE_CLOUD * scattered / mass


def passed(air: LayerOptics, cosine: Array) -> Array:
    """Share of light of a `cosine` to the vertical (..., W) that comes through the cloud, (..., W).

    Eddington's two streams (Meador and Weaver 1980), (2 + 3 cosine) / (4 + 3 (1 - g) depth), less what dies.
    """
    xp, lost = namespace(cosine, *air), dying(air)
    safe = xp.where(lost > 1e-3, lost, xp.full_like(lost, 1e-3))
    return (2 + 3 * cosine) / (4 + 3 * turned(air)) * safe / xp.sinh(safe) * -xp.expm1(-air.cloud)


def typical(air: LayerOptics, sun: Array) -> Array:
    """Radiance under the cloud for a sun of irradiance 1, the same everywhere, sr-1, (..., W), of `DARK` or more."""
    beam, sky = on_the_cloud(air, sun)
    cosine = (beam * sun[..., None] + sky * DIFFUSE) / at_least(beam + sky, 1e-30)
    back = air.ground * mirrored(air) / (1 + dying(air))
    return (beam + sky) * passed(air, cosine) / (np.pi * (1 - back)) + DARK


def features(air: LayerOptics, sine: Array) -> Array:
    """What the network reads, (..., W, F): optical numbers (..., W) and the sine of the sun's elevation (...,).

    Beside the numbers, what two streams of light make of them: depths by similarity, what the cloud mirrors, how fast
    light dies in it, how much of the beam is left above and below, what comes upon the cloud and through it.
    """
    xp = namespace(sine, *air)
    above = (sine + xp.sqrt(sine * sine + 0.01)) / 2
    path, mass, high = ((1 / (above + 0.05))[..., None], air_mass(sine)[..., None], ozone_mass(sine)[..., None])
    m, n, o, tau, w, g, f, ground = air
    deep, lost, scaled, fast, mirror = turned(air), tau * (1 - w), tau * (1 - w * f), dying(air), mirrored(air)
    left, coming = xp.exp(-0.3 * path * scaled), sum(on_the_cloud(air, sine))
    numbers = [
        *(m, n, o, w, g, f, ground, mirror, fast, lost, left, xp.exp(-0.3 * scaled)),
        *(xp.log(tau), xp.log(deep), xp.log(1 + 0.75 * deep), xp.log(1 + fast), xp.log(1 + lost)),
        *(xp.log(m + 0.01), xp.log(n + 0.01), ground * mirror, xp.log(1.02 - ground * mirror), ground * n),
        *(path * m, path * o, xp.exp(-path * m), xp.exp(-path * o), xp.log(1 + path * deep)),
        *(mass * m, high * o, xp.exp(-mass * m), xp.exp(-high * o), xp.log(coming + DARK)),
        *(xp.log(passed(air, 1 + 0 * m) + DARK), xp.log(typical(air, sine))),
    ]
    heights = [part[..., None] for part in heights_of(sine, above)]
    return xp.stack(list(xp.broadcast_arrays(*numbers, *heights)), axis=-1)


def light_of(logs: Array, air: LayerOptics, sun: Array) -> Array:
    """Light scattered twice and more, sr-1, from the network's logarithms, (..., W)."""
    xp = namespace(logs)
    return at_least(xp.exp(logs) * typical(air, sun) - DARK, 0.0)
