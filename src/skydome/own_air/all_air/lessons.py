"""What the networks of the physical sky learn from: solved airs in a folder, one file a batch.

A file appears whole or not at all, so that a run goes on where it was stopped, and several may work in one folder.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Self, TypeVar

import numpy as np

from skydome.ground.files.reading import arrays_in
from skydome.ground.writing import appearing, require_place
from skydome.own_air.all_air.airs import AIRS, batch
from skydome.own_air.all_air.places import FINEST, SCALE, Places
from skydome.own_air.all_air.solver import Solver
from skydome.skies.all_air.rest import features
from skydome.skies.all_air.taught_air import Optics
from skydome.skies.physical.cosine_series import view_nodes

Kind = TypeVar("Kind")

VIEWS, AZIMUTHS, SUNS = 32, 25, 56
"""Nodes of half a sky, and suns of each air: one in each of so many even parts, from -18 to 90 degrees."""
MOST_BYTES = 1 << 30
HELD = 10
"""Of so many airs one is never trained on."""


def make_lessons(
    folder: str | PathLike[str],
    batches: int,
    seed: int = 1,
    places: Places | None = None,
    report: Callable[[int, int, str], None] = lambda *_: None,
) -> int:
    """Solves so many batches of random airs into a folder; the count that was missing.

    ValueError for fewer than one batch, and for a grid too coarse to give finite light; OSError where the folder
    cannot be made. Needs numba and scipy.
    """
    return write_missing(folder, batches, seed, lambda: Solver.of(places or Places()), lesson_of, report)


def write_missing(
    folder: str | PathLike[str],
    batches: int,
    seed: int,
    solver: Callable[[], Kind],
    lesson: Callable[[Kind, int, int], dict[str, np.ndarray]],
    report: Callable[[int, int, str], None],
) -> int:
    """The count of batches that the folder lacked: each is now a file of the arrays of its `lesson` by a `solver`."""
    if batches < 1:
        raise ValueError(f"batches must be 1 or more, got {batches}")
    place = require_place(folder, folder=True)
    place.mkdir(exist_ok=True)
    missing = [number for number in range(batches) if not path_of(place, seed, number).exists()]
    if not missing:
        return 0
    solved = solver()
    for done, number in enumerate(missing):
        arrays = lesson(solved, seed, number)
        with appearing(path_of(place, seed, number)) as beside, beside.open("wb") as file:
            np.savez(file, allow_pickle=False, **arrays)
        report(done + 1, len(missing), f"batch {number}")
    return len(missing)


def path_of(folder: Path, seed: int, number: int) -> Path:
    """The file of a batch."""
    return folder / f"{seed:04d}-{number:05d}.npz"


def lesson_of(solver: Solver, seed: int, number: int) -> dict[str, np.ndarray]:
    """The arrays of a batch's file: sines of suns, optical numbers (7, AIRS), `rest` and `once` (AIRS, suns, nodes)."""
    air = batch(seed, number)
    sines = random_suns(np.random.default_rng((seed, number, 1)))
    cosines, azimuths = np.asarray(view_nodes(VIEWS - 8)), np.linspace(0, np.pi, AZIMUTHS)
    rest, once = solver.at_ground(solver.solve(air), sines, cosines, azimuths)
    if not (np.isfinite(rest).all() and np.isfinite(once).all()):
        raise ValueError(f"the light of batch {number} must be finite: the grid of {solver.places} is too coarse")
    shape = (AIRS, SUNS, VIEWS * AZIMUTHS)
    light = {"rest": rest, "once": once}
    return {"sines": sines, "air": np.stack(air)} | {
        k: v.transpose(3, 1, 0, 2).reshape(shape) for k, v in light.items()
    }


def random_suns(random: np.random.Generator) -> np.ndarray:
    """Sines of elevations, rising, (SUNS,): dense where the light changes fastest."""
    low, high = (np.arcsinh((edge - FINEST) / SCALE) for edge in (-18.0, 90.0))
    share = (np.arange(SUNS) + random.random(SUNS)) / SUNS
    return np.asarray(np.sin(np.radians(FINEST + SCALE * np.sinh(low + (high - low) * share))))


@dataclass(frozen=True, eq=False)
class Cases(ABC):
    """Cases, air and sun: the sun's sine (N,), rest and light scattered once (N, nodes), and whether the air is held
    back (N,).
    """

    sines: np.ndarray
    rest: np.ndarray
    once: np.ndarray
    held: np.ndarray

    @abstractmethod
    def inputs(self) -> np.ndarray:
        """What the network reads, (N, 1, F)."""

    @abstractmethod
    def chosen(self, which: np.ndarray) -> Self:
        """Some of the cases."""


@dataclass(frozen=True, eq=False)
class Lessons(Cases):
    """Cases of clear air, its optical numbers (N,)."""

    air: Optics

    @classmethod
    def load(cls, folder: str | PathLike[str], low: float = -18.0, high: float = 90.0) -> "Lessons":
        """The cases of a folder with the sun between two elevations, degrees; ValueError where there are none."""
        files = sorted(Path(folder).glob("*-*.npz"))
        if not files:
            raise ValueError(f"the folder must hold lessons (make_lessons), got {folder}")
        low, high = np.sin(np.radians([low, high]))
        parts = [cases(path, number, low, high) for number, path in enumerate(files)]
        numbers, sines, rest, once, held = (np.concatenate(part) for part in zip(*parts, strict=True))
        floor = 1e-3 * np.median(np.abs(rest), axis=1, keepdims=True)
        return cls(sines, np.maximum(rest, floor), once, held, Optics(*numbers.T))

    def chosen(self, which: np.ndarray) -> Self:
        """Some of the cases."""
        air = Optics(*(part[which] for part in self.air))
        return type(self)(self.sines[which], self.rest[which], self.once[which], self.held[which], air)

    def inputs(self) -> np.ndarray:
        """What the network reads, (N, 1, F)."""
        return np.asarray(features(Optics(*(part[:, None] for part in self.air)), self.sines))


def cases(path: Path, number: int, low: float, high: float) -> tuple[np.ndarray, ...]:
    """The arrays of `Lessons` of one file, its numbers (N, 7)."""
    names = ("air", "sines", "rest", "once")
    held_in_file = arrays_in(path, "a file of lessons", set(names), MOST_BYTES)
    air, sines, rest, once = (held_in_file[name] for name in names)
    own = (sines >= low) & (sines <= high)
    count = int(own.sum())
    held = (np.arange(AIRS) + AIRS * number) * 7919 % HELD == 3
    flat = [light[:, own].reshape(AIRS * count, -1) for light in (rest, once)]
    return np.repeat(air.T, count, axis=0), np.tile(sines[own], AIRS), *flat, np.repeat(held, count)
