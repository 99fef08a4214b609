"""The report finds what was broken on purpose, where it was broken, and nothing else."""

from dataclasses import replace

import numpy as np
import pytest

from motion import MotionError
from motion.body import REQUIRED
from motion.centre_of_mass import centre_of_mass
from motion.editing.foot_plants import find_feet
from motion.editing.path_length import PathLength, change_path_length
from motion.kinematics import forward_kinematics
from motion.quality import check, ease_off
from motion.quality.pair import matched
from motion.rotations import conjugate, from_axis_angle, multiply, rotate

X, Y, Z = np.eye(3)


@pytest.fixture
def standing(knocking):
    """Frames in which the knocking body stands on both feet."""
    left, right = find_feet(knocking)
    both = left.stands & right.stands
    last = knocking.frames - 40
    assert both[last - 40 : last].all()
    return slice(last - 30, last)


def turned(clip, role, turn, frames):
    """The clip with one joint turned in its parent's axes during some frames."""
    rotations = clip.rotations.copy()
    joint = clip.skeleton.roles[role]
    rotations[frames, joint] = multiply(turn, rotations[frames, joint])
    return replace(clip, rotations=rotations)


def moved(clip, way, frames):
    root = clip.root_positions.copy()
    root[frames] += way
    return replace(clip, root_positions=root)


def only(report, kind):
    found = [finding for finding in report.findings if finding.kind == kind]
    assert found, f"no {kind} in {report.findings}"
    return found


def seconds(clip, frames):
    return frames.start * clip.frame_time, (frames.stop - 1) * clip.frame_time


def test_every_sample_is_clean_against_itself(samples):
    for clip in samples.values():
        assert check(clip, clip).findings == ()


@pytest.mark.motions
def test_every_recording_is_clean_against_itself(going):
    assert check(going, going).findings == ()


def test_a_foot_that_slides_is_found_with_the_way_it_slid(knocking, standing):
    late = slice(standing.start, knocking.frames)
    slips = only(check(knocking, moved(knocking, 0.03 * Z, late)), "foot slip")
    assert {finding.part for finding in slips} == {"left foot", "right foot"}
    for finding in slips:
        assert finding.start == pytest.approx(standing.start * knocking.frame_time)
        assert finding.size == pytest.approx(0.03, abs=0.002)
        assert (finding.unit, finding.limit) == ("m", pytest.approx(0.005, abs=0.002))


def test_feet_below_the_floor_are_found_with_their_depth(knocking, standing):
    sunk = only(check(knocking, moved(knocking, -0.04 * Y, standing)), "floor")
    assert {finding.part for finding in sunk} == {"left foot", "right foot"}
    for finding in sunk:
        assert (finding.start, finding.end) == pytest.approx(seconds(knocking, standing))
        assert finding.size == pytest.approx(0.04, abs=0.002)


@pytest.mark.parametrize("side", ["left", "right"])
def test_an_elbow_bent_backwards_is_found_with_its_angle(knocking, standing, side):
    rotations = knocking.rotations.copy()
    sign = 1 if side == "left" else -1
    back = from_axis_angle(Y, np.radians(40.0 * sign))  # arms reach sideways in the zero pose
    rotations[standing, knocking.skeleton.roles[f"{side}_forearm"]] = back
    (finding,) = only(check(knocking, replace(knocking, rotations=rotations)), "joint range")
    assert finding.part == f"{side} elbow"
    assert (finding.start, finding.end) == pytest.approx(seconds(knocking, standing))
    assert finding.size == pytest.approx(40.0, abs=3.0)
    assert (finding.unit, finding.limit) == ("°", 15.0)


@pytest.mark.parametrize(
    ("role", "turn", "part"),
    [
        ("head", from_axis_angle(Y, np.radians(110.0)), "neck"),
        ("right_thigh", from_axis_angle(X, np.radians(70.0)), "right hip"),
        ("left_shin", from_axis_angle(X, np.radians(-60.0)), "left knee"),
        ("left_foot", from_axis_angle(X, np.radians(80.0)), "left ankle"),
    ],
)
def test_other_joints_bent_too_far_are_found(knocking, standing, role, turn, part):
    found = only(check(knocking, turned(knocking, role, turn, standing)), "joint range")
    assert [finding.part for finding in found] == [part]


def test_an_arm_through_the_trunk_is_found(knocking, standing):
    inward = from_axis_angle(Z, np.radians(-35.0))
    found = only(
        check(knocking, turned(knocking, "left_upper_arm", inward, standing)), "intersection"
    )
    assert {finding.part for finding in found} <= {"left forearm", "left hand"}
    for finding in found:
        start, end = seconds(knocking, standing)
        assert start <= finding.start <= finding.end <= end


