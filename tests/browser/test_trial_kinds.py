"""Every kind of trial and page, answered by the keyboard alone and with a finger on a phone."""

from __future__ import annotations

import json
import sqlite3
from contextlib import closing
from itertools import pairwise

import pytest
from playwright.sync_api import Browser, Locator, Page, expect

from tests.browser.accessibility import access_faults
from tests.browser.every_kind import SLUG, TASKS, add_every_kind
from tests.browser.participant import keep_still, tab_to
from tests.support.server import Server

pytestmark = pytest.mark.browser

PHONE = {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True}
PAIRS = [scale["id"] for scale in TASKS["semantic_differential"][1]["scales"]]
LONG = 60_000
TOO_SMALL = """() => {
  const controls = "main button, main textarea, main select, main input.input, main label.choice, "
    + ".step input, .pick input, .slider input";
  return [...document.querySelectorAll(controls)].filter((one) => {
    const { width, height } = one.getBoundingClientRect();
    return one.checkVisibility() && Math.min(width, height) < 43.9;
  }).map((one) => one.outerHTML.slice(0, 120));
}"""
# Plays from the start until so many frames have been drawn; returns when each of them was.
PLAY = """async (frames) => {
  const viewer = document.querySelector("motion-viewer");
  const times = [];
  await new Promise((done) => {
    viewer.addEventListener("frame", function note() {
      times.push(document.timeline.currentTime);
      if (times.length <= frames) return;
      viewer.removeEventListener("frame", note);
      viewer.pause();
      done();
    });
    viewer.replay();
  });
  return times;
}"""


@pytest.fixture
def study(server: Server) -> Server:
    """The server with the study of every kind."""
    add_every_kind(server.data_directory)
    return server


def begin(page: Page, server: Server) -> str:
    keep_still(page.context)
    page.goto(f"{server.url}/studies/{SLUG}")
    page.get_by_role("checkbox").check()
    page.get_by_role("button", name="Begin").click()
    wait_for(page, 0)
    return page.url


def wait_for(page: Page, step: int) -> None:
    """Wait until a step is shown and can be answered."""
    expect(page.locator(".place progress")).to_have_js_property("value", step, timeout=LONG)
    expect(page.locator(".back")).to_be_enabled(timeout=LONG)


def go_on(page: Page) -> None:
    """By the keyboard, wherever the focus is."""
    tab_to(page, page.locator(".next"), 60)
    page.keyboard.press("Enter")


def rows(server: Server) -> list[tuple[str, dict, dict]]:
    """Kind, answers and record of every stored step, in order."""
    query = "select trial_type, answers, record from responses order by trial_index, revision"
    with closing(sqlite3.connect(server.data_directory / "manner.sqlite3")) as database:
        found = database.execute(query).fetchall()
    return [(kind, json.loads(answers), json.loads(record)) for kind, answers, record in found]


def expect_stored(page: Page, server: Server, expected: list[tuple[str, dict]]) -> None:
    page.wait_for_url("**/thanks", timeout=LONG)
    found = rows(server)
    assert [kind for kind, _, _ in found] == [kind for kind, _ in expected]
    for (kind, answers, record), (_, planned) in zip(found, expected, strict=True):
        assert answers == planned, kind
        assert record["viewport"]["width"] == page.viewport_size["width"]
        watched = kind in TASKS or kind == "instructions"
        assert [record[name] is not None for name in ("plays", "tier")] == [watched] * 2, kind
        if kind in TASKS and TASKS[kind][0] > 1:
            assert len(record["figure_ms"]) >= TASKS[kind][0]


def expect_the_figures_in_view_and_the_line_with_the_focus_too(page: Page) -> None:
    seen = page.evaluate("""() => {
      const viewer = document.querySelector("motion-viewer").getBoundingClientRect();
      const list = document.querySelector(".panel-scroll").getBoundingClientRect();
      const line = document.activeElement.closest("[data-line]").getBoundingClientRect();
      return viewer.top >= 0 && viewer.bottom <= innerHeight
        && line.top >= list.top - 1 && line.bottom <= list.bottom + 1;
    }""")
    assert seen


