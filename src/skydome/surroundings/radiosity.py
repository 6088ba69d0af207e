"""Light between diffuse faces: form factors in closed form, and the balance of what each face sends to the others."""

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arrays import Array, constant, namespace
from skydome.ground.quadrature import gauss_legendre


def parallel_rectangles(width: float, depth: float, distance: float) -> float:
    """Form factor between equal rectangles that face each other (Howell's catalogue, C-11), dimensionless.

    >>> round(parallel_rectangles(1.0, 1.0, 1.0), 6)
    0.199825
    """
    x, y = width / distance, depth / distance
    u, v = np.sqrt(1 + x * x), np.sqrt(1 + y * y)
    edge = np.log(np.sqrt(u * u * v * v / (u * u + y * y)))
    sides = x * v * np.arctan(x / v) + y * u * np.arctan(y / u) - x * np.arctan(x) - y * np.arctan(y)
    return float(2 / (np.pi * x * y) * (edge + sides))


def perpendicular_rectangles(common: float, own: float, other: float) -> float:
    """Form factor from a rectangle common x own to one common x other at a right angle (Howell's catalogue, C-14).

    They meet in the edge of length `common`.

    >>> round(perpendicular_rectangles(1.0, 1.0, 1.0), 6)
    0.200044
    """
    w, h = own / common, other / common
    w2, h2 = w * w, h * h
    slant = np.sqrt(h2 + w2)
    angles = w * np.arctan(1 / w) + h * np.arctan(1 / h) - slant * np.arctan(1 / slant)
    logs = np.log((1 + w2) * (1 + h2) / (1 + w2 + h2))
    logs += w2 * np.log(w2 * (1 + w2 + h2) / ((1 + w2) * (w2 + h2)))
    logs += h2 * np.log(h2 * (1 + h2 + w2) / ((1 + h2) * (h2 + w2)))
    return float((angles + logs / 4) / (np.pi * w))


