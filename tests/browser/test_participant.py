"""People go through the whole study: with the mouse, with the keyboard alone, with a finger."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.participant import (
    CLIPS,
    STUDY,
    answer,
    begin,
    choose_planned,
    expect_stored,
    keep_still,
    planned_steps,
    step,
    stored,
    tab_to,
    wait_for_clip,
    wait_until_saved,
)
from tests.support.server import Server

pytestmark = pytest.mark.browser

CODE = re.compile(r"MNR-[0-9A-Z]{4}-[0-9A-Z]{4}")
PHONE = {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True}


@pytest.fixture(autouse=True)
def still(page: Page) -> None:
    keep_still(page.context)


def expect_a_complete_study(page: Page, server: Server) -> None:
    page.wait_for_url("**/thanks", timeout=60_000)
    expect(page.locator("#code")).to_have_text(CODE)
    expect(page.get_by_text("Everything that you answered has arrived.")).to_be_visible()
    expect_stored(server, CLIPS)
    rows = stored(server)
    for row in rows:
        assert row.rt_ms > 0
        assert row.record["plays"] >= 1
        assert len(row.record["touched"]) == len(row.steps)
    elapsed = [row.record["time_elapsed_ms"] for row in rows]
    assert elapsed == sorted(elapsed)


def test_a_person_does_the_whole_study_with_the_mouse(page: Page, server: Server):
    begin(page, server)
    for trial in range(CLIPS):
        answer(page, trial)
    expect_a_complete_study(page, server)


def test_a_person_does_the_whole_study_with_the_keyboard_alone(page: Page, server: Server):
    page.goto(server.url + STUDY)
    tab_to(page, page.get_by_role("checkbox"))
    page.keyboard.press("Space")
    tab_to(page, page.get_by_role("button", name="Begin"))
    page.keyboard.press("Enter")
    wait_for_clip(page, 1)
    tab_to(page, step(page, 0, 0))
    for trial in range(CLIPS):
        wait_for_clip(page, trial + 1)
        expect(step(page, 0, 0)).to_be_focused()
        for scale, value in enumerate(planned_steps(trial)):
            if scale:
                page.keyboard.press("Tab")
            move_to(page, value, by_arrows=trial % 2 == 0)
        page.keyboard.press("Enter")
    expect_a_complete_study(page, server)


def test_a_person_does_the_whole_study_with_a_finger_on_a_phone(browser: Browser, server: Server):
    context = browser.new_context(**PHONE)
    keep_still(context)
    page = context.new_page()
    page.goto(server.url + STUDY)
    page.get_by_role("checkbox").tap()
    page.get_by_role("button", name="Begin").tap()
    for trial in range(CLIPS):
        wait_for_clip(page, trial + 1)
        for scale, value in enumerate(planned_steps(trial)):
            step(page, scale, value).tap()
        page.locator(".next").tap()
    expect_a_complete_study(page, server)
    context.close()


def test_a_changed_answer_becomes_a_revision_and_a_mere_look_back_does_not(
    page: Page, server: Server
):
    begin(page, server)
    answer(page, 0)
    answer(page, 1)
    page.get_by_role("button", name="Back").click()
    wait_for_clip(page, 2)
    page.get_by_role("button", name="Back").click()
    wait_for_clip(page, 1)
    expect(step(page, 0, planned_steps(0)[0])).to_be_checked()
    step(page, 0, 2).click()
    page.get_by_label("Anything else you noticed?").fill("limps a little")
    page.locator(".next").click()
    wait_for_clip(page, 2)
    page.locator(".next").click()
    wait_for_clip(page, 3)
    wait_until_saved(page)
    rows = stored(server)
    assert [(row.trial, row.revision) for row in rows] == [(0, 1), (0, 2), (1, 1)]
    assert rows[1].steps == (2, *planned_steps(0)[1:])
    assert [row.comment for row in rows] == ["", "limps a little", ""]


def test_an_untouched_middle_is_told_from_a_chosen_one(page: Page, server: Server):
    begin(page, server)
    step(page, 1, 0).click()
    page.locator(".next").click()
    wait_for_clip(page, 2)
    wait_until_saved(page)
    (row,) = stored(server)
    assert row.steps == (0,) * 6
    assert row.record["touched"] == ["tired_excited"]


def test_the_welcome_page_begins_nothing_before_the_box_is_ticked(page: Page, server: Server):
    page.goto(server.url + STUDY)
    page.get_by_role("button", name="Begin").click()
    assert page.url == server.url + STUDY
    page.get_by_role("link", name="I would rather not").click()
    expect(page.get_by_text("Nothing has been kept.")).to_be_visible()


def test_answers_are_deleted_for_good_when_a_person_withdraws(page: Page, server: Server):
    link = begin(page, server)
    choose_planned(page, 0)
    answer(page, 0)
    wait_until_saved(page)
    page.goto(link + "/withdraw")
    heading = page.get_by_role("heading", name="Delete your answers?")
    expect(heading).to_be_visible()
    assert heading.bounding_box()["x"] >= 16  # the page has its margins
    assert len(stored(server)) == 1
    page.get_by_role("button", name="Delete my answers").click()
    expect(page.get_by_role("heading", name="Your answers are deleted.")).to_be_visible()
    assert stored(server) == []
    assert page.evaluate("Object.keys(localStorage)") == []
    page.goto(link)
    expect(page.get_by_role("heading", name="Your answers are deleted.")).to_be_visible()


def move_to(page: Page, value: int, *, by_arrows: bool) -> None:
    """From the preselected middle to a step."""
    if not by_arrows:
        page.keyboard.press(str(value + 3))
    elif value == 0:
        page.keyboard.press("Space")
    for _ in range(abs(value) if by_arrows else 0):
        page.keyboard.press("ArrowRight" if value > 0 else "ArrowLeft")
