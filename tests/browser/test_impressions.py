"""The page on which adjective pairs are kept, grouped, named and frozen into an authoring space."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Locator, Page, expect
from sqlalchemy import update

from app.persistence import studies as stored
from app.persistence.engine import Database, make_engine
from app.persistence.models import StudyMember
from app.services import command_line_studies, study_files
from app.studies import TEMPLATES
from app.studies.simulated_impressions import simulated_ratings
from tests.browser.accessibility import access_faults
from tests.browser.conftest import DESKTOP, PHONE
from tests.support import rated_pairs
from tests.support.server import Server

pytestmark = pytest.mark.browser

SET_A, SET_B = "adjectives-set-a", "adjectives-set-b"
SPACE = re.compile("^/studio/spaces/[0-9a-f]{64}$")
LONG = 60_000  # the CI machine is slow


@pytest.fixture
def database(server: Server) -> Iterator[Database]:
    engine = make_engine(f"sqlite:///{server.data_directory / 'manner.sqlite3'}")
    yield Database(engine)
    engine.dispose()


@pytest.fixture
def impressions(research_page: Page, server: Server, database: Database) -> Page:
    """The page of set A's study, which fourteen people have taken part in."""
    publish(database, "adjectives-a")
    rate(database, SET_A, "set_a")
    open_study(research_page, server, SET_A)
    return research_page


def publish(database: Database, template: str) -> None:
    file = study_files.read(study_files.write(TEMPLATES[template].build()), f"{template}.yaml")
    command_line_studies.publish(database, file, None)


def rate(database: Database, slug: str, motion_set: str) -> None:
    ratings = simulated_ratings(motion_set, np.random.default_rng(1))
    with database.writing() as db:
        study = stored.by_slug(db, slug)
        assert study is not None
        rated_pairs.add(db, study, ratings)


def open_study(page: Page, server: Server, slug: str) -> None:
    page.goto(f"{server.url}/research/studies/{slug}/impressions")
    expect(page.locator("impressions-page h2").first).to_be_visible()


def asked(page: Page, server: Server, **query: Any) -> dict[str, Any]:
    """What the API says."""
    answer = page.request.get(f"{server.url}/api/v1/studies/{SET_A}/impressions", params=query)
    return answer.json()


def drag(page: Page, handle: Locator, sideways: float) -> None:
    handle.scroll_into_view_if_needed()
    box = handle.bounding_box()
    assert box
    x, y = box["x"] + box["width"] / 2, box["y"] + min(box["height"], 36) / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + sideways / 2, y, steps=4)
    page.mouse.move(x + sideways, y, steps=4)
    page.mouse.up()


def saved(page: Page) -> None:
    expect(page.locator("[data-saving]")).to_have_attribute("data-saving", "saved", timeout=LONG)


def test_dragging_a_threshold_drops_pairs_live_as_the_api_does(
    impressions: Page, server: Server, faults: list[str]
):
    page = impressions
    slider = page.get_by_role("slider", name="μ* at least")
    before = len(asked(page, server)["kept"])
    expect(page.locator(".kept-count b")).to_have_text(str(before))
    drag(page, slider, 60)
    limit = float(slider.input_value())
    assert limit > 1.0
    found = asked(page, server, least_peak=limit)
    assert len(found["kept"]) < before
    expect(page.locator(".kept-count b")).to_have_text(str(len(found["kept"])), timeout=LONG)
    dropped = page.locator(".pairs tbody tr.dropped")
    expect(dropped).to_have_count(len(found["pairs"]) - len(found["kept"]))
    expect(page.locator(".heat tbody tr")).to_have_count(len(found["kept"]))
    saved(page)
    page.reload()
    expect(page.locator(".kept-count b")).to_have_text(str(len(found["kept"])))
    expect(slider).to_have_value(f"{limit:g}")
    assert faults == []


