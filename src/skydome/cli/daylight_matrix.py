"""`skydome-mtx tape.wea > sky.mtx`: what `gendaymtx` prints, several times as fast, by NumPy alone."""

import gc
import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # halves the time that NumPy takes to start; nothing here needs more

import sys
from typing import Any, BinaryIO, Literal, NamedTuple

from skydome.cli.endings import DEBUG, FORESEEN, complain, end_on_signals, ending, leave_at_once, sentence_of

PROGRAM = "skydome-mtx"
USAGE = (
    "usage: skydome-mtx [-v] [-h] [-A] [-d | -s | -n] [-u] [-D file [-M file]] [-5 degrees] [-r degrees] [-i minutes] "
    "[-m N] [-g R G B] [-c R G B] [-oa | -of | -od] [-O0 | -O1] [tape.wea | site.epw] > sky.mtx; "
    "or many files with --folder matrices"
)
BLACK = (0.0, 0.0, 0.0)


class Asked(NamedTuple):
    """The options of the command line, by gendaymtx's letters; the tape comes from standard input without a path.

    With a `folder` the matrix of each of the `paths` is a file of its name there.
    """

    path: str = "-"
    paths: tuple[str, ...] = ("-",)
    folder: str = ""
    division: int = 1
    numbers: Literal["ascii", "float", "double"] = "ascii"
    header: bool = True
    matrix: bool = True
    mean: bool = False
    sun: bool = True
    disc: float = 0.0
    colour: tuple[float, float, float] | None = (0.960, 1.004, 1.118)
    ground: tuple[float, float, float] = (0.2, 0.2, 0.2)
    rotation: float = 0.0
    minutes: float = 0.0
    solar: bool = False
    sun_hours: bool = False
    suns: str = ""
    modifiers: str = ""
    aloud: bool = False


FLAGS: dict[str, dict[str, Any]] = {
    "-s": {"sun": False},
    "-d": {"colour": None, "ground": BLACK},
    "-n": {"matrix": False, "colour": None, "ground": BLACK, "division": 1},
    "-A": {"mean": True},
    "-u": {"sun_hours": True},
    "-v": {"aloud": True},
    "-oa": {"numbers": "ascii"},
    "-of": {"numbers": "float"},
    "-od": {"numbers": "double"},
    "-O0": {"solar": False},
    "-O1": {"solar": True},
    "-h": {"header": False},
}
VALUES = {"-m": "division", "-5": "disc", "-r": "rotation", "-rz": "rotation", "-i": "minutes"}
LIMITS = {
    "-m": (1, 12), "-5": (0, 179), "-r": (-1e6, 1e6), "-rz": (-1e6, 1e6), "-i": (0, 1440), "-c": (0, 1e6), "-g": (0, 1),
}  # fmt: skip
COLOURS = {"-c": "colour", "-g": "ground"}
FILES = {"-D": "suns", "-M": "modifiers", "--folder": "folder"}


def main(arguments: list[str] | None = None) -> int:
    """Write the matrix to stdout; exit code 0, or 2 with one line on stderr for bad input."""
    end_on_signals()
    if arguments is None:
        gc.disable()  # a program of a tenth of a second makes no garbage worth looking for: 10 ms
    with ending(PROGRAM, debug=DEBUG in sys.argv):
        words = sys.argv[1:] if arguments is None else arguments
        asked = parsed([word for word in words if word != DEBUG])
        if asked.folder:
            convert_many(asked)
        else:
            convert(asked, sys.stdout.buffer)
    if arguments is None:
        leave_at_once()
    return 0


def say(words: str) -> None:
    """A line on stderr."""
    complain(PROGRAM, words)


def parsed(arguments: list[str]) -> Asked:
    """The options read, one after another; ValueError with the usage for what is none."""
    words, asked, paths = list(arguments), Asked(), []
    while words:
        word = words.pop(0)
        count = 1 if word in VALUES or word in FILES else 3 if word in COLOURS else 0
        given, words = words[:count], words[count:]
        if len(given) < count:
            raise ValueError(USAGE)
        if word == "-" or not word.startswith("-"):
            paths.append(word)
        else:
            asked = asked._replace(**meaning(word, given))
    if asked.division not in range(1, 13) or (len(paths) > 1 and not asked.folder):
        raise ValueError(USAGE)
    paths = paths or ["-"]
    return asked._replace(division=int(asked.division), path=paths[0], paths=tuple(paths))


def meaning(word: str, given: list[str]) -> dict[str, Any]:
    """What an option with its words asks for; ValueError with the usage for none."""
    if word in FLAGS:
        return FLAGS[word]
    if word in FILES:
        return {FILES[word]: given[0]} | (FLAGS["-n"] if word == "-D" and given[0] == "-" else {})
    if not given:
        raise ValueError(USAGE)
    numbers = tuple(number_of(word, number) for number in given)
    return {COLOURS[word]: numbers} if word in COLOURS else {VALUES[word]: numbers[0]}


