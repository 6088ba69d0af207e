"""What the rest of the sky's light depends on: a few optical numbers of the air, and the ranges that were taught."""

from collections.abc import Sequence
from functools import reduce
from typing import Any, NamedTuple

import numpy as np

from skydome.air.atmosphere import USUAL_ALBEDO, Atmosphere
from skydome.air.constituents import AbsorbingGas, Aerosol, Constituent, Molecules, at
from skydome.air.cross_sections import STANDARD_PRESSURE
from skydome.air.gases.gases import STANDARD_WATER
from skydome.air.named_airs import BACKGROUND_DEPTH
from skydome.ground.arrays import Array, as_numpy, constant, floating, is_concrete, is_numpy, namespace, safe_divide
from skydome.ground.limits.ranges import Range, inside
from skydome.skies.all_air.low_aerosol import HIGH, LowAerosol, same

TAUGHT = {
    "molecules": Range(0.0, 1.35),
    "aerosol": Range(0.0, 1.6),
    "stratospheric": Range(0.0, 0.04),
    "absorbers": Range(0.0, 0.42),
    "aerosol_albedo": Range(0.58, 1.0),
    "asymmetry": Range(0.48, 0.92),
    "ground": Range(0.0, 1.0),
}
"""Optical depths (molecules, low aerosol, stratospheric aerosol, ozone), the aerosol's numbers, the ground's albedo."""
ALLOWED = TAUGHT | {"absorbers": Range(0.0, 6.5)}
"""What the sky may be asked for: ozone goes beyond what was taught (`deep_ozone`)."""
NAMES = {
    "molecules": "optical depth of molecules",
    "aerosol": "optical depth of aerosol",
    "stratospheric": "optical depth of stratospheric aerosol",
    "absorbers": "optical depth of ozone",
    "aerosol_albedo": "single scattering albedo of aerosol",
    "asymmetry": "asymmetry of aerosol",
    "ground": "albedo of the ground",
}
NUMBERS = {
    "aerosol_depth": Range(0.0, 0.9),
    "angstrom": Range(0.0, 2.5),
    "asymmetry": Range(0.48, 0.92),
    "aerosol_albedo": Range(0.6, 1.0),
    "ozone": Range(0.0, 600.0, "DU"),
    "albedo": Range(0.0, 1.0),
}
"""Numbers of `clear_air` that a sky may be made of."""
BARE = {"aerosol_albedo": 0.92, "asymmetry": 0.7}
"""What stands for the numbers of an aerosol that is not there."""


class Optics(NamedTuple):
    """The numbers of `TAUGHT`, each (..., W)."""

    molecules: Array
    aerosol: Array
    stratospheric: Array
    absorbers: Array
    aerosol_albedo: Array
    asymmetry: Array
    ground: Array

    @property
    def allowed(self) -> Array:
        """True where all numbers (..., W) lie in `ALLOWED`, (...,)."""
        xp = namespace(*self)
        each = (xp.all(inside(number, ALLOWED[name]), axis=-1) for name, number in self._asdict().items())
        return reduce(lambda a, b: a & b, each)


def clear_air(
    aerosol_depth: Any = 0.1,
    asymmetry: Any = 0.76,
    pressure: Any = STANDARD_PRESSURE,
    ozone: Any = 330.0,
    albedo: Any = USUAL_ALBEDO,
    aerosol_albedo: Any = 0.92,
    angstrom: Any = 1.3,
    stratospheric_depth: Any = BACKGROUND_DEPTH,
    water: Any = STANDARD_WATER,
    nitrogen_dioxide: Any = 0.0,
) -> Atmosphere:
    """The air that the physical sky was taught: `Atmosphere.standard`, under the name that this sky had for it.

    >>> [round(float(part.depth([550.0])[0]), 4) for part in clear_air().constituents]
    [0.0971, 0.094, 0.0292, 0.006]
    """
    return Atmosphere.standard(
        aerosol_depth,
        asymmetry,
        pressure,
        ozone,
        albedo,
        aerosol_albedo=aerosol_albedo,
        angstrom=angstrom,
        stratospheric_depth=stratospheric_depth,
        water=water,
        nitrogen_dioxide=nitrogen_dioxide,
    )