def test_the_keyboard_alone_answers_every_kind(page: Page, study: Server):
    begin(page, study)
    press = page.keyboard.press

    tab_to(page, page.locator("#box-age"))
    page.keyboard.type("33")
    tab_to(page, page.get_by_role("radio", name="Left"))
    press("ArrowDown")
    tab_to(page, page.get_by_role("checkbox", name="Waltz"))
    press("Space")
    tab_to(page, page.locator("#box-town"))
    page.keyboard.type("Turku")
    press("Enter")

    wait_for(page, 1)
    go_on(page)

    wait_for(page, 2)
    expect(page.locator(".next")).to_have_text("41 pairs to go")
    for index in range(len(PAIRS)):
        expect(page.locator("[data-line]").nth(index).locator("input:focus")).to_have_count(1)
        expect_the_figures_in_view_and_the_line_with_the_focus_too(page)
        press("ArrowRight" if index % 5 == 3 else str(1 + index % 5))
        press("Enter")

    wait_for(page, 3)
    for digit in "413":
        press(digit)
        press("Enter")
    for step in (4, 5):
        wait_for(page, step)
        for key in ("End", "7"):
            press(key)
            press("Enter")

    wait_for(page, 6)
    for key in ("ArrowRight", "Home"):
        press(key)
        press("Enter")

    wait_for(page, 7)
    page.keyboard.type("walks to the shop")
    press("Control+Enter")
    wait_for(page, 8)
    go_on(page)

    wait_for(page, 9)
    press("4")
    expect(page.get_by_text("You chose number 4.")).to_be_visible()
    press("Enter")
    wait_for(page, 10)
    press("ArrowRight")
    press("Enter")
    wait_for(page, 11)
    press("1")
    press("Enter")

    wait_for(page, 12)
    for key in ("ArrowRight", "End", "Home", "Space"):
        press(key)
        press("Enter")

    wait_for(page, 13)
    for place in range(4):
        tab_to(page, page.locator(".place-button").nth(place))
        press("Space")
    press("ArrowLeft")
    go_on(page)

    wait_for(page, 14)
    tab_to(page, page.locator("textarea"))
    page.keyboard.type("no")
    go_on(page)
    wait_for(page, 15)
    go_on(page)

    expect_stored(page, study, [
        ("form", {"age": 33, "hand": "right", "dances": ["waltz"], "town": "Turku"}),
        ("instructions", {}),
        ("semantic_differential", {
            pair: 1 if index % 5 == 3 else index % 5 - 2 for index, pair in enumerate(PAIRS)
        }),
        ("unipolar", {"friendly": 3, "hurried": 0, "clumsy": 2}),
        ("likert", {"meet": 7, "trust": 7}), ("likert", {"meet": 7, "trust": 7}),
        ("analogue", {"sad_happy": 51, "weak_strong": 0}),
        ("free_text", {"text": "walks to the shop"}),
        ("break", {}),
        ("choose", {"choice": 3}), ("ab", {"choice": 1}), ("abx", {"choice": 0}),
        ("parallel", {"0": 51, "1": 100, "2": 0, "3": 50}),
        ("ranking", {"0": 1, "1": 2, "2": 4, "3": 3}),
        ("comment", {"text": "no"}),
        ("debriefing", {}),
    ])  # fmt: skip


def test_a_finger_on_a_phone_answers_every_kind(browser: Browser, study: Server):
    context = browser.new_context(**PHONE)
    page = context.new_page()
    begin(page, study)
    step = Steps(page)

    page.locator(".next").tap()
    expect(page.locator(".field-error")).to_have_count(3)
    expect(page.locator("#box-age")).to_be_focused()
    page.locator("#box-age").fill("17")
    expect(page.locator("#error-age")).to_have_text("Please write a number from 18 to 120.")
    page.locator("#box-age").fill("33")
    page.get_by_text("Left", exact=True).tap()
    page.locator("#box-town").fill("Turku")
    step.done()
    step.done()
    for index, pair in enumerate(PAIRS):
        line = page.locator(f'[data-line="{pair}"]')
        line.locator("input").nth(index % 5).tap()
    step.done()
    for index, line in enumerate(page.locator("[data-line]").all()):
        line.locator("input").nth(index).tap()
    step.done()
    for _ in range(2):
        for line in page.locator("[data-line]").all():
            line.locator("input").last.tap()
        step.done()
    for slider in page.locator(".slider input").all():
        tap_at(slider, 0.75)
    step.done()
    page.locator("textarea").fill("walks")
    step.done()
    step.done()

    page.locator(".cell-stage").nth(5).scroll_into_view_if_needed()
    tap_figure(page, 5)
    expect(page.get_by_text("You chose number 6.")).to_be_visible()
    step.done()
    page.get_by_text("I see no difference").tap()
    step.done()
    page.locator(".pick input").nth(1).tap()
    step.done()
    for slider in page.locator(".slider input").all():
        tap_at(slider, 0.25)
    step.done()
    for place in (2, 0, 3, 1):
        page.locator(".place-button").nth(place).tap()
    page.get_by_role("button", name="Move figure B forward").tap()
    step.done()
    step.done()
    step.done()

    page.wait_for_url("**/thanks", timeout=LONG)
    found = {kind: answers for kind, answers, _ in rows(study)}
    assert len(rows(study)) == 16
    assert list(found["semantic_differential"].values()) == [i % 5 - 2 for i in range(len(PAIRS))]
    assert found["unipolar"] == {"friendly": 0, "hurried": 1, "clumsy": 2}
    assert found["likert"] == {"meet": 7, "trust": 7}
    assert all(70 <= value <= 80 for value in found["analogue"].values())
    assert all(20 <= value <= 30 for value in found["parallel"].values())
    choices = [found[kind]["choice"] for kind in ("choose", "ab", "abx")]
    assert choices == [5, -1, 1]
    assert found["ranking"] == {"2": 1, "0": 2, "1": 3, "3": 4}
    context.close()


