"""`python -m skydome.own_air.all_air FOLDER OUTPUT`: lessons made or gone on with, then both networks trained."""

import argparse
import sys


def main() -> int:
    """Exit code: 2 with one line for what is wrong."""
    from skydome.own_air.all_air.lessons import make_lessons
    from skydome.own_air.all_air.training import DAY, TWILIGHT, require_torch, train_rest

    parser = argparse.ArgumentParser(prog="python -m skydome.own_air.all_air", description=__doc__)
    parser.add_argument("folder", help="the lessons' folder; what is there is kept")
    parser.add_argument("output", help="the networks' file, .safetensors")
    parser.add_argument("--batches", type=int, default=51, help="of 16 airs each")
    parser.add_argument("--steps", type=int, default=18_000, help="of training, for each network")
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    try:
        require_torch()
        make_lessons(given.folder, given.batches, given.seed, report=lambda k, n, what: print(f"{what}: {k} of {n}"))
        day, twilight = (course._replace(steps=given.steps) for course in (DAY, TWILIGHT))
        print(
            train_rest(
                given.folder, given.output, day, twilight, given.seed, lambda name, loss: print(name, f"{loss:.5f}")
            )
        )
    except (ValueError, OSError, ImportError) as error:
        print(error, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
