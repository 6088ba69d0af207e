"""Networks of the physical sky, trained on lessons: shapes by singular values, their coefficients by a small network.

First the network learns the coefficients, then network and shapes together learn the light itself: the difference of
the rest over the whole light, its largest values tamed.
"""

from collections.abc import Callable
from dataclasses import dataclass
from os import PathLike
from typing import Any, NamedTuple

import numpy as np

from skydome.ground.extras import required
from skydome.own_air.all_air.lessons import AZIMUTHS, VIEWS, Cases, Lessons
from skydome.skies.all_air.rest import Rest, RestNetwork, cosine_series, place_of
from skydome.skies.all_air.rest_files import save_rest

NODES = VIEWS * AZIMUTHS
FIRST_CASES = 30_000
"""Shapes and coefficients are found from at most so many cases, the light is then learned from all."""


class Course(NamedTuple):
    """Between which elevations, degrees, what is learned: shapes of mean air and others, the network's width, steps in
    all, cosines of the azimuth in a shape, and the error beyond which a case counts less.
    """

    low: float
    high: float
    shapes: int
    tamed: float
    mean_shapes: int = 13
    width: int = 96
    steps: int = 30_000
    terms: int = 13


DAY, TWILIGHT = Course(-1.0, 90.0, 24, 0.1), Course(-18.0, 3.0, 32, 0.3)
SMALL_DAY = DAY._replace(shapes=8, mean_shapes=7, width=40, terms=7)
SMALL_TWILIGHT = TWILIGHT._replace(shapes=10, mean_shapes=9, width=40, terms=7)
"""Of networks under 30 kB, for the web."""


def train_rest(
    folder: str | PathLike[str],
    output: str | PathLike[str],
    day: Course = DAY,
    twilight: Course = TWILIGHT,
    seed: int = 0,
    report: Callable[[str, float], None] = lambda *_: None,
) -> dict[str, float]:
    """Trains both networks on a folder of lessons and writes them to a file that `load_rest` reads.

    The rms errors of the whole radiance on airs held back, by network. Needs torch.
    """
    networks, errors = [], {}
    for name, course in (("day", day), ("twilight", twilight)):
        lessons = Lessons.load(folder, course.low, course.high)
        networks.append(taught(lessons, course, seed, lambda loss, name=name: report(name, loss)))  # type: ignore[misc]
        errors[name] = rms_error(networks[-1], lessons.chosen(lessons.held))
    save_rest(output, Rest(*networks), f"skydome.own_air.all_air: seed {seed}, {day}, {twilight}")
    return errors


def rms_error(network: RestNetwork, lessons: Cases) -> float:
    """Of the whole radiance over all nodes of all cases; ValueError where no case is left."""
    if not len(lessons.sines):
        raise ValueError("no air is held back: make more lessons")
    found = np.exp(network.coefficients(lessons.inputs(), lessons.sines)[:, 0] @ whole(network.shapes))
    return float(np.sqrt(np.mean(((found - lessons.rest) / (lessons.rest + lessons.once)) ** 2)))


def azimuth_waves(terms: int) -> np.ndarray:
    """From cosine coefficients to the lessons' azimuths, (terms, AZIMUTHS)."""
    return np.asarray(np.cos(np.outer(np.arange(terms), np.linspace(0, np.pi, AZIMUTHS))))


def whole(shapes: np.ndarray) -> np.ndarray:
    """Shapes (S, VIEWS, terms) at all nodes, (S, NODES)."""
    return np.asarray((shapes @ azimuth_waves(shapes.shape[-1])).reshape(len(shapes), NODES))


def mean_coefficients(sines: np.ndarray, places: tuple[float, float], count: int) -> np.ndarray:
    """How much of each of the shapes of mean air there is under suns of such sines (N,), (N, count)."""
    low, high = places
    x = np.clip((2 * np.asarray(place_of(sines)) - low - high) / (high - low), -1, 1)
    return np.asarray(cosine_series(x, count))


@dataclass(frozen=True, eq=False)
class Start:
    """What training sets out from: the range of places, shapes (S, VIEWS, terms), and the other shapes' coefficients
    to learn (N, shapes), scaled, with each one's weight.
    """

    places: tuple[float, float]
    shapes: np.ndarray
    wanted: np.ndarray
    weight: np.ndarray

    @classmethod
    def of(cls, lessons: Cases, course: Course) -> "Start":
        """By least squares and singular values of log rest, weighted by the rest's share of the light."""
        low, high = (float(np.float16(place_of(np.sin(np.radians(edge))))) for edge in (course.low, course.high))
        mean = mean_coefficients(lessons.sines, (low, high), course.mean_shapes)
        logs = np.log(lessons.rest.astype(np.float64))
        first = np.linalg.lstsq(mean, logs, rcond=None)[0]
        logs -= mean @ first
        share = np.sqrt((lessons.rest / (lessons.rest + lessons.once)).mean(axis=0))
        across = np.linalg.eigh((logs * share).T @ (logs * share))[1][:, ::-1][:, : course.shapes]
        found = (logs * share) @ across
        middle, size = found.mean(axis=0), found.std(axis=0) + 1e-12
        others = across.T / share
        first[0] += middle @ others
        shapes = np.concatenate([first, others * size[:, None]]).reshape(-1, VIEWS, AZIMUTHS)
        weight = (size / size.max()) ** 2 + 0.003
        series = shapes @ np.linalg.pinv(azimuth_waves(course.terms))
        return cls((low, high), series, (found - middle) / size, weight)


