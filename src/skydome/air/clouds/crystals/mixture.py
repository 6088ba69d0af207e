"""Traced light of a mixture of prisms: the table of `scripts/make_ice_crystals.py`, by wavelength and size."""

from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np

from skydome.air.clouds.crystals.diffraction import spread
from skydome.air.clouds.crystals.halos import TRACED, drawn_out
from skydome.air.clouds.crystals.prism import Prism
from skydome.ground.interpolation import weights
from skydome.ground.tables import archive, columns
from skydome.light.spectrum import interpolated

KEPT = np.array([0, 2, 3, 4])
"""Of the table's absorptions those with a phase function."""
BEAM = 0.44
"""Radius, in sides, of a disc that spreads light as the beam of the 22 degree halo does: a strip .756 sides wide."""


MIDDLES = (np.arange(1800) + 0.5) / 10
"""Even angles for means, degrees."""


@dataclass(frozen=True)
class Mixture:
    """Prisms of an `aspect`, a share `smooth` of their area with plane faces, the others of a `roughness`."""

    aspect: float
    roughness: float
    smooth: float

    @cached_property
    def shares(self) -> np.ndarray:
        """Of the table's prisms, (aspects, roughnesses)."""
        table = archive("ice_crystals")
        rough = weights(table["roughness"], np.asarray(self.roughness)) * (1 - self.smooth)
        rough[0] += self.smooth
        return np.outer(weights(np.log(table["aspect"]), np.log(np.asarray(self.aspect))), rough)

    @property
    def sizes(self) -> tuple[float, float]:
        """Radii of discs of the mean projected area and of the beam that makes the halo, over the effective radius."""
        prism = Prism(self.aspect)
        return np.sqrt(prism.mean_area / np.pi) / prism.effective_radius, BEAM / prism.effective_radius

    def mean(self, name: str) -> np.ndarray:
        """Of a table by index and absorption, (K, A, ...)."""
        return np.tensordot(self.shares, archive("ice_crystals")[name].astype(np.float64), axes=2)

    @cached_property
    def logarithms(self) -> np.ndarray:
        """Of the light that is turned, sr-1 over the sunlight, at `TRACED`, (K, KEPT, T)."""
        table = archive("ice_crystals")
        whole = (1 - table["absorbed"].astype(np.float64) - table["straight"])[..., KEPT, None]
        light = np.tensordot(self.shares, np.exp(logarithms()) * whole, axes=2)
        return np.asarray(np.log(light))

    def absorbed(self, radius: float, wavelengths: np.ndarray) -> np.ndarray:
        """Share of the light that enters, (W,), for an effective radius, m."""
        known = archive("ice_crystals")["absorption"][1:]
        index, absorption = ice(radius, wavelengths)
        lost = np.log(self.mean("absorbed")[:, 1:] / known)
        at = weights(np.log(known), np.log(np.clip(absorption, known[0], known[-1])))
        return np.asarray(absorption * np.exp(np.einsum("wk,wa,ka->w", by_index(index), at, lost)))

    def straight(self, radius: float, wavelengths: np.ndarray) -> np.ndarray:
        """Share that goes straight on through parallel faces, (W,)."""
        known, (index, absorption) = archive("ice_crystals")["absorption"], ice(radius, wavelengths)
        logarithms = np.log(np.maximum(self.mean("straight"), 1e-12))
        found = np.einsum("wk,wa,ka->w", by_index(index), by_absorption(known, absorption), logarithms)
        return np.asarray(np.exp(found))

    def turned(self, radius: float, wavelengths: np.ndarray, degrees: np.ndarray) -> np.ndarray:
        """Light that is turned by angles (D,), sr-1 over the sunlight up to a factor by wavelength, (D, W)."""
        index, absorption = ice(radius, wavelengths)
        rows = np.einsum(
            "wk,wa,kat->wt",
            by_index(index),
            by_absorption(archive("ice_crystals")["absorption"][KEPT], absorption),
            self.logarithms,
        )
        drawn = (drawn_out(degrees, n) for n in index)
        return np.stack([np.exp(np.interp(at, TRACED.knots, row)) for at, row in zip(drawn, rows, strict=True)], axis=1)

    def mean_cosine(self, radius: float, wavelengths: np.ndarray) -> np.ndarray:
        """Of all light that is scattered, (W,): rays spread by diffraction, and the peak."""
        peak, ray = (spread(2 * np.pi * radius / (wavelengths * 1e-9) * size, 2)[1] for size in self.sizes)
        light = self.turned(radius, wavelengths, MIDDLES) * np.sin(np.radians(MIDDLES))[:, None]
        ray = ray * (np.cos(np.radians(MIDDLES)) @ light) / light.sum(axis=0)
        straight, lost = self.straight(radius, wavelengths), self.absorbed(radius, wavelengths)
        return np.asarray(((1 + straight) * peak + (1 - lost - straight) * ray) / (2 - lost))


@cache
def logarithms() -> np.ndarray:
    """Of the table's phase functions, (aspects, roughnesses, K, KEPT, T); the last index dims as the one before."""
    phase, dimmed = (np.cumsum(archive("ice_crystals")[name], axis=-1) / 100 for name in ("phase", "dimmed"))
    more = np.concatenate([0 * dimmed[:, :, :, :1], dimmed], axis=3)
    return np.asarray(phase[:, :, :, None] + more[:, :, [0, 1, 1]])


def ice(radius: float, wavelengths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Refractive index of ice, and 4 pi k r / wavelength for an effective radius, m, each (W,)."""
    table = columns("ice_index")
    n = interpolated(wavelengths, table["wavelength_nm"], table["n"])
    k = np.exp(interpolated(wavelengths, table["wavelength_nm"], np.log(table["k"])))
    return n, 4 * np.pi * k * radius / (wavelengths * 1e-9)


def by_index(index: np.ndarray) -> np.ndarray:
    """Weights (W, K) of the table's indices."""
    return np.asarray(weights(archive("ice_crystals")["index"], index))


def by_absorption(known: np.ndarray, absorption: np.ndarray) -> np.ndarray:
    """Weights (W, A) of absorptions, held beyond the last."""
    return np.asarray(weights(known, np.minimum(absorption, known[-1])))
