"""`skydome animate`: smooth frames between captured skies."""

from dataclasses import replace
from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from skydome.cli.clouds.film import USUAL_WIND, light_film
from skydome.cli.clouds.layer_options import CloudKindWord
from skydome.cli.doors import progress
from skydome.cli.map_file import Exposure, Half
from skydome.cli.night.film import film_of, movie_of, show_film
from skydome.cli.options import AsJson, SkyOptions
from skydome.cli.printing import show_facts

MOST_FRAMES = 100_000

LAYOUTS = "latlong, angular, mirror-ball, cube, fisheye or fisheye-equisolid"
Layout = Annotated[str, Option(help=f"How the maps lie in their files: {LAYOUTS}.")]


def animate(
    output: Annotated[Path, Option("--output", "-o", help="The folder for the frames; made if it is not there.")],
    folder: Annotated[
        Path | None, Argument(help="A folder of .exr or .hdr captures of one day; or --date.", metavar="[CAPTURES]")
    ] = None,
    frames: Annotated[int, Option(help="How many frames, from the first capture to the last.")] = 240,
    layout: Layout = "latlong",
    place: Annotated[
        str | None, Option(metavar="LAT,LON[,ALT]", help="Compute the sun; the maps are turned to true north.")
    ] = None,
    zone: Annotated[str | None, Option(metavar="NAME", help="IANA zone of times in file names.")] = None,
    horizon: Annotated[float, Option(help="Elevation below which nothing is sky, degrees.")] = 0.0,
    masks: Annotated[
        bool, Option("--masks", help="Write each capture's sky mask beside it as PNG to edit, and stop.")
    ] = False,
    seed: Annotated[int, Option(help="Seed of the training, or of the clouds.")] = 0,
    recipe: Annotated[
        str, Option(metavar="NAME", help="The day's network: maps, or published with the paper's output and loss.")
    ] = "maps",
    half: Half = True,
    date: Annotated[
        str | None,
        Option(metavar="2026-08-12", help="No captures: a day and its night at --place, by the physical sky."),
    ] = None,
    step: Annotated[
        str | None,
        Option(metavar="10min", help="Time between the frames of --date. [default: 10min; of --weather its rows]"),
    ] = None,
    weather: Annotated[
        Path | None,
        Option(metavar="SITE.epw", help="No --place: the --date of a weather file, each row's light in a frame."),
    ] = None,
    clouds: Annotated[
        str | None,
        Option(
            metavar="KIND",
            help="cumulus (the usual), stratocumulus, altocumulus or cirrus over --place, or with --weather's light.",
        ),
    ] = None,
    cloud_kind: CloudKindWord = None,
    cover: Annotated[
        float | None, Option(help="Of --clouds over --place: share of the sky with cloud, 0-1. [default: 0.4]")
    ] = None,
    wind: Annotated[
        str | None, Option(metavar="EAST,NORTH", help="Of --clouds: how they drift, m/s. [default: 6,2]")
    ] = None,
    model: Annotated[str, Option(metavar="physical|overcast", help="The sky of --place and --date.")] = "physical",
    cloud_depth: Annotated[
        float | None, Option("--cloud-depth", help="Of --model overcast: its optical depth, 5-60. [default: 20]")
    ] = None,
    height: Annotated[int, Option(help="Rows of the frames of --date.")] = 512,
    exposure: Exposure = None,
    film: Annotated[
        Path | None,
        Option(metavar="NIGHT.mp4", help="Also the frames of --date as a film, exposed for their content (ffmpeg)."),
    ] = None,
    night_vision: Annotated[
        bool, Option("--night-vision", help="The --film as the eye sees it: dark places bluish, without colour.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Write the frames of a day: between captures, by a neural sky trained on them, or of --date; can go on."""
    movie = movie_of(film, date, exposure, night_vision)
    level = exposure if movie is None else None
    if weather is not None:
        if (
            date is None
            or (folder or place or zone) is not None
            or (cover, cloud_depth, model) != (None, None, "physical")
        ):
            raise ValueError(
                "--weather makes a film of a --date, whose place and light are the file's: give --date and --clouds, "
                "no captures, --place, --zone, --cover, --cloud-depth or --model"
            )
        film_order = light_film(weather, date, clouds, seed, output, height, level, step, wind, cloud_kind)
        show_film(film_order, movie, as_json)
        return
    if wind is not None and clouds is None:
        raise ValueError("--wind moves clouds: give --clouds too, such as --clouds cumulus")
    if date is not None:
        sky = SkyOptions(model=model, clouds=clouds, cover=cover, optical_depth=cloud_depth, kind=cloud_kind)
        if clouds is not None:
            sky = replace(sky, cloud_seed=seed, wind=wind or USUAL_WIND)
        show_film(film_of(folder, place, date, zone, step or "10min", output, height, level, sky), movie, as_json)
        return
    if (clouds, cover, cloud_depth, cloud_kind, model) != (None, None, None, None, "physical"):
        raise ValueError("clouds and --model are of a film of a day: give --date, and --place or --weather")
    if folder is None:
        raise ValueError("animate needs a folder of captures, or --place and --date")
    from math import radians

    import skydome as sd
    from skydome.captures.capture_training import day_recipe
    from skydome.captures.captures import layout_named
    from skydome.captures.frames import Job, run, write_masks
    from skydome.ground.limits.sizes import require_count

    require_count(frames, MOST_FRAMES, "frames")
    if frames < 2:
        raise ValueError(f"frames must be at least 2, got {frames}")
    layout_named(layout)
    day_recipe(recipe)
    where = None if place is None else sd.Place.parse(place)
    job = Job(folder, output, frames, layout, where, zone, radians(horizon), seed, half, recipe)
    with progress("reading captures") as report:
        facts = (write_masks if masks else run)(job, lambda stage, share: report(share, 1.0, stage))
    show_facts(facts, as_json)
