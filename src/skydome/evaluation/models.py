"""The models that can be held against a measured sky, by name, with the numbers of each that may be fitted."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.air.atmosphere import DARK_GREEN, Atmosphere
from skydome.air.phase_laws import HenyeyGreenstein
from skydome.evaluation.evaluation import SkyOf
from skydome.evaluation.measured_sky import MeasuredSky
from skydome.skies.all_air.taught_air import TAUGHT
from skydome.skies.catalogue import CATALOGUE
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.model import AirModel, Model, PhysicalModel, TracedModel
from skydome.skies.physical.discrete_ordinates import DiscreteOrdinates
from skydome.skies.physical.refitted import Numbers, Refitted

GROUND = 98_500.0
"""Pressure at 280 m, Pa."""


@dataclass(frozen=True)
class EvaluatedModel:
    """A model: a sky from a sun and numbers; their usual values, limits (of those that are fitted), known failures."""

    name: str
    make: Callable[..., SpectralSky]
    numbers: dict[str, float]
    limits: dict[str, tuple[float, float]]
    failures: str

    def sky_of(self, numbers: dict[str, float] | None = None) -> SkyOf:
        """From a sun to the sky, with the usual numbers or those given."""
        chosen = self.numbers | (numbers or {})
        return lambda sun: self.make(sun, **chosen)


def plain_air(depth: float, asymmetry: float, distance: float = 1.0) -> Atmosphere:
    """Clean air over green ground: one lobe of aerosol, ozone 330 DU; the sun at a `distance` in AU."""
    return Atmosphere.standard(depth, asymmetry, GROUND, 330.0, DARK_GREEN, sun_scale=distance**-2)


def two_lobe_air(depth: float, share: float, narrow: float, wide: float, distance: float = 1.0) -> Atmosphere:
    """The same with an aerosol of two Henyey-Greenstein lobes, `share` of them the narrow one."""
    law = HenyeyGreenstein((narrow, wide), (share, 1 - share))
    return Atmosphere.standard(depth, 0.0, GROUND, 330.0, DARK_GREEN, law, sun_scale=distance**-2)


def distance_of(sky: MeasuredSky) -> float:
    """The sun's distance on the day, AU."""
    from skydome.sun.position import earth_sun_distance

    return float(np.mean(earth_sun_distance([str(time) for time in sky.times])))


class Refit:
    """From a sun to the fast sky of plain air: the nine numbers are fitted once for each air, then only evaluated."""

    def __init__(self, distance: float) -> None:
        self.distance = distance
        self.known: dict[tuple[float, float], Numbers] = {}

    def __call__(self, sun: np.ndarray, depth: float, asymmetry: float) -> Refitted:
        """The sky of one sun."""
        from skydome.own_air.refit import refitted

        if (depth, asymmetry) not in self.known:
            self.known[depth, asymmetry] = refitted(plain_air(depth, asymmetry, self.distance))
        return Refitted(sun, self.known[depth, asymmetry])


PLAIN = {"depth": 0.06, "asymmetry": 0.76}
PLAIN_LIMITS = {"depth": (0.005, 0.5), "asymmetry": (0.4, 0.95)}
TURBIDITY = 2.5
"""A clear day's, where a fit does not look for it."""


def of_air(model: AirModel, distance: float) -> EvaluatedModel:
    """A sky of the catalogue in plain air; what is noisy is not fitted."""
    kind: Any = model.kind
    taught = {"asymmetry": (TAUGHT["asymmetry"].low, TAUGHT["asymmetry"].high)}
    limits = PLAIN_LIMITS | (taught if isinstance(model, PhysicalModel) else {})
    limits = {} if isinstance(model, TracedModel) else limits
    return EvaluatedModel(
        model.name,
        lambda sun, depth, asymmetry: kind(sun, plain_air(depth, asymmetry, distance)),
        PLAIN,
        limits,
        model.failures,
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


def models(distance: float = 1.0) -> dict[str, EvaluatedModel]:
    """Every model by name: those of the catalogue that tell their failures, and skies of this study's own airs.

    The physical ones have the sun at a `distance`, AU.
    """
    evaluated = [model for model in CATALOGUE if model.failures and issubclass(model.kind, SpectralSky)]
    listed = (
        *(of_air(model, distance) if isinstance(model, AirModel) else of_numbers(model) for model in evaluated),
        EvaluatedModel(
            "two-lobe-air",
            lambda sun, **numbers: DiscreteOrdinates(sun, two_lobe_air(distance=distance, **numbers)),
            {"depth": 0.068, "share": 0.37, "narrow": 0.853, "wide": 0.609},
            {"depth": (0.005, 0.5), "share": (0.0, 1.0), "narrow": (0.7, 0.97), "wide": (0.0, 0.8)},
            "its aerosol has been fitted to this day and place",
        ),
        EvaluatedModel(
            "refitted",
            Refit(distance),
            PLAIN,
            {},
            "those of discrete ordinates, and a fit error of about 2 %",
        ),
        EvaluatedModel(
            "bruneton-air",
            lambda sun: DiscreteOrdinates(sun, Atmosphere.bruneton2016()),
            {},
            {},
            "no ozone, a strongly absorbing aerosol, as in Bruneton's evaluation",
        ),
    )
    return {model.name: model for model in listed}


def model_of(name: str, distance: float = 1.0) -> EvaluatedModel:
    """The model by name; ValueError with the names there are."""
    known = models(distance)
    if name not in known:
        raise ValueError(f"model must be one of {', '.join(known)}, got {name!r}")
    return known[name]


def fitted(model: EvaluatedModel, sky: MeasuredSky, start: dict[str, float] | None = None) -> dict[str, Any]:
    """The numbers of a model, within its limits, that make the mean measure least over all scans of a sky."""
    from scipy.optimize import minimize

    from skydome.evaluation.evaluation import band_mean, relative_rms

    if not model.limits:
        return {}
    names, measured = list(model.limits), sky.band()
    limits = [model.limits[name] for name in names]

    def loss(values: np.ndarray) -> float:
        make = model.sky_of(dict(zip(names, map(float, values), strict=True)))
        light = [band_mean(make(sun), views) for sun, views in zip(sky.suns, sky.directions, strict=True)]
        return float(relative_rms(np.stack(light), measured, sky.valid).mean())

    begin = np.array([(model.numbers | (start or {}))[name] for name in names])
    options = {"xatol": 1e-3, "fatol": 2e-5, "maxfev": 60 * len(names)}
    found = minimize(loss, begin, method="Nelder-Mead", bounds=limits, options=options)
    return dict(zip(names, (float(v) for v in found.x), strict=True))
