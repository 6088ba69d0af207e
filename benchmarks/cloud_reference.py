"""What a map of clouds by the reference costs: `python benchmarks/cloud_reference.py [PASSES]`, some ten CPU minutes.

Every fourth row and column of the upper half of a map of 2048 x 1024. The error is the rms of standard errors over the
mean light, where paths found cloud and 10 degrees from the sun: of the map's own texels and of texels of 2 degrees,
144 of its own each. Minutes are for the whole map, as the squares of errors go.
"""

import sys
import time

import numpy as np

import skydome as sd

WIDTH, HEIGHT, EVERY, TOGETHER = 512, 128, 4, (3, 3)
"""Of the sample; which texels of the map it has; of it in 2 degrees, about (2.1 by 2.1)."""
AIM, AUREOLE = 0.05, 0.985
SKIES = ((sd.Cumulus(), 0.4, 40), (sd.Stratocumulus(), 0.7, 25), (sd.Altocumulus(), 0.6, 15), (sd.Cirrus(), 0.6, 30))
"""Kind, cover, the sun's elevation."""


def views() -> np.ndarray:
    """Directions of the sample, (HEIGHT, WIDTH, 3)."""
    azimuth, up = (np.arange(WIDTH) + 0.5) * (2 * np.pi / WIDTH), (np.arange(HEIGHT) + 0.5) / HEIGHT * (np.pi / 2)
    return sd.direction(azimuth, up[:, None])


def together(table: np.ndarray) -> np.ndarray:
    """Means over texels of 2 degrees."""
    high, wide = TOGETHER
    rows, columns = table.shape[0] // high, table.shape[1] // wide
    return table[: rows * high, : columns * wide].reshape(rows, high, columns, wide).mean(axis=(1, 3))


def main() -> None:
    """Print each sky's errors and minutes."""
    passes = int(sys.argv[1]) if len(sys.argv) > 1 else 24
    toward = views()
    for kind, cover, high in SKIES:
        sun = sd.direction(azimuth=200 * sd.deg, elevation=high * sd.deg)
        sky = sd.CloudySky(sd.PhysicalSky(sun), sd.CloudField(kind, cover=cover, seed=7))
        job = sd.CloudTracing(sky, toward.reshape(-1, 3), paths_per_pass=2)
        job.one_pass(10**6)  # compiled, and its tables made
        started = time.process_time()
        found = job.start().more(passes)
        minutes = (time.process_time() - started) * EVERY**2 / 60
        light, error = (part[:, 1].reshape(HEIGHT, WIDTH) for part in (found.radiance, found.standard_error))
        seen = (error > 0) & (toward @ sun < AUREOLE)
        own = np.sqrt(np.mean(error[seen] ** 2)) / light[seen].mean()
        seen2 = together(seen.astype(float)) > 0.5
        wide = (
            np.sqrt(together(error**2)[seen2].mean() / (np.prod(TOGETHER) * EVERY**2)) / together(light)[seen2].mean()
        )
        whole = [minutes * (each / AIM) ** 2 for each in (own, wide)]
        print(
            f"{kind.name} {cover} sun {high}: {2 * passes} paths a texel, {minutes:.1f} CPU minutes the map: error"
            f" of a texel {own:.3f}, median {found.relative_error:.3f}; of 2 degrees {wide:.3f}; minutes to {AIM}:"
            f" {whole[0]:.0f}, {whole[1]:.1f}",
            flush=True,
        )


if __name__ == "__main__":
    main()
