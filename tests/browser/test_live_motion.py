"""A viewer whose motion changes while it is looked at: other motions, poses from outside."""

from __future__ import annotations

import base64
import re
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Page, expect

from motion.clip import Clip
from motion.editing.tempo import change_tempo
from motion.figure.build import build_figure
from motion.glb import write_clip_glb, write_figure_glb
from motion.kinematics import forward_kinematics
from motion.procedural.library import sample_clips
from tests.browser.viewer_page import Show, ready, serve, shower, until

pytestmark = pytest.mark.browser

VIEWER = "document.querySelector('motion-viewer')"
ONE = '<motion-viewer controls="none" loop="on" src="/clip.glb" figure="/figure.glb">'
PAIR = (
    '<motion-viewer controls="views" figure="/figure.glb">'
    '<motion-figure as="clay" label="Edited" src="/clip.glb"></motion-figure>'
    '<motion-figure as="original" ghost label="Original" src="/clip.glb"></motion-figure>'
    "</motion-viewer>"
)
STYLE = "body { margin: 0 } motion-viewer { height: 300px } "
STRIP = "document.querySelector('time-strip')"
WITH_STRIP = ONE + "</motion-viewer><time-strip></time-strip>"
# A fault in the middle of the motion, the strip bound to the viewer.
BIND = """() => {
  const viewer = document.querySelector("motion-viewer");
  const start = viewer.duration / 2;
  Object.assign(document.querySelector("time-strip"), { viewer, findings: [{ kind: "foot slip",
    part: "left foot", start, end: start, size: 0.007, unit: "m", limit: 0.005 }] });
}"""
# Gives figure 0 the motion of a file (base64) and tells what the viewer says to it.
SET = """async (file) => {
  const viewer = document.querySelector("motion-viewer");
  const bytes = Uint8Array.from(atob(file), (letter) => letter.charCodeAt(0));
  const seen = new Promise((done) => viewer.addEventListener("motion", done, { once: true }));
  try {
    viewer.setMotion(0, bytes.buffer);
  } catch (error) {
    return String(error);
  }
  return (await seen).detail.index;
}"""


@pytest.fixture(scope="module")
def clips() -> list[Clip]:
    """Two walks of one skeleton."""
    return [sample.clip for sample in islice(sample_clips(), 2)]


@pytest.fixture(scope="module")
def site(clips: list[Clip], tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Path, str]]:
    """A folder and the address under which it is served."""
    folder = tmp_path_factory.mktemp("live")
    (folder / "clip.glb").write_bytes(write_clip_glb(clips[0]))
    (folder / "figure.glb").write_bytes(write_figure_glb(build_figure(clips[0])))
    with serve(folder, STYLE) as address:
        yield folder, address


@pytest.fixture
def show(site: tuple[Path, str], page: Page) -> Show:
    """Open a page with some markup and the viewer's script."""
    page.set_viewport_size({"width": 400, "height": 420})
    return shower(page, *site)


@pytest.fixture
def strip(site: tuple[Path, str], page: Page) -> Page:
    """A viewer with a time strip that drives it."""
    page.set_viewport_size({"width": 640, "height": 560})
    shower(page, *site, entry="studio")(WITH_STRIP)
    ready(page)
    page.evaluate(BIND)
    expect(page.get_by_role("slider")).to_have_attribute("aria-valuenow", "0.00")
    return page


def _set_motion(page: Page, glb: bytes) -> object:
    return page.evaluate(SET, base64.b64encode(glb).decode())


def _joints(page: Page, figure: int = 0) -> np.ndarray:
    return np.reshape(page.evaluate(f"[...{VIEWER}.figures[{figure}].jointPositions()]"), (-1, 3))


def test_another_motion_is_shown_exactly_and_at_the_same_moment(
    show: Show, clips: list[Clip]
) -> None:
    page = show(ONE)
    ready(page)
    frame = clips[1].frames // 3
    seconds = frame * clips[1].frame_time
    page.evaluate(f"{VIEWER}.seek({seconds}), {VIEWER}.view('side')")
    assert _set_motion(page, write_clip_glb(clips[1])) == 0
    assert page.evaluate(f"{VIEWER}.currentTime") == pytest.approx(seconds)
    assert page.evaluate(f"[{VIEWER}.paused, {VIEWER}.preset]") == [True, "side"]
    world = forward_kinematics(clips[1]).positions
    assert np.abs(_joints(page) - world[frame]).max() < 1e-3


def test_a_playing_viewer_goes_on_playing_another_motion(show: Show, clips: list[Clip]) -> None:
    page = show(ONE)
    ready(page)
    page.evaluate(f"{VIEWER}.play()")
    _set_motion(page, write_clip_glb(clips[1]))
    assert page.evaluate(f"{VIEWER}.paused") is False
    before = page.evaluate(f"{VIEWER}.currentTime")
    until(page, f"{VIEWER}.currentTime !== {before}")


def test_the_moment_stays_within_a_shorter_motion(show: Show, clips: list[Clip]) -> None:
    page = show(ONE)
    ready(page)
    page.evaluate(f"{VIEWER}.seek({VIEWER}.duration)")
    short = change_tempo(clips[0], 2.0)
    _set_motion(page, write_clip_glb(short))
    assert page.evaluate(f"{VIEWER}.duration") == pytest.approx(short.duration)
    assert page.evaluate(f"{VIEWER}.currentTime") == pytest.approx(short.duration)
    assert np.abs(_joints(page) - forward_kinematics(short).positions[-1]).max() < 1e-3


