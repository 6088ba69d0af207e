"""Twenty processes that begin one store at once, twenty times over: one makes it, the others take it, none fails."""

import os
import sys
import tempfile
from pathlib import Path

from tests.fuzz import kills

AT_ONCE = 20


def at_once(work, place):
    """The exit codes of forks that wait for one signal, a pipe that closes, and then do the work."""
    gate, opened = os.pipe()
    numbers = []
    for _ in range(AT_ONCE):
        number = os.fork()
        if not number:
            os.close(opened)
            os.read(gate, 1)
            try:
                work()
            except BaseException:
                kills.traceback.print_exc(file=(place / "fault.txt").open("a"))
                os._exit(1)
            os._exit(0)
        numbers.append(number)
    os.close(gate)
    os.close(opened)
    return [kills.ended(number) for number in numbers]


def run(times, folder, names=("simulate", "year")):
    """The faults of so many beginnings of each kind of store."""
    from skydome.own_air.grid import Grid, prepared
    from skydome.years.stores.sites import read_sites
    from skydome.years.stores.sites_store import open_store

    kills.prepare(folder)
    grid, (sites, *_) = Grid.load(folder / "grid.toml"), read_sites(folder / "sites.csv")
    kinds = {
        "simulate": lambda store: prepared(grid, store),
        "year": lambda store: open_store(store, sites, {}),
    }
    found = []
    for name, begin in ((name, kinds[name]) for name in names):
        for k in range(times):
            store = folder / f"{name}{k}.zarr"
            codes = at_once(lambda begin=begin, store=store: begin(store), folder)
            begin(store)  # what stands there is whole
            print(name, k, sum(map(bool, codes)), flush=True)
            if any(codes) or kills.left_over(folder):
                found.append((name, k, codes, kills.left_over(folder)))
    return found


if __name__ == "__main__":
    for library in kills.LIBRARIES:
        kills.import_module(library)
    with tempfile.TemporaryDirectory() as here:
        place = Path(here, "starts")
        faults = run(int(sys.argv[1]), place, sys.argv[2:] or ("simulate", "year"))
        told = place / "fault.txt"
        print(len(faults), "faults", *faults, told.read_text()[-2000:] if told.exists() else "", sep="\n")
    sys.exit(bool(faults))
