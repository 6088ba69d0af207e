"""The page's numbers are the package's, one by one; its built files lie in the package."""

import base64
import importlib.util
import json
import re
from importlib.resources import files
from pathlib import Path

import numpy as np

from skydome.explorer.address import VERSION
from skydome.skies.catalogue import CATALOGUE

ROOT = Path(__file__).parents[2]
DATA = ROOT / "explorer" / "src" / "data"
MOST_BYTES = 1_000_000


def exporter():
    """The script that writes the page's numbers."""
    spec = importlib.util.spec_from_file_location("export_explorer", ROOT / "scripts" / "export_explorer.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def pairs(found, wanted, where=""):
    """Numbers of two trees, side by side, as arrays."""
    if isinstance(wanted, dict) and "f4" in wanted:
        assert found["shape"] == wanted["shape"], where
        yield where, *(np.frombuffer(base64.b64decode(each["f4"]), "<f4") for each in (found, wanted))
    elif isinstance(wanted, dict):
        assert found.keys() == wanted.keys(), where
        for name in wanted:
            yield from pairs(found[name], wanted[name], f"{where}/{name}")
    elif isinstance(wanted, list) and any(isinstance(each, list | dict) for each in wanted):
        assert len(found) == len(wanted), where
        for k, each in enumerate(wanted):
            yield from pairs(found[k], each, f"{where}/{k}")
    elif isinstance(wanted, list | float) and not isinstance(wanted, bool) and np.asarray(wanted).dtype.kind in "fi":
        yield where, np.asarray(found, float), np.asarray(wanted, float)
    else:
        assert found == wanted, where


def test_every_number_of_the_page_is_the_packages():
    script = exporter()
    stored = json.loads((DATA / "tables.json").read_text("utf-8"))
    count = 0
    for where, found, wanted in pairs(stored, json.loads(json.dumps(script.tables()))):
        np.testing.assert_allclose(found, wanted, rtol=1e-6, atol=1e-9, err_msg=where)
        count += found.size
    assert count > 40_000


def test_the_pages_formulas_are_the_exporters():
    texts = exporter().texts()
    for name in ("formula.ts", "shaders.ts"):
        assert (DATA / name).read_text("utf-8") == texts[name]


def test_the_page_lies_in_the_package():
    import gzip

    page = files("skydome.explorer") / "page"
    sizes = {
        name: len(gzip.compress((page / name).read_bytes())) for name in ("index.html", "explorer.js", "explorer.css")
    }
    assert sum(sizes.values()) < MOST_BYTES
    text = (page / "explorer.js").read_text("utf-8")
    assert not re.search(r"(?:https?:)?//(?!www\.w3\.org/2000/svg)[a-z0-9-]+\.[a-z]{2,}/", text)


def test_its_models_are_of_the_catalogue():
    text = (ROOT / "explorer" / "src" / "skies" / "catalogue.ts").read_text("utf-8")
    named = set(re.findall(r'name: "([a-z-]+)"', text))
    assert named <= {model.name for model in CATALOGUE}
    assert f"VERSION = {VERSION};" in (ROOT / "explorer" / "src" / "page" / "state.ts").read_text("utf-8")
