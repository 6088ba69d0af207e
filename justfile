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

bench:
    python benchmarks/run.py
