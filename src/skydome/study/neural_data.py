"""Samples of a sky model for networks to learn: as the paper drew them, and richer ones."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.ground.directions import direction
from skydome.skies.network import conditions, features
from skydome.skies.sky import Sky
from skydome.study.levenberg_marquardt import Samples

LEAST_ELEVATION = 1e-6  # the models call a sun at or below 0 night; the paper's zenith of 90 degrees is meant by day


class Teacher(ABC):
    """A sky model with the turbidities that its networks learn."""

    name: str
    turbidities: tuple[float, float]
    bands: tuple[float, ...] = ()

    @abstractmethod
    def light(self, directions: np.ndarray, sun: np.ndarray, turbidity: Any, albedo: Any) -> np.ndarray:
        """Linear sRGB (cd m-2), or spectral radiance in the bands, shape (..., outputs)."""


class PreethamTeacher(Teacher):
    """Preetham's sky, turbidity 2-6."""

    name, turbidities = "preetham", (2.0, 6.0)

    def light(self, directions: np.ndarray, sun: np.ndarray, turbidity: Any, albedo: Any) -> np.ndarray:
        """Linear sRGB, cut off at 0."""
        from skydome.skies.preetham import Preetham

        return np.maximum(Preetham(sun, turbidity).rgb(directions), 0.0)


class HosekWilkieTeacher(Teacher):
    """Hosek and Wilkie's sky in its RGB form, turbidity 1-10; the paper's albedo is 0.5."""

    name, turbidities = "hosek-wilkie", (1.0, 10.0)

    def light(self, directions: np.ndarray, sun: np.ndarray, turbidity: Any, albedo: Any) -> np.ndarray:
        """Linear sRGB."""
        from skydome.skies.hosek_wilkie import HosekWilkieRGB

        return HosekWilkieRGB(sun, turbidity, albedo).rgb(directions)


class HosekWilkieSpectralTeacher(Teacher):
    """Hosek and Wilkie's sky in its 11 bands, turbidity 1-10, any albedo."""

    name, turbidities = "hosek-wilkie-spectral", (1.0, 10.0)
    bands = tuple(float(w) for w in range(320, 721, 40))

    def light(self, directions: np.ndarray, sun: np.ndarray, turbidity: Any, albedo: Any) -> np.ndarray:
        """Spectral radiance, W m-2 sr-1 nm-1."""
        from skydome.skies.hosek_wilkie import HosekWilkie

        return HosekWilkie(sun, turbidity, albedo).radiance(directions, self.bands)


TEACHERS: dict[str, Teacher] = {
    teacher.name: teacher for teacher in (PreethamTeacher(), HosekWilkieTeacher(), HosekWilkieSpectralTeacher())
}


@dataclass(frozen=True, eq=False)
class Lesson:
    """Conditions (C, 1, ...) and directions (C, D, 3), with the teacher's light (C, D, outputs)."""

    sun: np.ndarray
    turbidity: np.ndarray
    albedo: np.ndarray
    directions: np.ndarray
    light: np.ndarray

    def samples(self, names: tuple[str, ...], scale: float) -> Samples:
        """Inputs by name, and light over `scale`, flat."""
        inputs = features(names, conditions(self.directions, self.sun, self.turbidity, self.albedo))
        inputs = np.broadcast_to(inputs, (*self.light.shape[:2], len(names)))
        return Samples(inputs.reshape(-1, len(names)), self.light.reshape(-1, self.light.shape[-1]) / scale)


def lesson(
    teacher: Teacher, elevation: np.ndarray, turbidity: np.ndarray, albedo: np.ndarray, directions: np.ndarray
) -> Lesson:
    """A lesson at conditions (C,), with directions (C, D, 3); the sun stands at azimuth 0."""
    sun = direction(np.zeros_like(elevation), np.maximum(elevation, LEAST_ELEVATION))[:, None, :]
    turbidity, albedo = turbidity[:, None], albedo[:, None]
    return Lesson(sun, turbidity, albedo, directions, teacher.light(directions, sun, turbidity, albedo))


def stratified(rng: np.random.Generator, rings: int, columns: int, count: int) -> np.ndarray:
    """Directions (count, rings x columns, 3), one at random in each cell of equal zenith angle and azimuth."""
    zenith = (np.arange(rings)[:, None] + rng.random((count, rings, columns))) * (np.pi / 2 / rings)
    azimuth = (np.arange(columns) + rng.random((count, rings, columns))) * (2 * np.pi / columns)
    return direction(azimuth, np.pi / 2 - zenith).reshape(count, -1, 3)


def published_lesson(teacher: Teacher, seed: int, albedo: float = 0.5) -> Lesson:
    """The paper's data: whole turbidities, 20 sun zeniths from 0 to 90 degrees, 10 x 20 stratified views."""
    rng = np.random.default_rng(seed)
    low, high = teacher.turbidities
    turbidity, elevation = np.meshgrid(np.arange(low, high + 1), np.linspace(np.pi / 2, 0, 20), indexing="ij")
    count = turbidity.size
    views = stratified(rng, 10, 20, count)
    return lesson(teacher, elevation.ravel(), turbidity.ravel(), np.full(count, albedo), views)


def rich_lesson(teacher: Teacher, seed: int, count: int = 800, views: int = 60, albedo: float | None = 0.5) -> Lesson:
    """Random conditions: any turbidity, 5 % of suns on the horizon, a fifth of the views near the sun.

    `albedo` None draws it from 0 to 1. Low suns are drawn more often (elevation = 90 deg x uniform^1.5).
    """
    rng = np.random.default_rng(seed)
    turbidity = rng.uniform(*teacher.turbidities, count)
    elevation = np.pi / 2 * rng.random(count) ** 1.5
    elevation[rng.random(count) < 0.05] = 0.0
    reflect = rng.random(count) if albedo is None else np.full(count, albedo)
    spread = direction(rng.uniform(0, 2 * np.pi, (count, views)), np.arcsin(rng.random((count, views))))
    sun = direction(np.zeros(count), elevation)[:, None, :]
    near = sun + rng.normal(size=(count, views, 3)) * rng.uniform(0.02, 0.3, (count, views, 1))
    chosen = np.where(rng.random((count, views, 1)) < 0.2, near, spread)
    chosen[..., 2] = np.abs(chosen[..., 2])
    chosen /= np.linalg.norm(chosen, axis=-1, keepdims=True)
    return lesson(teacher, elevation, turbidity, reflect, chosen)


def held_out(teacher: Teacher, seed: int = 99, views: int = 800, albedo: float = 0.5) -> Lesson:
    """The paper's test: half turbidities, 7 sun zeniths from 0 to 90 degrees, fresh views even in solid angle."""
    rng = np.random.default_rng(seed)
    low, high = teacher.turbidities
    turbidity, elevation = np.meshgrid(np.arange(low + 0.5, high), np.linspace(np.pi / 2, 0, 7), indexing="ij")
    count = turbidity.size
    spread = direction(rng.uniform(0, 2 * np.pi, (count, views)), np.arcsin(rng.random((count, views))))
    return lesson(teacher, elevation.ravel(), turbidity.ravel(), np.full(count, albedo), spread)


def sky_of(teacher: Teacher, sun: np.ndarray, turbidity: float, albedo: float) -> Sky:
    """The teacher's sky itself."""
    from skydome.skies.hosek_wilkie import HosekWilkie, HosekWilkieRGB
    from skydome.skies.preetham import Preetham

    if teacher.name == "preetham":
        return Preetham(sun, turbidity)
    return (HosekWilkie if teacher.bands else HosekWilkieRGB)(sun, turbidity, albedo)
