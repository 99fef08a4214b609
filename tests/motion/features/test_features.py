"""The 51 features, against what is known beforehand and what holds for every clip."""

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from motion import Clip, MotionError
from motion.editing.tempo import resample_rate
from motion.features import FEATURE_GROUPS, FEATURES, features
from motion.ingest import IngestOptions, ingest
from motion.procedural.bodies import BODIES
from motion.rotations import multiply
from tests.motion.features.robots import (
    BODY,
    SIDES,
    X,
    Z,
    hanging,
    mirrored,
    moved,
    robot,
    swinging_arm,
    times,
    turn,
    walker,
)
from tests.support.gait import Gait

NAMES = [feature.id for feature in FEATURES]
STEPS = ("step_width", "step_length", "longest_step")
WALKS = (
    "active", "angry", "childish", "chimpira", "feminine", "giant", "happy", "masculinity",
    "musical", "normal", "not-confident", "old", "proud", "sad", "tired",
)  # fmt: skip


def measured(clip: Clip) -> dict[str, float]:
    return dict(zip(NAMES, features(clip).tolist(), strict=True))


def assert_same(one: Clip, other: Clip, *, but=()) -> None:
    """Within 2 %, or half a degree, or 5 mm (a second)."""
    least = {"°": 0.5, "m": 0.005, "m/s": 0.005, "s": 0.0}
    a, b = features(one), features(other)
    allowed = np.maximum(0.02 * np.abs(b), [least[f.unit] for f in FEATURES])
    apart = {
        name: (x, y)
        for name, x, y, most in zip(NAMES, a, b, allowed, strict=True)
        if abs(x - y) > most and name not in but
    }
    assert apart == {}


def read(path) -> Clip:
    return ingest(path.read_bytes(), IngestOptions(drop_first_frame="cmu" in path.parent.name)).clip


# --- what they are


def test_there_are_51_in_the_papers_four_groups():
    counts = Counter(feature.group for feature in FEATURES)
    assert counts == {"lateral_swing": 5, "limb_swing": 12, "bending": 17, "step_length": 17}
    assert list(counts) == list(FEATURE_GROUPS)
    assert len(set(NAMES)) == len({feature.title for feature in FEATURES}) == 51


@pytest.mark.parametrize("feature", FEATURES, ids=NAMES)
def test_each_says_its_unit_definition_and_positive_direction(feature):
    assert feature.unit in ("°", "m", "m/s", "s")
    assert feature.definition.endswith(".")
    assert feature.positive.startswith(("Positive: ", "Greater: "))
    assert feature.description == f"{feature.definition} {feature.positive}"
    assert 0 < feature.least <= 0.5


# --- known values


@pytest.mark.parametrize(("mean", "swing"), [(0.0, 5.0), (10.0, 20.0), (-15.0, 40.0)])
def test_a_pendulum_arm_gives_its_mean_and_its_swing_over_the_root_of_two(mean, swing):
    found = measured(swinging_arm(mean=mean, swing=swing))
    for part in ("left_upper_arm", "left_forearm"):
        assert found[f"{part}_front_back_mean"] == pytest.approx(mean, abs=1e-9)
        assert found[f"{part}_front_back_spread"] == pytest.approx(swing / np.sqrt(2), abs=1e-9)
    assert found["left_upper_arm_left_right_spread"] == pytest.approx(0.0, abs=1e-6)
    assert found["right_upper_arm_front_back_spread"] == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize(("part", "name"), [("thigh", "thigh"), ("shin", "shin")])
def test_a_leg_that_swings_to_the_side_swings_left_right_alone(part, name):
    t = times(60, 1.0)
    angle = 6.0 + 9.0 * np.sin(2 * np.pi * t)
    found = measured(robot(t, {f"right_{part}": turn(Z, -angle)}))
    assert found[f"right_{name}_front_back_mean"] == pytest.approx(0.0, abs=1e-9)
    if part == "thigh":
        assert found["right_thigh_left_right_mean"] == pytest.approx(-6.0, abs=1e-9)
        assert found["right_thigh_left_right_spread"] == pytest.approx(9 / np.sqrt(2), abs=1e-9)


