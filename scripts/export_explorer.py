"""What the explorer's page reads of the package: its tables, networks and formulas, written for TypeScript.

    python scripts/export_explorer.py            # writes explorer/src/data/
    python scripts/export_explorer.py --check    # exit code 1 where what lies there differs

Long rows of numbers are float32 in base64, little endian; a test compares them, number by number, with the package's.
"""

import base64
import json
import sys
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

import skydome as sd
from skydome.air.atmosphere import USUAL_ALBEDO
from skydome.air.cross_sections import rayleigh_depth
from skydome.air.turbidity import meteorological_range
from skydome.dome.ground_light import USUAL_ALBEDO as GROUND_ALBEDO
from skydome.export import held_shader
from skydome.export.formula_shader import angle_function, channel_function
from skydome.export.network_shader import INPUTS
from skydome.export.shader_languages import GLSL, Language
from skydome.ground.quadrature import crowded
from skydome.ground.tables import archive, columns
from skydome.ground.units import LUMINOUS_EFFICACY, SOLAR_CONSTANT
from skydome.light.colour import D65, xyz_of_white
from skydome.light.colour_temperature import _locus
from skydome.light.daylight import daylight_weights
from skydome.light.spectrum import xyz_weights
from skydome.skies.catalogue import CATALOGUE, model_named
from skydome.skies.formula.igawa import GREATEST_INDEX
from skydome.skies.formula.level import CLEAR_SHAPE, HIGHEST
from skydome.skies.formula.older import asrc_cie
from skydome.skies.formula.older.pokrowski import NEAREST, Pokrowski
from skydome.skies.formula.perez_formula import COSINE_FLOOR
from skydome.skies.formula.perez_table import BIN_CENTRES, LEAST_BRIGHTNESS, MOST_BLACK
from skydome.skies.hosek_wilkie import BANDS, HosekWilkie, band_weights, published
from skydome.skies.neural.sky import NeuralForm, NeuralSky, NeuralSpectralSky
from skydome.skies.preetham import Preetham, PreethamNumbers
from skydome.skies.suns.sun_disc import SunDisc, limb_coefficients, limb_mean
from skydome.sun.delta_t import POLYNOMIALS
from skydome.sun.geocentric import OBLIQUITY
from skydome.sun.position import SOLAR_RADIUS_AT_1_AU

FOLDER = Path(__file__).resolve().parent.parent / "explorer" / "src" / "data"
DAYLIGHT = np.arange(380.0, 781.0, 10.0)
NODES = 24

JAVASCRIPT = Language(
    name="js", comment="//", let="const {name} = {expression};", argument="{name}: number",
    scalar="export function {name}({arguments}): number", colour="", answer="", direction=("x", "y", "z"), many="",
    functions=tuple((name, f"Math.{name}") for name in ("exp", "sqrt", "max", "min", "log")),
)  # fmt: skip


def packed(values: Any) -> dict[str, Any]:
    """Numbers as float32 in base64, with their shape."""
    array = np.ascontiguousarray(values, dtype="<f4")
    return {"shape": list(array.shape), "f4": base64.b64encode(array.tobytes()).decode()}


def plain(values: Any) -> Any:
    """Numbers as lists, to twelve digits: the last ones differ between processors."""
    rounded = [float(f"{value:.12g}") for value in np.asarray(values, dtype=np.float64).ravel()]
    return np.reshape(rounded, np.shape(values)).tolist()


def preetham() -> dict[str, Any]:
    """Preetham's numbers as printed."""
    return asdict(PreethamNumbers.PRINTED)


def hosek_wilkie() -> dict[str, Any]:
    """The authors' control points of R A ... I, (turbidity, albedo, control, channel, 10)."""
    return {form: packed(published(form)) for form in ("xyz", "rgb", "spectral")} | {"bands": plain(BANDS)}


def perez() -> dict[str, Any]:
    """Perez's letters, bins and efficacies."""
    return {
        "letters": {name: plain(column) for name, column in columns("perez_1993").items()},
        "efficacy": {name: plain(column) for name, column in columns("perez_1990_efficacy").items()},
        "binCentres": plain(BIN_CENTRES),
        "leastBrightness": LEAST_BRIGHTNESS,
        "mostBlack": MOST_BLACK,
        "solarConstant": SOLAR_CONSTANT,
    }


def seen() -> list[float]:
    """One over how far one sees, km-1: a constant, and its part by turbidity."""
    near, far = 1000 / np.asarray(meteorological_range(np.array([2.0, 1.0])))
    return [float(2 * far - near), float(near - far)]


def older() -> dict[str, Any]:
    """Numbers of the older skies: tables, and what their classes have where nobody says."""
    usual = Pokrowski(sd.ZENITH, zenith_luminance=1.0)
    return {
        "asrc": {"clear": list(asrc_cie.CLEAR), "turbid": list(asrc_cie.TURBID)},
        "brungerHooper": {name: plain(column) for name, column in columns("brunger_hooper_1993").items()},
        "pokrowski": [usual.constant, usual.depth, float(NEAREST)],
    }


def disc() -> dict[str, Any]:
    """The sun's disc: radiance in its bands, limb darkening, and what makes colours of them."""
    bands = SunDisc.bands
    return {
        "radiance": packed(archive("hosek_wilkie_2013")["solar_radiance"].transpose(1, 0, 2, 3)),
        "between": packed(band_weights(bands).T),
        "limb": packed(limb_coefficients(bands)),
        "limbMean": packed(limb_mean(bands)),
        "xyz": packed(xyz_weights(bands)),
        "radius": SOLAR_RADIUS_AT_1_AU,
    }


