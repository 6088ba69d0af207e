"""The lowest versions that pyproject.toml allows, as pip's constraints, one a line.

Run: python scripts/lowest_versions.py [EXTRA ...] > lowest.txt
"""

import sys
import tomllib
from pathlib import Path

PROJECT = Path(__file__).parents[1] / "pyproject.toml"


def lowest(extras):
    """`name==bound` for each `name>=bound` of the default install and of the extras."""
    project = tomllib.loads(PROJECT.read_text("utf-8"))["project"]
    packages = [*project["dependencies"], *(p for extra in extras for p in project["optional-dependencies"][extra])]
    return sorted({package.replace(">=", "==") for package in packages if ">=" in package})


if __name__ == "__main__":
    print("\n".join(lowest(sys.argv[1:])))
