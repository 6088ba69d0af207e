"""Ward-Larson's fog, the older form of aerial perspective, as Preetham 1999, section 5 compares itself with it."""

from dataclasses import dataclass

import numpy as np

from skydome.ground.arrays import Array, constant, is_numpy, namespace
from skydome.ground.directions import ZENITH, checked_directions
from skydome.haze.aerial_perspective import AerialPerspective, AirLight
from skydome.haze.integrals import Ray, checked_metres, optical_depth
from skydome.haze.light import sky_nodes

KILOMETRE = 1000.0


@dataclass(frozen=True, eq=False)
class WardLarson:
    """Air that looks the same in every direction: right at one kilometre, exponential elsewhere, lit by the zenith.

    tau(s) = tau(1 km)^(s / 1 km) of a level ray; in-scattered light = the zenith's radiance x (1 - tau), as Preetham
    1999, section 5 has it. `air` gives the extinction, the sky and the channels (RGB or wavelengths).

    >>> import skydome as sd
    >>> from skydome.haze.aerial_perspective import AirLight
    >>> sun = sd.direction(azimuth=250 * sd.deg, elevation=20 * sd.deg)
    >>> fog = WardLarson(AirLight(sd.Preetham(sun, turbidity=3.0)))
    >>> east, west = (fog.at(5000.0, view).inscattered for view in (sd.EAST, sd.WEST))
    >>> bool((east == west).all())
    True
    """

    air: AirLight

    def lit_from(self) -> tuple[np.ndarray, np.ndarray]:
        """Directions (N, 3) of the sky that lights the fog, and their weights (N,), which sum to 1."""
        return np.asarray(ZENITH)[None, :], np.ones(1)

    @property
    def ambient(self) -> Array:
        """The light of fog without end: the sky's where it is `lit_from`, without the sun, (C,)."""
        directions, weights = self.lit_from()
        views = constant(directions, self.air.like)
        total: Array = 0.0
        for part in self.air.parts[1]:
            rgb = self.air.wavelengths is None
            light = part.rgb(views) if rgb else self.air.channels.sky_light(part, views)  # type: ignore[attr-defined]
            total = total + constant(weights, light) @ light
        return total

    def at(self, distance: Array, direction: Array, height: Array = 0.0) -> AerialPerspective:
        """Transmittance and in-scattered light, each (..., C), of rays of `distance` m from `height` m."""
        direction = checked_directions(direction, "direction")
        distance, height = (
            checked_metres(distance, direction, "distance", 0.0),
            checked_metres(height, direction, "height"),
        )
        xp = namespace(direction, distance)
        level = direction[..., 2] * 0
        kilometre = xp.zeros_like(level) + KILOMETRE
        length, level, above = xp.broadcast_arrays(kilometre, level, height)
        ray = Ray.at(length, level, above, self.air.air.decays)
        depth = optical_depth(ray, self.air.coefficients(direction))
        tau = xp.exp(-depth * (distance / KILOMETRE)[..., None])
        ambient = self.ambient
        return AerialPerspective(tau, (1 - tau) * (constant(ambient, tau) if is_numpy(ambient) else ambient))


@dataclass(frozen=True, eq=False)
class WardLarsonMeanSky(WardLarson):
    """The same fog lit by the mean radiance of the whole sky, which is nearer to what Radiance calls ambient light.

    Preetham 1999, section 5 takes the zenith as its "best estimate for setting the ambient in-scattering term suggested
    by Ward-Larson". The zenith is the bluest of a low sun's sky; the mean is not.

    >>> import skydome as sd
    >>> air = sd.AirLight(sd.Preetham(sd.direction(azimuth=250 * sd.deg, elevation=5 * sd.deg), turbidity=6.0))
    >>> zenith, mean = WardLarson(air).ambient, WardLarsonMeanSky(air).ambient
    >>> bool(mean[2] / mean[0] < zenith[2] / zenith[0])
    True
    """

    def lit_from(self) -> tuple[np.ndarray, np.ndarray]:
        """The nodes of the hemisphere by their solid angles."""
        directions, solid_angles = sky_nodes()
        return directions, solid_angles / (2 * np.pi)
