"""Light that a map sends onto surfaces: sums over its texels' solid angles, exact for a piecewise constant map."""

from collections.abc import Iterator

import numpy as np

from skydome.maps.projection import Projection, texel_centre

CHUNK = 1 << 17  # texels at a time: about 10 MB of vectors
EDGE = 1e-9  # texels, and the sine below which a texel's corner counts as on the horizon


def row_chunks(rows: int, columns: int, texels: int = CHUNK) -> Iterator[slice]:
    """Slices of whole rows with about `texels` texels each."""
    step = max(1, texels // columns)
    return (slice(k, min(k + step, rows)) for k in range(0, rows, step))


def light_vector(values: np.ndarray, projection: Projection) -> np.ndarray:
    """Integral of value x direction over the map, shape (3,): the light vector for values (H, W)."""
    rows, columns = values.shape
    total = np.zeros(3)
    for part in row_chunks(rows, columns):
        total += np.einsum("ij,ijk->k", values[part], projection.vector_solid_angles(rows, part))
    return total


def cosine_integral(values: np.ndarray, projection: Projection, normal: np.ndarray) -> float:
    """Integral of value x max(0, cosine to the unit vector `normal`) over the map, for values (H, W).

    Texels wholly in front count by their exact integral of the direction; those that the surface's plane cuts
    by 8 x 8 directions within them.
    """
    rows, columns = values.shape
    angles = np.broadcast_to(projection.solid_angles(rows), values.shape)
    total = 0.0
    for part in row_chunks(rows, columns):
        projected = projection.vector_solid_angles(rows, part) @ normal
        size = angles[part]
        i, j = np.nonzero(np.abs(projected) < size * (3 * np.pi / rows))  # a texel reaches less far than that
        projected[i, j] = front_part(projection, rows, i + part.start, j, normal, projected[i, j], size[i, j])
        total += float(np.sum(values[part] * np.maximum(projected, 0.0)))
    return total


def front_part(
    projection: Projection,
    height: int,
    row: np.ndarray,
    column: np.ndarray,
    normal: np.ndarray,
    projected: np.ndarray,
    size: np.ndarray,
) -> np.ndarray:
    """Projected solid angle of the part of each texel (n,) that is in front of the plane: 0 behind, sampled between."""
    corners = [
        projection.toward(row + down, column + right, height) @ normal
        for down in (EDGE, 1 - EDGE)
        for right in (EDGE, 1 - EDGE)
    ]
    before, behind = np.min(corners, axis=0) > -1e2 * EDGE, np.max(corners, axis=0) < 1e2 * EDGE
    cut = ~(before | behind)
    result = np.where(before, projected, 0.0)
    if not cut.any():
        return result
    offsets = texel_centre(np.arange(8)) / 8
    places = [(down, right) for down in offsets for right in offsets]
    cosines = [projection.toward(row[cut] + down, column[cut] + right, height) @ normal for down, right in places]
    result[cut] = np.mean(np.maximum(cosines, 0.0), axis=0) * size[cut]
    return result
