"""Fields of cloud, fast form against traced paths: `python benchmarks/cloud_fields.py [fit | held | fresh | newest]`.

Texels of 2 degrees, even in solid angle, 16 rays in each; sunlight, and skylight a fifth of it, on the cloud alone.
Nothing of the fast form is fitted; nobody had looked at "newest" before it was as it is. Two to forty processor seconds
a field.
"""

import argparse

import numpy as np

import skydome as sd
from skydome.skies.clouds.fields.lit_field import LitField
from skydome.skies.clouds.fields.reference import beam, laws_of, traced_through

C, S, A, R = sd.Cumulus(), sd.Stratocumulus(), sd.Altocumulus(), sd.Cirrus()
FIELDS = {
    "fit": ((C, 0.4, 50, 7), (C, 0.6, 20, 1), (C, 0.8, 60, 2), (C, 0.3, 35, 3), (S, 0.7, 40, 3), (S, 0.5, 20, 1),
            (A, 0.6, 30, 3), (A, 0.4, 60, 1), (R, 0.5, 40, 3)),
    "held": ((C, 0.3, 60, 11), (C, 0.5, 30, 12), (C, 0.7, 45, 13), (C, 0.4, 15, 14), (S, 0.8, 25, 11), (S, 0.6, 55, 12),
             (A, 0.5, 20, 11), (A, 0.7, 45, 12), (R, 0.5, 30, 11), (R, 0.7, 60, 12)),
    "fresh": ((C, 0.35, 55, 21), (C, 0.5, 40, 22), (C, 0.65, 25, 23), (C, 0.45, 20, 24), (S, 0.75, 50, 21),
              (S, 0.6, 30, 22), (A, 0.55, 50, 21), (A, 0.65, 25, 22), (R, 0.6, 25, 21), (R, 0.4, 50, 22)),
    "newest": ((C, 0.35, 35, 31), (C, 0.55, 50, 32), (C, 0.6, 15, 33), (C, 0.45, 65, 34), (S, 0.7, 20, 31),
               (S, 0.55, 60, 32), (A, 0.6, 40, 31), (A, 0.45, 15, 32), (R, 0.65, 45, 31), (R, 0.45, 20, 32)),
}  # fmt: skip
"""Kind, cover, the sun's elevation, seed."""
TEXELS, RAYS, PATHS, PASSES = 600, 16, 6, 24
SKYLIGHT = 0.2
AUREOLE = 0.985
"""Cosine of 10 degrees."""


def views() -> np.ndarray:
    """Directions in texels, (TEXELS, RAYS, 3)."""
    rng = np.random.default_rng(5)
    up = np.degrees(np.arcsin((np.arange(TEXELS) + 0.5) / TEXELS))
    elevation, azimuth = np.clip(np.floor(up / 2) * 2 + 1, 3, 89), np.floor(rng.uniform(0, 180, TEXELS)) * 2
    cells = np.stack(np.meshgrid(np.arange(4), np.arange(4)), -1).reshape(-1, 2)
    off = 2 * ((cells + rng.uniform(0, 1, (TEXELS, RAYS, 2))) / 4 - 0.5)
    return sd.direction((azimuth[:, None] + off[..., 0]) * sd.deg, (elevation[:, None] + off[..., 1]) * sd.deg)


def traced(lit: LitField, rays: np.ndarray) -> np.ndarray:
    """Light of sun and sky on the cloud by paths, passes of it, (PASSES, TEXELS)."""
    flat, lights = np.ascontiguousarray(rays.reshape(-1, 3)), beam(lit, [1.0])
    whole = np.full((5, 8, 1), SKYLIGHT / np.pi)
    found = []
    for number in range(PASSES):
        of = traced_through(lit, laws_of(lit.scattering()), flat, lights, whole, PATHS, 1, number)
        found.append((of[:, 0] + of[:, 1] * SKYLIGHT / np.pi).reshape(TEXELS, RAYS).mean(axis=1))
    return np.array(found)


def fast(lit: LitField, rays: np.ndarray) -> np.ndarray:
    """The same by the fast form, (TEXELS,)."""
    flat = rays.reshape(-1, 3)
    seen = lit.seen(flat)
    sunlight = seen[:, 1] + lit.scattering().once(flat @ lit.sun, seen[:, 5:])[:, 0]
    return (sunlight + SKYLIGHT * (seen[:, 2] + seen[:, 0] / np.pi)).reshape(TEXELS, RAYS).mean(axis=1)


def main() -> None:
    """Print each field's errors."""
    asked = argparse.ArgumentParser(description=__doc__)
    asked.add_argument("fields", nargs="?", default="held", choices=sorted(FIELDS))
    rays = views()
    middle = rays.mean(axis=1)
    for kind, cover, high, seed in FIELDS[asked.parse_args().fields]:
        sun = sd.direction(np.pi, high * sd.deg)
        lit = LitField.of(sd.CloudField(kind, cover, seed=seed), sun)
        passes, ours, away = traced(lit, rays), fast(lit, rays), middle @ sun < AUREOLE
        known, noise = passes.mean(axis=0)[away], passes.var(axis=0, ddof=1)[away].mean() / PASSES
        ours, level = ours[away], middle[away, 2]
        rms = np.sqrt(max(np.mean((ours - known) ** 2) - noise, 0)) / known.mean()
        print(
            f"{kind.name:14} cover {cover:.2f} sun {high} seed {seed}: mean {ours.mean() / known.mean():.3f},"
            f" irradiance {(ours @ level) / (known @ level):.3f}, rms {rms:.3f} (paths'"
            f" {noise**0.5 / known.mean():.2f})",
            flush=True,
        )


if __name__ == "__main__":
    main()