def taught(
    lessons: Cases, course: Course, seed: int = 0, report: Callable[[float], None] = lambda _: None
) -> RestNetwork:
    """The network of a course, trained on the lessons that are not held back."""
    torch = require_torch()
    lessons = lessons.chosen(~lessons.held)
    random, read = np.random.default_rng(seed), lessons.inputs()[:, 0]
    first = np.sort(random.choice(len(read), min(len(read), FIRST_CASES), replace=False))
    start = Start.of(lessons.chosen(first), course)
    middle, size = read.mean(axis=0), read.std(axis=0) + 1e-9
    torch.manual_seed(seed)
    net = layers(torch, read.shape[1], course)
    given = torch.tensor((read - middle) / size, dtype=torch.float32)
    learn_coefficients(torch, net, given[first], start, random, course.steps // 6)
    shapes = learn_light(torch, net, given, start, lessons, random, course, report)
    return RestNetwork(unscaled(net, middle, size), shapes, start.places)


def require_torch() -> Any:
    """The library, or ImportError in one line."""
    return required("torch", "test", "training the physical sky")


def layers(torch: Any, count: int, course: Course) -> Any:
    """A network of two hidden layers."""
    nn = torch.nn
    first, second = nn.Linear(count, course.width), nn.Linear(course.width, course.width)
    return nn.Sequential(first, nn.SiLU(), second, nn.SiLU(), nn.Linear(course.width, course.shapes))


def learn_coefficients(torch: Any, net: Any, given: Any, start: Start, random: np.random.Generator, steps: int) -> None:
    """The first sixth: coefficients alone."""
    wanted, weight = (torch.tensor(part, dtype=torch.float32) for part in (start.wanted, start.weight))
    optimiser = torch.optim.AdamW(net.parameters(), 3e-3, weight_decay=1e-3)
    pace = torch.optim.lr_scheduler.OneCycleLR(optimiser, 4e-3, total_steps=steps)
    for _ in range(steps):
        some = random.choice(len(given), 512)
        loss = ((net(given[some]) - wanted[some]) ** 2 * weight).mean()
        step(torch, net, loss, optimiser, pace)


def learn_light(
    torch: Any,
    net: Any,
    given: Any,
    start: Start,
    lessons: Cases,
    random: np.random.Generator,
    course: Course,
    report: Callable[[float], None],
) -> np.ndarray:
    """The rest of the steps: network and shapes, on the light of some nodes of some cases at a time; the shapes."""
    means = mean_coefficients(lessons.sines, start.places, course.mean_shapes)
    mean, waves = (torch.tensor(part, dtype=torch.float32) for part in (means, azimuth_waves(course.terms)))
    shapes = torch.nn.Parameter(torch.tensor(start.shapes, dtype=torch.float32))
    share = torch.tensor(lessons.rest / (lessons.rest + lessons.once), dtype=torch.float32)
    logs = torch.tensor(np.log(lessons.rest), dtype=torch.float32)
    steps = course.steps - course.steps // 6
    parts = [{"params": net.parameters(), "weight_decay": 1e-3}, {"params": [shapes], "weight_decay": 0.0}]
    optimiser = torch.optim.AdamW(parts, 2e-3)
    pace = torch.optim.lr_scheduler.OneCycleLR(optimiser, [3e-3, 1.5e-3], total_steps=steps, pct_start=0.1)
    for number in range(steps):
        some, nodes = random.choice(len(given), 256)[:, None], random.choice(NODES, NODES // 5, replace=False)
        at = (shapes[:, nodes // AZIMUTHS] * waves.T[nodes % AZIMUTHS]).sum(-1)
        found = torch.cat([mean[some[:, 0]], net(given[some[:, 0]])], 1) @ at
        off = torch.expm1((found - logs[some, nodes]).clamp(-3, 3)) * share[some, nodes]
        loss = (torch.sqrt(off * off + course.tamed**2) - course.tamed).mean()
        step(torch, net, loss, optimiser, pace)
        if number % 100 == 0:
            report(float(loss.detach()))
    return np.asarray(shapes.detach().numpy(), dtype=np.float64)


def step(torch: Any, net: Any, loss: Any, optimiser: Any, pace: Any) -> None:
    """One step down the gradient, the network's at most 1 long."""
    optimiser.zero_grad()
    loss.backward()
    torch.nn.utils.clip_grad_norm_(net.parameters(), 1.0)
    optimiser.step()
    pace.step()


def unscaled(net: Any, middle: np.ndarray, size: np.ndarray) -> tuple[tuple[np.ndarray, np.ndarray], ...]:
    """Weights (in, out) and biases of the layers, that read inputs as they are."""
    numbers = [part.detach().numpy().T.astype(np.float64) for part in net.parameters()]
    numbers[0] = numbers[0] / size[:, None]
    numbers[1] = numbers[1] - middle @ numbers[0]
    return tuple(zip(numbers[::2], numbers[1::2], strict=True))
