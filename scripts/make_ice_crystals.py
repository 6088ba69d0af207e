"""Make src/skydome/ground/data/ice_crystals.npz: how hexagonal prisms of ice turn light, by shape, roughness and index.

Rays of sunlight are followed through prisms that lie in any way (`skydome.air.clouds.crystals.tracing`). Kept are the
logarithm of the phase function of what leaves a prism without what goes straight on, at angles drawn out such that
halos of all indices stand at the same places, and what absorption adds to it (not at 300 nm, where there is none); what
goes straight on; what is absorbed. Eight minutes of one core; `python scripts/make_ice_crystals.py FOLDER` keeps what
is traced there and goes on where it was stopped.
"""

import sys
from pathlib import Path

import numpy as np

from skydome.air.clouds.crystals.halos import TRACED, true_angles
from skydome.air.clouds.crystals.prism import Prism
from skydome.air.clouds.crystals.tracing import BINS, Turned, turned

TARGET = Path(__file__).parents[1] / "src" / "skydome" / "ground" / "data" / "ice_crystals.npz"
ASPECTS = np.array([0.2, 0.5, 1.0, 2.0, 5.0])
"""Length over diameter."""
ROUGHNESSES = np.array([0.0, 0.01, 0.03, 0.1, 0.25])
RAYS = (1_000_000, 500_000, 500_000, 200_000, 200_000)
"""For each roughness."""
INDICES = np.array([1.227, 1.285, 1.335])
"""Of ice at 2500, 1700 and 300 nm."""
ABSORPTIONS = np.array([0.0, 0.01, 0.1, 0.5, 2.0])


def traced(aspect: float, index: float, which: int, folder: Path | None) -> Turned:
    """A case, from the folder where it is there."""
    file = None if folder is None else folder / f"{aspect:g}_{index:g}_{which}.npz"
    if file is not None and file.exists():
        kept = np.load(file)
        return Turned(kept["angles"], kept["straight"], kept["absorbed"], float(kept["area"]))
    found = turned(Prism(aspect), index, ABSORPTIONS, float(ROUGHNESSES[which]), RAYS[which])
    if file is not None:
        np.savez_compressed(file, **{name: getattr(found, name) for name in ("angles", "straight", "absorbed", "area")})
    return found


def means(power: np.ndarray, index: float) -> np.ndarray:
    """Mean light per steradian of power by even cells (A, BINS), about each angle of the table, (A, T)."""
    knots = TRACED.knots
    between = np.concatenate([[0.0], (knots[1:] + knots[:-1]) / 2, [180.0]])
    edges = np.radians(true_angles(between, index))
    whole = np.concatenate([np.zeros((len(power), 1)), np.cumsum(power, axis=1)], axis=1)
    at = np.linspace(0, np.pi, BINS + 1)
    sums = np.stack([np.interp(edges, at, row) for row in whole])
    return np.diff(sums, axis=1) / (-2 * np.pi * np.diff(np.cos(edges)))


def stored(logarithms: np.ndarray) -> np.ndarray:
    """Logarithms (..., T) in hundredths, as steps from angle to angle."""
    return np.diff(np.rint(100 * logarithms), axis=-1, prepend=0.0).astype(np.int16)


def main(folder: Path | None) -> None:
    """Trace every case and write the table."""
    shape = (ASPECTS.size, ROUGHNESSES.size, INDICES.size, ABSORPTIONS.size)
    phases, straight, absorbed = np.zeros((*shape, TRACED.knots.size)), np.zeros(shape), np.zeros(shape)
    for i, aspect in enumerate(ASPECTS):
        for j in range(ROUGHNESSES.size):
            for k, index in enumerate(INDICES):
                found = traced(float(aspect), float(index), j, folder)
                phases[i, j, k] = means(found.angles, index)
                straight[i, j, k], absorbed[i, j, k] = found.straight, found.absorbed
                print(aspect, ROUGHNESSES[j], index, found.mean_cosine.round(4), found.absorbed.round(4), flush=True)
    logarithms = np.log(np.maximum(phases, 1e-5))
    np.savez_compressed(
        TARGET,
        aspect=ASPECTS,
        roughness=ROUGHNESSES,
        index=INDICES,
        absorption=ABSORPTIONS,
        straight=straight.astype(np.float32),
        absorbed=absorbed.astype(np.float32),
        phase=stored(logarithms[:, :, :, 0]),
        dimmed=stored(logarithms[:, :, :2, 2:] - logarithms[:, :, :2, :1]),
    )
    print(TARGET, TARGET.stat().st_size)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else None)