def test_a_motion_for_another_skeleton_is_refused_by_name_and_the_old_one_stays(
    show: Show, clips: list[Clip]
) -> None:
    page = show(ONE)
    ready(page)
    before = _joints(page)
    hips = clips[0].skeleton.names[0]
    other = write_clip_glb(clips[0]).replace(f'"{hips}"'.encode(), f'"{hips[::-1]}"'.encode())
    said = _set_motion(page, other)
    assert hips in str(said)
    assert hips[::-1] in str(said)
    page.evaluate(f"{VIEWER}.seek(0)")
    assert np.array_equal(_joints(page), before)


def test_a_pose_from_outside_is_shown_exactly_while_the_clock_stands(
    show: Show, clips: list[Clip]
) -> None:
    page = show(ONE)
    ready(page)
    page.evaluate(f"{VIEWER}.play()")
    world = forward_kinematics(clips[1]).positions
    for frame in (0, 17, 40):
        root = clips[1].root_positions[frame].tolist()
        turns = clips[1].rotations[frame][:, [1, 2, 3, 0]].ravel().tolist()
        page.evaluate(f"([root, turns]) => {VIEWER}.setPose(0, root, turns)", [root, turns])
        assert np.abs(_joints(page) - world[frame]).max() < 1e-3
    assert page.evaluate(f"[{VIEWER}.live, {VIEWER}.paused]") == [True, True]
    # A frame is asked for at which the clock would show its own moment, if it had a say.
    drawn = page.evaluate(f"{VIEWER}.seek(0), {VIEWER}.statistics.frames")
    until(page, f"{VIEWER}.statistics.frames > {drawn}")
    assert np.abs(_joints(page) - world[40]).max() < 1e-3


def test_a_pose_of_another_number_of_joints_is_refused(show: Show) -> None:
    page = show(ONE)
    ready(page)
    said = page.evaluate(
        f"(() => {{ try {{ {VIEWER}.setPose(0, [0, 1, 0], [0, 0, 0, 1]) }}"
        " catch (error) { return error.message } })()"
    )
    assert "joints), not 3 and 4" in said


def test_the_original_stands_behind_beside_or_alone_without_a_reload(
    show: Show, clips: list[Clip]
) -> None:
    page = show(PAIR)
    ready(page)
    _set_motion(page, write_clip_glb(clips[1]))
    page.evaluate(f"{VIEWER}.seek({5 * clips[0].frame_time})")
    worlds = [forward_kinematics(clip).positions[5] for clip in reversed(clips)]
    for arrangement in ("beside", "one", "ghost"):
        page.evaluate(f"{VIEWER}.arrange = '{arrangement}'")
        for figure, world in enumerate(worlds):
            assert np.abs(_joints(page, figure) - world).max() < 1e-3
    expect(page.get_by_text("Original")).to_be_visible()
    page.evaluate(f"{VIEWER}.arrange = 'one'")
    expect(page.get_by_text("Original")).to_be_hidden()
    page.evaluate(f"{VIEWER}.setShown(0, false)")
    expect(page.get_by_text("Edited")).to_be_hidden()
    expect(page.get_by_text("Original")).to_be_visible()


def _time(page: Page) -> float:
    return page.evaluate(f"{VIEWER}.currentTime")


def test_keys_on_the_time_strip_step_by_frames(strip: Page, clips: list[Clip]) -> None:
    frame_time = clips[0].frame_time
    strip.get_by_role("slider").focus()
    strip.keyboard.press("ArrowRight")
    strip.keyboard.press("Shift+ArrowRight")
    assert _time(strip) == pytest.approx(11 * frame_time)
    strip.keyboard.press("ArrowLeft")
    assert _time(strip) == pytest.approx(10 * frame_time)
    expect(strip.get_by_role("slider")).to_have_attribute("aria-valuetext", re.compile("frame 11"))
    strip.keyboard.press("End")
    assert _time(strip) == pytest.approx(clips[0].duration)
    strip.keyboard.press("Home")
    assert _time(strip) == 0


def test_dragging_over_the_time_strip_seeks_and_playing_goes_on_after_it(
    strip: Page, clips: list[Clip]
) -> None:
    strip.evaluate(f"{VIEWER}.play()")
    box = strip.get_by_role("img", name="The left foot").bounding_box()
    assert box
    strip.mouse.move(box["x"] + box["width"] / 4, box["y"] + 5)
    strip.mouse.down()
    for share in (0.5, 0.75):
        strip.mouse.move(box["x"] + box["width"] * share, box["y"] + 40)
        near = pytest.approx(share * clips[0].duration, abs=2 * clips[0].frame_time)
        assert _time(strip) == near
        assert strip.evaluate(f"{VIEWER}.paused") is True
    strip.mouse.up()
    assert strip.evaluate(f"{VIEWER}.paused") is False


def test_a_fault_on_the_time_strip_is_named_and_leads_to_its_moment(
    strip: Page, clips: list[Clip]
) -> None:
    strip.get_by_role("button", name="left foot slides 7 mm").click()
    assert _time(strip) == pytest.approx(clips[0].duration / 2, abs=clips[0].frame_time)


def test_a_drag_along_the_ruler_repeats_that_part_only(strip: Page) -> None:
    box = strip.locator(".strip-ruler").bounding_box()
    assert box
    strip.mouse.move(box["x"] + box["width"] * 0.5, box["y"] + 12)
    strip.mouse.down()
    strip.mouse.move(box["x"] + box["width"] * 0.75, box["y"] + 12)
    strip.mouse.up()
    start, duration = strip.evaluate(f"[{STRIP}.loop.start, {VIEWER}.duration]")
    assert start == pytest.approx(duration / 2, abs=0.02)
    strip.get_by_role("button", name="Play", exact=True).click()
    until(strip, f"{VIEWER}.currentTime >= {start}")
    strip.get_by_role("button", name="Loop 0.").click()
    assert strip.evaluate(f"{STRIP}.loop") is None