def number_of(option: str, text: str) -> float:
    """A number that the option may have; ValueError in one line for any other."""
    low, high = LIMITS[option]
    try:
        number = float(text)
    except ValueError:
        number = float("nan")
    if not low <= number <= high:
        wanted = "be three numbers" if option in COLOURS else "be a number"
        raise ValueError(f"{option} must {wanted} in [{low:g}, {high:g}], got {text}")
    return number


def convert_many(asked: Asked) -> None:
    """Write the matrix of every tape into the folder, each whole or not at all; ValueError if some could not be done.

    Those that fail are told one by one, and the others are done.
    """
    from pathlib import Path

    from skydome.ground.writing import appearing

    names = [Path(path).stem for path in asked.paths]
    twice = sorted({name for name in names if names.count(name) > 1})
    if "-" in asked.paths:
        raise ValueError("--folder needs one file or more to read (tape.wea or site.epw), got none or standard input")
    if twice or asked.suns:
        got = ", ".join(twice) or f"-D {asked.suns}"
        raise ValueError(f"--folder takes files of different names, without -D, got {got}")
    Path(asked.folder).mkdir(parents=True, exist_ok=True)
    failed = 0
    for name, path in zip(names, asked.paths, strict=True):
        try:
            with appearing(Path(asked.folder) / f"{name}.mtx") as beside, beside.open("wb") as file:
                convert(asked._replace(path=path), file)
        except (OSError, *FORESEEN) as error:
            failed += 1
            say(sentence_of(error))
    if failed:
        raise ValueError(f"{failed} of {len(names)} files could not be done")


def convert(asked: Asked, file: BinaryIO) -> None:
    """Read the tape, write the suns, and the matrix into `file`."""
    from skydome.years.gendaymtx import matrix as gendaymtx
    from skydome.years.gendaymtx.sun import Sun

    if asked.path == "-" and sys.stdin.isatty():
        raise ValueError(USAGE)
    sun = (Sun.disc(asked.disc) if asked.disc else Sun()) if asked.sun else None
    colour = asked.colour if asked.colour and max(asked.colour) > 0 else None
    choices: Any = gendaymtx.Choices(colour, asked.ground, sun, asked.solar, asked.rotation, asked.minutes)
    tape = tape_at(asked)
    if asked.aloud:
        say(f"{tape.hour.size} time steps at {tape.latitude:.1f} degrees north, {-tape.longitude:.1f} west")
    if asked.suns:
        write_suns(tape, choices, asked)
    if asked.matrix:
        write_matrix(tape, choices, asked, file)


def tape_at(asked: Asked) -> Any:
    """The tape of a file of any kind, or of standard input; missing hours are counted on stderr."""
    from skydome.years.gendaymtx.hours import in_the_sky, sun_of, tape_from, tape_of
    from skydome.years.weather.tape import is_tape
    from skydome.years.weather.text import text_of

    text = text_of(asked.path)
    if is_tape(text):
        tape = tape_of(text)
    else:
        from skydome.years.weather.closure import aligned
        from skydome.years.weather.reading import read_text

        tape = tape_from(aligned(read_text(text)))
    lacking = tape.missing.nonzero()[0]
    if lacking.size:
        first = lacking[0]
        say(
            f"{lacking.size} of {tape.hour.size} hours have no irradiance and are black; the first is month "
            f"{tape.month[first]:g}, day {tape.day[first]:g}, {tape.hour[first]:g} h"
        )
    return tape.rows(in_the_sky(sun_of(tape, asked.minutes)[0])) if asked.sun_hours else tape


def write_suns(tape: Any, choices: Any, asked: Asked) -> None:
    """Write the light sources of `-D`, and the names of their modifiers."""
    from pathlib import Path

    from skydome.ground.writing import appearing
    from skydome.years.gendaymtx.suns import sources

    pairs = list(sources(tape, choices))
    for path, texts in ((asked.suns, [pair[0] for pair in pairs]), (asked.modifiers, [pair[1] for pair in pairs])):
        if path == "-":
            sys.stdout.write("".join(texts))
        elif path:
            with appearing(Path(path)) as beside:
                beside.write_text("".join(texts), encoding="ascii")


def write_matrix(tape: Any, choices: Any, asked: Asked, file: BinaryIO) -> None:
    """Write the matrix, or the mean of its columns."""
    from skydome.years.gendaymtx import matrix as gendaymtx
    from skydome.years.gendaymtx import text as matrix_text

    if not tape.hour.size:
        raise ValueError(f"{asked.path}: no hour is left to make a sky of")
    light: Any = gendaymtx.coloured(tape, asked.division, choices)
    count = tape.hour.size
    if asked.mean:
        light, count = (part.mean(axis=1, dtype="float64", keepdims=True) for part in light), 1
    shape, place = (144 * asked.division**2 + 2, count), (tape.latitude, tape.longitude)
    maker = PROGRAM if asked.header else ""
    matrix_text.write(file, light, shape, place, asked.numbers, maker)


if __name__ == "__main__":
    sys.exit(main())