def test_a_threshold_is_typed_and_what_fails_it_says_why(impressions: Page, server: Server):
    page = impressions
    number = page.get_by_label("σ̄ at most, as a number")
    number.fill("0.6")
    number.press("Enter")
    found = asked(page, server, most_spread=0.6)
    expect(page.locator(".kept-count b")).to_have_text(str(len(found["kept"])), timeout=LONG)
    why = page.locator(".pairs tr[data-pair=slow_fast] td.outcome")
    expect(why).to_have_text("people disagree")
    number.fill("0")
    number.press("Enter")
    expect(page.get_by_text("By these thresholds no pair is kept")).to_be_visible(timeout=LONG)
    expect(page.locator(".pairs tbody tr.dropped")).to_have_count(41)


def test_the_cut_is_moved_by_keys_and_by_pointer(impressions: Page, server: Server):
    page = impressions
    cut = page.get_by_role("slider", name="Cut of the tree")
    columns = page.locator(".cluster")
    expect(columns).to_have_count(4)
    cut.focus()
    cut.press("ArrowRight")
    expect(columns).to_have_count(5, timeout=LONG)
    expect(cut).to_have_attribute("aria-valuenow", "5")
    expect(page.locator(".cluster-count")).to_have_text("five clusters")
    page.get_by_role("button", name="One cluster more").click()
    expect(columns).to_have_count(6, timeout=LONG)
    cut.press("Home")
    expect(columns).to_have_count(1, timeout=LONG)
    drag(page, page.locator(".cut"), 3)  # as a finger slips that scrolls the page
    expect(cut).to_have_attribute("aria-valuenow", "1")
    drag(page, page.locator(".cut"), 150)
    expect(columns).not_to_have_count(1, timeout=LONG)
    saved(page)
    clusters = asked(page, server)["clusters"]
    assert len(clusters) > 1
    expect(columns).to_have_count(len(clusters))


def test_a_name_and_a_pair_moved_by_hand_are_still_there_after_a_reload(
    impressions: Page, server: Server, faults: list[str]
):
    page = impressions
    first, second = page.locator(".cluster").nth(0), page.locator(".cluster").nth(1)
    name = first.get_by_role("textbox")
    name.fill("good order")
    name.press("Tab")
    saved(page)
    pair = first.locator("li").nth(1)
    words = pair.locator(".adjectives").inner_text()
    members = second.locator("li").count()
    pair.get_by_role("combobox", name=f"Move {words} to").select_option(index=1)
    expect(second.locator("li")).to_have_count(members + 1, timeout=LONG)
    expect(second.get_by_role("button", name=f"Undo moving {words}")).to_be_focused()
    expect(page.locator("cluster-list [role=status]")).to_contain_text(f"{words} is now in ")
    page.reload()
    expect(name).to_have_value("good order")
    expect(page.locator(".bracket").first).to_have_text("good order")
    moved = second.locator("li", has_text=words)
    expect(moved).to_contain_text("moved by hand")
    moved.get_by_role("button", name=f"Undo moving {words}").click()
    expect(second.locator("li")).to_have_count(members, timeout=LONG)
    assert asked(page, server)["choices"]["moved"] == {}
    assert faults == []


def test_the_matrix_is_read_by_keys_with_the_numbers_of_the_api(impressions: Page, server: Server):
    page = impressions
    found = asked(page, server)
    page.locator(".heat .cell[tabindex='0']").focus()
    page.keyboard.press("ArrowDown")
    page.keyboard.press("ArrowRight")
    expect(page.locator(".readout b")).to_have_text(found["clips"][1]["label"])
    value = f"{found['matrix'][1][1]:.2f}".removeprefix("0")
    expect(page.locator(".readout")).to_contain_text(value)
    page.get_by_role("button", name="Show numbers").first.click()
    rows = page.locator(".heat.numbers tbody tr")
    expect(rows).to_have_count(len(found["leaves"]))
    expect(rows.nth(1).locator(".cell").nth(1)).to_have_text(value)


