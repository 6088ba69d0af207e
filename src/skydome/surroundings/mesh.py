"""Light in a scene of triangles: what each point sees by ray casting, and interreflection between the triangles."""

from dataclasses import dataclass, field
from functools import cached_property
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arguments import numbers, require_file
from skydome.ground.arrays import Array, constant
from skydome.ground.directions import ZENITH, checked_directions
from skydome.light.spectrum import Spectrum
from skydome.skies.labelled import outer_labels
from skydome.skies.sky import Sky
from skydome.surroundings.channels import BELOW_ONE, channelled, check_shares, points_and_channels, side_by_side
from skydome.surroundings.faces import Enclosure, Faces, Scene, plain
from skydome.surroundings.intervals import GROUND, SKY
from skydome.surroundings.light_kinds import LUX, LightKind
from skydome.surroundings.obstruction import TOLERANCE, PlaneView, Received
from skydome.surroundings.radiosity import interreflected, interreflected_channels
from skydome.surroundings.rays import ray_caster, trimesh_library

LIFT = 2e-6
"""How far rays start above a surface, in diagonals of the scene: some 30 roundings of the rays' 32 bit."""

INNER = np.array([[4, 1, 1], [1, 4, 1], [1, 1, 4]]) / 6
"""Three points of a triangle in barycentric coordinates, of equal weight: exact for quadratics."""

FACE_BANDS, FACE_TOLERANCE = 24, 2e-3
"""How finely the triangles themselves look around for their own illuminance."""


