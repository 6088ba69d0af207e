"""What a plane receives per unit of each light of a year: of each patch's luminance, of the sun, of the ground."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from skydome.dome.patches import Patches
from skydome.surroundings.faces import Enclosure, FaceLight, Scene, met_faces
from skydome.surroundings.intervals import GROUND
from skydome.surroundings.obstruction import share_of_disc
from skydome.surroundings.patch_view import LOOKS, PatchView, looks_into
from skydome.years.planes.plane import Plane


@dataclass(frozen=True, eq=False)
class PlaneCoefficients:
    """Light on one plane: `view.weights` (N,) and `reflected` (N,), sr, per luminance of each patch; `ground`, 1.

    `ground` is the light per global horizontal light in the open, by way of the ground and of the faces that it lights.
    `faces` (F,) is the light per illuminance of each face of the scene, none in the open.
    """

    view: PatchView
    reflected: np.ndarray
    ground: float
    faces: np.ndarray

    def of_suns(self, suns: np.ndarray, radii: np.ndarray) -> np.ndarray:
        """Direct light per normal light of suns (T, 3) of angular `radii` (T,): cosine times the share not hidden."""
        cosine: np.ndarray = np.maximum(suns @ self.view.normal, 0)
        if self.view.surroundings.hides:
            rows = np.flatnonzero(cosine > 0)
            cosine[rows] *= share_of_disc(suns[rows], radii[rows], self.view.surroundings)
        return cosine


@dataclass(frozen=True, eq=False)
class Coefficients:
    """Those of P planes, and the light of the scenes that they stand in, by scene."""

    planes: list[PlaneCoefficients]
    scenes: "dict[Scene, FaceLight]"

    @classmethod
    def of(cls, planes: Sequence[Plane], cut: Patches, albedo: float, looks: int = LOOKS) -> "Coefficients":
        """Found by looking around once: from each plane, and from the faces of each scene."""
        every = looks_into(cut, looks)
        scenes: dict[Scene, FaceLight] = {}
        found = []
        for plane in planes:
            view, around = PatchView.of(plane.surroundings, plane.normal, every), plane.surroundings
            if not isinstance(around, Enclosure):
                open_ground = albedo / np.pi * float(view.factors.sum())
                found.append(PlaneCoefficients(view, np.zeros(cut.count), open_ground, np.zeros(0)))
                continue
            scene = around.within()
            if scene not in scenes:
                scenes[scene] = FaceLight.of(scene.lit_faces(), cut)
            found.append(enclosed(view, around, scenes[scene]))
        return cls(found, scenes)

    @property
    def weights(self) -> np.ndarray:
        """What each plane sees of each patch, sr, (N, P)."""
        return np.stack([plane.view.weights for plane in self.planes], axis=-1)

    @property
    def reflected(self) -> np.ndarray:
        """What it receives of it by way of faces, sr, (N, P)."""
        return np.stack([plane.reflected for plane in self.planes], axis=-1)

    @property
    def ground(self) -> np.ndarray:
        """Light per global horizontal light, by way of the ground, (P,)."""
        return np.array([plane.ground for plane in self.planes])

    def of_suns(self, suns: np.ndarray, radii: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Light per normal light of suns (T, 3), directly and by way of faces, (T, P) each."""
        direct = np.stack([plane.of_suns(suns, radii) for plane in self.planes], axis=-1)
        lit = {scene: light.of_suns(suns) for scene, light in self.scenes.items()}
        by_faces = np.zeros_like(direct)
        for k, plane in enumerate(self.planes):
            around = plane.view.surroundings
            if isinstance(around, Enclosure):
                by_faces[:, k] = lit[around.within()] @ plane.faces
        return direct, by_faces


def enclosed(view: PatchView, place: Enclosure, light: FaceLight) -> PlaneCoefficients:
    """The coefficients of a plane in a scene, from the light of its faces."""
    met, factor = met_faces(view, place)
    faces = np.zeros(len(light.leaving))
    faces[met] = factor * light.leaving[met]
    ground = (view.factor_of(GROUND) + float(faces @ light.ground)) * light.faces.ground_albedo / np.pi
    return PlaneCoefficients(view, faces @ light.sky, ground, faces)
