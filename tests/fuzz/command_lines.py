"""Random command lines: what people write, what they mistype, and numbers from beyond, for every command and option."""

import json
import math
import random
from pathlib import Path

from typer.testing import CliRunner

SUNS = ["180,40", "240,5", "0,90", "100,0.5", "10,-3", "nan,40", "180", "a,b", "180,1e400", "", "-720,45", "180,91"]
PLACES = ["45.07,7.69", "-33.9,151.2,20", "90,0", "91,0", "nan,7", "45", "45,7,1e9", "", "0,180", "Turin"]
TIMES = [
    "2026-06-21T15:00+02:00",
    "2026-12-21T12:00+01:00",
    "2026-06-21T15:00",
    "noon",
    "9999-12-31T23:59+00:00",
    "0001-01-01T00:00+00:00",
    "2026-02-30T12:00+00:00",
    "1900-06-01T12:00Z",
    "",
]
NUMBERS = [
    "0",
    "1",
    "-1",
    "0.2",
    "3",
    "5.5",
    "10",
    "100",
    "800",
    "1e4",
    "1e9",
    "1e300",
    "-1e300",
    "nan",
    "inf",
    "-inf",
    "1e-300",
    "-0",
    "",
    "x",
    "0x10",
    "1_0",
    "284",
    "12",
]
WORDS = [
    "",
    "raise",
    "clamp",
    "nan",
    "paper",
    "gendaylit",
    "authors",
    "printed",
    "none.json",
    "x" * 300,
    "../..",
    "é",
    "\u200b",
]
MODELS = [
    "hosek-wilkie",
    "preetham",
    "perez",
    "perez-all-weather",
    "cie-1",
    "cie-12",
    "cie-15",
    "cie-clear",
    "cie-intermediate",
    "moon-spencer",
    "uniform",
    "neural",
    "neural-preetham",
    "nothing",
    "",
    "none.safetensors",
]
OUTPUTS = ["a.exr", "a.hdr", "a.png", "a.svg", "a.txt", "no/such/a.exr", "a", ".", "a.exr/", "x" * 300 + ".exr"]
SENSIBLE = {
    "-o": ["a.exr", "a.hdr", "a.png"],
    "--sun": SUNS[:4],
    "--model": MODELS[:2] + MODELS[4:13],
    "--height": ["16", "32", "64"],
    "--place": PLACES[:2],
    "--time": TIMES[:2],
    "--zone": ["UTC"],
    "--check": ["clamp"],
    "--chromaticity": ["0.33,0.33"],
    "--letters": ["-1,-0.32,10,-3,0.45"],
    "--illuminance": ["10000"],
    "--zenith-luminance": ["5000"],
    "--dni": ["700"],
    "--dhi": ["100"],
    "--dew-point": ["8"],
    "--plane": ["30,180"],
    "--normal": ["180,0"],
    "--lang": ["glsl", "wgsl"],
    "--target": ["native", "blender"],
    "--space": ["srgb"],
    "--ground": ["black", "0.3"],
    "--gamut": ["white"],
    "--white-luminance": ["1", "179"],
    "--max-memory": ["1G"],
    "--view": ["180,20"],
}
VALUES = {
    "--sun": SUNS,
    "--place": PLACES,
    "--time": TIMES,
    "--zone": ["Europe/Rome", "UTC", "Mars", "", "../etc/passwd"],
    "--model": MODELS,
    "--height": ["16", "32", "64", "63", "0", "-2", "1e3", "999999999999", "30000", "x"],
    "--letters": ["-1,-0.32,10,-3,0.45", "1,2,3", "nan,1,1,1,1", "1e300,-1,1,1,1", "0,0,0,0,0", "-5,-1,0,0,0"],
    "--chromaticity": ["0.3127,0.3290", "0,0", "nan,0.3", "0.9,0.9", "0.7,0.25", "1"],
    "--target": ["native", "blender", "mitsuba", "three", "cube", "nothing"],
    "--space": ["srgb", "rec2020", "acescg", "p3"],
    "--ground": ["black", "0.3", "2", "nan", "green"],
    "--gamut": ["white", "none", "x"],
    "--normal": SUNS,
    "--lang": ["glsl", "wgsl", "c", "cobol"],
    "--set": ["glow=1", "x=nan", "=", "glow"],
    "--until": ["1%", "0", "nan", "2"],
    "--plane": ["30,180", "181,0", "nan,0", "90,0"],
    "--profile": ["none.csv"],
    "--light": ["xyz", "rgb", "450,550", "x", "nan"],
    "--paths": ["1", "0", "-5"],
    "--tables": ["none.npz"],
    "--label": ["end", "x"],
    "--shift": ["auto", "nan", "1e400"],
    "--check": ["raise", "clamp", "nan", "x"],
    "--max-memory": ["1G", "64M", "x", "1"],
}
FLAGS = ["--json", "--no-sun", "--refraction", "--half", "--smooth", "--bands", "--debugg", "--help", "--version"]
COMMANDS = {
    "light": ["--sun", "--model"],
    "sun": ["--place", "--time"],
    "render": ["--sun", "--height", "-o"],
    "shader": ["--sun", "--model"],
    "illuminance": ["--sun", "--plane"],
    "models": [],
    "convert": ["-o"],
    "year": [],
    "glare": ["--view"],
    "terrain": ["-o"],
    "fit": ["-o"],
    "train": ["-o"],
    "simulate": ["-o"],
    "evaluate": [],
    "animate": ["-o"],
    "plot": ["--sun", "-o"],
    "weather": ["--plot"],
    "daylight": ["-o"],
    "": [],
}
FILES_FIRST = ("convert", "year", "glare", "terrain", "fit", "simulate", "evaluate", "animate", "weather", "daylight")
WEIGHTS = [8, 3, 8, 3, 4, 1, 2, 2, 1, 1, 1, 1, 1, 1, 1, 2, 1, 1, 1]


