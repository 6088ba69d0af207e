"""The documentation holds: code runs, links lead somewhere, tables are what is measured now, commands parse."""

import importlib
import re
import shlex
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).parents[2]
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])
NAMES = [str(page.relative_to(ROOT)) for page in PAGES]
FIGURES = ROOT / "docs" / "figures"
LINK = re.compile(r"\]\(([^)\s]+)\)")
every_page = pytest.mark.parametrize("page", PAGES, ids=NAMES)


def blocks(page, *kinds):
    """Line number and code of a page's blocks, without those under a comment `<!-- not run: why -->`."""
    text = page.read_text()
    for found in re.finditer(r"^```(\w+)\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        above = text[: found.start()].rstrip().rsplit("\n", 1)[-1]
        if found[1] in kinds and not above.startswith("<!-- not run:"):
            yield text[: found.start()].count("\n") + 2, found[2]


@every_page
def test_python_blocks_run(page, tmp_path, monkeypatch):
    """All of a page's blocks in one namespace, as a reader would type them."""
    monkeypatch.chdir(tmp_path)
    # dataclasses look up their module: give the page one of its own
    name = "page_" + re.sub(r"\W", "_", str(page.relative_to(ROOT)))
    module = type(sys)(name)
    monkeypatch.setitem(sys.modules, name, module)
    for line, code in blocks(page, "python"):
        exec(compile("\n" * (line - 1) + code, str(page), "exec"), module.__dict__)


def test_the_blocks_are_found():
    assert len(list(blocks(ROOT / "docs" / "adding-a-model.md", "python"))) == 3  # and one that is not run
    assert sum(len(list(blocks(page, "python"))) for page in PAGES) > 10


@every_page
def test_links_and_images_exist(page):
    text = re.sub(r"```.*?```", "", page.read_text(), flags=re.DOTALL)
    for link in LINK.findall(text):
        if not link.startswith(("http://", "https://", "#", "mailto:")):
            assert (page.parent / link.split("#")[0]).exists(), f"{page.name} links to {link}"


def test_every_page_can_be_reached_from_the_index():
    index = ROOT / "docs" / "index.md"
    seen, waiting = set(), [index]
    while waiting:
        page = waiting.pop().resolve()
        if page in seen or not page.exists():
            continue
        seen.add(page)
        links = (link.split("#")[0] for link in LINK.findall(page.read_text()))
        waiting += [page.parent / link for link in links if link.endswith(".md") and not link.startswith("http")]
    lost = [name for page, name in zip(PAGES, NAMES, strict=True) if name.startswith("docs/") and page not in seen]
    assert not lost, f"add to docs/index.md: {lost}"


@pytest.mark.parametrize("picture", sorted(FIGURES.glob("*.png")), ids=lambda path: path.name)
def test_pictures_are_small_and_shown(picture):
    assert picture.stat().st_size < 300_000
    assert any(picture.name in page.read_text() for page in PAGES), f"no page shows {picture.name}"


def commands():
    for page, name in zip(PAGES, NAMES, strict=True):
        for _, code in blocks(page, "sh", "bash", "console"):
            for line in code.replace("\\\n", " ").splitlines():
                if line.lstrip("$ ").startswith("skydome "):
                    yield name, line.lstrip("$ ")


@pytest.mark.parametrize(("name", "line"), list(commands()), ids=lambda value: value[:60])
def test_command_lines_parse(name, line):
    """The real command line takes every option; nothing is run."""
    import typer

    from skydome.cli.main import app

    command, words = typer.main.get_command(app), shlex.split(line, comments=True)[1:]
    while hasattr(command, "commands"):
        command = command.commands[words.pop(0)]
    command.make_context(line, words)


def test_readme_has_command_lines():
    assert any(name == "README.md" for name, _ in commands())


def figure_module(name, monkeypatch):
    monkeypatch.syspath_prepend(str(FIGURES))
    return importlib.import_module(name)


MEASURED = {
    "targets": "targets.md",
    "preetham": "models/preetham.md",
    "hosek_wilkie": "models/hosek-wilkie.md",
    "sun_disc": "models/sun-disc.md",
    "eye": "eye.md",
}


@pytest.mark.slow
@pytest.mark.parametrize("name", MEASURED)
def test_measured_tables_are_what_is_measured_now(name, monkeypatch):
    """Every number printed is the number measured, to one unit of its last digit."""
    drawing, module = figure_module("drawing", monkeypatch), figure_module(name, monkeypatch)
    tables = module.tables()
    assert tables
    for key, fresh in tables.items():
        printed = drawing.printed(MEASURED[name], key)
        assert without_numbers(printed) == without_numbers(fresh), key
        for old, new in zip(numbers(printed), numbers(fresh), strict=True):
            assert abs(old[0] - new[0]) <= old[1] * 1.001, (key, old, new)


def numbers(text):
    """Each number with one unit of its last digit."""
    found = re.findall(r"\d[\d,]*(?:\.(\d+))?", text)
    values = [float(match.replace(",", "")) for match in re.findall(r"\d[\d,]*(?:\.\d+)?", text)]
    return [(value, 10.0 ** -len(digits)) for value, digits in zip(values, found, strict=True)]


def without_numbers(text):
    return re.sub(r"\d[\d,]*(?:\.\d+)?", "#", text)


def test_numbers_of_a_table():
    assert numbers("| 1,234 | 0.50 |") == [(1234.0, 1.0), (0.5, 0.01)]
    assert without_numbers("| 1,234 | 0.50 |") == "| # | # |"


@pytest.mark.parametrize("elevation", [2, 20, 45, 70])
@pytest.mark.parametrize("turbidity", [2.0, 4.0, 6.0])
def test_previews_keep_the_hue_of_a_blue_sky(elevation, turbidity, monkeypatch):
    """Less than half a degree of OKLab hue for blues, 7 for a sunset's oranges, which fade to white."""
    import skydome as sd
    from skydome.light.tone import Filmic, tone_mapped

    drawing, oklab_hue = figure_module("drawing", monkeypatch), figure_module("hosek_wilkie", monkeypatch).oklab_hue
    light, valid = drawing.dome_light(sd.HosekWilkie(drawing.sky_toward(elevation), turbidity), 96)
    source = light[valid]
    assert (source > 0).all()  # inside sRGB
    shown = tone_mapped(source * drawing.common_exposure([(light, valid)]), Filmic())
    coloured = np.ptp(shown, axis=-1) > 0.15 * shown.max(axis=-1)
    turn = np.abs((oklab_hue(shown) - oklab_hue(source) + 180) % 360 - 180)
    blue = coloured & (source[:, 2] > 1.2 * source[:, 0])
    assert blue.sum() > 50
    assert turn[blue].max() < 0.5
    assert turn[coloured].max() < 7
