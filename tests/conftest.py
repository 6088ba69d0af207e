"""Parallel workers leave each other the cores: linear algebra takes one thread in each.

Workers whose small matrix products use a thread for each core wait for one another, up to 30 times as long. The
variables are set before the workers start, since a plugin may load NumPy before any file of tests.

`in_three` opens a page with three.js in a real browser without a window, for the tests of several rooms.
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

import pytest

FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--disable-background-networking", "--disable-component-update", "--disable-sync", "--no-first-run",
)  # fmt: skip


def pytest_configure(config):
    if config.getoption("numprocesses", None):
        for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
            os.environ.setdefault(name, "1")


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
    """Call with a page (a path) that lies in a folder with what it loads: what the page posted.

    Skips where Chromium or an unpacked `three` (SKYDOME_THREE, fetched by .ci/run) is missing.
    """
    browser = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    three = os.environ.get("SKYDOME_THREE")
    if browser is None or not three or not Path(three, "build/three.module.js").exists():
        pytest.skip("needs Chromium, and SKYDOME_THREE: the unpacked npm package three")
    results = queue.Queue()
    server = ThreadingHTTPServer(
        ("127.0.0.1", 0), partial(Handler, directory=str(tmp_path), three=three, results=results)
    )
    threading.Thread(target=server.serve_forever, daemon=True).start()

    def posted(page):
        shutil.copy(page, tmp_path / "page.html")
        address = f"http://127.0.0.1:{server.server_port}/page.html"
        with subprocess.Popen(
            [browser, *FLAGS, f"--user-data-dir={tmp_path}/profile", "--remote-debugging-port=0", address],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        ) as process:  # fmt: skip
            try:
                found = results.get(timeout=180)
            finally:
                process.terminate()
        assert "error" not in found, found
        return found

    yield posted
    server.shutdown()
    server.server_close()
