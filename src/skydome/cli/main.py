"""The command `skydome`. Commands import what they need when they run, so that help is quick."""

import sys
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from skydome import __version__
from skydome.cli.commands.convert import convert
from skydome.cli.commands.glare import glare
from skydome.cli.commands.illuminance import illuminance
from skydome.cli.commands.light import light
from skydome.cli.commands.list_models import models
from skydome.cli.commands.plot import plot
from skydome.cli.commands.render import render
from skydome.cli.commands.shader import shader
from skydome.cli.commands.sun import sun
from skydome.cli.commands.terrain import terrain
from skydome.cli.commands.year import year
from skydome.cli.learning.animate import animate
from skydome.cli.learning.evaluate import evaluate
from skydome.cli.learning.fit import fit
from skydome.cli.learning.simulate import simulate
from skydome.cli.learning.train import train
from skydome.cli.options import target_help

BAD_INPUT, INTERRUPTED = 2, 130


class Commands(TyperGroup):
    """The group of commands; what goes wrong becomes one line on stderr and an exit code."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """The command that is called; its help names the renderers, which nothing else needs to know."""
        name, command, rest = super().resolve_command(ctx, args)
        if command is not None and not {"-h", "--help"}.isdisjoint(rest):
            for option in command.params:
                if option.name == "target":
                    vars(option)["help"] = target_help()
        return name, command, rest

    def main(self, *arguments: Any, **choices: Any) -> Any:
        """Run a command and exit: 0, 2 for bad input, 130 when interrupted."""
        try:
            code = super().main(*arguments, **(choices | {"standalone_mode": False}))
        except KeyboardInterrupt:
            code = INTERRUPTED
        except MemoryError as error:
            code = complain(memory_sentence(error))
        except OSError as error:
            code = complain(file_sentence(error))
        except (ValueError, TypeError, ImportError) as error:
            code = complain(str(error) or type(error).__name__)
        except Exception as error:
            if not hasattr(error, "format_message"):  # typer's own say what is wrong with the line
                raise
            code = complain(error.format_message())
        sys.exit(code if isinstance(code, int) else 0)


def memory_sentence(error: MemoryError) -> str:
    """What to say where memory does not suffice.

    >>> memory_sentence(MemoryError("Unable to allocate 224. GiB for an array with shape (100000, 200000, 3)"))
    'this needs more memory than there is, 224. GiB more at once; ask for fewer pixels, directions, hours or cells'
    """
    asked = str(error).removeprefix("Unable to allocate ").split(" for ")[0]
    size = f", {asked} more at once" if asked else ""
    return f"this needs more memory than there is{size}; ask for fewer pixels, directions, hours or cells"


def file_sentence(error: OSError) -> str:
    """What to say of a file that could not be read or written.

    >>> file_sentence(FileNotFoundError(2, "No such file or directory", "sky.exr"))
    'sky.exr: no such file or directory'
    """
    if error.strerror is None:
        return str(error) or type(error).__name__
    where = "" if error.filename is None else f"{error.filename}: "
    return where + error.strerror[:1].lower() + error.strerror[1:]


def complain(message: str) -> int:
    """Print one line on stderr; the exit code for bad input."""
    print("skydome:", " ".join(message.split()), file=sys.stderr)
    return BAD_INPUT


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
    glare,
    illuminance,
    evaluate,
    simulate,
    fit,
    terrain,
    year,
    train,
    animate,
):
    app.command()(command)


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
) -> None:
    """The light of the sky, from a place, a time and the air: maps, numbers and plots by every published model.

    Azimuth runs clockwise from north; angles are degrees here; luminance is in cd m-2, illuminance in lx.
    """
    if context.invoked_subcommand is None:
        print(context.get_help(), end="")


def run() -> None:
    """The console command: exit code 0, or 2 with one line on stderr for bad input."""
    app(prog_name="skydome")
