"""The published closed form of aerial perspective (Preetham 1999, eq. 10, 11 and A.4), and quadrature to judge it by.

deviation from the paper | here | why
eq. 10 begins with exp(-H1) | H1 = exp(-alpha1 h0) | the density at the viewer is meant
K of section 4.1 | beta / (alpha cos t) | with the printed sign transmittance would grow with distance
"|alpha s cos t| << 1" | |alpha1 s cos t| < 0.1 | no limit is given
"""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from skydome.ground.arrays import Array, floating, namespace
from skydome.ground.extras import required
from skydome.ground.limits.ranges import Bounded, Range
from skydome.haze.integrals import (
    Coefficients,
    FewNodes,
    Integration,
    Ray,
    columns_of_air,
    mean_fall,
)

LEVEL = 0.1
"""Below this |alpha1 s cos t| a ray counts as level."""


@dataclass(frozen=True)
class PublishedClosedForm(Integration):
    """Eq. 10 for nearly level rays, eq. 11 for others. Kept as the paper's method, not for use.

    Worst relative error of I1 and I2 over zenith angles 0-120 degrees and turbidity 2-6: .8 % to 1 km, 2.4 % to 3 km,
    a factor of 4 to 10 km, then factors up to 1e28 at 100 km, because no cubic follows the other kind's extinction once
    this kind has thinned out (docs/aerial-perspective.md has the map). In float32 eq. 11 loses digits where K is small.
    """

    def integrals(self, ray: Ray, air: Coefficients) -> tuple[Array, Array]:
        """I1 and I2, m, each (..., C); infinite where the closed form overflows."""
        xp = namespace(ray.distance, ray.cosine)
        level = (xp.abs(ray.haze_decay * ray.distance * ray.cosine) < LEVEL)[..., None]
        safe = ray._replace(cosine=xp.where(level[..., 0], xp.ones_like(ray.cosine), ray.cosine))
        haze = air.haze, ray.haze_decay, ray.haze_density
        gas = air.gas, ray.gas_decay, ray.gas_density
        with np.errstate(over="ignore", invalid="ignore"):
            pairs = [
                (near_level(ray, air, own), hermite(safe, own, other)) for own, other in ((haze, gas), (gas, haze))
            ]
        first, second = (xp.where(level, flat, steep) for flat, steep in pairs)
        return first, second


Kind = tuple[Array, float, Array]
"""A kind of particle: scattering (..., C), decay with height, density at the viewer (...)."""


def near_level(ray: Ray, air: Coefficients, own: Kind) -> Array:
    """I of a nearly level ray, (..., C) (eq. 10)."""
    _, decay, density = own
    rate = air.haze * ray.haze_density[..., None] + air.gas * ray.gas_density[..., None]
    rate = rate + decay * ray.cosine[..., None]
    distance = ray.distance[..., None]
    return density[..., None] * distance * mean_fall(rate * distance)


def hermite(ray: Ray, own: Kind, other: Kind) -> Array:
    """I by a cubic in v = u(x) for the other kind's extinction, integrated by parts, (..., C) (eq. 11, A.4)."""
    xp = namespace(ray.distance, ray.cosine)
    beta, decay, density = own
    beta_other, decay_other, density_other = other
    fall, fall_other = decay * ray.cosine, decay_other * ray.cosine
    start, end = density, density * xp.exp(-fall * ray.distance)
    end_other = density_other * xp.exp(-fall_other * ray.distance)
    k = beta / fall[..., None]
    f_end = xp.exp(-beta_other / fall_other[..., None] * (density_other - end_other)[..., None])
    slope_start = beta_other * (density_other / (fall * start))[..., None]
    slope_end = f_end * beta_other * (end_other / (fall * end))[..., None]
    start, width = start[..., None], (end - start)[..., None]
    rise = (f_end - 1) / width
    c3 = (slope_start + slope_end - 2 * rise) / (width * width)
    c2 = (3 * rise - 2 * slope_start - slope_end) / width
    at_end = ((c3 * width + c2) * width + slope_start) * width + 1
    first_end = (3 * c3 * width + 2 * c2) * width + slope_start
    parts_end = at_end / k - first_end / k**2 + (6 * c3 * width + 2 * c2) / k**3 - 6 * c3 / k**4
    parts_start = 1 / k - slope_start / k**2 + 2 * c2 / k**3 - 6 * c3 / k**4
    return -(xp.exp(k * width) * parts_end - parts_start) / fall[..., None]


@dataclass(frozen=True)
class AdaptiveQuadrature(Bounded, Integration):
    """I1 and I2 by scipy's adaptive Gauss-Kronrod rule, the reference; NumPy only, slow.

    `tolerance`: relative, of every integral.
    """

    tolerance: float = 1e-9
    bounds: ClassVar = {"tolerance": Range(1e-15, 1.0)}

    def __post_init__(self) -> None:
        """Validate only."""
        self.require_bounds()

    def integrals(self, ray: Ray, air: Coefficients) -> tuple[Array, Array]:
        """I1 and I2, m, each (..., C), float64."""
        quad_vec = required("scipy.integrate", "fit", "AdaptiveQuadrature").quad_vec
        ray = Ray(*np.broadcast_arrays(*(np.asarray(part, dtype=np.float64) for part in ray)))
        rough = np.stack(FewNodes(8).integrals(ray, air))
        scale = np.where(rough > 0, rough, 1.0)
        bend = ray.distance * (air.haze_550 * ray.haze_density + air.gas_550 * ray.gas_density)

        def integrand(q: float) -> np.ndarray:
            shrink = 1 + bend * (1 - q)
            haze, gas, haze_column, gas_column = columns_of_air(ray, ray.distance * q / shrink)
            step = ray.distance * (1 + bend) / shrink**2
            seen = np.exp(-(air.haze * haze_column[..., None] + air.gas * gas_column[..., None]))
            return np.stack([(step * haze)[..., None] * seen, (step * gas)[..., None] * seen]) / scale

        found = quad_vec(integrand, 0.0, 1.0, epsabs=self.tolerance, epsrel=0.0, norm="max", limit=2000)[0]
        found = floating(found) * scale
        return found[0], found[1]
