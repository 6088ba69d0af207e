"""Samples of a sky model for networks to learn: as the paper drew them, and richer ones."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.ground.directions import direction
from skydome.ground.extras import required
from skydome.skies.catalogue import CATALOGUE
from skydome.skies.model import Model
from skydome.skies.neural.network import conditions, features
from skydome.training.levenberg_marquardt import Examples

JUST_UP = 1e-6  # the models call a sun at or below 0 night; the paper's zenith of 90 degrees is meant by day


@dataclass(frozen=True)
class Teacher:
    """A model of the catalogue that networks learn, with the turbidities of its range."""

    model: Model

    @property
    def name(self) -> str:
        """The name of its lesson."""
        return self.model.lesson

    @property
    def turbidities(self) -> tuple[float, float]:
        """Least and most."""
        span = self.model.kind.ranges["turbidity"]
        return span.low, span.high

    @property
    def bands(self) -> tuple[float, ...]:
        """Wavelengths, nm, of spectral lessons; none where RGB is learned."""
        return self.model.lesson_bands

    def light(self, directions: np.ndarray, sun: np.ndarray, turbidity: Any, albedo: Any) -> np.ndarray:
        """Linear sRGB (cd m-2), or spectral radiance in the bands, never negative, shape (..., outputs)."""
        ground = {"albedo": albedo} if "albedo" in self.model.takes else {}
        sky: Any = self.model.make(sun, {"turbidity": turbidity} | ground)
        light = sky.radiance(directions, self.bands) if self.bands else sky.rgb(directions)
        positive: np.ndarray = np.maximum(light, 0.0)
        return positive


TEACHERS: dict[str, Teacher] = {model.lesson: Teacher(model) for model in CATALOGUE if model.lesson}


@dataclass(frozen=True, eq=False)
class Lesson:
    """Conditions (C, 1, ...) and directions (C, D, 3), with the teacher's light (C, D, outputs)."""

    sun: np.ndarray
    turbidity: np.ndarray
    albedo: np.ndarray
    directions: np.ndarray
    light: np.ndarray

    def samples(self, names: tuple[str, ...], scale: float) -> Examples:
        """Inputs by name, and light over `scale`, flat."""
        inputs = features(names, conditions(self.directions, self.sun, self.turbidity, self.albedo))
        inputs = np.broadcast_to(inputs, (*self.light.shape[:2], len(names)))
        return Examples(inputs.reshape(-1, len(names)), self.light.reshape(-1, self.light.shape[-1]) / scale)


def lesson(
    teacher: Teacher, elevation: np.ndarray, turbidity: np.ndarray, albedo: np.ndarray, directions: np.ndarray
) -> Lesson:
    """A lesson at conditions (C,), with directions (C, D, 3); the sun stands at azimuth 0."""
    sun = direction(np.zeros_like(elevation), np.maximum(elevation, JUST_UP))[:, None, :]
    turbidity, albedo = turbidity[:, None], albedo[:, None]
    return Lesson(sun, turbidity, albedo, directions, teacher.light(directions, sun, turbidity, albedo))


def stratified(rng: np.random.Generator, rings: int, columns: int, count: int) -> np.ndarray:
    """Directions (count, rings x columns, 3), one at random in each cell of equal zenith angle and azimuth."""
    zenith = (np.arange(rings)[:, None] + rng.random((count, rings, columns))) * (np.pi / 2 / rings)
    azimuth = (np.arange(columns) + rng.random((count, rings, columns))) * (2 * np.pi / columns)
    views: np.ndarray = direction(azimuth, np.pi / 2 - zenith).reshape(count, -1, 3)
    return views


def published_lesson(teacher: Teacher, seed: int, albedo: float = 0.5) -> Lesson:
    """The paper's data: whole turbidities, 20 sun zeniths from 0 to 90 degrees, 10 x 20 stratified views."""
    rng = np.random.default_rng(seed)
    low, high = teacher.turbidities
    turbidity, elevation = np.meshgrid(np.arange(low, high + 1), np.linspace(np.pi / 2, 0, 20), indexing="ij")
    count = turbidity.size
    views = stratified(rng, 10, 20, count)
    return lesson(teacher, elevation.ravel(), turbidity.ravel(), np.full(count, albedo), views)


