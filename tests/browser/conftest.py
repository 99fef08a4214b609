"""The real server and a real Chromium."""

from __future__ import annotations

import fcntl
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from app.persistence.engine import Database, make_engine
from app.security import SignInCookies
from app.services import researchers
from app.settings import Settings
from tests.browser.participant import keep_still
from tests.support.server import Server

DESKTOP = {"width": 1280, "height": 800}
PHONE = {"width": 390, "height": 844}
# WebGL without a graphics card, and none of the connections that Chromium makes for itself.
CHROMIUM_ARGUMENTS = [
    "--no-sandbox",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-gpu-rasterization",
    "--disable-gpu-compositing",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
]
NAME, EMAIL, PASSWORD = "A Researcher", "researcher@example.org", "a long enough pass phrase"


@pytest.fixture(scope="session")
def browser_type_launch_args(browser_type_launch_args: dict) -> dict:
    chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser"))), None)
    return {
        **browser_type_launch_args,
        "executable_path": chromium,
        "args": CHROMIUM_ARGUMENTS,
    }


@pytest.fixture(scope="session")
def browser_context_args(browser_context_args: dict) -> dict:
    return {**browser_context_args, "viewport": DESKTOP}


@pytest.fixture(scope="session")
def prepared_data(tmp_path_factory: pytest.TempPathFactory, worker_id: str) -> Path:
    """A data folder with the sample library, made once for all workers of the run."""
    shared = tmp_path_factory.getbasetemp()
    if worker_id != "master":
        shared = shared.parent
    folder = shared / "prepared-data"
    with (shared / "prepared-data.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (folder / "ready").exists():
            subprocess.run(
                [sys.executable, "-m", "app.cli", "prepare"],
                env={**os.environ, "MANNER_DATA_DIRECTORY": str(folder)},
                check=True,
            )
            (folder / "ready").touch()
    return folder


@pytest.fixture
def server(prepared_data: Path, tmp_path: Path) -> Iterator[Server]:
    """A fresh server with the sample library and no researcher yet."""
    folder = tmp_path / "data"
    shutil.copytree(prepared_data, folder)
    server = Server(folder)
    server.start()
    yield server
    server.stop()


@pytest.fixture
def research_page(server: Server, page: Page) -> Page:
    """A page whose user is signed in as the server's researcher; its figures stand still."""
    settings = Settings(data_directory=server.data_directory, public_url=server.url)
    database = Database(make_engine(settings.database))
    with database.writing() as db:
        token = server.set_up_link.rsplit("/", 1)[-1]
        someone = researchers.set_up(db, token, email=EMAIL, name=NAME, password=PASSWORD)
    database.engine.dispose()
    cookies = SignInCookies(settings)
    value = cookies.make(someone.researcher_id, someone.password_mark)
    page.context.add_cookies([{"name": cookies.name, "value": value, "url": server.url}])
    keep_still(page.context)
    page.goto(server.url + "/research")
    return page


@pytest.fixture
def faults(page: Page) -> list[str]:
    """What the browser complains of, breaches of the content policy among it."""
    seen: list[str] = []
    page.on("pageerror", lambda error: seen.append(str(error)))
    page.on("console", lambda told: seen.append(told.text) if told.type == "error" else None)
    return seen


def set_up_researcher(page: Page, server: Server) -> None:
    """Follow the set-up link and make the first researcher's account, as a person does."""
    page.goto(server.set_up_link)
    page.get_by_label("Name").fill(NAME)
    page.get_by_label("Email").fill(EMAIL)
    for field in page.locator("input[type=password]").all():
        field.fill(PASSWORD)
    page.locator("form button[type=submit]").first.click()
    expect(page.get_by_role("heading", name="Studies")).to_be_visible()
