"""Directions in groups: two belong together where steps of no more than an angle lead from one to the other."""

import numpy as np

CHUNK = 2000


def linked(directions: np.ndarray, angle: float) -> np.ndarray:
    """Group number 0, 1, ... of each unit vector (N, 3), linked over steps of at most `angle` radians; shape (N,).

    >>> east, north = np.eye(3)[:2]
    >>> linked(np.stack([east, north, east]), 0.1).tolist()
    [0, 1, 0]
    """
    return joined(directions, np.arange(len(directions)), angle)


def linked_pixels(mask: np.ndarray, directions: np.ndarray, angle: float) -> np.ndarray:
    """Group number 1, 2, ... of each pixel of the mask (H, W) that looks along directions (H, W, 3); 0 elsewhere.

    Pixels that touch belong together; of the rest, patches whose edges come within `angle` radians.
    """
    from scipy.ndimage import binary_erosion, label

    touching = np.ones((3, 3))
    patches, count = label(mask, structure=touching)
    if count < 2:
        return np.asarray(patches)
    edge = mask & ~binary_erosion(mask, structure=touching)
    numbers = patches[edge] - 1
    groups = joined(directions[edge], numbers, angle)
    number_of = np.zeros(count + 1, dtype=np.intp)
    number_of[numbers + 1] = groups + 1
    return np.asarray(number_of[patches])


def joined(directions: np.ndarray, patches: np.ndarray, angle: float) -> np.ndarray:
    """Group number (N,) of directions (N, 3) that are in patches (N,) already, patches being joined across `angle`."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import cKDTree

    if not len(directions):
        return np.zeros(0, dtype=np.intp)
    tree, reach, count = cKDTree(directions), 2 * np.sin(angle / 2), int(patches.max()) + 1
    pairs = []
    for k in range(0, len(directions), CHUNK):
        near = cKDTree(directions[k : k + CHUNK]).sparse_distance_matrix(tree, reach, output_type="ndarray")
        both = patches[near["i"] + k] * count + patches[near["j"]]
        pairs.append(np.unique(both))
    both = np.unique(np.concatenate(pairs))
    graph = coo_array((np.ones(both.size), (both // count, both % count)), shape=(count, count))
    return np.asarray(connected_components(graph, directed=False)[1][patches], dtype=np.intp)
