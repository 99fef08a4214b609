"""A study while it runs, in Chromium: the page follows, a participant is left out and replayed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Page, expect

from app.persistence.engine import Database, make_engine
from app.studies import emotion
from tests.browser.accessibility import access_faults
from tests.browser.conftest import DESKTOP, PHONE
from tests.support.server import Server
from tests.support.simulate import take_part

pytestmark = pytest.mark.browser
# Waits until the figure's clip is there; the page's own policy forbids what polls by text.
SHOWN = """() => new Promise((done) => {
  const look = () => document.querySelector("#stage motion-viewer").duration > 0
    ? done() : setTimeout(look, 50);
  look();
})"""

LIVE = f"/research/studies/{emotion.SLUG}/live"
PATIENT = 60_000  # ms; the page asks every five seconds, and the machine may be slow


def come(server: Server, seed: int, answered: int | None = None) -> None:
    """One more participant."""
    database = Database(make_engine(f"sqlite:///{server.data_directory / 'manner.sqlite3'}"))

    def write(job: Any) -> Any:
        with database.writing() as db:
            done = job(db)
            db.commit()
            return done

    take_part(write, np.random.default_rng(seed), answered=answered)
    database.engine.dispose()


def number(page: Page, word: str) -> Any:
    return page.locator(".key-numbers > div", has_text=word).locator("dd")


def test_the_page_follows_by_itself(research_page: Page, server: Server) -> None:
    page = research_page
    page.goto(server.url + LIVE)
    expect(page.get_by_role("heading", name="Nobody has begun yet")).to_be_visible()
    come(server, 1)
    expect(number(page, "Complete")).to_have_text("1", timeout=PATIENT)
    expect(page.locator("[data-chart=clips] canvas")).to_be_visible(timeout=PATIENT)
    come(server, 2, answered=4)
    expect(number(page, "Under way")).to_have_text("1", timeout=PATIENT)


def test_a_participant_is_left_out_with_a_reason_and_counted_again(
    research_page: Page, server: Server
) -> None:
    page = research_page
    come(server, 1)
    come(server, 2)
    page.goto(server.url + LIVE)
    name = page.locator("table.people tbody a").first.inner_text()
    page.locator("table.people tbody a").first.click()
    page.get_by_role("button", name="Leave out").click()
    dialog = page.get_by_role("dialog", name=f"Leave participant {name} out")
    dialog.get_by_label("Reason").fill("fell asleep")
    dialog.get_by_role("button", name="Leave out").click()
    expect(page.get_by_text("left out", exact=True)).to_be_visible(timeout=PATIENT)
    expect(page.locator(".trail")).to_contain_text("fell asleep")
    page.goto(server.url + LIVE)
    expect(number(page, "Left out")).to_have_text("1")
    page.get_by_role("button", name="Count again").press("Enter")
    expect(number(page, "Complete")).to_have_text("2", timeout=PATIENT)
    expect(page.locator(".trail li")).to_have_count(2)


def test_who_is_deleted_is_asked_about_first_and_then_gone(
    research_page: Page, server: Server
) -> None:
    page = research_page
    come(server, 1)
    page.goto(server.url + LIVE)
    page.locator("table.people tbody a").first.click()
    page.get_by_role("button", name="Delete").click()
    page.get_by_role("button", name="Cancel").click()
    expect(page.get_by_role("heading", level=1)).to_contain_text("Participant")
    page.get_by_role("button", name="Delete").click()
    page.get_by_role("button", name="Delete for good").click()
    expect(number(page, "Withdrawn")).to_have_text("1", timeout=PATIENT)
    expect(page.locator("table.people tbody tr")).to_have_count(0)


def test_each_step_shows_its_own_figure(research_page: Page, server: Server) -> None:
    page = research_page
    come(server, 1)
    page.goto(server.url + LIVE)
    page.locator("table.people tbody a").first.click()
    names = page.locator("[data-step] .figures-named").all_inner_texts()
    other = next(
        step for step, name in enumerate(names) if name != names[0]
    )  # a practice may recur
    sources = []
    for step in (0, other):
        page.locator(f"[data-step='{step}']").click()
        expect(page.locator(f"[data-step='{step}']")).to_have_attribute("aria-pressed", "true")
        figure = page.locator("#stage motion-figure")
        expect(figure).to_have_count(1)
        sources.append(figure.get_attribute("src"))
        page.evaluate(SHOWN)
    assert sources[0] != sources[1]


@pytest.mark.parametrize("size", [DESKTOP, PHONE], ids=["desktop", "phone"])
def test_nothing_is_wide_or_hard_to_reach(
    research_page: Page, server: Server, size: dict[str, int]
) -> None:
    page = research_page
    come(server, 1)
    page.set_viewport_size(size)
    for place in ("live", "session"):
        if place == "live":
            page.goto(server.url + LIVE)
            expect(page.locator("[data-chart=clips] canvas")).to_be_visible(timeout=PATIENT)
        else:
            page.locator("table.people tbody a").first.click()
            expect(page.locator("#stage motion-viewer")).to_be_visible(timeout=PATIENT)
        assert page.evaluate("document.documentElement.scrollWidth") <= size["width"], place
        assert access_faults(page) == [], place
