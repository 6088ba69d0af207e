"""A film of one day at a place: a map every so many minutes from midnight to midnight, taken up where it stopped."""

from dataclasses import replace
from datetime import timedelta
from pathlib import Path

from skydome.cli.frames import Frames, day_named, duration
from skydome.cli.map_file import FileOptions
from skydome.cli.map_order import MapOrder
from skydome.cli.night.movie import Movie
from skydome.cli.options import SkyOptions
from skydome.ground.files.folders import folder_for_work

FRAMES = {"exr": "sky.####.exr", "png": "sky.####.png"}
"""The names of frames by their format."""


PLAIN = SkyOptions()
"""The physical sky without a cloud."""


def film_of(
    captures: Path | None,
    place: str | None,
    date: str,
    zone: str | None,
    step: str,
    folder: Path,
    height: int,
    exposure: float | None,
    sky: SkyOptions = PLAIN,
) -> Frames:
    """The frames of a day's film of a `sky` in a folder: OpenEXR of one scale, or PNG where an exposure is given.

    ValueError in one line for what does not fit together.
    """
    from skydome.cli.moment import aware_time

    if captures is not None or place is None:
        raise ValueError("--date makes a film without captures: give --place and --date, and no folder of captures")
    require_all_hours(sky)
    if duration(step) > timedelta(days=1):
        raise ValueError(f"--step must be a day at most in the film of --date, got {step!r}")
    day, zone = day_named(date), zone or "UTC"
    first = aware_time(f"{day}T00:00", zone)
    last = aware_time(f"{day + timedelta(days=1)}T00:00", zone) - timedelta(microseconds=1)
    options = replace(sky, place=place, time=first.isoformat(), until=last.isoformat(), zone=zone)
    file, name = FileOptions(exposure=exposure), FRAMES["exr" if exposure is None else "png"]
    with folder_for_work(folder):
        return Frames.of(MapOrder(options, file, folder / name, height).checked(), step)


def require_all_hours(sky: SkyOptions) -> None:
    """ValueError, before any work, for a sky that has no day and night, or for clouds that cannot be."""
    from skydome.cli.clouds.scene import night_field, without_clouds
    from skydome.cli.models import refuse_what_it_does_not_take
    from skydome.skies.catalogue import model_named

    model = model_named(sky.model)
    if not model.kind.of_all_hours:
        raise ValueError(f"--date makes a film of a day and its night: --model physical or overcast, got {sky.model}")
    refuse_what_it_does_not_take(model, without_clouds(sky))
    night_field(replace(sky, time="2000-01-01T00:00Z"))


def movie_of(film: Path | None, date: str | None, exposure: float | None, night_vision: bool) -> Movie | None:
    """The movie of the options, None where none is asked for; ValueError for what does not fit together."""
    if film is None:
        if night_vision:
            raise ValueError("--night-vision is of a film: give --film night.mp4 too")
        return None
    if date is None:
        raise ValueError("--film is of a day without captures: give --place and --date")
    return Movie(film, exposure, night_vision)


def show_film(frames: Frames, movie: Movie | None, as_json: bool) -> None:
    """Make the frames that are not there yet, and the movie of all, and say what was made."""
    from skydome.cli.commands.render import sequence, sequence_rows
    from skydome.cli.doors import progress
    from skydome.cli.printing import show

    if movie is not None:
        movie.require()
    facts = sequence(frames)
    rows = sequence_rows(facts)
    if movie is not None:
        seconds = [time.timestamp() for time in frames.times]
        with progress("encoding the film") as report:
            told = movie.made([order.output for order in frames], seconds, report)
        facts, rows = facts | told, rows | {"film": "{film}, {film_seconds:.1f} s".format(**told)}
    show(facts, rows, as_json)
