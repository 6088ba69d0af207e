"""An endless street between two walls of one height: the light on its floor and walls, with interreflection."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arrays import Array, constant
from skydome.ground.directions import ZENITH, checked_directions, checked_turn, direction
from skydome.ground.limits.ranges import FINITE, SHARE, Bounded, Range
from skydome.ground.quadrature import gauss_legendre
from skydome.skies.labelled import outer_labels
from skydome.skies.sky import Sky
from skydome.surroundings.bands import Bands, dihedral, level_axis
from skydome.surroundings.channels import BELOW_ONE, channelled, check_shares, points_and_channels, side_by_side
from skydome.surroundings.faces import Enclosure, Faces, Scene, plain
from skydome.surroundings.intervals import SKY
from skydome.surroundings.light_kinds import LUX, LightKind
from skydome.surroundings.obstruction import PlaneView, Received
from skydome.surroundings.radiosity import crossed_strings, interreflected, interreflected_channels

POINTS_PER_STRIP = 3


LENGTH = Range(1e-9, 1e9)


@dataclass(frozen=True, eq=False)
class StreetCanyon(Bounded, Scene):
    """A street `width` m wide between walls of `height` m that runs toward `azimuth`, radians; metres, or any one unit.

    Across the street x runs from -width / 2, the wall at the left of one who looks along the azimuth, to width / 2.
    Floor and walls are cut in `strips` each, of uniform illuminance and of `floor_reflectance`, `wall_reflectance`:
    numbers in [0, 1), or for light in colour one of each channel (C,), or a `Spectrum`.

    >>> canyon = StreetCanyon(height=10.0, width=10.0)
    >>> round(canyon.floor_view_factor, 6)
    0.414214
    """

    height: float
    width: float
    azimuth: float = 0.0
    floor_reflectance: Any = 0.0
    wall_reflectance: Any = 0.0
    strips: int = 16
    bounds: ClassVar = {
        "height": LENGTH,
        "width": LENGTH,
        "azimuth": FINITE,
        "floor_reflectance": SHARE,
        "wall_reflectance": SHARE,
        "strips": Range(1, 4096),
    }

    def __post_init__(self) -> None:
        self.require_bounds()
        checked_turn(self.azimuth, "azimuth of the street")
        for name in ("floor_reflectance", "wall_reflectance"):
            check_shares(name, getattr(self, name), BELOW_ONE)

    @property
    def along(self) -> np.ndarray:
        """Unit vector along the street, (3,)."""
        way: np.ndarray = direction(self.azimuth, 0.0)
        return way

    @property
    def right(self) -> np.ndarray:
        """Unit vector to the right of one who looks along the street, (3,)."""
        side: np.ndarray = direction(self.azimuth + np.pi / 2, 0.0)
        return side

    @property
    def floor_view_factor(self) -> float:
        """Mean view factor from the floor to the sky, by crossed strings: sqrt(1 + (H/W)^2) - H/W."""
        ratio = self.height / self.width
        return float(np.hypot(1.0, ratio) - ratio)

    @property
    def wall_view_factor(self) -> float:
        """Mean view factor from a wall to the sky: (1 + W/H - sqrt(1 + (W/H)^2)) / 2."""
        ratio = self.width / self.height
        return float((1 + ratio - np.hypot(1.0, ratio)) / 2)

    def point_view_factor(self, x: Any) -> np.ndarray:
        """View factor to the sky from the floor at x (...,): half the sum of the sines of the zenith angles seen."""
        left, right = np.asarray(x) + self.width / 2, self.width / 2 - np.asarray(x)
        seen: np.ndarray = (left / np.hypot(left, self.height) + right / np.hypot(right, self.height)) / 2
        return seen

    @cached_property
    def ends(self) -> np.ndarray:
        """Ends (x, z) of every strip, (3 x strips, 2, 2): the floor's from left to right, then the walls' upwards."""
        n = self.strips
        across, up = np.linspace(-self.width / 2, self.width / 2, n + 1), np.linspace(0.0, self.height, n + 1)
        floor = np.stack([across, np.zeros(n + 1)], axis=-1)
        left, right = (np.stack([np.full(n + 1, x), up], axis=-1) for x in (across[0], across[-1]))
        ends: np.ndarray = np.concatenate([np.stack([line[:-1], line[1:]], axis=1) for line in (floor, left, right)])
        return ends

    @property
    def normals(self) -> np.ndarray:
        """Unit normal of every strip, (3 x strips, 3)."""
        return np.repeat(np.stack([ZENITH, self.right, -self.right]), self.strips, axis=0)

    def reflectances(self, light: LightKind = LUX) -> np.ndarray:
        """Reflectance of every strip, (3 x strips,), or (3 x strips, C) where floor or walls have channels."""
        floor, wall = (channelled(value, light) for value in (self.floor_reflectance, self.wall_reflectance))
        return np.repeat(np.stack(np.broadcast_arrays(floor, wall, wall)), self.strips, axis=0)

    @cached_property
    def factors(self) -> np.ndarray:
        """Form factors between the strips, (3 x strips, 3 x strips), exact."""
        every = crossed_strings(self.ends, self.ends)
        part = np.repeat(np.arange(3), self.strips)
        every[part[:, None] == part] = 0.0
        return every

    def at(self, x: float, z: float = 0.0) -> "CanyonPoint":
        """What is seen from x across the street and z above its floor; ValueError outside."""
        if abs(x) > self.width / 2 or not z >= 0:
            raise ValueError(
                f"the point must lie in the street, |x| <= {self.width / 2:g} and z >= 0, got {x:g}, {z:g}"
            )
        return CanyonPoint(self, float(x), float(z))

    def lit_faces(self) -> Faces:
        """The strips, for `FaceLight`, with three points each. ValueError for reflectances in colour."""
        t, _ = gauss_legendre(POINTS_PER_STRIP)
        places = [[self.at(*(start + share * (end - start))) for share in t] for start, end in self.ends]
        return Faces(places, self.normals, plain(self.reflectances()), self.factors)

    def strip_light(self, sky: Sky, bands: int = 48, light: LightKind = LUX) -> Array:
        """Illuminance of every strip with interreflection, lx, (..., 3 x strips): sky's leading axes first.

        In another kind of `light` (..., 3 x strips, C).
        """
        t, w = gauss_legendre(POINTS_PER_STRIP)
        columns = []
        for (start, end), normal in zip(self.ends, self.normals, strict=True):
            points = [self.at(*(start + share * (end - start))) for share in t]
            received = [point.view(normal, bands).receive(sky, light=light) for point in points]
            columns.append(sum(share * part.total for share, part in zip(w, received, strict=True)))
        balance = interreflected_channels if light.trailing else interreflected
        return balance(side_by_side(columns, light), self.factors, self.reflectances(light))

    @outer_labels("", points_and_channels)
    def illuminance(
        self,
        sky: Sky,
        x: Sequence[float],
        z: float = 0.0,
        normal: ArrayLike = ZENITH,
        bands: int = 64,
        light: LightKind = LUX,
    ) -> Received:
        """Light at points x (P,) across the street, z above its floor, on planes facing `normal` (3,), lx, (..., P).

        From the sky, the sun and, where floor or walls reflect, from them: uniform strips with interreflection. In
        another kind of `light` (..., P, C).
        """
        lit = None
        reflectances = self.reflectances(light)
        if reflectances.any():
            strips = self.strip_light(sky, light=light)
            shares = reflectances[:, None] if light.trailing and reflectances.ndim == 1 else reflectances
            lit = strips * constant(shares / np.pi, strips)
        found = []
        for place in x:
            view = self.at(float(place), z).view(normal, bands)
            luminances = {} if lit is None else {int(k): light.pick(lit, int(k)) for k in view.labels}
            received = view.receive(sky, luminances, light=light)
            found.append([received.sky, received.sun, received.reflected])
        return Received(*(side_by_side(column, light) for column in zip(*found, strict=True)))


@dataclass(frozen=True, eq=False)
class CanyonPoint(Enclosure):
    """A point in a street canyon: `x` across, `z` above the floor."""

    canyon: StreetCanyon
    x: float
    z: float

    def within(self) -> StreetCanyon:
        """The street."""
        return self.canyon

    def shown(self, labels: np.ndarray) -> np.ndarray:
        """All of them: nobody stands behind a wall."""
        return np.full(labels.shape, True)

    def seen(self, directions: np.ndarray) -> np.ndarray:
        """The number of the strip that is met, or SKY."""
        c, half, n = self.canyon, self.canyon.width / 2, self.canyon.strips
        side, rise = directions @ c.right, directions[..., 2]
        with np.errstate(divide="ignore", invalid="ignore"):
            height = self.z + rise * (np.where(side > 0, half, -half) - self.x) / side
            landing = self.x - side * self.z / rise
        height = np.where(np.isnan(height), np.where(rise > 0, np.inf, -np.inf), height)
        wall = n + np.clip(height / c.height * n, 0, n - 1).astype(int) + np.where(side > 0, n, 0)
        floor = np.clip(np.nan_to_num((landing + half) / c.width * n, posinf=0.0, neginf=0.0), 0, n - 1).astype(int)
        return np.where(height < 0, floor, np.where(height > c.height, SKY, wall))

    def view(self, normal: ArrayLike = ZENITH, bands: int = 64) -> PlaneView:
        """The view of a plane. Where the plane holds the street's direction the bands run along the street.

        Then roofs and the strips' ends are edges of bands, and the shares of sky and strips are exact.
        """
        n = np.asarray(checked_directions(normal, "normal"), dtype=np.float64)
        if abs(float(n @ self.canyon.along)) > 1e-9:
            return PlaneView.of(self, n, bands)
        plain = level_axis(n)
        axis = self.canyon.along * np.sign(plain @ self.canyon.along or 1.0)
        across = np.cross(n, axis)
        gaps = self.canyon.ends.reshape(-1, 2) - (self.x, self.z)
        gaps = gaps[np.linalg.norm(gaps, axis=-1) > 1e-9 * self.canyon.width]
        borders = [dihedral(gap[0] * self.canyon.right + gap[1] * ZENITH, across, n) for gap in gaps]
        return PlaneView.of(self, n, Bands.of(n, bands, axis, borders))