@dataclass(frozen=True, eq=False)
class MeshScene(Scene):
    """Triangles (`vertices` (V, 3) m, `faces` (N, 3)) under the sky; x east, y north, z up.

    Fronts reflect, backs are black. `reflectance` (N,) or a number in [0, 1): each triangle has one illuminance, so
    cut large ones (`finer`); for light in colour (N, C), or a `Spectrum` of all or of each. Where no triangle is met
    below the horizon lies open ground of `ground_albedo`, a number, (C,) or a `Spectrum`. Needs
    trimesh and embreex: pip install "skydome[scene]". ValueError for no triangles, one without area, or a
    reflectance outside.

    >>> wall = MeshScene([[-9, 5, 0], [9, 5, 0], [9, 5, 6], [-9, 5, 6]], [[0, 1, 2], [0, 2, 3]], reflectance=0.5)
    >>> import skydome as sd
    >>> seen = wall.at((0, 0, 0)).seen(np.array([sd.NORTH, sd.SOUTH, sd.ZENITH]))
    >>> bool(seen[0] >= 0), seen[1:].tolist()
    (True, [-1, -1])
    """

    vertices: Any
    faces: Any
    reflectance: Any = 0.0
    ground_albedo: Any = 0.0
    casts: Any = field(init=False, repr=False)

    def __post_init__(self) -> None:
        vertices, faces = numbers(self.vertices, "vertices"), np.asarray(self.faces)
        if vertices.ndim != 2 or vertices.shape[1] != 3 or faces.ndim != 2 or faces.shape[1] != 3 or not len(faces):
            raise ValueError(
                f"vertices must be (V, 3) and faces (N, 3), N >= 1, got {vertices.shape} and {faces.shape}"
            )
        if not np.isfinite(vertices).all():
            raise ValueError("vertices must be finite, got NaN or infinity")
        if faces.dtype.kind not in "iu" or faces.min() < 0 or faces.max() >= len(vertices):
            raise ValueError(f"faces must be whole numbers in [0, {len(vertices)}), got {faces.min()} to {faces.max()}")
        check_shares("reflectance", self.reflectance, BELOW_ONE)
        check_shares("ground_albedo", self.ground_albedo)
        reflectance = of_faces(self.reflectance, len(faces))
        for name, value in (("vertices", vertices), ("faces", faces), ("reflectance", reflectance)):
            object.__setattr__(self, name, value)
        if (self.areas <= 0).any():
            raise ValueError(f"every triangle must have an area, got none in triangle {int(np.argmin(self.areas))}")
        object.__setattr__(self, "casts", ray_caster(vertices, faces))

    @classmethod
    def read(cls, path: "str | PathLike[str]", reflectance: ArrayLike | Spectrum = 0.2, **others: Any) -> "MeshScene":
        """The scene in a file that trimesh reads (OBJ, PLY, STL, glTF), z up, metres."""
        mesh = trimesh_library().load(require_file(path, "a mesh"), force="mesh", process=False)
        return cls(mesh.vertices, mesh.faces, reflectance, **others)

    def finer(self, longest: float) -> "MeshScene":
        """The same scene with no triangle's edge longer than `longest`, m."""
        subdivide: Any = trimesh_library().remesh.subdivide_to_size
        vertices, faces, origin = subdivide(self.vertices, self.faces, longest, max_iter=20, return_index=True)
        reflectance = self.reflectance
        if isinstance(reflectance, Spectrum):
            every = reflectance.values.ndim == 2
            reflectance = Spectrum(reflectance.wavelengths, reflectance.values[origin]) if every else reflectance
        else:
            reflectance = reflectance[origin]
        return MeshScene(vertices, faces, reflectance, self.ground_albedo)

    @cached_property
    def triangles(self) -> np.ndarray:
        """Corners, m, (N, 3, 3)."""
        corners: np.ndarray = self.vertices[self.faces]
        return corners

    @cached_property
    def crosses(self) -> np.ndarray:
        """Normals of twice the area's length, (N, 3)."""
        t = self.triangles
        return np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0])

    @cached_property
    def areas(self) -> np.ndarray:
        """Area of each triangle, m^2, (N,)."""
        sizes: np.ndarray = np.linalg.norm(self.crosses, axis=1) / 2
        return sizes

    @cached_property
    def normals(self) -> np.ndarray:
        """Unit normals of the fronts, (N, 3): corners run anticlockwise as seen from there."""
        fronts: np.ndarray = self.crosses / (2 * self.areas[:, None])
        return fronts

    @cached_property
    def lift(self) -> float:
        """How far rays start above a surface, m."""
        return float(LIFT * np.linalg.norm(np.ptp(self.vertices, axis=0)))

    def at(self, point: Array, normal: Array = ZENITH) -> "MeshPoint":
        """What is seen from a point (3,), m, just in front of a surface that faces `normal` (3,)."""
        place = np.asarray(point, dtype=np.float64)
        if place.shape != (3,) or not np.isfinite(place).all():
            raise ValueError(f"the point must be 3 finite numbers, m, got {point}")
        return MeshPoint(self, place + self.lift * np.asarray(checked_directions(normal, "normal")))

    @cached_property
    def face_views(self) -> list[list[PlaneView]]:
        """The views of 3 points of every triangle: (N) lists of 3. Found once, for any number of skies."""
        corners = INNER @ self.triangles
        return [
            [self.view(point, normal, FACE_BANDS, FACE_TOLERANCE) for point in points]
            for points, normal in zip(corners, self.normals, strict=True)
        ]

    @cached_property
    def factors(self) -> np.ndarray:
        """Form factors between the triangles, what hides them accounted for, (N, N), row: from.

        By the bands' closed form (15.54): each row, with its sky and open ground, adds up to 1. Backs count 0.
        """
        factors = np.zeros((len(self.faces), len(self.faces)))
        for row, (views, points) in enumerate(zip(self.face_views, INNER @ self.triangles, strict=True)):
            for view, point in zip(views, points, strict=True):
                met = view.labels[view.labels >= 0]
                front = ((point - self.triangles[met, 0]) * self.normals[met]).sum(axis=1) > 0
                factors[row, met] += front * view.factors[view.labels >= 0] / (np.pi * len(INNER))
        return factors

    def lit_faces(self) -> Faces:
        """The triangles, for `FaceLight`, with three points each. ValueError for reflectances in colour."""
        corners = INNER @ self.triangles
        places = [[self.at(point, n) for point in points] for points, n in zip(corners, self.normals, strict=True)]
        return Faces(places, self.normals, plain(self.reflectances()), None, float(plain(self.ground_albedo)))

    def view(self, point: ArrayLike, normal: ArrayLike, bands: int = 64, tolerance: float = TOLERANCE) -> PlaneView:
        """The view from a point (3,) of a surface that faces `normal` (3,)."""
        return PlaneView.of(self.at(point, normal), normal, bands, tolerance)

    def lit(self, sky: Sky, light: LightKind = LUX) -> Array:
        """Illuminance of every triangle with interreflection, lx, (..., N); in another kind of `light` (..., N, C)."""
        ground = {GROUND: self.ground_luminance(sky, light)}
        direct = [
            sum(view.receive(sky, ground, light=light).total for view in views) / len(views)
            for views in self.face_views
        ]
        balance = interreflected_channels if light.trailing else interreflected
        return balance(side_by_side(direct, light), self.factors, self.reflectances(light))

    def reflectances(self, light: LightKind = LUX) -> np.ndarray:
        """Reflectance of every triangle, (N,), or (N, C) by channel."""
        return channelled(self.reflectance, light, len(self.faces))

    def ground_luminance(self, sky: Sky, light: LightKind = LUX) -> Array:
        """Luminance of the open ground around the scene, cd m-2, (...,) or (..., C)."""
        falling = light.on_level(sky)
        return falling * constant(channelled(self.ground_albedo, light) / np.pi, falling)

    @outer_labels("", points_and_channels)
    def illuminance(
        self, sky: Sky, points: ArrayLike, normals: ArrayLike = ZENITH, bands: int = 64, light: LightKind = LUX
    ) -> Received:
        """Light at points (P, 3), m, on planes facing `normals` (P, 3) or (3,), lx, (..., P): sky, sun, reflected.

        In another kind of `light` (..., P, C).
        """
        places = np.atleast_2d(np.asarray(points, dtype=np.float64))
        facing = np.broadcast_to(checked_directions(normals, "normals"), places.shape)
        luminances: dict[int, Any] = {GROUND: self.ground_luminance(sky, light)}
        reflectances = self.reflectances(light)
        if reflectances.any():
            lit = self.lit(sky, light)
            luminances |= {
                k: light.pick(lit, k) * constant(np.asarray(rho) / np.pi, lit) for k, rho in enumerate(reflectances)
            }
        found = [
            self.view(p, n, bands).receive(sky, luminances, light=light) for p, n in zip(places, facing, strict=True)
        ]
        return Received(
            *(side_by_side([getattr(one, name) for one in found], light) for name in ("sky", "sun", "reflected"))
        )


