"""The page on differentiating the sky: its examples run, one after another, and find what they say."""

import re
from pathlib import Path

import pytest

import skydome as sd

PAGE = Path(__file__).parents[2] / "docs" / "differentiate.md"


@pytest.mark.slow
def test_every_example_runs(capsys):
    pytest.importorskip("torch")
    pytest.importorskip("jax")
    names = {}
    for block in re.findall(r"```python\n(.*?)```", PAGE.read_text("utf-8"), re.DOTALL):
        exec(compile(block, str(PAGE), "exec"), names)
    found, truth = names["found"], names["truth"]
    assert abs(float(found.turbidity.detach()) - truth.turbidity) < 0.1
    assert float(sd.angle_between(found.sun.detach().numpy(), truth.sun)) < 0.5 * sd.deg
    assert names["slopes"].shape == (3,)
    assert "one more turbidity" in capsys.readouterr().out
