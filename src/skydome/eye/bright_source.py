"""Suns and lamps in a map: found, taken out of the texels, and known by direction, size and the light they send."""

from dataclasses import dataclass, replace

import numpy as np

from skydome.eye.linked_groups import linked
from skydome.ground.directions import angle_between, tangent_frame, unit
from skydome.ground.extras import required
from skydome.light.colour import RGBSpace
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.projection import texel_centre
from skydome.maps.resample import SUN_CONTRAST, without_suns
from skydome.skies.suns.sun_disc import MEAN_RADIUS

MOST = 32
"""So many sources, the strongest, are treated one by one; fainter ones stay in the map."""

RING = 48


@dataclass(frozen=True, eq=False)
class BrightSource:
    """A round source toward the unit vector `direction` (3,), of angular `radius`, radians.

    `light` (3,): linear RGB of the light on a plane that faces it; (1, 1, 1) means 1 lx. The blue of a setting sun,
    which is redder than any sRGB colour, is negative.
    """

    direction: np.ndarray
    light: np.ndarray
    radius: float = MEAN_RADIUS

    def illuminance(self, space: RGBSpace) -> float:
        """Illuminance on a plane that faces the source, lx."""
        return float(space.to_xyz[1] @ self.light)


def without_sources(
    environment: EnvironmentMap, contrast: float = SUN_CONTRAST
) -> tuple[EnvironmentMap, list[BrightSource]]:
    """The map with its bright sources filled in by what surrounds them, and the sources, strongest first.

    A source is what stands out `contrast` times from its surroundings. The light of map and sources together is the
    map's own, exactly. A source smaller than a texel counts as large as the sun.
    """
    required("scipy", "eye", "finding the suns of a map")
    _, row, column = without_suns(environment.pixels, contrast)
    if not row.size:
        return environment, []
    pixels = environment.pixels.copy()
    toward = environment.projection.toward(texel_centre(row), texel_centre(column), environment.height)
    groups = linked(toward, 3 * texel(environment))
    strength = np.bincount(groups, weights=environment.pixels[row, column].sum(axis=-1))
    sources = []
    for group in np.argsort(-strength, kind="stable")[:MOST]:
        member = groups == group
        sources.append(taken_out(environment, pixels, row[member], column[member]))
    return replace(environment, pixels=pixels), sources


def texel(environment: EnvironmentMap) -> float:
    """Width of a typical texel, radians."""
    rows, columns = environment.pixels.shape[:2]
    angles = environment.projection.solid_angles(environment.height)
    return float(np.sqrt(np.broadcast_to(angles, (rows, columns)).max()))


def taken_out(environment: EnvironmentMap, pixels: np.ndarray, row: np.ndarray, column: np.ndarray) -> BrightSource:
    """The source in the texels (n,) of `environment`; they and their neighbours are filled in in `pixels`, in place."""
    projection, height = environment.projection, environment.height
    row, column = with_neighbours(environment, row, column)
    toward = projection.toward(texel_centre(row), texel_centre(column), height)
    angles = np.broadcast_to(projection.solid_angles(height), pixels.shape[:2])[row, column]
    rough = pixels[row, column].sum(axis=-1) * angles
    middle = unit(rough @ toward)
    width = texel(environment)
    reach = float(angle_between(toward, middle).max()) + width
    fill = np.minimum(ring_median(environment, middle, reach), pixels[row, column].max(axis=0))
    flux = (pixels[row, column] - fill) * angles[:, None]
    pixels[row, column] = fill
    weight = np.maximum(flux.sum(axis=-1), 0.0)
    centre = unit(weight @ toward) if weight.any() else middle
    spread = float(weight @ angle_between(toward, centre) ** 2) / max(float(weight.sum()), 1e-300) - width**2 / 6
    radius = float(np.sqrt(2 * max(spread, 0.0)))  # a disc's mean square distance from its middle is R^2 / 2
    light = flux.sum(axis=0, dtype=np.float64) * environment.white_luminance
    return BrightSource(centre, light, radius if radius > width else MEAN_RADIUS)


def with_neighbours(environment: EnvironmentMap, row: np.ndarray, column: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The texels and the eight around each, each once."""
    steps = np.array([(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)])
    i, j, there = environment.projection.wrapped(
        row[:, None] + steps[:, 0], column[:, None] + steps[:, 1], environment.height, row[:, None]
    )
    width = environment.pixels.shape[1]
    texels = np.unique((i * width + j)[np.broadcast_to(there, i.shape)])
    return texels // width, texels % width


def ring_median(environment: EnvironmentMap, middle: np.ndarray, angle: float) -> np.ndarray:
    """Median RGB (3,) of the map at an angle from `middle`, in the map's own unit."""
    u, v = tangent_frame(middle)
    turn = (np.arange(RING) + 0.5) * 2 * np.pi / RING
    around = np.cos(turn)[:, None] * u + np.sin(turn)[:, None] * v
    median: np.ndarray = np.median(environment.sample(np.cos(angle) * middle + np.sin(angle) * around), axis=0)
    return median
