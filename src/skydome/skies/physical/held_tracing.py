"""A traced sky held in a table: the paths start where the table has its nodes, until an error or a count is reached."""

from collections.abc import Callable

import numpy as np

from skydome.skies.path_tracing.sky import PathTraced
from skydome.skies.physical.held import HeldSky, held, node_directions

USUAL_ERROR = 0.01
BANDS = np.arange(380.0, 781.0, 20.0)
MOST_PASSES = 100_000

Report = Callable[[float, float], None]
"""Called with the share of the work that is done, 0-1, and the relative error so far."""


def held_tracing(
    sky: PathTraced, until: float | None = None, paths: int | None = None, report: Report | None = None
) -> HeldSky:
    """The colours of a path-traced sky, traced `until` a median relative error or for so many `paths` a direction.

    Neither: until 1 %; `paths` alone: all of them; both: whichever comes first. ValueError for too few paths.
    """
    wanted = (USUAL_ERROR if paths is None else 1e-6) if until is None else until
    most = MOST_PASSES if paths is None else passes_for(paths, sky.paths_per_pass)
    by_error = until is not None or paths is None

    def passed(error: float, passes: int) -> None:
        done = (wanted / error) ** 2 if by_error and error > 0 else 0.0
        if report is not None:
            report(max(done, passes / most), error)

    tracing = sky.job(node_directions(sky.sun), BANDS).start().until(wanted, most, passed)
    return held(sky, BANDS, tracing.radiance)


def passes_for(paths: int, each: int) -> int:
    """Passes of `each` paths that make up the count; ValueError below 2 passes, which tell no error."""
    if paths < 2 * each:
        raise ValueError(f"paths must be {2 * each} or more, got {paths}")
    return -(-paths // each)
