"""Clouds under suns about the level, fast form over traced paths: `python benchmarks/cloud_low_suns.py [ELEVATIONS]`.

The sun's scattered light alone, for a beam of 1, suns as seen from the field (of stratocumulus, altocumulus, cirrus):
64 texels of some degrees, even in solid angle, 8 rays in each and 800 paths a ray, not the 10 degrees about the sun.
Elevations in degrees, 1.5,0.3,-0.5,-1,-1.5 by themselves. A processor minute or two.
"""

import sys

import numpy as np

import skydome as sd
from skydome.skies.clouds.fields.lit_field import LitField
from skydome.skies.clouds.fields.reference import beam, laws_of, traced_through

FIELDS = ((sd.Stratocumulus(), 0.8), (sd.Altocumulus(), 0.6), (sd.Cirrus(), 0.6))
SEED, USUAL = 3, "1.5,0.3,-0.5,-1,-1.5"
TEXELS, RAYS, SPREAD, PATHS, PASSES = 64, 8, 0.02, 200, 4
AUREOLE, GOLDEN_ANGLE = 0.985, 2.39996


def views() -> np.ndarray:
    """Directions in texels, (TEXELS, RAYS, 3)."""
    each = np.arange(TEXELS)
    middle = sd.direction(each * GOLDEN_ANGLE % (2 * np.pi), np.arcsin((each + 0.5) / TEXELS * 0.97 + 0.03))
    rays = middle[:, None] + np.random.default_rng(1).normal(0, SPREAD, (TEXELS, RAYS, 3))
    rays[..., 2] = np.abs(rays[..., 2])
    return rays / np.linalg.norm(rays, axis=-1, keepdims=True)


def main() -> None:
    """Print each field's ratios."""
    rays = views()
    flat, middle, none = np.ascontiguousarray(rays.reshape(-1, 3)), rays.mean(axis=1), np.zeros((5, 8, 1))
    for kind, cover in FIELDS:
        for high in (float(part) for part in (sys.argv[1] if len(sys.argv) > 1 else USUAL).split(",")):
            lit = LitField.of(sd.CloudField(kind, cover, seed=SEED), sd.direction(np.pi, high * sd.deg))
            seen, laws = lit.seen(flat), laws_of(lit.scattering())
            ours = seen[:, 1] + lit.scattering().once(flat @ lit.sun, seen[:, 5:])[:, 0]
            ours = ours.reshape(TEXELS, RAYS).mean(axis=1)
            of_passes = (traced_through(lit, laws, flat, beam(lit, [1.0]), none, PATHS, 1, n) for n in range(PASSES))
            passes = np.array([found[:, 0].reshape(TEXELS, RAYS).mean(axis=1) for found in of_passes])
            known, away, level = passes.mean(axis=0), middle @ lit.sun < AUREOLE, middle[:, 2]
            error = passes[:, away].mean(axis=1).std(ddof=1) / np.sqrt(PASSES) / known[away].mean()
            print(
                f"{kind.name} {cover} sun {high}: mean {ours[away].mean() / known[away].mean():.2f} (paths' error"
                f" {error:.3f}), irradiance {(ours @ (level * away)) / (known @ (level * away)):.2f}",
                flush=True,
            )


if __name__ == "__main__":
    main()
