"""Other kinds of aerosol and other ozone for the explorer's page, data/airs.json: `python scripts/export_airs.py`.

Beside the fields of the usual air (`export_physical.py`) those of another are so many times as bright. The factor's
logarithm is a sum of few shapes, with coefficients by the sun's height, the turbidity and the ground. Of ozone there
are two, of less and of more than the usual. Bytes in base64, a scale a shape.
"""

import base64
import json
import sys
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from export_physical import LIT, SPANS, on_turns, rest_series

import skydome as sd
from skydome.air.named_airs import KINDS
from skydome.skies.catalogue import model_named

PATH = Path(__file__).resolve().parent.parent / "explorer" / "src" / "data" / "airs.json"
TURBIDITIES = np.array([1.08, 2.0, 4.0, 10.0])
ALBEDOS = np.array([0.0, 1.0])
OZONE = (210.0, 450.0)
SHAPES = (10, 8)
"""Of light scattered once and of the rest."""
NEGLIGIBLE = 1e-3
"""Share of a field's brightest below which its factor does not count."""


@cache
def fields_of(elevation: float, turbidity: float, aerosol: str, ozone: float) -> tuple[np.ndarray, np.ndarray]:
    """Fields of one sun and air: once (9, shape), rest (albedos x 3, shape)."""
    made = [sky_of(elevation, turbidity, aerosol, ozone, albedo) for albedo in ALBEDOS]
    once = on_turns(made[0].held().series[:, :, list(LIT)])
    rest = np.stack([on_turns(rest_series(sky)) for sky in made])
    flat = [np.moveaxis(once, (2, 3), (0, 1)).reshape(9, -1), np.moveaxis(rest, 3, 1).reshape(len(made) * 3, -1)]
    return flat[0], flat[1]


def sky_of(elevation: float, turbidity: float, aerosol: str, ozone: float, albedo: float = 0.0) -> Any:
    """The physical sky of a sun and an air."""
    given = {"turbidity": turbidity, "aerosol": aerosol, "ozone": ozone, "albedo": albedo}
    return model_named("physical").make(sd.direction(0.0, elevation * sd.deg), given, check="clamp")


@cache
def lux_of(elevation: float, turbidity: float, aerosol: str, ozone: float) -> float:
    """Illuminance of the sun facing it, lx."""
    return float(sky_of(elevation, turbidity, aerosol, ozone).direct_normal_illuminance)


def factor(other: np.ndarray, usual: np.ndarray) -> np.ndarray:
    """Logarithm of one field over another, (fields, shape); towards 0 where neither gives light."""
    least = NEGLIGIBLE * np.abs(usual).max(axis=-1, keepdims=True) + 1e-30
    return np.asarray(np.log((np.maximum(other, 0) + least) / (np.maximum(usual, 0) + least)))


def bytes_of(values: np.ndarray) -> dict[str, Any]:
    """Numbers (..., count) as bytes, each column over its largest."""
    scale = np.maximum(np.abs(values).max(axis=tuple(range(values.ndim - 1))), 1e-12)
    packed = np.round(values / scale * 127).astype(np.int8)
    text = base64.b64encode(packed.tobytes()).decode()
    return {"shape": list(values.shape), "scale": [float(f"{s:.5g}") for s in scale], "i1": text}


def compressed(rows: list[np.ndarray], count: int) -> dict[str, Any]:
    """Factors (airs, elevations, turbidities, fields, shape) of each air by coefficients of common shapes."""
    whole = np.stack(rows)
    _, _, right = np.linalg.svd(whole.reshape(-1, whole.shape[-1]), full_matrices=False)
    stored = bytes_of(right[:count].T)
    shapes = np.frombuffer(base64.b64decode(stored["i1"]), np.int8).reshape(stored["shape"]) / 127 * stored["scale"]
    found, *_ = np.linalg.lstsq(shapes, whole.reshape(-1, whole.shape[-1]).T, rcond=None)
    return {"shapes": stored, "airs": [bytes_of(part) for part in found.T.reshape(*whole.shape[:-1], count)]}


def span(elevations: np.ndarray) -> dict[str, Any]:
    """The table of a span of the sun's elevations."""
    few = np.unique(np.append(elevations[::2], elevations[-1]))
    airs = [((kind, 330.0), ("usual", 330.0)) for kind in KINDS if kind != "usual"]
    airs += [(("usual", ozone), ("usual", 330.0)) for ozone in OZONE]
    found: list[list[np.ndarray]] = [[], []]
    for other, usual in airs:
        pairs = [[(fields_of(e, t, *other), fields_of(e, t, *usual)) for t in TURBIDITIES] for e in few]
        for k in (0, 1):
            found[k].append(np.array([[factor(a[k], b[k]) for a, b in row] for row in pairs]))
    lux = [[[np.log((lux_of(e, t, *a) + 1e-6) / (lux_of(e, t, *b) + 1e-6)) for t in TURBIDITIES] for e in elevations]
           for a, b in airs]  # fmt: skip
    once, rest = (compressed(found[k], SHAPES[k]) for k in (0, 1))
    return {
        "elevations": few.round(6).tolist(),
        "once": once,
        "rest": rest,
        "lux": np.array(lux).round(4).tolist(),
    }


def table() -> dict[str, Any]:
    """Everything."""
    kinds = [kind for kind in KINDS if kind != "usual"]
    return {
        "kinds": kinds,
        "ozone": list(OZONE),
        "lobes": [KINDS[kind].phase.asymmetries[0] for kind in kinds],
        "turbidities": TURBIDITIES.tolist(),
        "albedos": ALBEDOS.tolist(),
        "spans": [span(entry[0]) for entry in SPANS],
    }


if __name__ == "__main__":
    PATH.write_text(json.dumps(table(), separators=(",", ":")) + "\n", "utf-8")
    sys.exit(0)
