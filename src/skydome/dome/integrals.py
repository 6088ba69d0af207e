"""Integrals of the dome: what light falls on a plane."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array, Constant, at_least, constant, floating, is_array, is_numpy, namespace
from skydome.ground.directions import ZENITH, checked_directions
from skydome.ground.limits.ranges import SHARE, HeldBySky, require, require_one
from skydome.ground.quadrature import hemisphere
from skydome.light.spectrum import Spectrum
from skydome.skies.colour_sky import ColourSky, SpectralSky
from skydome.skies.labelled import BARE, outer_labels, parameters_of
from skydome.skies.sky import Sky
from skydome.skies.suns.point_lights import PointLights
from skydome.skies.suns.sun_disc import SunDisc

RINGS, COLUMNS = 96, 192


def projected(normals: Array, like: Array) -> tuple[np.ndarray, Array]:
    """Directions (N, 3) of the hemisphere; their projected solid angles (..., N) on planes with `normals` (..., 3)."""
    directions, solid_angles = hemisphere(RINGS, COLUMNS)
    nodes = constant(directions, like)
    cosines = at_least(normals @ nodes.T, 0.0)
    return nodes, cosines * constant(solid_angles, like)


def discs_and_rest(sky: Sky) -> tuple[list[tuple[SunDisc, Any]], list[Sky]]:
    """The sun's discs in a sum of skies, each with the factor it was multiplied by, and the other parts."""
    require_kind(sky, Sky, "sky", "Preetham(sun, turbidity=3.0)")
    discs: list[tuple[SunDisc, Any]] = []
    rest: list[Sky] = []
    for part in sky.parts:
        inner, factor = part.single
        if isinstance(inner, SunDisc):
            discs.append((inner, factor))
        else:
            rest.append(part)
    return discs, rest


def points_of(parts: list[Sky]) -> list[tuple[PointLights, Any]]:
    """The points of light among the parts of a sum, each with the factor it was multiplied by."""
    singles = [part.single for part in parts]
    return [(inner, factor) for inner, factor in singles if isinstance(inner, PointLights)]


def extended(parts: list[Sky]) -> list[Sky]:
    """The parts of a sum that are no points."""
    return [part for part in parts if not isinstance(part.single[0], PointLights)]


def own_array(value: Any) -> Any:
    """The floating array among a sky's parameters whose library, dtype and device its light has, or None.

    The first of another library than NumPy, if there is one, as the air's; else the first.
    """
    found = list(arrays_of(value))
    return next((array for array in found if not is_numpy(array)), found[0] if found else None)


def in_library_of(table: np.ndarray, sky: Sky) -> Array:
    """A NumPy table in the library, dtype and device of the sky's own arrays."""
    like = own_array(sky)
    return table if like is None else constant(table, like)


def arrays_of(value: Any) -> Iterator[Any]:
    """The floating arrays among a sky's parameters and those of its air."""
    if isinstance(value, BARE):
        return
    if isinstance(value, (Sky, HeldBySky)):
        for name, _, _ in parameters_of(value):
            yield from arrays_of(getattr(value, name))
    elif isinstance(value, tuple | list):
        for part in value:
            yield from arrays_of(part)
    elif is_array(value) and not isinstance(value, np.generic | Constant):
        yield floating(value)


@outer_labels("lx")
def illuminance(sky: Sky, normal: Any = ZENITH, *, ground_albedo: Any = 0.0) -> Array:
    """Illuminance on planes with unit normals (..., 3), lx; light from below the horizon only with `ground_albedo`.

    Shape: that of the normals' leading axes, after the sky's own, whose last axis of 1 is dropped: a sky of shape
    (T, 1) and normals (M, 3) give (T, M), a normal (3,) gives (T,). The sun's discs enter in closed form. Error below
    1e-4 on the horizontal, 3e-4 on any plane (tested). Memory: 150 kB a normal and a sky. The ground is level,
    unobstructed and diffuse, of an albedo 0-1: it adds albedo x E_horizontal x (1 - cos tilt) / 2.

    >>> import skydome as sd
    >>> bool(abs(sd.illuminance(sd.Uniform(1.0)) - np.pi) < 1e-9)
    True
    >>> round(float(sd.illuminance(sd.Uniform(1.0), sd.SOUTH, ground_albedo=0.2) / np.pi), 4)
    0.6
    """
    require("ground_albedo", ground_albedo, SHARE)
    require_one("ground_albedo", ground_albedo)
    normals, single = planes(sky, normal)
    discs, rest = discs_and_rest(sky)
    nodes, weights = projected(normals, normals)
    total: Array = 0.0
    for lights, factor in points_of(rest):
        total = total + lights.illuminance(normals) * factor
    for part in extended(rest):
        light = part.for_maps.luminance(nodes)
        xp = namespace(light)
        total = total + light @ xp.astype(xp.matrix_transpose(weights), light.dtype)
    for disc, factor in discs:
        beam = disc.illuminance(normals)
        if tuple(beam.shape)[-1:] != (len(normals),):
            got = tuple(beam.shape)
            told = f"leading shapes must fit, got {len(normals)} planes and light of a sun's disc of shape {got}"
            raise ValueError(f"{told}; give many suns an axis of 1: sun[:, None, :], many levels too: level[:, None]")
        total = total + beam * factor
    if ground_albedo:
        ground = illuminance(sky, constant(ZENITH, normals))
        total = total + ground[..., None] * (ground_albedo * below_horizon(normals))
    return total[..., 0] if single else total


