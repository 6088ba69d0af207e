"""The picture of one bright source in the eye, or as a plain disc: exact far below the size of a pixel."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from skydome.eye.bright_source import BrightSource
from skydome.eye.point_spread import FIELD, PointSpread, cap, ring_weights, rings
from skydome.eye.streaks import Needles, halo_colours
from skydome.ground.directions import angle_between, tangent_frame
from skydome.ground.units import deg
from skydome.light.colour import SRGB, RGBSpace
from skydome.maps.projection import texel_centre

AFAR = 24.0  # radii of a disc from its middle, where it begins to count as a point
HALO_ANGLES = np.arange(1.5, 5.0, 0.02) * deg
CHUNK = 1 << 16
NEAR = 4.0  # pixels from the edge of the disc within which a pixel is divided

Toward = Callable[[np.ndarray, np.ndarray], np.ndarray]
"""Unit vectors (..., 3) of continuous pixel coordinates (row, column)."""


def steps_of_angle(radius: float) -> tuple[np.ndarray, np.ndarray]:
    """Angles up to AFAR radii at which a disc's glow is worked out (A,), and distances (T,) by which it is summed."""
    far = AFAR * radius
    edge = radius * np.geomspace(1e-3, 0.5, 24)
    angle = np.concatenate([[0.0], edge, radius - edge, [radius], radius + edge, np.geomspace(1.52 * radius, far, 160)])
    steps = np.concatenate([[0.0], np.geomspace(1e-3, 1, 300) * radius, np.arange(1.02, AFAR + 1.1, 0.05) * radius])
    return np.unique(angle), steps


def share_of_circle(angle: np.ndarray, distance: np.ndarray, radius: float) -> np.ndarray:
    """How much of a circle of radius `distance` (T,), drawn about points `angle` (A, 1) from a disc's middle, is in it.

    By the cosine law on the sphere; `radius` is the disc's. Shape (A, T), 0..1.
    """
    across = np.sin(angle) * np.sin(distance)
    opening = np.cos(radius) - np.cos(angle) * np.cos(distance)
    cosine = np.clip(opening / np.where(across == 0, 1.0, across), -1.0, 1.0)
    share: np.ndarray = np.where(across == 0, np.maximum(angle, distance) <= radius, np.arccos(cosine) / np.pi)
    return share


def disc_glow(spread: PointSpread, radius: float, halo: float = 0.0, space: RGBSpace = SRGB) -> tuple[np.ndarray, ...]:
    """Angles (A,) from the middle of a disc and its glow there per lux, sr^-1, for red, green and blue (A, 3).

    Near the disc the spread is averaged over it, ring by ring: right however sharp its core is; beyond AFAR radii the
    disc counts as a point (within 1e-3). A share `halo` of the light goes into the coloured lenticular halo: out of the
    same angles' light where the spread counts all scattered light, as far as there is enough, else out of all of it.
    """
    near, steps = steps_of_angle(radius)
    far = np.concatenate([np.geomspace(near[-1] * 1.01, FIELD, 400), [np.nextafter(FIELD, 2), np.pi]])
    if halo:
        far = np.unique(np.concatenate([far, HALO_ANGLES[near[-1] < HALO_ANGLES]]))
    middle, solid_angle = (steps[1:] + steps[:-1]) / 2, np.diff(cap(steps))
    colour = Colouring.of(spread, halo, space)
    light = colour.of_rings(middle, np.diff(spread.within(steps)) / solid_angle) * solid_angle[:, None]
    within = share_of_circle(near[:, None], middle, radius) @ light / cap(np.float64(radius))
    return np.concatenate([near, far]), np.concatenate([within, colour.of_rings(far, spread(far))])


@dataclass(frozen=True)
class Colouring:
    """How a spread is coloured by a `halo` that has a share of the light; the light of all angles together stays 1."""

    halo: float
    space: RGBSpace
    replaces: bool
    """True where the halo's luminance is taken out of the spread at the same angle."""
    kept: float = 1.0
    """What the rest of the spread is multiplied by."""

    @classmethod
    def of(cls, spread: PointSpread, halo: float, space: RGBSpace) -> "Colouring":
        """The colouring that keeps the light of the spread."""
        if not halo:
            return cls(halo, space, False)
        rough, angle = cls(halo, space, spread.holds_halo), rings()
        taken = float(ring_weights(angle) @ rough.taken(rough.ring(angle), spread(angle)))
        return cls(halo, space, spread.holds_halo, (1 - halo) / (1 - taken))

    def ring(self, angle: np.ndarray) -> np.ndarray:
        """The halo's light at angles (N,), sr^-1, (N, 3)."""
        light: np.ndarray = self.halo * halo_colours(angle, self.space)
        return light

    def taken(self, ring: np.ndarray, plain: np.ndarray) -> np.ndarray:
        """What the halo takes out of the spread `plain` (N,) where it stands, (N,)."""
        taken: np.ndarray = np.minimum(ring @ self.space.to_xyz[1], plain) * self.replaces
        return taken

    def of_rings(self, angle: np.ndarray, plain: np.ndarray) -> np.ndarray:
        """The spread `plain` at angles (N,), sr^-1, coloured, (N, 3)."""
        if not self.halo:
            return np.repeat(plain[:, None], 3, axis=1)
        ring = self.ring(angle)
        coloured: np.ndarray = self.kept * (plain - self.taken(ring, plain))[:, None] + ring
        return coloured


