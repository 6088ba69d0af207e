"""The models that can be held against a measured sky, by name, with the numbers of each that may be fitted."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from skydome.air.atmosphere import DARK_GREEN, Atmosphere
from skydome.air.constituents import Aerosol
from skydome.air.mie import MieParticles
from skydome.air.phase_laws import HenyeyGreenstein
from skydome.air.size_distributions import Lognormal
from skydome.evaluation.evaluation import SkyOf
from skydome.light.spectrum import Spectrum
from skydome.skies.air_models import AirModel, PhysicalModel, TracedModel
from skydome.skies.all_air.sky import PhysicalSky
from skydome.skies.all_air.taught_air import TAUGHT, clear_air
from skydome.skies.catalogue import CATALOGUE
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.model import Model
from skydome.skies.physical.discrete_ordinates import DiscreteOrdinates
from skydome.skies.physical.refitted import Numbers, Refitted
from skydome.skies.wrapped.daylight_sky import Daylight

GROUND = 98_500.0
"""Pressure at 280 m, Pa."""


@dataclass(frozen=True)
class EvaluatedModel:
    """A model: a sky from a sun and numbers; their usual values, limits (of those that are fitted), known failures.

    `knows_distance`: whether `make` takes the sun's distance, AU, as `distance`.
    """

    name: str
    make: Callable[..., SpectralSky]
    numbers: dict[str, float]
    limits: dict[str, tuple[float, float]]
    failures: str
    knows_distance: bool = False

    def sky_of(self, numbers: dict[str, float] | None = None) -> SkyOf:
        """From a sun and its distance to the sky, with the usual numbers or those given."""
        chosen = self.numbers | (numbers or {})

        def sky(sun: np.ndarray, distance: float = 1.0) -> SpectralSky:
            return self.make(sun, **chosen, **({"distance": distance} if self.knows_distance else {}))

        return sky


def plain_air(depth: float, asymmetry: float, distance: float = 1.0) -> Atmosphere:
    """Clean air over green ground: one lobe of aerosol, ozone 330 DU; the sun at a `distance` in AU."""
    return Atmosphere.standard(depth, asymmetry, GROUND, 330.0, DARK_GREEN, sun_scale=distance**-2)


def taught_air(depth: float, asymmetry: float, distance: float = 1.0) -> Atmosphere:
    """The same of the profiles that the physical sky was taught."""
    air = clear_air(depth, asymmetry, GROUND, albedo=DARK_GREEN)
    return replace(air, sun_scale=distance**-2)


def taught_two_lobes(depth: float, share: float, narrow: float, wide: float, distance: float = 1.0) -> Atmosphere:
    """The same with an aerosol of two Henyey-Greenstein lobes, `share` of them the narrow one."""
    molecules, aerosol, *others = taught_air(depth, 0.7, distance).constituents
    lobes = Aerosol(depth, phase=HenyeyGreenstein((narrow, wide), (share, 1 - share)), profile=aerosol.profile)
    return replace(taught_air(depth, 0.7, distance), constituents=(molecules, lobes, *others))


def two_lobe_air(depth: float, share: float, narrow: float, wide: float, distance: float = 1.0) -> Atmosphere:
    """The same with an aerosol of two Henyey-Greenstein lobes, `share` of them the narrow one."""
    law = HenyeyGreenstein((narrow, wide), (share, 1 - share))
    return Atmosphere.standard(depth, 0.0, GROUND, 330.0, DARK_GREEN, law, sun_scale=distance**-2)


class Refit:
    """From a sun to the fast sky of plain air: the nine numbers are fitted once for each air, then only evaluated."""

    def __init__(self) -> None:
        self.known: dict[tuple[float, float], Numbers] = {}

    def __call__(self, sun: np.ndarray, depth: float, asymmetry: float, distance: float = 1.0) -> Refitted:
        """The sky of one sun at a distance, AU."""
        from skydome.own_air.refit import refitted

        if (depth, asymmetry) not in self.known:
            self.known[depth, asymmetry] = refitted(plain_air(depth, asymmetry))
        return Refitted(sun, replace(self.known[depth, asymmetry], sun_scale=distance**-2))


class TwoModes:
    """From a sun to the physical sky of two lognormal modes of spheres by Mie: worked out once, then only mixed."""

    sizes = (Lognormal(0.12e-6, 1.6), Lognormal(0.6e-6, 1.8))
    wavelengths = np.arange(380.0, 801.0, 60.0)

    @cached_property
    def modes(self) -> tuple[Aerosol, ...]:
        """Fine and coarse, each of optical depth 1 at 550 nm; refractive index 1.5 - 0.005 i."""
        particles = (MieParticles(sizes, 1.5, 0.005) for sizes in self.sizes)
        return tuple(each.optics(self.wavelengths).aerosol(1.0) for each in particles)

    def __call__(self, sun: np.ndarray, fine: float, coarse: float, distance: float = 1.0) -> PhysicalSky:
        """The sky; depths of both modes at 550 nm."""
        molecules, _, *others = taught_air(0.1, 0.7, distance).constituents
        low = [thinned(mode, depth) for mode, depth in zip(self.modes, (fine, coarse), strict=True)]
        air = replace(taught_air(0.1, 0.7, distance), constituents=(molecules, *low, *others))
        return PhysicalSky(sun, air, check="clamp")


def thinned(aerosol: Aerosol, share: float) -> Aerosol:
    """So much of an aerosol whose depth is a spectrum."""
    depth = aerosol.optical_depth
    return replace(aerosol, optical_depth=Spectrum(depth.wavelengths, share * depth.values))


PLAIN = {"depth": 0.06, "asymmetry": 0.76}
PLAIN_LIMITS = {"depth": (0.005, 0.5), "asymmetry": (0.4, 0.95)}
TURBIDITY = 2.5
"""A clear day's, where a fit does not look for it."""


