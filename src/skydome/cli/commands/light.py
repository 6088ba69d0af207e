"""`skydome light`: the numbers of the sky's light."""

from typing import Annotated

from typer import Option

from skydome.cli.doors import progress
from skydome.cli.moment import pointing
from skydome.cli.numbers_of_light import amount, light_facts, light_rows
from skydome.cli.options import AsJson, SkyOptions, taking
from skydome.cli.printing import show
from skydome.cli.scene import scene_of


@taking(SkyOptions)
def light(
    options: SkyOptions,
    normal: Annotated[
        str | None, Option(metavar="AZ,EL", help="Also the illuminance of a plane that faces this way, degrees.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Print the numbers of the sky's light without making a map."""
    import skydome as sd

    facing = None if normal is None else pointing(normal, "--normal")
    with progress("adding up the light"):
        scene = scene_of(options, any_hour=True)
        facts = light_facts(scene)
        rows = light_rows(facts)
        if facing is not None:
            facts["illuminance_lx"]["plane"] = value = float(sd.illuminance(scene.whole, facing))
            rows[f"plane facing {normal}"] = f"{amount(value)} lx"
    show(facts, rows, as_json)
