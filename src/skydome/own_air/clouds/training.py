"""The overcast sky's network, trained on lessons as the physical sky's are."""

from collections.abc import Callable
from os import PathLike

from skydome.own_air.all_air.training import Course, rms_error, taught
from skydome.own_air.clouds.lessons import OvercastLessons
from skydome.own_air.clouds.polishing import polished
from skydome.skies.clouds.overcast_files import save_overcast

OVERCAST = Course(0.0, 90.0, shapes=24, tamed=0.1, mean_shapes=5, width=72, steps=16_000, terms=9)
POLISHING = 750
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
    network = polished(taught(lessons, course, seed, report), lessons.chosen(~lessons.held), polishing)
    save_overcast(output, network, f"skydome.own_air.clouds: seed {seed}, {course}")
    return rms_error(network, lessons.chosen(lessons.held))
