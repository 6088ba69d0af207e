"""Light between the faces of a scene for a year: what each patch of the sky, the ground and any sun give every face."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from skydome.dome.patches import Patches
from skydome.surroundings.intervals import GROUND, SKY, Surroundings
from skydome.surroundings.light_kinds import LUX
from skydome.surroundings.patch_view import FEW_LOOKS, PatchView, looks_into


class Enclosure(Surroundings):
    """Surroundings with faces that light each other."""

    @abstractmethod
    def within(self) -> "Scene":
        """The scene that it is a point of, one for all its points."""

    @abstractmethod
    def shown(self, labels: np.ndarray) -> np.ndarray:
        """Which of the faces that are met (K,) show the side that reflects, booleans (K,)."""


@dataclass(frozen=True, eq=False)
class Faces:
    """F diffuse faces: `places` (F lists of S points that look around), `normals` (F, 3), `reflectance` (F,), below 1.

    `factors` (F, F), from row to column, if they are known in closed form; else they are looked at. Around them lies
    open ground of `ground_albedo`.
    """

    places: Sequence[Sequence[Enclosure]]
    normals: np.ndarray
    reflectance: np.ndarray
    factors: np.ndarray | None = None
    ground_albedo: float = 0.0


class Scene(ABC):
    """A thing with faces, of which points in it are `Enclosure`s."""

    @abstractmethod
    def lit_faces(self) -> Faces:
        """The faces, ready to look around. ValueError where their reflectance is a spectrum."""


@dataclass(frozen=True, eq=False)
class FaceLight:
    """Illuminance of every face, all interreflection in it, per unit of what lights them.

    `sky` (F, N), sr: per luminance of each patch; `ground` (F,), sr: per luminance of the open ground; `exchange`
    (F, F): per illuminance that arrives directly.
    """

    faces: Faces
    sky: np.ndarray
    ground: np.ndarray
    exchange: np.ndarray

    @classmethod
    def of(cls, faces: Faces, cut: Patches, looks: int = FEW_LOOKS) -> "FaceLight":
        """The coefficients by about `looks` looks from each point of each face into each half of the world."""
        every, count = looks_into(cut, looks), len(faces.reflectance)
        sky, ground, factors = np.zeros((count, cut.count)), np.zeros(count), np.zeros((count, count))
        for k, (points, normal) in enumerate(zip(faces.places, faces.normals, strict=True)):
            for point in points:
                view = PatchView.of(point, normal, every)
                sky[k] += view.weights / len(points)
                ground[k] += view.factor_of(GROUND) / len(points)
                met, factor = met_faces(view, point)
                factors[k, met] += factor / (np.pi * len(points))
        known = factors if faces.factors is None else faces.factors
        exchange = np.linalg.inv(np.eye(count) - known * faces.reflectance)
        return cls(faces, exchange @ sky, exchange @ ground, exchange)

    def of_suns(self, suns: np.ndarray) -> np.ndarray:
        """The same per normal illuminance of suns (T, 3), taken as points: (T, F)."""
        direct = np.zeros((len(suns), len(self.faces.reflectance)))
        for k, (points, normal) in enumerate(zip(self.faces.places, self.faces.normals, strict=True)):
            facing = np.flatnonzero(suns @ normal > 0)
            free = sum((point.seen(suns[facing]) == SKY).astype(np.float64) for point in points) / len(points)
            direct[facing, k] = free * (suns[facing] @ normal)
        arriving: np.ndarray = direct @ self.exchange.T
        return arriving

    @cached_property
    def leaving(self) -> np.ndarray:
        """Luminance of each face per its illuminance, 1 / sr, (F,)."""
        shares: np.ndarray = self.faces.reflectance / np.pi
        return shares


def met_faces(view: PatchView, place: Enclosure) -> tuple[np.ndarray, np.ndarray]:
    """The faces that a view meets from the side that reflects (K,), and the factor of each (K,)."""
    faces = view.labels >= 0
    faces[faces] = place.shown(view.labels[faces])
    return view.labels[faces], view.factors[faces]


def plain(reflectance: Any) -> np.ndarray:
    """A reflectance that is a number, or one of each face (F,); ValueError for one in colour.

    >>> plain(0.2).tolist()
    0.2
    """
    numbers = LUX.shares(reflectance)
    if numbers.ndim > 1:
        raise ValueError(f"a year of light needs one reflectance of each face, got shape {numbers.shape}")
    return numbers
