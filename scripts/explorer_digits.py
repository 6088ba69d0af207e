"""Numbers as text that compresses well, for the explorer's page: whole multiples of a step, their differences along an
axis as digits, a letter each; a plane of letters for each place. gzip takes out what the small ones do not need.
"""

from typing import Any

import numpy as np

LETTERS = "".join(chr(code) for code in range(35, 127) if chr(code) not in "$'<\\`")
BASE = len(LETTERS)
HALF = BASE // 2
"""Digits from -HALF to HALF."""


def digits(values: np.ndarray, steps: Any, along: int) -> dict[str, Any]:
    """Numbers of an array as whole multiples of `steps`, one or one for each of the first axis."""
    wide = np.asarray(steps, np.float64).reshape(-1, *(1,) * (values.ndim - 1))
    whole = np.diff(np.round(values / wide).astype(np.int64), axis=along, prepend=0)
    told = [float(f"{step:.6g}") for step in wide.ravel()]
    return {"shape": list(values.shape), "along": along, "steps": told, "planes": planes(whole.ravel())}


def planes(whole: np.ndarray) -> list[str]:
    """Letters of the lowest digits, of the next ones, and so on."""
    found: list[str] = []
    while not found or whole.any():
        low = (whole + HALF) % BASE - HALF
        found.append("".join(LETTERS[k] for k in low + HALF))
        whole = (whole - low) // BASE
    return found


def numbers_of(packed: dict[str, Any]) -> np.ndarray:
    """The numbers again."""
    place = {letter: k - HALF for k, letter in enumerate(LETTERS)}
    whole = sum(
        BASE**n * np.array([place[letter] for letter in text], np.int64) for n, text in enumerate(packed["planes"])
    )
    wide = np.asarray(packed["steps"]).reshape(-1, *(1,) * (len(packed["shape"]) - 1))
    return np.asarray(np.cumsum(np.reshape(whole, packed["shape"]), axis=packed["along"]) * wide)
