"""How long an eye takes to look: a 1024 x 1024 view of a 2048 x 1024 map, the best of several runs."""

import time

import skydome as sd
from skydome import deg
from skydome.eye.bright_source import without_sources


def best(work, runs=5):
    """The shortest time of several runs, seconds; the first, which loads libraries, is left out."""
    work()
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


if __name__ == "__main__":
    sky = sd.HosekWilkie(sd.direction(180 * deg, 25 * deg), turbidity=3.0)
    environment = sd.render(sky + sd.SunDisc.of(sky), height=1024)
    view, eye = sd.Camera(170 * deg, 18 * deg), sd.Eye(60)
    print(f"look     {best(lambda: eye.look(environment, view)):.2f} s")
    print(f"suns     {best(lambda: without_sources(environment)):.2f} s")
    print(f"glare    {best(lambda: sd.glare(environment, view.azimuth, view.elevation)):.2f} s")
    print(f"sphere   {best(lambda: eye.on_sphere(environment), 2):.2f} s")
