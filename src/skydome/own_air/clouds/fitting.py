"""A network of the coefficients of shapes: first steps over some cases at a time, then over all of them by the
curvature of the error (L-BFGS).
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from skydome.own_air.all_air.training import Course, layers, require_torch, step, unscaled
from skydome.own_air.clouds.lessons import OvercastLessons
from skydome.own_air.clouds.shapes import CloudShapes, Forms
from skydome.skies.clouds.overcast_network import OvercastNetwork

TAMED, SMALL = 0.06, 3e-8
"""The error beyond which a case counts less in the last steps, and what keeps weights small."""
SOME, WIDEST = 384, 3.0
"""Cases at a time; spread of the coefficients up to which the network starts as wide."""


def fitted(
    lessons: OvercastLessons, shapes: CloudShapes, course: Course, last: int, seed: int, report: Callable[[float], None]
) -> OvercastNetwork:
    """The network of a course, its `steps` over some cases and the `last` over all of the lessons."""
    torch, read, forms = require_torch(), lessons.inputs()[:, 0], shapes.forms(lessons)
    middle, size = read.mean(axis=0), read.std(axis=0) + 1e-9
    torch.manual_seed(seed)
    net = layers(torch, read.shape[1], course._replace(shapes=course.shapes + 1))
    started(torch, net, forms)
    given = (read - middle) / size
    learn_some(torch, net, given, forms, course, np.random.default_rng(seed), report)
    learn_all(torch, net.double(), given, forms, last)
    return OvercastNetwork(unscaled(net, middle, size), shapes.table, shapes.places)


def started(torch: Any, net: Any, forms: Forms) -> None:
    """The last layer as wide as the coefficients, about their mean."""
    wide = np.minimum(forms.best.std(axis=0), WIDEST)[:, None]
    with torch.no_grad():
        net[-1].bias.copy_(torch.tensor(forms.best.mean(axis=0)))
        net[-1].weight.mul_(torch.tensor(wide, dtype=torch.float32))


def tame_error(torch: Any, off: Any, form: Any, tamed: float) -> Any:
    """Mean over cases of their rms error, its largest tamed, from coefficients (N, S) too many."""
    square = (off * torch.bmm(form, off[..., None])[..., 0]).sum(1).clamp(min=0)
    return (torch.sqrt(square + tamed**2) - tamed).mean()


def learn_some(
    torch: Any,
    net: Any,
    given: np.ndarray,
    forms: Forms,
    course: Course,
    random: np.random.Generator,
    report: Callable[[float], None],
) -> None:
    """The course's steps."""
    read, best, form = (torch.tensor(part, dtype=torch.float32) for part in (given, *forms))
    optimiser = torch.optim.AdamW(net.parameters(), 1e-3, weight_decay=1e-3)
    pace = torch.optim.lr_scheduler.OneCycleLR(optimiser, 4e-3, total_steps=course.steps, pct_start=0.1)
    for number in range(course.steps):
        some = torch.tensor(random.choice(len(read), min(SOME, len(read)), replace=False))
        loss = tame_error(torch, net(read[some]) - best[some], form[some], course.tamed)
        step(torch, net, loss, optimiser, pace)
        if number % 100 == 0:
            report(float(loss.detach()))


def learn_all(torch: Any, net: Any, given: np.ndarray, forms: Forms, steps: int) -> None:
    """So many steps over all cases."""
    read, best, form = (torch.tensor(part) for part in (given, *forms))
    optimiser = torch.optim.LBFGS(
        net.parameters(), max_iter=steps, max_eval=2 * steps, history_size=40, line_search_fn="strong_wolfe",
        tolerance_change=1e-14,
    )  # fmt: skip

    def error() -> Any:
        optimiser.zero_grad()
        small = SMALL * sum((part**2).sum() for part in net.parameters() if part.ndim == 2)
        loss = tame_error(torch, net(read) - best, form, TAMED) + small
        loss.backward()
        return loss

    optimiser.step(error)
