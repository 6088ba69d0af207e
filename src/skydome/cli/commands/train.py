"""`skydome train`: a small neural network that learns a sky model."""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from typer import Option

from skydome.cli.options import AsJson
from skydome.cli.printing import show

if TYPE_CHECKING:
    from skydome.training.lessons import Teacher
    from skydome.training.method import Recipe


def train(
    output: Annotated[Path, Option("--output", "-o", help="The network's file, .safetensors.")],
    model: Annotated[
        str, Option(metavar="LESSON", help="What is learned: preetham, hosek-wilkie, hosek-wilkie-spectral ...")
    ] = "hosek-wilkie",
    recipe: Annotated[
        str,
        Option(
            metavar="NAME",
            help="published (492 bytes), compact (486), deep (1740), spectral (11 bands), published-data (492, the"
            " paper's samples), backpropagation (492, the paper's training).",
        ),
    ] = "published",
    seed: Annotated[int, Option(min=0, help="Another seed gives other data and other starts.")] = 0,
    resume: Annotated[bool, Option("--resume", help="Go on where an interrupted training stopped.")] = False,
    as_json: AsJson = False,
) -> None:
    """Train a small network on a sky model; `NeuralSky.load` reads it.

    Interrupted, it leaves FILE.training.npz, from which --resume goes on to the same result.
    """
    from skydome.training.lessons import teacher_named
    from skydome.training.recipes import recipe_named

    teacher, way = teacher_named("hosek-wilkie-spectral" if recipe == "spectral" else model), recipe_named(recipe)
    require_network_name(output)
    facts = trained(output, teacher, way, {"model": teacher.name, "recipe": recipe, "seed": seed}, resume)
    show(facts, {name: f"{value:.4g}" if isinstance(value, float) else str(value) for name, value in facts.items()},
         as_json)  # fmt: skip


def require_network_name(path: Path) -> None:
    """ValueError or OSError in one line unless a network file can be written there."""
    if path.suffix != ".safetensors":
        raise ValueError(f"the network's file must end in .safetensors, got {path.name}")
    if not path.parent.is_dir():
        raise FileNotFoundError(f"the folder to write to must exist, got {path.parent}")


def trained(path: Path, teacher: "Teacher", recipe: "Recipe", what: dict[str, Any], resume: bool) -> dict[str, Any]:
    """Train, write, and tell errors and processor seconds."""
    import skydome
    from skydome.skies.neural.files import save_network
    from skydome.training.journal import Journal
    from skydome.training.train import train as learn

    journal = Journal.beside(path, what | {"skydome": skydome.__version__})
    if journal.path.exists() and not resume:
        raise ValueError(f"{journal.path.name} is there from an interrupted training: give --resume, or remove it")
    start = time.process_time()
    with shown() as progress:
        network = learn(teacher, recipe, int(what["seed"]), progress, journal)
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


@contextmanager
def shown() -> Iterator[Callable[[str, float], None]]:
    """A listener that shows stage, step and loss on stderr; silent where stderr is no terminal."""
    from rich.console import Console
    from rich.progress import Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

    text = TextColumn("{task.description}, step {task.completed}, error {task.fields[loss]:.5f}")
    with Progress(
        SpinnerColumn(), text, TimeElapsedColumn(), console=Console(stderr=True), disable=not sys.stderr.isatty()
    ) as progress:
        task = progress.add_task("", total=None, loss=float("nan"))
        yield lambda stage, loss: progress.update(task, description=stage, loss=loss, advance=1)
