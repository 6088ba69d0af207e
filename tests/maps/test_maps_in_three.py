"""Our maps in a real three.js, in headless Chromium: the light that a white sphere has.

Skips where Chromium or an unpacked `three` (SKYDOME_THREE, fetched by .ci/run) is missing.
"""

import json
import os
import queue
import shutil
import subprocess
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.ground import exr

pytestmark = pytest.mark.slow

FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--disable-background-networking", "--disable-component-update", "--disable-sync", "--no-first-run",
)  # fmt: skip
PAGE = Path(__file__).parent / "sphere_in_three.html"
VIEWS = {"up": sd.ZENITH, "east": sd.EAST, "north": sd.NORTH, "south": sd.SOUTH, "south west": sd.direction(3.9, 0.5)}


class Handler(SimpleHTTPRequestHandler):
    """The folder of the test, three under /three, and what the page posts."""

    def __init__(self, *arguments, three, results, **named):
        self.three, self.results = three, results
        super().__init__(*arguments, **named)

    def translate_path(self, path):
        return f"{self.three}{path[6:]}" if path.startswith("/three/") else super().translate_path(path)

    def do_POST(self):
        self.results.put(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.send_response(204)
        self.end_headers()

    def log_message(self, *words):
        pass


@pytest.fixture
def in_three(tmp_path):
    """Call with a scene: what the page measured."""
    browser = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    three = os.environ.get("SKYDOME_THREE")
    if browser is None or not three or not Path(three, "build/three.module.js").exists():
        pytest.skip("needs Chromium, and SKYDOME_THREE: the unpacked npm package three")
    results = queue.Queue()
    server = ThreadingHTTPServer(
        ("127.0.0.1", 0), partial(Handler, directory=str(tmp_path), three=three, results=results)
    )
    threading.Thread(target=server.serve_forever, daemon=True).start()
    shutil.copy(PAGE, tmp_path / "page.html")

    def measured(scene):
        (tmp_path / "scene.json").write_text(json.dumps(scene))
        page = f"http://127.0.0.1:{server.server_port}/page.html"
        with subprocess.Popen(
            [browser, *FLAGS, f"--user-data-dir={tmp_path}/profile", "--remote-debugging-port=0", page],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        ) as process:  # fmt: skip
            try:
                found = results.get(timeout=180)
            finally:
                process.terminate()
        assert "error" not in found, found
        return found

    yield measured
    server.shutdown()
    server.server_close()


@pytest.mark.parametrize(
    ("elevation", "suffix", "tolerance"),
    [(40.0, ".exr", 0.01), (20.0, ".exr", 0.02), (8.0, ".exr", 0.03), (40.0, ".hdr", 0.01)],
)
def test_a_white_sphere_has_the_light_that_is_printed(in_three, tmp_path, elevation, suffix, tolerance):
    """By a light probe of nine harmonics, which the bright side of a low sun's sky tries most."""
    sun = sd.direction(200 * sd.deg, elevation * sd.deg)
    sky = sd.HosekWilkie(sun, 3.0)
    disc = sd.SunDisc.of(sky)
    calm = sd.render(sky, 256)
    whole = sky + disc
    ground = sd.render(whole, 32).pixels[-1, 0]
    calm.pixels[128:] = ground  # the ground is lit by the sun that three adds as a light
    calm.save(tmp_path / f"sky{suffix}", target="three")
    axes = sd.target("three").frame_vectors
    scene = {
        "file": f"sky{suffix}", "unit": 1e5, "sun": axes(sun).tolist(), "lux": float(disc.illuminance(sun)),
        "views": [axes(view).tolist() for view in VIEWS.values()],
    }  # fmt: skip
    found = in_three(scene)
    seen = np.array(found["seen"]) @ sd.SRGB.to_xyz[1] * 1e5 * np.pi
    expected = np.array([float(sd.illuminance(whole, view, ground_albedo=0.2)) for view in VIEWS.values()])
    np.testing.assert_allclose(seen, expected, rtol=tolerance)


def test_its_loaders_keep_the_sun(in_three, tmp_path):
    """Every texel below 65504, the sun's too: the loader clips nothing."""
    sun = sd.direction(200 * sd.deg, 60 * sd.deg)
    sky = sd.HosekWilkie(sun, 2.0)
    sd.render(sky + sd.SunDisc.of(sky), 1024).save(tmp_path / "sky.exr", target="three")
    pixels = exr.read(tmp_path / "sky.exr")[0]
    found = in_three({"file": "sky.exr", "unit": 1e5, "sun": [0, 1, 0], "lux": 0.0, "views": []})
    assert found["peak"] == pytest.approx(float(pixels.max()))
    assert 5000 < found["peak"] < 65504
