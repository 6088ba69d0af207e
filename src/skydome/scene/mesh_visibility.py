"""Light in a scene of triangles: what each point sees by ray casting, and interreflection between the triangles."""

from dataclasses import dataclass, field
from functools import cached_property
from os import PathLike
from typing import Any

import numpy as np

from skydome.dome.integrals import illuminance
from skydome.ground.arrays import Array, constant, namespace
from skydome.ground.directions import ZENITH, checked_directions
from skydome.scene.obstruction import TOLERANCE, PlaneView, Received
from skydome.scene.obstruction_intervals import GROUND, SKY, Surroundings
from skydome.scene.radiosity import interreflected
from skydome.skies.sky import Sky

LIFT = 2e-6
"""How far rays start above a surface, in diagonals of the scene: some 30 roundings of the rays' 32 bit."""

INNER = np.array([[4, 1, 1], [1, 4, 1], [1, 1, 4]]) / 6
"""Three points of a triangle in barycentric coordinates, of equal weight: exact for quadratics."""

FACE_BANDS, FACE_TOLERANCE = 24, 2e-3
"""How finely the triangles themselves look around for their own illuminance."""

BLOCK = 400_000


@dataclass(frozen=True, eq=False)
class MeshScene:
    """Triangles (`vertices` (V, 3) m, `faces` (N, 3)) under the sky; x east, y north, z up.

    Fronts reflect, backs are black. `reflectance` (N,) or a number in [0, 1): each triangle has one illuminance, so
    cut large ones (`finer`). Where no triangle is met below the horizon lies open ground of `ground_albedo`. Needs
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
    ground_albedo: float = 0.0
    casts: Any = field(init=False, repr=False)

    def __post_init__(self) -> None:
        vertices, faces = np.asarray(self.vertices, dtype=np.float64), np.asarray(self.faces)
        if vertices.ndim != 2 or vertices.shape[1] != 3 or faces.ndim != 2 or faces.shape[1] != 3 or not len(faces):
            raise ValueError(
                f"vertices must be (V, 3) and faces (N, 3), N >= 1, got {vertices.shape} and {faces.shape}"
            )
        if not np.isfinite(vertices).all():
            raise ValueError("vertices must be finite, got NaN or infinity")
        if faces.dtype.kind not in "iu" or faces.min() < 0 or faces.max() >= len(vertices):
            raise ValueError(f"faces must be whole numbers in [0, {len(vertices)}), got {faces.min()} to {faces.max()}")
        reflectance = np.broadcast_to(np.asarray(self.reflectance, dtype=np.float64), len(faces))
        if not ((reflectance >= 0) & (reflectance < 1)).all() or not 0 <= self.ground_albedo <= 1:
            raise ValueError("reflectance must lie in [0, 1) and ground_albedo in [0, 1]")
        for name, value in (("vertices", vertices), ("faces", faces), ("reflectance", reflectance)):
            object.__setattr__(self, name, value)
        if (self.areas <= 0).any():
            raise ValueError(f"every triangle must have an area, got none in triangle {int(np.argmin(self.areas))}")
        object.__setattr__(self, "casts", ray_caster(vertices, faces))

    @classmethod
    def read(cls, path: "str | PathLike[str]", reflectance: Any = 0.2, **others: Any) -> "MeshScene":
        """The scene in a file that trimesh reads (OBJ, PLY, STL, glTF), z up, metres."""
        mesh = trimesh_library().load(path, force="mesh", process=False)
        return cls(mesh.vertices, mesh.faces, reflectance, **others)

    def finer(self, longest: float) -> "MeshScene":
        """The same scene with no triangle's edge longer than `longest`, m."""
        subdivide: Any = trimesh_library().remesh.subdivide_to_size
        vertices, faces, origin = subdivide(self.vertices, self.faces, longest, max_iter=20, return_index=True)
        return MeshScene(vertices, faces, self.reflectance[origin], self.ground_albedo)

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

    def at(self, point: Any, normal: Any = ZENITH) -> "MeshPoint":
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

    def view(self, point: Any, normal: Any, bands: int = 64, tolerance: float = TOLERANCE) -> PlaneView:
        """The view from a point (3,) of a surface that faces `normal` (3,)."""
        return PlaneView.of(self.at(point, normal), normal, bands, tolerance)

    def lit(self, sky: Sky) -> Array:
        """Illuminance of every triangle with interreflection, lx, (..., N)."""
        ground = {GROUND: self.ground_luminance(sky)}
        direct = [sum(view.receive(sky, ground).total for view in views) / len(views) for views in self.face_views]
        return interreflected(stacked(direct), self.factors, self.reflectance)

    def ground_luminance(self, sky: Sky) -> Array:
        """Luminance of the open ground around the scene, cd m-2, (...,)."""
        return illuminance(sky) * (self.ground_albedo / np.pi)

    def illuminance(self, sky: Sky, points: Any, normals: Any = ZENITH, bands: int = 64) -> Received:
        """Light at points (P, 3), m, on planes facing `normals` (P, 3) or (3,), lx, (..., P): sky, sun, reflected."""
        places = np.atleast_2d(np.asarray(points, dtype=np.float64))
        facing = np.broadcast_to(checked_directions(normals, "normals"), places.shape)
        luminances: dict[int, Any] = {GROUND: self.ground_luminance(sky)}
        if self.reflectance.any():
            light = self.lit(sky)
            luminances |= {k: light[..., k] * (rho / np.pi) for k, rho in enumerate(self.reflectance)}
        found = [self.view(p, n, bands).receive(sky, luminances) for p, n in zip(places, facing, strict=True)]
        return Received(*(stacked([getattr(one, name) for one in found]) for name in ("sky", "sun", "reflected")))


