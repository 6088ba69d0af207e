"""`skydome shader`: a sky as a function of direction in a shading language."""

import json
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from typer import Option

from skydome.cli.doors import require_output
from skydome.cli.options import AsJson, FormulaOptions, taking
from skydome.cli.printing import show
from skydome.cli.scene import scene_of

if TYPE_CHECKING:
    import numpy as np

ANY_SUN = "180,45"
"""Of a network whose code takes the sun as an argument: neither text nor numbers depend on it."""
TEXELS = 256
"""In a row of the texture that has the numbers."""


@taking(FormulaOptions)
def shader(
    options: FormulaOptions,
    lang: Annotated[str, Option(metavar="glsl|wgsl|hlsl|osl|c", help="The shading language.")] = "glsl",
    scale: Annotated[float, Option(help="Value of 1 cd m-2; 1e-4 suits a game exposed for noon.")] = 1.0,
    bands: Annotated[bool, Option("--bands", help="A spectral network's bands, W m-2 sr-1 nm-1, not RGB.")] = False,
    basis: Annotated[
        str | None,
        Option(metavar="KIND,ORDER", help="The sky, of any model, as a sum of functions: steerable,4; gaussians,32."),
    ] = None,
    uniforms: Annotated[
        Path | None,
        Option(metavar="FILE", help="The code reads its numbers; this sky's go into FILE: .json, or .bin of float32."),
    ] = None,
    free_sun: Annotated[
        bool, Option("--free-sun", help="Of a network: a function of direction, sun and turbidity.")
    ] = False,
    disc: Annotated[bool, Option("--disc", help="With the sun's disc.")] = False,
    output: Annotated[Path | None, Option("--output", "-o", help="File; stdout without it.")] = None,
    as_json: AsJson = False,
) -> None:
    """Write a sky as shader source: skydome_rgb(direction), or skydome_bands."""
    import skydome as sd
    from skydome.export.shader_languages import language
    from skydome.ground.writing import appearing

    language(lang)  # refused before the sky is made
    kind, order = ("", 0) if basis is None else kind_and_order(basis)
    if basis is None:
        if options.clouds is not None:
            raise ValueError("--clouds have no shader of their own: give --basis steerable,4 for the sky as a sum")
        require_shader(options.model, uniforms is not None)
    require_output(output, "the shader's file")
    if uniforms is not None:
        require_output(uniforms, "the numbers' file", (".json", ".bin"))
    if free_sun and (options.sun, options.place, options.time) == (None, None, None):
        options = replace(options, sun=ANY_SUN)
    scene = scene_of(options)
    sky: sd.Sky = scene.sky if basis is None else sd.SkyBasis.fit(scene.sky, kind, order)
    if disc and scene.disc is not None:
        sky = sky + scene.disc
    source = sd.shader(sky, lang, scale=scale, bands=bands, uniforms=uniforms is not None, free_sun=free_sun)
    if uniforms is not None:
        write_numbers(uniforms, sd.shader_numbers(sky, scale=scale, bands=bands, free_sun=free_sun))
    if output is None and not as_json:
        sys.stdout.write(source)
        return
    if output is not None:
        with appearing(output) as path:
            Path(path).write_text(source)
    facts = {"language": lang, "model": scene.sky.parameters(), "file": None if output is None else str(output)}
    show(facts | {"source": source}, {"language": lang, "file": str(output)}, as_json)


def kind_and_order(text: str) -> tuple[str, int]:
    """The kind of basis and its order; ValueError unless the text is one of the kinds, a comma and a whole number."""
    from skydome.dome.bases.sky_basis import KINDS

    kind, _, order = text.partition(",")
    if kind not in KINDS or not order.isdigit():
        raise ValueError(
            f"--basis must be one of {', '.join(KINDS)}, a comma and an order, as steerable,4, got {text!r}"
        )
    KINDS[kind](int(order))  # refused before the sky is made
    return kind, int(order)


def write_numbers(path: Path, numbers: "np.ndarray") -> None:
    """The numbers as JSON, or as float32 in rows of 256, the last one filled up with zeros: a texture's texels."""
    import numpy as np

    from skydome.ground.writing import appearing

    with appearing(path) as beside:
        if path.suffix == ".json":
            Path(beside).write_text(json.dumps([float(f"{value:.9g}") for value in numbers]))
        else:
            Path(beside).write_bytes(np.pad(numbers, (0, -numbers.size % TEXELS)).astype("<f4").tobytes())


def require_shader(name: str, uniforms: bool) -> None:
    """ValueError for a model that no shader can be written of, before its sky is made."""
    from skydome.skies.catalogue import CATALOGUE, model_named

    model = model_named(name)
    if model.has_table_shader and not uniforms:
        raise ValueError(f"the shader of {name} reads a table: give --uniforms FILE for it (or --basis steerable,4)")
    if not (model.has_shader or model.has_table_shader):
        known = ", ".join(model.name for model in CATALOGUE if model.has_shader and not model.name[-1].isdigit())
        raise ValueError(
            f"shaders know the nine-number formula and networks: {known}, cie-1 ... cie-15; got {name} "
            "(any other sky with --basis steerable,4)"
        )
