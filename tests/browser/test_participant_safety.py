"""No answer is lost or doubled, whatever happens to the page, the tab, the line or the server."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page, expect

from tests.browser.participant import (
    CLIPS,
    answer,
    begin,
    choose_planned,
    expect_stored,
    keep_still,
    planned_steps,
    step,
    stored,
    wait_for_clip,
    wait_until_saved,
)
from tests.support.server import Server

pytestmark = pytest.mark.browser
RESPONSES = "**/api/v1/sessions/*/responses"


@pytest.fixture(autouse=True)
def still(page: Page) -> None:
    keep_still(page.context)


def test_a_reload_in_the_middle_comes_back_to_the_same_trial_half_filled_as_it_was(
    page: Page, server: Server
):
    begin(page, server)
    answer(page, 0)
    answer(page, 1)
    step(page, 2, -1).click()
    page.get_by_label("Anything else you noticed?").fill("in a hurry")
    page.reload()
    wait_for_clip(page, 3)
    expect(step(page, 2, -1)).to_be_checked()
    expect(page.get_by_label("Anything else you noticed?")).to_have_value("in a hurry")
    wait_until_saved(page)
    expect_stored(server, 2)


def test_a_new_tab_goes_on_at_the_same_trial_and_the_old_one_says_so(page: Page, server: Server):
    link = begin(page, server)
    answer(page, 0)
    step(page, 1, 1).click()
    other = page.context.new_page()
    other.goto(link)
    wait_for_clip(other, 2)
    expect(step(other, 1, 1)).to_be_checked()
    expect(page.get_by_role("heading", name="This study is open in another tab")).to_be_visible()
    answer(other, 1)
    wait_until_saved(other)
    page.get_by_role("button", name="Continue here").click()
    wait_for_clip(page, 3)
    expect(other.get_by_role("button", name="Continue here")).to_be_visible()
    expect_stored(server, 2)


def test_a_server_killed_between_two_answers_loses_and_doubles_none(page: Page, server: Server):
    begin(page, server)
    answer(page, 0)
    answer(page, 1)
    wait_until_saved(page)
    server.kill()
    answer(page, 2)
    answer(page, 3)
    expect(page.get_by_text("No connection.")).to_be_visible()
    expect_stored(server, 2)
    server.start()
    wait_until_saved(page)
    answer(page, 4)
    wait_until_saved(page)
    expect_stored(server, 5)


def test_a_server_killed_before_it_could_acknowledge_gets_the_answer_once(
    page: Page, server: Server
):
    begin(page, server)

    def store_but_say_nothing(route) -> None:
        route.fetch()
        route.abort("connectionreset")

    page.route(RESPONSES, store_but_say_nothing, times=1)
    answer(page, 0)
    server.restart()
    wait_until_saved(page)
    answer(page, 1)
    wait_until_saved(page)
    expect_stored(server, 2)


def test_ten_seconds_without_a_connection_lose_nothing(page: Page, server: Server):
    begin(page, server)
    answer(page, 0)
    wait_until_saved(page)
    page.context.set_offline(True)
    answer(page, 1)
    answer(page, 2)
    note = page.get_by_text("2 answers are kept on this device and go out by themselves.")
    expect(note).to_be_visible()
    page.wait_for_timeout(10_000)
    expect_stored(server, 1)
    page.context.set_offline(False)
    wait_until_saved(page)
    expect(note).to_be_hidden()
    expect_stored(server, 3)


def test_a_tab_closed_without_a_connection_hands_its_answer_in_when_it_is_opened_again(
    page: Page, server: Server
):
    link = begin(page, server)
    wait_until_two_clips_are_ahead(page)
    page.context.set_offline(True)
    answer(page, 0)
    page.close()
    later = page.context.new_page()
    page.context.set_offline(False)
    assert stored(server) == []
    later.goto(link)
    wait_for_clip(later, 2)
    wait_until_saved(later)
    expect_stored(server, 1)


def test_the_code_comes_only_after_the_last_answer_has_arrived(page: Page, server: Server):
    begin(page, server)
    for trial in range(CLIPS - 2):
        answer(page, trial)
    wait_until_saved(page)
    page.route(RESPONSES, lambda route: route.abort())
    answer(page, CLIPS - 2)
    choose_planned(page, CLIPS - 1)
    page.get_by_role("button", name="Finish").click()
    title = page.get_by_role("heading", name="One moment, the last 2 answers are being sent")
    expect(title).to_be_visible()
    page.wait_for_timeout(2_000)
    assert "/thanks" not in page.url
    assert "MNR-" not in page.content()
    page.unroute(RESPONSES)
    page.wait_for_url("**/thanks", timeout=60_000)
    expect_stored(server, CLIPS)


def test_an_answer_given_first_on_another_device_counts(page: Page, server: Server):
    link = begin(page, server)
    elsewhere = page.context.browser.new_context()
    keep_still(elsewhere)
    other = elsewhere.new_page()
    other.goto(link)
    wait_for_clip(other, 1)
    answer(other, 0)
    wait_until_saved(other)
    elsewhere.close()
    step(page, 0, 2).click()
    page.locator(".next").click()
    wait_for_clip(page, 2)
    wait_until_saved(page)
    expect_stored(server, 1)
    page.get_by_role("button", name="Back").click()
    wait_for_clip(page, 1)
    expect(step(page, 0, planned_steps(0)[0])).to_be_checked()


def wait_until_two_clips_are_ahead(page: Page) -> None:
    page.wait_for_load_state("networkidle")
