"""The numbers of a Prague file: which skies it holds, and its blocks of numbers, mapped and read as they are asked for.

The layout is that of the authors' data sets (C++ program of 2022): counts as 32-bit integers and values as doubles,
then for each visibility, albedo, altitude, sun and channel a sum of products of piecewise linear curves, in halves.
"""

from dataclasses import dataclass
from functools import cache
from os import PathLike
from pathlib import Path
from typing import BinaryIO, NamedTuple

import numpy as np

from skydome.ground.arguments import require_file

MOST = 100_000
"""Most values that a list of a file may have."""


class Curves(NamedTuple):
    """Curves of every sky (V, B, A, S, C): `table` by fields, and the angles, rad, between which curves are linear."""

    table: np.ndarray
    sun_breaks: np.ndarray
    zenith_breaks: np.ndarray
    emphasis_breaks: np.ndarray


class Passage(NamedTuple):
    """Square roots of transmittance: `places` (A, D, H, rank), `weights` (V, A, C, rank), and where they hold."""

    altitudes: np.ndarray
    visibilities: np.ndarray
    places: np.ndarray
    weights: np.ndarray


@dataclass(frozen=True, eq=False)
class PragueFile:
    """What a Prague file holds: visibilities, m; albedos; altitudes, m; suns' elevations, degrees; bands, nm.

    `bands` are the channels' middles, `band_width` wide. `transmittance` and `polarisation` are None where the file has
    none; `missing` says why.
    """

    path: str
    visibilities: np.ndarray
    albedos: np.ndarray
    altitudes: np.ndarray
    elevations: np.ndarray
    bands: np.ndarray
    band_width: float
    radiance: Curves
    transmittance: Passage | None
    polarisation: Curves | None
    missing: str


@cache
def read_prague(path: str | PathLike[str]) -> PragueFile:
    """What a Prague file holds; FileNotFoundError without one, ValueError for a file that is none."""
    place = require_file(path, "a Prague file")
    size = place.stat().st_size
    with place.open("rb") as file:
        try:
            visibilities, albedos, altitudes, elevations = (values(file) for _ in range(4))
            channels = integer(file)
            start, width = np.fromfile(file, "<f8", 2)
            shape = (visibilities.size, albedos.size, altitudes.size, elevations.size, channels)
            require_sense(visibilities, albedos, altitudes, elevations, start, width, channels)
            rank, breaks = integer(file), [values(file) for _ in range(3)]
            radiance = mapped(place, file, emphasised(rank, breaks), shape, size)
        except (EOFError, ValueError, IndexError, OSError) as error:
            raise ValueError(f"{path} is not a file of the Prague sky model ({error})") from None
        passage, polarisation, missing = the_rest(place, file, shape, size)
    bands = start + width * (np.arange(channels) + 0.5)
    return PragueFile(
        str(path), visibilities * 1000, albedos, altitudes, elevations, bands, float(width),
        Curves(radiance, breaks[0], breaks[1], breaks[2]), passage, polarisation, missing,
    )  # fmt: skip


def integer(file: BinaryIO) -> int:
    """A count; ValueError unless it lies in 1 ... MOST."""
    found = np.fromfile(file, "<i4", 1)
    if not found.size:
        raise EOFError("it ends early")
    count = int(found[0])
    if not 1 <= count <= MOST:
        raise ValueError(f"a count in it is {count}")
    return count


def values(file: BinaryIO) -> np.ndarray:
    """A list with its count before it; ValueError unless it is finite and increases."""
    count = integer(file)
    found = np.fromfile(file, "<f8", count)
    if found.size < count:
        raise EOFError("it ends early")
    if not np.isfinite(found).all() or (np.diff(found) <= 0).any():
        raise ValueError("a list in it does not increase")
    return found


def require_sense(*parts: np.ndarray | float) -> None:
    """ValueError unless the lists are what they are taken for."""
    visibilities, albedos, altitudes, elevations, start, width, channels = parts
    sensible = np.all(np.asarray(visibilities) > 0) and np.min(albedos) >= 0 and np.max(albedos) <= 1
    sensible &= np.min(altitudes) >= 0 and np.max(np.abs(elevations)) <= 90
    if not (sensible and 100 <= start < 10_000 and 0 < width <= 1000 and channels <= 1000):
        raise ValueError("its lists of visibilities, albedos, heights, suns and bands make no sense")


def emphasised(rank: int, breaks: list[np.ndarray]) -> np.dtype:
    """A radiance's record: curves of the sun's angle and, scaled, of the zenith's, `rank` of them, and the emphasis."""
    sun, zenith, emphasis = (part.size for part in breaks)
    term = np.dtype([("sun", "<f2", (sun,)), ("scale", "<f8"), ("zenith", "<f2", (zenith,))])
    return np.dtype([("terms", term, (rank,)), ("emphasis", "<f2", (emphasis,))])


def mapped(path: Path, file: BinaryIO, record: np.dtype, shape: tuple[int, ...], size: int) -> np.ndarray:
    """The records of a block, read when asked for; `file` is moved behind it. ValueError where it is too short."""
    begin, length = file.tell(), record.itemsize * int(np.prod([float(n) for n in shape]))
    if begin + length > size:
        raise ValueError(f"it holds {size} bytes where {begin + length} are told")
    file.seek(begin + length)
    return np.memmap(path, record, "r", begin, shape)


def the_rest(
    path: Path, file: BinaryIO, shape: tuple[int, ...], size: int
) -> tuple[Passage | None, Curves | None, str]:
    """Transmittance and polarisation behind the radiance, each None where it is not there, and why."""
    if file.tell() == size:
        return None, None, "the file ends behind its radiance"
    try:
        passage = passage_of(path, file, shape[-1], size)
    except (EOFError, ValueError) as error:
        return None, None, f"its block of transmittance has the wrong size: {error}"
    if file.tell() == size:
        return passage, None, "the file has no polarisation"
    try:
        rank, breaks = integer(file), [values(file) for _ in range(2)]
        term = np.dtype([("sun", "<f4", (breaks[0].size,)), ("zenith", "<f4", (breaks[1].size,))])
        table = mapped(path, file, np.dtype([("terms", term, (rank,))]), shape, size)
    except (EOFError, ValueError) as error:
        return None, None, f"what lies behind its radiance has the wrong size: {error}"
    if file.tell() != size:
        return None, None, f"{size - file.tell()} bytes too many lie behind its radiance"
    return passage, Curves(table, breaks[0], breaks[1], np.zeros(0)), ""


def passage_of(path: Path, file: BinaryIO, channels: int, size: int) -> Passage:
    """The block of transmittance."""
    distances, heights, visibility_count, altitude_count, rank = (integer(file) for _ in range(5))
    altitudes, visibilities = (np.fromfile(file, "<f4", n).astype(float) for n in (altitude_count, visibility_count))
    wrong = [part for part in (altitudes, visibilities) if not np.isfinite(part).all() or (np.diff(part) <= 0).any()]
    if wrong or altitudes.size < altitude_count or visibilities.size < visibility_count:
        raise ValueError("its lists do not increase")
    single = np.dtype("<f4")
    places = mapped(path, file, single, (altitude_count, distances, heights, rank), size)
    weights = mapped(path, file, single, (visibility_count, altitude_count, channels, rank), size)
    return Passage(altitudes, visibilities * 1000, places, weights)
