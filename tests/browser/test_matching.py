"""Targets matched in the browser: the clock, the distance, and what outlives a reload."""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Callable
from contextlib import closing
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Locator, Page, expect

from app.persistence.clips import contents
from app.persistence.engine import Database, make_engine
from app.schemas.spaces import SpaceDefinition
from app.services.space_motion import Prepared
from motion.blending.distance import matching_distance
from motion.storage import clip_from_bytes
from tests.browser import test_builder as builder
from tests.browser.accessibility import access_faults
from tests.browser.participant import keep_still
from tests.support.server import Server
from tests.support.study_files import CONSENT, TEXTS, THANKS

pytestmark = pytest.mark.browser

WALKS = ("set_a_neutral", "set_a_sad", "set_a_swaggering")
SAMPLE = "Walks of set A (simulated raters) · 10 examples"
LONG = 60_000
POST = """async ([path, body]) => {
  const token = document.querySelector('meta[name="csrf-token"]').content;
  const headers = { "Content-Type": "application/json", "X-CSRF-Token": token };
  const answer = await fetch(path, { method: "POST", headers, body: JSON.stringify(body) });
  if (!answer.ok) throw new Error(await answer.text());
  return answer.json();
}"""

OFTEN_MS = 100
# Between the distance at the start and the one with the second slider at its end.
BETWEEN = 0.016
PHONE = {"width": 390, "height": 844}
MOTION = "**/steps/*/motion"
TOO_SMALL = """() => [...document.querySelectorAll("main button, main input")].filter((one) => {
  const { width, height } = one.getBoundingClientRect();
  return one.checkVisibility() && Math.min(width, height) < 43.9;
}).map((one) => one.outerHTML.slice(0, 120))"""
# Every move of a slider, as the browser tells it.
LISTEN = """window.moves = [];
addEventListener("input", ({ target }) => window.moves.push(
  [target.closest("[data-slider]").dataset.slider, target.valueAsNumber]), true)"""

Matching = Callable[..., str]


@pytest.fixture
def matching(research_page: Page, server: Server) -> Matching:
    """Publishes a study that matches one target with the weights of three walks, unless told else.

    Returns:
        A function of what the task sets else; it gives the study's address.
    """
    query = f"select name, id from clips where name in {WALKS}"
    clips = dict(rows(server, query))
    ids = [clips[name] for name in WALKS]
    space = research_page.evaluate(POST, ["/api/v1/spaces", {"name": "Three walks", "clips": ids}])

    def made(**task: Any) -> str:
        values = dict(zip(ids, (0.2, 0.65, 0.15), strict=True))
        target = {"space": space["name"], "interface": "weights", "values": values}
        asked = {
            "kind": "match", "question": "Make the blue figure walk like the green one.",
            "space": space["name"], "interfaces": ["weights"], "guess_first": False, **task,
        }  # fmt: skip
        part = {
            "kind": "trials", "id": "matching", "task": asked,
            "stimuli": [{"made": target, "name": "one", "label": "one"}],
        }  # fmt: skip
        study = {
            "manner": 1, "slug": "matching", "title": "Matching", "welcome": TEXTS,
            "thanks": THANKS, "consent": CONSENT, "parts": [part],
        }  # fmt: skip
        research_page.evaluate(POST, ["/api/v1/studies", {"definition": study}])
        research_page.evaluate(POST, ["/api/v1/studies/matching/publish", {}])
        return f"{server.url}/studies/matching"

    return made


def rows(server: Server, query: str) -> list[Any]:
    with closing(sqlite3.connect(server.data_directory / "manner.sqlite3")) as database:
        return database.execute(query).fetchall()


def begin(page: Page, address: str) -> str:
    """Agree, begin, and return the address of the personal link."""
    keep_still(page.context)
    page.goto(address)
    page.get_by_role("checkbox").check()
    page.get_by_role("button", name="Begin").click()
    expect(page.locator(".match-sliders input").first).to_be_enabled(timeout=LONG)
    return page.url


def slider(page: Page, number: int) -> Locator:
    return page.get_by_role("slider", name=f"Share of example {number}", exact=True)


def press(page: Page, number: int, *keys: str) -> None:
    """Move a slider by the keyboard."""
    slider(page, number).focus()
    for key in keys:
        page.keyboard.press(key)


def left(page: Page) -> int:
    """Seconds that the clock shows."""
    minutes, seconds = page.get_by_role("timer").inner_text().split(":")
    return 60 * int(minutes) + int(seconds)


def finish(page: Page) -> None:
    page.locator(".next").click()
    page.wait_for_url("**/thanks", timeout=LONG)


