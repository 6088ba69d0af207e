"""What the skies of an `Atmosphere` share: the air, its ground, and how bright its sun is."""

import math
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.gases.skylight import skylight_share
from skydome.air.phase_laws import PhaseLaw
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array, at_least, constant, floating, is_numpy
from skydome.light.spectrum import xyz_weights
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.sky import SunlitSky


@dataclass(frozen=True, eq=False)
class AtmosphereSky(SunlitSky, SpectralSky):
    """The sky of an `atmosphere` under a sun: what discrete ordinates, Nishita's integrals and path tracing solve."""

    atmosphere: Atmosphere = field(default_factory=Atmosphere.standard)
    kinds: ClassVar = {"atmosphere": (Atmosphere, "Atmosphere.from_turbidity(3.0)")}
    takes_layers: ClassVar[bool] = False
    """Whether the air may have edges, as a layer of cloud has."""
    takes_many_airs: ClassVar[bool] = False
    """Whether the air's numbers may be arrays (...,), and they and the sun torch's or JAX's."""

    def __post_init__(self) -> None:
        super().__post_init__()
        require_kind(self.atmosphere, Atmosphere, "atmosphere", "Atmosphere.standard()")
        if not self.takes_layers:
            self.atmosphere.require_no_layers(type(self).__name__)
        if not self.takes_many_airs:
            self.atmosphere.require_one(type(self).__name__)
            if not is_numpy(self.sun):
                raise TypeError(
                    f"{type(self).__name__} takes a sun of NumPy's, got torch's or JAX's; PhysicalSky takes those"
                )

    def once_per_phase(self, views: np.ndarray, wavelengths: np.ndarray) -> Array | None:
        """What each constituent scatters once toward views (D, 3), per phase function, for a sun of irradiance 1,
        (K, D, W), where the sky knows it better than quadrature along the rays; None elsewhere.
        """
        return None

    @property
    def laws(self) -> list[PhaseLaw]:
        """The constituents' phase laws."""
        return [part.phase_law for part in self.atmosphere.constituents]

    @property
    def held_laws(self) -> list[PhaseLaw]:
        """The phase laws whose light a table of this sky keeps apart."""
        return self.laws

    @property
    def far_air(self) -> Atmosphere:
        """The air itself."""
        return self.atmosphere

    @property
    def albedo(self) -> Any:
        """The ground's, a number or a `Spectrum`."""
        return self.atmosphere.albedo

    @property
    def is_single(self) -> bool:
        """Whether there is one sun, and one air."""
        return self.one_sun and self.atmosphere.is_one

    @property
    def seen_sun(self) -> Array:
        """The sun (..., 3) where it is seen: the middle of its glow."""
        return floating(self.sun)

    def tell_missing_bands(self, wavelengths: Any) -> None:
        """A warning where `wavelengths` ask for bands of gases that the air lacks; colours, with `bands`, are none."""
        if wavelengths is not self.bands:
            self.atmosphere.tell_missing_bands(wavelengths)

    def sunlight(self, directions: Array, wavelengths: Any) -> Array:
        """What light for a sun of irradiance 1 is multiplied by, W m-2 nm-1, (..., W), or (W,) for all views at once.

        The sun's irradiance above the air, less what the air's gases take of the light from directions (..., 3).
        """
        light, gases = self.atmosphere.sun_at(wavelengths), self.atmosphere.gases
        if gases is None:
            return light
        share = skylight_share(gases, floating(self.sun, like=directions)[..., 2], directions[..., 2], wavelengths)
        return share * constant(light, share)

    @property
    def sun_distance(self) -> float:
        """Distance of the sun, AU, that the atmosphere's `sun_scale` tells."""
        return 1.0 / math.sqrt(self.atmosphere.sun_scale)

    @property
    def direct_normal_illuminance(self) -> Array | float:
        """Illuminance of the sun through this air on a plane that faces it, lx, shape (...,); 0 when it has set."""
        cosine, bands = np.asarray(self.sun, dtype=np.float64)[..., 2], SpectralSky.bands
        light = self.atmosphere.transmittance(at_least(cosine, 0.0), bands) * self.atmosphere.sun_at(bands)
        level = np.where(cosine > 0, (light @ xyz_weights(bands))[..., 1], 0.0)
        return float(level) if self.one_sun else level
