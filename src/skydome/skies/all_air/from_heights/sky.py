"""The sky, the haze below and the ground, seen from a height."""

from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar, Self

import numpy as np

from skydome.air.rays import ColumnTable
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array
from skydome.skies.all_air.from_heights.blunted import BluntedAir
from skydome.skies.all_air.from_heights.diffuse_field import TERMS, DiffuseField
from skydome.skies.all_air.spectral_nodes import NODES
from skydome.skies.physical.precomputed.tabled_sky import TabledSky


@dataclass(frozen=True, eq=False)
class SkyFromHeight(TabledSky):
    """The sky of an `atmosphere` seen from a `height` above the ground, m, with haze and ground below the horizon.

    Light scattered once is worked out along each view, in round shells; the rest by the moments of the light inside
    the air, and the ground shines by its albedo under sun and sky. The `field` serves all suns, views and heights
    (`SkyFromHeight.by`). For suns of 5 degrees or more within 2 % rms; docs/models/heights.md. Rays are straight.

    >>> import skydome as sd
    >>> field = sd.DiffuseField.of(sd.Atmosphere.standard(), [450.0, 650.0])
    >>> sky = SkyFromHeight.by(field, sd.direction(azimuth=180 * sd.deg, elevation=40 * sd.deg), height=10_000.0)
    >>> views = sd.direction(azimuth=0.0, elevation=np.array([90.0, 10.0, -10.0, -90.0]) * sd.deg)
    >>> sky.radiance(views, [450.0, 650.0]).shape
    (4, 2)
    """

    field: DiffuseField | None = None
    kinds: ClassVar = {"field": (DiffuseField | None, "DiffuseField.of(atmosphere, wavelengths)")}
    lowest_sun: ClassVar[float] = -4.0
    source: ClassVar[str] = "single scattering by quadrature, higher orders by Legendre moments of the light inside"

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.field is not None and self.field.atmosphere is not self.atmosphere:
            raise ValueError("field must be that of the sky's atmosphere: use SkyFromHeight.by(field, sun)")

    @classmethod
    def by(cls, field: DiffuseField, sun: Array, height: float = 0.0) -> Self:
        """The sky of a sun (..., 3) by a field, seen from a height above the ground, m."""
        require_kind(field, DiffuseField, "field", "DiffuseField.of(atmosphere, wavelengths)")
        return cls(sun, field.atmosphere, height, field)

    @cached_property
    def known(self) -> DiffuseField:
        """The field given, or the sky's own."""
        return self.field or DiffuseField.of(self.atmosphere, NODES)

    @property
    def columns(self) -> ColumnTable:
        """Columns of the air, the field's."""
        return self.known.columns

    def depths(self, wavelengths: np.ndarray) -> np.ndarray:
        """Vertical optical depths of the constituents, less what goes straight on, (K, W)."""
        return BluntedAir.of(self.atmosphere, wavelengths, TERMS).depths
