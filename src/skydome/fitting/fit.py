"""The conditions behind an observed sky: a model's parameters by least squares, with what is known of their errors."""

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.fitting.determination import centred, degenerate_names, errors_by_name, rivalled_names
from skydome.fitting.samples import Observations, samples_of
from skydome.fitting.starting import starts
from skydome.fitting.unknowns import Problem
from skydome.ground.extras import required
from skydome.light.colour import SRGB, RGBSpace
from skydome.maps.environment_map import EnvironmentMap
from skydome.skies.sky import Sky

MOST_SAMPLES = 40_000
"""Samples used at the end; more are thinned evenly."""

FEW_SAMPLES = 1500
"""Samples used to try the starts."""

NEAR = 1e-4
"""Share of its span by which a number that ends at a limit may be away from it."""

FAINT = 0.02
"""Least light by which differences are divided, over the mean: dark places count no more than that."""


@dataclass(frozen=True, eq=False)
class Fit:
    """A fitted sky and how well it is known.

    `parameters` by name; `names`, `covariance` (p, p) and `standard_errors` (by name; "sun": radians of arc) of the
    numbers varied, "sun_across" and "sun_up" being the sun's two angles. `residual` is observed minus fitted light, as
    observed or as a map; `rms` its root mean square; `relative_rms` that of the differences over the fitted light.
    Where the samples cannot tell, `determined` is False, `degenerate` names the parameters, which are NaN in
    `parameters` and infinite in `standard_errors`, and `message` says so; `sky` still shows light like that observed.

    >>> import skydome as sd
    >>> sun, views = sd.direction(2.0, 0.7), sd.direction(np.arange(50) * 2.4 % 6.283, np.linspace(0.1, 1.5, 50))
    >>> found = fit(sd.Preetham, views, sd.Preetham(sun, 3.3).luminance(views), initial={"sun": sun})
    >>> found.names, round(found.parameters["turbidity"], 3)
    (('sun_across', 'sun_up', 'turbidity'), 3.3)
    """

    sky: Sky
    parameters: dict[str, Any]
    names: tuple[str, ...]
    covariance: np.ndarray
    standard_errors: dict[str, float]
    residual: Any
    rms: float
    relative_rms: float
    success: bool
    determined: bool
    degenerate: tuple[str, ...]
    message: str


@dataclass(frozen=True, eq=False)
class Objective:
    """The differences that are squared and summed: (fitted - observed) x weight, for some of the samples."""

    problem: Problem
    samples: Observations
    chosen: np.ndarray
    about: np.ndarray
    reference: np.ndarray

    def light(self, x: np.ndarray) -> np.ndarray:
        """The model's light toward the chosen samples, (n,) or (n, channels)."""
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            return self.samples.light(self.problem.sky(self.problem.values(x, self.about), "nan"), self.toward)

    @property
    def toward(self) -> np.ndarray:
        """Directions of the chosen samples, (n, 3)."""
        toward: np.ndarray = self.samples.directions[self.chosen]
        return toward

    def differences(self, x: np.ndarray) -> np.ndarray:
        """Weighted differences, flat; finite even where the model is not."""
        difference = (self.light(x) - self.samples.values[self.chosen]) / self.reference
        flat: np.ndarray = np.nan_to_num(difference, nan=1e6, posinf=1e6, neginf=-1e6).reshape(-1)
        return flat


def reference(samples: Observations, chosen: np.ndarray, light: np.ndarray) -> np.ndarray:
    """What differences are divided by: 1 / sqrt(weight), or without weights the light itself, held off 0.

    The light is a model's, not the observed: noise must not choose its own weight.
    """
    if samples.weights is not None:
        weight = samples.weights[chosen]
        own = np.where(weight > 0, 1 / np.sqrt(np.where(weight > 0, weight, 1.0)), np.inf)
    else:
        size = np.abs(light) if light.ndim == 1 else np.abs(light).mean(axis=-1)
        own = np.maximum(size, max(FAINT * float(size.mean()), 1e-30))
    return own if light.ndim == 1 else own[:, None]


def solved(objective: Objective, x: np.ndarray, effort: int) -> Any:
    """scipy's answer of the bounded least squares from x (p,)."""
    from scipy.optimize import least_squares

    unknowns = objective.problem.unknowns
    low, high = np.array([u.low for u in unknowns]), np.array([u.high for u in unknowns])
    inset = 1e-9 * np.array([u.span for u in unknowns])
    return least_squares(
        objective.differences,
        np.clip(x, low + inset, high - inset),
        bounds=(low, high),
        x_scale=np.array([u.span for u in unknowns]),
        jac="3-point",
        ftol=1e-13,
        xtol=1e-12,
        gtol=1e-13,
        max_nfev=effort,
    )


def refined(
    problem: Problem, samples: Observations, chosen: np.ndarray, x: np.ndarray, about: np.ndarray, rounds: int
) -> tuple[Objective, Any]:
    """The objective and scipy's answer after some rounds, each from the last one's sun, its light as reference."""
    objective = Objective(problem, samples, chosen, about, np.array(1.0))
    answer: Any = None
    for _ in range(rounds):
        divisor = reference(samples, chosen, objective.light(x))
        objective = Objective(problem, samples, chosen, objective.about, divisor)
        answer = solved(objective, x, 60)
        x, about = answer.x.copy(), objective.about
        if "sun" in problem.free:
            about = problem.values(x, about)["sun"]
        x = centred(problem, x)
        objective = Objective(problem, samples, chosen, about, divisor)
    return objective, answer


