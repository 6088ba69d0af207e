"""Cube maps: six square faces in a vertical strip, in OpenGL's order and orientation."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from skydome.maps.projection import ALL_ROWS, Projection, Texels, checked_height, within

# Per face +X -X +Y -Y +Z -Z: its axis, and where the image's right (s) and down (t) point, in OpenGL's Y-up frame
# (OpenGL 4.6 core specification, table 8.19: s_c, t_c, m_a). The last column of the table is the face's own axis.
AXIS_INDEX = np.array([0, 0, 1, 1, 2, 2])
AXIS_SIGN = np.array([1.0, -1.0, 1.0, -1.0, 1.0, -1.0])
RIGHT_INDEX = np.array([2, 2, 0, 0, 0, 0])
RIGHT_SIGN = np.array([-1.0, 1.0, 1.0, 1.0, 1.0, -1.0])
DOWN_INDEX = np.array([1, 1, 2, 2, 1, 1])
DOWN_SIGN = np.array([-1.0, -1.0, 1.0, -1.0, -1.0, -1.0])


@dataclass(frozen=True)
class CubeMap(Projection):
    """Six faces +X, -X, +Y, -Y, +Z, -Z from top to bottom, each height / 6 square, ready for OpenGL's six targets.

    OpenGL's frame is Y-up: X east, Y up, Z south. Its faces are laid out as seen from outside the cube (table 8.19).

    >>> cube = CubeMap()
    >>> cube.shape(12)
    (12, 2)
    >>> row, column, _ = cube.pixels([0.0, 0.0, 1.0], 12)   # the zenith: the middle of face +Y, the third
    >>> float(row), float(column)
    (5.0, 1.0)
    """

    def shape(self, height: int) -> tuple[int, int]:
        """Rows and columns (height, height / 6); the height must be a multiple of 6."""
        height = checked_height(height, 6, 6, "a cube map's strip of six faces")
        return height, height // 6

    def face_plane(self, row: ArrayLike, column: ArrayLike, height: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Face index and the position (s to the right, t down, each -1..1) on its face, broadcast together."""
        side = self.shape(height)[1]
        row, column = np.broadcast_arrays(np.asarray(row, np.float64), np.asarray(column, np.float64))
        face = np.clip(row // side, 0, 5).astype(np.intp)
        return face, 2 * column / side - 1, 2 * (row - face * side) / side - 1

    def toward(self, row: ArrayLike, column: ArrayLike, height: int) -> np.ndarray:
        """Unit vectors (..., 3) toward continuous texel coordinates."""
        return toward_face(*self.face_plane(row, column, height))

    def pixels(self, directions: ArrayLike, height: int) -> Texels:
        """Continuous texel coordinates (row, column) of directions (..., 3); every direction is covered."""
        side = self.shape(height)[1]
        x, y, z = np.moveaxis(np.asarray(directions, dtype=np.float64), -1, 0)
        v = np.stack([x, z, -y], axis=-1)  # Y-up
        axis = np.argmax(np.abs(v), axis=-1)
        major = np.take_along_axis(v, axis[..., None], -1)[..., 0]
        face = 2 * axis + (major < 0)
        s = RIGHT_SIGN[face] * np.take_along_axis(v, RIGHT_INDEX[face][..., None], -1)[..., 0] / np.abs(major)
        t = DOWN_SIGN[face] * np.take_along_axis(v, DOWN_INDEX[face][..., None], -1)[..., 0] / np.abs(major)
        row = np.minimum(face * side + within((t + 1) / 2 * side, side), np.nextafter((face + 1.0) * side, 0))
        return row, within((s + 1) / 2 * side, side), np.ones(np.shape(x), dtype=bool)

    def solid_angles(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """Exact solid angle of each texel, sr, shape (r, height / 6), by the arctangents of its four corners.

        The rectangle from the face's middle to (s, t) spans atan(s t / sqrt(1 + s^2 + t^2)).
        """
        side = self.shape(height)[1]
        s = 2 * np.arange(side + 1) / side - 1
        top = 2 * (np.arange(height)[rows, None] % side) / side - 1
        above, below = (np.arctan2(s * t, np.sqrt(1 + s * s + t * t)) for t in (top, top + 2 / side))
        return np.diff(below - above, axis=1)

    def vector_solid_angles(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """Exact integral of the direction over each texel, sr, shape (r, height / 6, 3).

        Lambert's sum over the edges of a spherical polygon: half of (edge angle) x (the edge plane's unit normal).
        """
        row, column = self.centres(height, rows)
        face, s, t = self.face_plane(row, column, height)
        half = 6 / height
        around = [(-half, -half), (half, -half), (half, half), (-half, half)]
        corners = [toward_face(face, s + right, t + down) for right, down in around]
        total = np.zeros_like(corners[0])
        for a, b in zip(corners, corners[1:] + corners[:1], strict=True):
            normal = np.cross(a, b)
            sine = np.linalg.norm(normal, axis=-1, keepdims=True)
            total += normal / sine * np.arcsin(sine) / 2
        outward = np.sum(total * self.toward(row, column, height), axis=-1, keepdims=True)
        total *= np.sign(outward)
        return total

    def wrapped(self, row: np.ndarray, column: np.ndarray, height: int, home: np.ndarray) -> Texels:
        """Texel indices, where they leave the face of row `home`, led to the face that continues it."""
        side = self.shape(height)[1]
        face = home // side
        across, down = column, row - face * side
        leaves = (across < 0) | (across >= side) | (down < 0) | (down >= side)
        beyond = toward_face(face[leaves], (2 * across[leaves] + 1) / side - 1, (2 * down[leaves] + 1) / side - 1)
        there = self.pixels(beyond, height)
        row, column = row.copy(), column.copy()
        row[leaves], column[leaves] = there[0].astype(row.dtype), there[1].astype(column.dtype)
        return row, column, np.ones(row.shape, dtype=bool)

    def height_for(self, texels: float) -> int:
        """The height, a multiple of 6, whose six faces come nearest."""
        return 6 * max(1, round(math.sqrt(texels / 6)))


def toward_face(face: np.ndarray, s: np.ndarray, t: np.ndarray) -> np.ndarray:
    """Unit vectors (..., 3) of our frame toward (s, t) on the plane of each face; s and t may lie beyond the face."""
    v = np.zeros((*face.shape, 3))
    np.put_along_axis(v, AXIS_INDEX[face][..., None], AXIS_SIGN[face][..., None], -1)
    np.put_along_axis(v, RIGHT_INDEX[face][..., None], (RIGHT_SIGN[face] * s)[..., None], -1)
    np.put_along_axis(v, DOWN_INDEX[face][..., None], (DOWN_SIGN[face] * t)[..., None], -1)
    v /= np.linalg.norm(v, axis=-1, keepdims=True)
    return np.stack([v[..., 0], -v[..., 2], v[..., 1]], axis=-1)
