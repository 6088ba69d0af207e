"""Run the notebooks and keep what they show: `python scripts/run_notebooks.py [NAME ...]`, else all of docs/notebooks.

A cell's last expression is shown as Jupyter shows it: by `_repr_html_`, `_repr_png_`, a figure, or as text. No Jupyter
is needed, so that tests run the same cells.
"""

import ast
import contextlib
import io
import json
import sys
from base64 import b64encode
from pathlib import Path

FOLDER = Path(__file__).parents[1] / "docs" / "notebooks"


def run_cell(code, names, title):
    """Run a cell: its text on stdout, and the value of its last expression, None where it ends with none."""
    tree = ast.parse(code)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    stream = io.StringIO()
    with contextlib.redirect_stdout(stream):
        exec(compile(tree, title, "exec"), names)
        value = None if last is None else eval(compile(ast.Expression(last.value), title, "eval"), names)
    return stream.getvalue(), None if code.rstrip().endswith(";") else value


def shown(value):
    """What Jupyter would show of a value, by media type."""
    figure = value.get_figure() if hasattr(value, "get_figure") else value
    if hasattr(figure, "savefig"):
        stream = io.BytesIO()
        figure.savefig(stream, format="png", dpi=72)
        return {"text/plain": [repr(value)], "image/png": b64encode(stream.getvalue()).decode()}
    told = {"text/plain": [repr(value)[:2000]]}
    for kind, method in (("image/png", "_repr_png_"), ("text/html", "_repr_html_")):
        answer = getattr(value, method, lambda: None)()
        if answer is not None:
            told[kind] = b64encode(answer).decode() if isinstance(answer, bytes) else [answer]
    if "text/html" in told:
        told.pop("image/png", None)
    return told


def run(path):
    """The notebook with the outputs of its cells."""
    book, names, count = json.loads(path.read_text("utf-8")), {"__name__": "__main__"}, 0
    for cell in book["cells"]:
        if cell["cell_type"] != "code":
            continue
        count += 1
        printed, value = run_cell("".join(cell["source"]), names, f"{path.name}, cell {count}")
        cell["execution_count"], cell["outputs"] = count, []
        if printed:
            cell["outputs"].append({"output_type": "stream", "name": "stdout", "text": [printed]})
        if value is not None:
            cell["outputs"].append(
                {"output_type": "execute_result", "execution_count": count, "metadata": {}, "data": shown(value)}
            )
    return book


def main(names):
    """Run and write."""
    for path in [FOLDER / f"{name}.ipynb" for name in names] or sorted(FOLDER.glob("*.ipynb")):
        path.write_text(json.dumps(run(path), indent=1, ensure_ascii=False) + "\n", "utf-8")
        print(f"{path.name}: {path.stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main(sys.argv[1:])
