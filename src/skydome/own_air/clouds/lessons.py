"""What the overcast sky's network learns from: random layers of cloud by discrete ordinates, one file a batch."""

from collections.abc import Callable
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Self

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.files.reading import arrays_in
from skydome.own_air.all_air.lessons import AZIMUTHS, HELD, MOST_BYTES, VIEWS, Cases, write_missing
from skydome.own_air.clouds.layers import RandomLayer, hard_layer, random_layer
from skydome.skies.clouds.layer_features import features
from skydome.skies.clouds.layer_light import once
from skydome.skies.clouds.layer_optics import PEAK, LayerOptics, layer_optics
from skydome.skies.clouds.overcast_network import glow
from skydome.skies.clouds.two_streams import DARK, course
from skydome.skies.physical.cosine_series import LEAST_COSINE, interpolated, view_nodes
from skydome.skies.physical.discrete_ordinates import Solution

CASES = 32
"""In a batch."""
EASY = 148
"""The first so many batches are of layers as they come; of those after, every other one is of hard ones."""
ACCURACY = 1e-4
"""Of the azimuth's terms: they end where two came to less than this of the light."""

LEAST_ALBEDO = 0.83
"""Single scattering albedo of clouds that absorb too much to learn from."""


def make_overcast_lessons(
    folder: str | PathLike[str], batches: int, seed: int = 1, report: Callable[[int, int, str], None] = lambda *_: None
) -> int:
    """Solves so many batches of random layers into a folder; the count that was missing. Needs nanodisort."""
    return write_missing(folder, batches, seed, lambda: None, lambda _, *which: lesson_of(*which), report)


def lesson_of(seed: int, number: int) -> dict[str, np.ndarray]:
    """The arrays of a batch's file: sines of suns (N,), optical numbers (10, N), `rest` and `once` (N, nodes)."""
    random, draw = (
        np.random.default_rng((seed, number, 2)),
        hard_layer if number >= EASY and number % 2 else random_layer,
    )
    solved = [solve(draw(random)) for _ in range(CASES)]
    sines, numbers, rest, single = zip(*solved, strict=True)
    return {"sines": np.array(sines), "air": np.array(numbers).T, "rest": np.stack(rest), "once": np.stack(single)}


def solve(layer: RandomLayer) -> tuple[float, np.ndarray, np.ndarray, np.ndarray]:
    """The sun's sine, the numbers (10,), and at the nodes, float32: the rest, and what the cloud scatters once."""
    w = np.array([layer.wavelength])
    sine = max(float(np.sin(np.radians(layer.elevation))), LEAST_COSINE)
    air = Atmosphere((layer.molecules, layer.ozone, layer.cloud), albedo=layer.albedo)
    solution = Solution.of(air, sine, w, PEAK, ACCURACY)
    view, relative = node_views()
    angle = angles(np.array([sine]))[0]
    molecules = layer.molecules.phase_law.value(angle, w) * solution.layers.strengths(view, angle, sine)[0]
    rest = (interpolated(solution.series, view, relative) + molecules)[:, 0]
    numbers = layer_optics(layer.molecules, layer.ozone, layer.cloud, np.array([layer.albedo]), w)
    single = once(numbers, view, np.array(sine), angle)[:, 0]
    single = single * layer.cloud.phase_law.value(angle, w)[:, 0]
    return sine, np.concatenate(numbers), *(part.astype(np.float32) for part in (rest, single))


def node_views() -> tuple[np.ndarray, np.ndarray]:
    """Cosine to the vertical and azimuth from the sun of the nodes, (nodes,) each."""
    view, relative = np.meshgrid(view_nodes(VIEWS - 8), np.linspace(0, np.pi, AZIMUTHS), indexing="ij")
    return view.ravel(), relative.ravel()


def angles(sines: np.ndarray) -> np.ndarray:
    """Cosines of the nodes' angles to suns of such sines (N,), (N, nodes)."""
    (view, relative), sine = node_views(), sines[:, None]
    return np.asarray(np.minimum(view * sine + np.sqrt((1 - view**2) * (1 - sine**2)) * np.cos(relative), 1.0))


@dataclass(frozen=True, eq=False)
class OvercastLessons(Cases):
    """Cases of a layer, its optical numbers (N,); `once` is the cloud's. Light in units of `Course.typical`."""

    air: LayerOptics

    @classmethod
    def load(cls, folder: str | PathLike[str]) -> "OvercastLessons":
        """All cases of a folder; ValueError where there are none."""
        files = sorted(Path(folder).glob("*-*.npz"))
        if not files:
            raise ValueError(f"the folder must hold lessons (make_overcast_lessons), got {folder}")
        names = ("air", "sines", "rest", "once")
        read = [arrays_in(path, "a file of lessons", set(names), MOST_BYTES) for path in files]
        numbers = np.concatenate([part["air"] for part in read], axis=1)
        sines, rest, single = (np.concatenate([part[name] for part in read]) for name in names[1:])
        held = np.arange(len(sines)) * 7919 % HELD == 3
        air = LayerOptics(*numbers)
        unit = course(LayerOptics(*(part[:, None] for part in air)), sines).typical.astype(np.float32)
        every = cls(sines, (np.maximum(rest, 0.0) + np.float32(DARK)) / unit, single / unit, held, air)
        return every.chosen(every.air.albedo > LEAST_ALBEDO)

    def chosen(self, which: np.ndarray) -> Self:
        """Some of the cases."""
        air = LayerOptics(*(part[which] for part in self.air))
        return type(self)(self.sines[which], self.rest[which], self.once[which], self.held[which], air)

    def inputs(self) -> np.ndarray:
        """What the network reads, (N, 1, F)."""
        return np.asarray(features(LayerOptics(*(part[:, None] for part in self.air)), self.sines))

    @property
    def glow(self) -> np.ndarray:
        """The glow about the sun at the nodes, float32, (N, nodes)."""
        return np.asarray(glow(angles(self.sines)), dtype=np.float32)
