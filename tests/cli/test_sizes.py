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


def test_long_tables_are_refused_in_a_short_line(refused, tmp_path):
    """A table of 1.9 million sites took 1.5 GB and a line of 100 MB; a list of settings all its numbers."""
    long, many = tmp_path / "long.csv", tmp_path / "many.csv"
    long.write_text("name,file\n" + "a,a.wea\n" * 100_001)
    assert refused("year", long, "-o", tmp_path / "a.zarr").endswith("at most 100000 sites in long.csv, got 100001\n")
    many.write_text("name,file\n" + "a,a.wea\n" * 1000)
    assert len(refused("year", many, "-o", tmp_path / "a.zarr")) < 2100
    grid = tmp_path / "grid.toml"
    grid.write_text(f"turbidities = [{'1,' * 1000}1]")
    assert len(refused("simulate", grid, "-o", tmp_path / "a.zarr")) < 200
    grid.write_text("x = 1 #" + " " * (1 << 20))
    assert "may take 1 MB" in refused("simulate", grid, "-o", tmp_path / "a.zarr")
