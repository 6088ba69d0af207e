"""Rays in a scene of triangles, cast by Embree."""

from typing import Any

import numpy as np

from skydome.ground.extras import required

BLOCK = 400_000
"""Rays that are cast at once."""


def trimesh_library() -> Any:
    """The trimesh module; ImportError where it or Embree is missing."""
    required("embreex", "scene", "a scene of triangles")
    return required("trimesh", "scene", "a scene of triangles")


def ray_caster(vertices: np.ndarray, faces: np.ndarray) -> Any:
    """A function (origins (K, 3), directions (K, 3)) -> number of the triangle met first or -1, (K,); Embree's rays."""
    trimesh = trimesh_library()
    from trimesh.ray.ray_pyembree import RayMeshIntersector

    tracer = RayMeshIntersector(trimesh.Trimesh(vertices, faces, process=False), scale_to_box=False)

    def first_met(origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        blocks = range(0, len(origins), BLOCK)
        met = [tracer.intersects_first(origins[b : b + BLOCK], directions[b : b + BLOCK]) for b in blocks]
        return np.concatenate(met) if met else np.zeros(0, dtype=np.int64)

    return first_met
