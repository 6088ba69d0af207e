"""Light with labels: where a sky's parameters or the directions are labelled (pandas, xarray), its light is too."""

from collections.abc import Callable, Iterator
from dataclasses import fields, is_dataclass, replace
from functools import cache, wraps
from inspect import isfunction, signature
from typing import Any, ClassVar, NamedTuple, TypeVar, cast

import numpy as np

from skydome.ground.arrays import is_compiling, is_labelled
from skydome.ground.labels import COMPONENTS, Axis, Door, Last, last_of
from skydome.ground.limits.ranges import HeldBySky
from skydome.skies.validity import Ranged

Function = TypeVar("Function", bound=Callable[..., Any])
Kind = TypeVar("Kind")


class Answer(NamedTuple):
    """What a method of the ladder answers: its unit, its last axes, and whether wavelengths come before those."""

    unit: str
    last: tuple[Axis, ...] = ()
    spectral: bool = False


XYZ_CHANNELS = (Axis("channel", ("X", "Y", "Z"), 3),)
RGB_CHANNELS = (Axis("channel", ("red", "green", "blue"), 3),)

ANSWERS = {
    "luminance": Answer("cd m-2"),
    "xyz": Answer("cd m-2", XYZ_CHANNELS),
    "rgb": Answer("cd m-2", RGB_CHANNELS),
    "radiance": Answer("W m-2 sr-1 nm-1", spectral=True),
    "stokes": Answer("W m-2 sr-1 nm-1", (Axis("stokes", ("I", "Q", "U"), 3),), spectral=True),
    "degree_of_polarisation": Answer("", spectral=True),
    "angle_of_polarisation": Answer("rad", spectral=True),
    "broadband_radiance": Answer("W m-2 sr-1"),
    "illuminance": Answer("lx"),
    "irradiance": Answer("W m-2 nm-1", spectral=True),
}
"""The ladder's methods, and those of single classes."""

KNOWN = {
    "valid": Answer(""),
    "is_day": Answer(""),
    "diffuse_illuminance": Answer("lx"),
    "direct_normal_illuminance": Answer("lx"),
    "normal_xyz": Answer("lx", XYZ_CHANNELS),
    "sun_distance": Answer("AU"),
    "seen_sun": Answer("", (COMPONENTS,)),
}
"""What a sky knows without being asked for directions: properties."""


class LabelledLight(Ranged):
    """A sky whose answers have the labels of what was given; every class of skies gets it by standing below this one.

    >>> import pandas as pd, skydome as sd
    >>> days = pd.Series([2.0, 5.0], index=["clear", "hazy"])
    >>> sky = sd.HosekWilkie(sd.direction(2.0, 0.7), turbidity=days)
    >>> (sky.luminance(sd.NORTH) / 1000).round(1).to_dict()
    {'clear': 10.3, 'hazy': 7.5}
    """

    directions_held: ClassVar[tuple[str, ...]] = ()
    """Names of the parameters that are directions, (..., 3)."""

    def __init_subclass__(cls, **named: Any) -> None:
        super().__init_subclass__(**named)
        own = dict(vars(cls))  # a field of such a name is what was given
        for name in ANSWERS.keys() & own.keys():
            if isfunction(own[name]):
                setattr(cls, name, with_labels(own[name]))
        for name in KNOWN.keys() & own.keys():
            if isinstance(own[name], property):
                setattr(cls, name, property(knows_labels(own[name]), doc=own[name].__doc__))


def with_labels(method: Callable[..., Any]) -> Callable[..., Any]:
    """A method of the ladder that answers with labels where the sky or its arguments have some."""

    @wraps(method)
    def called(sky: Any, *arguments: Any, **named: Any) -> Any:
        if is_compiling():
            return method(sky, *arguments, **named)
        given = [*labelled_parts(sky), *((value, 1) for value in (*arguments, *named.values()) if is_labelled(value))]
        if not given:
            return method(sky, *arguments, **named)
        return answered(sky, method.__name__, given, arguments, named)

    return called


def knows_labels(known: property) -> Callable[[Any], Any]:
    """What gets a property of a sky, with labels where the sky has some."""
    get = cast(Callable[[Any], Any], known.fget)

    @wraps(get)
    def got(sky: Any) -> Any:
        if is_compiling() or not (given := list(labelled_parts(sky))):
            return get(sky)
        door, (unit, last, _) = Door.of(given), KNOWN[get.__name__]
        return door.labelled(getattr(plain_sky(sky, door), get.__name__), last, get.__name__, unit)

    return got


def plain_sky(sky: Any, door: Door) -> Any:
    """A sky with plain arrays in place of the labelled ones that a door has met."""
    return changed(sky, lambda value, core: door.array(value, core) if is_labelled(value) else value)


def answered(
    sky: Any, name: str, given: list[tuple[Any, int]], arguments: tuple[Any, ...], named: dict[str, Any]
) -> Any:
    """The light of a sky and arguments of which some, `given`, are labelled."""
    unit, last, spectral = ANSWERS[name]
    wavelengths = named.get("wavelengths", arguments[-1] if arguments else None) if spectral else None
    door = Door.of((value, core) for value, core in given if value is not wavelengths)

    def plain(value: Any) -> Any:
        if not is_labelled(value):
            return value
        return np.asarray(value) if value is wavelengths else door.array(value, 1)

    light = getattr(plain_sky(sky, door), name)(
        *map(plain, arguments), **{key: plain(value) for key, value in named.items()}
    )
    if wavelengths is not None:
        last = (*wavelength_axis(wavelengths), *last)
    return door.labelled(light, last, name, unit)


