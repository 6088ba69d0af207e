"""A layer of cloud in the air: so deep at 550 nm, so high, of droplets or crystals of so large a radius."""

from dataclasses import dataclass, field
from typing import Any, ClassVar

from numpy.typing import ArrayLike

from skydome.air.clouds.particles import CloudOptics, CloudParticles, Water
from skydome.air.constituents import DEPTH, Constituent
from skydome.air.phase_laws import PhaseLaw
from skydome.air.profiles import Slab
from skydome.ground.arrays import Array, constant, floating
from skydome.ground.limits.ranges import Range, require


@dataclass(frozen=True)
class Cloud(Constituent):
    """An even layer of cloud of vertical `optical_depth` at 550 nm, from `base` up, `thickness` m thick.

    `kind`: `Water()`, `Ice()` or `HexagonalIce()`, which has halos; `effective_radius` in m, 4-25 um for water, 13-130
    and 10-200 um for ice (None: 10 and 30 um).

    >>> import skydome as sd
    >>> air = sd.Atmosphere((*sd.Atmosphere.standard().constituents, Cloud(12.0, base=800.0, thickness=600.0)))
    >>> air.depth([550.0]).round(1).tolist()
    [12.2]
    """

    optical_depth: Any = 10.0
    base: float = 1000.0
    thickness: float = 500.0
    effective_radius: float | None = None
    kind: CloudParticles = field(default_factory=Water)
    bounds: ClassVar = {
        "optical_depth": DEPTH,
        "base": Range(0.0, 30_000.0, "m"),
        "thickness": Range(1.0, 30_000.0, "m"),
        "effective_radius": Range(1e-6, 1e-3, "m"),
    }
    kinds: ClassVar = {"kind": (CloudParticles, "Water()")}

    def __post_init__(self) -> None:
        super().__post_init__()
        require("effective_radius", self.radius, self.kind.radii)

    @property
    def radius(self) -> float:
        """The effective radius, m."""
        return self.kind.usual_radius if self.effective_radius is None else self.effective_radius

    @property
    def profile(self) -> Slab:  # type: ignore[override]
        """Even from the base to the top."""
        return Slab(self.base, self.base + self.thickness)

    def optics(self, wavelengths: ArrayLike) -> CloudOptics:
        """What its particles do to light at wavelengths (W,) nm, each (W,)."""
        return self.kind.optics(self.radius, wavelengths)

    def depth(self, wavelengths: ArrayLike) -> Array:
        """The depth at 550 nm, times the particles' extinction over that there."""
        depth = floating(self.optical_depth)[..., None]
        return depth * constant(self.optics(wavelengths).extinction, depth)

    def scattered(self, wavelengths: ArrayLike) -> Array:
        """The particles' single scattering albedo."""
        return self.optics(wavelengths).albedo

    @property
    def phase_law(self) -> PhaseLaw:
        """The particles'."""
        return self.kind.phase_law(self.radius)
