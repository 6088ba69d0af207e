"""The overcast sky's network, trained on lessons: shapes of the dome first, then a network of their coefficients."""

from collections.abc import Callable
from os import PathLike

import numpy as np

from skydome.own_air.all_air.training import Course, whole
from skydome.own_air.clouds.fitting import fitted
from skydome.own_air.clouds.lessons import OvercastLessons
from skydome.own_air.clouds.shapes import CloudShapes, solid_angles
from skydome.skies.clouds.overcast_files import save_overcast
from skydome.skies.clouds.overcast_network import OvercastNetwork

OVERCAST = Course(0.0, 90.0, shapes=20, tamed=0.1, mean_shapes=4, width=89, steps=5000, terms=7)
POLISHING = 3000
"""Steps over all cases, after the course's over some."""


def train_overcast(
    folder: str | PathLike[str],
    output: str | PathLike[str],
    course: Course = OVERCAST,
    seed: int = 0,
    report: Callable[[float], None] = lambda _: None,
    polishing: int = POLISHING,
) -> float:
    """Trains the network on a folder of lessons and writes it to a file; the rms error of the whole radiance on layers
    held back. Needs torch.
    """
    lessons = OvercastLessons.load(folder)
    taught = lessons.chosen(~lessons.held)
    network = fitted(taught, CloudShapes.of(taught, course), course, polishing, seed, report)
    save_overcast(output, network, f"skydome.own_air.clouds: seed {seed}, {course}")
    return rms_error(network, lessons.chosen(lessons.held))


def rms_error(network: OvercastNetwork, lessons: OvercastLessons) -> float:
    """Of the whole radiance over the domes of all cases, even in solid angle; ValueError where no case is left."""
    if not len(lessons.sines):
        raise ValueError("no layer is held back: make more lessons")
    coefficients = network.coefficients(lessons.inputs(), lessons.sines)[:, 0]
    logs = coefficients[:, :-1] @ whole(network.shapes) + coefficients[:, -1:] * lessons.glow
    off = (np.exp(logs) - lessons.rest) / (lessons.rest + lessons.once)
    return float(np.sqrt((off**2 @ solid_angles()).mean()))
