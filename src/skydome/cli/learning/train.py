"""`skydome train`: a small neural network that learns a sky model."""

import time
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from typer import Option

from skydome.cli.doors import progress, require_output
from skydome.cli.learning.animate import LAYOUTS
from skydome.cli.learning.physical_networks import (
    BATCHES,
    OVERCAST,
    PHYSICAL,
    POLARISATION,
    train_overcast_network,
    train_physical_networks,
    train_polarised_network,
)
from skydome.cli.learning.train_day import MapsOfDay, ScansOfDay, train_day_network
from skydome.cli.options import AsJson
from skydome.cli.printing import show_facts

if TYPE_CHECKING:
    from skydome.training.lessons import Teacher
    from skydome.training.method import TrainingRecipe

DAY = "A day instead of a model"


def train(
    output: Annotated[Path, Option("--output", "-o", help="The network's file, .safetensors.")],
    model: Annotated[
        str,
        Option(
            metavar="LESSON",
            help="What is learned: preetham, hosek-wilkie, hosek-wilkie-spectral, physical, polarisation, overcast",
        ),
    ] = "hosek-wilkie",
    recipe: Annotated[
        str,
        Option(
            metavar="NAME",
            help="published (492 bytes), compact (486), deep (1740), spectral (11 bands), published-data (492, the"
            " paper's samples), backpropagation (492, the paper's training); of captures published or maps.",
        ),
    ] = "published",
    seed: Annotated[int, Option(min=0, help="Another seed gives other data and other starts.")] = 0,
    resume: Annotated[bool, Option("--resume", help="Go on where an interrupted training stopped.")] = False,
    lessons: Annotated[
        Path | None, Option(help="The physical sky's lessons, a folder that is filled up first. [FILE.lessons]")
    ] = None,
    batches: Annotated[int, Option(min=1, help="Of 16 random airs, or 32 clouds, each.")] = BATCHES,
    small: Annotated[bool, Option("--small", help="The physical sky's networks in less than 30 kB.")] = False,
    captures: Annotated[
        Path | None,
        Option(metavar="FOLDER", help="Learn a day of captured maps instead (see animate).", rich_help_panel=DAY),
    ] = None,
    measured: Annotated[
        Path | None,
        Option(metavar="FILE", help="Learn a sky scanner's samples: .nc, or .csv of luminance.", rich_help_panel=DAY),
    ] = None,
    layout: Annotated[str, Option(help=f"Of captures: {LAYOUTS}.", rich_help_panel=DAY)] = "latlong",
    place: Annotated[
        str | None, Option(metavar="LAT,LON[,ALT]", help="Of captures: compute the sun.", rich_help_panel=DAY)
    ] = None,
    zone: Annotated[
        str | None, Option(metavar="NAME", help="Of captures: IANA zone of times in names.", rich_help_panel=DAY)
    ] = None,
    validate: Annotated[
        bool, Option("--validate", help="Cross validation: errors at captures left out in turn.", rich_help_panel=DAY)
    ] = False,
    folds: Annotated[
        int | None, Option(help="Of the validation. [default: one a capture]", rich_help_panel=DAY)
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Train a small network on a sky model, or on a day of captures; `NeuralSky.load` reads it.

    Interrupted, it leaves FILE.training.npz, from which --resume goes on to the same result. With --model physical:
    lessons, where they are missing, and both networks of `PhysicalSky`; the lessons stay for a next run; polarisation
    and overcast: the same for its polarisation, and for `OvercastSky`. Networks of models are measured on skies that
    they have not seen; those of captures are with --validate.
    """
    if captures is not None or measured is not None:
        require_output(output, "the network's file", (".safetensors",))
        require_day(captures, measured, resume, recipe, folds, validate)
        day = ScansOfDay(measured) if measured is not None else MapsOfDay(captures or Path(), layout, place, zone)
        show_facts(train_day_network(output, day, recipe, seed, folds, validate), as_json)
        return
    if validate or folds is not None:
        raise ValueError("--validate leaves out whole captures: it goes with --captures or --measured")
    if model in (PHYSICAL, POLARISATION, OVERCAST):
        require_output(output, "the network's file", (".safetensors",))
        folder = output.with_suffix(".lessons") if lessons is None else lessons
        if model == PHYSICAL:
            show_facts(train_physical_networks(output, folder, batches, seed, small), as_json)
        else:
            learn = train_polarised_network if model == POLARISATION else train_overcast_network
            show_facts(learn(output, folder, batches, seed), as_json)
        return
    from skydome.training.lessons import teacher_named
    from skydome.training.recipes import recipe_named

    teacher, way = teacher_named("hosek-wilkie-spectral" if recipe == "spectral" else model), recipe_named(recipe)
    require_output(output, "the network's file", (".safetensors",))
    facts = trained(output, teacher, way, {"model": teacher.name, "recipe": recipe, "seed": seed}, resume)
    show_facts(facts, as_json)


def require_day(
    captures: Path | None, measured: Path | None, resume: bool, recipe: str, folds: int | None, validate: bool
) -> None:
    """ValueError, before any work, for choices that do not go with a day."""
    from skydome.captures.capture_training import day_recipe

    if captures is not None and measured is not None:
        raise ValueError("a network learns --captures or --measured: give one of them")
    if resume:
        raise ValueError("--resume goes on with a model's training; a day is learned in seconds")
    if folds is not None and not validate:
        raise ValueError("--folds belongs to --validate")
    day_recipe(recipe)


def trained(
    path: Path, teacher: "Teacher", recipe: "TrainingRecipe", what: dict[str, Any], resume: bool
) -> dict[str, Any]:
    """Train, write, and tell errors and processor seconds."""
    import skydome
    from skydome.skies.neural.files import save_network
    from skydome.training.journal import Journal
    from skydome.training.train import train as learn

    journal = Journal.beside(path, what | {"skydome": skydome.__version__})
    if journal.path.exists() and not resume:
        raise ValueError(f"{journal.path.name} is there from an interrupted training: give --resume, or remove it")
    start = time.process_time()
    steps = count(1)
    with progress("training") as report:

        def listen(stage: str, loss: float) -> None:
            step = next(steps)
            report(step, None, f"{stage}, step {step}, error {loss:.5f}")

        network = learn(teacher, recipe, int(what["seed"]), listen, journal)
    seconds = time.process_time() - start
    facts = what | {"bytes": network.bytes, "processor_seconds": round(seconds, 1)} | errors_of(network, teacher)
    command = "skydome train --model {model} --recipe {recipe} --seed {seed}".format(**what)
    save_network(path, network, {"command": command, "skydome": skydome.__version__} | facts)
    journal.forget()
    return {"file": str(path)} | facts


def errors_of(network: Any, teacher: "Teacher") -> dict[str, float]:
    """The measures of the network on held-out data."""
    from skydome.training.validation import relative_error, validated, validated_by_zenith

    if teacher.bands:
        return {"rms_relative": relative_error(network, teacher)}
    by_zenith = validated_by_zenith(network, teacher).target
    return validated(network, teacher).as_dict() | {"target_of_views_by_zenith": by_zenith}
