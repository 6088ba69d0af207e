"""Light on a plane among obstructions: sky through the visible intervals of bands, sun, and light from faces."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.dome.integrals import discs_and_rest, extended, in_library_of, points_of
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array, as_numpy, constant, namespace
from skydome.ground.directions import ZENITH, tangent_frame
from skydome.ground.labels import Parts
from skydome.light.spectrum import Spectrum
from skydome.skies.labelled import outer_labels
from skydome.skies.sky import Sky
from skydome.skies.suns.sun_disc import SunDisc
from skydome.surroundings.bands import Bands
from skydome.surroundings.channels import channelled, channels_asked, check_shares
from skydome.surroundings.intervals import SKY, Intervals, Surroundings, intervals, refined
from skydome.surroundings.light_kinds import LUX, LightKind

DISC_POINTS = 61
TOLERANCE = 3e-4


@dataclass(frozen=True, eq=False)
class Received(Parts):
    """Light on a plane, lx: from the `sky`, the `sun`'s disc, and `reflected`; each (...,), the sky's leading axes.

    In another kind of light, its unit, and (..., C).

    >>> float(Received(np.array(900.0), np.array(2000.0), np.array(100.0)).total)
    3000.0
    """

    sky: Array
    sun: Array
    reflected: Array

    @property
    def total(self) -> Array:
        """All of it."""
        return self.sky + self.sun + self.reflected


@dataclass(frozen=True, eq=False)
class PlaneView:
    """What one plane sees, ready for any sky: found once, used for a year.

    `directions` (M, 3) and `weights` (M,), projected solid angles, of the visible sky; `labels` (K,) of what else is
    seen and its `factors` (K,): the illuminance that each gives per unit of its luminance, pi x form factor.

    >>> import skydome as sd
    >>> view = PlaneView.of(sd.Horizon.level(30 * sd.deg))
    >>> round(view.sky_view_factor, 3)
    0.75
    >>> year = sd.Uniform(np.array([1000.0, 2000.0])[:, None])
    >>> view.receive(year).total.shape
    (2,)
    """

    normal: np.ndarray
    surroundings: Surroundings
    directions: np.ndarray
    weights: np.ndarray
    labels: np.ndarray
    factors: np.ndarray

    @classmethod
    def of(
        cls,
        surroundings: Surroundings,
        normal: ArrayLike = ZENITH,
        bands: "int | Bands" = 64,
        tolerance: float = TOLERANCE,
    ) -> "PlaneView":
        """The view of a plane facing `normal` (3,) through `bands`: bands laid out for it, or how many to begin with.

        In the second case bands are halved until what is seen changes by less than `tolerance` across each.
        """
        if not isinstance(bands, Bands):
            bands = refined(surroundings, Bands.of(normal, bands), tolerance)
        found = intervals(surroundings, bands)
        open_sky = found.of(SKY)
        directions, weights, _ = bands.nodes(open_sky.band, open_sky.first, open_sky.last)
        labels, owner = np.unique(found.label, return_inverse=True)
        factors = np.bincount(owner, uniform_between(bands, found), len(labels))
        rest = labels != SKY
        return cls(bands.normal, surroundings, directions, weights, labels[rest], factors[rest])

    @property
    def sky_view_factor(self) -> float:
        """Share of the light of a uniform sky that would fall on the plane if sky were all around, in [0, 1]."""
        return float(self.weights.sum() / np.pi)

    def from_sky(self, sky: Sky, light: LightKind = LUX) -> Array:
        """Illuminance from the visible sky and its stars, no sun's discs, lx, shape (...,): the sky's leading axes."""
        rest = discs_and_rest(sky)[1]
        total: Array = 0.0
        for part in extended(rest):
            total = total + light.weighted(light.toward(part, in_library_of(self.directions, part)), self.weights)
        for lights, factor in points_of(rest):
            seen = self.surroundings.seen(np.asarray(lights.directions)) < 0
            total = total + light.points_on(lights, self.normal, seen * factor)
        return total

    def from_sun(self, sky: Sky, light: LightKind = LUX) -> Array:
        """Illuminance from the unobstructed part of the sun's discs, lx, shape (...,)."""
        total: Array = 0.0
        for disc, factor in discs_and_rest(sky)[0]:
            share = in_library_of(visible_share(disc, self.surroundings), disc)
            total = total + light.sun_on(disc, self.normal, share * factor)
        return total

    def from_faces(self, luminances: "dict[int, Any]") -> Array:
        """Illuminance from faces of uniform luminance, cd m-2, by label ((15.54) with L0 the face's), lx."""
        total: Array = 0.0
        for label, factor in zip(self.labels, self.factors, strict=True):
            total = total + luminances.get(int(label), 0.0) * factor
        return total

    @outer_labels("", channels_asked)
    def receive(
        self,
        sky: Sky,
        luminances: "dict[int, Any] | None" = None,
        albedo: ArrayLike | Spectrum = 0.0,
        light: LightKind = LUX,
    ) -> Received:
        """The light on the plane. Labels without a luminance shine as ground of `albedo` under the open sky.

        `light` says in what it is counted: LightInRGB(), LightInWavelengths([450.0, 550.0]); `albedo` may then differ
        by channel, and `luminances` have channels last.
        """
        received, sun = self.from_sky(sky, light), self.from_sun(sky, light)
        reflected: Array = self.from_faces(luminances) if luminances else 0.0
        ground = channelled(albedo, light)
        if ground.any():
            known = luminances or {}
            rest = sum(f for label, f in zip(self.labels, self.factors, strict=True) if int(label) not in known)
            falling = light.on_level(sky)
            reflected = reflected + falling * constant(ground / np.pi * rest, falling)
        return Received(received, shaped_like(sun, received), shaped_like(reflected, received))


