"""`skydome render`: an environment map of the sky in a file, the scene that lights with it, a sequence, or spectra."""

from pathlib import Path
from typing import Annotated, Any

from typer import Option

from skydome.cli.doors import progress
from skydome.cli.frames import Frames, frame_facts, is_dark
from skydome.cli.map_file import FileOptions
from skydome.cli.map_order import MapOrder, order_rows
from skydome.cli.numbers_of_light import frame_light_facts
from skydome.cli.options import AsJson, SkyOptions, taking
from skydome.cli.printing import show
from skydome.cli.spectral_map import spectral_map, spectral_rows, steps


@taking(SkyOptions, FileOptions)
def render(
    options: SkyOptions,
    file: FileOptions,
    output: Annotated[
        Path, Option("--output", "-o", help="sky.exr, sky.hdr, or sky.png for a preview; day.####.exr with --step.")
    ],
    height: Annotated[int | None, Option(help="Rows. [default: 1024, or texels of about that size]")] = None,
    space: Annotated[str, Option(metavar="srgb|rec2020|acescg", help="Linear RGB space of the file.")] = "srgb",
    ground: Annotated[
        str | None, Option(metavar="black|ALBEDO", help="Ground below the horizon. [default: --albedo]")
    ] = None,
    scene: Annotated[
        Path | None,
        Option(
            "--scene",
            help="Also the renderer's scene, the sun a lamp and not in the map: sky.usda, .py (Blender), "
            ".xml (Mitsuba), .pbrt, .js (three.js), .rad, .gltf.",
        ),
    ] = None,
    north: Annotated[
        float, Option(metavar="DEG", help="Where the scene's own north points, degrees clockwise from true north.")
    ] = 0.0,
    step: Annotated[
        str | None, Option(metavar="10min", help="A sequence: a map every 10min from --time to --until.")
    ] = None,
    wavelengths: Annotated[
        str | None, Option(metavar="FROM,TO,STEP", help="Spectra instead, nm: 390,710,20 into sky.hsr or sky.exr.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Write an environment map of the sky and print its numbers."""
    if wavelengths is not None:
        if scene is not None or step is not None or ground is not None or space != "srgb":
            raise ValueError("--wavelengths writes spectra of one sky: no --scene, --step, --ground or --space")
        waves = steps(wavelengths)
        with progress("rendering spectra"):
            facts = spectral_map(options, file, output, waves, height, north)
        show(facts, spectral_rows(facts), as_json)
        return
    order = MapOrder(options, file, output, height, space, ground, north, scene)
    if step is not None:
        facts = sequence(Frames.of(order.checked(), step))
        show(facts, sequence_rows(facts), as_json)
        return
    order = order.checked()
    with progress(f"rendering {order.rows} rows") as report:
        facts = order.made(report)
    show(facts, order_rows(facts), as_json)


def sequence(frames: Frames) -> dict[str, Any]:
    """Make the frames that are not there yet: which were made, which were there, which are dark."""
    before = frames.done()
    made, dark, kept = [], [], dict(before)
    with progress(f"rendering {len(frames.times)} frames") as report:
        for number, order in enumerate(frames):
            report(number, len(frames.times), f"frame {number + 1} of {len(frames.times)}, {order.options.time}")
            name = order.output.name
            if name in before:
                continue
            if is_dark(order):
                dark.append(name)
                continue
            kept[name] = frame_facts(order.made(told=frame_light_facts))
            made.append(name)
            frames.keep(kept)
    return {
        "frames": len(frames.times),
        "made": made,
        "there_before": sorted(before),
        "dark": dark,
        "record": str(frames.record),
    }


def sequence_rows(facts: dict[str, Any]) -> dict[str, str]:
    """The same for people."""
    rows = {"frames": f"{facts['frames']} asked for, {len(facts['made'])} made now"}
    if facts["there_before"]:
        rows["there before"] = f"{len(facts['there_before'])}, left as they are"
    if facts["made"]:
        rows["files"] = f"{facts['made'][0]} to {facts['made'][-1]}"
    if facts["dark"]:
        rows["left out"] = f"{len(facts['dark'])}: the sun has set, and the model knows no light then"
    return rows | ({"record": facts["record"]} if facts["made"] or facts["there_before"] else {})
