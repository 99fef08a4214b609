"""The viewer by itself, from the built bundle, under the same content policy as on a page."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import islice
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Page, expect

from motion.clip import Clip
from motion.figure.build import build_figure
from motion.glb import write_clip_glb, write_figure_glb
from motion.kinematics import forward_kinematics
from motion.procedural.library import sample_clips
from tests.browser.viewer_page import Show, ready, serve, shower, until

pytestmark = pytest.mark.browser

VIEWER = "document.querySelector('motion-viewer')"
ONE = '<motion-viewer controls="{controls}" src="/clip0.glb" figure="/figure.glb"></motion-viewer>'
QUICKER = 0.7
STYLE = "body { margin: 0; background: #f4f3f0 } motion-viewer { height: 300px } "
CARD = "motion-thumbnail { width: 100px; height: 110px; display: inline-block }"
# Counts the contexts that draw; a probe that gives its context back at once is none of them.
COUNT_CONTEXTS = """
window.contexts = [];
const original = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
  const context = original.call(this, kind, ...rest);
  if (kind.startsWith("webgl") && context && !window.contexts.includes(context))
    window.contexts.push(context);
  return context;
};
"""
NO_WEBGL = """
const original = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
  return kind.startsWith("webgl") ? null : original.call(this, kind, ...rest);
};
"""


@pytest.fixture(scope="module")
def clips() -> list[Clip]:
    """Two walks of one skeleton."""
    return [sample.clip for sample in islice(sample_clips(), 2)]


@pytest.fixture(scope="module")
def site(clips: list[Clip], tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Path, str]]:
    """A folder and the address under which it is served."""
    folder = tmp_path_factory.mktemp("viewer")
    for index, clip in enumerate(clips):
        (folder / f"clip{index}.glb").write_bytes(write_clip_glb(clip))
    quick = replace(clips[0], frame_time=QUICKER * clips[0].frame_time)
    (folder / "quick.glb").write_bytes(write_clip_glb(quick))
    (folder / "figure.glb").write_bytes(write_figure_glb(build_figure(clips[0])))
    with serve(folder, STYLE + CARD) as address:
        yield folder, address


@pytest.fixture
def show(site: tuple[Path, str], page: Page) -> Show:
    """Open a page with some markup and the viewer's script."""
    page.set_viewport_size({"width": 400, "height": 420})
    return shower(page, *site)


def _get(page: Page, expression: str) -> object:
    return page.evaluate(f"{VIEWER}.{expression}")


