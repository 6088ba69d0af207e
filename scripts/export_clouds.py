"""Fields of cloud for the explorer's page, data/clouds.json: `python scripts/export_clouds.py`.

The kinds' numbers, the constants of the fast form, columns of air between the eye, the clouds and the sun, and the
light of the sky above each kind. The page makes the clouds themselves from the same hash; their shapes are written out
once more there.
"""

import json
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from explorer_digits import digits

from skydome.air.atmosphere import Atmosphere
from skydome.air.cross_sections import rayleigh_depth
from skydome.air.named_airs import BACKGROUND_DEPTH, KINDS, background
from skydome.air.phase_laws import Rayleigh
from skydome.ground.directions import direction
from skydome.ground.units import EARTH_RADIUS
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.sky import PhysicalSky
from skydome.skies.all_air.spectral_nodes import NODES, bands_from_nodes
from skydome.skies.catalogue import model_named
from skydome.skies.clouds.fields import field, lit_field, low_sun, march_kernel, scattering, shadows
from skydome.skies.clouds.fields.air import exchange, lower
from skydome.skies.clouds.fields.air.above import skylight
from skydome.skies.clouds.fields.air.before import LEVELS, VIEWS, AirBefore
from skydome.skies.clouds.fields.air.channels import Channels
from skydome.skies.clouds.fields.air.sunlight import Sunlight
from skydome.skies.clouds.fields.kinds import Altocumulus, Cirrus, CloudKind, Cumulus, Stratocumulus
from skydome.skies.clouds.fields.transport import diffusion, ordinates
from skydome.skies.physical.sky_colours import SkyColours
from skydome.skies.suns.sun_disc import MEAN_RADIUS

PATH = Path(__file__).resolve().parent.parent / "explorer" / "src" / "data" / "clouds.json"
SINES = np.linspace(0.0, 1.0, VIEWS) ** 2
STANDING = -4.0 + 94.0 * np.linspace(0.0, 1.0, 64) ** 2
"""True elevations of suns, degrees."""
KINDS_OF_CLOUD = (Cumulus(), Stratocumulus(), Altocumulus(), Cirrus())
SUNS = np.array([-6, -5, -4, -3, -2, -1.2, -0.6, 0, 0.6, 1.2, 2, 3, 4.5, 6, 8, 11, 15, 20, 27, 36, 48, 64, 90.0])
TURBIDITIES = np.array([1.1, 2.2, 4.7, 10.0])
"""True elevations of suns, degrees, and hazes under which the sky above a kind is told."""
STEP = 2e-3
"""Of the logarithm of its light."""
FIGURES = 5


def plain(values: Any, figures: int = FIGURES) -> Any:
    """Numbers as lists, to so many figures."""
    rounded = [float(f"{value:.{figures}g}") for value in np.asarray(values, np.float64).ravel()]
    return np.reshape(rounded, np.shape(values)).tolist()


def numbers_of(kind: CloudKind) -> dict[str, Any]:
    """What the page knows of a kind."""
    names = ("base", "thickness", "extinction", "period", "count", "levels", "erosion", "detail", "edge")
    profile = kind.profile((np.arange(kind.levels) + 0.5) / kind.levels)
    asymmetry = float(np.asarray(kind.law.mean_cosine([550.0]))[0])
    told = {name: getattr(kind, name) for name in names}
    return told | {"particles": kind.particles.name, "asymmetry": asymmetry, "profile": plain(profile, 7)}