def test_trunk_head_and_feet_turn_as_far_as_they_are_turned():
    t = times(60, 1.0)
    wave = np.sin(2 * np.pi * t)
    upright = measured(robot(t))
    bowed = measured(robot(t, {"spine": turn(X, 12.0 + 0 * t), "head": turn(X, 30.0 + 4 * wave)}))
    leaning = measured(robot(t, {"head": turn(Z, -8.0 + 2 * wave)}))
    feet = measured(robot(t, {"left_foot": turn(X, -15.0 + 10 * wave)}))
    assert bowed["head_front_back_mean"] == pytest.approx(30.0, abs=1e-9)
    assert bowed["head_front_back_spread"] == pytest.approx(4 / np.sqrt(2), abs=1e-9)
    # The trunk is measured from the hip joints, below which the spine does not bend.
    assert 8.0 < bowed["torso_front_back_mean"] - upright["torso_front_back_mean"] < 12.0
    assert leaning["head_left_right_mean"] == pytest.approx(8.0, abs=1e-9)
    assert leaning["head_left_right_spread"] == pytest.approx(2 / np.sqrt(2), abs=1e-3)
    lifted = feet["left_foot_front_back_mean"] - upright["left_foot_front_back_mean"]
    assert lifted == pytest.approx(15.0, abs=1e-9)
    assert feet["left_foot_front_back_spread"] == pytest.approx(10 / np.sqrt(2), abs=1e-9)


@pytest.mark.parametrize("cyclic", [True, False])
def test_a_body_that_bounces_and_sways_gives_its_centres_spread_and_speed(cyclic):
    t = times(60, 3.0)
    root = np.zeros((len(t), 3))
    root[:, 0] = 0.04 * np.sin(2 * np.pi * t) + 0.1 * t
    root[:, 1] = 0.03 * np.sin(4 * np.pi * t)
    root[:, 2] = 1.2 * t + 0.02 * np.sin(4 * np.pi * t)
    found = measured(robot(t, root=root, cyclic=cyclic))
    still = measured(robot(t))
    two = np.sqrt(2)
    assert found["com_left_right_spread"] == pytest.approx(0.04 / two, rel=1e-3)
    assert found["com_position_vertical_spread"] == pytest.approx(0.03 / two, rel=1e-3)
    assert found["com_velocity_vertical_spread"] == pytest.approx(0.03 * 4 * np.pi / two, rel=5e-3)
    forward = 0.02 * 4 * np.pi / two
    assert found["com_velocity_front_back_spread"] == pytest.approx(forward, rel=5e-3)
    assert found["com_velocity_front_back_mean"] == pytest.approx(1.2)
    assert found["com_velocity_left_right_mean"] == pytest.approx(0.1)
    assert found["com_position_vertical_mean"] == pytest.approx(still["com_position_vertical_mean"])
    assert 0.54 < found["com_position_vertical_mean"] / BODY.stature < 0.58
    assert found["motion_duration"] == pytest.approx(3.0)


@pytest.mark.parametrize("rate", [30, 60, 120])
@pytest.mark.parametrize(("left", "right", "width"), [(0.5, 0.62, 0.16), (0.4, 0.4, -0.03)])
def test_a_walk_of_known_steps_gives_their_length_and_width(rate, left, right, width):
    found = measured(walker(rate, left=left, right=right, width=width))
    assert found["step_length"] == pytest.approx((left + right) / 2, abs=1e-6)
    assert found["longest_step"] == pytest.approx(max(left, right), abs=1e-6)
    assert found["step_width"] == pytest.approx(width, abs=1e-6)
    assert found["com_velocity_front_back_mean"] == pytest.approx((left + right) / 1.2)


