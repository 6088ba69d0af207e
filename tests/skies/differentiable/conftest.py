"""One of every sky, made from a multiplier and a sun in any array library."""

import importlib.util
from pathlib import Path

spec = importlib.util.spec_from_file_location("catalogue", Path(__file__).parents[1] / "catalogue.py")
catalogue = importlib.util.module_from_spec(spec)
spec.loader.exec_module(catalogue)


def pytest_generate_tests(metafunc):
    if "make" in metafunc.fixturenames:
        metafunc.parametrize("make", catalogue.SKIES.values(), ids=catalogue.SKIES.keys())
