"""A researcher makes a study without code, publishes it, changes it, and sets how it is run."""

from __future__ import annotations

import csv
from collections.abc import Iterator

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.browser.accessibility import access_faults
from tests.browser.conftest import DESKTOP, PHONE
from tests.support.server import Server

PATIENCE = 240_000  # milliseconds for work of the server: CI is slow


@pytest.fixture(autouse=True)
def patient(page: Page) -> Iterator[None]:
    """On a slow machine a page's next state may take far longer than the usual five seconds."""
    page.set_default_timeout(PATIENCE)
    expect.set_options(timeout=PATIENCE)
    yield
    expect.set_options(timeout=5_000)


def button(page: Page, name: str) -> Locator:
    return page.get_by_role("button", name=name, exact=True)


def begin(page: Page, server: Server, title: str) -> None:
    """An empty study, from the list."""
    page.goto(f"{server.url}/research")
    button(page, "New study").press("Enter")
    page.get_by_placeholder("Title of the study").fill(title)
    page.get_by_placeholder("Title of the study").press("Enter")
    expect(page.get_by_role("heading", name=title)).to_be_visible()
    expect(button(page, "Add a part")).to_be_visible()


def add(page: Page, kind: str) -> None:
    button(page, "Add a part").press("Enter")
    page.locator("#add-dialog").get_by_role("button", name=kind).press("Enter")
    expect(page.locator("#add-dialog")).to_be_hidden()


def choose_clips(page: Page, search: str, count: int) -> None:
    button(page, "Add clips").press("Enter")
    dialog = page.get_by_role("dialog", name="Choose clips")
    dialog.get_by_placeholder("Name, style or tag").fill(search)
    for index in range(count):
        dialog.locator(".clip-card").nth(index).press("Enter")
    dialog.get_by_role("button", name=f"Add {count} clips").press("Enter")
    expect(page.locator(".stimuli motion-thumbnail")).to_have_count(min(count, 6))


def saved(page: Page) -> None:
    expect(page.locator(".saved")).to_have_text("Saved")


def has_parts(page: Page, *names: str) -> None:
    expect(page.locator(".parts > ol .part > span:first-child")).to_have_text(names)


def test_a_study_is_made_by_keyboard_alone_published_and_taken(
    research_page: Page, server: Server
) -> None:
    page = research_page
    begin(page, server, "Gaits by hand")
    expect(page.get_by_text("to mend before publishing")).to_be_visible()
    add(page, "Opposite words")
    page.get_by_label("Left word").fill("slow")
    page.get_by_label("Right word").fill("fast")
    button(page, "Add a scale").press("Enter")
    page.get_by_label("Left word").nth(1).fill("sad")
    page.get_by_label("Right word").nth(1).fill("happy")
    button(page, "Move scale 2").press("ArrowUp")
    expect(page.get_by_label("Left word").first).to_have_value("sad")
    expect(button(page, "Move scale 1")).to_be_focused()
    choose_clips(page, "set B", 3)
    add(page, "Last words")
    add(page, "Break")
    button(page, "Move “Break”").press("ArrowUp")
    expect(page.locator(".parts > ol .part").nth(1)).to_contain_text("Break")
    has_parts(page, "Opposite words", "Break", "Last words")
    button(page, "Duplicate").press("Enter")
    has_parts(page, "Opposite words", "Break", "Break 2", "Last words")
    page.keyboard.press("Control+z")
    expect(page.locator(".parts > ol .part")).to_have_count(3)
    expect(page.get_by_text("to mend before publishing")).to_be_hidden()
    saved(page)
    frame = page.frame_locator("iframe")
    expect(frame.get_by_text("Take a break")).to_be_visible()

    page.reload()
    expect(page.locator(".parts > ol .part")).to_have_count(3)
    button(page, "Publish").press("Enter")
    dialog = page.locator("#publish-dialog")
    expect(dialog.get_by_text("The first version: 3 parts, 3 clips.")).to_be_visible()
    dialog.get_by_role("button", name="Publish").press("Enter")
    expect(page.get_by_role("heading", name="Version 1 is published")).to_be_visible()
    page.keyboard.press("Escape")
    page.goto(f"{server.url}/studies/gaits-by-hand")
    expect(page.get_by_role("heading", name="How does this movement seem to you?")).to_be_visible()
    clips_chosen_in_the_library_come_into_it(page, server)


