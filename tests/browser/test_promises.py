"""What participants and researchers are promised, in the worst weather.

The other promises have their tests beside what they are about: see `docs/promises.md`.
"""

from __future__ import annotations

import json
import os
import shutil
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import BrowserContext, BrowserType, Page, Route, expect

from tests.browser.conftest import CHROMIUM_ARGUMENTS, DESKTOP
from tests.browser.participant import (
    answer,
    begin,
    choose_planned,
    expect_stored,
    keep_still,
    stored,
    wait_for_clip,
    wait_until_saved,
)
from tests.support.server import Server

pytestmark = pytest.mark.browser
RESPONSES = "**/api/v1/sessions/*/responses"
DAY_MS = 86_400_000


@pytest.fixture(autouse=True)
def still(page: Page) -> None:
    keep_still(page.context)


@pytest.fixture
def profile(browser_type: BrowserType, tmp_path: Path) -> Iterator[Any]:
    """Opens one and the same browser profile again and again, as a person does."""
    opened: list[BrowserContext] = []

    def open_profile() -> BrowserContext:
        context = browser_type.launch_persistent_context(
            tmp_path / "profile",
            executable_path=shutil.which("chromium") or shutil.which("chromium-browser"),
            args=CHROMIUM_ARGUMENTS,
            viewport=DESKTOP,
        )
        keep_still(context)
        opened.append(context)
        return context

    yield open_profile
    for context in opened[1:]:
        context.close()


def kill_browser(folder: Path) -> None:
    """End the browser of a profile as a crash does: no page learns of it."""
    for process in Path("/proc").glob("[0-9]*"):
        try:
            command = (process / "cmdline").read_bytes().decode().split("\0")
        except (OSError, UnicodeDecodeError):
            continue
        if f"--user-data-dir={folder}" in command and "--type=" not in " ".join(command):
            os.kill(int(process.name), signal.SIGKILL)


def test_a_browser_killed_in_the_middle_loses_nothing_that_was_answered(
    profile: Any, server: Server, tmp_path: Path
) -> None:
    context = profile()
    page = context.pages[0]
    link = begin(page, server)
    answer(page, 0)
    answer(page, 1)
    wait_until_saved(page)
    kill_browser(tmp_path / "profile")

    (tmp_path / "profile" / "SingletonLock").unlink(missing_ok=True)
    page = profile().pages[0]
    page.goto(link)
    wait_for_clip(page, 3)
    answer(page, 2)
    wait_until_saved(page)
    expect_stored(server, 3)


def test_requests_that_are_replayed_and_come_in_another_order_store_each_answer_once(
    page: Page, server: Server
) -> None:
    begin(page, server)
    sent: list[tuple[str, dict[str, str], str]] = []

    def keep(route: Route) -> None:
        request = route.request
        sent.append((request.url, request.headers, request.post_data or ""))
        route.continue_()

    page.route(RESPONSES, keep)
    for trial in range(3):
        answer(page, trial)
    wait_until_saved(page)
    for url, headers, body in [*reversed(sent), *sent]:
        again = page.request.post(url, headers=headers, data=body)
        assert again.status == 200
        assert again.json()["trial_index"] == json.loads(body)["trial_index"]
    expect_stored(server, 3)


def test_a_minute_without_a_connection_loses_nothing_and_goes_on_by_itself(
    page: Page, server: Server
) -> None:
    begin(page, server)
    answer(page, 0)
    wait_until_saved(page)
    page.context.set_offline(True)
    for trial in range(1, 3):  # whose clips lie ready
        answer(page, trial)
    page.wait_for_timeout(60_000)  # the minute itself is what is tested
    expect(page.get_by_text("2 answers are kept on this device")).to_be_visible()
    expect_stored(server, 1)
    page.context.set_offline(False)
    wait_until_saved(page)
    answer(page, 3)
    wait_until_saved(page)
    expect_stored(server, 4)


def test_a_line_of_400_kbit_a_second_takes_a_person_through_clip_after_clip(
    page: Page, server: Server
) -> None:
    network = page.context.new_cdp_session(page)
    network.send("Network.enable")
    network.send(
        "Network.emulateNetworkConditions",
        {
            "offline": False,
            "latency": 300,
            "downloadThroughput": 400_000 / 8,
            "uploadThroughput": 400_000 / 8,
        },
    )
    page.set_default_timeout(120_000)
    begin(page, server)
    for trial in range(3):
        answer(page, trial)
    wait_until_saved(page)
    expect_stored(server, 3)


@pytest.mark.parametrize("days", [-1, 1])
def test_a_clock_wrong_by_a_day_changes_no_time_that_counts(
    page: Page, server: Server, days: int
) -> None:
    page.add_init_script(
        f"""const real = Date.now; const off = {days * DAY_MS};
        Date = class extends Date {{
          constructor(...given) {{ given.length ? super(...given) : super(real() + off); }}
          static now() {{ return real() + off; }}
        }};"""
    )
    begin(page, server)
    answer(page, 0)
    page.reload()
    wait_for_clip(page, 2)
    answer(page, 1)
    wait_until_saved(page)
    expect_stored(server, 2)
    for row in stored(server):
        assert 0 < row.rt_ms < 600_000
        assert row.rt_ms <= row.record["time_elapsed_ms"] < 600_000


def test_the_clock_that_jumps_while_a_trial_is_on_makes_no_negative_time(
    page: Page, server: Server
) -> None:
    begin(page, server)
    page.evaluate(f"Date.now = () => new Date().getTime() - {DAY_MS}")
    choose_planned(page, 0)
    page.locator(".next").click()
    wait_until_saved(page)
    (row,) = stored(server)
    assert 0 < row.rt_ms < 600_000
