"""The public face: its stub and its page say what the code says, names are told of, type checkers catch slips."""

import doctest
import importlib.util
import inspect
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import skydome as sd

ROOT = Path(__file__).parents[1]
GENERATED = {"api.md", "decisions.md", "performance.md"}
"""Pages that list or justify; a name must be told of in another one."""

RIGHT = """
import skydome as sd

turin = sd.Place(latitude=45.07, longitude=7.69, altitude=240)
sun = sd.sun_direction(turin, "2026-06-21T15:00+02:00")
sky = sd.HosekWilkie(sun, turbidity=3.0, albedo=0.2)
sd.render(sky + sd.SunDisc.of(sky), height=64).save("sky.exr", target="blender")
print(sky.radiance(sd.ZENITH, [400, 550, 700]), sky.luminance(sd.direction(0.0, 30 * sd.deg)))
print(sd.load("sky.exr", target="blender").pixels.shape)
sd.year("site.epw", patches="reinhart:1")
reveal_type(sky)
reveal_type(sd.year)
reveal_type(sd.load("sky.exr"))
reveal_type(sd.fit(sd.HosekWilkie, sky.luminance(sd.ZENITH), sd.ZENITH))
reveal_type(sd.ZENITH)
"""
TENSORS = """
import jax
import jax.numpy as jnp
import torch
import skydome as sd

turbidity = torch.tensor(3.0, requires_grad=True)
sky = sd.HosekWilkie(sd.direction(torch.tensor(3.6), torch.tensor(0.5)), turbidity)
loss: torch.Tensor = sd.illuminance(sky)
views, density = sd.sample(sky, 5, seed=1)
print(sd.azimuth(views), sd.colour_temperature(sky.xyz(views)), loss.item())
light: jax.Array = sd.Preetham(sd.direction(jnp.asarray(3.6), 0.5), jnp.asarray(3.0)).luminance(jnp.asarray(sd.ZENITH))
"""
REVEALED = ("HosekWilkie", "def (", "EnvironmentMap", "Fit", "ndarray")
WRONG = """
import skydome as sd

sd.HosekWilke(sd.ZENITH)
sd.HosekWilkie(sd.ZENITH, turbidty=3)
sd.HosekWilkie(sd.ZENITH, 3.0, check="clip")
sd.rendr(sd.Uniform(1.0))
sd.render(height=32)
sd.Uniform(1.0).radiance(sd.ZENITH, [550.0])
sd.direction({}, 0.5)
"""
WRONG_LINES = [4, 5, 6, 7, 8, 9, 10]


def made():
    """The script that writes the stub and the page."""
    spec = importlib.util.spec_from_file_location("make_face", ROOT / "scripts" / "make_face.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_stub_and_the_page_are_fresh():
    script = made()
    assert script.STUB.read_text("utf-8") == script.stub(), "run `python scripts/make_face.py`"
    assert script.PAGE.read_text("utf-8") == script.page(), "run `python scripts/make_face.py`"


def test_every_public_name_resolves():
    for name in sd.__all__:
        assert getattr(sd, name) is not None
    assert set(sd.WHERE) <= set(dir(sd)) == set(sd.__all__)
    with pytest.raises(AttributeError, match="no attribute 'Skye'"):
        _ = sd.Skye


def test_no_public_name_is_a_room():
    rooms = {path.name for path in Path(sd.__file__).parent.iterdir() if path.is_dir()}
    assert not rooms & set(sd.__all__)


def test_a_star_brings_every_name():
    names = {}
    exec("from skydome import *", names)
    assert set(sd.__all__) <= set(names)


def test_classes_and_functions_are_ordinary_ones_with_their_own_signature():
    for name in sd.WHERE:
        value = getattr(sd, name)
        if inspect.isfunction(value) or inspect.isclass(value):
            assert value.__module__ == sd.WHERE[name], f"{name} lives in {value.__module__}"
    assert inspect.isfunction(sd.year)
    assert inspect.isfunction(sd.load)
    assert list(inspect.signature(sd.HosekWilkie).parameters)[:3] == ["sun", "turbidity", "albedo"]


def checked(tmp_path, code, *command):
    """Output of a type checker on a user's file."""
    file = tmp_path / "users.py"
    file.write_text(code)
    answer = subprocess.run([*command, str(file)], capture_output=True, text=True, cwd=tmp_path, check=False)
    return answer.stdout + answer.stderr


def error_lines(output):
    return sorted({int(found) for found in re.findall(r"users\.py:(\d+)(?::\d+)?(?: -)?:? error", output)})


CHECKERS = {
    "mypy": [sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent"],
    "pyright": ["pyright", "--pythonpath", sys.executable],
}


@pytest.fixture(autouse=True)
def one_cache_of_mypy(request, monkeypatch):
    """What mypy learnt of the libraries in an earlier test or run need not be learnt again."""
    monkeypatch.setenv("MYPY_CACHE_DIR", str(request.config.cache.mkdir("mypy")))


@pytest.mark.slow
@pytest.mark.parametrize("checker", CHECKERS)
def test_type_checkers_catch_slips_and_know_every_type(checker, tmp_path):
    pytest.importorskip("mypy")
    command = CHECKERS[checker]
    if shutil.which(command[0]) is None:
        pytest.skip(f"needs {checker}")
    right = checked(tmp_path, RIGHT, *command)
    assert error_lines(right) == [], right
    for line, wanted in zip(re.findall(r"users\.py:\d.*", right), REVEALED, strict=True):
        assert wanted in line or (wanted == "def (" and "-> " in line), line
        assert not re.search(r'(-> |is ")Any"$', line), line
    wrong = checked(tmp_path, WRONG, *command)
    assert error_lines(wrong) == WRONG_LINES, wrong
    assert "HosekWilke" in wrong
    assert "turbidty" in wrong


@pytest.mark.parametrize("name", list(sd.WHERE))
def test_a_public_name_opens_with_what_comes_out_and_shows_its_use(name):
    value = getattr(sd, name)
    if inspect.isfunction(value) or inspect.isclass(value):
        opening = inspect.cleandoc(value.__doc__).split("\n\n")[0]
        assert opening.endswith(".")
        assert not opening.startswith(("Return", "Compute", "Calculate", "Get "))
        assert doctest.DocTestParser().get_examples(value.__doc__), f"{name} shows no example"


def test_every_public_name_is_told_of_in_a_page():
    pages = [ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]
    text = "\n".join(page.read_text("utf-8") for page in pages if page.name not in GENERATED)
    told = {name for name in sd.WHERE if re.search(rf"\bsd\.{name}\b|`[^`\n]*\b{name}\b[^`\n]*`", text)}
    assert set(sd.WHERE) - told == set()


@pytest.mark.slow
@pytest.mark.parametrize("checker", CHECKERS)
def test_type_checkers_take_arrays_of_torch_and_jax(checker, tmp_path):
    for library in ("mypy", "torch", "jax"):
        pytest.importorskip(library)
    command = CHECKERS[checker]
    if shutil.which(command[0]) is None:
        pytest.skip(f"needs {checker}")
    output = checked(tmp_path, TENSORS, *command)
    assert error_lines(output) == [], output
