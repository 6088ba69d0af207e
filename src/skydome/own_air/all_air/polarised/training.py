"""The network of polarisation, trained on lessons: shapes by singular values, then coefficients and shapes together.

What is made small is the error of Q, U and intensity over the whole light at the nodes.
"""

from collections.abc import Callable
from os import PathLike
from typing import Any, NamedTuple

import numpy as np

from skydome.own_air.all_air.polarised.lessons import AZIMUTHS, VIEWS, PolarisedLessons
from skydome.own_air.all_air.training import require_torch, step, unscaled
from skydome.skies.all_air.polarised.files import save_polarisation
from skydome.skies.all_air.polarised.network import PolarisedRest, U
from skydome.skies.all_air.rest import features
from skydome.skies.all_air.taught_air import Optics

NODES = VIEWS * AZIMUTHS


class Course(NamedTuple):
    """How many shapes, cosines of the azimuth in each, the network's width, steps, and the error that is tamed."""

    shapes: int = 18
    terms: int = 5
    width: int = 48
    steps: int = 12_000
    tamed: float = 0.01


def train_polarisation(
    folder: str | PathLike[str],
    output: str | PathLike[str],
    course: Course = Course(),  # noqa: B008
    seed: int = 0,
    report: Callable[[int, float], None] = lambda *_: None,
) -> dict[str, float]:
    """Trains on a folder of lessons and writes a file that `load_polarisation` reads.

    The rms errors of intensity, Q and U over the whole light on airs held back. Needs torch.
    """
    lessons = PolarisedLessons.load(folder)
    network = taught(lessons.chosen(~lessons.held), course, seed, report)
    save_polarisation(
        output, network, f"skydome.own_air.all_air.polarised: {len(lessons.sines)} cases, seed {seed}, {course}"
    )
    return rms_errors(network, lessons.chosen(lessons.held))


def rms_errors(network: PolarisedRest, lessons: PolarisedLessons) -> dict[str, float]:
    """Over all nodes of all cases, by field; ValueError where no case is left."""
    if not len(lessons.sines):
        raise ValueError("no air is held back: make more lessons")
    off = (predicted(network, lessons) - lessons.fields) * lessons.share[:, None]
    return dict(zip(("intensity", "q", "u"), np.sqrt((off**2).mean(axis=(0, 2))).tolist(), strict=True))


def predicted(network: PolarisedRest, lessons: PolarisedLessons) -> np.ndarray:
    """The fields (N, 3, nodes) of cases."""
    found = network.coefficients(Optics(*(part[:, None] for part in lessons.air)), lessons.sines)[:, 0]
    return np.asarray(np.einsum("nk,fkp->nfp", found, at_nodes(network.shapes), optimize=True))


def waves(terms: int) -> np.ndarray:
    """From cosine coefficients of each field to the lessons' azimuths, (3, terms, AZIMUTHS)."""
    azimuth = np.linspace(0, np.pi, AZIMUTHS)
    even = np.cos(np.outer(np.arange(terms), azimuth))
    return np.stack([even * (np.sin(azimuth) if field == U else 1.0) for field in range(3)])


def at_nodes(shapes: np.ndarray) -> np.ndarray:
    """Shapes (3, S, VIEWS, terms) at all nodes, (3, S, NODES)."""
    found = np.matmul(shapes, waves(shapes.shape[-1])[:, None])
    return np.asarray(found.reshape(3, -1, NODES))


def first_shapes(lessons: PolarisedLessons, course: Course) -> np.ndarray:
    """Shapes (3, S, VIEWS, terms) by singular values of the fields, weighted by the rest's share of the light."""
    weight = np.sqrt(lessons.share.mean(axis=0))
    flat = (lessons.fields * weight).reshape(len(lessons.sines), -1).astype(np.float64)
    across = np.linalg.eigh(flat.T @ flat)[1][:, ::-1][:, : course.shapes]
    size = (flat @ across).std(axis=0)
    found = (across.T * size[:, None]).reshape(course.shapes, 3, NODES) / weight
    series = np.stack([np.linalg.pinv(part) for part in waves(course.terms)])
    return np.asarray(np.einsum("sfvp,fpt->fsvt", found.reshape(course.shapes, 3, VIEWS, AZIMUTHS), series))


def taught(
    lessons: PolarisedLessons, course: Course, seed: int = 0, report: Callable[[int, float], None] = lambda *_: None
) -> PolarisedRest:
    """The network of a course: every step some cases, all nodes."""
    torch, random = require_torch(), np.random.default_rng(seed)
    read = np.asarray(features(Optics(*(part[:, None] for part in lessons.air)), lessons.sines))[:, 0]
    middle, size = read.mean(axis=0), read.std(axis=0) + 1e-9
    torch.manual_seed(seed)
    net = layers(torch, read.shape[1], course)
    given, wanted, share, wave = (
        torch.tensor(part, dtype=torch.float32)
        for part in ((read - middle) / size, lessons.fields, lessons.share[:, None], waves(course.terms))
    )
    shapes = torch.nn.Parameter(torch.tensor(first_shapes(lessons, course), dtype=torch.float32))
    optimiser = torch.optim.AdamW([*net.parameters(), shapes], 3e-3, weight_decay=1e-4)
    pace = torch.optim.lr_scheduler.OneCycleLR(optimiser, 4e-3, total_steps=course.steps, pct_start=0.1)
    for number in range(course.steps):
        some = random.choice(len(read), min(256, len(read)), replace=False)
        whole = (shapes @ wave[:, None]).reshape(3, course.shapes, NODES)
        found = torch.einsum("nk,fkp->nfp", net(given[some]), whole)
        off = (found - wanted[some]) * share[some]
        loss = (torch.sqrt(off * off + course.tamed**2) - course.tamed).mean()
        step(torch, net, loss, optimiser, pace)
        if number % 100 == 0:
            report(number + 1, float(loss.detach()))
    return PolarisedRest(unscaled(net, middle, size), np.asarray(shapes.detach().numpy(), dtype=np.float64))


def layers(torch: Any, count: int, course: Course) -> Any:
    """A network of two hidden layers."""
    nn = torch.nn
    first, second = nn.Linear(count, course.width), nn.Linear(course.width, course.width)
    return nn.Sequential(first, nn.SiLU(), second, nn.SiLU(), nn.Linear(course.width, course.shapes))