def test_participants_are_drawn_anew_another_study_is_set_beside_and_a_space_is_made(
    impressions: Page, server: Server, database: Database, faults: list[str]
):
    page = impressions
    publish(database, "adjectives-b")
    rate(database, SET_B, "set_b")
    open_study(page, server, SET_A)
    page.get_by_role("button", name="Draw participants anew").click()
    expect(page.locator(".curve canvas")).to_be_visible(timeout=2 * LONG)
    expect(page.locator(".stay-bars li")).to_have_count(41)
    expect(page.locator(".enough")).to_contain_text("for the whole solution")
    page.get_by_label("Draws").select_option("10000")
    page.get_by_role("button", name="Draw participants anew").click()
    progress = page.get_by_role("progressbar", name="Drawing participants anew")
    expect(progress).to_have_attribute("max", "107", timeout=LONG)  # pieces of work
    page.get_by_role("button", name="Cancel").click()
    expect(page.get_by_text("Cancelled.")).to_be_visible(timeout=LONG)
    expect(page.locator(".enough")).to_contain_text("for the whole solution")  # of before
    job = page.request.get(f"{server.url}/api/v1/jobs").json()["jobs"][0]
    assert (job["kind"], job["state"]) == ("stability", "cancelled")
    page.get_by_label("Compare with").select_option("Adjectives for walks, set B")
    expect(page.locator("solution-comparison .sentence")).to_contain_text(
        "adjusted Rand index", timeout=LONG
    )
    page.get_by_label("Name", exact=True).fill("Walks by adjectives")
    page.get_by_role("button", name="Make authoring space").click()
    link = page.get_by_role("link", name="Open it in the studio")
    expect(link).to_have_attribute("href", SPACE, timeout=LONG)
    spaces = page.request.get(f"{server.url}/api/v1/spaces").json()["spaces"]
    assert "Walks by adjectives" in [space["name"] for space in spaces]
    page.reload()
    expect(page.get_by_role("link", name="Walks by adjectives, version 1")).to_have_attribute(
        "href", SPACE, timeout=LONG
    )
    assert faults == []


@pytest.mark.parametrize(("size", "scheme"), [(DESKTOP, "light"), (PHONE, "dark")], ids=str)
def test_axe_finds_nothing_and_nothing_is_wider_than_the_screen(
    impressions: Page, size: Any, scheme: Any
):
    page = impressions
    page.set_viewport_size(size)
    page.emulate_media(color_scheme=scheme)
    for button in page.get_by_role("button", name="Show numbers").all():
        button.click()
    expect(page.locator(".heat.numbers")).to_be_visible()
    assert access_faults(page) == []
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")


def test_whoever_may_only_look_can_try_thresholds_but_nothing_is_saved(
    impressions: Page, server: Server, database: Database
):
    page = impressions
    with database.writing() as db:
        db.execute(update(StudyMember).values(role="viewer"))
        db.commit()
    page.reload()
    expect(page.get_by_text("only an editor’s are saved")).to_be_visible()
    cut = page.get_by_role("slider", name="Cut of the tree")
    cut.focus()
    cut.press("ArrowLeft")
    expect(page.locator(".cluster")).to_have_count(3, timeout=LONG)
    expect(page.locator(".cluster").get_by_role("textbox")).to_have_count(0)
    expect(page.get_by_role("button", name="Make authoring space")).to_have_count(0)
    assert asked(page, server)["saved_at"] is None


def test_without_answers_the_page_says_what_is_missing(
    research_page: Page, server: Server, database: Database
):
    page = research_page
    publish(database, "adjectives-a")
    page.goto(f"{server.url}/research/studies/{SET_A}")
    page.get_by_role("link", name="Impressions").click()
    expect(page.get_by_role("heading", name="Not enough answers yet")).to_be_visible()
    expect(page.locator(".empty p")).to_have_text(asked(page, server)["problem"])