def of_air(model: AirModel) -> EvaluatedModel:
    """A sky of the catalogue in plain air; what is noisy is not fitted."""
    kind: Any = model.kind
    air = taught_air if isinstance(model, PhysicalModel) else plain_air
    taught = {"asymmetry": (TAUGHT["asymmetry"].low, TAUGHT["asymmetry"].high)}
    limits = PLAIN_LIMITS | (taught if isinstance(model, PhysicalModel) else {})
    limits = {} if isinstance(model, TracedModel) else limits
    return EvaluatedModel(
        model.name,
        lambda sun, depth, asymmetry, distance: kind(sun, air(depth, asymmetry, distance)),
        PLAIN,
        limits,
        model.failures,
        knows_distance=True,
    )


def of_numbers(model: Model) -> EvaluatedModel:
    """A formula of the catalogue, its ranges the limits of the fit, over green ground where it knows the ground."""
    kind: Any = model.kind
    ground = {"albedo": DARK_GREEN} if "albedo" in model.takes else {}
    spans = {name: span for name, span in model.kind.ranges.items() if name in model.takes and name not in ground}
    limits = {name: (span.low, span.high) for name, span in spans.items() if span.is_finite}
    usual = {name: TURBIDITY if name == "turbidity" else (low + high) / 2 for name, (low, high) in limits.items()}
    return EvaluatedModel(
        model.name, lambda sun, **numbers: kind(sun, **ground, **numbers), usual, limits, model.failures
    )


CLEAR_DAY = {"direct_normal_irradiance": 850.0, "diffuse_horizontal_irradiance": 80.0}
CLEAR_DAY_LIMITS = {"direct_normal_irradiance": (0.0, 1100.0), "diffuse_horizontal_irradiance": (20.0, 500.0)}
ILLUMINANCE = {"illuminance": 11_000.0}
"""Of a clear day's sky, lx."""


def of_luminance(model: Model) -> EvaluatedModel:
    """A sky of luminance alone, in the colours of daylight: from irradiances, or of an illuminance, of a clear day."""
    kind: Any = model.kind
    span = {"illuminance": (1_000.0, 40_000.0)}
    usual, limits = (CLEAR_DAY, CLEAR_DAY_LIMITS) if model.knows_level else (ILLUMINANCE, span)
    shape = {} if model.knows_level else {n: s for n, s in kind.ranges.items() if n in model.takes}
    own = {name: kind.__dataclass_fields__[name].default for name in shape}

    def make(sun: np.ndarray, **numbers: float) -> SpectralSky:
        return Daylight(kind(sun, **model.fixed, **numbers))

    return EvaluatedModel(
        model.name, make, usual | own, limits | {n: (s.low, s.high) for n, s in shape.items()}, model.failures
    )


def models() -> dict[str, EvaluatedModel]:
    """Every model by name: those of the catalogue that tell their failures, and skies of this study's own airs."""
    evaluated = [model for model in CATALOGUE if model.failures and issubclass(model.kind, SpectralSky)]
    by_luminance = [model for model in CATALOGUE if model.failures and not issubclass(model.kind, SpectralSky)]
    listed = (
        *(of_air(model) if isinstance(model, AirModel) else of_numbers(model) for model in evaluated),
        *(of_luminance(model) for model in by_luminance),
        EvaluatedModel(
            "two-lobe-air",
            lambda sun, **numbers: DiscreteOrdinates(sun, two_lobe_air(**numbers)),
            {"depth": 0.068, "share": 0.37, "narrow": 0.853, "wide": 0.609},
            {"depth": (0.005, 0.5), "share": (0.0, 1.0), "narrow": (0.7, 0.97), "wide": (0.0, 0.8)},
            "its aerosol has been fitted to this day and place",
            knows_distance=True,
        ),
        EvaluatedModel(
            "physical-two-lobes",
            lambda sun, **numbers: PhysicalSky(sun, taught_two_lobes(**numbers), check="clamp"),
            {"depth": 0.068, "share": 0.37, "narrow": 0.853, "wide": 0.609},
            {"depth": (0.005, 0.5), "share": (0.0, 1.0), "narrow": (0.7, 0.97), "wide": (0.0, 0.8)},
            "its aerosol has been fitted to this day and place; no polarisation (up to 7 % at 400 nm)",
            knows_distance=True,
        ),
        EvaluatedModel(
            "physical-two-modes",
            TwoModes(),
            {"fine": 0.05, "coarse": 0.015},
            {"fine": (0.003, 0.3), "coarse": (0.001, 0.15)},
            "spheres of two sizes, of one refractive index; no polarisation (up to 7 % at 400 nm)",
            knows_distance=True,
        ),
        EvaluatedModel(
            "refitted",
            Refit(),
            PLAIN,
            {},
            "those of discrete ordinates, and a fit error of about 2 %",
            knows_distance=True,
        ),
        EvaluatedModel(
            "bruneton-air",
            lambda sun, distance: DiscreteOrdinates(sun, replace(Atmosphere.bruneton2016(), sun_scale=distance**-2)),
            {},
            {},
            "no ozone, a strongly absorbing aerosol, as in Bruneton's evaluation",
            knows_distance=True,
        ),
    )
    return {model.name: model for model in listed}


def model_of(name: str) -> EvaluatedModel:
    """The model by name; ValueError with the names there are."""
    known = models()
    if name not in known:
        raise ValueError(f"model must be one of {', '.join(known)}, got {name!r}")
    return known[name]
