"""Authoring spaces in Chromium: sliders become motion, are changed, saved, and made anew."""

from __future__ import annotations

import re
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, Route, expect

from tests.browser.accessibility import access_faults
from tests.browser.conftest import PHONE
from tests.support.server import Server

pytestmark = pytest.mark.browser

PATIENCE = 90_000  # ms: the first motion of a space prepares all its examples
DEMONSTRATION = "Walks of set A (simulated raters)"


@pytest.fixture
def space(research_page: Page, server: Server) -> Page:
    """The demonstration space, its middle on the stage."""
    research_page.goto(server.url + "/studio/spaces")
    research_page.get_by_role("link", name=DEMONSTRATION).click()
    settled(research_page)
    return research_page


def settled(page: Page) -> None:
    """Wait until the stage shows what the sliders ask for."""
    expect(page.get_by_role("region", name="Stage")).to_have_attribute(
        "aria-busy", "false", timeout=PATIENCE
    )


def feel(page: Page) -> Locator:
    return page.get_by_role("complementary", name="How it feels")


def mix(page: Page) -> Locator:
    return page.get_by_role("complementary", name="The mix")


def weights(page: Page) -> list[float]:
    """What the sliders of the mix show, in the space's order."""
    values = mix(page).get_by_role("slider").evaluate_all("all => all.map(one => one.value)")
    return [float(value) for value in values]


def duration(page: Page) -> float:
    """Seconds that the motion on the stage lasts."""
    return float(page.locator("motion-viewer").evaluate("viewer => viewer.duration"))


def press(page: Page, slider: Locator, key: str, times: int) -> None:
    slider.focus()
    for _ in range(times):
        page.keyboard.press(key)
    settled(page)


def clips(page: Page, server: Server) -> list[dict[str, Any]]:
    return list(page.request.get(server.url + "/api/v1/clips").json()["clips"])


def test_a_slider_changes_the_mix_and_the_motion_and_undo_brings_both_back(
    space: Page, faults: list[str]
):
    page = space
    before, lasted = weights(page), duration(page)
    assert sum(before) == pytest.approx(1, abs=0.03)  # sliders stand on hundredths
    press(page, page.get_by_role("slider", name="quickness"), "ArrowRight", 30)
    after = weights(page)
    assert after != before
    assert sum(after) == pytest.approx(1, abs=0.05)
    assert duration(page) != lasted
    page.keyboard.press("Control+z")  # the whole run of keys at once
    expect(page.get_by_role("slider", name="quickness")).to_have_value("0.5")
    settled(page)
    assert weights(page) == before
    assert duration(page) == pytest.approx(lasted, abs=1e-3)
    assert faults == []


def test_pairs_are_added_swapped_and_deleted(space: Page):
    page = space
    sliders = feel(page).locator(".word-sliders").get_by_role("slider")
    four = sliders.count()
    feel(page).get_by_role("button", name="Add a pair").click()
    chooser = page.get_by_role("dialog", name="Choose a pair")
    chooser.get_by_label("Search").fill("sad")
    chooser.get_by_role("button", name=re.compile("sad.*happy")).click()
    expect(chooser).to_have_count(0)
    added = page.get_by_role("slider", name="sad or happy")
    expect(added).to_be_focused()
    expect(sliders).to_have_count(four + 1)
    settled(page)
    page.get_by_role("button", name="Swap sad or happy for another pair").click()
    expect(chooser.get_by_role("button", name=re.compile("sad.*happy"))).to_have_count(0)
    chooser.get_by_role("button", name=re.compile("small.*large")).click()
    expect(added).to_have_count(0)
    swapped = page.get_by_role("slider", name="small or large")
    expect(swapped).to_be_visible()
    settled(page)
    page.get_by_role("button", name="Delete small or large").click()
    expect(sliders).to_have_count(four)
    settled(page)


def test_features_say_what_was_measured(space: Page):
    page = space
    feel(page).get_by_role("button", name="Features").click()
    settled(page)
    feel(page).get_by_role("button", name="Add a feature").click()
    chooser = page.get_by_role("dialog", name="Choose a feature")
    chooser.get_by_label("Search").fill("duration")
    chooser.get_by_role("button", name="Duration", exact=True).click()
    slider = page.get_by_role("slider", name="Duration", exact=True)
    lasted = duration(page)
    press(page, slider, "End", 1)
    assert duration(page) > lasted
    expect(slider).to_have_attribute("aria-valuetext", re.compile(r"^\d\.\d\d s$"))