def test_the_figure_stands_exactly_where_its_motion_says(show: Show, clips: list[Clip]) -> None:
    page = show(ONE.format(controls="none"))
    ready(page)
    world = forward_kinematics(clips[0]).positions
    for frame in (0, clips[0].frames // 3, clips[0].frames - 2):
        seconds = frame * clips[0].frame_time
        shown = page.evaluate(
            f"{VIEWER}.seek({seconds}), [...{VIEWER}.figures[0].jointPositions()]"
        )
        assert np.abs(np.reshape(shown, (-1, 3)) - world[frame]).max() < 1e-3


def test_between_two_frames_the_figure_is_between_them(show: Show, clips: list[Clip]) -> None:
    page = show(ONE.format(controls="none"))
    ready(page)
    world = forward_kinematics(clips[0]).positions
    seconds = 7.5 * clips[0].frame_time
    shown = page.evaluate(f"{VIEWER}.seek({seconds}), [...{VIEWER}.figures[0].jointPositions()]")
    assert np.abs(np.reshape(shown, (-1, 3)) - (world[7] + world[8]) / 2).max() < 2e-3


def test_several_figures_keep_step_in_one_context(
    show: Show, page: Page, clips: list[Clip]
) -> None:
    page.add_init_script(COUNT_CONTEXTS)
    figures = "".join(
        f'<motion-figure as="{role}" label="{role}" src="/clip{index}.glb"></motion-figure>'
        for index, role in enumerate(("reference", "judged"))
    )
    show(f'<motion-viewer controls="none" figure="/figure.glb">{figures}</motion-viewer>')
    ready(page)
    seconds = 5 * clips[0].frame_time
    page.evaluate(f"{VIEWER}.seek({seconds})")
    for index, clip in enumerate(clips):
        shown = page.evaluate(f"[...{VIEWER}.figures[{index}].jointPositions()]")
        frame = round(seconds / clip.frame_time)
        world = forward_kinematics(clip).positions[frame]
        assert np.abs(np.reshape(shown, (-1, 3)) - world).max() < 1e-3
    assert page.evaluate("contexts.filter((context) => !context.isContextLost()).length") == 1
    expect(page.get_by_text("judged")).to_be_visible()


def test_in_step_the_others_are_as_far_as_the_first(show: Show, clips: list[Clip]) -> None:
    figures = "".join(
        f'<motion-figure src="/{name}.glb"></motion-figure>' for name in ("clip0", "quick")
    )
    page = show(
        f'<motion-viewer in-step controls="none" figure="/figure.glb">{figures}</motion-viewer>'
    )
    ready(page)
    assert _get(page, "duration") == pytest.approx(clips[0].duration, abs=1e-3)
    world = forward_kinematics(clips[0]).positions
    for frame in (3, clips[0].frames // 2, clips[0].frames - 2):
        page.evaluate(f"{VIEWER}.seek({frame * clips[0].frame_time})")
        for index in (0, 1):
            shown = page.evaluate(f"[...{VIEWER}.figures[{index}].jointPositions()]")
            assert np.abs(np.reshape(shown, (-1, 3)) - world[frame]).max() < 1e-3


def test_viewers_and_thumbnails_of_a_page_share_one_context(show: Show, page: Page) -> None:
    page.add_init_script(COUNT_CONTEXTS)
    card = '<motion-thumbnail src="/clip1.glb" figure="/figure.glb"></motion-thumbnail>'
    show(ONE.format(controls="none") + 3 * card)
    ready(page)
    until(
        page,
        "[...document.querySelectorAll('motion-thumbnail')].every((thumbnail) => {"
        "  const canvas = thumbnail.shadowRoot.querySelector('canvas');"
        "  const { width, height } = canvas;"
        "  const { data } = canvas.getContext('2d').getImageData(0, 0, width, height);"
        "  return data.some((value) => value > 0); })",
    )
    assert page.evaluate("contexts.filter((context) => !context.isContextLost()).length") == 1


def test_a_card_moves_while_it_is_looked_at_and_goes_back_to_its_still(show: Show) -> None:
    page = show(
        '<a href="#"><motion-thumbnail src="/clip1.glb" figure="/figure.glb" poster-time="0.2">'
        "</motion-thumbnail></a>" + ONE.format(controls="none")
    )
    card = "document.querySelector('motion-thumbnail')"
    picture = f"{card}.shadowRoot.querySelector('canvas').toDataURL()"
    ready(page)
    until(page, f"{card}.drawn")
    still = page.evaluate(picture)
    page.get_by_role("link").focus()
    until(page, f"{picture} !== '{still}'")
    page.get_by_role("link").blur()
    until(page, f"{picture} === '{still}'")


def test_the_keyboard_reaches_everything(show: Show, clips: list[Clip]) -> None:
    page = show(ONE.format(controls="full"))
    ready(page)
    frame_time, duration = clips[0].frame_time, clips[0].duration
    page.get_by_role("application").focus()
    page.keyboard.press("Space")
    assert _get(page, "paused") is False
    page.keyboard.press("Space")
    assert _get(page, "paused") is True
    page.keyboard.press("Home")
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Shift+ArrowRight")
    assert _get(page, "currentTime") == pytest.approx(11 * frame_time)
    page.keyboard.press("ArrowLeft")
    assert _get(page, "currentTime") == pytest.approx(10 * frame_time)
    page.keyboard.press("End")
    assert _get(page, "currentTime") == pytest.approx(duration)
    page.keyboard.press("]")
    assert _get(page, "speed") == 1.5
    looping = _get(page, "loop")
    page.keyboard.press("l")
    assert _get(page, "loop") is not looping
    page.keyboard.press("Alt+ArrowLeft")
    assert _get(page, "cameraMoved") is True
    page.keyboard.press("0")
    until(page, f"!{VIEWER}.cameraMoved")
    assert _get(page, "statistics.cameraMoves") == 2


def test_a_participant_cannot_change_the_pace_of_what_is_judged(show: Show) -> None:
    page = show(ONE.format(controls="simple"))
    ready(page)
    page.get_by_role("application").focus()
    looping = _get(page, "loop")
    for key in ("]", "[", "l"):
        page.keyboard.press(key)
    assert (_get(page, "speed"), _get(page, "loop")) == (1, looping)


def test_dragging_turns_the_view_and_is_counted_once(show: Show) -> None:
    page = show(ONE.format(controls="simple"))
    ready(page)
    page.mouse.move(200, 120)
    page.mouse.down()
    page.mouse.move(260, 120, steps=5)
    page.mouse.up()
    assert (_get(page, "cameraMoved"), _get(page, "statistics.cameraMoves")) == (True, 1)
    page.get_by_role("button", name="Reset the view").click()
    until(page, f"!{VIEWER}.cameraMoved")


def test_scrubbing_with_the_keyboard_steps_by_frames(show: Show, clips: list[Clip]) -> None:
    page = show(ONE.format(controls="simple"))
    ready(page)
    slider = page.get_by_role("slider", name="Place in the motion")
    slider.focus()
    page.keyboard.press("ArrowRight")
    assert _get(page, "currentTime") == pytest.approx(clips[0].frame_time)


def test_nothing_is_drawn_while_paused(show: Show) -> None:
    page = show(ONE.format(controls="none"))
    ready(page)
    page.evaluate(f"{VIEWER}.play()")
    until(page, f"{VIEWER}.statistics.frames > 3")
    page.evaluate(f"{VIEWER}.pause()")
    two_frames = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
    page.evaluate(two_frames)
    before = _get(page, "statistics.frames")
    for _ in range(10):
        page.evaluate(two_frames)
    assert _get(page, "statistics.frames") == before


def test_a_motion_that_does_not_arrive_is_said_and_can_be_asked_for_again(
    show: Show, site: tuple[Path, str]
) -> None:
    folder, _ = site
    page = show('<motion-viewer src="/late.glb" figure="/figure.glb"></motion-viewer>')
    expect(page.get_by_text("The motion did not arrive")).to_be_visible()
    (folder / "late.glb").write_bytes((folder / "clip0.glb").read_bytes())
    page.get_by_role("button", name="Try again").click()
    ready(page)
    expect(page.get_by_text("The motion did not arrive")).to_be_hidden()


def test_a_browser_without_webgl_says_so_and_what_helps(show: Show, page: Page) -> None:
    page.add_init_script(NO_WEBGL)
    page.add_init_script(
        "document.addEventListener('unsupported', () => { window.told = true }, true);"
    )
    show(ONE.format(controls="simple"))
    expect(page.get_by_text("The figure cannot be drawn here.")).to_be_visible()
    assert page.evaluate("window.told") is True


def test_the_page_s_policy_is_kept_and_nothing_is_complained_about(show: Show, page: Page) -> None:
    said: list[str] = []
    page.on("console", lambda message: said.append(f"{message.type}: {message.text}"))
    page.on("pageerror", lambda error: said.append(str(error)))
    show(ONE.format(controls="full"))
    ready(page)
    page.evaluate(f"{VIEWER}.play()")
    until(page, f"{VIEWER}.statistics.frames > 3")
    # Chromium itself remarks on slow reads of pixels without a graphics card.
    assert [line for line in said if "GPU stall due to ReadPixels" not in line] == []
