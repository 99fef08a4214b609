"""A researcher's pages in Chromium: the library and its imports, one clip, a study's results."""

from __future__ import annotations

import re
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from app.persistence.engine import Database, make_engine
from tests.browser.accessibility import access_faults
from tests.browser.conftest import DESKTOP, PHONE
from tests.support.server import Server
from tests.support.simulate import simulate

pytestmark = pytest.mark.browser

RESULTS = "/research/studies/emotion-in-walking"


@pytest.fixture
def library(research_page: Page, server: Server) -> Page:
    """The library, as a signed-in researcher sees it."""
    expect(research_page.get_by_role("heading", name="Studies")).to_be_visible()
    research_page.goto(server.url + "/library")
    expect(research_page.locator(".clip-card").first).to_be_visible()
    return research_page


def answers_by(server: Server, participants: int, seed: int = 1) -> None:
    database = Database(make_engine(f"sqlite:///{server.data_directory / 'manner.sqlite3'}"))

    def write(job: Any) -> Any:
        with database.writing() as db:
            done = job(db)
            db.commit()
            return done

    simulate(write, participants, seed)
    database.engine.dispose()


def sample_bvh(page: Page, server: Server, name: str = "acted_male_sad") -> str:
    clips = page.request.get(server.url + "/api/v1/clips").json()["clips"]
    (clip,) = (clip for clip in clips if clip["name"] == name)
    return page.request.get(f"{server.url}/api/v1/clips/{clip['id']}.bvh").text()


def choose(page: Page, name: str, text: str) -> None:
    file = {"name": name, "mimeType": "text/plain", "buffer": text.encode()}
    page.locator("input[type=file]").set_input_files(file)


@pytest.mark.parametrize(("size", "scheme"), [(DESKTOP, "light"), (PHONE, "dark")], ids=str)
def test_axe_finds_nothing_on_any_page_of_a_researcher(library: Page, server: Server, size, scheme):
    page = library
    page.set_viewport_size(size)
    page.emulate_media(color_scheme=scheme)
    answers_by(server, 5)
    clip = page.locator(".clip-card").first.get_attribute("href")
    choose(page, "walk.bvh", sample_bvh(page, server))
    expect(page.get_by_role("button", name="Yes, keep it")).to_be_visible(timeout=60_000)
    assert access_faults(page) == [], "import report"
    for path in ("/", "/library", clip, "/research", RESULTS, "/no-webgl", "/nothing-here"):
        page.goto(server.url + path)
        expect(page.get_by_role("heading").first).to_be_visible()
        assert access_faults(page) == [], path
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), path


def test_an_imported_file_is_reported_beside_a_rule_and_kept_on_request(
    library: Page, server: Server, faults: list[str]
):
    page = library
    choose(page, "my walk.bvh", sample_bvh(page, server))
    drawer = page.get_by_label("Import report")
    expect(drawer.get_by_role("heading", name="my walk")).to_be_visible(timeout=60_000)
    expect(drawer.locator(".ruler")).to_contain_text("1.7 m")
    expect(drawer.get_by_role("button", name="Yes, keep it")).to_be_focused()
    card = page.locator(".clip-card").first
    expect(card).to_contain_text("new")
    page.reload()
    card.click()
    expect(drawer).to_contain_text("Waits to be confirmed")
    drawer.get_by_role("button", name="Yes, keep it").press("Enter")
    expect(drawer).to_be_hidden()
    expect(page.locator(".file-button input")).to_be_focused()
    expect(card).not_to_contain_text("new")
    page.reload()
    expect(page.get_by_role("button", name=re.compile("Imported"))).to_contain_text("1")
    assert faults == []


def test_a_wrong_guess_is_corrected_and_a_discarded_file_leaves_nothing(
    library: Page, server: Server
):
    page = library
    choose(page, "walk.bvh", sample_bvh(page, server))
    drawer = page.get_by_label("Import report")
    drawer.get_by_role("button", name=re.compile("^(Change|Correct)")).first.click(timeout=60_000)
    drawer.get_by_label("One unit in the file is").select_option("inches")
    drawer.get_by_label("neck").select_option("no joint")
    drawer.get_by_role("button", name="Read it again").click()
    expect(drawer.locator(".report-notes")).to_contain_text("inches", timeout=60_000)
    expect(drawer.locator(".facts")).to_contain_text("1 role missing")
    expect(drawer.get_by_role("button", name="Yes, keep it")).to_be_focused()
    drawer.get_by_role("button", name="Discard").click()
    expect(drawer).to_be_hidden()
    page.reload()
    expect(page.locator(".clip-card").first).to_be_visible()
    expect(page.get_by_role("button", name=re.compile("Imported"))).to_have_count(0)