def test_a_weight_that_is_moved_leaves_the_others_their_proportions(space: Page):
    page = space
    before = weights(page)
    index = before.index(min(before))
    slider = mix(page).get_by_role("slider").nth(index)
    press(page, slider, "End", 1)
    expect(feel(page).get_by_role("button", name="Weights")).to_have_attribute(
        "aria-pressed", "true"
    )
    assert weights(page) == [float(n == index) for n in range(len(before))]
    page.keyboard.press("Control+z")
    settled(page)
    assert weights(page) == before
    press(page, slider, "ArrowRight", 20)
    after = weights(page)
    assert after[index] == pytest.approx(before[index] + 0.2, abs=0.011)
    scale = (1 - after[index]) / (1 - before[index])
    others = [scale * one for n, one in enumerate(before) if n != index]
    assert [one for n, one in enumerate(after) if n != index] == pytest.approx(others, abs=0.02)
    box = slider.bounding_box()
    assert box
    middle = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + box["width"] * after[index], middle)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] + 30, middle, steps=3)
    page.mouse.move(box["x"] + box["width"] / 2, middle, steps=3)  # back from 100 %
    page.mouse.up()
    settled(page)
    dragged = weights(page)
    assert dragged[index] == pytest.approx(0.5, abs=0.05)
    scale = (1 - dragged[index]) / (1 - before[index])
    others = [scale * one for n, one in enumerate(before) if n != index]
    assert [one for n, one in enumerate(dragged) if n != index] == pytest.approx(others, abs=0.02)


def test_the_point_on_the_map_is_dragged_and_an_example_is_gone_to(space: Page):
    page = space
    map_ = page.locator("space-map")
    place = map_.get_by_role("slider", name="The mix")
    box = map_.bounding_box()
    assert box
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] + 20, box["y"] - 20, steps=5)
    page.mouse.up()
    settled(page)
    expect(place).to_have_attribute("aria-valuetext", re.compile(r"1\.00, .* 1\.00"))
    outside = mix(page).get_by_text("Outside what the examples span")
    expect(outside).to_be_visible()
    place.focus()
    page.keyboard.press("Shift+ArrowLeft")
    expect(place).to_have_attribute("aria-valuetext", re.compile(r"0\.90, .* 1\.00"))
    example = map_.get_by_role("button").first
    name = (example.get_attribute("aria-label") or "").removeprefix("Go to ")
    example.focus()
    page.keyboard.press("Enter")
    settled(page)
    expect(mix(page).get_by_role("slider", name=f"Weight of {name}")).to_have_value("1")
    expect(outside).to_have_count(0)


def test_what_is_saved_is_an_ordinary_clip_made_by_a_recipe(space: Page, server: Server):
    page = space
    press(page, page.get_by_role("slider", name="largeness"), "ArrowRight", 20)
    page.get_by_label("Name of the motion").fill("as large as I like it")
    page.get_by_role("button", name="Save", exact=True).click()
    link = page.get_by_role("link", name="Open in the studio")
    expect(link).to_be_visible(timeout=PATIENCE)
    (clip,) = (one for one in clips(page, server) if one["name"] == "as large as I like it")
    detail = page.request.get(f"{server.url}/api/v1/clips/{clip['id']}").json()
    assert [step["operation"] for step in detail["provenance"]["recipe"]] == ["blend@1"]
    assert detail["variant_of"] is None
    page.get_by_role("button", name="Use in a study").click()
    into = page.get_by_role("dialog", name="Use in a study")
    into.get_by_label("Title").fill("As large as it gets")
    into.get_by_role("button", name="Begin").click()
    expect(into.get_by_role("link", name="Open its clips")).to_be_focused()
    page.keyboard.press("Escape")
    link.click()
    expect(page.get_by_role("heading", name="Studio: as large as I like it")).to_be_attached()
    expect(page.get_by_text(re.compile("from as large as I like it, a mix of"))).to_be_visible()
    settled(page)
    page.get_by_role("link", name=DEMONSTRATION).click()
    expect(page.get_by_role("slider", name="largeness")).to_have_value("0.7")


def test_events_that_are_moved_make_the_next_version(space: Page, server: Server):
    page = space
    name = mix(page).locator(".weight-name").first
    name.click()
    event = page.get_by_role("slider", name="right off")
    before = float(event.get_attribute("aria-valuenow") or "nan")
    event.focus()
    for _ in range(3):
        page.keyboard.press("ArrowRight")
    expect(event).to_have_attribute("aria-valuenow", f"{before + 0.03:.2f}")
    page.get_by_role("button", name="Save as version 2").click()
    expect(page.get_by_text(f"in {DEMONSTRATION}, version 2")).to_be_visible(timeout=PATIENCE)
    settled(page)
    mix(page).locator(".weight-name").first.click()
    expect(event).to_have_attribute("aria-valuenow", f"{before + 0.03:.2f}")
    page.goto(server.url + "/studio/spaces")
    page.get_by_text("1 older version").click()
    expect(page.get_by_role("link", name=DEMONSTRATION)).to_have_count(2)
    page.get_by_role("button", name=f"Delete {DEMONSTRATION}, version 2").press("Enter")
    question = page.get_by_role("dialog", name=f"Delete “{DEMONSTRATION}”, version 2")
    expect(question.get_by_role("button", name="Keep it")).to_be_focused()
    assert access_faults(page) == []
    question.get_by_role("button", name="Delete").click()
    expect(page.get_by_text("version 2, is deleted")).to_be_visible()
    expect(page.get_by_role("heading", name="Spaces")).to_be_focused()
    expect(page.get_by_role("link", name=DEMONSTRATION)).to_have_count(1)


