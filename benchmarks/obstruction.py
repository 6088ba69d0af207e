"""Times of obstructed daylight, best of three, on this machine: python benchmarks/obstruction.py."""

import time

import numpy as np

import skydome as sd
from skydome import deg


def best(work, repeats=3):
    """Least wall time of a few runs, milliseconds."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return 1000 * min(times)


def court():
    """A floor of 20 m x 20 m with a block on it, 246 triangles or so."""
    corners = [[(-10, -10, 0), (10, -10, 0), (10, 10, 0), (-10, 10, 0)]]
    ring = [(-4, 4), (4, 4), (4, 7), (-4, 7)]
    corners.append([(*p, 6) for p in ring])
    corners += [[(*ring[i], 0), (*ring[i - 3], 0), (*ring[i - 3], 6), (*ring[i], 6)] for i in range(4)]
    faces = np.arange(len(corners))[:, None, None] * 4 + np.array([[0, 1, 2], [0, 2, 3]])
    return sd.MeshScene(np.reshape(corners, (-1, 3)), faces.reshape(-1, 3), 0.4).finer(3.0)


sky = sd.HosekWilkie(sd.direction(200 * deg, 40 * deg), turbidity=3.0)
hills = sd.Horizon(np.arange(36) * 10 * deg, np.random.default_rng(3).uniform(0, 40, 36) * deg)
view = sd.PlaneView.of(hills)
suns = sd.direction(np.linspace(1.8, 4.5, 365), np.linspace(0.2, 0.9, 365))[:, None, :]
year = sd.HosekWilkie(suns, turbidity=3.0)
street = sd.StreetCanyon(12.0, 12.0, 0.3, 0.2, 0.4)
scene = court()
print(f"south wall, 64 bands        {best(lambda: sd.Bands.of(sd.SOUTH, 64).illuminance(sky)):9.1f} ms")
print(f"view of 36 hills            {best(lambda: sd.PlaneView.of(hills)):9.1f} ms")
print(f"365 skies by that view      {best(lambda: view.receive(year)):9.1f} ms ({len(view.weights)} directions)")
print(f"nine harmonics              {best(lambda: sd.SphericalHarmonics.of(sky)):9.1f} ms")
print(f"patch means, 145            {best(lambda: sd.patch_means(sky)):9.1f} ms")
print(f"patch means, 2305           {best(lambda: sd.patch_means(sky, 'reinhart:4')):9.1f} ms")
print(f"street of 48 strips         {best(lambda: street.strip_light(sky), 1):9.1f} ms")
print(f"views of {len(scene.faces)} triangles x 3   {best(lambda: scene.face_views, 1):9.1f} ms")
