"""A scene of triangles against Radiance's rtrace, run in the test."""

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.surroundings.mesh import MeshScene

pytest.importorskip("trimesh")
pytest.importorskip("embreex")
pyradiance = pytest.importorskip("pyradiance")
PROGRAMS = Path(pyradiance.__file__).parent / "bin"
REFLECTANCE = 0.4
POINTS = np.array([[0.5, -2.0, 0.0], [3.0, 1.0, 0.0], [-6.0, 5.0, 0.0], [0.0, 4.0, 2.5], [6.0, -4.5, 3.0]])
NORMALS = np.array([[0, 0, 1], [0, 0, 1], [0, 0, 1], [0, -1, 0], [-1, 0, 0]], dtype=float)
SKIES = {
    "uniform": sd.Uniform(100.0),
    "overcast": sd.MoonSpencer(zenith_luminance=150.0),
    "clear": sd.CIEClear(sd.direction(200 * sd.deg, 40 * sd.deg), zenith_luminance=50.0),
}


def quads():
    """Corners (Q, 4, 3) of a court: a floor around two blocks, one low and wide, one tall."""

    def block(x0, y0, x1, y1, h):
        a, b, c, d = (x0, y0), (x1, y0), (x1, y1), (x0, y1)
        low, high = [(*p, 0.0) for p in (a, b, c, d)], [(*p, h) for p in (a, b, c, d)]
        return [high, *([low[i], low[(i + 1) % 4], high[(i + 1) % 4], high[i]] for i in range(4))]

    def floor(x0, y0, x1, y1):
        return [(x0, y0, 0.0), (x1, y0, 0.0), (x1, y1, 0.0), (x0, y1, 0.0)]

    floors = [floor(-10, -10, 6, 4), floor(9, -10, 10, 4), floor(6, -10, 9, -7), floor(6, -2, 9, 4)]
    floors += [floor(-10, 4, -4, 8), floor(4, 4, 10, 8)]
    return np.array([*floors, *block(-4, 4, 4, 8, 6.0), *block(6, -7, 9, -2, 9.0)])


def scene():
    corners = quads()
    faces = np.arange(len(corners))[:, None, None] * 4 + np.array([[0, 1, 2], [0, 2, 3]])
    return MeshScene(corners.reshape(-1, 3), faces.reshape(-1, 3), REFLECTANCE).finer(4.0)


def radiance_text():
    """The court in Radiance's words, under a glowing dome whose brightness is the sky's formula."""
    lines = [f"void plastic grey 0 0 5 {REFLECTANCE} {REFLECTANCE} {REFLECTANCE} 0 0"]
    for k, quad in enumerate(quads()):
        lines.append(f"grey polygon p{k} 0 0 12 " + " ".join(f"{x:g}" for x in quad.ravel()))
    lines += ["void brightfunc pattern 2 bright sky.cal 0 0", "pattern glow light 0 0 4 1 1 1 0"]
    lines += ["light source sky 0 0 4 0 0 1 180"]
    return "\n".join(lines)


def formula(name, sky):
    """The sky's luminance as a Radiance function of direction: written from the published formulas."""
    if name == "uniform":
        return f"bright = {sky.value};"
    if name == "overcast":
        return f"bright = {sky.zenith_luminance} * (1 + 2 * Dz) / 3;"
    x, y, z = sky.sun
    zenith = np.arccos(z)
    level = (0.91 + 10 * np.exp(-3 * zenith) + 0.45 * z**2) * (1 - np.exp(-0.32))
    return (
        f"g = acos(Dx * {x} + Dy * {y} + Dz * {z});\n"
        f"bright = {sky.zenith_luminance / level} * (0.91 + 10 * exp(-3 * g) + 0.45 * cos(g)^2)"
        " * (1 - exp(-0.32 / if(Dz - 0.01, Dz, 0.01)));"
    )


def traced(folder, name, sky):
    """Irradiance at the points by rtrace, in the units of the sky."""
    (folder / "sky.cal").write_text(formula(name, sky))
    (folder / "scene.rad").write_text(radiance_text())
    tree = subprocess.run([PROGRAMS / "oconv", "scene.rad"], cwd=folder, capture_output=True, check=True).stdout
    (folder / "scene.oct").write_bytes(tree)
    rays = "\n".join(" ".join(map(str, (*p + 1e-4 * n, *n))) for p, n in zip(POINTS, NORMALS, strict=True))
    accuracy = "-h -I -ab 6 -aa 0 -ad 8192 -as 0 -lw 1e-4 -lr -12 -n 2"
    command = [PROGRAMS / "rtrace", *accuracy.split(), "scene.oct"]
    told = subprocess.run(command, cwd=folder, input=rays.encode(), capture_output=True, check=True).stdout
    return np.array([float(line.split()[1]) for line in told.decode().splitlines()])


@pytest.fixture(scope="module")
def court():
    return scene()


@pytest.mark.slow
@pytest.mark.parametrize("name", SKIES)
def test_illuminance_in_a_court_is_that_of_rtrace(tmp_path, court, name):
    if not (PROGRAMS / "rtrace").exists() and not shutil.which("rtrace"):
        pytest.skip("pyradiance comes without rtrace here")
    sky = SKIES[name]
    ours = court.illuminance(sky, POINTS, NORMALS)
    theirs = traced(tmp_path, name, sky)
    assert (ours.reflected > 0.03 * ours.total).all()
    assert ours.reflected[3] > 0.1 * ours.total[3]
    np.testing.assert_allclose(ours.total, theirs, rtol=0.02)
