"""The studio in Chromium: edits shown, undone, compared, saved and taken along."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Locator, Page, expect
from scipy.spatial.transform import Rotation

from motion.bvh import read_bvh
from tests.browser.accessibility import access_faults
from tests.browser.conftest import DESKTOP, PHONE
from tests.motion.test_glb import run_node
from tests.support.server import Server

pytestmark = pytest.mark.browser

Array = NDArray[np.float64]
PATIENCE = 90_000  # ms: the first motion of a clip starts a process that computes
NEUTRAL = "path 1.00, as it is; timing 1.00, as it is"
VIEWER = "document.querySelector('motion-viewer')"


@pytest.fixture
def studio(research_page: Page, server: Server) -> Page:
    """The studio with a neutral walk, its first checks done."""
    open_studio(research_page, server)
    return research_page


def clip_id(page: Page, server: Server, name: str = "set_b_neutral_normal") -> str:
    clips = page.request.get(server.url + "/api/v1/clips").json()["clips"]
    return next(clip["id"] for clip in clips if clip["name"] == name)


def open_studio(page: Page, server: Server) -> None:
    page.goto(f"{server.url}/studio?clip={clip_id(page, server)}")
    expect(page.locator(".report .fine").first).to_be_attached(timeout=PATIENCE)
    settled(page)


def settled(page: Page) -> None:
    """Wait until the stage shows the recipe as it stands."""
    expect(page.get_by_role("region", name="Stage")).to_have_attribute(
        "aria-busy", "false", timeout=PATIENCE
    )


def preset(page: Page, name: str) -> Locator:
    return page.get_by_role("group", name="Presets").get_by_role("button", name=name, exact=True)


def choose(page: Page, name: str) -> None:
    preset(page, name).click()
    settled(page)


def pad(page: Page) -> Locator:
    return page.get_by_role("slider", name="Path length and timing")


def shown(page: Page, seconds: float, figure: int = 0) -> Array:
    """Where the joints (J, 3) of a figure are at a moment, in metres."""
    values = page.evaluate(
        f"{VIEWER}.pause(), {VIEWER}.seek({seconds}),"
        f" [...{VIEWER}.figures[{figure}].jointPositions()]"
    )
    return np.reshape(values, (-1, 3))


def apart(one: Array, other: Array) -> float:
    """The farthest that two poses are apart, in metres."""
    return float(np.abs(one - other).max())


def drag_across_pad(page: Page) -> None:
    box = pad(page).bounding_box()
    assert box
    page.mouse.move(box["x"] + box["width"] * 0.3, box["y"] + box["height"] * 0.3)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] * 0.8, box["y"] + box["height"] * 0.2, steps=8)
    page.mouse.up()


def test_a_preset_a_drag_undo_and_redo_are_what_the_stage_shows(studio: Page, faults: list[str]):
    page = studio
    original = shown(page, 0.4)
    assert apart(shown(page, 0.4, figure=1), original) < 1e-6
    choose(page, "sad")
    sad = shown(page, 0.4)
    assert apart(sad, original) > 0.02
    assert apart(shown(page, 0.4, figure=1), original) < 1e-6  # the original stays
    drag_across_pad(page)
    settled(page)
    assert apart(shown(page, 0.4), sad) > 0.02
    expect(pad(page)).to_have_attribute("aria-valuetext", re.compile("longer.*pauses"))
    page.keyboard.press("Control+z")  # the whole drag at once
    settled(page)
    expect(pad(page)).to_have_attribute("aria-valuetext", re.compile("path 0.40, shorter"))
    assert apart(shown(page, 0.4), sad) < 1e-6
    page.get_by_role("button", name="Undo").click()
    settled(page)
    expect(preset(page, "sad")).to_have_attribute("aria-pressed", "false")
    assert apart(shown(page, 0.4), original) < 1e-3  # the GLB's rounding
    page.keyboard.press("Control+Shift+z")
    settled(page)
    assert apart(shown(page, 0.4), sad) < 1e-6
    assert faults == []


def test_a_key_compares_with_the_original_and_the_ghost_comes_and_goes(studio: Page):
    page = studio
    viewer = page.locator("motion-viewer")
    original = page.get_by_role("group", name="Compare").get_by_role("button", name="A original")
    page.keyboard.press("c")
    expect(original).to_have_attribute("aria-pressed", "true")
    expect(viewer).to_have_attribute("arrange", "one")
    page.keyboard.press("c")
    expect(original).to_have_attribute("aria-pressed", "false")
    expect(viewer).to_have_attribute("arrange", "ghost")
    page.get_by_role("button", name="Beside").click()
    expect(viewer).to_have_attribute("arrange", "beside")
    page.get_by_role("button", name="Ghost").click()
    page.get_by_role("button", name="Ghost").click()
    expect(viewer).to_have_attribute("arrange", "one")


def test_one_control_is_reset_and_the_others_stay(studio: Page):
    page = studio
    choose(page, "strong")
    elbows = page.get_by_role("slider", name="elbows out")
    expect(elbows).not_to_have_value("0")
    page.get_by_role("button", name="Reset elbows out").click()
    expect(elbows).to_have_value("0")
    expect(pad(page)).not_to_have_attribute("aria-valuetext", NEUTRAL)
    page.get_by_role("button", name="Reset path and timing").click()
    expect(pad(page)).to_have_attribute("aria-valuetext", NEUTRAL)
    settled(page)


def test_an_edit_is_made_saved_and_opened_again_by_keyboard_alone(studio: Page):
    page = studio
    pad(page).focus()
    for key in ("ArrowLeft", "Shift+ArrowLeft", "ArrowUp"):
        page.keyboard.press(key)
    expect(pad(page)).to_have_attribute("aria-valuetext", "path 0.70, shorter; timing 1.05, pauses")
    page.get_by_label("Name of the variant").focus()
    page.keyboard.type("a little shy")
    save = page.get_by_role("button", name="Save")
    for _ in range(12):
        page.keyboard.press("Tab")
        if save.evaluate("button => button === document.activeElement"):
            break
    page.keyboard.press("Enter")
    expect(page.locator(".studio-title")).to_contain_text("· saved", timeout=PATIENCE)
    page.reload()
    expect(page.get_by_label("Name of the variant")).to_have_value("a little shy")
    expect(pad(page)).to_have_attribute("aria-valuetext", re.compile("path 0.70.*timing 1.05"))
    expect(page.locator(".variants")).to_contain_text("a little shy")


def test_a_captured_pose_and_a_variant_are_deleted_after_asking(studio: Page):
    page = studio
    asked: list[str] = []
    page.on("dialog", lambda dialog: (asked.append(dialog.message), dialog.accept()))
    choose(page, "strong")
    page.get_by_role("button", name="Capture pose from this frame").click()
    variant = page.locator(".variants li", has_text="strong")
    expect(variant).to_have_count(1, timeout=PATIENCE)
    delete_pose = page.get_by_role("button", name=re.compile(r"^Delete \d"))
    delete_pose.click(timeout=PATIENCE)
    expect(delete_pose).to_have_count(0)
    variant.get_by_role("button", name="Delete").click()
    expect(variant).to_have_count(0)
    expect(pad(page)).to_have_attribute("aria-valuetext", NEUTRAL, timeout=PATIENCE)
    assert [words.split(" “")[0] for words in asked] == ["Delete the pose", "Delete"]


def test_unsaved_edits_outlive_the_page_until_they_are_thrown_away(studio: Page):
    page = studio
    choose(page, "tired")
    page.reload()
    expect(page.get_by_text("These are your edits of last time")).to_be_visible(timeout=PATIENCE)
    expect(pad(page)).to_have_attribute("aria-valuetext", re.compile("path 0.00"))
    page.get_by_role("button", name="Start over").click()
    expect(pad(page)).to_have_attribute("aria-valuetext", NEUTRAL)
    page.reload()
    expect(page.locator(".studio-title")).to_contain_text("· saved", timeout=PATIENCE)


def test_without_a_connection_the_last_motion_stays_and_the_newest_edit_follows(studio: Page):
    page = studio
    before = shown(page, 0.4)
    page.route("**/api/v1/clips/preview", lambda route: route.abort())
    preset(page, "sad").click()
    expect(page.get_by_text("The server cannot be reached.")).to_be_visible()
    assert apart(shown(page, 0.4), before) < 1e-6
    page.unroute("**/api/v1/clips/preview")
    page.get_by_role("button", name="Try now").click()
    settled(page)
    expect(page.get_by_text("The server cannot be reached.")).to_be_hidden()
    assert apart(shown(page, 0.4), before) > 0.02


def test_an_impossible_step_is_named_and_taken_out_while_the_last_motion_stays(studio: Page):
    page = studio
    page.locator("summary", has_text="More").click()
    page.get_by_role("button", name="Cut", exact=True).click()
    page.get_by_label("Start (s)").fill("5")
    page.get_by_label("End (s)").fill("1")
    page.get_by_label("End (s)").press("Tab")
    alert = page.get_by_role("alert")
    expect(alert).to_contain_text("Step 1, cut", timeout=PATIENCE)
    page.get_by_role("button", name="Take out Cut").click()
    expect(alert).to_be_hidden(timeout=PATIENCE)
    settled(page)


def downloaded(page: Page, kind: str, folder: Path) -> Path:
    with page.expect_download(timeout=PATIENCE) as waiting:
        page.get_by_role("group", name="Download").get_by_role("button", name=kind).click()
    file = folder / f"clip.{kind.lower()}"
    waiting.value.save_as(file)
    return file


def bvh_joints(text: str) -> tuple[list[str], Array]:
    """Names and places (T, J, 3) in metres, by nothing but offsets and Euler angles."""
    file = read_bvh(text.encode())
    columns = iter(file.values.T * 1.0)
    places: list[Array] = []
    turns: list[Rotation] = []
    for joint in file.joints:
        offset = np.tile(np.asarray(joint.offset) / 100.0, (len(file.values), 1))
        axes, angles = "", []
        for channel in joint.channels:
            values = next(columns)
            if channel.lower().endswith("position"):
                offset[:, "xyz".index(channel[0].lower())] = values / 100.0
            else:
                axes += channel[0].upper()
                angles.append(values)
        turn = Rotation.from_euler(axes, np.transpose(angles), degrees=True)
        if joint.parent >= 0:
            parent = turns[joint.parent]
            offset, turn = places[joint.parent] + parent.apply(offset), parent * turn
        places.append(offset)
        turns.append(turn)
    return [joint.name for joint in file.joints], np.stack(places, axis=1)


def test_the_downloaded_files_are_the_clip_that_is_shown(studio: Page, tmp_path: Path):
    page = studio
    choose(page, "strong")
    frame_time = page.evaluate(f"{VIEWER}.frameTime")
    frames = [0, 7, 20, 33]
    seen = np.array([shown(page, frame * frame_time) for frame in frames])
    glb, bvh, numbers = (downloaded(page, kind, tmp_path) for kind in ("GLB", "BVH", "JSON"))
    times = [frame * frame_time for frame in frames]
    read = run_node("gltf_read.mjs", glb, *times)
    assert apart(np.array(read["joints"]), seen) < 1e-3
    names, places = bvh_joints(bvh.read_text())
    order = [names.index(name) for name in read["extras"]["names"]]
    assert apart(places[frames][:, order], seen) < 1e-3
    motion = json.loads(numbers.read_text())["motion"]
    assert motion["names"] == read["extras"]["names"]
    assert apart(np.array(motion["root_positions"])[frames], seen[:, 0]) < 1e-3


def test_the_copied_calls_make_the_same_clip_with_a_key(studio: Page, server: Server):
    page = studio
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    choose(page, "angry")
    calls = []
    for name in ("Copy as curl call", "Copy as Python"):
        page.get_by_role("button", name=name).click()
        expect(page.locator(".exports header [role=status]")).to_contain_text("copied")
        calls.append(page.evaluate("navigator.clipboard.readText()"))
    curl, program = calls
    page.get_by_role("button", name="Save").click()
    expect(page.locator(".studio-title")).to_contain_text("· saved", timeout=PATIENCE)
    saved = page.url.split("clip=")[1]
    environment = {**os.environ, "MANNER_KEY": write_key(page, server)}
    for command in (["sh", "-c", curl], [sys.executable, "-c", program]):
        done = subprocess.run(command, env=environment, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        assert saved in done.stdout


def write_key(page: Page, server: Server) -> str:
    other = page.context.new_page()
    other.goto(server.url + "/research/keys")
    other.get_by_label("What it is for").fill("a test")
    other.get_by_role("radio", name=re.compile("Read and write")).check()
    other.get_by_role("button", name="Make the key").click()
    return other.locator("#secret").inner_text()


@pytest.mark.parametrize(("size", "scheme"), [(DESKTOP, "light"), (PHONE, "dark")], ids=str)
def test_axe_finds_nothing_in_the_studio_and_nothing_is_cut_off(
    research_page: Page, server: Server, size, scheme
):
    page = research_page
    page.set_viewport_size(size)
    page.emulate_media(color_scheme=scheme)
    open_studio(page, server)
    for name in ("Edit", "Results") if size is PHONE else ("",):
        if name:
            page.get_by_role("button", name=name, exact=True).click()
        for summary in page.locator("summary:visible").all():
            summary.click()
        assert access_faults(page) == [], name
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), name
    page.goto(server.url + "/studio")
    expect(page.get_by_role("dialog").locator(".clip-card").first).to_be_visible(timeout=PATIENCE)
    assert access_faults(page) == [], "picker"
