"""An office with a window, as Radiance and as triangles: coefficients of six points on its desks, by pyradiance."""

import numpy as np
import pytest

import skydome as sd
from skydome.dome.patches import reinhart

WIDTH, DEPTH, HEIGHT = 3.6, 5.4, 2.8
WINDOW = (0.3, 3.3, 0.9, 2.4)
"""From, to across; sill, head."""
REFLECTANCE, ALBEDO = {"floor": 0.2, "walls": 0.5, "ceiling": 0.7}, 0.2
POINTS = np.array([(x, y, 0.85) for y in (0.9, 2.7, 4.5) for x in (0.9, 2.7)])
SUNS = 4

SKY = """#@rfluxmtx h=u u=Y
void glow ground_glow 0 0 4 1 1 1 0
ground_glow source ground 0 0 4 0 0 -1 180
#@rfluxmtx h=r1 u=Y
void glow sky_glow 0 0 4 1 1 1 0
sky_glow source sky 0 0 4 0 0 1 180
"""


def walls():
    """Name of its stuff and corners of each polygon, which faces the room; the window is a hole in the south."""
    w, d, h = WIDTH, DEPTH, HEIGHT
    left, right, sill, head = WINDOW
    yield "floor", [(0, 0, 0), (w, 0, 0), (w, d, 0), (0, d, 0)]
    yield "ceiling", [(0, 0, h), (0, d, h), (w, d, h), (w, 0, h)]
    yield "walls", [(0, d, 0), (w, d, 0), (w, d, h), (0, d, h)]
    yield "walls", [(0, 0, 0), (0, d, 0), (0, d, h), (0, 0, h)]
    yield "walls", [(w, 0, 0), (w, 0, h), (w, d, h), (w, d, 0)]
    for x0, x1, z0, z1 in ((0, w, 0, sill), (0, w, head, h), (0, left, sill, head), (right, w, sill, head)):
        yield "walls", [(x0, 0, z0), (x0, 0, z1), (x1, 0, z1), (x1, 0, z0)]


@pytest.fixture(scope="session")
def office_mesh():
    """The room as triangles of at most 1.4 m."""
    vertices, faces, shares = [], [], []
    for name, corners in walls():
        start = len(vertices)
        vertices += corners
        faces += [(start, start + 1, start + 2), (start, start + 2, start + 3)]
        shares += [REFLECTANCE[name]] * 2
    return sd.MeshScene(np.array(vertices, float), np.array(faces), np.array(shares), ALBEDO).finer(1.4)


def scene_text(black=False):
    lines = []
    for name, share in REFLECTANCE.items():
        grey = " ".join([str(0.0 if black else share)] * 3)
        lines.append(f"void plastic {name} 0 0 5 {grey} 0 0")
    for k, (name, corners) in enumerate(walls()):
        flat = " ".join(f"{value:g}" for corner in corners for value in corner)
        lines.append(f"{name} polygon p{k} 0 0 12 {flat}")
    return "\n".join(lines) + "\n"


@pytest.fixture(scope="session")
def office(tmp_path_factory, run_radiance):
    """Files of coefficients: total, direct, suns."""
    folder = tmp_path_factory.mktemp("office")
    (folder / "sky.rad").write_text(SKY)
    sensors = "".join(f"{x} {y} {z} 0 0 1\n" for x, y, z in POINTS).encode()
    settings = ["-I+", "-y", len(POINTS), "-lw", "4e-6", "-n", "1"]
    for name, black, more in (
        ("total", False, ["-ab", "5", "-ad", "30000"]),
        ("direct", True, ["-ab", "1", "-ad", "12000"]),
    ):
        (folder / f"{name}.rad").write_text(scene_text(black))
        arguments = [*settings, *more, "-", "sky.rad", f"{name}.rad"]
        text = run_radiance("rfluxmtx", *arguments, input=sensors, cwd=folder).stdout
        (folder / f"{name}.mtx").write_bytes(text)
    suns = ["void light solar 0 0 3 1e6 1e6 1e6"]
    centres = reinhart(SUNS).directions
    suns += [f"solar source sun{k} 0 0 4 {x:.8f} {y:.8f} {z:.8f} 0.533" for k, (x, y, z) in enumerate(centres)]
    (folder / "suns.rad").write_text("\n".join(suns) + "\n")
    tree = run_radiance("oconv", "direct.rad", "suns.rad", cwd=folder).stdout
    (folder / "suns.oct").write_bytes(tree)
    arguments = [
        "-I+",
        "-ab",
        "0",
        "-dj",
        "0",
        "-dc",
        "1",
        "-dt",
        "0",
        "-dp",
        "512",
        "-fo",
        "-y",
        len(POINTS),
        "-e",
        f"MF:{SUNS}",
    ]
    arguments += ["-f", "reinhart.cal", "-b", "rbin", "-bn", "Nrbins", "-m", "solar", "suns.oct"]
    (folder / "suns.mtx").write_bytes(run_radiance("rcontrib", *arguments, input=sensors, cwd=folder).stdout)
    return folder


@pytest.fixture(scope="session")
def desks():
    return POINTS
