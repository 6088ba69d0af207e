"""Ward-Larson's fog, the older form of aerial perspective, as Preetham 1999, section 5 compares itself with it."""

from dataclasses import dataclass
from typing import Any

from skydome.ground.arrays import Array, constant, is_numpy, namespace
from skydome.ground.directions import ZENITH, checked_directions
from skydome.scene.aerial_perspective import AerialPerspective, AirLight, checked
from skydome.scene.aerial_perspective_integrals import Ray, optical_depth

KILOMETRE = 1000.0


@dataclass(frozen=True, eq=False)
class WardLarson:
    """Air that looks the same in every direction: right at one kilometre, exponential elsewhere, lit by the zenith.

    tau(s) = tau(1 km)^(s / 1 km) of a level ray; in-scattered light = the zenith's radiance x (1 - tau). `air` gives
    the extinction, the zenith and the channels (RGB or wavelengths).

    >>> import skydome as sd
    >>> from skydome.scene.aerial_perspective import AirLight
    >>> sun = sd.direction(azimuth=250 * sd.deg, elevation=20 * sd.deg)
    >>> fog = WardLarson(AirLight(sd.Preetham(sun, turbidity=3.0)))
    >>> east, west = (fog.at(5000.0, view).inscattered for view in (sd.EAST, sd.WEST))
    >>> bool((east == west).all())
    True
    """

    air: AirLight

    @property
    def ambient(self) -> Array:
        """The zenith's light without the sun, (C,)."""
        total: Array = 0.0
        for part in self.air.parts[1]:
            if self.air.wavelengths is None:
                total = total + part.rgb(constant(ZENITH, self.air.like))  # type: ignore[attr-defined]
            else:
                total = total + self.air.channels.sky_light(part, constant(ZENITH, self.air.like))
        return total

    def at(self, distance: Any, direction: Any, height: Any = 0.0) -> AerialPerspective:
        """Transmittance and in-scattered light, each (..., C), of rays of `distance` m from `height` m."""
        direction = checked_directions(direction, "direction")
        distance, height = checked(distance, direction, "distance", 0.0), checked(height, direction, "height")
        xp = namespace(direction, distance)
        level = direction[..., 2] * 0
        kilometre = xp.zeros_like(level) + KILOMETRE
        rays = xp.broadcast_arrays(kilometre, level, height)
        depth = optical_depth(Ray.at(*rays), self.air.coefficients(direction))
        tau = xp.exp(-depth * (distance / KILOMETRE)[..., None])
        ambient = self.ambient
        return AerialPerspective(tau, (1 - tau) * (constant(ambient, tau) if is_numpy(ambient) else ambient))
