"""Pictures of the way from adjectives to sliders, and of what is matched with them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
from playwright.sync_api import Page, expect

from app.persistence import studies
from app.persistence.engine import Database, make_engine
from app.services import command_line_simulation as simulation
from app.services import command_line_studies, study_files
from app.studies import TEMPLATES
from app.studies.simulated_impressions import simulated_ratings
from tests.browser.conftest import DESKTOP, PHONE
from tests.support import rated_pairs
from tests.support.server import Server

Shot = Callable[..., None]
MATCHERS = 6  # one for each order of the three interfaces
PATIENCE = 120_000  # ms
ADJECTIVES, MATCHING = "adjectives-set-a", "matching-walks"


def publish_and_answer(folder: Path) -> None:
    """The studies of set A's adjectives and of matching, once the server has a researcher."""
    database = Database(make_engine(f"sqlite:///{folder / 'manner.sqlite3'}"))
    for template in ("adjectives-a", "matching"):
        file = study_files.read(study_files.write(TEMPLATES[template].build()), template)
        command_line_studies.publish(database, file, None)
    with database.writing() as db:
        study = studies.by_slug(db, ADJECTIVES)
        assert study is not None
        rated_pairs.add(db, study, simulated_ratings("set_a", np.random.default_rng(1)))
    plan = simulation.planned(database, MATCHING, None)
    simulation.run(database, plan, MATCHERS, 0, np.random.default_rng(3), lambda done: None)
    database.engine.dispose()


def take(page: Page, server: Server, shot: Shot) -> None:
    """Every picture; the researcher is signed in."""
    publish_and_answer(server.data_directory)
    of = f"{server.url}/research/studies"
    for name, address in (
        ("impressions", f"{of}/{ADJECTIVES}/impressions"),
        ("matching", f"{of}/{MATCHING}?kind=simulated"),
    ):
        page.goto(address)
        shot(page, name, full=True)
    page.goto(f"{of}/{MATCHING}/edit#matching/stimuli")
    page.get_by_role("button", name="Look at").first.click()
    shot(page, "stimulus")
    page.keyboard.press("Escape")
    page.goto(f"{server.url}/studio/spaces")
    shot(page, "spaces")
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        open_space(page, server)
        page.get_by_role("slider", name="largeness").fill("0.7")
        shot(page, f"space-{scheme}")
    page.emulate_media(color_scheme="light")
    use_in_a_study(page, server)
    shot(page, "use-in-a-study")
    page.set_viewport_size(PHONE)
    open_space(page, server)
    page.get_by_role("button", name="Feel", exact=True).click()
    shot(page, "space-phone")
    for name, viewport in (("desktop", DESKTOP), ("phone", PHONE)):
        page.set_viewport_size(viewport)
        match(page, server)  # somebody else each time, who begins with another interface
        shot(page, f"match-{name}")


def open_space(page: Page, server: Server) -> None:
    """Set A's space, once its figure moves."""
    page.goto(f"{server.url}/studio/spaces")
    page.get_by_role("link", name="Walks of set A (simulated raters)").click()
    page.wait_for_selector(".studio-stage[aria-busy=false]", timeout=PATIENCE)


def use_in_a_study(page: Page, server: Server) -> None:
    """Two clips of the library are chosen, and the studies that may take them are listed."""
    page.goto(f"{server.url}/library")
    page.get_by_role("button", name="Choose clips").click()
    for index in range(2):
        page.locator(".clip-card").nth(index).click()
    page.get_by_role("button", name="Use in a study").click()


def match(page: Page, server: Server) -> None:
    """The first walk to be matched, a little way towards it."""
    page.goto(f"{server.url}/studies/{MATCHING}")
    page.get_by_role("checkbox").check()
    page.get_by_role("button", name="Begin").click()
    sliders = page.locator(".match-sliders input")
    for _ in range(2):  # about you, and what is to be done
        page.locator(".next").click()
    expect(sliders.first).to_be_enabled(timeout=PATIENCE)
    sliders.nth(1).fill("0.6")
