"""`skydome-mtx tape.wea > sky.mtx`: what `gendaymtx` prints, several times as fast, by NumPy alone."""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # halves the time that NumPy takes to start; nothing here needs more

import sys
from typing import Any, NamedTuple

USAGE = (
    "usage: skydome-mtx [-m N] [-s | -d] [-5 degrees] [-c R G B] [-g R G B] [-r degrees] [-O0 | -O1] [-h] [-oa | -of] "
    "tape.wea|site.epw > sky.mtx"
)


class Asked(NamedTuple):
    """The options of the command line, by gendaymtx's letters."""

    path: str = ""
    division: int = 1
    binary: bool = False
    header: bool = True
    sky: bool = True
    sun: bool = True
    disc: float = 0.0
    colour: tuple[float, ...] | None = None
    ground: tuple[float, ...] | None = None
    rotation: float = 0.0
    solar: bool = False


FLAGS: dict[str, dict[str, Any]] = {
    "-s": {"sun": False, "sky": True},
    "-d": {"sky": False, "sun": True},
    "-oa": {"binary": False},
    "-of": {"binary": True},
    "-O0": {"solar": False},
    "-O1": {"solar": True},
    "-h": {"header": False},
}
VALUES = {"-m": ("division", 1), "-5": ("disc", 1), "-r": ("rotation", 1), "-rz": ("rotation", 1)}
COLOURS = {"-c": ("colour", 3), "-g": ("ground", 3)}


def main(arguments: list[str] | None = None) -> int:
    """Write the matrix to stdout; exit code 0, or 2 with one line on stderr for bad input."""
    try:
        convert(parsed(sys.argv[1:] if arguments is None else arguments))
    except (ValueError, OSError) as error:
        print("skydome-mtx:", error, file=sys.stderr)
        return 2
    return 0


def parsed(arguments: list[str]) -> Asked:
    """The options read; ValueError with the usage for what is none."""
    words, asked = list(arguments), Asked()
    while words:
        word = words.pop(0)
        name, count = (VALUES | COLOURS).get(word, ("", 0))
        if word in FLAGS:
            asked = asked._replace(**FLAGS[word])
        elif name and len(words) >= count:
            numbers = tuple(float(words.pop(0)) for _ in range(count))
            given: dict[str, Any] = {name: numbers if word in COLOURS else numbers[0]}
            asked = asked._replace(**given)
        elif not word.startswith("-") and not asked.path:
            asked = asked._replace(path=word)
        else:
            raise ValueError(USAGE)
    if not asked.path or asked.division not in range(1, 13):
        raise ValueError(USAGE)
    return asked._replace(division=int(asked.division))


def convert(asked: Asked) -> None:
    """Read the tape, write the matrix."""
    from skydome.years.gendaymtx import matrix as gendaymtx
    from skydome.years.gendaymtx import text as matrix_text
    from skydome.years.gendaymtx.sun import Sun

    if asked.path.lower().endswith(".epw"):
        from skydome.years.weather.reading import read_weather

        tape = gendaymtx.tape_from(read_weather(asked.path))
    else:
        tape = gendaymtx.tape_of(asked.path)
    given: dict[str, Any] = {name: getattr(asked, name) for name in ("colour", "ground") if getattr(asked, name)}
    if not asked.sky:
        given["colour"] = None
    sun = (Sun.disc(asked.disc) if asked.disc else Sun()) if asked.sun else None
    choices = gendaymtx.Choices(**given, sun=sun, solar=asked.solar, rotation=asked.rotation)
    light = gendaymtx.coloured(tape, asked.division, choices)
    shape, place = (144 * asked.division**2 + 2, tape.hour.size), (tape.latitude, tape.longitude)
    matrix_text.write(sys.stdout.buffer, light, shape, place, asked.binary, "skydome-mtx" if asked.header else "")


if __name__ == "__main__":
    sys.exit(main())
