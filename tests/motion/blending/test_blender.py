"""What a blend keeps: bones, phases, the seam, and an example that is alone."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from motion import Clip, MotionError
from motion.blending import Blender
from motion.editing.cycle_cut import cut_cycle, roll_cycle
from motion.editing.cycles import three_cycles
from motion.graph_window import frames_of
from motion.keytimes import find_keytimes
from motion.kinematics import forward_kinematics
from motion.procedural.library import sample_clips
from motion.rotations import angle_between, from_axis_angle, multiply, rotate
from tests.motion.blending.conftest import blender_of, mixtures, only
from tests.motion.editing.conftest import read
from tests.motion.editing.measures import bone_lengths

UP = np.array([0.0, 1.0, 0.0])


@pytest.fixture(scope="session")
def acted() -> list[Clip]:
    """Motions that do not loop, of one body."""
    names = [f"acted_male_{emotion}" for emotion in ("neutral", "sad", "angry")]
    clips = {sample.name: sample.clip for sample in sample_clips()}
    return [clips[name] for name in names if name in clips]


def begun_at_left_strike(clip: Clip) -> Clip:
    """The cycle from the frame nearest to its left strike on, over the place where it began."""
    start = round(find_keytimes(clip)["left_strike"] / clip.frame_time) % (clip.frames - 1)
    root, rotations = frames_of(clip, start, start + clip.frames)
    root = root - clip.travel * start / (clip.frames - 1)
    return replace(clip, root_positions=root, rotations=rotations)


def turned(clip: Clip, angle: float) -> Clip:
    turn = from_axis_angle(UP, angle)
    rotations = clip.rotations.copy()
    rotations[:, 0] = multiply(turn, rotations[:, 0])
    return replace(clip, root_positions=rotate(turn, clip.root_positions), rotations=rotations)


def assert_same(one: Clip, two: Clip, within: float = 1e-6):
    assert (one.frames, one.frame_time, one.cyclic) == (two.frames, two.frame_time, two.cyclic)
    np.testing.assert_allclose(one.root_positions, two.root_positions, rtol=0, atol=within)
    assert angle_between(one.rotations, two.rotations).max() < within


def test_bones_keep_their_lengths(blender, walks):
    own = np.linalg.norm(walks[0].skeleton.offsets[1:], axis=1)
    for weights in mixtures(4, len(walks)):
        lengths = bone_lengths(blender.blend(weights))
        np.testing.assert_allclose(lengths, np.tile(own, (len(lengths), 1)), atol=1e-9)


def test_an_example_alone_comes_back(blender, walks):
    for index, clip in enumerate(walks):
        found = blender.blend(only(index, len(walks)))
        assert_same(found, begun_at_left_strike(clip))


def test_a_clip_blended_with_itself_is_that_clip(walks):
    clip = walks[1]
    found = blender_of((clip, clip, clip)).blend([0.2, 0.5, 0.3])
    assert_same(found, begun_at_left_strike(clip))


def test_clips_that_do_not_loop_are_blended_too(acted):
    blender = Blender(acted)
    for index, clip in enumerate(acted):
        assert_same(blender.blend(only(index, len(acted))), clip)
    between = blender.blend([0.5, 0.5, 0.0])
    assert not between.cyclic
    assert between.duration == pytest.approx(
        (acted[0].duration + acted[1].duration) / 2, abs=acted[0].frame_time
    )


def test_left_and_right_stay_apart_when_walks_start_on_different_feet(walks_real):
    """The same walk begun at its right strike: mixed as it is, both legs would go together."""
    clip = begun_at_left_strike(walks_real[0])
    other = roll_cycle(clip, round(find_keytimes(clip)["right_strike"] / clip.frame_time))
    sideways = (other.root_positions[0] - clip.root_positions[0]) * [1.0, 0.0, 0.0]
    found = blender_of((clip, other)).blend([0.5, 0.5])
    expected = replace(
        clip, root_positions=clip.root_positions + found.root_positions[0] - clip.root_positions[0]
    )
    assert np.abs(sideways).max() < 0.1
    assert_same(found, expected)


def test_a_walk_counts_the_same_wherever_it_heads(walks_a):
    clips = (walks_a[0], turned(walks_a[3], 2.0))
    straight = blender_of((walks_a[0], walks_a[3])).blend([0.4, 0.6])
    found = blender_of(clips).blend([0.4, 0.6])
    strayed = found.root_positions - straight.root_positions
    np.testing.assert_allclose(strayed, np.tile(strayed[0], (len(strayed), 1)), atol=1e-9)
    assert angle_between(found.rotations, straight.rotations).max() < 1e-7


def test_a_blend_goes_straight_ahead_and_closes(blender, walks):
    for weights in mixtures(6, len(walks)):
        clip = blender.blend(weights)
        assert clip.cyclic
        np.testing.assert_allclose(clip.travel[:2], 0.0, atol=1e-9)
        stride = weights @ [walk.travel[2] for walk in walks]
        assert clip.travel[2] == pytest.approx(stride, abs=1e-9)
        np.testing.assert_array_equal(clip.rotations[-1], clip.rotations[0])


def test_nothing_jumps_at_the_seam(blender, walks):
    """Neither place nor velocity: the seam's change of velocity is one among others."""
    for weights in mixtures(8, len(walks), seed=2):
        clip = blender.blend(weights)
        places, last = forward_kinematics(three_cycles(clip)).positions, clip.frames - 1
        steps = np.linalg.norm(np.diff(places, axis=0), axis=2).max(axis=1)
        changes = np.linalg.norm(np.diff(places, 2, axis=0), axis=2).max(axis=1)
        assert max(steps[last - 1], steps[last]) <= 1.05 * steps[last + 1 : 2 * last - 1].max()
        assert changes[last - 1] <= changes[last : 2 * last - 1].max()


