"""What participants wait for: the page's weight, answers a second, the figure's part of a frame."""

from __future__ import annotations

import gzip
import os
import shutil
import statistics
import subprocess
import sys
from pathlib import Path

from playwright.sync_api import Browser, Page, Response, ViewportSize, expect, sync_playwright

from tests.bench import answers_load
from tests.bench.measure import RUNS, Row
from tests.browser.conftest import CHROMIUM_ARGUMENTS, set_up_researcher
from tests.browser.participant import begin
from tests.support.server import Server

# When each frame of a figure was drawn, in ms since the navigation began.
_NOTE_FRAMES = """window.drawn = [];
addEventListener("frame", () => window.drawn.push(performance.now()), true);"""
_SECOND_FRAME = """() => new Promise((done) => {
  const look = () => window.drawn.length > 1 ? done(window.drawn[1]) : setTimeout(look, 20);
  look();
})"""
# What the aim leaves out: figures and clips (GLB; unpacked ones are blobs) and fonts.
MOVES = 40  # of the pointer
DESKTOP = ViewportSize(width=1280, height=800)
_LEFT_OUT = (".glb", ".woff2")


def rows(scratch: Path) -> list[Row]:
    """All rows about the web side, on a server of its own with the sample library."""
    return [*answers(), *participant(scratch)]


def answers() -> list[Row]:
    """Durable answers a second at 32 clients: SQLite, synchronous=FULL."""
    runs = answers_load.measure(clients=32, seconds=4.0, runs=RUNS)
    speeds = [run.rate for run in runs]
    late = [run.percentile(95) for run in runs]
    what = "Answers, 32 clients, SQLite"
    return [
        _median(what, speeds, "answers/s", "≥ 600"),
        _median(f"{what}, p95", late, "ms", "≤ 120"),
    ]


def participant(scratch: Path) -> list[Row]:
    """The trial page's weight, and the main thread's work for one figure in a frame."""
    server = Server(scratch / "data")
    server.data_directory.mkdir()
    environment = {**os.environ, "MANNER_DATA_DIRECTORY": str(server.data_directory)}
    subprocess.run([sys.executable, "-m", "app.cli", "prepare"], env=environment, check=True)
    server.start()
    try:
        with sync_playwright() as playwright:
            chromium = shutil.which("chromium") or shutil.which("chromium-browser")
            browser = playwright.chromium.launch(executable_path=chromium, args=CHROMIUM_ARGUMENTS)
            page = browser.new_page(viewport={"width": 1280, "height": 800})
            found = [*_measure_trial(page, server), _first_figure(browser, server)]
            return [
                *found,
                _drag(browser.new_page(viewport={"width": 1280, "height": 800}), server),
            ]
    finally:
        server.stop()


def _measure_trial(page: Page, server: Server) -> list[Row]:
    sizes: dict[str, float] = {}

    def weigh(response: Response) -> None:
        url, body = response.url.split("?")[0], response.body()
        if not url.startswith("blob:") and not url.endswith(_LEFT_OUT) and "/api/" not in url:
            sizes[url] = len(gzip.compress(body, 6)) / 1000

    link = begin(page, server)
    page.goto("about:blank")  # what the first page still waits for must not be weighed
    page.wait_for_timeout(1000)
    page.on("requestfinished", lambda request: weigh(request.response()))
    page.goto(link)
    page.wait_for_selector("motion-viewer")
    page.wait_for_timeout(3000)
    work = []
    for _ in range(RUNS):
        page.wait_for_timeout(1000)
        work.append(
            page.evaluate("document.querySelector('motion-viewer').statistics.mainThreadMs")
        )
    return [
        Row("Participant's page, gzip", "Manner", sum(sizes.values()), "kB", "≤ 260"),
        _median("Pose and draw one figure, main thread", work, "ms/frame", "≤ 2"),
    ]


def _first_figure(browser: Browser, server: Server) -> Row:
    """From navigating to the trial page until its figure has moved; nothing is cached."""
    found = []
    for _ in range(RUNS):
        context = browser.new_context(viewport={"width": 390, "height": 844})
        page = context.new_page()
        link = begin(page, server)
        context.close()
        context = browser.new_context(viewport={"width": 390, "height": 844})
        context.add_init_script(_NOTE_FRAMES)
        page = context.new_page()
        page.goto(link)
        found.append(page.evaluate(_SECOND_FRAME))
        context.close()
    return _median("First figure moving, cold cache", found, "ms", "≤ 1500")


def _drag(page: Page, server: Server) -> Row:
    """From the pointer's move to the first frame of the new motion, in a space of 27 examples."""
    set_up_researcher(page, server)
    spaces = page.request.get(f"{server.url}/api/v1/spaces").json()["spaces"]
    walks = next(one["id"] for one in spaces if one["examples"] == 27)
    page.goto(f"{server.url}/studio/spaces/{walks}")
    stage = page.get_by_role("region", name="Stage")
    expect(stage).to_have_attribute("aria-busy", "false", timeout=60_000)
    box = page.get_by_role("slider", name="quickness").bounding_box()
    assert box is not None
    across = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + 0.5 * box["width"], across)
    page.mouse.down()
    for move in range(MOVES):
        page.mouse.move(box["x"] + (0.5 + 0.4 * move / MOVES) * box["width"], across)
        page.wait_for_timeout(120)
    page.mouse.up()
    page.wait_for_timeout(1000)
    times = page.evaluate("performance.getEntriesByName('manner:change').map((it) => it.duration)")
    return _median("Slider to new motion on screen, no graphics card", times, "ms", "≤ 100")


def _median(what: str, values: list[float], unit: str, aim: str) -> Row:
    return Row(what, "Manner", statistics.median(values), unit, aim, (min(values), max(values)))
