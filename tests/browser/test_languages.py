"""From the welcome to the thanks in each language, with nothing said in another."""

from __future__ import annotations

import pytest
from playwright.sync_api import Browser, Page, expect

from app import messages
from app.persistence.engine import Database, make_engine
from app.persistence.models import ClipRecord
from tests.browser.accessibility import access_faults
from tests.browser.participant import keep_still
from tests.support.published import add_published
from tests.support.server import Server
from tests.support.three_languages import HEADINGS, SLUG, THANKS, three_languages

pytestmark = pytest.mark.browser

# Language to its name and what is said on the way: begin, the option, the step, on, the end.
WAYS = {
    "en": ("English", "Begin", "Yes", "rather happy", "Clip 1 of 2", "Next clip", "Finish"),
    "fi": ("Suomi", "Aloita", "Kyllä", "melko iloinen", "Liike 1 / 2", "Seuraava liike", "Valmis"),
    "ja": ("日本語", "始める", "はい", "やや うれしい", "動き 1 / 2", "次の動き", "終了する"),
}
SIZES = {"en": (1280, 800), "fi": (390, 844), "ja": (390, 844)}
# Everything that is written or said on the page, within the viewer as well.
SAID = """() => {
  const found = [];
  const walk = (root) => {
    for (const node of root.querySelectorAll("*")) {
      if (["SCRIPT", "STYLE", "NOSCRIPT"].includes(node.tagName)) continue;
      for (const name of ["aria-label", "title"]) found.push(node.getAttribute(name));
      for (const child of node.childNodes) if (child.nodeType === 3) found.push(child.data);
      if (node.shadowRoot) walk(node.shadowRoot);
    }
  };
  walk(document.body);
  return found.filter(Boolean).map((text) => text.trim().replace(/\\s+/g, " "));
}"""


@pytest.fixture(autouse=True)
def still(page: Page) -> None:
    keep_still(page.context)


@pytest.fixture
def study(server: Server) -> str:
    """The address of a study of two clips."""
    return publish(server)


def publish(server: Server, **running: str) -> str:
    """Put the study onto the server; its address."""
    engine = make_engine(f"sqlite:///{server.data_directory / 'manner.sqlite3'}")
    with Database(engine).writing() as db:
        clips = db.query(ClipRecord).filter(ClipRecord.name.like("set_a%")).order_by("name")
        add_published(db, three_languages([clip.id for clip in clips.limit(2)]), **running)
        db.commit()
    engine.dispose()
    return f"{server.url}/studies/{SLUG}"


def in_english(page: Page) -> list[str]:
    """What the page says that is an English text of the interface."""
    known = {
        text
        for message in messages.collect()
        for text in ([message.id] if isinstance(message.id, str) else message.id)
    }
    return [text for text in page.evaluate(SAID) if text in known - {""}]


@pytest.mark.parametrize("language", WAYS)
def test_a_study_can_be_taken_from_welcome_to_thanks(page: Page, study: str, language: str):
    name, begin, option, step, place, onward, end = WAYS[language]
    width, height = SIZES[language]
    page.set_viewport_size({"width": width, "height": height})

    def look(where: str) -> None:
        expect(page.locator("html")).to_have_attribute("lang", language)
        assert language == "en" or in_english(page) == [], where
        assert access_faults(page) == [], where

    page.goto(study)
    page.get_by_role("link", name=name).focus()
    page.keyboard.press("Enter")
    expect(page.get_by_role("heading", name=HEADINGS[language])).to_be_visible()
    expect(page.locator(".languages [aria-current]")).to_have_text(name)
    expect(page.get_by_role("button", name=begin)).to_be_visible()
    look("welcome")

    page.get_by_role("checkbox").check()
    page.get_by_role("button", name=begin).click()
    page.get_by_role("radio", name=option).check()
    look("form")
    page.locator(".next").click()

    expect(page.locator(".place")).to_contain_text(place, timeout=60_000)
    for button in (onward, end):
        expect(page.locator(".next")).to_be_enabled(timeout=60_000)
        expect(page.locator(".next")).to_have_text(button)
        page.get_by_role("radio", name=step, exact=True).check(force=True)
        if button == onward:
            look("trial")
        page.locator(".next").click()
        expect(page.locator(".next", has_text=button)).to_have_count(0)

    expect(page.get_by_role("heading", name=THANKS[language])).to_be_visible(timeout=60_000)
    look("thanks")


def test_a_time_of_opening_is_told_in_the_readers_own_time_zone(browser: Browser, server: Server):
    address = publish(server, opens_at="2100-03-01T18:05:00+00:00")
    context = browser.new_context(timezone_id="Asia/Tokyo", locale="ja-JP")
    page = context.new_page()
    page.goto(address)
    expect(page.locator("time")).to_have_text("2100年3月2日 3:05")
    context.close()


def test_an_english_page_fetches_no_japanese_letters(page: Page, study: str):
    fonts: list[str] = []
    page.on("request", lambda request: fonts.append(request.url))
    page.goto(f"{study}?lang=en")
    page.wait_for_load_state("networkidle")
    assert [url for url in fonts if "noto" in url or "japanese" in url] == []
    page.goto(f"{study}?lang=ja")
    page.wait_for_load_state("networkidle")
    parts = [url for url in fonts if "noto-sans-jp" in url]
    assert 0 < len(parts) < 60, "only the parts whose letters stand on the page"
