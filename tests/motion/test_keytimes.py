"""Heel strikes and toe-offs, against the plans that the sample walks were made by."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from motion import Clip
from motion.blending.blender import Blender
from motion.editing.cycle_cut import cut_cycle, roll_cycle
from motion.editing.tempo import resample_rate
from motion.keytimes import EVENTS, find_keytimes, standing_times
from motion.kinematics import forward_kinematics
from motion.procedural.bodies import BODIES
from motion.procedural.library import sample_clips
from motion.procedural.plan import FRAME_RATE, cycle_frames, plan_cycle
from motion.procedural.styles import AFFECTS, CHARACTERS, SPEEDS, at_speed
from motion.procedural.walk import walk_cycle
from motion.rotations import from_axis_angle, multiply, rotate
from tests.motion.editing.conftest import WALKS, read

STYLES = {f"set_a_{name}": style for name, style in CHARACTERS.items()} | {
    f"set_b_{name}_{speed}": at_speed(style, speed)
    for name, style in AFFECTS.items()
    for speed in SPEEDS
}
REAL = [f"bandai-namco/walk_{style}_001" for style in WALKS] + ["cmu/12_01_walk"]


@cache
def made(name: str) -> Clip:
    return walk_cycle(STYLES[name], BODIES["adult"])


def planned(name: str) -> dict[str, float]:
    """Seconds of the events in the plan's middle cycle, its own hesitations reckoned in."""
    frames = cycle_frames(STYLES[name])
    plan = plan_cycle(STYLES[name], BODIES["adult"])
    shown_at = np.arange(-frames, 2 * frames + 1) / FRAME_RATE
    found = {}
    for number, side in enumerate(("left", "right")):
        for event, moments in (
            ("strike", [step.contact for step in plan.of_side(number)]),
            ("off", [step.lift for step in plan.of_side(number)]),
        ):
            times = np.interp(moments, plan.times, shown_at)
            inside = times[(times > -1e-9) & (times < frames / FRAME_RATE - 1e-9)]
            found[f"{side}_{event}"] = float(inside[0])
    return found


def apart(one: dict[str, float], other: dict[str, float], duration: float) -> np.ndarray:
    """(4,) s, each event of one after the other's, the short way around the cycle."""
    gaps = np.array([one[event] - other[event] for event in EVENTS])
    return (gaps + duration / 2.0) % duration - duration / 2.0


def stances(clip: Clip) -> list[float]:
    """Share of the cycle that each foot stands."""
    found = find_keytimes(clip)
    return [
        (found[f"{side}_off"] - found[f"{side}_strike"]) % clip.duration / clip.duration
        for side in ("left", "right")
    ]


def in_order(found: dict[str, float], duration: float) -> list[str]:
    """The events from the left strike on."""
    return sorted(found, key=lambda event: (found[event] - found["left_strike"]) % duration)


def test_keytimes_are_those_that_the_walks_were_planned_by():
    errors = np.array([apart(find_keytimes(made(n)), planned(n), made(n).duration) for n in STYLES])
    assert np.abs(errors).max() < 1 / 30, "a frame of a recording at 30 Hz"
    assert np.abs(errors).mean() < 1 / FRAME_RATE
    assert np.abs(errors.mean(axis=0)).max() < 1 / FRAME_RATE


def test_a_walk_strikes_left_lifts_right_strikes_right_lifts_left():
    for name in STYLES:
        order = in_order(find_keytimes(made(name)), made(name).duration)
        assert order == ["left_strike", "right_off", "right_strike", "left_off"], name