def clips_chosen_in_the_library_come_into_it(page: Page, server: Server) -> None:
    page.goto(f"{server.url}/library")
    button(page, "Choose clips").press("Enter")
    page.get_by_placeholder("Name, style or tag").fill("set A")
    for index in range(2):
        page.locator(".clip-card").nth(index).press("Enter")
    bar = page.get_by_role("group", name="What is chosen")
    expect(bar).to_contain_text("2 clips chosen")
    button(page, "Use in a study").press("Enter")
    dialog = page.get_by_role("dialog", name="Use in a study")
    ours = dialog.get_by_role("button", name="Gaits by hand")
    expect(ours).to_contain_text("3 clips · English · open, for version 2")
    assert access_faults(page) == []
    expect(ours).to_be_focused()
    ours.press("Enter")
    expect(dialog.get_by_role("heading", name="Added to Gaits by hand")).to_be_visible()
    expect(dialog.get_by_role("link", name="Open its clips")).to_be_focused()
    page.keyboard.press("Escape")
    button(page, "Use in a study").press("Enter")
    ours.press("Enter")
    expect(dialog.get_by_role("alert")).to_contain_text(
        "All 2 clips are in “Gaits by hand” already"
    )
    page.goto(f"{server.url}/research/studies/gaits-by-hand/edit#opposite_words/stimuli")
    expect(page.locator(".stimuli motion-thumbnail")).to_have_count(5)
    expect(page.get_by_role("group", name="Clips · 5")).to_be_focused()
    page.get_by_role("button", name="Look at").last.press("Enter")
    look = page.locator(".stimulus-dialog")
    page.wait_for_function(
        "() => document.querySelector('.stimulus-dialog motion-viewer')?.duration > 0"
    )
    look.get_by_label("Name in the results").fill("the last one")
    expect(look.get_by_role("heading", name="the last one")).to_be_visible()
    assert access_faults(page) == []
    page.keyboard.press("Escape")
    expect(page.locator(".stimulus-name").last).to_have_text("the last one")
    saved(page)


def test_what_is_missing_is_told_at_its_field_and_in_the_list(
    research_page: Page, server: Server
) -> None:
    page = research_page
    begin(page, server, "Incomplete")
    add(page, "Statements")
    choose_clips(page, "set B", 2)
    question = page.get_by_label("Question", exact=True)
    question.fill("")
    expect(question).to_have_attribute("aria-invalid", "true")
    expect(page.locator(".part[aria-current]")).to_contain_text("needs mending")
    button(page, "The study").press("Enter")
    problems = page.locator(".problems")
    problems.get_by_role("button", name="Statements").first.press("Enter")
    expect(question).to_be_focused()
    page.keyboard.type("Do you agree?")  # the page behind the preview must not take the focus
    page.get_by_label("The statement").fill("It moves like a person.")
    expect(problems).to_be_hidden()
    expect(question).to_have_value("Do you agree?")
    expect(page.frame_locator("iframe").get_by_text("Do you agree?")).to_be_visible()


def test_texts_are_written_per_language_and_the_missing_ones_counted(
    research_page: Page, server: Server
) -> None:
    page = research_page
    begin(page, server, "Languages")
    add(page, "Own words")
    choose_clips(page, "set B", 2)
    button(page, "The study").press("Enter")
    button(page, "Suomi").press("Enter")
    page.locator(".parts > ol .part").press("Enter")
    page.get_by_role("group", name="Language of the texts").get_by_text("Suomi").press("Enter")
    missing = page.get_by_text("are missing")
    expect(missing).to_be_visible()
    before = int((missing.text_content() or "").split()[0])
    page.get_by_label("Question", exact=True).fill("Onko vielä jotain?")
    expect(missing).to_have_text(f"{before - 1} texts are missing")
    expect(page.frame_locator("iframe").get_by_text("Onko vielä jotain?")).to_be_visible()