@dataclass(frozen=True, eq=False)
class Glow:
    """What a source looks like per lux: a table of glow over angle, with needles or without."""

    angle: np.ndarray
    value: np.ndarray
    radius: float
    needles: Needles | None = None

    @classmethod
    def plain(cls, radius: float) -> "Glow":
        """The bare disc, its light spread evenly."""
        edge = np.array([0.0, radius, np.nextafter(radius, 1.0), np.pi])
        value = np.array([1.0, 1.0, 0.0, 0.0]) / cap(np.float64(radius))
        return cls(edge, np.repeat(value[:, None], 3, axis=1), radius)

    def at(self, directions: np.ndarray, source: BrightSource) -> np.ndarray:
        """Linear RGB (..., 3) float32 of the source toward unit vectors (..., 3); (1, 1, 1) is 1 cd m-2."""
        angle = angle_from(directions, source.direction).astype(np.float32)
        result = np.empty((*angle.shape, 3), dtype=np.float32)
        for channel in range(3):
            result[..., channel] = np.interp(angle, self.angle, self.value[:, channel] * source.light[channel])
        if self.needles is not None:
            result *= self.needles.factor(angle, turn_about(directions, source.direction))
        return result

    def painted(self, toward: Toward, shape: tuple[int, int], source: BrightSource) -> np.ndarray:
        """The source in a picture (H, W, 3) float32: pixels at its disc are means over many directions within them."""
        columns = np.arange(shape[1])[None, :]
        picture = np.zeros((*shape, 3), dtype=np.float32)
        width = pixel_width(toward, shape)
        step = max(1, CHUNK // shape[1])
        for k in range(0, shape[0], step):
            directions = toward(texel_centre(np.arange(k, min(k + step, shape[0]))[:, None]), texel_centre(columns))
            cosine = directions @ source.direction
            if not self.is_bare:
                picture[k : k + step] = self.at(directions, source)
            i, j = np.nonzero(cosine > np.cos(self.radius + NEAR * width))
            if i.size:
                picture[i + k, j] = self.mean(toward, i + k, j, source, width)
        return picture

    @property
    def is_bare(self) -> bool:
        """True where there is no light outside the disc."""
        return not self.value[self.angle > self.radius].any()

    def mean(self, toward: Toward, i: np.ndarray, j: np.ndarray, source: BrightSource, width: float) -> np.ndarray:
        """Mean (n, 3) of the source over each of the pixels (i, j)."""
        count = int(np.clip(np.ceil(8 * width / self.radius), 4, 64))
        offsets = texel_centre(np.arange(count)) / count
        total = np.zeros((i.size, 3))
        for down in offsets:
            total += self.at(toward((i + down)[:, None], j[:, None] + offsets), source).sum(axis=1, dtype=np.float64)
        return total / count**2


def pixel_width(toward: Toward, shape: tuple[int, int]) -> float:
    """Height of the picture's middle pixel, radians."""
    row, column = np.array([shape[0] // 2, shape[0] // 2 + 1]), np.full(2, shape[1] / 2)
    return float(angle_between(*toward(row, column)))


def angle_from(directions: np.ndarray, axis: np.ndarray) -> np.ndarray:
    """Angle (...,) of unit vectors (..., 3) from an axis (3,), radians; good to 2e-8, far below a pixel, and quick."""
    angle: np.ndarray = np.arccos(np.clip(directions @ axis, -1.0, 1.0))
    return angle


def turn_about(directions: np.ndarray, axis: np.ndarray) -> np.ndarray:
    """Angle of unit vectors (..., 3) about an axis (3,), radians in [-pi, pi], shape (...,)."""
    u, v = tangent_frame(axis)
    turn: np.ndarray = np.arctan2(directions @ v, directions @ u)
    return turn
