"""Sixteen threads at once in every kind of compiled work: the light of one, and nobody aborts."""

import subprocess
import sys
import warnings
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace

import numpy as np
import pytest

import skydome as sd
from skydome.ground import compiled
from skydome.land.elevation import Elevation

pytest.importorskip("numba")
SUN = np.array([0.0, 0.6, 0.8])
HILL = Elevation(200 * np.exp(-((np.mgrid[-10:10, -10:10] / 4.0) ** 2).sum(0)), 100.0, 100.0)
VIEWS = sd.direction(*np.random.default_rng(0).uniform((0, 0.1), (6, 1.5), (2000, 2)).T).astype(np.float32)


def seen_land():
    camera = sd.Camera(above_ground=100, elevation=-0.1, width=24, height=16)
    return sd.render_terrain(HILL, camera, sd.Preetham(SUN, 3.0), samples=1).rgb


JOBS = {
    "maps of formulas": lambda: sd.render(sd.HosekWilkie(SUN, 3.0), 512).pixels,
    "maps of networks": lambda: sd.render(sd.NeuralSky.load("hosek-wilkie", SUN, 3.0, albedo=0.2), 512).pixels,
    "held skies": lambda: sd.render(sd.PhysicalSky(SUN), 256).pixels,
    "paths": lambda: sd.PathTraced(SUN, relative_error=0.3).luminance(sd.ZENITH[None]),
    "land": seen_land,
    "haze": lambda: sd.aerial_perspective(sd.Preetham(SUN, 3.0), 1e4, VIEWS).inscattered,
}


@pytest.mark.parametrize("name", JOBS)
def test_sixteen_threads_give_the_light_of_one(name):
    alone = np.asarray(JOBS[name]())
    with ThreadPoolExecutor(16) as pool:
        together = list(pool.map(lambda _: np.asarray(JOBS[name]()), range(16)))
    assert all(np.array_equal(each, alone) for each in together)


def test_no_threading_layer_is_started():
    """Numba's plainest one, workqueue, ends the process when two threads enter: here none is ever entered."""
    code = "\n".join(
        [
            "import numba, numpy as np, skydome as sd",
            "sd.render(sd.HosekWilkie(np.array([0.0, 0.6, 0.8]), 3.0), 512)",
            "try: print(numba.threading_layer())",
            "except ValueError: print('none')",
        ]
    )
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "none\n"


def broken(*given):
    raise EOFError("Ran out of input")


def test_a_damaged_cache_costs_time_not_the_work():
    cleared = []
    cache = SimpleNamespace(load_overload=broken, save_overload=broken, flush=lambda: cleared.append(1))
    compiled.forgiving(cache)
    assert cache.load_overload(1, 2) is None
    assert cleared == [1]
    with pytest.warns(UserWarning, match="name a folder that can be written to in NUMBA_CACHE_DIR"):
        cache.save_overload(1, 2)


def test_a_cache_that_cannot_be_written_is_told(monkeypatch):
    import numba

    made = numba.njit

    def njit(cache=False, **choices):
        if cache:
            raise RuntimeError("cannot cache function: no locator available")
        return made(**choices)

    monkeypatch.setattr(numba, "njit", njit)
    with pytest.warns(UserWarning, match="compiled code cannot be kept here"):
        add = compiled.compiled(lambda a, b: a + b)
    assert add(1, 2) == 3


def test_compiling_is_heard():
    with compiled.compiling() as seconds, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        heard = []
        assert seconds() == 0
        function = compiled.compiled(lambda x: x * 3 + 1, cache=False)
        with ThreadPoolExecutor(1) as pool:
            done = pool.submit(function, 2.0)
            while not done.done():
                heard.append(seconds())
        assert done.result() == 7
        assert max(heard) > 0
        assert seconds() == 0
