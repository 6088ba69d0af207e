"""Paths through fields of cloud against Mitsuba's through the same extinction: `python benchmarks/cloud_paths.py`.

All orders of sunlight over black ground, one Henyey-Greenstein lobe, looking up in a picture of 80 degrees. Mitsuba has
the extinction as a grid of 14 x 14 x 10 m about the eye, so that fields here have no fine detail. Three processor
minutes.
"""

from dataclasses import dataclass
from typing import ClassVar

import mitsuba as mi
import numpy as np

import skydome as sd
from skydome.air.phase_laws import HenyeyGreenstein
from skydome.skies.clouds.fields.lit_field import LitField
from skydome.skies.clouds.fields.medium_kernel import extinctions
from skydome.skies.clouds.fields.reference import beam, laws_of, traced_through
from skydome.skies.clouds.fields.scattering import Scattering

mi.set_variant("scalar_rgb")
LOBE = 0.85
SIDE, RAYS, PASSES, WIDE = 8, 64, 8, np.tan(np.radians(40.0))
HALF, PLACES, LEVELS = 4500.0, 640, 128
SAMPLES = 8192


@dataclass(frozen=True)
class SmoothCumulus(sd.Cumulus):
    """Cumulus without fine detail."""

    erosion: ClassVar[float] = 0.0


@dataclass(frozen=True)
class SmoothStratocumulus(sd.Stratocumulus):
    """Stratocumulus without fine detail."""

    erosion: ClassVar[float] = 0.0


FIELDS = ((SmoothCumulus(), 0.4, 50, 7), (SmoothCumulus(), 0.6, 60, 2), (SmoothStratocumulus(), 0.7, 40, 3))
"""Kind, cover, the sun's elevation, seed."""


def ours(field: sd.CloudField, sun: np.ndarray) -> np.ndarray:
    """Mean light of each picture element by passes of paths, each along rays of its own, (PASSES, SIDE, SIDE)."""
    lit = LitField.of(field, sun)
    law = Scattering.of(HenyeyGreenstein((LOBE,)), LOBE**2, [550.0], np.ones((1, 1)))
    lights = beam(lit, [1.0])
    dark, found = np.zeros((5, 8, 1)), []
    for number in range(PASSES):
        of = traced_through(lit, laws_of(law), rays(number), lights, dark, RAYS // 2, 1, number)
        found.append(of[:, 0].reshape(SIDE, SIDE, RAYS).mean(axis=-1))
    return np.array(found)


def rays(number: int) -> np.ndarray:
    """Of a pass, through the picture's elements, (SIDE * SIDE * RAYS, 3)."""
    rng, place = np.random.default_rng(number), np.arange(SIDE)
    across, down = (
        (at + rng.uniform(0, 1, (SIDE, SIDE, RAYS))) / SIDE * 2 - 1
        for at in (place[None, :, None], place[:, None, None])
    )
    views = np.stack([-across * WIDE, -down * WIDE, np.ones_like(down)], axis=-1).reshape(-1, 3)
    return np.asarray(views / np.linalg.norm(views, axis=1, keepdims=True))


def extinction(field: sd.CloudField) -> np.ndarray:
    """About the eye, m-1, (LEVELS, PLACES, PLACES) of up, north, east."""
    along = (np.arange(PLACES) + 0.5) / PLACES * 2 * HALF - HALF
    found = np.empty((LEVELS, PLACES * PLACES), np.float32)
    for k, z in enumerate(field.base + (np.arange(LEVELS) + 0.5) / LEVELS * field.thickness):
        points = np.stack(np.broadcast_arrays(along[None, :], along[:, None], z), -1).reshape(-1, 3)
        out = np.empty(len(points))
        extinctions(0, len(points), field.medium, points, out)
        found[k] = out
    return found.reshape(LEVELS, PLACES, PLACES)


def theirs(field: sd.CloudField, sun: np.ndarray) -> np.ndarray:
    """The same picture by Mitsuba, passes of it."""
    move, thick = mi.ScalarTransform4f, field.thickness
    volume = {
        "type": "gridvolume",
        "grid": mi.VolumeGrid(extinction(field)[..., None]),
        "raw": True,
        "to_world": move().translate([-HALF, -HALF, field.base]).scale([2 * HALF, 2 * HALF, thick]),
    }
    scene = mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "volpath", "max_depth": 2000, "rr_depth": 400},
            "sun": {
                "type": "directional",
                "direction": [float(-part) for part in sun],
                "irradiance": {"type": "rgb", "value": 1.0},
            },
            "air": {
                "type": "cube",
                "to_world": move().translate([0, 0, field.base + thick / 2]).scale([HALF, HALF, thick / 2]),
                "bsdf": {"type": "null"},
                "interior": {
                    "type": "heterogeneous",
                    "albedo": 1.0,
                    "sigma_t": volume,
                    "phase": {"type": "hg", "g": LOBE},
                },
            },
            "sensor": {
                "type": "perspective",
                "fov": float(2 * np.degrees(np.arctan(WIDE))),
                "to_world": move().look_at(origin=[0, 0, 0], target=[0, 0, 1], up=[0, 1, 0]),
                "film": {"type": "hdrfilm", "width": SIDE, "height": SIDE, "rfilter": {"type": "box"},
                         "pixel_format": "luminance", "component_format": "float32"},
            },
        }
    )  # fmt: skip
    return np.array([np.array(mi.render(scene, seed=k, spp=SAMPLES // 4))[..., 0] for k in range(4)])


def main() -> None:
    """Print means and differences."""
    for kind, cover, high, seed in FIELDS:
        sun, field = sd.direction(np.pi, high * sd.deg), sd.CloudField(kind, cover, seed=seed)
        both = ours(field, sun), theirs(field, sun)
        a, b = (passes.mean(axis=0) for passes in both)
        u, v = (passes.std(axis=0, ddof=1) / np.sqrt(len(passes)) for passes in both)
        rms = np.sqrt(max(((a - b) ** 2).mean() - (u**2).mean() - (v**2).mean(), 0.0)) / b.mean()
        print(
            f"{kind.name:14} cover {cover} sun {high}: mean over Mitsuba's {a.mean() / b.mean():.3f}"
            f" +- {np.sqrt((u**2 + v**2).mean()) / b.mean() / SIDE:.3f}, rms but for noise {rms:.3f},"
            f" correlation {np.corrcoef(a.ravel(), b.ravel())[0, 1]:.3f}",
            flush=True,
        )


if __name__ == "__main__":
    main()
