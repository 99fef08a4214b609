"""Motion graphs in Chromium: steered by keys, pointer and touch; made, changed and deleted."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Locator, Page, Route, expect

from motion.rotations import angle_between
from tests.browser.accessibility import access_faults
from tests.browser.conftest import DESKTOP, PHONE
from tests.support.server import Server

pytestmark = pytest.mark.browser

PATIENT = 180_000  # ms: the machine may be busy, and a figure drawn without a graphics card
SMALL = {"width": 420, "height": 600}
# Every drawn frame is 1/60 s of motion later, however long the machine takes over it.
STEADY_CLOCK = """
sessionStorage.setItem("manner-tier", "plain");
const real = requestAnimationFrame.bind(window);
let now = 1000, last = -1;
window.requestAnimationFrame = (act) => real((time) => {
  if (time !== last) [last, now] = [time, now + 1000 / 60];
  act(now);
});
"""
# Keeps what the figure shows whenever it is given a pose.
RECORD = """() => {
  const viewer = document.querySelector("motion-viewer");
  const walker = document.querySelector("graph-page").walker;
  const set = viewer.setPose.bind(viewer);
  window.shown = [];
  viewer.setPose = (...pose) => {
    set(...pose);
    const { root, rotations } = viewer.figures[0].pose;
    window.shown.push([walker.time, ...root, ...rotations]);
  };
}"""


@pytest.fixture(autouse=True)
def _patiently(page: Page) -> Iterator[None]:
    page.set_default_timeout(PATIENT)
    expect.set_options(timeout=PATIENT)
    yield
    expect.set_options(timeout=5_000)


@pytest.fixture
def steered(research_page: Page, server: Server) -> Page:
    """The sample graph in a small window, its character standing there, all poses recorded."""
    page = research_page
    page.set_viewport_size(SMALL)
    page.add_init_script(STEADY_CLOCK)
    page.goto(server.url + "/graphs")
    page.get_by_role("link", name="Stand, walk and turn").click()
    is_in(page, "stand")
    page.evaluate(RECORD)
    return page


def node(page: Page, name: str) -> Locator:
    return page.get_by_role("button", name=f"Go to {name}", exact=True)


def is_in(page: Page, name: str) -> None:
    """Wait until the character is in a clip, no cross-fade under way."""
    expect(page.locator(".steering-state b")).to_have_text(name)
    expect(node(page, name)).to_have_attribute("aria-current", "true")


def shows_no_jump(page: Page) -> np.ndarray:
    """The recorded poses never turn a joint by more than 15 degrees a sixtieth of a second."""
    rows = np.array(page.evaluate("window.shown"))
    times, roots = rows[:, 0], rows[:, 1:4]
    turned = rows[:, 4:].reshape(len(rows), -1, 4)[..., [3, 0, 1, 2]]
    frames = np.diff(times) * 60.0
    assert frames.min() >= 0.0
    assert frames.max() < 1.5, "a frame was left out"
    jumps = np.degrees(angle_between(turned[1:], turned[:-1])).max(axis=1)
    assert jumps.max() <= 15.0
    way = np.linalg.norm(np.diff(roots, axis=0), axis=1)
    assert way.max() <= 3.0 / 60.0  # m: nobody walks faster than 3 m/s
    return rows


def test_steering_by_keys_from_every_clip_to_every_other_shows_no_joint_jump(steered: Page):
    page = steered
    keys = {"stand": "ArrowDown", "walk": "ArrowUp", "turn left": "a", "turn right": "ArrowRight"}
    tour = ["walk", "left", "right", "walk", "right", "left", "walk", "stand", "left", "stand"]
    tour += ["right", "stand"]
    for word in tour:
        clip = word if word in keys else f"turn {word}"
        page.keyboard.down(keys[clip])
        is_in(page, clip)
        page.keyboard.up(keys[clip])
    page.keyboard.down("w")
    is_in(page, "walk")
    page.keyboard.up("w")
    is_in(page, "stand")  # nothing is held
    rows = shows_no_jump(page)
    assert len(rows) > 500
    assert np.linalg.norm(rows[-1, [1, 3]] - rows[0, [1, 3]]) > 1.0  # m: it has gone somewhere


def test_sliders_change_the_walk_while_it_goes_on_without_a_jump(steered: Page):
    page = steered
    page.get_by_role("button", name="Walk", exact=True).click()
    is_in(page, "walk")
    for label, value, asked in [
        ("Path length", "1.7", '"path":1.7'),
        ("Timing", "0.3", '"timing":0.3'),
        ("Head down", "1", '"head_down":1'),
        ("Path length", "0.4", '"path":0.4'),
    ]:
        with page.expect_response(_piece_asked_with(asked)):
            page.get_by_label(label, exact=True).fill(value)
    before = len(page.evaluate("window.shown"))
    page.get_by_role("button", name="Left", exact=True).click()
    is_in(page, "turn left")
    rows = shows_no_jump(page)
    assert len(rows) > before


def _piece_asked_with(text: str) -> Any:
    """Whether an answer is the piece of a request with that text."""
    return lambda answer: answer.url.endswith("/play") and text in (answer.request.post_data or "")


def test_fingers_steer_by_buttons_that_are_large_enough(steered: Page, server: Server):
    browser = steered.context.browser
    assert browser is not None
    state = steered.context.storage_state()
    context = browser.new_context(
        viewport=PHONE, has_touch=True, is_mobile=True, storage_state=state
    )
    page = context.new_page()
    page.set_default_timeout(PATIENT)
    page.add_init_script(STEADY_CLOCK)
    page.goto(server.url + "/graphs/sample")
    is_in(page, "stand")
    page.evaluate(RECORD)
    for word, clip in [("Right", "turn right"), ("Walk", "walk"), ("Stop", "stand")]:
        button = page.get_by_role("button", name=word, exact=True)
        box = button.bounding_box()
        assert box is not None
        assert min(box["width"], box["height"]) >= 44
        button.tap()
        expect(button).to_have_attribute("aria-pressed", "true")
        is_in(page, clip)
    shows_no_jump(page)
    context.close()


def test_who_steers_before_the_figure_has_come_is_not_forgotten(steered: Page, server: Server):
    page = steered
    held: list[Route] = []
    come = False

    def hold(route: Route) -> None:
        if come:
            route.continue_()
        else:
            held.append(route)

    page.route(re.compile(r"\.glb"), hold)
    with page.expect_request(re.compile(r"\.glb")):
        page.goto(server.url + "/graphs/sample")
    page.get_by_role("button", name="Left", exact=True).click()
    come = True
    for route in held:
        route.continue_()
    is_in(page, "turn left")


def test_a_graph_is_copied_changed_played_and_deleted(research_page: Page, server: Server):
    page = research_page
    page.goto(server.url + "/graphs/sample")
    page.get_by_role("button", name="Copy and change").click()
    name = page.get_by_label("Name", exact=True)
    expect(name).to_have_value("Stand, walk and turn (copy)")
    name.fill("My walker")
    name.press("Enter")
    count = page.locator(".graph-side [role=status]")
    expect(page.get_by_role("heading", name="My walker")).to_be_attached()
    expect(count).to_have_text("561 transitions")

    page.locator(".table-filters select").first.select_option("walk")
    page.locator(".table-filters select").last.select_option("stand")
    rows = page.locator("table.transitions tbody tr")
    expect(rows).to_have_count(3)
    rows.first.get_by_role("button", name=re.compile("^Show")).click()
    expect(rows.first).to_have_class("chosen")
    rows.first.get_by_role("button", name=re.compile("^Remove")).click()
    expect(rows).to_have_count(2)
    page.get_by_text("1 removed by hand").click()
    page.get_by_role("button", name="Restore").click()
    expect(rows).to_have_count(3)

    form = page.get_by_role("form", name="Add a transition")
    form.locator("select").first.select_option("walk")
    form.locator("select").last.select_option("stand")
    form.get_by_label("at frame").first.fill("200")
    form.get_by_label("at frame").last.fill("30")
    form.get_by_role("button", name="Add transition").click()
    expect(rows).to_have_count(4)
    expect(page.locator("tr", has_text="added")).to_contain_text("3.33 s")

    page.get_by_label("Threshold").fill("3")
    expect(count).not_to_contain_text(re.compile("561|562|counting|saving"))
    fewer = int(count.inner_text().split()[0])
    assert 0 < fewer < 561
    page.reload()
    expect(count).to_have_text(f"{fewer} transitions")

    page.on("dialog", lambda dialog: dialog.accept())
    page.get_by_role("button", name="Delete").click()
    page.wait_for_url("**/graphs")
    expect(page.locator(".graph-rows li")).to_have_count(1)


def test_clips_that_do_not_fit_are_named_and_those_that_do_make_a_graph(
    research_page: Page, server: Server
):
    page = research_page
    page.goto(server.url + "/graphs")
    page.get_by_role("button", name="New graph").click()
    dialog = page.get_by_role("dialog")
    dialog.get_by_label("Name").fill("Bowing")
    for clip in ("bow", "stand", "acted_male_sad"):
        dialog.get_by_role("searchbox").fill(clip)
        dialog.get_by_role("checkbox", name=re.compile(f"^{clip}")).check()
    dialog.get_by_role("button", name="Make the graph").click()
    expect(dialog.get_by_role("alert")).to_contain_text("different skeletons")
    dialog.get_by_role("checkbox", name=re.compile("^acted_male_sad")).uncheck()
    dialog.get_by_role("button", name="Make the graph").click()
    expect(page.get_by_label("Name", exact=True)).to_have_value("Bowing")
    expect(node(page, "bow")).to_be_visible()


@pytest.mark.parametrize(("size", "scheme"), [(DESKTOP, "light"), (PHONE, "dark")], ids=str)
def test_axe_finds_nothing_on_the_pages_of_graphs(
    research_page: Page, server: Server, size: Any, scheme: Any
):
    page = research_page
    page.set_viewport_size(size)
    page.emulate_media(color_scheme=scheme)
    page.goto(server.url + "/graphs")
    page.get_by_role("button", name="New graph").click()
    expect(page.get_by_role("checkbox").first).to_be_visible()
    assert access_faults(page) == []
    page.goto(server.url + "/graphs/sample")
    page.get_by_role("button", name="Copy and change").click()
    expect(page.get_by_role("form", name="Add a transition")).to_be_visible()
    assert access_faults(page) == []
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
