"""Bytes of a safetensors file that are the same for the same contents: the library itself shuffles the notes."""

import json
from collections.abc import Mapping

import numpy as np

HEAD = 8
"""Bytes of the header's length, which is a multiple of as many."""


def tensor_bytes(tensors: Mapping[str, np.ndarray], about: Mapping[str, str]) -> bytes:
    """The file of some tensors, with notes in its header in the order of their names.

    >>> file = tensor_bytes({"a": np.ones(2, np.float32)}, {"z": "last", "b": "first"})
    >>> file.index(b"first") < file.index(b"last"), len(file) % 8
    (True, 0)
    """
    from safetensors.numpy import save

    file = save({name: np.ascontiguousarray(value) for name, value in tensors.items()}, dict(about))
    end = HEAD + int.from_bytes(file[:HEAD], "little")
    header = json.loads(file[HEAD:end])
    header["__metadata__"] = dict(sorted(header.get("__metadata__", {}).items()))
    text = json.dumps(dict(sorted(header.items())), separators=(",", ":"), ensure_ascii=False).encode("utf-8")
    text += b" " * (-len(text) % HEAD)
    return len(text).to_bytes(HEAD, "little") + text + file[end:]
