"""A motion of another body in Chromium: tried on a body of the library, then made."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.browser.accessibility import access_faults
from tests.browser.conftest import PHONE
from tests.support.other_bodies import stranger, stranger_bvh
from tests.support.server import Server

pytestmark = pytest.mark.browser

PATIENCE = 90_000  # ms: the first motion of a server waits for a process to start


@pytest.fixture
def report(research_page: Page, server: Server) -> Locator:
    """The import report of a walk by a smaller body with longer arms."""
    page = research_page
    page.goto(server.url + "/library")
    expect(page.locator(".clip-card").first).to_be_visible()
    file = {"name": "stranger.bvh", "mimeType": "text/plain", "buffer": stranger_bvh()}
    page.locator("input[type=file]").set_input_files(file)
    drawer = page.get_by_label("Import report")
    expect(drawer.get_by_role("heading", name="Body")).to_be_visible(timeout=PATIENCE)
    return drawer


def tried(page: Page) -> Locator:
    """The dialog once it tells how the motion fits."""
    dialog = page.get_by_role("dialog", name=re.compile("on another body"))
    expect(dialog.get_by_text("Feet slide", exact=True)).to_be_visible(timeout=PATIENCE)
    return dialog


def keep(report: Locator, server: Server) -> str:
    """Keep the imported clip; its id."""
    page = report.page
    report.get_by_role("button", name="Yes, keep it").click()
    expect(report).to_be_hidden()
    clips = page.request.get(server.url + "/api/v1/clips").json()["clips"]
    return str(next(clip["id"] for clip in clips if clip["name"] == "stranger"))


def test_an_imported_walk_is_put_onto_a_common_body_and_mixed_with_its_clips(
    report: Locator, server: Server, faults: list[str]
):
    page = report.page
    expect(report).to_contain_text("a skeleton of its own")
    report.get_by_role("button", name="Keep it and put it onto another body").click()
    dialog = tried(page)
    expect(dialog.get_by_label("set_a_neutral")).to_be_checked()
    expect(dialog).to_contain_text("The motion fits")
    expect(dialog.get_by_text(re.compile(r"mm off the floor in the mean$"))).to_be_visible()
    dialog.get_by_label("One cycle of it").check()
    tried(page)
    expect(dialog.get_by_label("Name")).to_have_value("stranger_cycle_on_set_a_neutral")
    # Both bodies show this one of its three strides, and so the same instant of it.
    page.wait_for_function(
        "longest => { const { duration } = document.querySelector('body-dialog motion-viewer');"
        " return duration > 0 && duration < longest; }",
        arg=stranger().duration / 2,
        timeout=PATIENCE,
    )
    assert access_faults(page) == []
    dialog.get_by_label("Name").fill("short walker")
    dialog.get_by_role("button", name="Make the clip").click()
    show = dialog.get_by_role("link", name="Show it")
    expect(show).to_be_focused(timeout=PATIENCE)
    expect(page.locator(".clip-card").first).to_contain_text("short walker")
    show.click()
    expect(page.get_by_role("heading", name="short walker")).to_be_visible()
    steps = page.locator(".steps li")
    expect(steps).to_have_count(2)
    expect(steps.nth(0)).to_contain_text("One cycle")
    expect(steps.nth(1)).to_contain_text("Onto another body")
    clips = page.request.get(server.url + "/api/v1/clips").json()["clips"]
    mixed = [c["id"] for c in clips if c["name"] in ("short walker", "set_a_neutral")]
    token = page.locator("meta[name=csrf-token]").get_attribute("content") or ""
    made = page.request.post(
        server.url + "/api/v1/spaces",
        data={"name": "Two walkers", "clips": mixed},
        headers={"X-CSRF-Token": token},
    )
    assert made.status == 201, made.text()
    assert faults == []


def test_the_way_of_a_refused_clip_opens_on_the_body_that_was_asked_for(
    report: Locator, server: Server
):
    page = report.page
    stranger = keep(report, server)
    clips = page.request.get(server.url + "/api/v1/clips").json()["clips"]
    onto = next(clip["id"] for clip in clips if clip["name"] == "acted_male_sad")
    page.set_viewport_size(PHONE)
    page.emulate_media(color_scheme="dark")
    page.goto(f"{server.url}/library/{stranger}?onto={onto}#body")
    dialog = tried(page)
    expect(dialog.get_by_label("acted_male_sad")).to_be_checked()
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    told, name = (
        dialog.locator(".body-fit").bounding_box(),
        dialog.locator("label.field").bounding_box(),
    )
    assert told
    assert name
    assert told["y"] + told["height"] <= name["y"]
    assert access_faults(page) == []
    dialog.get_by_label("acted_male_sad").press("ArrowDown")
    expect(dialog.get_by_label("acted_male_sad")).not_to_be_checked()
    tried(page)
    page.keyboard.press("Escape")
    expect(dialog).to_be_hidden()
    expect(page.get_by_role("button", name="Put it onto another body")).to_be_focused()


def test_a_motion_without_a_stride_is_told_with_the_way_on(report: Locator, server: Server):
    page = report.page
    stranger = keep(report, server)
    token = page.locator("meta[name=csrf-token]").get_attribute("content") or ""
    piece = page.request.post(
        server.url + "/api/v1/clips",
        data={
            "source": stranger,
            "operations": [{"operation": "cut@1", "parameters": {"end": 0.4}}],
            "name": "half a step",
        },
        headers={"X-CSRF-Token": token},
    ).json()
    page.goto(server.url + piece["page_url"])
    page.get_by_role("button", name="Put it onto another body").click()
    dialog = tried(page)
    dialog.get_by_label("One cycle of it").check()
    expect(dialog.get_by_role("alert")).to_contain_text("No stride", timeout=PATIENCE)
    expect(dialog).to_contain_text("Choose the whole motion")
    expect(dialog.get_by_role("button", name="Make the clip")).to_be_disabled()
    dialog.get_by_label("All of it, as one cycle").check()
    tried(page)
    expect(dialog.get_by_role("button", name="Make the clip")).to_be_enabled()


def test_the_studio_edits_a_clip_on_another_body_as_it_stands(report: Locator, server: Server):
    page = report.page
    report.get_by_role("button", name="Keep it and put it onto another body").click()
    tried(page).get_by_role("button", name="Make the clip").click()
    page.get_by_role("link", name="Show it").click(timeout=PATIENCE)
    page.get_by_role("link", name="Open in the studio").click()
    stage = page.get_by_role("region", name="Stage")
    expect(stage).to_have_attribute("aria-busy", "false", timeout=PATIENCE)
    expect(page.locator("motion-figure").first).to_have_attribute("src", re.compile("/media/"))
    figures = page.locator("motion-figure").evaluate_all(
        "all => all.map(one => one.getAttribute('figure'))"
    )
    clips = page.request.get(server.url + "/api/v1/clips").json()["clips"]
    (body,) = {clip["figure_url"] for clip in clips if clip["name"] == "set_a_neutral"}
    assert set(figures) == {body}
    more = page.get_by_text("tempo, limbs, contacts")
    more.click()
    add = page.get_by_role("group", name="Add")
    expect(add.get_by_role("button", name="One cycle")).to_be_visible()
    expect(add.get_by_role("button", name="Onto another body")).to_have_count(0)
    expect(page.get_by_role("link", name="put the motion onto it first")).to_be_visible()