def stacked(columns: list[Any]) -> Array:
    """Values of the same shape (...,) as one array (..., P)."""
    first = next((column for column in columns if hasattr(column, "dtype")), np.zeros(()))
    xp = namespace(first)
    shape = np.broadcast_shapes(*(np.shape(column) for column in columns))
    return xp.stack(
        [xp.broadcast_to(constant(c, first), shape) if not hasattr(c, "shape") else c for c in columns], axis=-1
    )


@dataclass(frozen=True, eq=False)
class MeshPoint(Surroundings):
    """A point, m, in a scene of triangles."""

    scene: MeshScene
    origin: np.ndarray

    def seen(self, directions: np.ndarray) -> np.ndarray:
        """The triangle met toward each direction, else SKY or, below the horizon, GROUND."""
        flat = np.ascontiguousarray(directions.reshape(-1, 3))
        met = self.scene.casts(np.broadcast_to(self.origin, flat.shape), flat)
        beyond = np.where(flat[:, 2] >= 0, SKY, GROUND)
        return np.where(met >= 0, met, beyond).reshape(directions.shape[:-1])


def trimesh_library() -> Any:
    """The trimesh module; ImportError that says how to get it."""
    try:
        import trimesh
    except ImportError as error:
        raise ImportError('scenes of triangles need trimesh and embreex: pip install "skydome[scene]"') from error
    return trimesh


def ray_caster(vertices: np.ndarray, faces: np.ndarray) -> Any:
    """A function (origins (K, 3), directions (K, 3)) -> number of the triangle met first or -1, (K,); Embree's rays."""
    trimesh = trimesh_library()
    try:
        from trimesh.ray.ray_pyembree import RayMeshIntersector
    except ImportError as error:
        raise ImportError('rays need embreex: pip install "skydome[scene]"') from error
    tracer = RayMeshIntersector(trimesh.Trimesh(vertices, faces, process=False), scale_to_box=False)

    def first_met(origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        blocks = range(0, len(origins), BLOCK)
        met = [tracer.intersects_first(origins[b : b + BLOCK], directions[b : b + BLOCK]) for b in blocks]
        return np.concatenate(met) if met else np.zeros(0, dtype=np.int64)

    return first_met
