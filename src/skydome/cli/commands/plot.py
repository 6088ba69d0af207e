"""`skydome plot`: the sky's luminance as a round picture, looking up."""

from datetime import datetime, timedelta
from pathlib import Path
from textwrap import wrap
from typing import Annotated, Any

from typer import Option

from skydome.cli.doors import progress, require_output
from skydome.cli.moment import Moment, place_text
from skydome.cli.numbers_of_light import light_facts, notes_row
from skydome.cli.options import AsJson, SkyOptions, taking
from skydome.cli.printing import show
from skydome.cli.scene import Scene, scene_of
from skydome.ground.extras import required

PATH_STEP = timedelta(minutes=5)


@taking(SkyOptions)
def plot(
    options: SkyOptions,
    output: Annotated[Path, Option("--output", "-o", help="plot.png, plot.svg or plot.pdf.")],
    as_json: AsJson = False,
) -> None:
    """Plot the sky's luminance looking up, north up, east at the left; with the sun's path, or moon and stars."""
    from skydome.figures.skies import FORMATS, save_figure, sky_figure
    from skydome.skies.validity import parameters_text
    from skydome.sun.day import is_day

    require_output(output, "a plot's file", FORMATS)
    required("matplotlib", "plot", "a plot")
    with progress("plotting the sky"):
        scene = scene_of(options, any_hour=True)
        moment = scene.moment
        path = None if moment is None or not is_day(moment.direction) else day_path(moment)
        lines = wrap(parameters_text(scene.sky.parameters()), 90)
        if moment is not None:
            lines.append(caption(moment))
        figure = sky_figure(scene.sky, marked(scene), path, "\n".join(lines))
        save_figure(figure, output)
        facts = light_facts(scene) | {"file": str(output), "bytes": output.stat().st_size}
    rows = {"file": str(output), "plot": "looking up: north up, east at the left"}
    show(facts, rows | notes_row(facts["notes"]), as_json)


def marked(scene: Scene) -> Any:
    """Where the sun stands, or the moon when the sun has set; None where neither is known or up."""
    from skydome.dome.integrals import discs_and_rest
    from skydome.sun.day import is_day

    moment = scene.moment
    if moment is None or is_day(moment.direction):
        return None if moment is None else moment.direction
    discs, _ = discs_and_rest(scene.whole)
    return discs[-1][0].sun if discs else None


def caption(moment: Moment) -> str:
    """Place, time and the sun's angles in a line."""
    parts = []
    if moment.place is not None and moment.time is not None:
        parts += [place_text(**vars(moment.place)), moment.time.isoformat(" ", "minutes")]
    return ", ".join([*parts, f"sun at azimuth {moment.azimuth:.1f}°, elevation {moment.elevation:.1f}°"])


def day_path(moment: Moment) -> tuple[Any, Any, list[str]] | None:
    """Directions of the sun through the local day (N, 3), those at whole hours (24, 3) and their labels."""
    import skydome as sd

    if moment.place is None or moment.time is None:
        return None
    start = moment.time.replace(hour=0, minute=0, second=0, microsecond=0)
    steps = [start + k * PATH_STEP for k in range(24 * 12 + 1)]
    hours: list[datetime] = steps[:-1:12]
    along = sd.sun_direction(moment.place, steps)
    return along, along[:-1:12], [f"{hour.hour}" for hour in hours]
