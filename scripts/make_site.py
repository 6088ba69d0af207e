"""The documentation as a site: `python scripts/make_site.py [FOLDER]` (default: build/site), warnings as errors.

The pages of `docs/` as they are, the notebooks with what they showed, a reference page a room from the public names'
own docstrings, and the figures with the scripts that drew them. Needs sphinx, myst-parser and pydata-sphinx-theme.
"""

import inspect
import json
import re
import shutil
import subprocess
import sys
from base64 import b64decode
from itertools import groupby
from pathlib import Path

import skydome

ROOT = Path(__file__).parents[1]
SOURCES = ROOT / "build" / "site-sources"
CHAPTERS = {
    "Start": "units-and-frame sun colour targets recipes phrases explorer",
    "Uses": "sunlight aerial-perspective daylight obstruction eye differentiate shaders neural captured",
    "Behind it": "adding-a-model evaluation errata performance decisions versions",
}
"""Which pages a chapter begins with; those that none names follow in the last."""


def lay_out():
    """Copy what the pages are and what they link to."""
    shutil.rmtree(SOURCES, ignore_errors=True)
    kept = shutil.ignore_patterns("__pycache__", "*.npz", "*.safetensors", "*.png~", "data")
    for folder in ("docs", "src", "tests", "benchmarks", "scripts"):
        shutil.copytree(ROOT / folder, SOURCES / folder, ignore=kept)
    for page in ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "LICENSE", "CITATION.cff", "justfile"):
        shutil.copy(ROOT / page, SOURCES)


def notebook_page(path):
    """A notebook as a page: its text, its cells and what they showed; its pictures beside it."""
    book, parts = json.loads(path.read_text("utf-8")), []
    for number, cell in enumerate(book["cells"]):
        text = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            parts.append(text)
            continue
        parts.append(f"```python\n{text}\n```")
        parts += [output_of(output, path, number) for output in cell["outputs"]]
    parts.append(f"[This page as a notebook]({path.name})")
    return "\n\n".join(parts) + "\n"


def output_of(output, path, number):
    """One output of a cell: HTML, a picture or text."""
    data = output.get("data", {})
    if "text/html" in data:
        return "".join(data["text/html"])
    if "image/png" in data:
        picture = path.with_name(f"{path.stem}-{number}.png")
        picture.write_bytes(b64decode(data["image/png"]))
        return f"![]({picture.name})"
    return "```text\n" + "".join(output.get("text") or data["text/plain"]).rstrip() + "\n```"


def safe(text):
    """Prose of a docstring as Markdown: what is no code stands as it is written."""
    pieces = re.split(r"(`[^`]*`)", text)
    return "".join(p if p.startswith("`") else re.sub(r"([*_<\[\]$|~^])", r"\\\1", p) for p in pieces)


def body_of(docstring):
    """A docstring as Markdown: paragraphs, and examples as code."""
    parts = []
    for paragraph in re.split(r"\n\s*\n", docstring.strip()):
        parts.append(f"```pycon\n{paragraph}\n```" if paragraph.lstrip().startswith(">>>") else safe(paragraph))
    return "\n\n".join(parts)


class Named:
    """What a signature shows in place of a value."""

    def __init__(self, name):
        self.name = name

    def __repr__(self):
        return self.name


def signature_of(value):
    """Its call, without the types, public constants by their names; "" for what is not called."""
    try:
        found = inspect.signature(value)
    except (TypeError, ValueError):
        return ""
    empty, constants = inspect.Parameter.empty, {id(getattr(skydome, name)): name for name in skydome.WHERE}
    bare = []
    for parameter in found.parameters.values():
        default = parameter.default
        if default is not empty and (id(default) in constants or len(repr(default)) > 60):
            default = Named(constants.get(id(default), f"{type(default).__name__}(...)"))
        if parameter.name != "self":
            bare.append(parameter.replace(annotation=empty, default=default))
    return re.sub(r" at 0x\w+", "", str(found.replace(parameters=bare, return_annotation=empty)))


def members_of(kind):
    """Public methods and properties that a class itself tells of, in its own order."""
    for name, member in vars(kind).items():
        function = member.fget if isinstance(member, property) else getattr(member, "__func__", member)
        if not name.startswith("_") and inspect.isfunction(function) and function.__doc__:
            call = "" if isinstance(member, property) else re.sub(r"^\(cls(, )?", "(", signature_of(function))
            yield name, call, inspect.getdoc(function)


