"""What the overcast sky's network reads: optical numbers, the sun's height, and what two streams make of them."""

from skydome.ground.arrays import Array, at_least, namespace, safe_sqrt
from skydome.skies.all_air.rest import heights_of
from skydome.skies.clouds.layer_optics import LayerOptics
from skydome.skies.clouds.two_streams import DARK, air_mass, course, dying, ozone_mass, turned


def features(air: LayerOptics, sine: Array) -> Array:
    """What the network reads, (..., W, F): optical numbers (..., W) and the sine of the sun's elevation (...,).

    Beside the numbers, what two streams of light make of them: depths by similarity, what the cloud mirrors, how fast
    light dies in it, how much of the beam is left above and below, what comes upon the cloud and through it; and how
    much the earth's roundness matters to the beam.
    """
    xp = namespace(sine, *air)
    above = (sine + xp.sqrt(sine * sine + 0.01)) / 2
    path, mass, high = ((1 / (above + 0.05))[..., None], air_mass(sine)[..., None], ozone_mass(sine)[..., None])
    m, n, o, tau, w, g, f, ground, height, thickness = air
    deep, fast, scaled, low = turned(air), dying(air), air.scaled, at_least(sine, 0.0)[..., None] + air.bend
    two = course(air, sine)
    numbers = [
        *(m, n, o, w, g, f, ground, height / 1e4, thickness / 2e3),
        *(xp.log(tau), xp.log(deep), xp.log(1 + 0.75 * deep), xp.log(m + 0.01), xp.log(n + 0.01)),
        *(fast, xp.log(1 + fast), safe_sqrt((1 - w) * tau / deep), two.sun.back, two.again, xp.log(1.02 - two.again)),
        *(ground * n, path * m, xp.exp(-path * m), mass * m, high * o, xp.exp(-mass * m), xp.exp(-high * o)),
        *(xp.exp(-0.3 * scaled), xp.exp(-0.3 * path * scaled), xp.exp(-scaled / low), xp.log(1 + path * deep)),
        *(two.sun.straight, two.sun.spread, xp.log(two.sun.through + DARK), two.sky / (two.beam + two.sky + DARK)),
        *(xp.log(two.beam + two.sky + DARK), xp.log(two.typical), xp.log(low), safe_sqrt(air.bend / low)),
    ]
    heights = [part[..., None] for part in heights_of(sine, above)]
    return xp.stack(list(xp.broadcast_arrays(*numbers, *heights)), axis=-1)
