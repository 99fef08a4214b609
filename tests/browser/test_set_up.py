"""The first minutes of a researcher: the set-up link, signing out and in again."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page, expect

from tests.browser.conftest import EMAIL, PASSWORD, set_up_researcher
from tests.support.server import Server

pytestmark = pytest.mark.browser


def test_the_set_up_link_makes_an_account_that_signs_out_and_in(page: Page, server: Server):
    set_up_researcher(page, server)
    page.get_by_role("button", name="Sign out").click()
    page.goto(server.url + "/research")
    page.get_by_label("Email address").fill(EMAIL)
    page.get_by_label("Password").fill(PASSWORD)
    page.get_by_role("button", name="Sign in").click()
    expect(page.get_by_role("heading", name="Studies")).to_be_visible()
    page.goto(server.set_up_link)  # used up
    expect(page.get_by_label("Password")).to_have_count(0)