def test_no_joint_is_thrown_about(blender, walks):
    """No joint of a blend is accelerated much more than the wildest of the examples."""
    wildest = max(strongest_acceleration(walk) for walk in walks)
    for weights in mixtures(8, len(walks), seed=3):
        assert strongest_acceleration(blender.blend(weights)) < 1.5 * wildest


def strongest_acceleration(clip: Clip) -> float:
    places = forward_kinematics(three_cycles(clip)).positions
    return float(np.linalg.norm(np.diff(places, 2, axis=0), axis=2).max() / clip.frame_time**2)


def test_duration_and_keytimes_are_weighted_means(blender, walks):
    for weights in mixtures(4, len(walks), seed=4):
        clip = blender.blend(weights)
        duration = weights @ [walk.duration for walk in walks]
        assert clip.duration == pytest.approx(duration, abs=0.51 * clip.frame_time)
        assert clip.frames == blender.frames(weights)
        found, told = find_keytimes(clip), blender.keytimes(weights)
        assert set(found) == set(told)
        for event, moment in told.items():
            apart = abs(moment - found[event]) % clip.duration
            assert min(apart, clip.duration - apart) < 0.06 * clip.duration


def test_a_little_more_weight_changes_little(blender_b, walks_b):
    for weights in mixtures(4, len(walks_b), seed=5):
        other = weights + 1e-4 * only(3, len(walks_b))
        one, two = blender_b.blend(weights), blender_b.blend(other / other.sum())
        if one.frames == two.frames:
            assert angle_between(one.rotations, two.rotations).max() < 5e-3
            assert np.abs(one.root_positions - two.root_positions).max() < 2e-3


def test_a_vanishing_weight_leaves_the_example_as_it_is(blender_b, walks_b):
    weights = only(5, len(walks_b)) + 1e-6 * only(9, len(walks_b))
    alone, nearly = blender_b.blend(only(5, len(walks_b))), blender_b.blend(weights)
    assert_same(nearly, alone, within=1e-3)


def test_the_same_weights_give_the_same_bits(blender_b, walks_b):
    weights = mixtures(1, len(walks_b))[0]
    again = blender_of(walks_b).blend(weights)
    assert blender_b.blend(weights).content_hash == again.content_hash


def test_the_order_of_the_examples_does_not_matter(blender_b, walks_b):
    weights = mixtures(2, len(walks_b))[1]
    order = np.random.default_rng(1).permutation(len(walks_b))
    shuffled = blender_of(tuple(walks_b[index] for index in order)).blend(weights[order])
    assert_same(shuffled, blender_b.blend(weights), within=1e-9)


