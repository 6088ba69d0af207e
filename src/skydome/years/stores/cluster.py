"""Dask's workers: those of a scheduler, reached within a time limit, or processes of this machine."""

import logging
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from skydome.ground.extras import required
from skydome.ground.limits.sizes import MOST_WORKERS, require_count

PATIENCE = 10
"""Seconds in which a scheduler must answer."""


@contextmanager
def cluster_client(purpose: str, scheduler: str | None, workers: int) -> Iterator[Any]:
    """A client of the scheduler at an address, or of new single-threaded worker processes here.

    ConnectionError where no scheduler answers in time, ValueError for an address that is none, and unless there are
    1 to `MOST_WORKERS` workers.
    """
    required("dask.distributed", "scale", purpose)
    if scheduler is None:
        from dask.distributed import Client, LocalCluster

        if workers < 1:
            raise ValueError(f"workers must be 1 or more, got {workers}")
        require_count(workers, MOST_WORKERS, "workers")
        quiet = {"silence_logs": logging.CRITICAL}  # what goes wrong is raised, or computed again
        choices = quiet | {"n_workers": workers, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
        with LocalCluster(**choices) as local, Client(local) as client:
            yield client
        return
    with connected(scheduler) as client:
        yield client


def connected(scheduler: str) -> Any:
    """A client of the scheduler at an address."""
    from dask.distributed import Client

    try:
        return Client(scheduler, timeout=PATIENCE)
    except (OSError, ValueError) as error:
        raise ConnectionError(f"a Dask scheduler must answer at {scheduler} within {PATIENCE} s: {error}") from error