def optics(air: Atmosphere, wavelengths: Any, like: Array) -> Optics:
    """The optical numbers of an atmosphere at wavelengths (W,) nm, as arrays (..., W) of the library of `like`.

    Of aerosols that are not one lobe those of what does not go straight on (`low_aerosol`).
    """

    def total(parts: list[Array]) -> Array:
        return sum(parts[1:], parts[0]) if parts else constant([0.0] * len(wavelengths), like)

    molecules, absorbers, low, high = kinds(air)
    depth = [same(part.depth(wavelengths), like) for part in low]
    scattered = [d * same(part.scattered(wavelengths), like) for d, part in zip(depth, low, strict=True)]
    forward = [s * same(part.phase_law.mean_cosine(wavelengths), like) for s, part in zip(scattered, low, strict=True)]
    aerosol, scattering = total(depth), total(scattered)
    mean, lobes = ratio(total(forward), scattering, BARE["asymmetry"]), LowAerosol.of(air, wavelengths, like)
    straight = 0.0 if lobes is None else lobes.straight
    aerosol, scattering = aerosol - straight * scattering, scattering * (1 - straight)
    return Optics(
        total([same(part.depth(wavelengths), like) for part in molecules]),
        aerosol,
        total([same(part.depth(wavelengths), like) for part in high]),
        total([same(part.depth(wavelengths), like) for part in absorbers]),
        ratio(scattering, aerosol, BARE["aerosol_albedo"]),
        (mean - straight) / (1 - straight),
        same(at(air.albedo, wavelengths), like),
    )


def kinds(air: Atmosphere) -> tuple[Sequence[Constituent], ...]:
    """An atmosphere's molecules, high absorbing gases, low aerosols with the gases among them, and high aerosols."""
    molecules, gases, hazes = (
        [part for part in air.constituents if isinstance(part, kind)] for kind in (Molecules, AbsorbingGas, Aerosol)
    )
    low, low_gases = ([part for part in some if part.profile.mean_height < HIGH] for some in (hazes, gases))
    high, absorbers = ([part for part in some if part.profile.mean_height >= HIGH] for some in (hazes, gases))
    return molecules, absorbers, [*low, *low_gases], high


def foreign(air: Atmosphere) -> Array | None:
    """An array of the library that the numbers of an atmosphere are in; None where that is NumPy."""
    w = [550.0]
    for value in () if air.gases is None else (air.gases.water, air.gases.pressure):
        if not is_numpy(floating(value)):
            return floating(value)
    for part in air.constituents:
        for value in (part.depth(w), part.scattered(w), part.phase_law.mean_cosine(w)):
            if not is_numpy(value):
                return value
    albedo = at(air.albedo, w)
    return None if is_numpy(albedo) else albedo


def ratio(upper: Array, lower: Array, otherwise: float) -> Array:
    """upper / lower, and `otherwise` where there is nothing."""
    xp = namespace(upper, lower)
    return xp.where(lower > 0, safe_divide(upper, lower), xp.full_like(lower, otherwise))


def require_taught(numbers: Optics) -> None:
    """ValueError in one line where a number of the air was not taught."""
    for name, number in numbers._asdict().items():
        if not is_concrete(number):
            continue
        found, interval = np.asarray(as_numpy(number)), ALLOWED[name]
        wrong = ~((found >= interval.low) & (found <= interval.high * (1 + 1e-6)))
        if wrong.any():
            raise ValueError(f"{NAMES[name]} must lie in {interval}, got {found[wrong].flat[0]:.4g}")


def is_earth(air: Atmosphere) -> bool:
    """Whether the atmosphere is about as large as the earth's."""
    return bool(abs(air.radius / 6_371_000.0 - 1) <= 0.01 and abs(air.height / 100_000.0 - 1) <= 0.5)


def require_earth(air: Atmosphere) -> None:
    """ValueError unless the atmosphere is about as large as the earth's: only that was taught."""
    if not is_earth(air):
        size = f"radius {air.radius / 1000:g} km, air up to {air.height / 1000:g} km"
        raise ValueError(f"the physical sky was taught for the earth's atmosphere (6371 km, 100 km), got {size}")