def network(kind: type[NeuralForm], name: str) -> dict[str, Any]:
    """A network's layers, its inputs by name, and the matrix from its outputs to XYZ."""
    sky = kind.load(name, sd.ZENITH)
    matrix = np.asarray(xyz_weights(sky.bands)).T if issubclass(kind, NeuralSpectralSky) else sd.SRGB.to_xyz
    return {
        "features": list(sky.network.features),
        "layers": [{"weights": packed(weights), "biases": packed(biases)} for weights, biases in sky.network.layers],
        "exponential": sky.network.output.name == "exponential",
        "scale": sky.network.scale,
        "bands": list(sky.network.bands),
        "toXYZ": plain(matrix),
    }


def networks() -> dict[str, Any]:
    """Every network of the catalogue by its model's name."""
    kinds = {model.name: model for model in CATALOGUE if issubclass(model.kind, (NeuralSky, NeuralSpectralSky))}
    return {name: network(model.kind, model.fixed["network"]) for name, model in kinds.items()}


def sun() -> dict[str, Any]:
    """The earth's course (VSOP87), the obliquity and delta T."""
    table = columns("vsop87_earth")
    rows = np.stack([table[name] for name in ("quantity", "power", "amplitude", "phase", "rate")], axis=-1)
    return {"vsop87": plain(rows), "obliquity": plain(OBLIQUITY), "deltaT": [list(row) for row in POLYNOMIALS]}


def colour() -> dict[str, Any]:
    """sRGB, the D65 white, daylight's spectrum and the Planckian locus."""
    points, tangents = _locus()
    matrix, balance = daylight_weights(DAYLIGHT)
    return {
        "srgbToXYZ": plain(sd.SRGB.to_xyz),
        "srgbFromXYZ": plain(sd.SRGB.from_xyz),
        "chromaticities": list(sd.SRGB.chromaticities),
        "d65": plain(xyz_of_white(D65)),
        "daylight": {"wavelengths": plain(DAYLIGHT), "matrix": plain(matrix), "balance": plain(balance)},
        "locus": packed(np.concatenate([points, tangents], axis=1)),
    }


def tables() -> dict[str, Any]:
    """Everything numeric."""
    near, weight = crowded(NODES)
    return {
        "version": sd.__version__,
        "cie": {name: plain(column) for name, column in columns("cie_s011").items()},
        "clearShape": plain(CLEAR_SHAPE[0]),
        "highest": HIGHEST,
        "efficacy": LUMINOUS_EFFICACY,
        "rayleigh": float(rayleigh_depth([550.0])[0]),
        "seen": plain(seen()),
        "albedo": {"sky": USUAL_ALBEDO, "ground": GROUND_ALBEDO},
        "nodes": {"near": plain(near), "weight": plain(weight)},
        "limits": {
            "preetham": plain(list(Preetham.ranges["turbidity"][:2])),
            "hosek": plain(list(HosekWilkie.ranges["turbidity"][:2])),
        },
        "shines": {f"cie-{kind}": model_named(f"cie-{kind}").shines for kind in range(1, 16)},
        "preetham": preetham(),
        "hosekWilkie": hosek_wilkie(),
        "perez": perez(),
        "igawa": {name: plain(column) for name, column in columns("igawa_2014").items()},
        "igawaMost": GREATEST_INDEX,
        "older": older(),
        "disc": disc(),
        "networks": networks(),
        "sun": sun(),
        "colour": colour(),
    }


def formula(language: Language) -> str:
    """The nine-number formula and the angle to the sun; Hosek and Wilkie's form has its own offset."""
    hosek = channel_function(language, HosekWilkie.offset, COSINE_FLOOR).replace("skydome_channel", "hosek_channel")
    return "\n".join([channel_function(language, 0.0, COSINE_FLOOR), hosek, angle_function(language)])


def held() -> dict[str, Any]:
    """The code of the physical sky that reads its numbers, by language, and the size of the table among them."""
    sky = model_named("physical").make(sd.direction(0.0, 0.5), {})
    languages = ("glsl", "wgsl", "hlsl", "osl", "c")
    texts = {lang: sd.shader(sky, lang=lang, uniforms=True) for lang in languages}
    return {"heights": held_shader.HEIGHTS, "azimuths": held_shader.AZIMUTHS, "texts": texts}


def texts() -> dict[str, str]:
    """The files by name."""
    note = "// Written by scripts/export_explorer.py from the package's own formulas.\n"
    inputs = json.dumps(INPUTS, indent=2)
    shaders = (
        f"export const FORMULA = `\n{formula(GLSL)}\n`;\n\nexport const INPUTS: Record<string, string> = {inputs};\n\n"
        f"export const HELD = {json.dumps(held(), indent=2)};\n"
    )
    return {
        "tables.json": json.dumps(tables(), separators=(",", ":")) + "\n",
        "formula.ts": note + formula(JAVASCRIPT) + "\n",
        "shaders.ts": note + shaders,
    }


def main() -> int:
    """Write the files, or compare them."""
    wanted = texts()
    if "--check" in sys.argv[1:]:
        stale = [name for name, text in wanted.items() if (FOLDER / name).read_text("utf-8") != text]
        print("stale: " + ", ".join(stale) if stale else "as the package has it")
        return int(bool(stale))
    FOLDER.mkdir(parents=True, exist_ok=True)
    for name, text in wanted.items():
        (FOLDER / name).write_text(text, "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
