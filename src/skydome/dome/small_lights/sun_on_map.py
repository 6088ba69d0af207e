"""The sun's disc on the texels of a map: its energy, its place and the light that it gives the ground are kept."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from skydome.dome.small_lights.texels import TexelLight
from skydome.ground.directions import ZENITH
from skydome.light.colour import RGBSpace, rgb_from_xyz
from skydome.maps.integrals import front_part
from skydome.maps.projection import Projection
from skydome.skies.suns.sun_disc import SunDisc

POINTS_PER_TEXEL = 4096
LEAST_POINTS, MOST_POINTS = 4096, 1 << 18
Step = tuple[int, int]
STEPS: tuple[Step, ...] = ((-1, 0), (1, 0), (0, -1), (0, 1))
"""One texel up, down, left, right."""
STEP_PAIRS = tuple((a, b) for a in STEPS[:2] for b in STEPS[2:]) + tuple((a,) for a in STEPS)
OBLIQUE: tuple[Step, ...] = ((-1, -1), (-1, 1), (1, -1), (1, 1), (-2, 0), (2, 0), (0, -2), (0, 2))
"""Further steps, for layouts in which the horizon runs across the texels."""
OBLIQUE_PAIRS = tuple((a,) for a in OBLIQUE) + tuple((a, b) for a in OBLIQUE for b in STEPS)
NEAR, HORIZONTAL = 2e-3, 4e-3
"""What is left of the mean direction, from which on further steps are tried, and what the ground's light may be off."""


class Spot(NamedTuple):
    """Texels (n,), each once, by row and column, and the XYZ flux that falls in each, (n, 3)."""

    row: np.ndarray
    column: np.ndarray
    flux: np.ndarray


def disc_on_map(
    disc: SunDisc, factor: float, projection: Projection, height: int, space: RGBSpace
) -> Iterator[TexelLight]:
    """What the disc gives the texels of a map.

    Each of many points of the disc gives its flux to the texel that it falls in; then a part of the whole pattern moves
    by one texel up or down, and left or right, so that its mean direction is the disc's. The sum of luminance x solid
    angle is the disc's illuminance, and the light on the horizontal the disc's too, at every height. Points below the
    horizon are dropped: of a sun that sets only the visible part remains. For a sun lower than half a texel the row
    below the horizon takes what the row above must not have. Where no texels allow both, as on a fisheye, which has
    none below, or at the zenith of a coarse cube, the light on the horizontal is kept within 0.4 %, not the sum.
    """
    if not bool(disc.is_day):
        return
    angles = np.broadcast_to(projection.solid_angles(height), projection.shape(height))
    directions, light = disc.points(disc_points(disc, 4 * np.pi / angles.size))
    row, column, covered = projection.pixels(directions, height)
    seen = covered & (directions[:, 2] >= 0) & (light[:, 1] > 0)
    if not seen.any():
        return
    texels = within_rim(row[seen], column[seen], angles)
    light = light[seen]
    wanted = directions[seen].T @ light[:, 1] / light[:, 1].sum()
    for part in centred(gathered(*texels, light, angles.shape[1]), wanted, projection, angles):
        share = part.flux * (factor / angles[part.row, part.column][:, None])
        yield TexelLight(part.row, part.column, rgb_from_xyz(share, space))


def disc_points(disc: SunDisc, texel: float) -> int:
    """How many points stand for the disc on texels of a solid angle, sr: thousands in every texel that it fills."""
    texels = np.pi * float(disc.angular_radius) ** 2 / texel
    return int(min(MOST_POINTS, max(LEAST_POINTS, POINTS_PER_TEXEL * texels)))


