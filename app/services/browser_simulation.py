"""Simulated participants in real browsers: the pages, the figures and the outbox take part as well.

Each session is begun by the service, for that makes it a simulated one; from there on Chromium
opens its personal link and answers by the page's own controls. Slow: for few participants.
"""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from threading import Lock
from typing import TYPE_CHECKING, Any

import numpy as np

from app.errors import InvalidError, MannerError
from app.persistence.engine import Database
from app.persistence.writer import Writer
from app.schemas.study import CommentPage, Form, Match, StudyDefinition, Trials
from app.services import simulation
from app.services.command_line_simulation import Plan, Tell
from app.services.plans import PAUSE, Step
from app.services.simulation import Begun, Course, Rater

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

PATIENCE = 120_000  # ms; figures are drawn without a graphics card
# WebGL without a graphics card.
ARGUMENTS = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
READY = """index => document.querySelector(".place progress")?.value === index
    && document.querySelector(".back")?.disabled === false"""


@dataclass(frozen=True)
class _Visit:
    """One participant's way through the pages."""

    page: Page
    definition: StudyDefinition
    rater: Rater

    def take(self, address: str, begun: Begun) -> Course:
        """Answer every step in the browser."""
        self.page.goto(f"{address}/take/{begun.token}")
        counted = []
        for index, step in enumerate(begun.steps):
            self.page.wait_for_function(READY, arg=index, timeout=PATIENCE)
            given = self.rater.answer(self.definition, step)
            self._answer(step, given)
            counted += begun.counted(step, given)
            self.page.locator(".next:enabled").click(timeout=PATIENCE)
        self.page.wait_for_url("**/thanks", timeout=PATIENCE)
        return Course(begun.token, True, counted)

    def _answer(self, step: Step, given: dict[str, Any]) -> None:
        part = None if step["part"] == PAUSE.id else self.definition.part(step["part"])
        for cell in self.page.locator(".cell").all():  # each figure must have been in view
            cell.scroll_into_view_if_needed()
        if isinstance(part, Form):
            for name, value in given.items():
                self._field(name, value)
        elif isinstance(part, CommentPage):
            self.page.locator("textarea").last.fill(given["text"])
        elif isinstance(part, Trials):
            self._trial(part.task.kind, given)

    def _trial(self, kind: str, given: dict[str, Any]) -> None:
        if kind == "free_text":
            self.page.locator("textarea").first.fill(given["text"])
        elif kind in ("choose", "ab", "abx"):
            self.page.locator(f'input[name="choice"][value="{given["choice"]}"]').check(force=True)
        elif kind == "ranking":
            for name in sorted(given, key=lambda one: int(given[one])):
                self.page.locator(f'[data-line="{name}"] .place-button').click()
        else:
            for name, value in given.items():
                self._line(name, value)

    def _line(self, name: str, value: int) -> None:
        line = self.page.locator(f'[data-line="{name}"]')
        slider = line.locator('input[type="range"]')
        if slider.count():
            slider.fill(str(value))
            slider.press(" ")  # the very middle is where it stands anyway
        else:
            line.locator(f'input[value="{value}"]').click(force=True)

    def _field(self, name: str, value: str | int | list[str]) -> None:
        box = self.page.locator(f"#box-{name}")
        if box.count() and box.evaluate("box => box.tagName") == "SELECT":
            box.select_option(str(value))
        elif box.count() and box.evaluate("box => 'value' in box"):
            box.fill(str(value))
        else:
            for option in value if isinstance(value, list) else [value]:
                self.page.locator(f'input[name="{name}"][value="{option}"]').check(force=True)


def run(
    database: Database,
    plan: Plan,
    participants: int,
    browsers: int,
    address: str,
    generator: np.random.Generator,
    tell: Tell,
) -> list[Course]:
    """So many participants, in so many browsers at once.

    Raises:
        InvalidError: the study has targets to match.
        MannerError: Playwright or Chromium is missing, or no server answers at the address.
    """
    _refuse_matching(plan.definition)
    raters = simulation.raters(plan.tastes, plan.effects, participants, generator)
    shares = [raters[start::browsers] for start in range(min(browsers, participants))]
    done: list[Course] = []
    lock = Lock()

    def told(course: Course) -> None:
        with lock:
            done.append(course)
            tell(len(done))

    writer = Writer(database)
    try:
        with ThreadPoolExecutor(len(shares)) as pool:
            visit = partial(_share, writer, plan, address.rstrip("/"), told)
            list(pool.map(visit, shares))
    finally:
        writer.close()
    return done


def _refuse_matching(definition: StudyDefinition) -> None:
    for part in definition.trials:
        if isinstance(part.task, Match):
            raise InvalidError(
                f"In “{part.id}” targets are matched, which simulated browsers cannot do.",
                code="cannot_simulate",
                mend="Simulate without --browsers.",
            )


def _share(
    writer: Writer, plan: Plan, address: str, told: Callable[[Course], None], raters: list[Rater]
) -> None:
    with _browser() as browser:
        for rater in raters:
            begun = writer.write(partial(simulation.begin, slug=plan.slug, rater=rater))
            context = browser.new_context(viewport={"width": 1280, "height": 800})
            told(_Visit(context.new_page(), plan.definition, rater).take(address, begun))
            context.close()


@contextmanager
def _browser() -> Iterator[Browser]:
    try:
        from playwright.sync_api import Error, sync_playwright
    except ImportError as error:
        raise MannerError(
            "Browsers are driven by Playwright, which is not installed.",
            code="playwright_missing",
            mend="Install Manner with its extra for development: pip install 'manner[dev]'.",
        ) from error
    installed = next(filter(None, map(shutil.which, ("chromium", "chromium-browser"))), None)
    with sync_playwright() as playwright:
        try:
            browser = playwright.chromium.launch(executable_path=installed, args=ARGUMENTS)
        except Error as error:
            raise MannerError(
                f"Chromium does not start: {error.message.splitlines()[0]}",
                code="chromium_missing",
                mend="Install it: playwright install chromium.",
            ) from error
        try:
            yield browser
        except Error as error:
            raise MannerError(
                f"A simulated browser got stuck: {error.message.splitlines()[0]}",
                code="browser_stuck",
                mend="Is the server running at --address, with the same database?",
            ) from error
        finally:
            browser.close()