def stored(server: Server) -> list[tuple[str, dict[str, Any], list[list[Any]]]]:
    """Target, answers and path of every stored step."""
    found = rows(server, "select clip_id, answers, record from responses order by trial_index")
    return [(clip, json.loads(a), json.loads(record)["path"]) for clip, a, record in found]


def distance(server: Server, target: str, weights: dict[str, float]) -> float:
    """Between a stored target and the blend of the stored examples."""
    [[definition]] = rows(server, "select definition from spaces where name = 'Three walks'")
    space = SpaceDefinition.model_validate_json(definition)
    engine = make_engine(f"sqlite:///{server.data_directory / 'manner.sqlite3'}")
    with Database(engine).reading() as db:
        clips = contents(db, [one.clip for one in space.examples] + [target])
    engine.dispose()
    given = np.array([weights[f"e{place}"] for place in range(len(space.examples))])
    made = Prepared.of(space, clips).clip(given / given.sum())
    return matching_distance(clip_from_bytes(clips[target]), made)


def test_a_slider_moved_by_the_keyboard_makes_them_alike(
    page: Page, matching: Matching, server: Server
) -> None:
    begin(page, matching(threshold=BETWEEN))
    expect(page.locator(".next")).to_be_disabled()
    assert access_faults(page) == []
    page.get_by_role("button", name="Show all examples").click()
    examples = page.get_by_role("dialog", name="All examples")
    expect(examples.locator(".cell-head")).to_have_text(["1", "2", "3"])
    expect(examples.locator("motion-figure")).to_have_count(3)
    assert access_faults(page) == []
    page.keyboard.press("Escape")
    press(page, 2, "End")
    expect(page.locator(".match-outcome")).to_contain_text("It matches. It took", timeout=LONG)
    expect(slider(page, 2)).to_be_disabled()
    finish(page)
    [[target, answers, path]] = stored(server)
    assert [answers[name] for name in ("e0", "e1", "e2", "solved")] == [0.5, 1, 0.5, 1]
    assert answers["distance"] == pytest.approx(distance(server, target, answers), abs=1e-5)
    assert answers["distance"] < BETWEEN
    assert [move[1:] for move in path] == [["e1", 1]]
    assert 0 < path[0][0] <= 1000 * answers["seconds"] <= 300_000


def test_when_the_time_is_up_one_goes_on(page: Page, matching: Matching, server: Server) -> None:
    begin(page, matching(threshold=0.0001, seconds=5))
    expect(page.locator(".match-outcome")).to_contain_text("Time is up.", timeout=LONG)
    expect(slider(page, 1)).to_be_disabled()
    finish(page)
    [[_, answers, path]] = stored(server)
    assert answers.items() >= {"solved": 0, "seconds": 5, "e0": 0.5, "e1": 0.5, "e2": 0.5}.items()
    assert path is None


def test_the_path_stored_is_the_moves_made(page: Page, matching: Matching, server: Server) -> None:
    page.add_init_script(LISTEN)
    begin(page, matching(threshold=BETWEEN))
    press(page, 1, "ArrowRight", "ArrowRight", "ArrowRight")
    press(page, 3, "ArrowRight", "ArrowLeft", "PageUp")
    press(page, 2, "End")
    expect(page.locator(".match-outcome")).to_be_visible(timeout=LONG)
    moves = page.evaluate("window.moves")
    finish(page)
    [[_, answers, path]] = stored(server)
    assert len(moves) == 7
    kept = [move[1:] for move in path]
    made = iter(moves)
    assert all(move in made for move in kept)  # in their order
    for name in ("e0", "e1", "e2"):
        own = [move for move in path if move[1] == name]
        last = [position for slider, position in moves if slider == name][-1]
        assert own[-1][2] == last == answers[name]
        assert all(b[0] - a[0] >= OFTEN_MS for a, b in pairwise(own))
    times = [move[0] for move in path]
    assert times == sorted(times)


def test_a_reload_and_a_closed_tab_keep_the_sliders_and_the_clock(
    page: Page, matching: Matching, server: Server
) -> None:
    link = begin(page, matching(threshold=BETWEEN))
    press(page, 3, "ArrowRight", "ArrowRight", "ArrowRight")
    expect(page.get_by_role("timer")).not_to_have_text("5:00", timeout=LONG)
    before = left(page)
    for again in (page, page.context.new_page()):
        again.route(MOTION, lambda route: None)  # no picture comes, so that the clock stands
        if again is page:
            page.reload()
        else:
            page.close()
            again.goto(link)
        expect(slider(again, 3)).to_have_value("0.53", timeout=LONG)
        kept = left(again)
        assert before - 2 <= kept <= before < 300
        again.unroute(MOTION)
        again.reload()
        expect(slider(again, 3)).to_be_enabled(timeout=LONG)
        before = left(again)
    press(again, 2, "End")
    expect(again.locator(".match-outcome")).to_be_visible(timeout=LONG)
    finish(again)
    [[_, answers, path]] = stored(server)
    assert answers["e2"] == 0.53
    assert [(path[i][1], path[i][2]) for i in (-2, -1)] == [("e2", 0.53), ("e1", 1)]