def test_a_cycle_that_begins_at_any_moment_has_the_same_features(cycles):
    clip = cycles["set_a_energetic"]
    last = clip.frames - 1
    for first in (7, 20, 41):
        index = np.arange(first, first + last + 1)
        root = clip.root_positions[index % last] + (index // last)[:, None] * clip.travel
        later = replace(clip, root_positions=root, rotations=clip.rotations[index % last])
        np.testing.assert_allclose(features(later), features(clip), rtol=1e-3, atol=2e-3)


def test_whole_cycles_of_a_walk_that_is_not_cyclic_are_measured_alike(cycles):
    for clip in (walker(), cycles["set_a_neutral"]):
        last = clip.frames - 1
        index = np.arange(6 * last + 1)
        root = clip.root_positions[index % last] + (index // last)[:, None] * clip.travel
        rotations = clip.rotations[index % last]
        row = replace(clip, root_positions=root, rotations=rotations, cyclic=False)
        assert_same(row, clip, but=["motion_duration"])


# --- an independent measurement of the same things


def test_the_sample_walks_are_measured_as_by_the_gait_measures_of_the_library_tests(cycles):
    for clip in cycles.values():
        gait, found = Gait(clip, BODIES["adult"]), measured(clip)
        for side in SIDES:
            for part, angles in (("thigh", gait.thigh(side)), ("upper_arm", gait.arm(side))):
                mean, spread = angles[:-1].mean(), angles[:-1].std()
                assert found[f"{side}_{part}_front_back_mean"] == pytest.approx(mean, abs=0.3)
                assert found[f"{side}_{part}_front_back_spread"] == pytest.approx(spread, abs=0.3)
        assert found["com_velocity_front_back_mean"] == pytest.approx(gait.speed, rel=1e-3)
        assert found["step_length"] == pytest.approx(clip.travel[2] / 2, rel=1e-2)


# --- laws


@pytest.mark.parametrize("degrees", [-170.0, 35.0, 90.0])
def test_heading_and_start_position_do_not_matter(degrees, cycles):
    for clip in (walker(), cycles["set_b_arousal_fast"], cycles["set_a_sad"]):
        elsewhere = features(moved(clip, degrees, to=(3.0, 0.0, -20.0)))
        np.testing.assert_allclose(elsewhere, features(clip), rtol=1e-6, atol=1e-6)


def test_in_a_mirror_left_and_right_change_places_and_sideways_means_their_sign(cycles):
    swaps = {"left": "right", "right": "left"}
    for clip in (swinging_arm(), walker(), cycles["set_a_swaggering"]):
        found, seen = measured(clip), measured(mirrored(clip))
        for name, value in found.items():
            side, _, rest = name.partition("_")
            twin = f"{swaps[side]}_{rest}" if side in swaps else name
            sideways = name.endswith("left_right_mean")
            if twin in seen:  # some are measured on one side only
                assert seen[twin] == pytest.approx(-value if sideways else value, abs=1e-6), name


@pytest.mark.parametrize("make", [swinging_arm, walker])
def test_synthetic_motions_are_the_same_on_30_and_120_frames_a_second(make):
    assert_same(make(30), make(120))


def test_the_sample_walks_are_the_same_on_30_and_120_frames_a_second(cycles):
    even = [clip for clip in cycles.values() if clip.frames % 2 == 1]
    assert len(even) > 15
    for clip in even:
        halved = replace(
            clip,
            root_positions=clip.root_positions[::2],
            rotations=clip.rotations[::2],
            frame_time=2 * clip.frame_time,
        )
        assert_same(halved, resample_rate(clip, 120))


@pytest.mark.motions
@pytest.mark.parametrize("style", WALKS)
def test_real_walks_are_the_same_on_30_and_120_frames_a_second(style, motions_dir):
    clip = read(motions_dir / f"bandai-namco/walk_{style}_001.bvh")
    assert_same(clip, resample_rate(clip, 120))


@pytest.mark.motions
def test_a_recording_of_120_frames_a_second_is_the_same_with_30(motions_dir):
    clip = read(motions_dir / "cmu/12_01_walk.bvh")
    clip = replace(clip, root_positions=clip.root_positions[:521], rotations=clip.rotations[:521])
    quarter = replace(
        clip,
        root_positions=clip.root_positions[::4],
        rotations=clip.rotations[::4],
        frame_time=4 * clip.frame_time,
    )
    assert_same(quarter, clip)


# --- every clip has them


@pytest.mark.parametrize("frames", [1, 2, 3, 40])
@pytest.mark.parametrize("cyclic", [True, False])
def test_who_stands_still_has_no_steps_no_spread_and_no_speed(frames, cyclic):
    whole = robot(times(30, 2.0), cyclic=cyclic)
    clip = replace(
        whole, root_positions=whole.root_positions[:frames], rotations=whole.rotations[:frames]
    )
    found = measured(clip)
    assert np.isfinite(list(found.values())).all()
    for name in (*STEPS, *(name for name in NAMES if "spread" in name or "velocity" in name)):
        assert found[name] == pytest.approx(0.0, abs=1e-9), name


@pytest.mark.motions
@pytest.mark.parametrize(
    "name", ["bye_normal_001", "bow_tired_001", "dance-short_normal_001", "kick_normal_001"]
)
def test_motions_that_are_no_walks_have_features_too(name, motions_dir):
    found = measured(read(motions_dir / f"bandai-namco/{name}.bvh"))
    assert np.isfinite(list(found.values())).all()
    if name.startswith(("bye", "bow")):
        assert [found[step] for step in STEPS] == [0.0, 0.0, 0.0]


def test_an_arm_held_to_the_side_does_not_swing_for_trembling():
    t = times(60, 1.0)
    generator = np.random.default_rng(3)
    tremble = multiply(turn(Z, generator.normal(0, 0.1, len(t))), turn([0, 1.0, 0], 0.1 * t))
    found = measured(robot(t, {"left_upper_arm": tremble}, cyclic=False))
    assert found["left_upper_arm_front_back_spread"] < 0.5
    assert found["left_upper_arm_left_right_mean"] == pytest.approx(90.0, abs=0.5)


def test_an_arm_raised_beyond_upright_goes_on_counting():
    t = times(60, 1.0)
    angle = 175.0 + 20.0 * np.sin(2 * np.pi * t)
    found = measured(robot(t, {"left_upper_arm": multiply(turn(X, -angle), hanging("left"))}))
    assert found["left_upper_arm_front_back_mean"] == pytest.approx(175.0, abs=1e-6)
    assert found["left_upper_arm_front_back_spread"] == pytest.approx(20 / np.sqrt(2), abs=1e-6)


def test_hands_toes_and_tips_may_be_missing(cycles):
    clip = cycles["set_a_neutral"]
    needless = ("hand", "toes", "clavicle", "neck", "spine", "chest")
    roles = {r: j for r, j in clip.skeleton.roles.items() if not r.endswith(needless)}
    bare = replace(clip, skeleton=replace(clip.skeleton, roles=roles, end_sites=()))
    found, whole = measured(bare), measured(clip)
    assert found["left_foot_front_back_mean"] == 0.0
    for side in SIDES:  # a forearm without a wrist goes on as the upper arm does
        upper = found[f"{side}_upper_arm_front_back_spread"]
        assert found[f"{side}_forearm_front_back_spread"] == pytest.approx(upper)
    for name in ("left_thigh_front_back_mean", "head_front_back_spread", "head_front_back_mean"):
        assert found[name] == pytest.approx(whole[name], abs=0.1)


def test_a_missing_limb_and_a_clip_without_frames_are_refused():
    clip = robot(times(60, 1.0))
    roles = {r: j for r, j in clip.skeleton.roles.items() if r != "left_shin"}
    with pytest.raises(MotionError, match="left shin"):
        features(replace(clip, skeleton=clip.skeleton.with_roles(roles)))
    empty = replace(clip, root_positions=clip.root_positions[:0], rotations=clip.rotations[:0])
    with pytest.raises(MotionError, match="without frames"):
        features(empty)