def test_a_missing_number_is_shown_in_its_line_and_filled_on_request(library: Page, server: Server):
    page = library
    lines = sample_bvh(page, server).splitlines()
    row = lines.index("MOTION") + 8
    numbers = lines[row].split()
    lines[row] = " ".join([*numbers[:5], "nan", *numbers[6:]])
    choose(page, "gap.bvh", "\n".join(lines))
    drawer = page.get_by_label("Import report")
    expect(drawer.get_by_role("alert")).to_contain_text(
        re.compile(rf"gap\.bvh was not imported\. Line {row + 1}, column \d+"), timeout=60_000
    )
    expect(drawer.locator("mark")).to_have_text("nan")
    drawer.get_by_role("button", name="Fill and import").click()
    expect(drawer.get_by_role("heading", name="gap")).to_be_visible(timeout=60_000)
    expect(drawer.locator(".report-notes")).to_contain_text(re.compile("fill", re.IGNORECASE))


def test_files_may_be_dropped_anywhere_on_the_library(library: Page, server: Server):
    page = library
    text = sample_bvh(page, server)
    files = page.evaluate_handle(
        """(text) => {
          const transfer = new DataTransfer();
          transfer.items.add(new File([text], "dropped.bvh"));
          return transfer;
        }""",
        text,
    )
    page.dispatch_event("h1", "dragenter", {"dataTransfer": files})
    expect(page.get_by_text("Drop BVH files to import them")).to_be_visible()
    page.dispatch_event("h1", "drop", {"dataTransfer": files})
    expect(page.get_by_text("Drop BVH files to import them")).to_be_hidden()
    heading = page.get_by_label("Import report").get_by_role("heading", name="dropped")
    expect(heading).to_be_visible(timeout=60_000)


def test_the_library_is_searched_filtered_and_opened_by_keyboard(page: Page, server: Server):
    page.goto(server.url + "/library")
    search = page.get_by_role("searchbox")
    search.press_sequentially("sad female")
    expect(page.locator(".clip-card")).to_have_count(1)
    search.fill("no such motion")
    expect(page.get_by_text("No motion matches")).to_be_visible()
    page.get_by_role("button", name=re.compile("Show all")).press("Enter")
    acted = page.get_by_role("button", name=re.compile("Acted"))
    acted.press("Space")
    expect(page.locator(".clip-card")).to_have_count(20)
    page.locator(".clip-card").first.press("Enter")
    page.wait_for_url("**/library/*")
    expect(page.get_by_role("link", name="BVH")).to_be_visible()


def test_charts_sentence_and_numbers_follow_the_chosen_axis_and_pole(
    research_page: Page, server: Server, faults: list[str]
):
    page = research_page
    answers_by(server, 6)
    page.goto(server.url + RESULTS)
    expect(page.locator(".chart canvas")).to_have_count(2)
    page.get_by_role("button", name="weak – strong").click()
    expect(page.get_by_text("How weak or strong each clip looked")).to_be_visible()
    page.get_by_role("button", name="Numbers").click()
    expect(page.locator("axis-charts tbody tr")).to_have_count(20)
    page.get_by_role("button", name="happy", exact=True).click()
    expect(page.locator("#sentence")).to_contain_text("happier")
    expect(page.locator("tr.chosen th")).to_have_text("happy")
    assert faults == []


def test_counts_follow_while_the_page_is_open_and_new_charts_are_offered(
    research_page: Page, server: Server
):
    page = research_page
    page.goto(server.url + RESULTS)
    complete = page.locator("#counts dd").first
    expect(page.get_by_text("No answers yet")).to_be_visible()
    expect(complete).to_have_text("0")
    answers_by(server, 5)
    expect(complete).to_have_text("5", timeout=20_000)
    page.get_by_role("link", name="Show all answers").click()
    expect(page.locator(".chart canvas")).to_have_count(2)