def shaped_like(light: Any, other: Any) -> Array:
    """No light (the number 0) as zeros of the other's shape; anything else as it is."""
    if hasattr(light, "shape") or not hasattr(other, "shape"):
        return light
    return namespace(other).zeros_like(other)


def uniform_between(bands: Bands, found: Intervals) -> np.ndarray:
    """E_k(last) - E_k(first) of each interval under luminance 1, lx, (I,) (15.54)."""
    own: np.ndarray = bands.weights[found.band] / 2 * (antiderivative(found.last) - antiderivative(found.first))
    return own


def antiderivative(alpha: np.ndarray) -> np.ndarray:
    """alpha - cos alpha sin alpha: twice the integral of sin^2 from 0."""
    value: np.ndarray = alpha - np.cos(alpha) * np.sin(alpha)
    return value


def visible_share(disc: SunDisc, surroundings: Surroundings) -> np.ndarray:
    """Share of each sun's disc that no face hides, shape of the suns' leading axes."""
    return share_of_disc(as_numpy(disc.sun).astype(np.float64), as_numpy(disc.angular_radius), surroundings)


def share_of_disc(sun: np.ndarray, radius: ArrayLike, surroundings: Surroundings) -> np.ndarray:
    """Share of suns' discs that no face hides, of suns (..., 3) and radii (...,), radians: 61 points spread evenly."""
    size = np.asarray(radius, dtype=np.float64)[..., None, None]
    k = np.arange(DISC_POINTS)
    reach, turn = np.sqrt((k + 0.5) / DISC_POINTS), k * np.pi * (3 - np.sqrt(5.0))
    u, v = (edge[..., None, :] for edge in tangent_frame(sun))
    around = np.cos(turn)[:, None] * u + np.sin(turn)[:, None] * v
    points = sun[..., None, :] + np.tan(size) * reach[:, None] * around
    points = points / np.linalg.norm(points, axis=-1, keepdims=True)
    return np.asarray((surroundings.seen(points) < 0).mean(axis=-1))


@outer_labels("", channels_asked)
def obstructed_illuminance(
    sky: Sky,
    surroundings: Surroundings,
    normal: ArrayLike = ZENITH,
    *,
    bands: "int | Bands" = 64,
    luminances: "dict[int, Any] | None" = None,
    albedo: ArrayLike | Spectrum = 0.0,
    light: LightKind = LUX,
) -> Received:
    """Light on a plane facing `normal` (3,) among surroundings, lx: `.sky`, `.sun`, `.reflected` and their `.total`.

    `luminances`, cd m-2, by the surroundings' labels; what has none reflects as ground of `albedo` (0-1) under the
    open sky. `light` counts it in colour: LightInXYZ(), LightInRGB(), LightInWavelengths([450.0, 550.0]), with the
    channels last and an albedo for each if wanted (or a `Spectrum`). For many skies make `PlaneView.of(...)` once.
    ValueError for an albedo outside [0, 1]; TypeError for a sky without colour where colour is asked for.

    >>> import skydome as sd
    >>> received = obstructed_illuminance(sd.Uniform(1000.0), sd.Horizon.level(30 * sd.deg))
    >>> bool(abs(received.total / (1000 * np.pi * 0.75) - 1) < 1e-3)
    True
    >>> blue = sd.HosekWilkie(sd.direction(2.0, 0.7), turbidity=3.0)
    >>> obstructed_illuminance(blue, sd.Horizon.level(0.5), light=sd.LightInRGB()).total.shape
    (3,)
    """
    require_kind(light, LightKind, "light", "LightInXYZ()")
    require_kind(luminances, dict | None, "luminances", "{0: 500.0}")
    require_kind(surroundings, Surroundings, "surroundings", "Horizon.level(30 * deg)")
    check_shares("albedo", albedo)
    return PlaneView.of(surroundings, normal, bands).receive(sky, luminances, albedo, light)
