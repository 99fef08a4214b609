"""Everybody can take part: readers, keyboards, browsers that cannot draw, slow lines."""

from __future__ import annotations

import gzip

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.accessibility import access_faults
from tests.browser.participant import (
    STUDY,
    answer,
    begin,
    keep_still,
    wait_until_saved,
)
from tests.support.server import Server

pytestmark = pytest.mark.browser

SIZES = pytest.mark.parametrize("size", [(1280, 800), (390, 844)], ids=["desktop", "phone"])
PAGE_LIMIT = 260_000
NO_WEBGL = """
const plain = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
  return kind.startsWith("webgl") ? null : plain.call(this, kind, ...more);
};
"""


@pytest.fixture(autouse=True)
def still(page: Page) -> None:
    keep_still(page.context)


@SIZES
def test_axe_finds_nothing_on_any_page_of_a_participant(page: Page, server: Server, size):
    page.set_viewport_size({"width": size[0], "height": size[1]})
    page.goto(server.url + STUDY)
    expect(page.get_by_role("button", name="Begin")).to_be_visible()
    assert access_faults(page) == [], "welcome"
    link = begin(page, server)
    assert access_faults(page) == [], "a trial"
    answer(page, 0)
    wait_until_saved(page)
    page.context.set_offline(True)
    expect(page.get_by_text("No connection.")).to_be_visible()
    assert access_faults(page) == [], "a trial without a connection"
    page.context.set_offline(False)
    other = page.context.new_page()
    other.goto(link + "/withdraw")
    assert access_faults(other) == [], "asking before deleting"
    other.goto(link)
    expect(page.get_by_role("button", name="Continue here")).to_be_visible()
    assert access_faults(page) == [], "the tab that does not count"
    other.goto(link + "/withdraw")
    other.get_by_role("button", name="Delete my answers").click()
    assert access_faults(other) == [], "deleted"


@SIZES
def test_axe_finds_nothing_on_the_thanks_page(page: Page, server: Server, size):
    page.set_viewport_size({"width": size[0], "height": size[1]})
    finish_by_request(page, begin(page, server))
    page.reload()
    page.wait_for_url("**/thanks")
    assert access_faults(page) == []


def test_a_finished_study_shows_its_code_again_by_the_same_link(page: Page, server: Server):
    link = begin(page, server)
    code = finish_by_request(page, link)
    page.goto(link)
    expect(page.locator("#code")).to_have_text(code)


def test_a_browser_without_webgl_is_told_before_consent_and_offered_no_begin(
    page: Page, server: Server
):
    page.add_init_script(NO_WEBGL)
    page.goto(server.url + STUDY)
    expect(page.get_by_text("This browser cannot draw the clips.")).to_be_visible()
    expect(page.get_by_role("button", name="Begin")).to_be_hidden()
    page.get_by_role("link", name="More help").click()
    expect(page.get_by_role("heading")).not_to_have_count(0)


def test_without_javascript_the_page_says_what_to_do_and_offers_no_begin(
    browser: Browser, server: Server
):
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto(server.url + STUDY)
    note = page.locator("noscript .note")  # Playwright's text search passes over <noscript>
    expect(note).to_be_visible()
    expect(note).to_contain_text("JavaScript is switched off.")
    expect(page.get_by_role("button", name="Begin")).to_be_hidden()
    context.close()


def test_the_stimulus_stays_light_where_the_system_is_dark(page: Page, server: Server):
    page.emulate_media(color_scheme="dark")
    begin(page, server)
    backgrounds = page.evaluate("getComputedStyle(document.body).backgroundColor")
    assert backgrounds == "rgb(244, 243, 240)"


def test_a_clip_that_is_slow_to_come_is_announced_and_taken_when_it_comes(
    page: Page, server: Server
):
    held = []
    page.goto(server.url + STUDY)
    page.get_by_role("checkbox").check()
    page.wait_for_load_state("networkidle")
    page.route("**/media/*.glb", lambda route: held.append(route), times=1)
    page.get_by_role("button", name="Begin").click()
    expect(page.get_by_text("The next clip is on its way")).to_be_visible()
    expect(page.get_by_role("button", name="Ask for it again")).to_be_visible(timeout=15_000)
    expect(page.locator(".next")).to_be_disabled()
    (route,) = held
    route.continue_()
    expect(page.locator(".next")).to_be_enabled(timeout=60_000)


def test_a_double_click_on_next_answers_one_clip_only(page: Page, server: Server):
    begin(page, server)
    page.locator(".next").dblclick()
    expect(page.locator(".place")).to_contain_text("Clip 2 of")
    page.wait_for_timeout(1_500)
    expect(page.locator(".place")).to_contain_text("Clip 2 of")


def test_the_second_click_of_a_double_click_answers_nothing_however_late_it_comes(
    page: Page, server: Server
):
    begin(page, server)
    page.locator(".next").click()
    expect(page.locator(".place")).to_contain_text("Clip 2 of")
    expect(page.locator(".next")).to_be_enabled()
    page.locator(".next").dispatch_event("click", {"detail": 2})
    page.wait_for_timeout(500)
    expect(page.locator(".place")).to_contain_text("Clip 2 of")
    page.locator(".next").dispatch_event("click", {"detail": 1})
    expect(page.locator(".place")).to_contain_text("Clip 3 of")


def test_every_step_can_be_hit_with_a_finger(page: Page, server: Server):
    page.set_viewport_size({"width": 390, "height": 844})
    begin(page, server)
    for target in page.locator(".step input, .panel-footer button:visible").all():
        box = target.bounding_box()
        assert box is not None
        assert min(box["width"], box["height"]) >= 44


def test_the_trial_page_weighs_little_without_figure_clips_and_fonts(page: Page, server: Server):
    link = begin(page, server)
    responses = []
    page.on("response", lambda response: responses.append(response))
    page.goto(link)
    expect(page.locator(".next")).to_be_enabled(timeout=60_000)
    page.wait_for_load_state("networkidle")
    sizes = {
        response.url: len(gzip.compress(response.body()))
        for response in responses
        if response.url.startswith("http") and not response.url.endswith((".glb", ".woff2"))
    }
    assert any("motion_viewer" in url for url in sizes), "the viewer is part of the page"
    assert sum(sizes.values()) <= PAGE_LIMIT, sizes


def finish_by_request(page: Page, link: str) -> str:
    """Answer all clips through the API, as the page would, and complete; returns the code."""
    api = link.replace("/take/", "/api/v1/sessions/")
    session = page.request.get(api).json()
    for step in session["steps"]:
        reply = page.request.post(
            f"{api}/responses",
            data={
                "trial_index": step["index"],
                "revision": 1,
                "answers": {scale["id"]: 1 for scale in session["parts"][step["part"]]["scales"]},
                "touched": [],
                "comment": "",
                "rt_ms": 1000,
                "time_elapsed_ms": 1000,
                "client_time": "2026-01-01T00:00:00Z",
                "record": {},
            },
        )
        assert reply.status == 201
    return page.request.post(f"{api}/complete").json()["completion_code"]
