"""The command `skydome`. Commands import what they need when they run, so that help is quick."""

import math
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Annotated, Any, cast

import typer
from typer.core import TyperCommand, TyperGroup

from skydome import __version__
from skydome.cli.clouds.kinds import with_usual_kind
from skydome.cli.commands.convert import convert
from skydome.cli.commands.daylight import daylight
from skydome.cli.commands.explore import explore
from skydome.cli.commands.glare import glare
from skydome.cli.commands.illuminance import illuminance
from skydome.cli.commands.light import light
from skydome.cli.commands.list_models import models
from skydome.cli.commands.plot import plot
from skydome.cli.commands.render import render
from skydome.cli.commands.shader import shader
from skydome.cli.commands.sun import sun
from skydome.cli.commands.terrain import terrain
from skydome.cli.commands.weather import weather
from skydome.cli.commands.year import year
from skydome.cli.endings import DEBUG, MEMORY, end_on_signals, ending
from skydome.cli.learning.animate import animate
from skydome.cli.learning.evaluate import evaluate
from skydome.cli.learning.fit import fit
from skydome.cli.learning.simulate import simulate
from skydome.cli.learning.train import train
from skydome.cli.options import target_help

UsageError = cast(type[typer.BadParameter], typer.BadParameter.__bases__[0])
"""What the command line itself says of words that it does not understand."""


class FiniteCommand(TyperCommand):
    """A command whose numbers are finite, whichever options it has; `--clouds` alone are the usual ones."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Read the words."""
        return super().parse_args(ctx, with_usual_kind(args))

    def invoke(self, ctx: Any) -> Any:
        """Look at the numbers, then call it."""
        for option in self.params:
            value = ctx.params.get(option.name)
            if isinstance(value, float) and not math.isfinite(value):
                raise ValueError(f"{option.opts[0]} must be a finite number, got {value:g}")
        return super().invoke(ctx)


class Commands(TyperGroup):
    """The group of commands; what goes wrong becomes one line on stderr and an exit code."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """The command that is called; its help names the renderers, which nothing else needs to know."""
        name, command, rest = super().resolve_command(ctx, args)
        if command is not None and not {"-h", "--help"}.isdisjoint(rest):
            for option in command.params:
                if option.name == "target" and isinstance(option.default, str):  # lx elsewhere
                    vars(option)["help"] = target_help()
        return name, command, rest

    def main(self, args: Any = None, *arguments: Any, **choices: Any) -> Any:
        """Run a command and exit: 0, 2 for bad input, 130 when interrupted."""
        words = list(sys.argv[1:] if args is None else args)
        with ending("skydome", debug=DEBUG in words), memory_granted(words) as words:
            words = [word for word in words if word != DEBUG]
            try:
                code = super().main(words, *arguments, **(choices | {"standalone_mode": False}))
            except UsageError as error:
                raise ValueError(error.format_message().replace(": Value error, ", ": ")) from error
        sys.exit(code if isinstance(code, int) else 0)


@contextmanager
def memory_granted(words: list[str]) -> Iterator[list[str]]:
    """The words without --max-memory, within the memory that it allows."""
    if MEMORY not in words:
        yield words
        return
    from skydome.ground.limits.sizes import bytes_of, granting

    place = words.index(MEMORY)
    with granting(bytes_of("".join(words[place + 1 : place + 2]))):
        yield words[:place] + words[place + 2 :]


app = typer.Typer(
    cls=Commands, pretty_exceptions_enable=False, context_settings={"help_option_names": ["-h", "--help"]}
)
for command in (
    render,
    light,
    sun,
    plot,
    models,
    convert,
    shader,
    explore,
    glare,
    illuminance,
    evaluate,
    simulate,
    fit,
    terrain,
    year,
    weather,
    daylight,
    train,
    animate,
):
    app.command(cls=FiniteCommand)(command)


def show_version(wanted: bool) -> None:
    """Print the version and leave."""
    if wanted:
        print(f"skydome {__version__}")
        raise typer.Exit


@app.callback(invoke_without_command=True)
def skydome(
    context: typer.Context,
    version: Annotated[
        bool, typer.Option("--version", callback=show_version, is_eager=True, help="Print the version and leave.")
    ] = False,
    max_memory: Annotated[  # taken off the line like --debug
        str, typer.Option(MEMORY, metavar="SIZE", help="Memory that one piece of work may take.")
    ] = "4G",
    debug: Annotated[  # taken off the line before it is read, wherever it stands
        bool, typer.Option(DEBUG, help="Show where in the program an error came from, before its line.")
    ] = False,
) -> None:
    """The light of the sky, from a place, a time and the air: maps, numbers and plots by the published models.

    Azimuth runs clockwise from north; angles are degrees here; luminance is in cd m-2, illuminance in lx.
    """
    if context.invoked_subcommand is None:
        print(context.get_help(), end="")


def run() -> None:
    """The console command: exit code 0, or 2 with one line on stderr for bad input."""
    end_on_signals()
    app(prog_name="skydome")
