"""The explorer in Chromium without a graphics card: first paint, and from a slider's event to pixels.

    python benchmarks/explorer.py            # a picture of 512 x 256, and the whole page of 1440 x 900

Clock times say something on idle cores only; the load is printed beside them.
"""

import os
import shutil
import statistics
import sys
import time

from playwright.sync_api import Browser, sync_playwright

from skydome.explorer.serving import page_server

FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking"]
WINDOWS = {"512 x 256": (892, 446), "page of 1440 x 900": (1440, 900)}
MODELS = ("physical", "hosek-wilkie", "cie-12", "neural-hosek-wilkie")

SLIDE = """async count => {
  const explorer = document.getElementById("skydome-explorer").explorer;
  const { gl } = explorer.stage.renderer;
  const slider = document.querySelector(".timeline input[type=range], input[type=range]");
  const input = [...document.querySelectorAll("input[type=range]")].find(each => each.closest(".hour")) ?? slider;
  const frame = () => new Promise(done => requestAnimationFrame(done));
  const pixel = new Uint8Array(4), found = [];
  const middle = (Number(input.min) + Number(input.max)) / 2;
  for (let k = 0; k < count; k++) {
    await frame();
    const drawn = explorer.took.length, begun = performance.now();
    input.value = String(middle + 6 * (k % 24));
    input.dispatchEvent(new Event("input", { bubbles: true }));
    await frame();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    const pixels = performance.now() - begun;
    await frame();
    found.push([pixels, performance.now() - begun, explorer.took[explorer.took.length - 1]]);
  }
  return found;
}"""


def quantiles(values: list[float]) -> str:
    """Median, and the best tenth, ms."""
    ordered = sorted(values)
    return f"{statistics.median(ordered):5.1f} (best tenth {ordered[len(ordered) // 10]:.1f})"


def opened(browser: Browser, address: str, size: tuple[int, int], query: str) -> tuple[object, float, float]:
    """A page at its first picture; seconds on the clock until then, and until the browser's first paint."""
    context = browser.new_context(viewport={"width": size[0], "height": size[1]}, bypass_csp=True)
    page = context.new_page()
    begun = time.perf_counter()
    page.goto(address + query, wait_until="commit")
    page.wait_for_function("document.getElementById('skydome-explorer')?.explorer?.took.length > 0")
    page.evaluate("() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    first = time.perf_counter() - begun
    paint = page.evaluate("performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? -1")
    return page, first, paint / 1000


def main() -> None:
    """Print the table."""
    flags = [*FLAGS, *sys.argv[1:]]
    with sync_playwright() as started, page_server() as server:
        browser = started.chromium.launch(executable_path=shutil.which("chromium"), args=flags)
        print(f"Chromium {browser.version}, load {os.getloadavg()[0]:.1f}")
        for name, size in WINDOWS.items():
            for model in MODELS:
                page, first, paint = opened(browser, server.address, size, f"?model={model}&time=15:00")
                page.evaluate(SLIDE, 5)
                rows = page.evaluate(SLIDE, 40)
                picture = page.evaluate(
                    "[document.querySelector('canvas').width, document.querySelector('canvas').height]"
                )
                pixels, shown, script = (quantiles(list(column)) for column in zip(*rows, strict=True))
                print(
                    f"{name}, {model}, picture {picture}: pixels {pixels}, next frame {shown}, script {script} ms; "
                    f"first picture {first:.2f} s, first paint {paint:.2f} s"
                )
                page.context.close()
        browser.close()


if __name__ == "__main__":
    main()