def of_faces(reflectance: ArrayLike | Spectrum, count: int) -> Any:
    """A reflectance as it is kept: a `Spectrum`, or numbers (N,) or (N, C); ValueError where the faces do not fit."""
    if isinstance(reflectance, Spectrum):
        if reflectance.values.ndim == 2 and len(reflectance.values) != count:
            raise ValueError(
                f"reflectance must have a spectrum of each of {count} faces, got {len(reflectance.values)}"
            )
        return reflectance
    numbers = np.asarray(reflectance, dtype=np.float64)
    if numbers.shape not in ((), (count,)) and (numbers.ndim != 2 or len(numbers) != count):
        raise ValueError(f"reflectance must be a number, (N,) or (N, C) with N = {count}, got {numbers.shape}")
    return np.broadcast_to(numbers, (count, *numbers.shape[1:]))


@dataclass(frozen=True, eq=False)
class MeshPoint(Enclosure):
    """A point, m, in a scene of triangles."""

    scene: MeshScene
    origin: np.ndarray

    def within(self) -> MeshScene:
        """The scene."""
        return self.scene

    def shown(self, labels: np.ndarray) -> np.ndarray:
        """Those whose corners run anticlockwise as seen from here."""
        toward = self.origin - self.scene.triangles[labels, 0]
        front: np.ndarray = (toward * self.scene.normals[labels]).sum(axis=1) > 0
        return front

    def seen(self, directions: np.ndarray) -> np.ndarray:
        """The triangle met toward each direction, else SKY or, below the horizon, GROUND."""
        flat = np.ascontiguousarray(directions.reshape(-1, 3))
        met = self.scene.casts(np.broadcast_to(self.origin, flat.shape), flat)
        beyond = np.where(flat[:, 2] >= 0, SKY, GROUND)
        return np.where(met >= 0, met, beyond).reshape(directions.shape[:-1])