def test_a_space_is_made_of_clips_and_another_one_joins_it(space: Page, server: Server):
    page = space
    page.goto(server.url + "/studio/spaces")
    page.get_by_role("button", name="Make a space from clips").click()
    form = page.get_by_role("dialog", name="Make a space from clips")
    form.get_by_label("Name").fill("Three walks")
    form.get_by_role("button", name="Choose clips").click()
    picker = page.get_by_role("dialog", name="Choose clips")
    picker.get_by_label("Search").fill("set_b_pleasure")
    picker.get_by_role("button", name="All 3").click()
    picker.get_by_role("button", name="Add 3 clips").click()
    form.get_by_role("button", name="Make the space").click()
    expect(page.get_by_role("heading", name="Authoring space: Three walks")).to_be_attached(
        timeout=PATIENCE
    )
    settled(page)
    expect(feel(page).get_by_role("button", name="Adjectives")).to_have_count(0)
    page.get_by_role("button", name="Add a clip to the space").click()
    picker = page.get_by_role("dialog", name="Choose a clip")
    picker.get_by_label("Search").fill("walk")
    picker.locator(".clip-name").get_by_text("walk", exact=True).click()
    join = page.get_by_role("button", name="Join as version 2")
    expect(join).to_be_disabled()  # the others are one cycle each
    page.get_by_role("button", name="Make a copy that fits").click(timeout=PATIENCE)
    expect(page.get_by_role("dialog", name="walk fitted")).to_be_visible(timeout=PATIENCE)
    join.click(timeout=PATIENCE)
    expect(page.get_by_text("in Three walks, version 2")).to_be_visible(timeout=PATIENCE)
    expect(mix(page).get_by_role("slider")).to_have_count(4)


def test_without_a_connection_the_last_motion_stays_and_the_newest_place_follows(space: Page):
    page = space
    lasted = duration(page)
    page.route("**/motion", lambda route: route.abort())
    slider = page.get_by_role("slider", name="quickness")
    slider.focus()
    page.keyboard.press("Home")
    expect(page.get_by_text("The server cannot be reached.")).to_be_visible()
    assert duration(page) == lasted
    asked: list[Route] = []
    with page.expect_request("**/motion"):
        page.route("**/motion", lambda route: asked.append(route))  # instead of breaking it off
        page.get_by_role("button", name="Try now").click()
    stage = page.get_by_role("region", name="Stage")
    expect(stage).to_have_attribute("aria-busy", "true")
    expect(page.get_by_text("The server cannot be reached.")).to_be_visible()
    for route in asked:
        route.continue_()
    page.unroute("**/motion")
    expect(page.get_by_text("The server cannot be reached.")).to_have_count(0)
    settled(page)
    assert duration(page) != lasted


def test_a_reload_comes_back_to_where_one_stood(space: Page):
    page = space
    press(page, page.get_by_role("slider", name="largeness"), "Home", 1)
    before = weights(page)
    page.reload()
    expect(page.get_by_role("slider", name="largeness")).to_have_value("0")
    settled(page)
    assert weights(page) == before


@pytest.mark.parametrize("mode", ["light", "dark"])
def test_the_pages_are_accessible_at_both_sizes(space: Page, server: Server, mode: Any):
    page = space
    page.emulate_media(color_scheme=mode)
    mix(page).locator(".weight-name").first.click()
    expect(page.get_by_role("slider", name="right off")).to_be_visible()
    assert access_faults(page) == []
    page.set_viewport_size(PHONE)
    for drawer in ("Feel", "Mix"):
        page.get_by_role("button", name=drawer, exact=True).click()
        assert access_faults(page) == []
    width = page.evaluate("document.documentElement.scrollWidth")
    assert width <= PHONE["width"]
    page.goto(server.url + "/studio/spaces")
    expect(page.get_by_role("link", name=DEMONSTRATION)).to_be_visible()
    assert access_faults(page) == []
