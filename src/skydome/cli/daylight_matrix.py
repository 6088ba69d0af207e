"""`skydome-mtx tape.wea > sky.mtx`: what `gendaymtx -s` prints, several times as fast, by NumPy alone."""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # halves the time that NumPy takes to start; nothing here needs more

import sys

USAGE = "usage: skydome-mtx [-m N] [-oa | -of] [-c R G B] tape.wea > sky.mtx"


def main(arguments: list[str] | None = None) -> int:
    """Write the matrix to stdout; exit code 0, or 2 with one line on stderr for bad input."""
    try:
        options = parsed(sys.argv[1:] if arguments is None else arguments)
        convert(*options)
    except (ValueError, OSError) as error:
        print("skydome-mtx:", error, file=sys.stderr)
        return 2
    return 0


def parsed(arguments: list[str]) -> tuple[str, int, bool, tuple[float, float, float] | None]:
    """Tape, division, whether binary, colour."""
    words = list(arguments)
    division, binary = 1, False
    colour: tuple[float, float, float] | None = None
    path: str | None = None
    while words:
        word = words.pop(0)
        if word == "-m" and words:
            division = int(words.pop(0))
        elif word in ("-oa", "-of"):
            binary = word == "-of"
        elif word == "-c" and len(words) > 2:
            colour = (float(words.pop(0)), float(words.pop(0)), float(words.pop(0)))
        elif word != "-s" and not word.startswith("-") and path is None:
            path = word
        elif word != "-s":
            raise ValueError(USAGE)
    if path is None or not 1 <= division <= 12:
        raise ValueError(USAGE)
    return path, division, binary, colour


def convert(path: str, division: int, binary: bool, colour: tuple[float, float, float] | None) -> None:
    """Read the tape, write the matrix."""
    from skydome.year import gendaymtx, matrix_text

    tape = gendaymtx.tape_of(path)
    light = gendaymtx.coloured(tape, division, colour or gendaymtx.SKY_COLOUR)
    shape = (144 * division**2 + 2, tape.hour.size)
    matrix_text.write(sys.stdout.buffer, light, shape, (tape.latitude, tape.longitude), binary, "skydome-mtx")


if __name__ == "__main__":
    sys.exit(main())