@pytest.mark.parametrize("name", ["set_a_neutral", "set_a_angry", "set_b_sleepiness_slow"])
def test_a_cycle_begun_elsewhere_has_the_same_moments_shifted(name):
    clip = made(name)
    for frame in (1, 13, clip.frames // 2, clip.frames - 2):
        rolled = find_keytimes(roll_cycle(clip, frame))
        shifted = {
            event: time - frame * clip.frame_time for event, time in find_keytimes(clip).items()
        }
        assert np.abs(apart(rolled, shifted, clip.duration)).max() < 1e-4
        assert all(0.0 <= time < clip.duration for time in rolled.values())


def test_where_a_walk_goes_does_not_matter():
    clip = made("set_a_proud")
    turn = from_axis_angle(np.array([0.0, 1.0, 0.0]), 2.0)
    rotations = clip.rotations.copy()
    rotations[:, 0] = multiply(turn, rotations[:, 0])
    root = rotate(turn, clip.root_positions) + np.array([3.0, 0.0, -7.0])
    moved = replace(clip, root_positions=root, rotations=rotations)
    assert np.abs(apart(find_keytimes(moved), find_keytimes(clip), clip.duration)).max() < 1e-6


@pytest.mark.parametrize("rate", [30.0, 120.0])
def test_the_frame_rate_does_not_matter(rate):
    errors = []
    for name in ("set_a_neutral", "set_a_sad", "set_a_energetic", "set_b_misery_slow"):
        clip = made(name)
        other = find_keytimes(resample_rate(clip, rate))
        errors.append(apart(other, find_keytimes(clip), clip.duration))
    assert np.abs(errors).max() < 1 / 30


@pytest.mark.motions
@pytest.mark.parametrize("name", REAL)
def test_real_walks_have_all_four_events(name, motions_dir):
    cycle = cut_cycle(read(motions_dir / f"{name}.bvh"))
    found = find_keytimes(cycle)
    assert set(found) == set(EVENTS)
    assert in_order(found, cycle.duration) in (
        ["left_strike", "right_off", "right_strike", "left_off"],
        ["right_off", "left_strike", "left_off", "right_strike"],
    )
    # Slow walks stand longest; the angry one, at 2 m/s, hardly more than half of the time.
    assert all(0.5 < share < 0.75 for share in stances(cycle))
    assert (
        abs((found["right_strike"] - found["left_strike"]) % cycle.duration / cycle.duration - 0.5)
        < 0.1
    )


@pytest.mark.motions
def test_events_are_where_the_feet_turn_back(motions_dir):
    """By coordinates alone, a foot strikes when it is farthest ahead of the hips and leaves when
    it is farthest behind (Zeni, Richards & Higginson 2008): a little before and after."""
    strikes, offs = [], []
    for name in REAL:
        cycle = cut_cycle(read(motions_dir / f"{name}.bvh"))
        found, roles = find_keytimes(cycle), cycle.skeleton.roles
        ahead = forward_kinematics(cycle).positions[:-1, :, 2]
        for side in ("left", "right"):
            heel, toes = (
                ahead[:, roles[f"{side}_{part}"]] - ahead[:, roles["hips"]]
                for part in ("foot", "toes")
            )
            for event, frame, gaps in (
                ("strike", heel.argmax(), strikes),
                ("off", toes.argmin(), offs),
            ):
                gap = found[f"{side}_{event}"] - frame * cycle.frame_time
                gaps.append((gap + cycle.duration / 2) % cycle.duration - cycle.duration / 2)
    assert min(strikes) > -0.01
    assert max(strikes) < 0.15
    assert np.abs(offs).max() < 0.07
    assert 0.02 < np.median(strikes) < 0.06
    assert -0.04 < np.median(offs) < 0.0


def test_without_steps_there_are_no_keytimes():
    clips = {sample.name: sample.clip for sample in sample_clips()}
    walk = made("set_a_neutral")
    assert find_keytimes(clips["stand"]) == {}
    assert find_keytimes(clips["bow"]) == {}
    assert find_keytimes(replace(walk, cyclic=False)) == {}
    on_the_spot = walk.root_positions * np.array([1.0, 1.0, 0.0])
    assert find_keytimes(replace(walk, root_positions=on_the_spot)) == {}


def test_without_legs_there_are_no_keytimes():
    walk = made("set_a_neutral")
    arms = {role: joint for role, joint in walk.skeleton.roles.items() if "arm" in role}
    assert find_keytimes(replace(walk, skeleton=walk.skeleton.with_roles(arms))) == {}


def test_a_foot_stands_from_its_strike_to_its_off_over_the_cycles_end_too():
    clip = made("set_a_proud")
    found, stands = find_keytimes(clip), standing_times(clip)
    for side in ("left", "right"):
        ends = np.ravel(stands[side]).tolist()
        assert found[f"{side}_off"] in [pytest.approx(end) for end in ends]
        missing = (found[f"{side}_off"] - found[f"{side}_strike"]) % clip.duration
        assert sum(b - a for a, b in stands[side]) == pytest.approx(missing, abs=clip.frame_time)
    still = replace(
        clip,
        root_positions=np.repeat(clip.root_positions[:1], clip.frames, axis=0),
        rotations=np.repeat(clip.rotations[:1], clip.frames, axis=0),
        cyclic=False,
    )
    assert standing_times(still)["left"] == [(0.0, pytest.approx(clip.duration))]


def test_a_mix_stands_when_the_mean_of_its_examples_keytimes_says():
    clips = [made("set_a_proud"), made("set_a_sad"), made("set_b_pleasure_fast")]
    moments = [find_keytimes(clip) for clip in clips]
    shares = np.array([0.5, 0.3, 0.2])
    mixed = Blender(clips, moments).blend(shares)
    begun = [
        [(one[event] - one["left_strike"]) % clip.duration for event in EVENTS]
        for one, clip in zip(moments, clips, strict=True)
    ]
    expected = dict(zip(EVENTS, shares @ np.array(begun), strict=True))
    stands = standing_times(mixed)
    (left,) = stands["left"]
    first, second = stands["right"]
    shown = [*left, first[1], second[0]]
    said = [expected[event] for event in ("left_strike", "left_off", "right_off", "right_strike")]
    assert shown == pytest.approx(said, abs=0.03)
