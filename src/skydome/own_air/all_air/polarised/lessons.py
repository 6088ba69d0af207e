"""What the network of polarisation learns from: solved airs in a folder, one file a batch, as `all_air.lessons`."""

from collections.abc import Callable
from dataclasses import dataclass
from os import PathLike
from pathlib import Path

import numpy as np

from skydome.ground.files.reading import arrays_in
from skydome.own_air.all_air.airs import AIRS, batch
from skydome.own_air.all_air.lessons import HELD, MOST_BYTES, random_suns, write_missing
from skydome.own_air.all_air.places import Places
from skydome.own_air.all_air.polarised.solver import PolarisedSolver
from skydome.own_air.all_air.solver import Solver
from skydome.skies.all_air.polarised.network import node_cosines
from skydome.skies.all_air.taught_air import Optics

VIEWS, AZIMUTHS = 20, 13
"""Nodes of half a sky."""
PLACES = Places(18, 15, 44, 9, 9, nodes=12, nodes_once=24, rising=8, falling=5)
"""Coarser than the rest's: shares of light within .001 of the finer grid's (rms), suns from 60 to -4 degrees."""
FIELDS = "excess", "q", "u"
MOST = np.array([0.5, 1.0, 1.0])[:, None]
"""Of the fields; what is beyond is the grid's own error, in the dark of deep ozone, and counts for nothing."""


def make_polarised_lessons(
    folder: str | PathLike[str],
    batches: int,
    seed: int = 1,
    places: Places = PLACES,
    report: Callable[[int, int, str], None] = lambda *_: None,
) -> int:
    """Solves so many batches of random airs with and without polarisation into a folder; the count that was missing.

    ValueError for fewer than one batch; OSError where the folder cannot be made. Needs numba and scipy.
    """

    def solver() -> PolarisedSolver:
        return PolarisedSolver(Solver.of(places))

    return write_missing(folder, batches, seed, solver, polarised_lesson, report)


def polarised_lesson(solver: PolarisedSolver, seed: int, number: int) -> dict[str, np.ndarray]:
    """The arrays of a batch's file: sines of suns, optical numbers (7, AIRS), the rest's `excess` of intensity by
    polarisation, Q and U over the rest without it, and the rest's `share` of all light: (AIRS, suns, nodes) each.
    """
    air = batch(seed, number)
    sines = random_suns(np.random.default_rng((seed, number, 1)))[number % 2 :: 2]
    given = sines, node_cosines(VIEWS), np.linspace(0, np.pi, AZIMUTHS)
    whole = solver.at_ground(solver.solve(air), *given)
    rest, once = solver.scalar.at_ground(solver.scalar.solve(air), *given)
    floor = 1e-3 * np.median(np.abs(rest), axis=(0, 2), keepdims=True)
    rest, total = np.maximum(rest, floor), np.maximum(rest + once, floor)
    light = {"excess": whole.rest / rest - 1, "q": whole.q / rest, "u": whole.u / rest, "share": rest / total}
    flat = {k: v.transpose(3, 1, 0, 2).reshape(AIRS, len(sines), -1).astype(np.float32) for k, v in light.items()}
    return {"sines": sines, "air": np.stack(air)} | flat


@dataclass(frozen=True, eq=False)
class PolarisedLessons:
    """Cases, air and sun: optical numbers (N,), the sun's sine (N,), fields (N, 3, nodes), the rest's share of the
    light (N, nodes), and whether the air is held back (N,).
    """

    air: Optics
    sines: np.ndarray
    fields: np.ndarray
    share: np.ndarray
    held: np.ndarray

    @classmethod
    def load(cls, folder: str | PathLike[str]) -> "PolarisedLessons":
        """The cases of a folder; ValueError where there are none."""
        files = sorted(Path(folder).glob("*-*.npz"))
        if not files:
            raise ValueError(f"the folder must hold lessons (make_polarised_lessons), got {folder}")
        parts = [cases(path, number) for number, path in enumerate(files)]
        numbers, sines, fields, share, held = (np.concatenate(part) for part in zip(*parts, strict=True))
        sound = (np.abs(fields) < MOST).all(axis=1)
        return cls(Optics(*numbers.T), sines, np.where(sound[:, None], fields, 0.0), share * sound, held)

    def chosen(self, which: np.ndarray) -> "PolarisedLessons":
        """Some of the cases."""
        air = Optics(*(part[which] for part in self.air))
        return PolarisedLessons(air, *(part[which] for part in (self.sines, self.fields, self.share, self.held)))


def cases(path: Path, number: int) -> tuple[np.ndarray, ...]:
    """The arrays of `PolarisedLessons` of one file, its numbers (N, 7)."""
    names = ("air", "sines", "share", *FIELDS)
    held_in_file = arrays_in(path, "a file of lessons of polarisation", set(names), MOST_BYTES)
    air, sines, share = (held_in_file[name] for name in names[:3])
    count = AIRS * len(sines)
    fields = np.stack([held_in_file[name] for name in FIELDS], axis=2).reshape(count, len(FIELDS), -1)
    held = (np.arange(AIRS) + AIRS * number) * 7919 % HELD == 3
    rows = np.repeat(air.T, len(sines), axis=0), np.tile(sines, AIRS)
    return *rows, fields, share.reshape(count, -1), np.repeat(held, len(sines))