class Steps:
    """Goes from step to step with a finger, and holds each to what all must keep."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.index = 0

    def done(self) -> None:
        assert access_faults(self.page) == []
        assert self.page.evaluate(TOO_SMALL) == []
        overflow = self.page.evaluate("document.documentElement.scrollWidth - innerWidth")
        assert overflow <= 0
        self.page.locator(".next").tap()
        self.index += 1
        if self.index < 16:
            wait_for(self.page, self.index)


def tap_at(slider: Locator, share: float) -> None:
    box = slider.bounding_box()
    slider.tap(position={"x": box["width"] * share, "y": box["height"] / 2})


def tap_figure(page: Page, place: int) -> None:
    box = page.locator(".cell-stage").nth(place).bounding_box()
    page.touchscreen.tap(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)


def test_plays_and_viewing_time_are_what_was_played(page: Page, study: Server):
    begin(page, study)
    answer_form(page)
    wait_for(page, 1)
    expected, tolerance = 0.0, 0.0
    for frames in (4, 7):
        times = page.evaluate(PLAY, frames)
        expected += times[-1] - times[0]
        tolerance += max(after - before for before, after in pairwise(times))
    page.locator("motion-viewer .stage").press("Alt+ArrowRight")
    page.locator(".next").click()
    wait_for(page, 2)
    expect(page.locator(".saved")).to_have_text("Saved", timeout=LONG)
    _, _, record = rows(study)[1]
    assert record["plays"] == 3  # by itself, then twice from the start
    assert record["camera_moves"] == 1
    assert expected > 0
    assert abs(record["viewing_ms"] - expected) <= tolerance
    # Both figures of the page were in view all the time.
    assert record["figure_ms"] == [record["viewing_ms"]] * 2


def test_a_preview_keeps_nothing_and_begins_again_after_the_last_step(page: Page, study: Server):
    link = begin(page, study)
    token = link.rsplit("/", 1)[1]
    html = page.request.get(link).text()
    preview = html.replace(f'token="{token}"', f'preview="/api/v1/sessions/{token}"')
    posts: list[str] = []
    page.on(
        "request", lambda request: posts.append(request.url) if request.method == "POST" else None
    )
    page.route(link, lambda route: route.fulfill(body=preview, content_type="text/html"))
    api = f"{study.url}/api/v1/sessions/{token}"
    session = page.request.get(api).json()
    last = {**session, "steps": session["steps"][:2]}
    page.route(api, lambda route: route.fulfill(json=last))
    page.goto(link)
    wait_for(page, 0)
    answer_form(page)
    wait_for(page, 1)
    page.locator(".next").click()
    expect(page.get_by_role("heading", name="That was the last step")).to_be_visible()
    page.get_by_role("button", name="Start again").click()
    wait_for(page, 0)
    expect(page.locator("#box-town")).to_have_value("")
    assert posts == []
    assert rows(study) == []


def test_an_answer_that_ends_the_study_leads_to_its_last_page(page: Page, study: Server):
    begin(page, study)
    answer_form(page, hand="With neither")
    page.wait_for_url("**/thanks", timeout=LONG)
    assert [kind for kind, _, _ in rows(study)] == ["form"]


def test_who_leaves_in_the_middle_of_a_long_list_finds_it_as_it_was(page: Page, study: Server):
    link = begin(page, study)
    answer_form(page)
    wait_for(page, 1)
    page.locator(".next").click()
    wait_for(page, 2)
    for index in range(30):
        page.locator("[data-line]").nth(index).locator("input").nth(index % 5).click()
    scrolled = page.locator(".panel-scroll").evaluate("list => list.scrollTop")
    assert scrolled > 0
    page.goto(link)
    wait_for(page, 2)
    expect(page.locator(".answered")).to_contain_text("30 of 41 pairs answered")
    expect(page.locator("[data-line] input:checked")).to_have_count(30)
    page.get_by_role("button", name="Next open pair").click()
    expect(page.locator("[data-line]").nth(30).locator("input:focus")).to_have_count(1)
    expect_the_figures_in_view_and_the_line_with_the_focus_too(page)


def answer_form(page: Page, hand: str = "Right") -> None:
    page.locator("#box-age").fill("33")
    page.get_by_text(hand, exact=True).click()
    page.locator("#box-town").fill("Turku")
    page.locator(".next").click()
