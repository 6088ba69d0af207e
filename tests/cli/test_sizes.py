"""Sizes on the command line: refused before any work, in one line; --max-memory allows more."""

import pytest


def test_the_command_line_grants_more_and_less(refused, call, tmp_path):
    asked = ("render", "--sun", "180,40", "-o", tmp_path / "a.exr", "--height")
    assert "at most 2147483648 texels in a map" in refused(*asked, 65536)
    assert "would take 6 GB of memory, 4 are allowed" in refused(*asked, 16384, "--scene", tmp_path / "a.usda")
    assert "must be a size such as 16G" in refused(*asked, 16, "--max-memory", "much")
    assert "64M at least" in refused(*asked, 16, "--max-memory")
    assert "0.0625 are allowed" in refused(*asked, 4096, "--max-memory", "64M")
    assert list(tmp_path.iterdir()) == []
    assert call(*asked, 16, "--max-memory", "64M").exit_code == 0


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (
            ("year", "EPW", "--colour", "preetham", "--wavelengths", "380,720,1e-9"),
            "at most 2000 wavelengths",
        ),
        (("terrain", "EPW", "--sun", "1,30", "--size", "16384,16384", "-o", "a.png"), "would take 12 GB"),
        (("animate", "IN", "-o", "OUT", "--frames", "1000000000"), "at most"),
        (("simulate", "EPW", "--workers", "99999", "-o", "OUT"), "less than or equal to 1024"),
    ],
)
def test_counts_that_nobody_needs(refused, tmp_path, words, message):
    (tmp_path / "in").mkdir()
    places = {"EPW": tmp_path / "none.npz", "IN": tmp_path / "in", "OUT": tmp_path / "out"}
    assert message in refused(*(places.get(word, word) for word in words))