def test_a_guess_shows_no_blue_figure_and_rests_once_it_is_given(
    page: Page, matching: Matching, server: Server
) -> None:
    page.set_viewport_size(PHONE)
    link = begin(page, matching(threshold=BETWEEN, guess_first=True))
    expect(page.locator("motion-figure")).to_have_count(1)
    expect(page.get_by_text("the motion is not shown")).to_be_visible()
    token = link.split("/take/")[1].split("?")[0]
    at = f"{server.url}/api/v1/sessions/{token}/steps/0/motion"
    refused = page.request.post(at, data={"values": {"e0": 1}})
    assert (refused.status, refused.json()["error"]["code"]) == (409, "unseen")
    expect(page.locator(".next")).to_be_disabled()
    press(page, 1, "ArrowRight")
    page.locator(".next").click()
    expect(page.get_by_role("timer")).to_be_visible(timeout=LONG)
    expect(slider(page, 1)).to_be_enabled(timeout=LONG)
    expect(slider(page, 1)).to_have_value("0.5")
    expect(page.locator("motion-figure")).to_have_count(2)
    assert access_faults(page) == []
    assert page.evaluate(TOO_SMALL) == []
    assert page.evaluate("document.documentElement.scrollHeight") <= PHONE["height"]
    page.locator(".back").click()
    expect(page.get_by_text("Your guess is kept.")).to_be_visible(timeout=LONG)
    expect(slider(page, 1)).to_be_disabled()
    expect(slider(page, 1)).to_have_value("0.51")
    [[target, answers, _]] = stored(server)
    assert (answers["seen"], answers["e0"]) == (0, 0.51)
    assert answers["distance"] == pytest.approx(distance(server, target, answers), abs=1e-5)


def test_without_a_connection_the_clock_stands_still(page: Page, matching: Matching) -> None:
    begin(page, matching(threshold=BETWEEN))
    page.context.set_offline(True)
    press(page, 3, "ArrowRight")
    note = page.get_by_text("The clock stands still")
    expect(note).to_be_visible(timeout=LONG)
    before = left(page)
    page.wait_for_timeout(2_500)
    assert left(page) == before
    page.context.set_offline(False)
    expect(note).to_be_hidden(timeout=LONG)
    press(page, 2, "End")
    expect(page.locator(".match-outcome")).to_contain_text("It matches.", timeout=LONG)


def test_a_preview_can_be_played_too(
    research_page: Page, matching: Matching, server: Server
) -> None:
    matching(threshold=BETWEEN)
    research_page.goto(f"{server.url}/research/studies/matching/preview")
    expect(slider(research_page, 2)).to_be_enabled(timeout=LONG)
    press(research_page, 2, "End")
    expect(research_page.locator(".match-outcome")).to_contain_text("It matches.", timeout=LONG)


def test_a_researcher_makes_a_matching_part_without_code(
    research_page: Page, server: Server
) -> None:
    page = research_page
    page.set_default_timeout(LONG)
    builder.begin(page, server, "Which sliders?")
    builder.add(page, "Match a motion")
    draw = page.get_by_role("button", name="Draw targets")
    expect(draw.last).to_be_disabled()
    page.get_by_label("Authoring space").select_option(label=SAMPLE)
    page.get_by_role("button", name="Motion features").click()
    page.get_by_label("Time for each").fill("60")
    page.get_by_label("How many").last.fill("2")
    draw.last.click()
    expect(page.locator(".stimulus-name")).to_have_text(["Target 1", "Target 2"], timeout=LONG)
    assert access_faults(page) == []
    builder.saved(page)
    [[draft]] = rows(server, "select draft from studies where title = 'Which sliders?'")
    part = json.loads(draft)["parts"][0]
    assert part["task"]["interfaces"] == ["weights", "adjectives"]
    assert (part["task"]["space"], part["task"]["seconds"]) == (SAMPLE.split(" · ")[0], 60)
    assert [sorted(one["made"]) for one in part["stimuli"]] == [["space", "values"]] * 2