class Lines:
    """Command lines drawn from a seed; `options` are those of each command, by the application itself."""

    def __init__(self, seed):
        from typer.main import get_command

        from skydome.cli.main import app

        self.random = random.Random(seed)
        group = get_command(app)
        self.options = {
            name: [option for parameter in command.params for option in parameter.opts if option.startswith("--")]
            for name, command in group.commands.items()
        }

    def value(self, option):
        """A value, often of the option's own kind."""
        if option in ("-o", "--output"):
            return self.random.choice(OUTPUTS)
        if self.random.random() < self.sense:
            return self.random.choice(SENSIBLE.get(option, ["0.2", "1", "3"]))
        kinds = VALUES.get(option, NUMBERS)
        return self.random.choice(kinds if self.random.random() < 0.9 else NUMBERS + WORDS)

    def line(self):
        """The words of one command line."""
        command = self.random.choices(list(COMMANDS), WEIGHTS)[0]
        self.sense = self.random.choice([0.3, 0.8, 0.95])
        known = [option for option in self.options.get(command, []) if option not in ("--json", "--help")]
        asked = [option for option in COMMANDS[command] if self.random.random() < 0.95]
        asked += self.random.sample(known, min(len(known), self.random.choice([0, 0, 1, 1, 2, 3])))
        words = [command] if command else []
        if command in FILES_FIRST:
            words.append(self.random.choice(["none.exr", "none.epw", ".", "none.npz", "x" * 300]))
        for option in asked:
            words.append(option)
            if self.random.random() < 0.97:
                words.append(self.value(option))
        if self.random.random() < 0.4:
            words.append(self.random.choice(FLAGS))
        return words


def unsound(value):
    """True where facts hold light below 0 or beyond all numbers."""
    if isinstance(value, dict):
        return any(
            unsound(inner) or (name.endswith(("_lx", "_cd_m2")) and isinstance(inner, float) and not inner >= 0)
            for name, inner in value.items()
        )
    if isinstance(value, list):
        return any(map(unsound, value))
    return isinstance(value, float) and not math.isfinite(value)


def fault(words, folder):
    """What is wrong with how a line ends, "" for nothing; files that it wrote are removed."""
    before = set(Path().rglob("*"))
    answer = CliRunner().invoke(app_of(), words)
    new = [path for path in Path().rglob("*") if path not in before]
    for path in sorted(new, reverse=True):  # what is in a folder before it
        path.rmdir() if path.is_dir() else path.unlink()
    lines = [
        line for line in answer.stderr.splitlines() if not line.startswith(("skydome: warning", "skydome: compiling"))
    ]
    if answer.exit_code not in (0, 2):
        return f"exit code {answer.exit_code}: {answer.exception!r}"
    if answer.exit_code == 2 and (len(lines) != 1 or not lines[0].startswith("skydome: ")):
        return f"{len(lines)} lines: {answer.stderr[-500:]}"
    if "please report" in answer.stderr or "Traceback" in answer.stderr:
        return answer.stderr[-300:]
    if answer.exit_code == 2 and new:
        return f"left behind: {new}"
    text = answer.stdout.lower()
    if answer.exit_code == 0 and "nan" not in words and not {"--help", "models", "shader"} & set(words):
        if " nan " in text or " inf " in text or "-inf" in text:
            return answer.stdout[-500:]
        if "--json" in words and text.startswith("{") and unsound(json.loads(answer.stdout)):
            return answer.stdout[-800:]
    return ""


def app_of():
    """The application."""
    from skydome.cli.main import app

    return app


def run(count, seed=0, report=lambda done: None):
    """The faults of so many lines, each with its words, in the current folder."""
    lines, found = Lines(seed), []
    for k in range(count):
        words = lines.line()
        if wrong := fault(words, Path()):
            found.append((words, wrong))
        report(k + 1)
    return found


if __name__ == "__main__":
    import os
    import sys
    import tempfile

    count, seed = int(sys.argv[1]), int(sys.argv[2])
    with tempfile.TemporaryDirectory() as here:
        os.chdir(here)
        for k in range(0, count, 50):  # told as they come: a long run may be ended
            faults = run(50, f"{seed} {k}")
            print(k + 50, "lines", len(faults), "faults", *faults, sep="\n", flush=True)
        os.chdir("/")
