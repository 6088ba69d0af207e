"""Files from anywhere: their size is known before they are unpacked, and whatever is wrong with one is a ValueError.

Nothing in a file is ever run. Decoders may raise anything over a damaged file; here it becomes one sentence.
"""

import json
from collections.abc import Iterator
from contextlib import contextmanager
from math import prod
from os import PathLike
from pathlib import Path
from typing import Any, BinaryIO
from zipfile import ZipFile

import numpy as np

from skydome.ground.arguments import require_file

MEGABYTE = 1 << 20
TEXT = 16 * MEGABYTE
"""Most bytes of a text that describes something: settings, numbers, a table of sites."""
SETTINGS = MEGABYTE
"""Most bytes of a TOML file, whose reader takes a second for each half megabyte."""


@contextmanager
def decoding(path: str | PathLike[str], what: str) -> Iterator[None]:
    """Whatever a decoder raises within, as a ValueError that says which file is no such thing."""
    try:
        yield
    except Exception as error:
        reason = " ".join(str(error).split())[:160] or type(error).__name__
        raise ValueError(f"cannot read {Path(path).name}, which is damaged or not {what}: {reason}") from error


def require_size(size: int, most: int, path: str | PathLike[str], what: str) -> None:
    """ValueError where a file, unpacked, would take more than it may."""
    if size > most:
        raise ValueError(f"{what} may take {most / MEGABYTE:.4g} MB, got {size / MEGABYTE:.4g} MB in {Path(path).name}")


def arrays_in(
    path: str | PathLike[str],
    what: str,
    names: "set[str] | frozenset[str]",
    most: int,
    optional: "set[str] | frozenset[str] | None" = frozenset(),
) -> dict[str, np.ndarray]:
    """The named arrays of an .npz file; ValueError in one line where one lacks, is damaged or holds no numbers or text.

    Together they take at most `most` bytes, which is known before any of them is unpacked. Of `optional` ones those are
    given that are there; None: all others too.
    """
    file = require_file(path, what)
    with decoding(file, what):
        archive = ZipFile(file)
    with archive:
        there = {Path(name).stem: name for name in archive.namelist()}
        missing = sorted(names - set(there))
        if missing:
            raise ValueError(f"{file.name} is not {what}: it lacks {', '.join(missing)}")
        wanted = sorted(there if optional is None else (names | optional) & set(there))
        require_size(sum(archive.getinfo(there[name]).file_size for name in wanted), most, file, what)
        with decoding(file, what):
            return {name: array_of(archive, there[name]) for name in wanted}


def array_of(archive: ZipFile, name: str) -> np.ndarray:
    """An array of an .npz file, once its head has been found to fit what follows."""
    info = archive.getinfo(name)
    with archive.open(info) as stored:
        shape, dtype = head_of(stored)  # type: ignore[arg-type]
    if dtype.kind not in "fiubUSc" or prod(shape) * dtype.itemsize > info.file_size:
        raise ValueError(f"{name} has shape {shape} of {dtype}, {info.file_size} bytes in all")
    with archive.open(info) as stored:
        return np.asarray(np.lib.format.read_array(stored, allow_pickle=False))


def head_of(stored: BinaryIO) -> tuple[tuple[int, ...], np.dtype[Any]]:
    """Shape and kind of number of a stored array."""
    version = np.lib.format.read_magic(stored)
    if version not in ((1, 0), (2, 0)):
        raise ValueError(f"arrays of version {version} are not known")
    read = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
    shape, _, dtype = read(stored)
    return shape, dtype


def tensors_in(path: str | PathLike[str], most: int) -> tuple[dict[str, str], dict[str, np.ndarray]]:
    """The notes and tensors of a safetensors file of at most `most` bytes; ValueError in one line for anything else."""
    from safetensors import safe_open

    what = "a network file (safetensors)"
    file = require_file(path, what)
    require_size(file.stat().st_size, most, file, what)
    with decoding(file, what), safe_open(str(file), "numpy") as stored:
        return stored.metadata() or {}, {name: stored.get_tensor(name) for name in list(stored.keys())}


def text_in(path: str | PathLike[str], what: str, most: int = TEXT) -> str:
    """The text of a file, UTF-8 with or without its mark, of at most `most` bytes."""
    with require_file(path, what).open("rb") as file:
        content = file.read(most + 1)
    require_size(len(content), most, path, what)
    with decoding(path, what):
        return content.decode("utf-8-sig")


def toml_in(path: str | PathLike[str], what: str) -> dict[str, Any]:
    """What a .toml file holds."""
    import tomllib

    text = text_in(path, what, SETTINGS)
    with decoding(path, f"{what} (TOML)"):
        return tomllib.loads(text)


def json_in(path: str | PathLike[str], what: str) -> Any:
    """What a .json file holds."""
    text = text_in(path, what)
    with decoding(path, f"{what} (JSON)"):
        return json.loads(text)