def evenly(used: np.ndarray, most: int) -> np.ndarray:
    """Indices of at most `most` of the samples that count, spread over all of them and always the same ones."""
    index = np.flatnonzero(used)
    return index if len(index) <= most else np.sort(np.random.default_rng(0).permutation(index)[:most])


def report(
    problem: Problem, samples: Observations, objective: Objective, answer: Any, rivalled: tuple[str, ...]
) -> Fit:
    """The answer as a `Fit`."""
    x = centred(problem, answer.x)
    values = problem.values(x, objective.about)
    sky = problem.sky(values)
    freedom = max(1, answer.fun.size - len(x))
    sigma = float(np.sqrt(answer.fun @ answer.fun / freedom))
    open_names = {*degenerate_names(problem, answer.jac, sigma), *rivalled}
    degenerate = tuple(name for name in problem.free if name in open_names)
    covariance = sigma**2 * np.linalg.pinv(answer.jac.T @ answer.jac, hermitian=True)
    difference = samples.values[objective.chosen] - objective.light(x)
    parameters = {n: np.full(np.shape(v), np.nan)[()] if n in degenerate else v for n, v in values.items()}
    message = str(answer.message)
    if degenerate:
        message = f"the samples do not determine {', '.join(degenerate)}; fix one, or show more of the sky"
    if stuck := at_limits(problem, x, degenerate):
        warnings.warn(f"the fit of {problem.model.__name__} ended at a limit: {', '.join(stuck)}", stacklevel=3)
    return Fit(
        sky, parameters, problem.numbers, covariance, errors_by_name(problem, covariance, degenerate),
        samples.residual(sky), float(np.sqrt(np.mean(difference**2))), float(np.sqrt(np.mean(answer.fun**2))),
        bool(answer.status > 0 and not degenerate), not degenerate, degenerate, message,
    )  # fmt: skip


def at_limits(problem: Problem, x: np.ndarray, degenerate: tuple[str, ...]) -> list[str]:
    """The parameters that stand at an end of their range, with their numbers; not the sun, nor what is open anyhow."""
    each = zip(problem.numbers, problem.unknowns, x, strict=True)
    return [
        f"{name} {number:.4g}"
        for name, unknown, number in each
        if name in problem.free
        and name not in degenerate
        and np.isfinite(unknown.high)  # not levels, which have none
        and min(number - unknown.low, unknown.high - number) < NEAR * unknown.span
    ]


def fit(
    model: type[Sky],
    directions: ArrayLike | EnvironmentMap,
    observed: ArrayLike | EnvironmentMap | None = None,
    *,
    mask: ArrayLike | None = None,
    initial: Mapping[str, Any] | None = None,
    free: Sequence[str] | None = None,
    weights: ArrayLike | None = None,
    space: RGBSpace | None = SRGB,
) -> Fit:
    """The `Fit` of a model to observed light: its conditions, their covariance, and what is left over.

    `observed` is luminance (N,), cd m-2, or (N, 3) in the RGB `space` (None: XYZ) toward `directions` (N, 3), or an
    `EnvironmentMap`, given instead of the directions. `mask` is True where a sample counts: leave out the sun's disc,
    clouds and buildings; what is not above the horizon never counts. `free` names what to find: "sun", "turbidity",
    "albedo", the letters "a" to "e", "zenith_luminance", "illuminance", "scale" (a factor on all light); by default the
    sun and the model's main parameters. `initial` starts a free parameter and holds any other. `weights` (N,) are
    1 / variance; by default differences are divided by the fitted light: noise in proportion to it.

    Bounded Levenberg-Marquardt (scipy's trust region), from a coarse grid over suns, the brightest part first, and
    turbidities. ValueError where samples are fewer than unknowns or nothing is left; where the samples cannot tell, the
    Fit says `determined=False` and which parameters. What ends at a limit of its range is told by a warning.

    >>> import skydome as sd
    >>> truth = sd.Preetham(sd.direction(azimuth=2.0, elevation=0.7), turbidity=3.3)
    >>> views = sd.direction(azimuth=np.arange(200) * 2.4 % 6.283, elevation=np.arcsin((np.arange(200) + 0.5) / 200))
    >>> found = fit(sd.Preetham, views, truth.luminance(views))
    >>> round(found.parameters["turbidity"], 4), round(float(sd.azimuth(found.parameters["sun"])), 4)
    (3.3, 2.0)
    """
    required("scipy", "fit", "a fit")
    problem = Problem.of(model, free, initial)
    samples = samples_of(directions, observed, mask, weights, space)
    count, unknown = int(samples.used.sum()), len(problem.numbers)
    if count * (1 if samples.values.ndim == 1 else 3) < unknown + 1:
        raise ValueError(f"{unknown} unknowns need more than {unknown} samples above the horizon, got {count}")
    few = evenly(samples.used, FEW_SAMPLES)
    tried = [refined(problem, samples, few, x, about, 2) for x, about in starts(problem, samples, few)]
    objective, answer = min(tried, key=lambda pair: float(pair[1].cost))
    x, about = centred(problem, answer.x), objective.about
    objective, answer = refined(problem, samples, evenly(samples.used, MOST_SAMPLES), x, about, 2)
    return report(problem, samples, objective, answer, rivalled_names(problem, tried))
