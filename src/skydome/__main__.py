"""`python -m skydome` is the command `skydome`."""

from skydome.cli.main import run

if __name__ == "__main__":
    run()
