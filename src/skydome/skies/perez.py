"""The Perez sky from five letters (Perez, Seals and Michalsky 1993)."""

from dataclasses import dataclass, field
from typing import Any, ClassVar

from skydome.ground.arrays import Array, constant, floating
from skydome.skies.formula.formula_sky import LuminanceFormulaSky
from skydome.skies.formula.level import levelled, require_one_level
from skydome.skies.formula.perez_formula import from_perez
from skydome.skies.validity import Range


@dataclass(frozen=True, eq=False)
class Perez(LuminanceFormulaSky):
    """Luminance (1 + a exp(b / cos t)) (1 + c exp(d g) + e cos^2 g), scaled to a level.

    a darkens or brightens the horizon, b < 0 its gradient, c the circumsolar region, d its width, e the backscatter.
    Level: zenith_luminance, cd m-2, or illuminance (diffuse, horizontal), lx (Perez et al. 1993). The letters
    broadcast with the sun's leading axes. Where the formula falls below 0 the sky is black.

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
    zenith_luminance: Any = field(default=None, kw_only=True)
    illuminance: Any = field(default=None, kw_only=True)
    ranges: ClassVar = {"b": Range(-float("inf"), 0.0)}  # else exp(b / cos t) has no bound at the horizon
    source: ClassVar[str] = "Perez, Seals and Michalsky 1993"

    def __post_init__(self) -> None:
        """Validate only."""
        require_one_level("Perez", self.zenith_luminance, self.illuminance)
        super().__post_init__()

    def coefficients(self) -> Array:
        """R A ... I of the one channel, shape (..., 1, 10)."""
        a, c, d, e = (floating(value, like=self.sun) for value in (self.a, self.c, self.d, self.e))
        relative = from_perez(constant(1.0, self.sun), a, self.parameter("b"), c, d, e)
        return levelled(relative, self.sun, self.zenith_luminance, self.illuminance)
