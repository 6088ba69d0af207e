"""Brunger and Hooper's sky (1993): a constant, a term in the view's height and one about the sun, by the weather.

deviation from the source | here | why
table of 48 kinds of weather, one number 43268 | 4.3268 | a lost point: as all others of that column
radiance over irradiance by a closed form of the integral | by quadrature | the closed form is up to .7 % off (tested)
a sum below 0 far from the sun, in some kinds | 0 | no negative light
kinds between the table's, and those that it lacks | the nearest kind that it has | the paper bins in steps of .1
"""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arrays import Array, as_numpy, at_least, constant, namespace, settled
from skydome.ground.limits.ranges import SHARE
from skydome.ground.tables import columns
from skydome.skies.formula.shaped_sky import ShapedSky


@settled
def numbers_of(diffuse_share: Any, clearness: Any) -> np.ndarray:
    """a0, a1, a2, a3 of the nearest kind of weather in the table, shape (4, ...)."""
    table = columns("brunger_hooper_1993")
    share, clear = np.broadcast_arrays(as_numpy(diffuse_share), as_numpy(clearness))
    off = (share[..., None] - table["diffuse_share"]) ** 2 + (clear[..., None] - table["clearness"]) ** 2
    nearest = off.argmin(axis=-1)
    return np.stack([table[name][nearest] for name in ("a0", "a1", "a2", "a3")])


@dataclass(frozen=True, eq=False)
class BrungerHooper(ShapedSky):
    """The sky of Brunger and Hooper 1993 for a diffuse share of global irradiance and a clearness index, each 0-1.

    L ~ a0 + a1 cos t + a2 exp(-a3 g), t the zenith angle, g the angle to the sun; the numbers by the nearest of 48
    kinds of weather measured at Toronto. Made for radiance of all wavelengths, taken for luminance here. Level by
    zenith_luminance, cd m-2, or illuminance, lx.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=0.0, elevation=0.6)
    >>> clear = sd.BrungerHooper(sun, diffuse_share=0.15, clearness=0.75, illuminance=12_000.0)
    >>> bool(clear.luminance(sun) > 5 * clear.luminance(sd.ZENITH))
    True
    """

    diffuse_share: Any = 0.15
    clearness: Any = 0.75
    ranges: ClassVar = {"diffuse_share": SHARE, "clearness": SHARE}
    source: ClassVar[str] = "Brunger and Hooper 1993, table 2"

    def relative(self, view_zenith: Array, sun_angle: Array, sun_zenith: Array) -> Array:
        """Relative radiance, shape (...,); 0 where the sum is negative, as that of some kinds is far from the sun."""
        xp = namespace(view_zenith, sun_angle)
        a0, a1, a2, a3 = (constant(part, sun_angle) for part in numbers_of(self.diffuse_share, self.clearness))
        if 0 < a0.ndim < sun_zenith.ndim:  # against nodes of the sky
            a0, a1, a2, a3 = (part[..., None] for part in (a0, a1, a2, a3))
        return at_least(a0 + a1 * xp.cos(view_zenith) + a2 * xp.exp(-a3 * sun_angle), 0.0)
