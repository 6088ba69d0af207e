"""What the package says of itself, and what its source archive must hold."""

import re
import tomllib
from pathlib import Path

import skydome

ROOT = Path(skydome.__file__).parents[2]


def test_the_readme_links_to_files_that_are_there():
    links = set(re.findall(r"\]\(([^)]+)\)", (ROOT / "README.md").read_text("utf-8")))
    assert len(links) > 10
    assert [link for link in links if not (ROOT / link).exists()] == []


def test_the_citation_has_the_packages_version_and_licence():
    cited = dict(re.findall(r"^(version|license): (\S+)$", (ROOT / "CITATION.cff").read_text("utf-8"), re.MULTILINE))
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert cited == {"version": project["version"], "license": project["license"]}


def test_every_lower_bound_can_be_pinned():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert [package for package in project["dependencies"] if not re.fullmatch(r"[\w-]+>=[\d.]+", package)] == []
