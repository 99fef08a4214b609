"""Takes the pictures of docs/pictures: the real pages, the sample library, simulated raters.

make pictures
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from datetime import timedelta
from pathlib import Path
from typing import Any

from playwright.sync_api import BrowserContext, Page, sync_playwright
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.persistence.engine import Database, make_engine
from app.persistence.models import StudySession
from tests.browser.conftest import CHROMIUM_ARGUMENTS, DESKTOP, PHONE, set_up_researcher
from tests.browser.participant import begin, step
from tests.support import pictures_of_spaces
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
                take_all(browser.new_context(), server)
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
    write(take_their_time)
    database.engine.dispose()
    return Server(folder)


def take_their_time(db: Session) -> None:
    """Simulated participants answer at once; let each have begun some minutes earlier."""
    for index, session in enumerate(db.scalars(select(StudySession))):
        session.consented_at -= timedelta(minutes=8 + index % 7, seconds=7 * index)


def take_all(context: BrowserContext, server: Server) -> None:
    """Every picture, participant's pages first."""
    # Without a graphics card the viewer would choose its plain shading.
    context.add_init_script("sessionStorage.setItem('manner-tier', 'full')")
    for name, viewport in (("desktop", DESKTOP), ("phone", PHONE)):
        page = context.new_page()
        page.set_viewport_size(viewport)
        page.goto(f"{server.url}/studies/emotion-in-walking")
        shot(page, f"welcome-{name}")
        begin(page, server)
        for scale, value in enumerate((-2, -1, 1, -1)):
            step(page, scale, value).check(force=True)
        page.evaluate("document.querySelector('.panel-scroll').scrollTo(0, 0)")
        shot(page, f"trial-{name}")
        page.context.clear_cookies()
        page.close()
    page = context.new_page()
    page.set_viewport_size(DESKTOP)
    set_up_researcher(page, server)
    clip = walking_clip(page, server)
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        for name, path in (("library", "/library"), ("viewer", clip), ("results", RESULTS)):
            page.goto(server.url + path)
            shot(page, f"{name}-{scheme}", full=name == "results")
        studio(page, server, clip, f"studio-{scheme}")
    page.emulate_media(color_scheme="light")
    take_the_rest(page, server, clip)
    pictures_of_spaces.take(page, server, shot)


def take_the_rest(page: Page, server: Server, clip: str) -> None:
    """The pages that are pictured in the light only."""
    for name, path in (("graph", "/graphs/sample"), ("sets", "/research/sets"), ("landing", "/")):
        page.goto(server.url + path)
        if name == "sets":
            page.get_by_role("button", name="Förger’s 20").click()
        shot(page, name)
    page.set_viewport_size(PHONE)
    studio(page, server, clip, "studio-phone")
    page.set_viewport_size(DESKTOP)


def studio(page: Page, server: Server, clip: str, name: str) -> None:
    """The studio with a preset chosen, once figure and checks follow it."""
    page.evaluate("localStorage.clear()")  # the draft of the picture before
    page.goto(f"{server.url}/studio?clip={clip.rpartition('/')[2]}")
    page.wait_for_selector(".studio-stage[aria-busy=false]", timeout=120_000)
    if name != "studio-phone":
        page.get_by_role("button", name="sad", exact=True).click()
        page.wait_for_selector(".report:not(.stale)", timeout=120_000)
    shot(page, name)


def walking_clip(page: Page, server: Server) -> str:
    """The address of the neutral walk's page."""
    clips = page.request.get(f"{server.url}/api/v1/clips").json()["clips"]
    return next(str(clip["page_url"]) for clip in clips if clip["name"] == "set_a_neutral")


def shot(page: Page, name: str, *, full: bool = False) -> None:
    """One picture, once everything on the page has arrived and the figures have been drawn."""
    # A steered character asks for more motion all the time.
    page.wait_for_load_state("load" if "/graphs/" in page.url else "networkidle")
    if full:  # figures that never were in view are not drawn
        page.keyboard.press("End")
        page.wait_for_timeout(6000)
        page.keyboard.press("Home")
    page.wait_for_timeout(9000)
    page.screenshot(path=FOLDER / f"{name}.png", full_page=full)


if __name__ == "__main__":
    main()
