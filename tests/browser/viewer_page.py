"""A tiny page with a viewer from the built bundle, under the same content policy as a real one."""

from __future__ import annotations

import functools
import http.server
import json
import shutil
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from playwright.sync_api import Page

DIST = Path(__file__).parents[2] / "static" / "dist"
POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; "
    "connect-src 'self' blob:; font-src 'self'; base-uri 'none'"
)

Show = Callable[[str], Page]


class _Handler(http.server.SimpleHTTPRequestHandler):
    """Files of a folder, under the policy of a page."""

    def end_headers(self) -> None:
        self.send_header("Content-Security-Policy", POLICY)
        super().end_headers()

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002 - the base's name
        """Stay quiet."""


@contextmanager
def serve(folder: Path, style: str) -> Iterator[str]:
    """Serve a folder with the bundle; give its address."""
    (folder / "page.css").write_text(style)
    (folder / "favicon.ico").write_bytes(b"")
    shutil.copytree(DIST, folder / "static")
    handler = functools.partial(_Handler, directory=str(folder))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_port}"
        finally:
            server.shutdown()
            thread.join()


def shower(page: Page, folder: Path, address: str, entry: str = "viewer") -> Show:
    """A function that opens a page with some markup and the script of an entry."""
    manifest = json.loads((folder / "static" / ".vite" / "manifest.json").read_text())
    built = manifest[f"src/entries/{entry}.ts"]
    sheets = "".join(
        f'<link rel="stylesheet" href="{href}">'
        for href in (*(f"/static/{name}" for name in built.get("css", [])), "/page.css")
    )

    def show(markup: str) -> Page:
        (folder / "page.html").write_text(
            '<!doctype html><html lang="en" data-theme="light"><meta charset="utf-8">'
            '<meta name="viewport" content="width=device-width"><title>Viewer</title>'
            f'{sheets}<body>{markup}<script type="module" src="/static/{built["file"]}"></script>'
            "</body></html>"
        )
        page.goto(f"{address}/page.html")
        return page

    return show


def until(page: Page, expression: str) -> None:
    """Wait for a condition. The page's policy forbids what Playwright's own way evaluates."""
    for _ in range(1200):
        if page.evaluate(expression):
            return
        page.wait_for_timeout(25)
    pytest.fail(f"never came true: {expression}")


def ready(page: Page) -> None:
    """Wait until every viewer of the page shows its motion."""
    until(
        page,
        "[...document.querySelectorAll('motion-viewer')].every((viewer) => viewer.duration > 0)",
    )
