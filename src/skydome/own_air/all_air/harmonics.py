"""From the light at each height to what the air gives off: Fourier series in azimuth, Legendre functions in height."""

from dataclasses import dataclass

import numpy as np

from skydome.ground.extras import required
from skydome.ground.quadrature import crowded
from skydome.own_air.all_air.places import Places
from skydome.own_air.all_air.shells import RADIUS


@dataclass(frozen=True, eq=False)
class Harmonics:
    """Light along rays (heights, J) in, a source on the views of `Places` out."""

    places: Places
    cosines: np.ndarray
    """Of the rays to the vertical, (heights, J): they part at the horizon of each height."""
    solid: np.ndarray
    """Their weights, (heights, J)."""
    analysis: np.ndarray
    """(heights, moments m, moments l, J)."""
    synthesis: np.ndarray
    """(moments m, views, moments l)."""
    fourier: np.ndarray
    """From values at azimuths to cosine coefficients, (moments, azimuths)."""
    waves: np.ndarray
    """And back, (azimuths, moments)."""

    @classmethod
    def of(cls, places: Places) -> "Harmonics":
        """The matrices of a grid."""
        cosines, solid = (np.stack(p) for p in zip(*(ray_nodes(h, places) for h in places.height_nodes), strict=True))
        count = places.moments
        analysis = np.moveaxis(legendre(cosines, count) * solid, 2, 0)
        synthesis = legendre(np.cos(places.view_nodes), count).transpose(0, 2, 1)
        m, x = np.arange(count), np.linspace(0, np.pi, places.azimuths)
        step = (1 - 0.5 * np.cos(x)) * np.pi / (places.azimuths - 1)
        step[[0, -1]] *= 0.5
        waves = np.cos(np.outer(m, places.azimuth_nodes))
        fourier = waves * step * np.where(m == 0, 1, 2)[:, None] / np.pi
        arrays = (np.ascontiguousarray(part, np.float32) for part in (analysis, synthesis, fourier, waves.T))
        return cls(places, cosines, solid, *arrays)

    def source(self, light: np.ndarray, moments: np.ndarray, steepness: np.ndarray) -> np.ndarray:
        """What light (N, suns, azimuths, AIRS) makes air of moments (heights, moments, AIRS) give off, by the norm."""
        places = self.places
        suns, count, airs = places.suns, places.moments, light.shape[-1]
        lit = light.reshape(places.heights, -1, suns, places.azimuths, airs)
        out = np.empty((places.heights, places.views, suns, places.azimuths, airs), np.float32)
        for i, own in enumerate(lit):
            series = np.matmul(self.fourier, own).transpose(2, 0, 1, 3).reshape(count, -1, suns * airs)
            found = np.matmul(self.analysis[i], series).reshape(count, count, suns, airs) * moments[i][None, :, None]
            seen = np.matmul(self.synthesis, found.reshape(count, count, -1)).reshape(count, -1, suns, airs)
            seen *= np.exp(-steepness[i]).astype(np.float32)[:, None]
            out[i] = np.matmul(self.waves, np.ascontiguousarray(seen.transpose(1, 2, 0, 3)))
        return out

    def irradiance(self, light: np.ndarray) -> np.ndarray:
        """On the ground, (suns, AIRS)."""
        up = self.cosines[0] > 0
        first = light.reshape(self.places.heights, -1, *light.shape[1:])[0][up]
        flow = (self.cosines * self.solid)[0][up]
        return np.asarray(2 * np.pi * np.einsum("j,p,jspb->sb", flow, self.fourier[0], first, optimize=True))


def ray_nodes(height: float, places: Places) -> tuple[np.ndarray, np.ndarray]:
    """Cosines of rays and weights, (J,), that crowd at the horizon as seen from a height."""
    horizon = -np.sqrt(1 - (RADIUS / (RADIUS + height)) ** 2)
    (up, w), (down, v) = crowded(places.rising), crowded(places.falling)
    cosines = np.concatenate([(horizon - (1 + horizon) * down)[::-1], horizon + (1 - horizon) * up])
    return cosines, np.concatenate([(v * (1 + horizon))[::-1], w * (1 - horizon)])


def legendre(cosine: np.ndarray, count: int) -> np.ndarray:
    """Associated Legendre functions whose squares integrate to 1, (m, l, ...): 0 where l < m."""
    required("scipy", "fit", "the physical sky's teacher")
    from scipy.special import gammaln, lpmv

    out = np.zeros((count, count, *cosine.shape))
    for m in range(count):
        for order in range(m, count):
            size = 0.5 * (np.log((2 * order + 1) / 2) + gammaln(order - m + 1) - gammaln(order + m + 1))
            out[m, order] = np.exp(size) * lpmv(m, order, cosine)
    return out
