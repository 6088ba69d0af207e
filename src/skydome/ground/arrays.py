"""One way to meet NumPy, PyTorch and JAX arrays: find the namespace, convert, guard the edges."""

import sys
from collections.abc import Callable
from functools import wraps
from typing import Any, TypeVar, cast

import numpy as np

expected = "expected an array or a number, got {}"
type_error = "arrays of different libraries cannot be mixed, got {}; convert them to one library first"


def brief(value: object, typed: bool = True) -> str:
    """A value in a few words of one line for a message: its type, if `typed`, and its beginning."""
    shown = " ".join(repr(value).split())
    shown = shown if len(shown) <= 60 else f"{shown[:57]}..."
    return f"{type(value).__name__} {shown}" if typed and value is not None else shown


WITHOUT_DTYPE = (int, float, np.generic, list, tuple)
"""Types of bare numbers; a tuple, as torch.compile does not read unions of types."""

HELD_BY_NUMPY = (np.ndarray, *WITHOUT_DTYPE)
"""Types that NumPy holds without another library."""

Function = TypeVar("Function", bound=Callable[..., Any])

Array = Any
"""A floating array of NumPy, PyTorch or JAX, in the library of what it was made from; docstrings say its shape.

`Any` to type checkers on purpose, so that it may be taken for an array of one's own library (docs/decisions.md).
What is converted on arrival, and may be a number or a list too, is `numpy.typing.ArrayLike`.
"""


class Constant(np.ndarray):
    """A NumPy array of constants: it cannot be written to, and goes along with any library, as bare numbers do.

    What is computed from it is a plain array.

    >>> up = Constant.of([0.0, 0.0, 1.0])
    >>> type(2 * up).__name__, up.flags.writeable
    ('ndarray', False)
    """

    @classmethod
    def of(cls, values: Any) -> "Constant":
        """The constants of floating `values`, whole numbers or numbers."""
        held = np.array(values).view(cls)
        held.flags.writeable = False
        return held

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **named: Any) -> Any:
        """What NumPy computes of plain arrays."""
        if "out" in named:
            named["out"] = tuple(map(without_class, named["out"]))
        return getattr(ufunc, method)(*map(without_class, inputs), **named)

    def __repr__(self) -> str:
        return repr(np.asarray(self))


def without_class(value: Any) -> Any:
    """The same numbers as a plain array, where they are a constant."""
    return np.asarray(value) if isinstance(value, Constant) else value


def is_numpy(value: object) -> bool:
    """True for what NumPy can hold without another library: arrays, numbers, lists; and arrays with labels."""
    return value is None or isinstance(value, HELD_BY_NUMPY) or is_labelled(value) or is_of(value, "pandas", "Index")


def is_labelled(value: object) -> bool:
    """True for a Series or DataFrame of pandas, or a DataArray of xarray: an array with labels along its axes."""
    return is_of(value, "pandas", "Series", "DataFrame") or is_data_array(value)


def is_data_array(value: object) -> bool:
    """True for a DataArray of xarray."""
    return is_of(value, "xarray", "DataArray")


def is_of(value: object, library: str, *kinds: str) -> bool:
    """True for an instance of one of a library's classes, by name; the library is not imported for that."""
    module = sys.modules.get(library)
    return module is not None and isinstance(value, tuple(getattr(module, kind) for kind in kinds))


def namespace(*values: Any) -> Any:
    """The array namespace that all of `values` share: numpy itself, or torch's or JAX's (array-api-compat).

    Python numbers, lists and constants go along with any library; arrays with labels (pandas, xarray) are NumPy's.
    TypeError where two libraries are mixed.

    >>> namespace(1.0, [2.0]).__name__
    'numpy'
    """
    foreign = [value for value in values if not is_numpy(value)]
    if not foreign:
        return np
    own = [value for value in values if isinstance(value, np.ndarray) and not isinstance(value, Constant)]
    if not own and all(is_torch(value) for value in foreign):
        from array_api_compat import torch

        require_one_device(foreign)
        return torch
    import array_api_compat

    for value in foreign:
        if not array_api_compat.is_array_api_obj(value):
            raise TypeError(expected.format(brief(value)))
    libraries = sorted({type(value).__module__.split(".")[0] for value in foreign + own})
    try:
        return array_api_compat.array_namespace(*foreign, *own)
    except TypeError as error:
        raise TypeError(type_error.format(" and ".join(libraries))) from error


def is_torch(value: object) -> bool:
    """True for a torch tensor."""
    torch = sys.modules.get("torch")
    return torch is not None and isinstance(value, torch.Tensor)


def require_one_device(tensors: list[Any]) -> None:
    """TypeError where torch tensors live on several devices; single CPU numbers go along with any, as in torch."""
    devices = {str(tensor.device) for tensor in tensors if tensor.ndim or tensor.device.type != "cpu"}
    if len(devices) > 1:
        got = " and ".join(sorted(devices))
        raise TypeError(f"arrays on different devices cannot be mixed, got {got}; move them to one device first")


