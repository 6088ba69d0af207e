"""`skydome shader`: a sky as a function of direction in a shading language."""

import sys
from pathlib import Path
from typing import Annotated

from typer import Option

from skydome.cli.doors import require_output
from skydome.cli.options import AsJson, SkyOptions, taking
from skydome.cli.printing import show
from skydome.cli.scene import scene_of


@taking(SkyOptions)
def shader(
    options: SkyOptions,
    lang: Annotated[str, Option(metavar="glsl|wgsl|hlsl|osl|c", help="The shading language.")] = "glsl",
    scale: Annotated[float, Option(help="Value of 1 cd m-2; 1e-4 suits a game exposed for noon.")] = 1.0,
    bands: Annotated[bool, Option("--bands", help="A spectral network's bands, W m-2 sr-1 nm-1, not RGB.")] = False,
    output: Annotated[Path | None, Option("--output", "-o", help="File; stdout without it.")] = None,
    as_json: AsJson = False,
) -> None:
    """Write a sky, without the sun's disc, as shader source: skydome_rgb(direction), or skydome_bands."""
    import skydome as sd
    from skydome.export.shader_languages import language
    from skydome.ground.writing import appearing

    language(lang)  # refused before the sky is made
    require_shader(options.model)
    require_output(output, "the shader's file")
    scene = scene_of(options)
    source = sd.shader(scene.sky, lang, scale=scale, bands=bands)
    if output is None and not as_json:
        sys.stdout.write(source)
        return
    if output is not None:
        with appearing(output) as path:
            Path(path).write_text(source)
    facts = {"language": lang, "model": scene.sky.parameters(), "file": None if output is None else str(output)}
    show(facts | {"source": source}, {"language": lang, "file": str(output)}, as_json)


def require_shader(name: str) -> None:
    """ValueError for a model that no shader can be written of, before its sky is made."""
    from skydome.skies.catalogue import CATALOGUE, model_named

    if not model_named(name).has_shader:
        known = ", ".join(model.name for model in CATALOGUE if model.has_shader and not model.name[-1].isdigit())
        raise ValueError(f"shaders know the nine-number formula and networks: {known}, cie-1 ... cie-15; got {name}")
