"""Sphinx, for `scripts/make_site.py`, which lays out the sources that this reads."""

import re
from pathlib import Path

VERSION = re.search(
    r'__version__ = "(.*?)"', (Path(__file__).parents[2] / "src" / "skydome" / "__init__.py").read_text("utf-8")
)[1]

project, author, copyright = "skydome", "The skydome authors", "the skydome authors, BSD-3-Clause"
version = release = VERSION
root_doc = "docs/index"
extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
exclude_patterns = ["src/**", "tests/**", "benchmarks/**", "README.md"]
myst_heading_anchors = 3
myst_enable_extensions = ["colon_fence"]
html_theme = "pydata_sphinx_theme"
html_title = f"skydome {VERSION}"
html_theme_options = {
    "navigation_with_keys": True,
    "show_nav_level": 1,
    "secondary_sidebar_items": ["page-toc"],
    "footer_start": ["copyright"],
    "footer_end": [],
    "logo": {"text": f"skydome {VERSION}"},
}
html_sidebars = {"docs/index": []}
html_show_sourcelink = False
suppress_warnings = ["misc.highlighting_failure"]
