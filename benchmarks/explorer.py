"""The explorer in Chromium without a graphics card: first paint, and from a slider's event to pixels.

    python benchmarks/explorer.py [FOLDER]     # the page of another checkout, to compare

A picture of 512 x 256, then the whole page of 1440 x 900. Clock times say something on idle cores only, so the
processor time of all of the browser's processes stands beside them, and the load.
"""

import os
import shutil
import statistics
import sys
import threading
import time
from functools import partial
from http.server import ThreadingHTTPServer
from importlib.resources import files
from pathlib import Path

from playwright.sync_api import Browser, Page, sync_playwright

from skydome.explorer.serving import LOOPBACK, Handler

FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking"]
WINDOWS = {"512 x 256": (868, 441), "page of 1440 x 900": (1440, 900)}
MODELS = ("physical", "hosek-wilkie", "cie-12", "neural-hosek-wilkie", "physical&clouds=cumulus&seed=7")
READY = "document.getElementById('skydome-explorer')?.explorer?.took.length > 0"
SETTLED = "document.getElementById('skydome-explorer').explorer.clouds?.settled ?? true"
FOLLOWED = "document.getElementById('skydome-explorer').explorer.clouds?.took ?? []"
EVENTS = 40

SLIDE = """async count => {
  const explorer = document.getElementById("skydome-explorer").explorer;
  const { gl } = explorer.stage.renderer;
  const input = document.querySelector("input.hour");
  const frame = () => new Promise(done => requestAnimationFrame(done));
  const pixel = new Uint8Array(4), found = [];
  for (let k = 0; k < count; k++) {
    await frame();
    const begun = performance.now();
    input.value = String(700 + 6 * (k % 24));
    input.dispatchEvent(new Event("input", { bubbles: true }));
    await frame();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    found.push([performance.now() - begun, explorer.took[explorer.took.length - 1]]);
    await frame();
  }
  return found;
}"""


def processor_seconds(name: str = "chrom") -> float:
    """Processor time so far of all processes below this one of that name."""
    parents, seconds = {}, {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            text = stat.read_text()
        except OSError:
            continue
        word, rest = text[text.index("(") + 1 : text.rindex(")")], text[text.rindex(")") + 2 :].split()
        parents[int(stat.parent.name)] = int(rest[1])
        seconds[int(stat.parent.name)] = (int(rest[11]) + int(rest[12])) * (name in word)

    def mine(process: int) -> bool:
        return process == os.getpid() or (process in parents and mine(parents[process]))

    return sum(value for process, value in seconds.items() if mine(process)) / os.sysconf("SC_CLK_TCK")


def opened(browser: Browser, address: str, size: tuple[int, int], query: str) -> tuple[Page, float, float]:
    """A page at its first picture; seconds on the clock until then, and until the browser's first paint."""
    context = browser.new_context(viewport={"width": size[0], "height": size[1]})
    page = context.new_page()
    begun = time.perf_counter()
    page.goto(address + query, wait_until="commit")
    while not page.evaluate(READY):
        time.sleep(0.01)
    page.evaluate("() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    first = time.perf_counter() - begun
    begun = time.perf_counter()
    while not page.evaluate(SETTLED):
        time.sleep(0.1)
    if "clouds" in query:
        maps = ", ".join(f"{ms / 1000:.1f}" for ms in page.evaluate(FOLLOWED))
        print(f"clouds at rest after {time.perf_counter() - begun:.1f} s more, their maps after {maps} s")
    paint = page.evaluate("performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? -1")
    page.wait_for_timeout(1500)
    return page, first, paint / 1000


def told(values: list[float]) -> str:
    """Median and best tenth, ms."""
    ordered = sorted(values)
    return f"{statistics.median(ordered):.1f} (best tenth {ordered[len(ordered) // 10]:.1f})"


def main() -> None:
    """Print a line for each window and model."""
    folder = sys.argv[1] if len(sys.argv) > 1 else str(files("skydome.explorer") / "page")
    server = ThreadingHTTPServer((LOOPBACK, 0), partial(Handler, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with sync_playwright() as started:
        browser = started.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        print(f"Chromium {browser.version}")
        for name, size in WINDOWS.items():
            for model in MODELS:
                address = f"http://{LOOPBACK}:{server.server_port}/"
                page, first, paint = opened(browser, address, size, f"?model={model}&time=15:00")
                page.evaluate(SLIDE, 5)
                spent = processor_seconds()
                rows = page.evaluate(SLIDE, EVENTS)
                spent = 1000 * (processor_seconds() - spent) / EVENTS
                pixels, script = (told(list(column)) for column in zip(*rows, strict=True))
                print(
                    f"{name}, {model}: pixels {pixels} ms, script {script} ms, processors {spent:.0f} ms; "
                    f"first picture {first:.2f} s, first paint {paint:.2f} s; load {os.getloadavg()[0]:.0f}"
                )
                if followed := page.evaluate(FOLLOWED)[4:]:
                    print(f"clouds follow the sun in {told(followed)} ms")
                page.context.close()
        browser.close()
    server.shutdown()


if __name__ == "__main__":
    main()