def planes(sky: Sky, normal: Any) -> tuple[Array, bool]:
    """Normals (M, 3) in the sky's own library where the default is asked for, and whether there is one alone."""
    normal = checked_directions(normal, "normal", like=own_array(sky))
    single = normal.ndim == 1
    return (normal[None, :] if single else normal), single


def below_horizon(normals: Array) -> Array:
    """Form factor from planes with unit normals (..., 3) to open level ground: (1 - cos tilt) / 2."""
    return (1 - normals[..., 2]) / 2


@outer_labels("W m-2 nm-1")
def irradiance(sky: Sky, wavelengths: Any, normal: Any = ZENITH, *, ground_albedo: Any = 0.0) -> Array:
    """Spectral irradiance on planes with unit normals (..., 3) at `wavelengths` (W,) nm, W m-2 nm-1, shape (..., W).

    Leading axes as those of `illuminance`. `ground_albedo`, a number or a `Spectrum` in [0, 1], adds what level ground
    reflects. TypeError for a sky that knows no spectrum. Memory: 150 kB a sky, a plane and a wavelength.

    >>> import skydome as sd
    >>> sky = sd.HosekWilkie(sd.direction(azimuth=2.0, elevation=0.7), turbidity=3.0)
    >>> irradiance(sky, [450.0, 550.0, 650.0]).shape
    (3,)
    """
    require("ground_albedo", ground_albedo, SHARE)
    albedo = np.asarray(ground_albedo.at(wavelengths) if isinstance(ground_albedo, Spectrum) else ground_albedo)
    normals, single = planes(sky, normal)
    discs, rest = discs_and_rest(sky)
    nodes, weights = projected(normals, normals)
    total: Array = 0.0
    for lights, factor in points_of(rest):
        total = total + lights.irradiance(normals, wavelengths) * factor
    for part in extended(rest):
        if not isinstance(part, SpectralSky):
            raise TypeError(
                f"{type(part).__name__} knows no spectrum; spectral irradiance needs one, as HosekWilkie has"
            )
        total = total + weights @ part.radiance(nodes, wavelengths)
    for disc, factor in discs:
        cosine = at_least(namespace(normals).sum(normals * floating(disc.sun, like=normals), axis=-1), 0.0)
        total = total + disc.irradiance(wavelengths) * (cosine * factor)[..., None]
    if albedo.any():
        ground = irradiance(sky, wavelengths, constant(ZENITH, normals))
        total = total + ground[..., None, :] * constant(albedo, ground) * below_horizon(normals)[..., None]
    return total[..., 0, :] if single else total


def horizontal_xyz(sky: ColourSky) -> tuple[Array, Array]:
    """CIE XYZ of the light on the horizontal from a sky and from its sun, Y in lx, each (..., 3): diffuse and direct.

    A sky of shape (T, 1) gives (T, 3).
    """
    like = own_array(sky)
    zenith = ZENITH if like is None or is_numpy(like) else constant(ZENITH, like)
    discs, rest = discs_and_rest(sky)
    diffuse, direct = zenith * 0.0, zenith * 0.0
    for lights, factor in points_of(rest):
        diffuse = diffuse + lights.shares(ZENITH) @ lights.carried * factor
    for part in extended(rest):
        diffuse = diffuse + level_xyz(coloured(part), zenith)
    for disc, factor in discs:
        sun = floating(disc.sun)
        light = disc.normal_xyz * floating(factor, like=sun)[..., None] * at_least(sun[..., 2:], 0.0)
        direct = direct + (light[..., 0, :] if light.ndim > 1 else light)
    return diffuse, direct


def level_xyz(sky: ColourSky, zenith: Array) -> Array:
    """XYZ of the light of a sky on the horizontal, (..., 3), as it knows it itself or from its dome."""
    inner, factor = sky.single
    shown = inner.for_maps
    if isinstance(shown, ColourSky) and (known := shown.on_level) is not None:
        return known * factor
    nodes, weights = projected(zenith, zenith)
    light = sky.xyz(nodes)
    return namespace(light).astype(weights, light.dtype) @ light


def coloured(sky: Sky) -> ColourSky:
    """The sky, known to have colour; TypeError for one that has none."""
    if not isinstance(sky, ColourSky):
        raise TypeError(colourless(sky))
    return sky


def colourless(sky: Sky) -> str:
    """What to say of a sky whose luminance only is known, where colour is needed."""
    require_kind(sky, Sky, "sky", "Preetham(sun, turbidity=3.0)")
    name = type(sky).__name__
    return f"{name} knows luminance only; give it a colour on purpose: skydome.Daylight(sky, chromaticity=(x, y))"
