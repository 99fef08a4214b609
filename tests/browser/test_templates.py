"""Every template from the welcome to the thanks, on a phone and a desktop, in three languages.

With fewer clips than it has, since what is shown once is shown forty times alike, each language
on one of the sizes, and axe in one language; whole, and all of it on both: `make test-long`.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import pytest
from playwright.sync_api import Browser, Page, expect

from app.persistence import researchers
from app.persistence.engine import Database, make_engine
from app.schemas.study import LANGUAGES
from app.services import command_line_studies, study_files
from app.studies import TEMPLATES
from tests.browser.accessibility import access_faults
from tests.browser.participant import keep_still
from tests.support.server import Server

pytestmark = pytest.mark.browser

SIZES = ({"width": 390, "height": 844}, {"width": 1280, "height": 800})
LONG = 60_000


class Here:
    """Does in this process what workers do."""

    def run(self, _: str, function, *arguments):
        return function(*arguments)

    def close(self) -> None:
        pass


@contextmanager
def library(server: Server) -> Iterator[Database]:
    engine = make_engine(f"sqlite:///{server.data_directory / 'manner.sqlite3'}")
    yield Database(engine)
    engine.dispose()


def built(name: str) -> dict:
    """The template; what is to be matched matches at once, or every trial would take minutes."""
    document = TEMPLATES[name].build()
    trials(document)["task"] |= {"threshold": 1} if name == "matching" else {}
    return document


def trials(document: dict) -> dict:
    return next(part for part in document["parts"] if part["kind"] == "trials")


def shortened(name: str) -> dict:
    """The template with as few clips as its kind of trial can do with."""
    document = built(name)
    part = trials(document)
    if name == "matching":
        part["task"]["practice_targets"] = []
    if name == "emotion":
        part |= {"stimuli": part["stimuli"][-1:], "practice": 0}  # a modified one
    elif name == "side-by-side":
        part["sets"] = part["sets"][:1]
    elif name == "more-natural":
        part["stimuli"] = part["stimuli"][:2]
    elif name != "most-natural":
        part["stimuli"] = part["stimuli"][:1]
    return document


def publish(server: Server, name: str, *, whole: bool = False) -> str:
    """Put the template onto the server; its address."""
    document = built(name) if whole else shortened(name)
    file = study_files.read(study_files.write(document), f"{name}.yaml")
    assert file.faults == []
    with library(server) as database:
        with database.writing() as db:
            researchers.add(db, email="rosa@example.org", name="Rosa", password_hash="-")
            db.commit()
        command_line_studies.publish(database, file, None)
    return f"{server.url}/studies/{file.definition.slug}"


def answer(page: Page, kind: str) -> None:
    """Answer the step that is shown."""
    if kind == "semantic_differential":
        for index, line in enumerate(page.locator("[data-line]").all()):
            line.locator("input").nth(index % 5).click()
    elif kind in ("choose", "ab"):
        page.keyboard.press("1")
    elif kind == "parallel":
        for slider in page.locator(".slider input").all():
            slider.press("ArrowRight")
    elif kind == "match" and page.locator(".match-note").count():  # a guess
        page.locator(".match-sliders input:enabled").first.press("ArrowRight")
    page.locator(".next").click(timeout=LONG)


def take_part(page: Page, address: str, language: str, *, axe: bool = True) -> list[str]:
    """Go from the welcome to the thanks; the kinds of the steps on the way."""
    page.goto(f"{address}?lang={language}")
    expect(page.locator("html")).to_have_attribute("lang", language)
    assert not axe or access_faults(page) == []
    page.get_by_role("checkbox").check()
    page.locator("form button[type=submit]").first.click()
    page.wait_for_url("**/take/*", timeout=LONG)
    token = page.url.rsplit("/", 1)[1].partition("?")[0]
    session = page.request.get(page.url.partition("/take/")[0] + f"/api/v1/sessions/{token}")
    kinds = [step["kind"] for step in session.json()["steps"]]
    seen: set[str] = set()
    for index, kind in enumerate(kinds):
        expect(page.locator(".place progress")).to_have_js_property("value", index, timeout=LONG)
        expect(page.locator(".back")).to_be_enabled(timeout=LONG)
        if kind not in seen:
            seen.add(kind)
            assert not axe or access_faults(page) == [], kind
            overflow = page.evaluate("document.documentElement.scrollWidth - innerWidth")
            assert overflow <= 0, kind
        answer(page, kind)
    page.wait_for_url("**/thanks", timeout=LONG)
    expect(page.locator("html")).to_have_attribute("lang", language)
    return kinds


@pytest.mark.parametrize("name", TEMPLATES)
def test_a_template_runs_from_the_welcome_to_the_thanks(
    browser: Browser, server: Server, monkeypatch: pytest.MonkeyPatch, name: str
):
    monkeypatch.setattr(command_line_studies, "Workers", Here)
    address = publish(server, name)
    turn = list(TEMPLATES).index(name)  # so that every language comes up on both sizes
    for place, language in enumerate(LANGUAGES):
        context = browser.new_context(viewport=SIZES[(turn + place) % 2])
        keep_still(context)
        kinds = take_part(context.new_page(), address, language, axe=place == turn % 3)
        assert kinds[:2] == ["form", "instructions"]
        assert kinds[-2:] == ["comment", "debriefing"]
        assert len(kinds) >= 5
        context.close()


@pytest.mark.long
@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("size", SIZES, ids=("phone", "desktop"))
@pytest.mark.parametrize("name", TEMPLATES)
def test_a_whole_template_runs_in_every_size_and_language(
    browser: Browser, server: Server, name: str, size: dict, language: str
):
    address = publish(server, name, whole=True)
    context = browser.new_context(viewport=size)
    keep_still(context)
    kinds = take_part(context.new_page(), address, language)
    (part,) = (part for part in TEMPLATES[name].build()["parts"] if part["kind"] == "trials")
    alone = part["task"]["kind"] == "semantic_differential"
    least = len(part["stimuli"]) if alone else len(part.get("sets", ())) or 1
    assert kinds.count(part["task"]["kind"]) >= least
    context.close()
