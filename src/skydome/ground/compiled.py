"""The compiled floor: Numba's decorator with what it falls back to, and compiled jobs shared among threads.

Kernels stand in files named kernel.py or ..._kernel.py, beside the readable form that each is tested against
(tests/test_kernels.py has the pairs). They take plain arrays and write into memory that the caller lends; what they
share, down to exp and random numbers, is in `elementary_kernel`. Only they import Numba: where it is missing
(`has_numba`), callers take the readable form. No kernel starts threads of its own: Numba's plainest threading layer
ends the process when two threads enter at once. Kernels let go of the interpreter's lock instead, and `shared` gives
them ranges of a job in ordinary threads.
"""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from importlib.util import find_spec
from typing import Any

EXACT = frozenset[str]()
"""Arithmetic as it is written."""
IN_ORDER = frozenset({"contract", "nsz", "arcp"})
"""Products may be fused with sums and divisions made products, but sums are added in the order that they have."""
ANY_ORDER = IN_ORDER | {"reassoc"}
"""Sums in any order too, so that they run in vectors."""

VALUES_PER_PIECE = 1 << 17
"""Numbers of light that are worth a thread's while."""


def compiled(function: Callable[..., Any], fastmath: frozenset[str] = EXACT, cache: bool = True, **options: Any) -> Any:
    """`function` by Numba, kept on disk where a folder can be written to."""
    from numba import njit

    choices = {"nogil": True, "error_model": "numpy", "fastmath": set(fastmath), **options}
    try:
        return njit(cache=cache, **choices)(function)
    except RuntimeError:  # no folder for the cache
        return njit(**choices)(function)


def job(fastmath: frozenset[str] = EXACT) -> Callable[..., Any]:
    """A decorator for what Python calls."""
    return partial(compiled, fastmath=fastmath)


def piece(fastmath: frozenset[str] = EXACT) -> Callable[..., Any]:
    """A decorator for what only other compiled functions call."""
    return partial(compiled, fastmath=fastmath, cache=False, no_cpython_wrapper=True, no_cfunc_wrapper=True)


def inlined(fastmath: frozenset[str] = EXACT) -> Callable[..., Any]:
    """A decorator for what is compiled into its caller; it must not make arrays, as references are not counted.

    Loops run in vectors only if nothing is called in them; and counting references (Numba's habit, switched off where
    it can be) took almost half of the path tracer's time.
    """
    from numba.core.options import DefaultOptions

    wished: dict[str, Any] = {"forceinline": True, "_nrt": False}
    return partial(compiled, fastmath=fastmath, **{k: v for k, v in wished.items() if hasattr(DefaultOptions, k)})


def has_numba() -> bool:
    """Whether there is a compiler."""
    return find_spec("numba") is not None


def workers() -> int:
    """Processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def shared(
    run: Callable[..., Any], count: int, values: int, given: tuple[Any, ...] = (), least: int = VALUES_PER_PIECE
) -> list[Any]:
    """The answers of run(first, last, *given) over pieces of range(count), in threads.

    `values` is the whole job's size; pieces have `least` of them or more, and there are at most four to a processor.
    """
    pieces = max(1, min(count, 4 * workers(), values // least))
    edges = [count * k // pieces for k in range(pieces + 1)]
    if pieces == 1:
        return [run(0, count, *given)]
    with ThreadPoolExecutor(min(workers(), pieces)) as pool:
        return list(pool.map(lambda first, last: run(first, last, *given), edges[:-1], edges[1:]))