def entry(name):
    """A public name's part of its room's page."""
    value = getattr(skydome, name)
    told = inspect.getdoc(value) if callable(value) else None
    lines = [f"## {name}", f"```python\nskydome.{name}{signature_of(value) if callable(value) else ''}\n```"]
    lines.append(body_of(told) if told else f"A constant of `{skydome.WHERE[name]}`.")
    if inspect.isclass(value):
        lines += [f"**`{member}{call}`**\n\n{body_of(text)}" for member, call, text in members_of(value)]
    return "\n\n".join(lines) + "\n"


def reference():
    """A page a room, grouped as the face is; their names."""
    folder, pages = SOURCES / "docs" / "reference", []
    folder.mkdir()
    for room, names in groupby(skydome.WHERE, lambda name: skydome.WHERE[name].split(".")[1]):
        page = folder / f"{room}.md"
        text = "" if page.exists() else f"# {room}\n\nPublic names of `skydome.{room}`.\n"
        with page.open("a", encoding="utf-8") as file:
            file.write("\n".join([text, *map(entry, names)]))
        pages += [] if room in pages else [room]
    return [f"reference/{room}" for room in pages]


def gallery():
    """The figures, each with the script that drew it."""
    parts = [
        "# Figures\n\nEvery figure of these pages with the script that drew it; `just figures` draws them again.\n"
    ]
    for script in sorted((ROOT / "docs" / "figures").glob("*.py")):
        code = script.read_text("utf-8")
        pictures = [name for name in re.findall(r"[\w-]+\.png", code) if (script.parent / name).exists()]
        if pictures:
            shown = "\n".join(f"![{name}](figures/{name})" for name in dict.fromkeys(pictures))
            parts.append(f"## {script.stem}\n\n{shown}\n\n[The script](figures/{script.name})\n")
    (SOURCES / "docs" / "gallery.md").write_text("\n".join(parts), "utf-8")


def chapters(reference_pages):
    """A page a chapter, and on the front page the chapters: every page stands in one."""
    docs = SOURCES / "docs"
    every = {p.relative_to(docs).with_suffix("").as_posix() for p in docs.rglob("*.md")} - {"index"}
    left = sorted(every - set(reference_pages) - {"api", "gallery"})
    named = {title: names.split() for title, names in CHAPTERS.items()}
    notebooks, models = ([p for p in left if p.startswith(f"{folder}/")] for folder in ("notebooks", "models"))
    told = {page for pages in (*named.values(), notebooks, models) for page in pages}
    lost = [page for page in left if page not in told]
    named = {"Notebooks": notebooks, "Models": models} | named
    named["Behind it"] += [*lost, "../CHANGELOG", "../CONTRIBUTING", "gallery"]
    named["Reference"] = ["api", *reference_pages]
    for title, pages in named.items():
        (docs / f"{file_of(title)}.md").write_text(f"# {title}\n\n{toctree(pages)}", "utf-8")
    index = docs / "index.md"
    index.write_text(f"{index.read_text('utf-8')}\n{toctree(map(file_of, named), ':hidden:')}", "utf-8")


def file_of(title):
    """The page of a chapter."""
    return "chapter-" + title.lower().replace(" ", "-")


def toctree(pages, *options):
    """A table of contents."""
    return "\n".join(["```{toctree}", ":maxdepth: 1", *options, "", *pages, "```", ""])


def main(folder):
    """Lay out and build; the exit code of Sphinx."""
    lay_out()
    for path in (SOURCES / "docs" / "notebooks").glob("*.ipynb"):
        path.with_suffix(".md").write_text(notebook_page(path), "utf-8")
    for page in (SOURCES / "docs").rglob("*.md"):
        page.write_text(re.sub(r"(\]\(\S*notebooks/\w+)\.ipynb", r"\1.md", page.read_text("utf-8")), "utf-8")
    gallery()
    chapters(reference())
    words = ["-W", "--keep-going", "-q", "-b", "html", "-c", str(SOURCES / "docs" / "site"), str(SOURCES), str(folder)]
    return subprocess.run([sys.executable, "-m", "sphinx", *words], cwd=SOURCES, check=False).returncode


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build" / "site").resolve()))
