"""Libraries that not every user needs: each comes with an extra of the package, and is asked for before any work."""

from importlib import import_module
from typing import Any


def required(library: str, extra: str, purpose: str) -> Any:
    """The module `library`, imported; ImportError that tells what needs it and how to install it.

    Call it before work begins, not when the library's turn comes.

    >>> required("math", "fast", "counting").floor(2.5)
    2
    """
    try:
        return import_module(library)
    except ModuleNotFoundError as error:
        missing = str(error.name).split(".")[0]
        raise ImportError(f'{purpose} needs {missing}: pip install "skydome[{extra}]"') from error
