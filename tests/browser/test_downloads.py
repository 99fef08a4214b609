"""The results page's downloads in Chromium."""

from __future__ import annotations

import zipfile

import pytest
from playwright.sync_api import Page, expect

from tests.browser.accessibility import access_faults
from tests.browser.conftest import DESKTOP, PHONE
from tests.support.server import Server

pytestmark = pytest.mark.browser

RESULTS = "/research/studies/emotion-in-walking"


@pytest.fixture
def results(research_page: Page, server: Server) -> Page:
    expect(research_page.get_by_role("heading", name="Studies")).to_be_visible()
    research_page.goto(server.url + RESULTS)
    return research_page


def test_by_keyboard_the_menu_opens_gives_a_file_and_closes(results: Page, tmp_path):
    menu, panel = results.locator("details.downloads"), results.get_by_label("Downloads")
    menu.locator("summary").focus()
    results.keyboard.press("Enter")
    expect(panel).to_be_visible()
    for _ in range(7):
        results.keyboard.press("Tab")
    expect(results.get_by_role("link", name="Psych-DS dataset")).to_be_focused()
    with results.expect_download() as download:
        results.keyboard.press("Enter")
    assert download.value.suggested_filename == "emotion-in-walking-psych-ds.zip"
    download.value.save_as(tmp_path / "dataset.zip")
    assert zipfile.ZipFile(tmp_path / "dataset.zip").testzip() is None
    results.keyboard.press("Escape")
    expect(panel).to_be_hidden()
    expect(menu.locator("summary")).to_be_focused()


def test_going_elsewhere_closes_the_menu(results: Page):
    panel = results.get_by_label("Downloads")
    results.get_by_text("Download", exact=True).click()
    expect(panel).to_be_visible()
    results.get_by_role("heading", level=1).click()
    expect(panel).to_be_hidden()


@pytest.mark.parametrize(("size", "scheme"), [(DESKTOP, "light"), (PHONE, "dark")], ids=str)
def test_the_open_menu_fits_and_axe_finds_nothing(results: Page, size, scheme):
    results.set_viewport_size(size)
    results.emulate_media(color_scheme=scheme)
    results.get_by_text("Download", exact=True).click()
    links = results.get_by_label("Downloads").get_by_role("link")
    expect(links).to_have_count(8)
    for link in links.all():
        box = link.bounding_box()
        assert box["height"] >= 44
        assert 0 <= box["x"] < box["x"] + box["width"] <= size["width"]
    assert access_faults(results) == []