def test_a_template_is_changed_and_the_new_version_says_so(
    research_page: Page, server: Server
) -> None:
    page = research_page
    page.goto(f"{server.url}/research")
    button(page, "New study").click()
    page.get_by_role("button", name="Four qualities of ten walks").click()
    expect(page.locator(".parts > ol .part").first).to_be_visible()
    for expected in ("The first version", "The title is “Other walks”."):
        button(page, "Publish").click()
        dialog = page.locator("#publish-dialog")
        expect(dialog.get_by_text(expected)).to_be_visible()
        dialog.get_by_role("button", name="Publish").click()
        expect(dialog.get_by_role("heading", name="is published")).to_be_visible()
        page.keyboard.press("Escape")
        if expected == "The first version":
            button(page, "The study").click()
            page.get_by_label("Title").fill("Other walks")
            saved(page)
    button(page, "version 2").click()
    versions = page.locator("#versions-dialog li h3")
    expect(versions).to_have_text(["Version 2", "Version 1"])
    with page.expect_download() as download:
        page.locator("#versions-dialog").get_by_role("link", name="YAML").first.click()
    assert "title: Other walks" in download.value.path().read_text()


def test_a_faulty_file_names_its_lines_and_a_good_one_becomes_a_study(
    research_page: Page, server: Server
) -> None:
    page = research_page
    page.goto(f"{server.url}/research")
    button(page, "New study").click()
    bad = {"name": "bad.yaml", "mimeType": "text/yaml", "buffer": b"title: A\nparts: none\n"}
    page.locator("input[type=file]").set_input_files(bad)
    expect(page.get_by_text("Line 2")).to_be_visible()
    text = page.request.get(f"{server.url}/api/v1/studies/emotion-in-walking/file").body()
    good = {"name": "good.yaml", "mimeType": "text/yaml", "buffer": text}
    page.locator("input[type=file]").set_input_files(good)
    page.wait_for_url("**/research/studies/emotion-in-walking-2/edit*")
    expect(page.locator(".parts > ol .part").first).to_be_visible()


def test_how_a_study_is_run_is_set_and_personal_links_are_made(
    research_page: Page, server: Server
) -> None:
    page = research_page
    page.goto(f"{server.url}/research/studies/emotion-in-walking/settings")
    page.get_by_role("switch", name="Prolific").press("Space")
    button(page, "Save").press("Enter")
    code = page.get_by_label("Completion code")
    expect(code).to_have_attribute("aria-invalid", "true")
    code.fill("C1ABC")
    page.get_by_label("How many may complete it").fill("30")
    page.get_by_label("How many may complete it").press("Tab")
    button(page, "Save").press("Enter")
    expect(page.get_by_role("status").filter(has_text="Saved")).to_be_visible()
    button(page, "Paused").press("Enter")
    expect(page.get_by_text("Nobody new can begin for now.")).to_be_visible()
    button(page, "Open").press("Enter")
    expect(page.get_by_text("New participants can begin.")).to_be_visible()
    with page.expect_download() as download:
        button(page, "Make links").press("Enter")
    with download.value.path().open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert len({row["url"] for row in rows}) == 20
    page.reload()
    expect(page.get_by_label("Completion code")).to_have_value("C1ABC")
    expect(page.get_by_label("How many may complete it")).to_have_value("30")
    expect(page.get_by_text("PROLIFIC_PID=")).to_be_visible()


@pytest.mark.parametrize(("size", "mode"), [(DESKTOP, "light"), (PHONE, "dark")], ids=str)
def test_the_pages_are_accessible_and_fit(
    research_page: Page, server: Server, size: dict, mode: str
) -> None:
    page = research_page
    page.set_viewport_size(size)
    page.emulate_media(color_scheme=mode, reduced_motion="reduce")
    study = f"{server.url}/research/studies/emotion-in-walking"
    for address, ready in (
        (f"{server.url}/research", "New study"),
        (f"{study}/edit", "Add clips"),
        (f"{study}/edit#welcome", "Add a term"),
        (f"{study}/settings", "Make links"),
    ):
        page.goto("about:blank")
        page.goto(address)
        expect(button(page, ready)).to_be_visible()
        assert access_faults(page) == []
        width = page.evaluate("document.documentElement.scrollWidth")
        assert width <= size["width"], address
