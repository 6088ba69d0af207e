"""The explorer's page in a real browser: skips where Chromium or Playwright is missing."""

import base64
import json
import shutil
from contextlib import contextmanager

import numpy as np
import pytest

from skydome.explorer.serving import page_server

FLAGS = ("--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking")
READ = """async ({view, width, height, which}) => {
  const explorer = document.getElementById("skydome-explorer").explorer;
  const numbers = explorer.read(view, width, height, which);
  const bytes = new Uint8Array(numbers.buffer);
  let text = "";
  for (let k = 0; k < bytes.length; k += 32768) text += String.fromCharCode(...bytes.subarray(k, k + 32768));
  return btoa(text);
}"""
WHOLE = {"dome": False, "left": 0.0, "across": 2 * np.pi, "top": np.pi / 2, "down": np.pi, "aspect": 2.0}


def chromium():
    """The browser's path; the test skips without."""
    found = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if found is None:
        pytest.skip("needs Chromium")
    return found


class Page:
    """A page of the explorer, what it said on its console, and what it asked of others."""

    def __init__(self, page, address):
        self.page, self.address, self.said, self.asked = page, address, [], []
        page.on("console", lambda message: self.said.append(f"{message.type}: {message.text}"))
        page.on("pageerror", lambda error: self.said.append(f"error: {error}"))
        page.on("request", lambda request: self.asked.append(request.url))

    def open(self, query=""):
        """Go to an address and wait for the first picture."""
        self.page.goto(self.address + query)
        self.wait_for("document.getElementById('skydome-explorer').explorer?.took.length > 0")
        self.settle()
        return self

    def wait_for(self, expression):
        """Wait until an expression is true: asked from outside, as the page's own policy forbids `eval` within."""
        for _ in range(600):
            if self.page.evaluate(expression):
                return
            self.page.wait_for_timeout(50)
        raise TimeoutError(f"{expression} is not true after 30 s; the page said {self.said}")

    def settle(self):
        """Wait until the picture is at rest."""
        self.page.wait_for_timeout(60)
        self.page.evaluate("() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def change(self, **parts):
        """Change the state."""
        self.page.evaluate("parts => document.getElementById('skydome-explorer').explorer.change(parts)", parts)
        self.settle()

    def ask(self, expression):
        """A value of the explorer, as JSON."""
        code = f"() => JSON.stringify((explorer => {expression})(document.getElementById('skydome-explorer').explorer))"
        return json.loads(self.page.evaluate(code))

    def xyz(self, height, which=0):
        """XYZ of the whole map, north at the left edge, (height, 2 height, 3)."""
        wanted = {"view": WHOLE, "width": 2 * height, "height": height, "which": which}
        numbers = np.frombuffer(base64.b64decode(self.page.evaluate(READ, wanted)), "<f4")
        return numbers.reshape(height, 2 * height, 4)[..., :3]


@pytest.fixture(scope="session")
def browser():
    """A browser for all tests of the page."""
    playwright = pytest.importorskip("playwright.sync_api", reason="needs playwright")
    path = chromium()
    with playwright.sync_playwright() as started:
        made = started.chromium.launch(executable_path=path, args=list(FLAGS))
        yield made
        made.close()


@pytest.fixture(scope="session")
def served():
    """The page on loopback."""
    with page_server() as server:
        yield server.address


@pytest.fixture
def opened(browser, served):
    """Call with a query: the page there; at the end nothing may have gone wrong or elsewhere."""

    @contextmanager
    def context(**choices):
        made = browser.new_context(**({"viewport": {"width": 1280, "height": 800}} | choices))
        try:
            yield made
        finally:
            made.close()

    held, pages = [], []

    def open_page(query="", **choices):
        entered = context(**choices)
        held.append(entered)
        page = Page(entered.__enter__().new_page(), served)
        pages.append(page)
        return page.open(query)

    yield open_page
    for page in pages:
        assert page.said == []
        assert {url for url in page.asked if not url.startswith((served, "data:", "blob:"))} == set()
    for entered in held:
        entered.__exit__(None, None, None)
