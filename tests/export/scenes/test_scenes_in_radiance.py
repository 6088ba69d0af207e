"""The Radiance scene in Radiance itself: what the level ground receives, and a ball's shadow."""

import numpy as np
import pytest

import skydome as sd

pytestmark = pytest.mark.slow

BRIGHTNESS = np.array([0.265, 0.670, 0.065])  # of its RGB, src/common/color.h
BALL = "void plastic black\n0\n0\n5 0 0 0 0 0\n\nblack sphere ball\n0\n0\n4 0 0 1 0.3\n"


def irradiance(folder, points, ball=False, **choices):
    """lx on the level ground at points (N, 2) east and north, by `rtrace`."""
    pyradiance = pytest.importorskip("pyradiance")
    files = [str(folder / "the sky.rad")]
    if ball:
        (folder / "ball.rad").write_text(BALL)
        files.append(str(folder / "ball.rad"))
    (folder / "octree").write_bytes(pyradiance.oconv(*files, warning=False))
    rays = "\n".join(f"{x} {y} 0 0 0 1" for x, y in points).encode()
    words = [word for name, value in choices.items() for word in (f"-{name}", str(value))]
    given = pyradiance.rtrace(rays, str(folder / "octree"), header=False, irradiance=True, params=words)
    return np.array([line.split()[:3] for line in given.decode().splitlines()], float) @ BRIGHTNESS * 179


@pytest.fixture
def folder(sky, tmp_path, monkeypatch):
    """A scene whose picture has a blank in its name, beside it."""
    sd.save_scene(sky.whole, tmp_path / "the sky.rad", height=256)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_ground_has_the_light_that_is_printed(sky, folder):
    given = irradiance(folder, [(0.0, 0.0)], ab=1, ad=16384, lw=1e-6, aa=0, dc=1)
    assert given[0] == pytest.approx(sky.level, rel=0.01)


def test_shadows_fall_away_from_the_sun(sky, folder):
    place = np.linspace(-2, 2, 129)
    east, north = np.meshgrid(place, place)
    given = irradiance(folder, np.column_stack([east.ravel(), north.ravel()]), ball=True, ab=0, dj=0)
    assert sky.shadow_azimuth(given, east.ravel(), north.ravel()) == pytest.approx(sky.shadow, abs=0.5)
