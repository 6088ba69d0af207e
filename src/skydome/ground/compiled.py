"""The compiled floor: Numba's decorator with what it falls back to, and compiled jobs shared among threads.

Kernels stand in files named kernel.py or ..._kernel.py, beside the readable form that each is tested against
(tests/test_kernels.py has the pairs). They take plain arrays and write into memory that the caller lends; what they
share, down to exp and random numbers, is in `elementary_kernel`. Only they import Numba: where it is missing
(`has_numba`), callers take the readable form. No kernel starts threads of its own: Numba's plainest threading layer
ends the process when two threads enter at once. Kernels let go of the interpreter's lock instead, and `shared` gives
them ranges of a job in ordinary threads.
"""

import os
import time
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
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
    if not cache:
        return njit(**choices)(function)
    try:
        made = njit(cache=True, **choices)(function)
    except RuntimeError:  # no folder for the cache
        warnings.warn(NOT_KEPT, stacklevel=2)
        return njit(**choices)(function)
    forgiving(made._cache)
    return made


NOT_KEPT = (
    "compiled code cannot be kept here, and is made anew by each process; name a folder that can be written to in"
    " NUMBA_CACHE_DIR"
)


def forgiving(cache: Any) -> None:
    """Let a cache that is damaged, or on a full disk, cost time and a note, not the work."""
    load, save, clear = cache.load_overload, cache.save_overload, cache.flush

    def loaded(*given: Any) -> Any:
        try:
            return load(*given)
        except Exception:  # pickle raises anything over a damaged file
            with suppress(OSError):
                clear()
            return None

    def saved(*given: Any) -> None:
        try:
            save(*given)
        except Exception:
            warnings.warn(NOT_KEPT, stacklevel=2)

    cache.load_overload, cache.save_overload = loaded, saved


@contextmanager
def compiling() -> Iterator[Callable[[], float]]:
    """What tells for how many seconds Numba has been compiling, 0 where it is not; it hears of what begins within."""
    from numba.core.event import Listener, register, unregister

    class Ears(Listener):  # type: ignore[misc]
        since, depth = 0.0, 0

        def on_start(self, event: Any) -> None:
            self.depth += 1
            self.since = self.since or time.monotonic()

        def on_end(self, event: Any) -> None:
            self.depth -= 1
            self.since = self.since if self.depth > 0 else 0.0

    ears = Ears()
    register("numba:compile", ears)
    try:
        yield lambda: time.monotonic() - ears.since if ears.since else 0.0
    finally:
        unregister("numba:compile", ears)


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