def within_rim(row: np.ndarray, column: np.ndarray, angles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Texels (n,), (n,) of continuous coordinates; one further in where a round map's rim cuts the texel away."""
    middle = np.array(angles.shape)[:, None] / 2
    place = np.stack([row, column])
    inward = (middle - place) / np.maximum(np.linalg.norm(middle - place, axis=0), 1e-9)
    cut = angles[tuple(place.astype(np.int64))] == 0
    found = (place + 1.5 * inward * cut).astype(np.int64)
    return found[0], found[1]


def gathered(row: np.ndarray, column: np.ndarray, flux: np.ndarray, columns: int) -> Spot:
    """The spot of points (n,) with their flux (n, 3): points in one texel together."""
    texels, place = np.unique(row * columns + column, return_inverse=True)
    total = np.zeros((texels.size, 3))
    np.add.at(total, place, flux)
    return Spot(texels // columns, texels % columns, total)


def centred(spot: Spot, wanted: np.ndarray, projection: Projection, angles: np.ndarray) -> list[Spot]:
    """The spot, parts of it moved by a texel or two, so that its mean direction is `wanted` (3,)."""
    start, ways, moved = mean_direction(spot, projection, angles), {}, {}
    weights = np.array([1.0, 1.0, 1.0 / wanted[2]])  # the height's relative error counts
    part: dict[Step, float] = {}
    left = float(np.linalg.norm((start - wanted) * weights))
    for steps, pairs, enough in ((STEPS, STEP_PAIRS, 0.0), (OBLIQUE, OBLIQUE_PAIRS, NEAR)):
        if left <= enough:
            break
        for step in steps:
            if (there := shifted(spot, step, projection, len(angles))) is not None:
                moved[step], ways[step] = there, mean_direction(there, projection, angles) - start
        options = [shares(ways, pair, wanted - start, weights) for pair in pairs if ways.keys() >= set(pair)]
        part, left = min([(part, left), *options], key=lambda option: option[1])
    rest = spot._replace(flux=spot.flux * (1 - sum(part.values())))
    found = [rest, *(moved[step]._replace(flux=spot.flux * share) for step, share in part.items())]
    height = float(start[2] + sum(share * ways[step][2] for step, share in part.items())) / float(wanted[2])
    kept = min(max(height, 1 - HORIZONTAL), 1 + HORIZONTAL) / height
    return [each._replace(flux=each.flux * kept) for each in found]


def mean_direction(spot: Spot, projection: Projection, angles: np.ndarray) -> np.ndarray:
    """Mean direction (3,) of the light in a spot's texels, its height by what the horizontal receives."""
    height, total = len(angles), np.zeros(3)
    for row in np.unique(spot.row):
        here = spot.row == row
        columns = spot.column[here]
        vectors = projection.vector_solid_angles(height, slice(row, row + 1))[0, columns]
        size = angles[row, columns]
        up = front_part(projection, height, spot.row[here], columns, ZENITH, vectors[:, 2], size)
        total += (spot.flux[here, 1] / size) @ np.column_stack([vectors[:, :2], up])
    mean: np.ndarray = total / spot.flux[:, 1].sum()
    return mean


def shifted(spot: Spot, step: Step, projection: Projection, height: int) -> Spot | None:
    """The spot a step on, over seams and poles; None where a texel of it would leave the map."""
    row, column, valid = spot.row, spot.column, np.ones(spot.row.shape, dtype=bool)
    for _ in range(max(map(abs, step))):
        down, right = np.sign(step)
        row, column, inside = projection.wrapped(row + down, column + right, height, row)
        valid = valid & inside
    return Spot(row, column, spot.flux) if valid.all() else None


def shares(
    ways: dict[Step, np.ndarray], steps: tuple[Step, ...], wanted: np.ndarray, weights: np.ndarray
) -> tuple[dict[Step, float], float]:
    """What share of the light takes each of `steps` to move the mean by `wanted` (3,), and the error that is left."""
    matrix = np.stack([ways[step] for step in steps], axis=1)
    found = np.linalg.lstsq(matrix * weights[:, None], wanted * weights)[0]
    part = np.clip(found, 0.0, 1.0)
    part /= max(1.0, float(part.sum()))
    left = float(np.linalg.norm((matrix @ part - wanted) * weights))
    return dict(zip(steps, part.tolist(), strict=True)), left
