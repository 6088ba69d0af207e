"""A list of models, fitted or not, against a measured sky."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from skydome.evaluation.evaluation import Comparison, compared
from skydome.evaluation.measured_sky import MeasuredSky
from skydome.evaluation.model_fit import fitted
from skydome.evaluation.models import EvaluatedModel, model_of, models
from skydome.evaluation.pointing import Repointed
from skydome.ground.extras import required

FITS = ("no", "all", "half", "each")


@dataclass(frozen=True, eq=False)
class Run:
    """One model's comparison, with the numbers it was made with (for `each` a list of them) and its known failures."""

    comparison: Comparison
    numbers: Any
    failures: str
    repointed: Repointed | None = None

    def row(self) -> dict[str, Any]:
        """Plain figures for a table."""
        anew = {} if self.repointed is None else self.repointed.figures()
        own = {"model": self.comparison.name} | self.comparison.figures()
        return own | anew | {"numbers": numbers_text(self.numbers)}


def numbers_text(numbers: Any) -> str:
    """Numbers in a line; of a list of them, one for each scan, the least and the most.

    >>> numbers_text({"turbidity": 2.5}), numbers_text([{"turbidity": 2.5}, {"turbidity": 2.25}])
    ('turbidity 2.5', 'turbidity 2.25 to 2.5')
    """
    if isinstance(numbers, list):
        spans = {name: [float(part[name]) for part in numbers] for name in numbers[0]}
        return ", ".join(f"{name} {min(values):.4g} to {max(values):.4g}" for name, values in spans.items())
    return ", ".join(f"{name} {value:.4g}" for name, value in numbers.items())


def evaluated(sky: MeasuredSky, names: list[str], fit: str = "no", pointing: bool = False) -> list[Run]:
    """The runs of the named models (`all`: every one). ValueError for a name or a way of fitting that is not known.

    With `pointing` each is also held against scans that are turned and leant for it, after its numbers were fitted.
    """
    if fit not in FITS:
        raise ValueError(f"fit must be one of {', '.join(FITS)}, got {fit!r}")
    if fit != "no" or pointing:
        required("scipy", "fit", "a fit to measured skies")
    chosen = list(models()) if names == ["all"] else names
    runs = [(model_of(name), run(model_of(name), sky, fit)) for name in chosen]
    return [with_pointing(model, found) if pointing else found for model, found in runs]


def with_pointing(model: EvaluatedModel, found: Run) -> Run:
    """The same with its scans pointed anew."""
    sky = found.comparison.sky
    each = found.numbers if isinstance(found.numbers, list) else [found.numbers] * len(sky)
    return replace(found, repointed=Repointed.of(model.name, sky, [model.sky_of(numbers) for numbers in each]))


def run(model: EvaluatedModel, sky: MeasuredSky, fit: str) -> Run:
    """One model: as it is, or fitted to all scans, to every second (and held against the others), or to each."""
    if fit == "each":
        return fitted_to_each(model, sky)
    numbers, other = model.numbers, sky
    if fit == "all":
        numbers = model.numbers | fitted(model, sky)
    elif fit == "half":
        other = sky.some(slice(1, None, 2))
        numbers = model.numbers | fitted(model, sky.some(slice(0, None, 2)))
    return Run(compared(model.name, other, model.sky_of(numbers)), numbers, model.failures)


def fitted_to_each(model: EvaluatedModel, sky: MeasuredSky) -> Run:
    """The model with its own numbers for each scan."""
    numbers = [model.numbers | fitted(model, sky.some([k])) for k in range(len(sky))]
    parts = [compared(model.name, sky.some([k]), model.sky_of(numbers[k])) for k in range(len(sky))]
    whole = replace(
        parts[0],
        sky=sky,
        model=np.concatenate([part.model for part in parts]),
        model_xyz=np.concatenate([part.model_xyz for part in parts]),
    )
    return Run(whole, numbers, model.failures)