def is_number(value: object) -> bool:
    """True for a bare number, a list of them, or a constant, that has no dtype of its own to keep."""
    return isinstance(value, (*WITHOUT_DTYPE, Constant))


def is_array(value: object) -> bool:
    """True for an array or a scalar of any library: what has a dtype."""
    return hasattr(value, "dtype")


def floating(value: Any, like: object = None) -> Array:
    """The value as a floating array, shape kept; numbers and lists take dtype, library and device of the array `like`.

    Floating arrays pass untouched (float32 stays float32); integers become float64, or the dtype of `like`; half
    floats, which would round all constants, NumPy's float64, torch's and JAX's their usual dtype.
    """
    if is_array(like) and is_number(value):
        return constant(value, like)
    if is_numpy(value):
        return floats(value)
    xp = namespace(value)
    if xp.isdtype(value.dtype, "bool"):
        raise TypeError(expected.format(brief(value)))
    fine = xp.isdtype(value.dtype, "real floating") and value.dtype.itemsize > 2
    return value if fine else xp.astype(value, xp.asarray(1.0).dtype)


def floats(value: Any) -> np.ndarray:
    """Numbers as NumPy holds them, floating ones untouched, others float64; TypeError for words, truths and the like.

    >>> floats(["red"])
    Traceback (most recent call last):
    TypeError: expected an array or a number, got list ['red']
    """
    try:
        array = np.asarray(value)
        if array.dtype.kind in "fiuO" and value is not None:
            return array if array.dtype.kind == "f" and array.itemsize > 2 else array.astype(np.float64)
    except (TypeError, ValueError):  # a list of lists of several lengths; an object that is no number
        pass
    raise TypeError(expected.format(brief(value)))


def constant(table: Any, like: Array) -> Array:
    """A number, list or NumPy table as an array of the library, dtype and device of `like`."""
    if is_numpy(like):
        dtype = np.asarray(like).dtype
        return floats(table).astype(dtype if dtype.kind == "f" else np.float64, copy=False)
    xp = namespace(like)
    if xp.__name__.endswith("torch"):
        return xp.asarray(np.array(table), dtype=like.dtype, device=like.device)
    return xp.asarray(np.asarray(table), dtype=like.dtype)


def settled(function: Function) -> Function:
    """Mark a function of constants, such as a table's reader: torch.compile calls it and does not read its code."""

    @wraps(function)
    def called(*arguments: Any, **named: Any) -> Any:
        return function(*arguments, **named)

    called.__dict__["_dynamo_marked_constant"] = True  # as torch.compiler.assume_constant_result does, without torch
    return cast(Function, called)


def is_compiling() -> bool:
    """True while torch.compile reads the code: values and their checks have no meaning then."""
    torch = sys.modules.get("torch")
    return torch is not None and torch.compiler.is_compiling()


def is_concrete(value: object) -> bool:
    """False where the values cannot be looked at: while JAX or torch traces or maps a function, and on "meta"."""
    jax, torch = sys.modules.get("jax"), sys.modules.get("torch")
    if jax is not None and isinstance(value, jax.core.Tracer):
        return False
    if torch is None or not isinstance(value, torch.Tensor):
        return True
    if is_compiling() or value.is_meta:
        return False
    return not torch._C._functorch.is_functorch_wrapped_tensor(value)  # torch.func has no public question for it


def as_numpy(value: object) -> np.ndarray:
    """`value` as a NumPy array, detached from gradients and copied from its device where needed."""
    return np.asarray(value.detach().cpu() if hasattr(value, "detach") else value)


def safe_sqrt(x: Array) -> Array:
    """Square root, 0 where x <= 0, with gradient 0 there (the plain root's is infinite or NaN)."""
    if isinstance(x, np.ndarray):
        return np.asarray(np.sqrt(np.fmax(x, x.dtype.type(0))))
    xp = namespace(x)
    positive = x > 0
    return xp.where(positive, xp.sqrt(xp.where(positive, x, xp.ones_like(x))), xp.zeros_like(x))


def safe_divide(numerator: Array, denominator: Array) -> Array:
    """Quotient, and 0 where the denominator is 0, without warnings or NaN gradients."""
    xp = namespace(numerator, denominator)
    usable = denominator != 0
    ratio = numerator / xp.where(usable, denominator, xp.ones_like(denominator))
    return xp.where(usable, ratio, xp.zeros_like(ratio))


def at_least(x: Array, low: float) -> Array:
    """Elementwise maximum of x and the number `low` in the dtype of x."""
    if isinstance(x, np.ndarray):
        return np.asarray(np.fmax(x, x.dtype.type(low)))
    return namespace(x).where(x > low, x, namespace(x).full_like(x, low))


def limited(x: Array, low: float, high: float) -> Array:
    """Elementwise x clamped to [low, high] in the dtype of x."""
    if isinstance(x, np.ndarray):
        return np.asarray(np.fmax(np.fmin(x, x.dtype.type(high)), x.dtype.type(low)))
    return namespace(x).where(x < high, at_least(x, low), namespace(x).full_like(x, high))
