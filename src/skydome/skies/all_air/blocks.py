"""Work on arrays that broadcast, some of it at a time, so that what is in between stays in the processor's cache."""

from collections.abc import Iterator
from typing import Any

import numpy as np

Block = tuple[Any, ...]
"""A slice of every axis of the shape that arrays broadcast to; the first may be an array of indices."""


def blocks(shape: tuple[int, ...], most: int) -> Iterator[Block]:
    """Slices that cut an array of `shape` into pieces of at most `most` elements, along the first axes.

    >>> [tuple((s.start, s.stop) for s in block) for block in blocks((3, 2), 4)]
    [((0, 2), (0, 2)), ((2, 3), (0, 2))]
    """
    rest = int(np.prod(shape[1:]))
    if not shape or shape[0] * rest <= most:
        yield tuple(slice(0, count) for count in shape)
        return
    step = max(1, most // max(rest, 1))
    for start in range(0, shape[0], step):
        for inner in blocks(shape[1:], max(most, 1)):
            yield (slice(start, min(start + step, shape[0])), *inner)


def part_of(array: np.ndarray, block: Block, trailing: int = 1) -> np.ndarray:
    """The block of an array whose axes, but for the `trailing` ones, broadcast to the blocks' shape.

    >>> part_of(np.zeros((4, 1, 3)), (slice(0, 2), slice(0, 5))).shape
    (2, 1, 3)
    """
    lead = array.ndim - trailing
    own = block[len(block) - lead :]
    return array[tuple(s if count > 1 else slice(None) for s, count in zip(own, array.shape, strict=False))]
