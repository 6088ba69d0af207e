"""Shapes of the dome under cloud: singular values of the lessons' logarithms, then least squares by turns.

With the shapes known, the squared error of a case's light is a quadratic form of its coefficients, so that a network of
these is taught without the dome.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple, Self

import numpy as np

from skydome.own_air.all_air.lessons import AZIMUTHS, VIEWS
from skydome.own_air.all_air.training import NODES, Course, azimuth_waves, mean_coefficients, whole
from skydome.own_air.clouds.lessons import OvercastLessons, node_views
from skydome.skies.all_air.rest import place_of

EVEN = 0.25
"""How much each node counts by itself beside the solid angle about it."""
TURNS, RIDGE = 3, 1e-8
"""Turns of least squares, and what keeps them from dividing by nothing, over the forms' mean."""
BLOCK = 256


class Forms(NamedTuple):
    """Of cases (N,): the best coefficients (N, S), and the form (N, S, S) that makes squared errors of others."""

    best: np.ndarray
    form: np.ndarray


@dataclass(frozen=True, eq=False)
class CloudShapes:
    """A `table` of shapes (S, views, terms), the first `mean` of them those of mean air, over the sun's `places`."""

    table: np.ndarray
    mean: int
    places: tuple[float, float]

    @classmethod
    def of(cls, lessons: OvercastLessons, course: Course) -> "CloudShapes":
        """Those of a course that tell lessons best."""
        places = tuple(float(np.float16(place_of(np.sin(np.radians(edge))))) for edge in (course.low, course.high))
        found = cls.singular(lessons, course, (places[0], places[1]))
        for _ in range(TURNS):
            found = found.nearer(lessons, found.forms(lessons).best)
        return found

    @classmethod
    def singular(cls, lessons: OvercastLessons, course: Course, places: tuple[float, float]) -> "CloudShapes":
        """By singular values of log rest less what the glow has of it, weighted by the rest's share of the light."""
        mean = mean_coefficients(lessons.sines, places, course.mean_shapes)
        logs, glow, weight = np.log(lessons.rest.astype(np.float64)), lessons.glow, weights(lessons)
        first = np.linalg.lstsq(mean, logs, rcond=None)[0]
        logs -= mean @ first
        root, glows = np.sqrt(weight.mean(axis=0)), np.zeros((len(logs), 1))
        for _ in range(TURNS):
            rest = (logs - glows * glow) * root
            across = np.linalg.eigh(rest.T @ rest)[1][:, ::-1][:, : course.shapes]
            found, own = rest @ across, across.T / root
            left = (logs - found @ own) * glow * weight
            glows = (left.sum(axis=1) / ((weight * glow**2).sum(axis=1) + 1e-6))[:, None]
        size = found.std(axis=0) + 1e-12
        first[0] += found.mean(axis=0) @ own
        table = np.concatenate([first, own * size[:, None]])
        return cls(series(table, course.terms), course.mean_shapes, places)

    def left(self, lessons: OvercastLessons) -> np.ndarray:
        """Log rest less the shapes of mean air, (N, nodes)."""
        mean = mean_coefficients(lessons.sines, self.places, self.mean)
        return np.asarray(np.log(lessons.rest) - (mean @ whole(self.table)[: self.mean]).astype(np.float32))

    def forms(self, lessons: OvercastLessons) -> Forms:
        """Of the lessons, those of the glow last."""
        own, parts = whole(self.table)[self.mean :], []
        for some in in_blocks(lessons):
            shapes = np.concatenate([np.broadcast_to(own, (len(some.sines), *own.shape)), some.glow[:, None]], axis=1)
            weighted = shapes * weights(some)[:, None]
            form = weighted @ np.swapaxes(shapes, 1, 2)
            parts.append((form, (weighted @ self.left(some)[..., None])[..., 0]))
        form, right = (np.concatenate(part) for part in zip(*parts, strict=True))
        ridge = RIDGE * np.trace(form, axis1=1, axis2=2).mean() * np.eye(form.shape[-1])
        return Forms(np.linalg.solve(form + ridge, right[..., None])[..., 0], form)

    def nearer(self, lessons: OvercastLessons, coefficients: np.ndarray) -> Self:
        """Own shapes again, by least squares from the cases' coefficients (N, S)."""
        own, left = coefficients[:, :-1], self.left(lessons) - coefficients[:, -1:] * lessons.glow
        weight, count = weights(lessons), own.shape[1]
        pairs = (own[:, :, None] * own[:, None]).reshape(len(own), -1)
        form, right = (weight.T @ pairs).reshape(NODES, count, count), (weight * left).T @ own
        ridge = RIDGE * np.trace(form, axis1=1, axis2=2)[:, None, None] * np.eye(count)
        solved = np.linalg.solve(form + ridge, right[..., None])[..., 0].T
        return replace(self, table=np.concatenate([self.table[: self.mean], series(solved, self.table.shape[-1])]))


def weights(lessons: OvercastLessons) -> np.ndarray:
    """How much an error of log rest counts at each node, (N, nodes): the rest's share of the light, squared."""
    share = lessons.rest / (lessons.rest + lessons.once)
    return np.asarray(share.astype(np.float64) ** 2 * ((1 - EVEN) * solid_angles() + EVEN / NODES))


def solid_angles() -> np.ndarray:
    """Share of the dome about each node, (nodes,)."""
    height = np.gradient(node_views()[0].reshape(VIEWS, AZIMUTHS)[:, 0])
    turn = np.where(np.arange(AZIMUTHS) % (AZIMUTHS - 1) == 0, 0.5, 1.0)
    share = np.outer(height, turn).ravel()
    return np.asarray(share / share.sum())


def series(shapes: np.ndarray, terms: int) -> np.ndarray:
    """Shapes at the nodes (S, nodes) as cosine series in the azimuth, (S, views, terms)."""
    return np.asarray(shapes.reshape(-1, VIEWS, AZIMUTHS) @ np.linalg.pinv(azimuth_waves(terms)))


def in_blocks(lessons: OvercastLessons) -> Iterator[OvercastLessons]:
    """Some cases at a time."""
    for start in range(0, len(lessons.sines), BLOCK):
        yield lessons.chosen(np.arange(start, min(start + BLOCK, len(lessons.sines))))
