"""Many Perez skies on Reinhart's patches, row by row: float32 NumPy in blocks that the processor keeps at hand.

The indicatrix is written out in place here: `perez_formula.indicatrix` takes 4.7 times as long in NumPy.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from skydome.ground.tables import columns

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

BLOCK = 16384
"""Values worked on at once."""

KEPT = 2**20
"""Values that are kept between two passes, 4 MB; more are quicker computed twice."""


class Skies(NamedTuple):
    """Perez skies of the lit hours (K,) of T: their indices, letters (5, K), sun, and illuminances in lx.

    `zenith` is the formula's, `altitude` the sun's own; `beam` is on a plane that faces the sun.
    """

    lit: np.ndarray
    letters: np.ndarray
    zenith: np.ndarray
    azimuth: np.ndarray
    altitude: np.ndarray
    diffuse: np.ndarray
    beam: np.ndarray
    on_ground: np.ndarray


def rows_of(division: int) -> list[tuple[float, int, float]]:
    """Elevation (rounded to float32), patches and size (sr) of a patch of each of Reinhart's rows, the zenith last."""
    step = np.pi / 2 / (7 * division + 0.5)
    rows, counts = [], columns("tregenza")["patches"]
    for k in range(7 * division):
        count = int(counts[k // division]) * division
        size = 2 * np.pi * (np.sin(step * (k + 1)) - np.sin(step * k)) / count
        rows.append((float(np.float32(step * (k + 0.5))), count, float(size)))
    return [*rows, (float(np.float32(np.pi / 2)), 1, float(2 * np.pi * (1 - np.cos(step / 2))))]


def patch_rows(skies: Skies, division: int, level: "ArrayLike" = 1.0) -> Iterator[tuple[np.ndarray, float, float]]:
    """Luminance of some patches (J, K), float32, their elevation and solid angle; patch by patch in Radiance's order.

    Relative, times `level` (K,). The array is used again for the next patches. The angle to the sun by the haversine
    form: hav = P + Q W, with P and Q of the row and W = sin^2 of half the azimuth difference, which rows of equally
    many patches share.
    """
    real = np.float32
    a, b, c, d, e = skies.letters
    twice_d, width, away = (2 * d).astype(real), skies.zenith.size, np.empty((0, 0), real)
    at_once = max(1, BLOCK // max(width, 1))
    scratch = np.empty((2, at_once, width), real)
    for elevation, count, size in rows_of(division):
        if len(away) != count:
            turns = (2 * np.pi * np.arange(count) / count).astype(np.float32).astype(np.float64)
            away = half_turns(turns, skies.azimuth)
        zenith = np.pi / 2 - elevation
        base = (np.sin((zenith - skies.zenith) / 2) ** 2).astype(real)
        lever = (np.sin(zenith) * np.sin(skies.zenith)).astype(real)
        gradation = level * (1 + a * np.exp(np.minimum(b / np.cos(zenith), 700)))
        factors = [(gradation * term).astype(real) for term in (c, 4 * e, 1)]
        for k in range(0, count, at_once):
            part = away[k : k + at_once]
            yield indicatrix(part, base, lever, twice_d, factors, scratch[:, : len(part)]), elevation, size


def half_turns(turns: np.ndarray, azimuth: np.ndarray) -> np.ndarray:
    """sin^2 of half the difference of azimuths, float32, (J, K)."""
    away = np.empty((turns.size, azimuth.size), np.float32)
    for k, turn in enumerate(turns):
        np.sin((0.5 * (turn - azimuth)).astype(np.float32), out=away[k])
    away *= away
    return away


def indicatrix(
    away: np.ndarray, base: np.ndarray, lever: np.ndarray, twice_d: np.ndarray, factors: list[np.ndarray], scratch: Any
) -> np.ndarray:
    """max(0, G + G c exp(d g) + G e cos^2 g), (J, K), in scratch (2, J, K); cos^2 g = 4 (hav - 1/2)^2."""
    hav, light = scratch
    peak, square, constant = factors
    np.multiply(away, lever, out=hav)
    hav += base
    np.minimum(hav, np.float32(1), out=hav)
    np.sqrt(hav, out=light)
    np.arcsin(light, out=light)
    light *= twice_d
    np.exp(light, out=light)
    light *= peak
    hav -= np.float32(0.5)
    hav *= hav
    hav *= square
    light += hav
    light += constant
    lit: np.ndarray = np.maximum(light, np.float32(0), out=light)
    return lit


def horizontal_sums(skies: Skies, division: int) -> tuple[np.ndarray, list[np.ndarray]]:
    """Sum over the patches of relative luminance, sine of elevation and solid angle, (K,): relative illuminance.

    And the luminances themselves, some patches at a time, where they are few enough to be kept: `KEPT`.
    """
    total, kept = np.zeros(skies.zenith.size), []
    few = (144 * division**2 + 1) * skies.zenith.size <= KEPT
    for light, elevation, size in patch_rows(skies, division):
        total += light.sum(axis=0) * (np.sin(elevation) * size)
        if few:
            kept.append(light.copy())
    return total, kept
