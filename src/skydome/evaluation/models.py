"""The models that can be held against a measured sky, by name, with the numbers of each that may be fitted."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.air.atmosphere import DARK_GREEN, Atmosphere
from skydome.air.phase_laws import HenyeyGreenstein
from skydome.evaluation.evaluation import SkyOf
from skydome.evaluation.measured_sky import MeasuredSky
from skydome.skies.hosek_wilkie import HosekWilkie
from skydome.skies.path_tracing.sky import PathTraced
from skydome.skies.physical.discrete_ordinates import DiscreteOrdinates
from skydome.skies.physical.nishita import Nishita93, Nishita96
from skydome.skies.physical.refitted import Numbers, Refitted
from skydome.skies.preetham import Preetham
from skydome.skies.sky import SpectralSky

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


def models(distance: float = 1.0) -> dict[str, EvaluatedModel]:
    """Every model by name; the physical ones with the sun at a `distance`, AU."""
    listed = (
        EvaluatedModel(
            "preetham",
            lambda sun, turbidity: Preetham(sun, turbidity),
            {"turbidity": 2.5},
            {"turbidity": (2.0, 6.0)},
            "about twice too bright away from the sun; far too bright round it",
        ),
        EvaluatedModel(
            "hosek-wilkie",
            lambda sun, turbidity: HosekWilkie(sun, turbidity, DARK_GREEN),
            {"turbidity": 2.5},
            {"turbidity": (1.0, 10.0)},
            "at the turbidity that fits best 40 % too bright away from the sun and too dark round it",
        ),
        EvaluatedModel(
            "plain-air",
            lambda sun, depth, asymmetry: DiscreteOrdinates(sun, plain_air(depth, asymmetry, distance)),
            {"depth": 0.06, "asymmetry": 0.76},
            {"depth": (0.005, 0.5), "asymmetry": (0.4, 0.95)},
            "no polarisation (up to 7 % at 400 nm); one lobe cannot have both the aureole and the sides right",
        ),
        EvaluatedModel(
            "two-lobe-air",
            lambda sun, **numbers: DiscreteOrdinates(sun, two_lobe_air(distance=distance, **numbers)),
            {"depth": 0.068, "share": 0.37, "narrow": 0.853, "wide": 0.609},
            {"depth": (0.005, 0.5), "share": (0.0, 1.0), "narrow": (0.7, 0.97), "wide": (0.0, 0.8)},
            "its aerosol has been fitted to this day and place",
        ),
        EvaluatedModel(
            "nishita93",
            lambda sun, depth, asymmetry: Nishita93(sun, plain_air(depth, asymmetry, distance)),
            {"depth": 0.06, "asymmetry": 0.76},
            {"depth": (0.005, 0.5), "asymmetry": (0.4, 0.95)},
            "one scattering only: too dark, most of all in the blue and away from the sun",
        ),
        EvaluatedModel(
            "nishita96",
            lambda sun, depth, asymmetry: Nishita96(sun, plain_air(depth, asymmetry, distance)),
            {"depth": 0.06, "asymmetry": 0.76},
            {"depth": (0.005, 0.5), "asymmetry": (0.4, 0.95)},
            "two scatterings only: a few percent (red) to a fifth (blue) too dark",
        ),
        EvaluatedModel(
            "path-traced",
            lambda sun, depth, asymmetry: PathTraced(sun, plain_air(depth, asymmetry, distance), 0.01),
            {"depth": 0.06, "asymmetry": 0.76},
            {},
            "noise of 1 %, so that its numbers are not fitted; else those of plain-air",
        ),
        EvaluatedModel(
            "refitted",
            Refit(distance),
            {"depth": 0.06, "asymmetry": 0.76},
            {},
            "those of plain-air, and a fit error of about 2 %",
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
