"""The sky as bands (Nishita and Nakamae 1986): lunes between planes through one axis in the receiving plane.

deviation from the text | here | why
the same angle written Omega_k and delta_k, half width Delta 8, Delta d | `centres`, `half_widths` | slips of the scan
base plane horizontal | any receiving plane | the derivation asks only that the axis lies in the receiving plane
bands of one width from 0 to pi | the horizon and given breaks are edges too | no band is half sky, half ground
the same, on tilted planes | bands narrow toward the horizon | skies are steep there: 0.3 % becomes 0.05 % (N = 64)

Derivation: toward angle a from the axis, in the plane at dihedral angle d, a solid angle is sin a da dd and its cosine
of incidence sin a sin d. Hence E = integral of L sin^2 a da x integral of sin d dd, and the second one is d_k.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from skydome.dome.integrals import in_library_of
from skydome.ground.arrays import Array, as_numpy, constant
from skydome.ground.directions import NORTH, ZENITH, checked_directions, unit
from skydome.ground.quadrature import gauss_legendre
from skydome.skies.sky import Sky
from skydome.surroundings.light_kinds import LUX, LightKind

LONGEST_PIECE = np.pi / 4
NODES_PER_PIECE = 12
CROWDING = 0.8
"""How much narrower bands are next to the horizon of a tilted plane than on average: by a factor 1 - 0.8."""


@dataclass(frozen=True, eq=False)
class Bands:
    """N bands over the hemisphere of a plane: `normal` (3,), `axis` (3,) in the plane, `edges` (N + 1,) radians.

    Edges are dihedral angles about the axis, rising from 0 to pi; at 0 lies `across` = normal x axis. Bands.of(...)
    lays them out. ValueError for an axis out of the plane.

    >>> bands = Bands.of(count=8)
    >>> round(float(bands.uniform(np.pi).sum()), 12) == round(np.pi, 12)
    True
    """

    normal: np.ndarray
    axis: np.ndarray
    edges: np.ndarray

    def __post_init__(self) -> None:
        off = abs(float(self.normal @ self.axis))
        if off > 1e-6:
            raise ValueError(f"the bands' axis must lie in the receiving plane, got cosine {off:.3g} to its normal")
        if not (np.diff(self.edges) > 0).all() or self.edges[0] != 0 or not np.isclose(self.edges[-1], np.pi):
            raise ValueError("the bands' edges must rise from 0 to pi")

    @classmethod
    def of(
        cls, normal: ArrayLike = ZENITH, count: int = 64, axis: ArrayLike | None = None, breaks: Sequence[float] = ()
    ) -> "Bands":
        """`count` bands for a plane facing `normal` (3,), of even width where the plane is level.

        `axis` (3,) is horizontal by default (east for a level plane). `breaks`, dihedral angles, become edges,
        and so does the horizon where the axis is horizontal; every piece between them has at least one band
        (so there can be a few more than `count`).
        """
        n = unit(as_numpy(checked_directions(normal, "normal")).astype(np.float64))
        if n.shape != (3,):
            raise ValueError(f"bands are laid out for one normal of shape (3,), got {n.shape}")
        if count != int(count) or count < 1:
            raise ValueError(f"count must be a whole number of bands, at least 1, got {count!r}")
        x = level_axis(n) if axis is None else unit(as_numpy(checked_directions(axis, "axis")).astype(np.float64))
        across = np.cross(n, x)
        horizon = [dihedral(ZENITH - (ZENITH @ x) * x, across, n)] if abs(x[2]) < 1e-12 else []
        horizon = [edge for up in horizon for edge in (up - np.pi / 2, up + np.pi / 2)]
        return cls(n, x, laid_edges(int(count), breaks, horizon))

    @property
    def count(self) -> int:
        """How many bands there are."""
        return len(self.edges) - 1

    @cached_property
    def across(self) -> np.ndarray:
        """The direction in the plane at dihedral angle 0, (3,)."""
        side: np.ndarray = np.cross(self.normal, self.axis)
        return side

    @cached_property
    def centres(self) -> np.ndarray:
        """Dihedral angle of each band's middle plane (delta_k), radians, (N,)."""
        middle: np.ndarray = (self.edges[1:] + self.edges[:-1]) / 2
        return middle

    @cached_property
    def half_widths(self) -> np.ndarray:
        """Half the width of each band (Delta delta), radians, (N,)."""
        half: np.ndarray = np.diff(self.edges) / 2
        return half

    @cached_property
    def weights(self) -> np.ndarray:
        """d_k = cos(delta_k - D) - cos(delta_k + D) (15.55), (N,); they add up to 2."""
        d: np.ndarray = np.cos(self.centres - self.half_widths) - np.cos(self.centres + self.half_widths)
        return d

    def toward(self, angle: ArrayLike, alpha: ArrayLike) -> np.ndarray:
        """Unit vectors at angle `alpha` from the axis in the plane of dihedral `angle`; both broadcast, (..., 3)."""
        angle, alpha = np.broadcast_arrays(angle, alpha)
        rim = np.cos(angle)[..., None] * self.across + np.sin(angle)[..., None] * self.normal
        vectors: np.ndarray = np.cos(alpha)[..., None] * self.axis + np.sin(alpha)[..., None] * rim
        return vectors

    def directions(self, band: Array, alpha: Array) -> np.ndarray:
        """Unit vectors at angle `alpha` from the axis in the middle planes of `band`; both broadcast, (..., 3)."""
        return self.toward(self.centres[band], alpha)

    def uniform(self, alpha: ArrayLike, luminance: float = 1.0) -> np.ndarray:
        """E_k(alpha) of every band for uniform luminance, lx: 0.5 d_k (alpha - cos alpha sin alpha) L0 (15.54).

        `alpha` (...,) radians from the axis; shape (..., N).
        """
        alpha = np.asarray(alpha, dtype=np.float64)[..., None]
        lit: np.ndarray = 0.5 * self.weights * (alpha - np.cos(alpha) * np.sin(alpha)) * luminance
        return lit

    def nodes(self, band: ArrayLike, first: ArrayLike, last: ArrayLike) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Gauss nodes for (15.56) on intervals `first` to `last` of `band`, each (I,).

        Directions (M, 3), weights (M,) sr projected on the plane, and the interval that each belongs to (M,).
        Intervals are cut in pieces of at most 45 degrees with 12 nodes each.
        """
        band, first, last = (np.atleast_1d(part) for part in (band, first, last))
        pieces = np.maximum(1, np.ceil((last - first) / LONGEST_PIECE - 1e-9)).astype(int)
        owner = np.repeat(np.arange(len(band)), pieces)
        turn = np.arange(len(owner)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
        length = ((last - first) / pieces)[owner]
        t, w = gauss_legendre(NODES_PER_PIECE)
        alpha = (first[owner] + turn * length)[:, None] + length[:, None] * t
        weights = self.weights[band[owner]][:, None] * length[:, None] * w * np.sin(alpha) ** 2
        directions = self.directions(band[owner][:, None], alpha)
        return directions.reshape(-1, 3), weights.reshape(-1), np.repeat(owner, NODES_PER_PIECE)

    def illuminance(self, sky: Sky, alpha: float = np.pi, light: LightKind = LUX) -> Array:
        """E_k(alpha) of every band for any sky, lx, shape (..., N): d_k x integral of L sin^2 (15.56).

        `sky` may have leading axes (T, 1). What lies below the horizon is dark. In another kind of `light`, such as
        LightInRGB(), shape (..., N, C).

        >>> import skydome as sd
        >>> bands = Bands.of(count=4)
        >>> bool(np.allclose(bands.illuminance(sd.Uniform(2.0)), bands.uniform(np.pi, 2.0), rtol=1e-12))
        True
        """
        if not 0 <= alpha <= np.pi + 1e-12:
            raise ValueError(f"alpha must lie in [0, pi], got {alpha}")
        every = np.arange(self.count)
        first, last = above_horizon(self, alpha)
        nodes, weights, owner = self.nodes(every, first, last)
        shares = weights[:, None] * (owner[:, None] == every)
        found = light.toward(sky, in_library_of(nodes, sky))
        return constant(shares.T, found) @ found if light.trailing else found @ constant(shares, found)


def level_axis(normal: np.ndarray) -> np.ndarray:
    """The horizontal direction in a plane, such that at dihedral angle 0 the plane rises most; east if it is level."""
    rise = ZENITH - normal[2] * normal
    length = np.linalg.norm(rise)
    up = rise / length if length > 1e-9 else NORTH * np.sign(normal[2])
    axis = np.cross(up, normal)
    level: np.ndarray = axis / np.linalg.norm(axis)
    return level


def dihedral(vector: np.ndarray, across: np.ndarray, normal: np.ndarray) -> float:
    """Dihedral angle of a vector about the axis, radians in (-pi, pi]."""
    return float(np.arctan2(vector @ normal, vector @ across))


def laid_edges(count: int, breaks: Sequence[float], horizons: Sequence[float]) -> np.ndarray:
    """Edges from 0 to pi through the breaks and horizons that lie between, `count` bands shared out by length."""
    inner = sorted(b for b in (*breaks, *horizons) if 1e-9 < b < np.pi - 1e-9)
    knots = np.array([0.0, *inner, np.pi])
    knots = knots[np.append(True, np.diff(knots) > 1e-9)]
    crowd = [1e-9 < k < np.pi - 1e-9 and bool(np.isclose(k, horizons, atol=1e-9).any()) for k in knots]
    pieces = [
        a + (b - a) * steps(n, low, high)[:-1]
        for a, b, n, low, high in zip(knots, knots[1:], shared(count, knots), crowd, crowd[1:], strict=False)
    ]
    return np.append(np.concatenate(pieces), np.pi)


def shared(count: int, knots: np.ndarray) -> np.ndarray:
    """How many of `count` bands lie between neighbouring knots (K,): by length, at least one each. (K - 1,)."""
    ideal = count * np.diff(knots) / np.pi
    shares: np.ndarray = np.maximum(1, np.floor(ideal)).astype(int)
    for piece in np.argsort(shares - ideal)[: max(0, count - int(shares.sum()))]:
        shares[piece] += 1
    return shares


def steps(count: int, low: bool, high: bool) -> np.ndarray:
    """count + 1 steps from 0 to 1 that crowd at the ends asked for: where skies are steep, above the horizon."""
    u = np.linspace(0.0, 1.0, count + 1)
    if low and high:
        return u - CROWDING / (2 * np.pi) * np.sin(2 * np.pi * u)
    if not (low or high):
        return u
    t = u if low else 1 - u
    t = t * (1 - CROWDING + CROWDING * t)
    return t if low else 1 - t


def above_horizon(bands: Bands, alpha: float) -> tuple[np.ndarray, np.ndarray]:
    """First and last angle from the axis, (N,) each, of the part of every band above the horizon, up to `alpha`."""
    rim = np.cos(bands.centres) * bands.across[2] + np.sin(bands.centres) * bands.normal[2]
    slope = bands.axis[2]
    if abs(slope) < 1e-12:
        return np.zeros(bands.count), np.where(rim > 0, alpha, 0.0)
    crossing = np.mod(np.arctan2(-slope, rim), np.pi)
    first, last = (0.0, crossing) if slope > 0 else (crossing, np.pi)
    return np.minimum(first, alpha) + np.zeros(bands.count), np.minimum(last, alpha) + np.zeros(bands.count)
