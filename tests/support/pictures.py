"""Takes the pictures of docs/pictures: the real pages, the sample library, simulated raters.

make pictures
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, Page, sync_playwright

from app.persistence.engine import Database, make_engine
from tests.browser.conftest import CHROMIUM_ARGUMENTS, DESKTOP, PHONE, set_up_researcher
from tests.browser.participant import begin, step
from tests.support.server import Server
from tests.support.simulate import simulate

FOLDER = Path(__file__).resolve().parents[2] / "docs" / "pictures"
PARTICIPANTS = 28  # as many as took part in Förger's study
RESULTS = "/research/studies/emotion-in-walking"


def main() -> None:
    """Make all pictures anew."""
    FOLDER.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        server = prepared_server(Path(scratch))
        server.start()
        try:
            with sync_playwright() as playwright:
                chromium = shutil.which("chromium") or shutil.which("chromium-browser")
                browser = playwright.chromium.launch(
                    executable_path=chromium, args=CHROMIUM_ARGUMENTS
                )
                take_all(browser, server)
        finally:
            server.stop()


def prepared_server(folder: Path) -> Server:
    """A server with the sample library and answers of simulated participants."""
    environment = {**os.environ, "MANNER_DATA_DIRECTORY": str(folder)}
    subprocess.run([sys.executable, "-m", "app.cli", "prepare"], env=environment, check=True)
    database = Database(make_engine(f"sqlite:///{folder / 'manner.sqlite3'}"))

    def write(job: Any) -> Any:
        with database.writing() as db:
            done = job(db)
            db.commit()
            return done

    simulate(write, PARTICIPANTS)
    database.engine.dispose()
    return Server(folder)


def take_all(browser: Browser, server: Server) -> None:
    """Every picture, participant's pages first."""
    for name, viewport in (("desktop", DESKTOP), ("phone", PHONE)):
        page = browser.new_page(viewport=viewport)
        page.goto(f"{server.url}/studies/emotion-in-walking")
        shot(page, f"welcome-{name}")
        begin(page, server)
        for scale, value in enumerate((-2, -1, 1, -1)):
            step(page, scale, value).check(force=True)
        shot(page, f"trial-{name}")
        page.close()
    page = browser.new_page(viewport=DESKTOP)
    set_up_researcher(page, server)
    clip = walking_clip(page, server)
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        for name, path in (("library", "/library"), ("viewer", clip), ("results", RESULTS)):
            page.goto(server.url + path)
            shot(page, f"{name}-{scheme}", full=name == "results")
    page.emulate_media(color_scheme="light")
    page.goto(server.url)
    shot(page, "landing")


def walking_clip(page: Page, server: Server) -> str:
    """The address of the neutral walk's page."""
    clips = page.request.get(f"{server.url}/api/v1/clips").json()["clips"]
    return next(str(clip["page_url"]) for clip in clips if clip["name"] == "set_a_neutral")


def shot(page: Page, name: str, *, full: bool = False) -> None:
    """One picture, once everything on the page has arrived and the figures have been drawn."""
    page.wait_for_load_state("networkidle")
    page.wait_for_timeout(4000)
    page.screenshot(path=FOLDER / f"{name}.png", full_page=full)


if __name__ == "__main__":
    main()
