"""The overcast sky for the explorer's page, data/overcast.json: `python scripts/export_overcast.py`.

Its network as the package ships it (float16 in base64), the optical numbers of its usual layers at the network's
wavelengths, and the cloud's phase functions at these as sums of three shapes over the angle.
"""

import base64
import json
import sys
from pathlib import Path
from typing import Any

import numpy as np

import skydome as sd
from skydome.ground.units import EARTH_RADIUS
from skydome.skies.all_air.spectral_nodes import NODES, bands_from_nodes
from skydome.skies.clouds.layer_light import LEAST
from skydome.skies.clouds.layer_optics import LayerOptics, layer_optics
from skydome.skies.clouds.model import KINDS
from skydome.skies.clouds.overcast import OvercastSky
from skydome.skies.clouds.overcast_files import shipped_overcast
from skydome.skies.clouds.overcast_network import GLOW, STRENGTH
from skydome.skies.clouds.two_streams import DARK, DIFFUSE, LEAST_LOST, MEAN, OZONE_HEIGHT, TO_THE_CLOUD
from skydome.skies.physical.cosine_series import LEAST_COSINE
from skydome.skies.physical.sky_colours import SkyColours

PATH = Path(__file__).resolve().parent.parent / "explorer" / "src" / "data" / "overcast.json"
SHAPES, ANGLES = 3, 512
"""Of the phase functions; angles are even in the root of the angle, so that the corona is fine."""


def half(values: np.ndarray) -> dict[str, Any]:
    """Numbers as float16 in base64, with their shape."""
    array = np.ascontiguousarray(values, dtype="<f2")
    return {"shape": list(array.shape), "f2": base64.b64encode(array.tobytes()).decode()}


def plain(values: Any, figures: int = 7) -> Any:
    """Numbers as lists, to so many figures."""
    rounded = [float(f"{value:.{figures}g}") for value in np.asarray(values, np.float64).ravel()]
    return np.reshape(rounded, np.shape(values)).tolist()


def sky_of(kind: str) -> OvercastSky:
    """The usual layer of a kind of cloud of depth 1 over a black ground."""
    return OvercastSky(sd.direction(0.0, 0.7), 1.0, 0.0, kind=KINDS[kind], check="clamp")


def optics_of(sky: OvercastSky) -> LayerOptics:
    """Its optical numbers at the network's wavelengths."""
    molecules, ozone, _ = sky.atmosphere.constituents
    return layer_optics(molecules, ozone, sky.cloud, np.zeros(NODES.size), NODES)


def layer(kind: str) -> dict[str, Any]:
    """A kind of cloud: its optical numbers, and its phase functions, `shapes` (angles, 3) times `mixture` (3, W)."""
    sky = sky_of(kind)
    numbers = optics_of(sky)
    angles = np.pi * np.linspace(0, 1, ANGLES) ** 2
    law = sky.cloud.phase_law.value(np.cos(angles), NODES)
    mean = law.mean(axis=1, keepdims=True)
    left, values, right = np.linalg.svd(law / mean, full_matrices=False)
    told = {name: plain(getattr(numbers, name)) for name in ("cloud", "albedo", "asymmetry", "peak")}
    shapes = (left[:, :SHAPES] * values[:SHAPES] * mean).astype(np.float32)
    return told | {"shapes": plain(shapes, 5), "mixture": plain(right[:SHAPES])}


def table() -> dict[str, Any]:
    """Everything."""
    network, sky = shipped_overcast(), sky_of("water")
    numbers = optics_of(sky)
    return {
        "layers": [{"weights": half(weights), "biases": half(biases)} for weights, biases in network.layers],
        "shapes": half(network.shapes),
        "places": plain(network.places),
        "dark": DARK,
        "streams": {
            "ozoneHeight": OZONE_HEIGHT,
            "diffuse": DIFFUSE,
            "toTheCloud": TO_THE_CLOUD,
            "leastLost": LEAST_LOST,
            "mean": MEAN,
        },
        "glow": {"width": GLOW, "strength": STRENGTH},
        "least": LEAST,
        "leastCosine": LEAST_COSINE,
        "earth": EARTH_RADIUS,
        "height": sky.cloud.profile.mean_height,
        "thickness": sky.cloud.thickness,
        "above": plain(numbers.above),
        "below": plain(numbers.below),
        "ozone": plain(numbers.ozone),
        "colours": plain(SkyColours.of(sky.atmosphere, bands_from_nodes().T).whole),
        "kinds": {kind: layer(kind) for kind in KINDS},
    }


if __name__ == "__main__":
    PATH.write_text(json.dumps(table(), separators=(",", ":")) + "\n", "utf-8")
    sys.exit(0)
