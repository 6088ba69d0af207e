# Daily commands; `just --list` shows them.

test:
    python -m pytest -n auto

quick:
    python -m pytest -n auto -m "not slow"

lint:
    ruff format --check .
    ruff check .

types:
    mypy

figures:
    for script in docs/figures/*.py; do python "$script"; done

# The documentation as a site in build/site; needs sphinx, myst-parser and pydata-sphinx-theme.
docs:
    python scripts/make_site.py

notebooks:
    python scripts/run_notebooks.py

bench:
    python benchmarks/run.py

fuzz times="20" seed="1":
    SKYDOME_FUZZ={{times}} SKYDOME_FUZZ_SEED={{seed}} python -m pytest -q tests/fuzz
