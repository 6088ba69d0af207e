"""What gases leave of the light of the sky, which has come by many ways.

A beam of known columns stands for them: of the sun's and the view's air masses m and v, a m^b + c v^d + e columns. The
numbers were fitted to discrete ordinates with the gas in the layers, its bands taken apart into sums of exponentials
(a k-distribution), in 240 random airs, 590-1090 nm, suns of 1-90 degrees, views of 2-90 degrees
(benchmarks/gases.py). The rms error there, as a part of the light outside the bands: 0.023 (water) and 0.021
(mixed gases), about twice that for views of 2 degrees; by the sun's way alone, as in Bird and Riordan 1986, 0.11 and
0.07.
"""

from typing import NamedTuple

from numpy.typing import ArrayLike

from skydome.air.gases.gases import Gases
from skydome.air.optical_mass import kasten_young
from skydome.ground.arrays import Array, limited, namespace, safe_sqrt


class Way(NamedTuple):
    """The numbers of a mean way."""

    sun: float
    sun_power: float
    view: float
    view_power: float
    rest: float

    def columns(self, sun: Array, view: Array) -> Array:
        """Vertical columns on the way of air masses of sun and view, which broadcast to (...,)."""
        return self.sun * sun**self.sun_power + self.view * view**self.view_power + self.rest


WATER_WAY = Way(0.873, 0.676, 1.998, 0.563, -1.776)
MIXED_WAY = Way(1.458, 0.694, 2.37, 0.314, -2.826)


def skylight_share(gases: Gases, sun: Array, view: Array, wavelengths: ArrayLike) -> Array:
    """Share of the sky's light that gases leave, (..., W), by cosines (...,) of sun and view to the vertical.

    Below the horizon the sun counts as on it.
    """
    m, v = air_mass(sun), air_mass(view)
    return gases.transmittance(WATER_WAY.columns(m, v), MIXED_WAY.columns(m, v), wavelengths)


def air_mass(cosine: Array) -> Array:
    """Relative optical mass toward cosines (...,) to the vertical (Kasten and Young 1989)."""
    cosine = limited(cosine, 0.0, 1.0)
    return kasten_young(namespace(cosine).atan2(safe_sqrt(1 - cosine * cosine), cosine))