def dense_lesson(teacher: Teacher, seed: int, count: int = 1000) -> Lesson:
    """For the published network: any turbidity and sun, one sun in ten on the horizon, albedo 0.5.

    24 views are stratified in zenith angle as the paper's, 16 even in solid angle: 40,000 samples.
    """
    rng = np.random.default_rng(seed)
    turbidity, elevation = rng.uniform(*teacher.turbidities, count), np.pi / 2 * rng.random(count)
    elevation[: count // 10] = 0.0
    azimuth, height = rng.uniform(0, 2 * np.pi, (count, 16)), rng.random((count, 16))
    views = np.concatenate([stratified(rng, 4, 6, count), direction(azimuth, np.arcsin(height))], axis=1)
    return lesson(teacher, elevation, turbidity, np.full(count, 0.5), views)


def even_sequence(teacher: Teacher, seed: int, power: int = 14) -> Lesson:
    """For the published network: 2^power single views by Sobol's sequence, as the paper's test weighs them, albedo 0.5.

    Suns are even in zenith angle, with 1/14 of them in the zenith and 1/7 on the horizon. Turbidity is even but for its
    first and last half, where it thins out. A fifth of the views are even in zenith angle, the others in solid angle.
    """
    qmc = required("scipy.stats", "fit", "Sobol's sequence").qmc
    first, sun, azimuth, height, manner, second = qmc.Sobol(6, seed=seed).random_base2(power).T
    low, high = teacher.turbidities
    turbidity = low + (high - low - 0.5) * first + 0.5 * second
    zenith = np.pi / 2 * np.clip((sun - 1 / 14) / (1 - 1 / 14 - 1 / 7), 0, 1)
    elevation = np.where(manner < 0.2, np.pi / 2 * height, np.arcsin(height))
    views = direction(2 * np.pi * azimuth, elevation)[:, None, :]
    return lesson(teacher, np.pi / 2 - zenith, turbidity, np.full(len(sun), 0.5), views)


def spectral_lesson(teacher: Teacher, seed: int) -> Lesson:
    """For spectral networks: 120,000 samples of any turbidity and albedo, suns above 1.9 degrees."""
    return rich_lesson(teacher, seed, count=3000, views=40, albedo=None, lowest=0.033)


def rich_lesson(
    teacher: Teacher,
    seed: int,
    count: int = 800,
    views: int = 60,
    albedo: float | None = 0.5,
    lowest: float = 0.0,
) -> Lesson:
    """Random conditions: any turbidity, 5 % of suns at their lowest, a fifth of the views near the sun.

    `albedo` None draws it from 0 to 1. Low suns are drawn more often (elevation goes as uniform^1.5); radians.
    """
    rng = np.random.default_rng(seed)
    turbidity = rng.uniform(*teacher.turbidities, count)
    elevation = lowest + (np.pi / 2 - lowest) * rng.random(count) ** 1.5
    elevation[rng.random(count) < 0.05] = lowest
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
    turbidity, elevation = held_out_conditions(teacher)
    count = turbidity.size
    spread = direction(rng.uniform(0, 2 * np.pi, (count, views)), np.arcsin(rng.random((count, views))))
    return lesson(teacher, elevation, turbidity, np.full(count, albedo), spread)


def held_out_conditions(teacher: Teacher) -> tuple[np.ndarray, np.ndarray]:
    """Half turbidities and 7 sun elevations, radians, each with each, flat."""
    low, high = teacher.turbidities
    turbidity, elevation = np.meshgrid(np.arange(low + 0.5, high), np.linspace(np.pi / 2, 0, 7), indexing="ij")
    return turbidity.ravel(), elevation.ravel()


def held_out_by_zenith(teacher: Teacher, seed: int = 99, albedo: float = 0.5) -> Lesson:
    """The paper's test with its own manner of views: 20 x 40 stratified in zenith angle and azimuth."""
    turbidity, elevation = held_out_conditions(teacher)
    views = stratified(np.random.default_rng(seed), 20, 40, turbidity.size)
    return lesson(teacher, elevation, turbidity, np.full(turbidity.size, albedo), views)


def even_lesson(teacher: Teacher, seed: int = 99, count: int = 600, views: int = 100) -> Lesson:
    """A test even in turbidity, albedo, sun elevation from 2 to 90 degrees, and views in solid angle."""
    rng = np.random.default_rng(seed)
    turbidity, albedo = rng.uniform(*teacher.turbidities, count), rng.random(count)
    elevation = np.radians(rng.uniform(2, 90, count))
    spread = direction(rng.uniform(0, 2 * np.pi, (count, views)), np.arcsin(rng.random((count, views))))
    return lesson(teacher, elevation, turbidity, albedo, spread)


def teacher_named(name: str) -> Teacher:
    """The teacher by name; ValueError with the names there are."""
    if name not in TEACHERS:
        raise ValueError(f"model must be one of {', '.join(TEACHERS)}, got {name!r}")
    return TEACHERS[name]
