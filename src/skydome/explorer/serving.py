"""The explorer's page on loopback: served by Python's own `http.server`, to this machine alone."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from http import HTTPStatus
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from importlib.resources import as_file, files
from pathlib import Path
from typing import Any

LOOPBACK = "127.0.0.1"
WEATHER = "weather.epw"
"""Name by which the page finds a weather file that was given."""
TYPES = {".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".epw": "text/plain"}


@dataclass(frozen=True)
class PageServer:
    """A server that runs: its `address`, and `wait`, which returns when it is stopped."""

    server: ThreadingHTTPServer
    thread: threading.Thread

    @property
    def address(self) -> str:
        """The page's address, with a stroke at its end."""
        return f"http://{LOOPBACK}:{self.server.server_port}/"

    def wait(self) -> None:
        """Stay until the server stops."""
        self.thread.join()


class Handler(SimpleHTTPRequestHandler):
    """The files of one folder, and one weather file, for requests that name this machine as their host."""

    def __init__(self, *arguments: Any, weather: Path | None = None, **named: Any) -> None:
        self.weather = weather
        super().__init__(*arguments, **named)

    def send_head(self) -> Any:
        """As the library's, but only for this machine's own names: other hosts' pages cannot ask through a browser."""
        host = (self.headers.get("Host") or "").rsplit(":", 1)[0]
        if host not in (LOOPBACK, "localhost"):
            self.send_error(HTTPStatus.FORBIDDEN, "only this machine is served")
            return None
        return super().send_head()

    def translate_path(self, path: str) -> str:
        """The file of a path: in the folder, or the weather file."""
        if self.weather is not None and path.split("?")[0] == f"/{WEATHER}":
            return str(self.weather)
        return super().translate_path(path)

    def list_directory(self, path: Any) -> None:
        """No lists of files."""
        self.send_error(HTTPStatus.NOT_FOUND, "no such page")

    def guess_type(self, path: Any) -> str:
        """The type by the name's end, whatever this machine's own tables say."""
        return TYPES.get(Path(path).suffix.lower(), "application/octet-stream")

    def end_headers(self) -> None:
        """Headers that keep the page to itself and fresh."""
        self.send_header("X-Content-Type-Options", "nosniff")
        self.send_header("Cross-Origin-Resource-Policy", "same-origin")
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()

    def log_message(self, *words: Any) -> None:
        """Say nothing of each request."""


@contextmanager
def page_server(port: int = 0, weather: Path | None = None) -> Iterator[PageServer]:
    """The page's server, stopped at the end; port 0 takes a free one. OSError where the port is taken.

    >>> from urllib.request import urlopen
    >>> with page_server() as server, urlopen(server.address) as page:
    ...     b"skydome-explorer" in page.read()
    True
    """
    with as_file(files("skydome.explorer") / "page") as folder:
        server = ThreadingHTTPServer((LOOPBACK, port), partial(Handler, directory=str(folder), weather=weather))
        thread = threading.Thread(target=server.serve_forever, daemon=True)
        thread.start()
        try:
            yield PageServer(server, thread)
        finally:
            server.shutdown()
            server.server_close()
