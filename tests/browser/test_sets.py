"""A researcher makes a set of clips, stops one, and gives a program a key."""

from __future__ import annotations

import json
import re
import urllib.error
import urllib.request
from collections.abc import Iterator

import pytest
from playwright.sync_api import Page, expect

from tests.browser.accessibility import access_faults
from tests.browser.conftest import DESKTOP, PHONE
from tests.support.server import Server

PATIENCE = 240_000  # milliseconds for work of the server: CI is slow


@pytest.fixture(autouse=True)
def patient(page: Page) -> Iterator[None]:
    """On a slow machine a page's next state may take far longer than the usual five seconds."""
    page.set_default_timeout(PATIENCE)
    expect.set_options(timeout=PATIENCE)
    yield
    expect.set_options(timeout=5_000)


def test_foergers_twenty_clips_are_made_by_one_button(research_page: Page, server: Server) -> None:
    page = research_page
    page.goto(f"{server.url}/research/sets")
    page.get_by_role("button", name="Förger’s 20 modified clips").click()
    expect(page.get_by_role("heading", name="20 clips")).to_be_visible()
    names = page.get_by_role("textbox", name=re.compile("^Name for"))
    expect(names).to_have_count(20)
    first = page.get_by_role("textbox", name="Name for acted_female_neutral, sad")
    expect(first).to_have_value("acted_female_neutral · sad")
    first.fill("Mourning woman")
    page.get_by_role("button", name="Make them").click()

    expect(page.get_by_role("progressbar", name="Clips made")).to_be_visible()
    done = page.get_by_role("heading", name="All 20 clips are made.")
    expect(done).to_be_visible()
    expect(done).to_be_focused()
    cards = page.locator(".set-job .clip-card")
    expect(cards).to_have_count(20)
    made = page.request.get(f"{server.url}/api/v1/clips", params={"tag": "set:foerger-modified"})
    clips = {clip["name"]: clip for clip in made.json()["clips"]}
    assert len(clips) == 20
    mourning = clips["Mourning woman"]
    assert mourning["tags"] == {
        "set": "foerger-modified",
        "body": "female",
        "emotion": "sad",
        "preset": "sad",
        "made": "modified",
        "from": "acted_female_neutral",
        "synthetic": "yes",
    }
    page.get_by_role("link", name="Mourning woman").click()
    expect(page.get_by_role("heading", name="Mourning woman")).to_be_visible()
    page.go_back()  # the address keeps the set
    expect(page.get_by_role("heading", name="All 20 clips are made.")).to_be_visible()
    page.get_by_role("button", name="Another set").click()
    page.get_by_role("button", name="Förger’s 20 modified clips").click()
    expect(page.get_by_text("all in the library already")).to_be_visible()


def test_a_set_is_chosen_by_keyboard_changed_and_stopped(
    research_page: Page, server: Server
) -> None:
    page = research_page
    page.goto(f"{server.url}/research/sets")
    expect(page.get_by_role("heading", name="Nothing chosen yet")).to_be_visible()
    page.get_by_placeholder("Name, style or tag").fill("set B")
    page.get_by_role("button", name=re.compile(r"^All \d+$")).press("Enter")
    for preset in ("Sad", "Angry", "Strong"):
        page.get_by_role("button", name=preset, exact=True).press("Enter")
    chosen = page.locator(".set-clips input:checked").count()
    assert chosen > 20
    expect(page.get_by_role("heading", name=f"{3 * chosen} clips")).to_be_visible()
    out = page.get_by_role("button", name=re.compile("^Leave out"))
    out.first.press("Enter")
    expect(page.get_by_role("heading", name=f"{3 * chosen - 1} clips")).to_be_visible()
    expect(out.first).to_be_focused()
    page.get_by_label("Name of the set").fill("pilot")
    page.get_by_role("button", name="Make them").press("Enter")
    expect(page.get_by_role("heading", name=re.compile("Making|Waiting"))).to_be_focused()
    page.get_by_role("button", name="Stop").press("Enter")
    stopped = page.get_by_role("heading", name=re.compile("^Stopped"))
    expect(stopped).to_be_visible()
    (job,) = page.request.get(f"{server.url}/api/v1/jobs").json()["jobs"]
    assert job["state"] == "cancelled"
    assert job["done"] < job["total"] == 3 * chosen - 1
    kept = page.request.get(f"{server.url}/api/v1/clips", params={"tag": "set:pilot"})
    assert len(kept.json()["clips"]) == job["done"]


def test_a_page_that_cannot_reach_the_server_says_so_and_tries_again(
    research_page: Page, server: Server
) -> None:
    page = research_page
    page.route("**/api/v1/presets", lambda route: route.abort())
    page.goto(f"{server.url}/research/sets")
    expect(page.get_by_role("alert")).to_contain_text("did not answer")
    page.unroute("**/api/v1/presets")
    page.get_by_role("button", name="Try again").click()
    expect(page.get_by_role("button", name="Energetic sadness")).to_be_visible()


def test_a_key_is_shown_once_and_revoked(research_page: Page, server: Server) -> None:
    page = research_page
    page.goto(server.url)
    page.goto(f"{server.url}/library")
    page.get_by_role("link", name="API keys").click()
    page.get_by_label("What it is for").fill("Notebook")
    page.get_by_role("button", name="Make the key").click()
    key = page.locator("#secret").inner_text()
    assert key.startswith("mnr_")
    assert key not in page.url
    assert status(f"{server.url}/api/v1/jobs", key) == 200
    page.get_by_role("button", name="Copy the key").click()
    expect(page.get_by_role("button", name=re.compile("Copied|Ctrl"))).to_be_visible()

    page.goto(f"{server.url}/research/keys")
    expect(page.get_by_text(f"mnr_…{key[-4:]}")).to_be_visible()
    assert key not in page.content()
    page.locator("summary", has_text="Revoke").click()
    page.get_by_role("button", name="Revoke “Notebook”").click()
    expect(page.get_by_text("revoked", exact=True)).to_be_visible()
    assert status(f"{server.url}/api/v1/jobs", key) == 401
    assert key not in server.log


@pytest.mark.parametrize(("size", "scheme"), [(DESKTOP, "light"), (PHONE, "dark")], ids=str)
def test_keys_and_sets_are_accessible_and_fit(
    research_page: Page, server: Server, size: dict, scheme: str
) -> None:
    page = research_page
    page.set_viewport_size(size)
    page.emulate_media(color_scheme=scheme)
    page.goto(f"{server.url}/research/keys")
    page.get_by_label("What it is for").fill("Notebook")
    page.get_by_role("button", name="Make the key").click()
    expect(page.locator("#secret")).to_be_visible()
    assert_sound(page)
    page.goto(f"{server.url}/research/sets")
    page.get_by_role("button", name="Förger’s 20 modified clips").click()
    expect(page.get_by_role("heading", name="20 clips")).to_be_visible()
    assert_sound(page)


def assert_sound(page: Page) -> None:
    """No fault that axe finds, and nothing wider than the window."""
    assert access_faults(page) == []
    wide = page.evaluate("document.documentElement.scrollWidth - innerWidth")
    assert wide <= 0


def status(address: str, key: str) -> int:
    """What a program with this key is answered."""
    request = urllib.request.Request(address, headers={"Authorization": f"Bearer {key}"})
    try:
        with urllib.request.urlopen(request) as answer:
            json.load(answer)
            return int(answer.status)
    except urllib.error.HTTPError as refused:
        return refused.code