def columns_of(air: Atmosphere, kind: CloudKind) -> tuple[np.ndarray, np.ndarray]:
    """Vertical columns of molecules, haze and ozone between the eye and the heights of a kind, (VIEWS, LEVELS, 3).

    And of suns at `STANDING`, as seen from its middle, the share that the ground and the gases leave, and columns of
    these and of the stratosphere's haze, (SUNS, 5).
    """
    before = AirBefore(air, np.empty(0), kind.base, kind.base + kind.thickness)
    tables, middle = ColumnTables.of(air), np.full(STANDING.shape, before.heights[LEVELS // 2])
    seen, share = tables.seen(middle, np.radians(STANDING))
    share = share * [gases_leave(air, middle[0], sun) for sun in STANDING]
    return before.columns[..., :3], np.column_stack([share, tables.toward(middle, np.sin(seen))])


def gases_leave(air: Atmosphere, height: float, sun: float) -> float:
    """Share of the luminance of a sun's beam that water vapour, oxygen and carbon dioxide leave at a height."""
    channels, at = Channels.of_colours(), np.array(height)
    depths = np.stack([np.asarray(part.depth(channels.wavelengths)) for part in air.constituents])
    whole, left = (
        float(sunlight.of_point(at, np.array(np.radians(sun))) @ channels.weights[:, 1])
        for sunlight in (
            Sunlight(AirBefore(each, depths, height, height), None, 1.0, channels.wavelengths)
            for each in (replace(air, gases=None), air)
        )
    )
    return left / whole if whole > 0 else 1.0


def above(kind: CloudKind, sun: float, turbidity: float, mirrored: float = 0.0) -> np.ndarray:
    """The sky on the top of a kind's field that sends a share `mirrored` of it and the sun back, irradiance over the
    sun's above the air, and the share of it that thick cloud has of even light, (2, NODES).
    """
    made = model_named("physical").make(direction(0.0, np.radians(sun)), {"turbidity": turbidity})
    clear, top = (
        PhysicalSky(made.toward, replace(made.atmosphere, gases=None), check="clamp"),
        kind.base + kind.thickness,
    )
    beam = beam_at(clear.atmosphere, top, max(float(made.toward[2]), 0.0))
    sky = skylight(clear, top, NODES, beam, np.full(NODES.shape, mirrored))
    return np.stack([sky.whole / clear.atmosphere.sun_at(NODES), sky.thick / sky.whole])


def beam_at(air: Atmosphere, height: float, sine: float) -> np.ndarray:
    """Irradiance of the sun on the horizontal at a height, (NODES,)."""
    columns = ColumnTables.of(air).toward(np.array(height), np.array(sine))
    depths = np.stack([np.asarray(part.depth(NODES)) for part in air.constituents])
    return sine * np.exp(-columns @ depths) * air.sun_at(NODES)


def skies_above(kind: CloudKind, suns: np.ndarray = SUNS) -> tuple[np.ndarray, np.ndarray]:
    """The same for hazes and suns over a field that sends nothing back, the light as its logarithm, (2, TURBIDITIES,
    SUNS, NODES); and the share that the air sends back of light from below, (TURBIDITIES, NODES).
    """
    light, thick = np.moveaxis([[above(kind, sun, haze) for sun in suns] for haze in TURBIDITIES], 2, 0)
    return np.stack([np.log(light), thick]), np.array([sent_back(kind, haze) for haze in TURBIDITIES])


def sent_back(kind: CloudKind, turbidity: float) -> np.ndarray:
    """Share that the air above a kind sends back of light from below, (NODES,)."""
    air = model_named("physical").make(direction(0.0, np.pi / 2), {"turbidity": turbidity}).atmosphere
    beam = beam_at(air, kind.base + kind.thickness, 1.0) / air.sun_at(NODES)
    none, whole = (above(kind, 90.0, turbidity, mirrored)[0] + beam for mirrored in (0.0, 1.0))
    return 1 - none / whole


def told_above(kind: CloudKind) -> dict[str, Any]:
    """The skies above a kind as the page has them."""
    light, back = skies_above(kind)
    return {"light": digits(light, STEP, 2), "back": plain(back, 4)}


def lower_columns(air: Atmosphere, kind: CloudKind) -> np.ndarray:
    """Vertical columns of molecules, haze and ozone below a kind's base, (3,)."""
    tables, up = ColumnTables.of(air), np.array(1.0)
    return (tables.toward(np.array(0.0), up) - tables.toward(np.array(kind.base), up))[:3]


def slants() -> Any:
    """Sines of the elevations of the ordinates' rays, and their shares of a hemisphere."""
    return plain(ordinates.Ordinates(np.zeros((1, 1, 1)), (1.0, 1.0), 0.0).slants, 12)


def table() -> dict[str, Any]:
    """Everything but the skies above the kinds."""
    air = Atmosphere.standard(0.1)
    kinds = KINDS_OF_CLOUD
    columns = {kind.name: columns_of(air, kind) for kind in kinds}
    ozone = air.constituents[2]
    return {
        "kinds": {kind.name: numbers_of(kind) for kind in kinds},
        "met": field.MET,
        "closed": field.CLOSED,
        "lowest": low_sun.LOWEST,
        "farthest": lit_field.FARTHEST,
        "diffusion": {
            "sweeps": diffusion.SWEEPS,
            "nothing": float(f"{diffusion.NOTHING:.3g}"),
            "smeared": diffusion.SMEARED,
        },
        "ordinates": {
            "change": ordinates.CHANGE,
            "wideChange": ordinates.WIDE_CHANGE,
            "most": ordinates.MOST,
            "narrowest": ordinates.NARROWEST,
            "thin": ordinates.THIN,
            "least": ordinates.LEAST,
            "slants": slants(),
        },
        "beams": {"fine": lit_field.FINE, "most": lit_field.MOST_LEVELS, "least": lit_field.LEAST},
        "widths": lit_field.WIDTHS.tolist(),
        "gone": march_kernel.GONE,
        "dense": march_kernel.DENSE,
        "earth": EARTH_RADIUS,
        "depths": scattering.DEPTHS,
        "first": scattering.FIRST,
        "step": scattering.STEP,
        "angles": scattering.ANGLES,
        "smooth": scattering.SMOOTH,
        "moments": scattering.MOMENTS,
        "points": shadows.POINTS,
        "discRadius": MEAN_RADIUS,
        "views": VIEWS,
        "wavelengths": NODES.tolist(),
        "colours": plain(SkyColours.of(air, bands_from_nodes().T).whole, 7),
        "rayleigh": float(rayleigh_depth([550.0])[0]),
        "molecules": plain(rayleigh_depth(NODES)),
        "ozone": plain(ozone.depth(NODES) / ozone.column, 5),
        "usualOzone": ozone.column,
        "angstrom": {name: kind.angstrom for name, kind in KINDS.items()},
        "background": [BACKGROUND_DEPTH, background().angstrom],
        "between": {name: plain(each[0], 4) for name, each in columns.items()},
        "sunward": {name: plain(each[1]) for name, each in columns.items()},
        "standing": [STANDING[0], STANDING[-1]],
        "ground": plain(ColumnTables.of(air).toward(np.zeros(SINES.shape), SINES)),
        "lower": {kind.name: plain(lower_columns(air, kind)) for kind in kinds},
        "streams": [plain(lower.SINES, 8), plain(lower.WEIGHTS, 8)],
        "grazing": float(lower.GRAZING),
        "slant": [exchange.DIFFUSE, exchange.OPEN],
        "molecular": plain(Rayleigh(air.constituents[0].depolarisation).moments(3, [550.0])[2], 6)[0],
        "haze": {name: [part.albedo, part.phase_law.asymmetries[0]] for name, part in KINDS.items()},
        "suns": SUNS.tolist(),
        "turbidities": TURBIDITIES.tolist(),
    }


if __name__ == "__main__":
    whole = table() | {"above": {kind.name: told_above(kind) for kind in KINDS_OF_CLOUD}}
    PATH.write_text(json.dumps(whole, separators=(",", ":")) + "\n", "utf-8")
    sys.exit(0)
