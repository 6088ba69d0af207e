"""The physical sky in a table small enough for the explorer's page: `python scripts/export_physical.py`.

Under one sun its light is a few smooth fields over half the dome (`HeldSky`): what each constituent scatters once, and
the rest. Over sun heights, turbidities and grounds these fields are sums of few shapes: each height's span has a basis
of its own (singular vectors), and a condition is its coefficients and the size of each field. Whole multiples of a
step in text (`explorer_digits.py`).

Air with less haze than the stratosphere's alone has less of that and none below: two rows of the table, and between
them straight lines.
"""

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
from explorer_digits import digits

import skydome as sd
from skydome.air.named_airs import BACKGROUND_DEPTH, depth_of_turbidity
from skydome.skies.all_air.sky import NODES, TERMS, PhysicalSky, series_of
from skydome.skies.catalogue import model_named
from skydome.skies.physical.cosine_series import LEAST_COSINE, view_nodes

PATH = Path(__file__).resolve().parent.parent / "explorer" / "src" / "data" / "physical.json"
SPANS = (
    (np.arange(-17.5, -5.4, 0.75), 36, 26),
    (np.arange(-6.0, 4.1, 0.5), 46, 26),
    (np.array([4, 5, 6, 7, 8.5, 10, 12, 14, 17, 20, 24, 28, 33, 38, 44, 50, 56, 62, 68, 74, 80, 85, 89.9]), 20, 28),
)
"""Elevations of the sun, degrees, and the number of shapes of light scattered once and of the rest."""
LEAST_HAZE = 1 + BACKGROUND_DEPTH / float(depth_of_turbidity(2.0))
"""Turbidity of the stratosphere's aerosol alone: what is above it lies near the ground."""
NEAR = 1e-3
"""How close to a turbidity's end its fields are taken, as they stand for a unit of haze."""
TURBIDITIES = np.array([1 + NEAR, LEAST_HAZE + NEAR, 1.2, 1.4, 1.7, 2.1, 2.7, 3.5, 4.6, 6.0, 7.8, 10.0])
STEP, STEP_OF_SIZE = 2.5e-4, 5e-4
"""Of coefficients, of which 1 is a field's brightest, and of the logarithms of sizes."""
ALBEDOS = np.array([0.0, 0.3, 0.65, 1.0])
TURNS = 17
LIT = (0, 1, 3)
"""The constituents that scatter: molecules, aerosol, stratospheric aerosol."""


def rest_series(sky: PhysicalSky) -> np.ndarray:
    """The rest of the light as a series, (nodes, terms, 3)."""
    turns = np.cos(np.linspace(0, np.pi, TERMS + 1, dtype=np.float32))
    lit = sky.at(NODES).single()
    rest = sky.rest.radiance(lit.numbers, np.float32(sky.sun[2]), lambda network: network.at_nodes(turns))
    view = np.asarray(view_nodes(TERMS))[:, None]
    colours = sky.colours().of_light(rest[None], lit.gases, np.float32(sky.sun[2]), view)
    series: np.ndarray = series_of(colours)[:, :, 0]
    return series


def on_turns(series: np.ndarray) -> np.ndarray:
    """A series (nodes, terms, ...) at azimuths from 0 to 180 degrees, (nodes, TURNS, ...)."""
    waves = np.cos(np.linspace(0, np.pi, TURNS)[:, None] * np.arange(series.shape[1]))
    return np.einsum("pm,nm...->np...", waves, series)


def fields_of(elevation: float, turbidity: float) -> dict[str, Any]:
    """Fields of one sun and air: once (nodes, turns, 3, 3), rest (albedos, nodes, turns, 3), lux, the sun as seen.

    The aerosol's are for each turbidity above `LEAST_HAZE`, the stratosphere's for all of it.
    """
    model, sun = model_named("physical"), sd.direction(0.0, elevation * sd.deg)
    made = [model.make(sun, {"turbidity": turbidity, "albedo": albedo}) for albedo in ALBEDOS]
    held = made[0].held()
    high = min(1.0, (turbidity - 1) / (LEAST_HAZE - 1))
    return {
        "once": on_turns(held.series[:, :, list(LIT)]) / np.array([1.0, turbidity - LEAST_HAZE, high])[:, None],
        "rest": np.stack([on_turns(rest_series(sky)) for sky in made]),
        "lux": float(made[0].direct_normal_illuminance),
        "seen": float(sd.elevation(held.sun)) / sd.deg,
    }


def compressed(rows: np.ndarray, count: int) -> dict[str, Any]:
    """Rows (heights, ..., shape) of fields >= 0 as log sizes, and coefficients (count, heights, ...) of a basis."""
    size = np.maximum(np.abs(rows).max(axis=-1, keepdims=True), 1e-12)
    flat = (rows / size).reshape(-1, rows.shape[-1])
    left, values, right = np.linalg.svd(flat, full_matrices=False)
    scale = np.abs(right[:count]).max(axis=1)
    coefficients = (left[:, :count] * values[:count] * scale).T
    most = np.maximum(np.abs(coefficients).max(axis=1), STEP)
    return {
        "size": digits(np.log(size[..., 0]), STEP_OF_SIZE, 0),
        "coefficients": digits(coefficients.reshape(count, *rows.shape[:-1]), STEP, 1),
        "basis": digits((right[:count] / scale[:, None]).reshape(count, -1, TURNS), STEP / most, 2),
    }


def span(elevations: np.ndarray, once: int, rest: int) -> dict[str, Any]:
    """The table of a span of the sun's elevations."""
    found = [[fields_of(e, t) for t in TURBIDITIES] for e in elevations]
    pick = {name: np.array([[f[name] for f in row] for row in found]) for name in ("once", "rest", "lux", "seen")}
    shapes = np.moveaxis(pick["once"], (2, 3), (-2, -1)).reshape(*pick["once"].shape[:2], 3, 3, -1)
    rests = np.moveaxis(pick["rest"], (3, 4), (-2, -1)).reshape(*pick["rest"].shape[:3], 3, -1)
    return {
        "elevations": elevations.round(6).tolist(),
        "seen": pick["seen"][:, 0].round(5).tolist(),
        "lux": np.log(np.maximum(pick["lux"], 1e-6)).round(4).tolist(),
        "once": compressed(shapes, once),
        "rest": compressed(rests, rest),
    }


def table() -> dict[str, Any]:
    """Everything."""
    sky = model_named("physical").make(sd.direction(0.0, 0.5), {})
    laws = [sky.laws[k].closed for k in LIT]
    return {
        "turbidities": TURBIDITIES.round(6).tolist(),
        "albedos": ALBEDOS.tolist(),
        "leastHaze": round(LEAST_HAZE, 6),
        "nodes": 32,
        "turns": TURNS,
        "leastCosine": LEAST_COSINE,
        "laws": [
            {"constant": law.constant, "square": law.square, "lobes": [list(x) for x in law.lobes]} for law in laws
        ],
        "spans": [span(*entry) for entry in SPANS],
    }


if __name__ == "__main__":
    PATH.write_text(json.dumps(table(), separators=(",", ":")) + "\n", "utf-8")
    sys.exit(0)