def test_a_body_that_leans_like_a_plank_is_found_off_balance(knocking, standing):
    """Its centre of mass moves ahead of the ankles by the sine of the angle times its height."""
    pose, angle = forward_kinematics(knocking), np.radians(14.0)
    feet = [knocking.skeleton.roles[f"{side}_foot"] for side in ("left", "right")]
    ankles = pose.positions[standing][:, feet].mean(axis=1)
    root, lean = knocking.root_positions.copy(), from_axis_angle(X, angle)
    root[standing] = ankles + rotate(lean, root[standing] - ankles)
    leaning = turned(replace(knocking, root_positions=root), "hips", lean, standing)
    for side in ("left", "right"):  # the feet stay flat
        leaning = turned(leaning, f"{side}_foot", conjugate(lean), standing)
    (finding,) = only(check(knocking, leaning), "balance")
    assert finding.part == "body"
    assert (finding.start, finding.end) == pytest.approx(seconds(knocking, standing))
    over = centre_of_mass(knocking.skeleton, pose)[standing] - ankles
    toes = [knocking.skeleton.roles[f"{side}_toes"] for side in ("left", "right")]
    balls = pose.positions[standing][:, toes]
    ahead = balls[..., 2].mean(axis=1) - ankles[:, 2]
    way = balls[0, 0] - balls[0, 1]  # one foot stands a little behind the other
    expected = over[:, 1] * np.sin(angle) + over[:, 2] * np.cos(angle) - ahead
    expected *= way[0] / np.hypot(way[0], way[2])
    assert finding.size == pytest.approx(expected.max(), abs=0.003)


def test_a_hand_that_shakes_is_found(knocking, standing):
    rotations = knocking.rotations.copy()
    joint = knocking.skeleton.roles["left_forearm"]
    shake = 0.15 * np.sin(2 * np.pi * 8.0 * knocking.frame_time * np.arange(30))
    rotations[standing, joint] = multiply(rotations[standing, joint], from_axis_angle(Y, shake))
    found = only(check(knocking, replace(knocking, rotations=rotations)), "jerk")
    assert {finding.part for finding in found} == {"left hand"}
    start, end = seconds(knocking, standing)
    assert all(start - 0.2 <= finding.start <= finding.end <= end + 0.2 for finding in found)


def test_feet_that_an_edit_leaves_unrepaired_are_found(samples):
    clip = samples["acted_female_happy"]
    edited = change_path_length(clip, PathLength(1.6))
    assert {finding.kind for finding in check(clip, edited).findings} >= {"foot slip"}


def test_easing_off_stops_just_before_the_first_fault(knocking, standing):
    """Feet sink by 4 cm times the amount, of which 1 cm is allowed."""

    def sink(amount):
        return moved(knocking, -0.04 * amount * Y, standing)

    amount, clip, report = ease_off(knocking, sink)
    assert amount == pytest.approx(0.25, abs=0.05)
    assert report.clean
    assert clip.content_hash == sink(amount).content_hash
    assert not check(knocking, sink(amount + 1 / 64)).clean


def test_a_clean_edit_is_not_eased(knocking):
    amount, clip, report = ease_off(knocking, lambda _: knocking)
    assert (amount, clip, report.clean) == (1.0, knocking, True)


def test_clips_that_do_not_belong_together_are_refused(knocking, samples):
    with pytest.raises(MotionError, match="skeleton"):
        check(knocking, samples["set_a_proud"])
    brief = replace(
        knocking, root_positions=knocking.root_positions[:1], rotations=knocking.rotations[:1]
    )
    with pytest.raises(MotionError, match="1 frames"):
        check(knocking, brief)


@pytest.mark.parametrize("times", [0.8, 1.5])
def test_a_clip_that_is_only_slower_or_quicker_is_clean(knocking, times):
    slower = replace(knocking, frame_time=knocking.frame_time * times)
    assert check(knocking, slower).findings == ()
    resampled = matched(knocking, longer(knocking, round(knocking.frames * times))).original
    assert resampled.frames == round(knocking.frames * times)
    assert check(knocking, resampled).findings == ()


@pytest.mark.parametrize("frames", [1, 2, 3, 4, 5, 9])
def test_the_shortest_clips_are_judged_as_well(knocking, frames):
    brief = replace(
        knocking,
        root_positions=knocking.root_positions[:frames],
        rotations=knocking.rotations[:frames],
    )
    assert check(brief, brief).clean
    assert not check(brief, moved(brief, -0.2 * Y, slice(None))).clean


def test_a_body_known_by_its_required_roles_alone_is_judged(knocking):
    roles = {role: knocking.skeleton.roles[role] for role in REQUIRED}
    clip = replace(knocking, skeleton=knocking.skeleton.with_roles(roles))
    assert check(clip, clip).clean
    sunk = check(clip, moved(clip, -0.2 * Y, slice(None)))
    assert {finding.kind for finding in sunk.findings} == {"floor"}


def longer(clip, frames):
    """Any clip of that many frames of the same body."""
    still = np.zeros(frames, dtype=int)
    return replace(clip, root_positions=clip.root_positions[still], rotations=clip.rotations[still])


def test_a_report_becomes_plain_values(knocking, standing):
    found = check(knocking, moved(knocking, -0.04 * Y, standing)).to_dict()
    assert found["clean"] is False
    assert set(found["findings"][0]) == {
        "kind", "part", "start", "end", "size", "unit", "limit",
    }  # fmt: skip