BARE = (float, int, str, bytes, type(None))
"""Kinds of parameters that hold no array."""


class Parameter(NamedTuple):
    """A field of a sky, air or law; `core`: how many of its last axes are not labels of the light."""

    name: str
    core: int
    given: bool


def parameters_of(value: Any) -> tuple[Parameter, ...]:
    """The fields of a sky, air or law."""
    return parameters_of_kind(cast(Any, type(value)))


@cache
def parameters_of_kind(kind: type) -> tuple[Parameter, ...]:
    """The fields of a class of skies, air or laws; none of a law that somebody wrote without a dataclass."""
    directions = kind.directions_held if issubclass(kind, LabelledLight) else ()
    known = fields(kind) if is_dataclass(kind) else ()
    return tuple(Parameter(item.name, int(item.name in directions), item.init) for item in known)


def labelled_parts(value: Any, core: int = 0) -> Iterator[tuple[Any, int]]:
    """The labelled parameters of a sky and its air, and how many of their last axes are not labels of the light."""
    if isinstance(value, BARE):
        return
    if isinstance(value, (LabelledLight, HeldBySky)):
        for name, own, _ in parameters_of(value):  # not what the sky keeps beside them: it may hold the sky
            yield from labelled_parts(getattr(value, name), own)
    elif isinstance(value, (tuple, list)):
        for part in value:
            yield from labelled_parts(part, core)
    elif is_labelled(value):
        yield value, core


def changed(value: Kind, change: Callable[[Any, int], Any], core: int = 0) -> Kind:
    """A sky, or a parameter of one, with `change(array, core)` in place of its arrays; itself where nothing changes."""
    result: Any
    if isinstance(value, BARE):
        return value
    if isinstance(value, (LabelledLight, HeldBySky)):
        held = {name: (getattr(value, name), own) for name, own, given in parameters_of(value) if given}
        new = {name: changed(old, change, own) for name, (old, own) in held.items()}
        moved = {name: part for name, part in new.items() if part is not held[name][0]}
        return cast(Kind, replace(value, **moved) if moved else value)  # type: ignore[type-var]
    if isinstance(value, (tuple, list)):
        parts = [changed(part, change, core) for part in value]
        same = all(new is old for new, old in zip(parts, value, strict=True))
        result = value if same else type(value)(parts)
    else:
        result = change(value, core)
    return cast(Kind, result)


def outer_labels(unit: str, last: Last = (), directions: str = "normal") -> Callable[[Function], Function]:
    """Decorate a function of a sky and directions: its answer has the sky's labels, then those of the directions.

    Labelled parameters get an axis of 1 for the directions of the dome. Wavelengths, if asked for, come last.
    """

    def decorated(function: Function) -> Function:
        names = list(signature(function).parameters)

        @wraps(function)
        def called(*arguments: Any, **named: Any) -> Any:
            held = dict(zip(names, arguments, strict=False)) | named
            normal, wavelengths = held.get(directions), held.get("wavelengths")
            given = list(labelled_parts(held.get("sky")))
            normals = [(normal, 1)] if is_labelled(normal) else []
            if is_compiling() or not (given or normals):
                return function(*arguments, **named)
            door, planes = Door.of(given), Door.of(normals)
            if door.named or planes.named:  # axes of one name are one axis; those of pandas stand apart
                Door.of(given + normals)
            held["sky"] = with_dome_axes(held["sky"], door)
            if normals:
                held[directions] = planes.array(normal, 1)
            ends = last_of(last, held) if wavelengths is None else wavelength_axis(wavelengths)
            joint = Door(door.axes + axes_of(normal, planes, directions), door.named or planes.named)
            return joint.answer(function(**held), ends, function.__name__, unit)

        return cast(Function, called)

    return decorated


def with_dome_axes(sky: Any, door: Door) -> Any:
    """A sky whose labelled parameters are plain arrays with an axis of 1 for the directions of the dome."""
    return changed(sky, lambda value, core: dome_axis(door.array(value, core), core) if is_labelled(value) else value)


def axes_of(directions: Any, door: Door, name: str) -> tuple[Axis, ...]:
    """The axes of directions (..., 3): their labels', or as many without labels, of a name."""
    lengths = np.shape(() if directions is None else directions)[:-1]
    return door.axes or tuple(Axis(name, None, length) for length in lengths)


def dome_axis(values: np.ndarray, core: int) -> np.ndarray:
    """Parameters with an axis of 1 before their last `core` ones, for the directions of the dome."""
    return np.expand_dims(values, values.ndim - core) if values.ndim > core else values


def wavelength_axis(wavelengths: Any) -> tuple[Axis]:
    """The last axis of spectra."""
    return (Axis("wavelength", tuple(np.atleast_1d(wavelengths).tolist()), int(np.size(wavelengths))),)
