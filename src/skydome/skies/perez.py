"""The Perez sky from five letters (Perez, Seals and Michalsky 1993)."""

from dataclasses import dataclass
from typing import Any, ClassVar

from skydome.ground.arrays import Array, constant, floating
from skydome.ground.limits.ranges import Range
from skydome.skies.formula.formula_sky import LuminanceFormulaSky
from skydome.skies.formula.perez_formula import from_perez


@dataclass(frozen=True, eq=False)
class Perez(LuminanceFormulaSky):
    """Luminance (1 + a exp(b / cos t)) (1 + c exp(d g) + e cos^2 g), scaled to a level.

    a darkens or brightens the horizon, b < 0 its gradient, c the circumsolar region, d its width, e the backscatter.
    Level: zenith_luminance, cd m-2, or illuminance (diffuse, horizontal), lx (Perez et al. 1993). The letters
    broadcast with the sun's leading axes. Where the formula falls below 0 the sky is black; one that is
    black all over, or in the zenith whose luminance is given, is refused.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=90 * sd.deg, elevation=40 * sd.deg)
    >>> sky = sd.Perez(sun, -1.0, -0.32, 10.0, -3.0, 0.45, illuminance=12_000.0)
    >>> round(float(sd.illuminance(sky, sd.ZENITH)))
    12000
    """

    a: Any
    b: Any
    c: Any
    d: Any
    e: Any
    ranges: ClassVar = {"b": Range(-float("inf"), 0.0)}  # else exp(b / cos t) has no bound at the horizon
    bounds: ClassVar = {name: Range(-1e6, 1e6) for name in "abce"} | {"d": Range(-1e6, 100.0)}  # exp(d g) overflows
    source: ClassVar[str] = "Perez, Seals and Michalsky 1993"

    def relative_coefficients(self) -> Array:
        """R A ... I with R = 1, shape (..., 1, 10)."""
        a, c, d, e = (floating(value, like=self.sun) for value in (self.a, self.c, self.d, self.e))
        return from_perez(constant(1.0, self.sun), a, self.parameter("b"), c, d, e)
