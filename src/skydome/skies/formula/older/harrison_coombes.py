"""Harrison and Coombes' sky (1988): radiance over irradiance of clear and of opaque cloud, mixed by cloud cover."""

from dataclasses import dataclass
from typing import Any, ClassVar

from skydome.ground.arrays import Array, at_least, floating, namespace
from skydome.ground.limits.ranges import SHARE
from skydome.skies.formula.shaped_sky import ShapedSky

LEAST_COSINE = 1e-6
"""What stands for a cosine of 0 where the formula divides by it."""


@dataclass(frozen=True, eq=False)
class HarrisonCoombes(ShapedSky):
    """The sky of Harrison and Coombes 1988 under a share `cloud` of opaque cloud, 0 (clear) to 1 (overcast).

    N = cloud N_o + (1 - cloud) N_c, pi times radiance over diffuse irradiance; t the zenith angle, ts the sun's, g the
    angle to the sun. N_c = (1.63 + 53.7 exp(-5.49 g) + 2.04 cos^2 g cos ts) (1 - exp(-0.19 / cos t))
    (1 - exp(-0.53 / cos ts)); N_o = 0.45 + 0.12 ts + 0.43 cos t + 0.72 exp(-1.88 g). Made for short-wave radiance,
    taken for luminance here. Level by zenith_luminance, cd m-2, or illuminance, lx.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=0.0, elevation=0.6)
    >>> half = sd.HarrisonCoombes(sun, cloud=0.5, illuminance=20_000.0)
    >>> bool(half.luminance(sun) > 3 * half.luminance(sd.ZENITH))
    True
    """

    cloud: Any = 0.0
    ranges: ClassVar = {"cloud": SHARE}
    source: ClassVar[str] = "Harrison and Coombes 1988, eq. 3-5"

    def relative(self, view_zenith: Array, sun_angle: Array, sun_zenith: Array) -> Array:
        """Pi times radiance over diffuse irradiance, 1, shape (...,)."""
        xp = namespace(view_zenith, sun_angle)
        cloud = floating(self.cloud, like=sun_angle)
        if 0 < cloud.ndim < sun_zenith.ndim:  # against nodes of the sky
            cloud = cloud[..., None]
        return cloud * overcast(xp, view_zenith, sun_angle, sun_zenith) + (1 - cloud) * clear(
            xp, view_zenith, sun_angle, sun_zenith
        )


def clear(xp: Any, view_zenith: Array, sun_angle: Array, sun_zenith: Array) -> Array:
    """Eq. 3, the clear sky."""
    up, sun_up = at_least(xp.cos(view_zenith), LEAST_COSINE), at_least(xp.cos(sun_zenith), LEAST_COSINE)
    indicatrix = 1.63 + 53.7 * xp.exp(-5.49 * sun_angle) + 2.04 * xp.cos(sun_angle) ** 2 * sun_up
    return indicatrix * (1 - xp.exp(-0.19 / up)) * (1 - xp.exp(-0.53 / sun_up))


def overcast(xp: Any, view_zenith: Array, sun_angle: Array, sun_zenith: Array) -> Array:
    """Eq. 4, the sky under opaque cloud."""
    return 0.45 + 0.12 * sun_zenith + 0.43 * xp.cos(view_zenith) + 0.72 * xp.exp(-1.88 * sun_angle)