def test_examples_without_weight_may_be_left_out(walks_b, blender_b):
    weights = np.zeros(len(walks_b))
    weights[[2, 7, 20]] = 0.2, 0.5, 0.3
    few = blender_of(tuple(walks_b[index] for index in (2, 7, 20))).blend([0.2, 0.5, 0.3])
    assert few.content_hash == blender_b.blend(weights).content_hash


def test_only_ratios_of_weights_count(blender_a):
    weights = mixtures(2, 10)[1]
    assert_same(blender_a.blend(weights), blender_a.blend(7.5 * weights), within=1e-9)


@pytest.mark.parametrize("frames", [2, 3, 4])
@pytest.mark.parametrize("cyclic", [True, False])
def test_the_shortest_clips_are_blended(walks_a, frames, cyclic):
    clips = [
        replace(w, root_positions=w.root_positions[:frames], rotations=w.rotations[:frames])
        for w in walks_a[:2]
    ]
    found = Blender([replace(clip, cyclic=cyclic) for clip in clips]).blend([0.5, 0.5])
    assert found.frames == frames
    assert np.isfinite(found.rotations).all()
    with pytest.raises(MotionError, match="single frame"):
        Blender(
            [
                replace(
                    walks_a[0], root_positions=np.zeros((1, 3)), rotations=walks_a[0].rotations[:1]
                )
            ]
        )


def test_no_joint_turns_over_between_frames(blender, walks):
    """A quaternion and its negative are one rotation; a player that mixes two would spin."""
    for weights in mixtures(6, len(walks), seed=9):
        rotations = blender.blend(weights).rotations[:-1]
        assert np.sum(rotations[1:] * rotations[:-1], axis=-1).min() > 0.0


def test_a_walk_and_a_run_are_blended_by_what_they_share(walks_real, motions_dir):
    run = cut_cycle(read(motions_dir / "bandai-namco/run_happy_001.bvh"))
    blender = blender_of((walks_real[0], run))
    clip = blender.blend([0.5, 0.5])
    assert set(blender.keytimes([0.5, 0.5])) == {"left_strike", "right_strike"}
    assert set(blender.keytimes([1.0, 0.0])) == set(find_keytimes(walks_real[0]))
    shorter, longer = sorted(one.travel[2] for one in (walks_real[0], run))
    assert shorter < clip.travel[2] < longer


def test_without_legs_a_body_is_blended_evenly(walks_a):
    def legless(clip: Clip) -> Clip:
        arms = {role: j for role, j in clip.skeleton.roles.items() if "arm" in role}
        return replace(clip, skeleton=clip.skeleton.with_roles(arms))

    clips = [legless(walks_a[0]), legless(walks_a[1])]
    assert Blender(clips).blend([0.5, 0.5]).frames > 2
    assert_same(Blender(clips).blend([1.0, 0.0]), clips[0])


def test_what_does_not_fit_is_refused_by_name(walks_a, walks_real, acted):
    with pytest.raises(MotionError, match="Clip 2 has another skeleton"):
        Blender([walks_a[0], walks_real[0]])
    with pytest.raises(MotionError, match="Clip 1 is none and clip 2 is a cycle: cut"):
        Blender([replace(walks_a[0], cyclic=False), walks_a[1]])
    with pytest.raises(MotionError, match="Clip 2 has no keytime in common"):
        Blender(walks_a[:2], [{"left_strike": 0.1}, {"right_strike": 0.2}])
    with pytest.raises(MotionError, match="not within the clip"):
        Blender(walks_a[:1], [{"left_strike": 100.0}])
    with pytest.raises(MotionError, match="no clip"):
        Blender([])
    with pytest.raises(MotionError, match="as many keytimes"):
        Blender(walks_a[:2], [{}])


@pytest.mark.parametrize("weights", [[1.0], [0.0, 0.0], [1.0, -0.1], [np.nan, 1.0]])
def test_what_are_no_weights_is_refused(walks_a, weights):
    with pytest.raises(MotionError, match="eight"):
        Blender(walks_a[:2]).blend(weights)