def crossed_strings(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Form factors from strips to strips that see each other fully, endless in length (Hottel 1954), (N, M).

    `a` (N, 2, 2) and `b` (M, 2, 2): both ends of each strip in the plane across. Crossed less uncrossed strings over
    twice the strip's width.
    """
    gap = np.linalg.norm(a[:, None, :, None] - b[None, :, None, :], axis=-1)  # (N, M, 2, 2)
    straight, crossed = gap[..., 0, 0] + gap[..., 1, 1], gap[..., 0, 1] + gap[..., 1, 0]
    width = np.linalg.norm(a[:, 1] - a[:, 0], axis=-1)
    factors: np.ndarray = np.abs(crossed - straight) / (2 * width[:, None])
    return factors


def polygon_factors(points: np.ndarray, normals: np.ndarray, polygons: np.ndarray) -> np.ndarray:
    """Form factors from small planes at `points` (P, 3) facing `normals` (P, 3) to `polygons` (N, V, 3): (P, N).

    Lambert's contour integral: the sum over the edges of (angle that the edge subtends) x (cosine between the plane's
    normal and the normal of the edge's plane through the point) / 2 pi. Polygons are flat, convex, and cut at the
    point's own plane; both their sides count.
    """
    corners = polygons[None] - points[:, None, None]  # (P, N, V, 3)
    height = np.einsum("pnvi,pi->pnv", corners, normals)
    start, end, rising, falling = clipped_edges(corners, height)
    total = subtended(start, end, normals).sum(axis=-1)
    closing = subtended(falling[:, :, None], rising[:, :, None], normals)[..., 0]
    factors: np.ndarray = np.abs(total + closing) / (2 * np.pi)
    return factors


def clipped_edges(corners: np.ndarray, height: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Edges' starts and ends (P, N, V, 3) above the plane, and where the contour enters and leaves it, (P, N, 3).

    An edge below is a point at the origin, and so is a crossing that does not occur.
    """
    after, height_after = np.roll(corners, -1, axis=2), np.roll(height, -1, axis=2)
    span = height - height_after
    share = np.clip(height / np.where(span == 0, 1.0, span), 0.0, 1.0)[..., None]
    crossing = corners + share * (after - corners)
    up, up_after = (height > 0)[..., None], (height_after > 0)[..., None]
    start = np.where(up, corners, np.where(up_after, crossing, 0.0))
    end = np.where(up_after, after, np.where(up, crossing, 0.0))
    rising = np.where(~up & up_after, crossing, 0.0).sum(axis=2)
    falling = np.where(up & ~up_after, crossing, 0.0).sum(axis=2)
    return start, end, rising, falling


def subtended(start: np.ndarray, end: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """Angle under which each edge (P, N, V, 3) is seen, times the cosine of its plane's normal to `normals` (P, 3)."""
    across = np.cross(start, end)
    length = np.linalg.norm(across, axis=-1)
    angle = np.arctan2(length, (start * end).sum(axis=-1))
    tilt = np.einsum("pnvi,pi->pnv", across, normals)
    turned: np.ndarray = angle * np.divide(tilt, length, out=np.zeros_like(tilt), where=length > 1e-300)
    return turned


def rectangle_points(rectangle: np.ndarray, count: int = 6) -> tuple[np.ndarray, np.ndarray]:
    """Gauss points (count^2, 3) on a parallelogram of corners (4, 3), and their shares of its area (count^2,)."""
    t, w = gauss_legendre(count)
    a, b = rectangle[1] - rectangle[0], rectangle[3] - rectangle[0]
    points = rectangle[0] + t[:, None, None] * a + t[None, :, None] * b
    return points.reshape(-1, 3), np.outer(w, w).ravel()


def rectangle_factors(rectangles: np.ndarray, count: int = 16) -> np.ndarray:
    """Form factors between parallelograms (N, 4, 3) that see each other fully, (N, N), row: from.

    Each faces the side from which its corners run anticlockwise. Lambert's closed form, averaged over count^2 Gauss
    points of the sender: in a cube exact to 1e-11 with 8.
    """
    normals = np.cross(rectangles[:, 1] - rectangles[:, 0], rectangles[:, 3] - rectangles[:, 0])
    normals = normals / np.linalg.norm(normals, axis=-1, keepdims=True)
    factors = np.zeros((len(rectangles), len(rectangles)))
    for k, rectangle in enumerate(rectangles):
        points, shares = rectangle_points(rectangle, count)
        facing = np.einsum("pni,ni->pn", points[:, None] - rectangles[None, :, 0], normals) > 1e-12
        every = polygon_factors(points, np.broadcast_to(normals[k], points.shape), rectangles)
        factors[k] = shares @ (every * facing)
    return factors


def interreflected(direct: Array, factors: Array, reflectance: Array) -> Array:
    """Illuminance of faces with all interreflection, lx, (..., N): E = E_direct + F (reflectance x E), solved.

    `direct` (..., N) may hold a year of hours; `factors` (N, N) from row to column; `reflectance` (N,) or a number in
    [0, 1). ValueError outside. Each face has one luminance, reflectance x E / pi (Nishita and Nakamae 1986).

    >>> float(interreflected(np.array([1.0, 1.0]), np.array([[0.0, 1.0], [1.0, 0.0]]), 0.5)[0])
    2.0
    """
    xp = namespace(direct)
    f = constant(factors, direct)
    known = np.asarray(reflectance, dtype=np.float64)
    if not ((known >= 0) & (known < 1)).all():
        raise ValueError(f"reflectance must lie in [0, 1), got {reflectance}")
    rho = constant(np.broadcast_to(known, f.shape[-1:]), direct)
    system = constant(np.eye(f.shape[0]), direct) - f * rho
    return (
        xp.matrix_transpose(xp.linalg.solve(system, xp.matrix_transpose(direct)))
        if direct.ndim > 1
        else (xp.linalg.solve(system, direct[:, None])[:, 0])
    )


def interreflected_channels(direct: Array, factors: Array, reflectance: ArrayLike) -> Array:
    """The same of light in channels (..., N, C), each for itself; `reflectance` (N,), or (N, C) by channel."""
    xp = namespace(direct)
    known = np.asarray(reflectance, dtype=np.float64)
    each = [known[:, c] if known.ndim == 2 else known for c in range(direct.shape[-1])]
    return xp.stack([interreflected(direct[..., c], factors, rho) for c, rho in enumerate(each)], axis=-1)
