"""Air of one density along the whole ray: the closed form of games (Hoffman and Preetham 2002).

deviation from the paper | here | why
light from the sun only | from whatever sky `aerial_perspective` is given; `SunDisc.of(sky)` alone for the paper's | one
  way to light the air
haze scatters by (1 - g)^2 / (4 pi (1 + g^2 - 2 g cos t)^(3/2)) | by Preetham 1999's Table 1 | with (1 - g)^2 where
  1 - g^2 belongs its integral over all angles is (1 - g) / (1 + g), not 1
"""

from dataclasses import dataclass

from skydome.ground.arrays import Array
from skydome.haze.integrals import Coefficients, Integration, Ray, mean_fall


@dataclass(frozen=True)
class HoffmanPreetham(Integration):
    """Transmittance exp(-b s), in-scattered light S / b (1 - exp(-b s)), b of the air at the viewer all along the ray.

    Right for level rays, the same in every direction. How wrong it is elsewhere: docs/aerial-perspective.md.

    >>> import skydome as sd
    >>> sky = sd.Preetham(sd.direction(azimuth=4.0, elevation=0.5), turbidity=3.0)
    >>> flat = sd.aerial_perspective(sky, 5000.0, sd.NORTH, method=HoffmanPreetham()).inscattered
    >>> exact = sd.aerial_perspective(sky, 5000.0, sd.NORTH).inscattered
    >>> bool((abs(flat / exact - 1) < 1e-6).all())
    True
    """

    def rate(self, ray: Ray, air: Coefficients) -> Array:
        """Extinction per metre at the viewer, (..., C)."""
        return air.haze * ray.haze_density[..., None] + air.gas * ray.gas_density[..., None]

    def optical_depth(self, ray: Ray, air: Coefficients) -> Array:
        """Optical depth of the whole ray, shape (..., C)."""
        return self.rate(ray, air) * ray.distance[..., None]

    def integrals(self, ray: Ray, air: Coefficients) -> tuple[Array, Array]:
        """I1 and I2, m, each (..., C)."""
        length = ray.distance[..., None] * mean_fall(self.optical_depth(ray, air))
        return ray.haze_density[..., None] * length, ray.gas_density[..., None] * length
