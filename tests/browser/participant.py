"""How a test takes part in the demonstration study, and what the database then holds."""

from __future__ import annotations

import json
import sqlite3
from contextlib import closing
from dataclasses import dataclass

from playwright.sync_api import BrowserContext, Locator, Page, expect

from tests.support.server import Server

STUDY = "/studies/emotion-in-walking"
CLIPS = 22
AXES = (
    ("sad", "happy"),
    ("tired", "excited"),
    ("angry", "relaxed"),
    ("weak", "strong"),
    ("afraid", "confident"),
    ("masculine", "feminine"),
)
SCALES = tuple("_".join(axis) for axis in AXES)
STILL = """addEventListener("ready", ({ target }) => target.pause?.(), true)"""


@dataclass(frozen=True)
class Row:
    """A stored answer."""

    trial: int
    revision: int
    steps: tuple[int, ...]
    comment: str
    rt_ms: float
    record: dict


def keep_still(context: BrowserContext) -> None:
    """Pause every clip once it is there: without a graphics card each frame takes a second."""
    context.add_init_script(STILL)


def begin(page: Page, server: Server) -> str:
    """Agree, begin, and return the address of the personal link."""
    page.goto(server.url + STUDY)
    page.get_by_role("checkbox").check()
    page.get_by_role("button", name="Begin").click()
    wait_for_clip(page, 1)
    return page.url


def wait_for_clip(page: Page, number: int) -> None:
    """Wait until clip ``number`` is shown and can be answered."""
    expect(page.locator(".place")).to_contain_text(f"Clip {number} of {CLIPS}", timeout=60_000)
    expect(page.locator(".next")).to_be_enabled(timeout=60_000)


def planned_steps(trial: int) -> tuple[int, ...]:
    """What the test person answers to each trial: every step of every scale comes up."""
    return tuple((trial + 2 * scale) % 5 - 2 for scale in range(len(SCALES)))


def step_name(scale: int, step: int) -> str:
    """What a step is called, as a screen reader says it."""
    if step == 0:
        return "neither"
    return f"{'very' if abs(step) == 2 else 'rather'} {AXES[scale][step > 0]}"


def step(page: Page, scale: int, value: int):
    """The radio button of a step."""
    group = page.get_by_role("radiogroup", name=" or ".join(AXES[scale]))
    return group.get_by_role("radio", name=step_name(scale, value), exact=True)


def choose_planned(page: Page, trial: int) -> None:
    """Choose with the mouse what is planned for a trial."""
    for scale, value in enumerate(planned_steps(trial)):
        step(page, scale, value).click()


def answer(page: Page, trial: int) -> None:
    """Answer a trial as planned and wait for the next clip."""
    choose_planned(page, trial)
    page.locator(".next").click()
    if trial + 1 < CLIPS:
        wait_for_clip(page, trial + 2)


def wait_until_saved(page: Page) -> None:
    """Wait until the page says that the server has everything."""
    expect(page.locator(".saved")).to_have_text("Saved", timeout=60_000)


def stored(server: Server) -> list[Row]:
    """Every stored answer, by trial and revision."""
    query = (
        "select trial_index, revision, answers, comment, rt_ms, record from responses "
        "order by trial_index, revision"
    )
    with closing(sqlite3.connect(server.data_directory / "manner.sqlite3")) as database:
        found = database.execute(query).fetchall()
    return [
        Row(trial, revision, _steps(json.loads(answers)), comment, rt_ms, json.loads(record))
        for trial, revision, answers, comment, rt_ms, record in found
    ]


def tab_to(page: Page, target: Locator, most: int = 15) -> None:
    """Press Tab until the focus is there."""
    for _ in range(most):
        if target.evaluate("element => element === document.activeElement"):
            return
        page.keyboard.press("Tab")
    expect(target).to_be_focused()


def _steps(answers: dict[str, int]) -> tuple[int, ...]:
    return tuple(answers[scale] for scale in SCALES)


def expect_stored(server: Server, trials: int) -> None:
    """The first so many trials are stored, each once and as the test person answers it."""
    rows = stored(server)
    assert [(row.trial, row.revision) for row in rows] == [(trial, 1) for trial in range(trials)]
    assert [row.steps for row in rows] == [planned_steps(trial) for trial in range(trials)]
