"""Clips to steer a walk by."""

import numpy as np
import pytest

from motion.editing.foot_plants import runs
from motion.procedural.bodies import BODIES
from motion.procedural.steering import graph_clips
from motion.rotations import angle_between, rotate
from tests.support.gait import SIDES, Gait


@pytest.fixture(scope="module", params=sorted(BODIES))
def body(request):
    return BODIES[request.param]


@pytest.fixture(scope="module")
def clips(body):
    return graph_clips(body)


def heading(clip):
    """(T,) rad, to the left positive, without jumps."""
    ahead = rotate(clip.rotations[:, 0], np.array([0.0, 0.0, 1.0]))
    return np.unwrap(np.arctan2(ahead[:, 0], ahead[:, 2]))


def test_planted_feet_do_not_slip_or_sink(body, clips):
    for clip in clips.values():
        gait, planted = Gait(clip, body), 0
        for side in SIDES:
            sole = gait.sole(side)
            assert sole[..., 1].min() > -0.002
            speed = np.linalg.norm(np.gradient(sole, clip.frame_time, axis=1), axis=-1)
            for point in range(3):
                for run in runs((sole[point, :, 1] < 0.003) & (speed[point] < 0.2)):
                    planted += run.stop - run.start
                    way = np.ptp(sole[point, run][:, [0, 2]], axis=0)
                    assert np.linalg.norm(way) < 0.005
        assert planted > clip.frames


def test_turns_go_around_to_their_side(clips):
    for name, sign in (("turn_left", 1), ("turn_right", -1)):
        around = heading(clips[name])
        assert around[-1] - around[0] == pytest.approx(sign * 1.5 * np.pi, abs=0.05)
    for name in ("stand", "walk"):
        assert np.abs(heading(clips[name])).max() < np.radians(12)


def test_left_and_right_turns_bend_the_way_alike(clips):
    left, right = clips["turn_left"].travel, clips["turn_right"].travel
    np.testing.assert_allclose(left * [-1, 1, 1], right, atol=0.03)
    assert clips["walk"].travel[2] > 4.0
    np.testing.assert_array_equal(clips["stand"].travel, np.zeros(3))


def test_joints_turn_no_faster_than_walking_bodies_do(clips):
    for clip in clips.values():
        turn = np.degrees(angle_between(clip.rotations[1:], clip.rotations[:-1]))
        assert turn.max() < 10.0


def test_knees_are_never_stretched_or_turned_out(body, clips):
    for clip in clips.values():
        gait = Gait(clip, body)
        for side in SIDES:
            assert gait.knee(side).min() > 3.0
            assert gait.knee(side).max() < 75.0


def test_every_walk_begins_and_ends_as_standing_does(clips):
    stand = clips["stand"]
    for name in ("walk", "turn_left", "turn_right"):
        for frame in (0, -1):
            other = clips[name].rotations[frame, 1:]
            assert np.degrees(angle_between(other, stand.rotations[0, 1:])).max() < 3.0


def test_four_clips_at_sixty_frames_a_second_of_which_standing_loops(clips):
    assert len({clip.content_hash for clip in clips.values()}) == 4
    assert {clip.frame_time for clip in clips.values()} == {1 / 60}
    assert [name for name, clip in clips.items() if clip.cyclic] == ["stand"]
