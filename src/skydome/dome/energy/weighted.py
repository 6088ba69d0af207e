"""The light of sun and sky on the horizontal, weighted by what each wavelength does.

The sky is one that knows its air and its spectrum from 300 to 2500 nm: the physical sky, with or without its sun's
disc. What the air leaves of the sunlight is taken as linear between some wavelengths, the sunlight as it is tabulated.
"""

from typing import Any, cast

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.gases.skylight import air_mass
from skydome.dome.integrals import discs_and_rest
from skydome.ground.arrays import Array, constant, namespace
from skydome.ground.interpolation import weights
from skydome.ground.quadrature import hemisphere
from skydome.skies.all_air.low_aerosol import same
from skydome.skies.all_air.sky import WAVELENGTHS, PhysicalSky
from skydome.skies.sky import Sky
from skydome.skies.suns.atmosphere_sun import AtmosphereSun
from skydome.skies.suns.sun_disc import SunDisc
from skydome.skies.validity import Check


def knows_energy(sky: Sky) -> bool:
    """True for skies of which `broadband` and its like can be asked."""
    discs, rest = discs_and_rest(sky)
    return all(part.knows_energy for part in [disc for disc, _ in discs] + [part.single[0] for part in rest])


def parts_of(
    sky: Sky, wavelengths: np.ndarray, action: Any, beam_alone: bool = False, check: Check | None = None
) -> tuple[Any, Any, Any]:
    """What light does by an `action`: diffuse and direct on the horizontal, and direct normal, (...,) each.

    Of suns and airs (...,); an axis of 1 for views, their last one, is dropped.
    """
    discs, rest = discs_and_rest(sky)
    require_energy(discs, rest)
    diffuse, direct, normal = 0.0, 0.0, 0.0
    for part in rest:
        inner, factor = cast(tuple[PhysicalSky, Any], part.single)
        if not beam_alone:
            held = inner if check is None else inner.without_refusal(check)
            each = weights_of(inner.atmosphere, wavelengths, action) * factor
            light = diffuse_of(held, wavelengths)
            diffuse = diffuse + light @ constant(each, light)
    for disc, factor in cast(list[tuple[AtmosphereSun, Any]], discs):
        beam = disc.irradiance(wavelengths) @ weights_of(disc.atmosphere, wavelengths, action) * factor
        level = beam * np.maximum(np.asarray(disc.sun)[..., 2], 0.0)
        direct, normal = direct + alone(level), normal + alone(beam)
    return diffuse, direct, normal


def require_energy(discs: list[tuple[SunDisc, Any]], rest: list[Sky]) -> None:
    """TypeError that names all that must be left out, where some part does not know 300-2500 nm."""
    wide = [inner for inner, _ in (part.single for part in rest) if not inner.knows_energy]
    unknown = [*wide, *(disc for disc, _ in discs if not disc.knows_energy)]
    if unknown:
        first = f"{type(unknown[0]).__name__} does not know light of 300-2500 nm"
        known = "SunDisc.of(PhysicalSky)" if not wide else "PhysicalSky"
        some = len(unknown) < len(discs) + len(rest)
        names = ", ".join(dict.fromkeys(type(part).__name__ for part in unknown))
        out = f": leave out {names}, from a sd.sky_at by its without('planets', ...)" if some else ""
        raise TypeError(f"{first}; {known} does{out}")


def diffuse_of(sky: PhysicalSky, wavelengths: np.ndarray) -> Array:
    """Spectral irradiance of the sky on the horizontal, W m-2 nm-1, (..., W), of suns and airs (...,) or (..., 1)."""
    known = wavelengths >= WAVELENGTHS.low
    light = level_irradiance(sky, wavelengths[known])
    if known.all():
        return light
    xp, short = namespace(light), wavelengths[: np.argmax(known) + 1]
    depth: Array = sum((same(part.depth(short), light) for part in sky.atmosphere.constituents), 0.0)
    mass, sunlight = air_mass(sky.toward[..., 2])[..., None], sky.atmosphere.sun_at(short)
    fall = alone(xp.exp(-(depth - depth[..., -1:]) * mass), axes=1) * constant(sunlight / sunlight[-1], light)
    return xp.concat([light[..., :1] * fall[..., :-1], light], axis=-1)


def level_irradiance(sky: PhysicalSky, wavelengths: np.ndarray) -> Array:
    """The same at wavelengths that the networks know: views are an axis after that of 1, else the first."""
    directions, solid_angles = hemisphere(*sky.nodes_of_energy)
    nodes, each = (constant(part, sky.toward) for part in (directions, solid_angles * directions[:, 2]))
    shape = np.shape(sky.valid)
    if shape[-1:] in ((), (1,)):
        return each @ sky.on_its_nodes(nodes, wavelengths)
    views = nodes.reshape(-1, *(1 for _ in shape), 3)
    return namespace(each).tensordot(each, sky.radiance(views, wavelengths), axes=1)


def weights_of(air: Atmosphere, wavelengths: np.ndarray, action: Any) -> np.ndarray:
    """Weights (W,) of light at `wavelengths` in its integral times an action, its share of the sunlight linear."""
    fine = np.arange(wavelengths[0], wavelengths[-1] + 0.5)
    step = np.full(fine.shape, 1.0)
    step[[0, -1]] = 0.5
    hats = weights(wavelengths, fine)
    result: np.ndarray = (step * action(fine) * air.sun_at(fine)) @ hats / air.sun_at(wavelengths)
    return result


def alone(light: Array, axes: int = 0) -> Array:
    """Numbers of suns and airs (..., 1) that have an axis for views without it; `axes` come after that."""
    views = light.ndim - axes - 1
    return (
        light.reshape(*light.shape[:views], *light.shape[views + 1 :])
        if views >= 0 and light.shape[views] == 1
        else light
    )
