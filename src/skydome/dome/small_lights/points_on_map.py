"""Points of light on the texels of a map: the energy and the place of each kept, at every height."""

from collections.abc import Iterator

import numpy as np

from skydome.dome.small_lights.sun_on_map import within_rim
from skydome.dome.small_lights.texels import TexelLight
from skydome.light.colour import RGBSpace, rgb_from_xyz
from skydome.maps.projection import Projection, from_first_centre, texel_centre
from skydome.skies.suns.point_lights import PointLights


def points_on_map(
    lights: PointLights, factor: float, projection: Projection, height: int, space: RGBSpace
) -> Iterator[TexelLight]:
    """What points of light give the texels of a map.

    Each point is shared out among the four texels around it, so that its place is theirs in the mean, whichever it
    falls in: nothing sparkles from frame to frame. Texels that the map lacks, or that lie under the horizon, leave
    their share to the one that the point falls in.
    """
    seen = lights.carried[:, 1] > 0
    directions, light = np.asarray(lights.directions, np.float64)[seen], lights.carried[seen]
    row, column, covered = projection.pixels(directions, height)
    row, column, light = row[covered], column[covered], light[covered]
    angles = np.broadcast_to(projection.solid_angles(height), projection.shape(height))
    at = within_rim(row, column, angles)
    y, x = np.floor(from_first_centre(row)).astype(np.int64), np.floor(from_first_centre(column)).astype(np.int64)
    down, right = from_first_centre(row) - y, from_first_centre(column) - x
    for i, j in ((0, 0), (0, 1), (1, 0), (1, 1)):
        share = (down if i else 1 - down) * (right if j else 1 - right)
        there = projection.wrapped(y + i, x + j, height, at[0])
        rows, columns = (place.astype(np.int64) for place in there[:2])
        fits = there[2] & (angles[rows, columns] > 0)
        fits &= projection.toward(texel_centre(rows), texel_centre(columns), height)[..., 2] >= 0
        rows, columns = np.where(fits, rows, at[0]), np.where(fits, columns, at[1])
        flux = light * (share * factor / np.maximum(angles[rows, columns], 1e-30))[:, None]
        yield TexelLight(rows, columns, rgb_from_xyz(flux, space))
