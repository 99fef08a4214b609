"""Path length and rhythm that change at random."""

import numpy as np
import pytest

from motion.editing.variation import vary
from motion.quality import check
from motion.rotations import angle_between
from tests.motion.editing.measures import bone_lengths


def drawn(seed=7):
    return np.random.default_rng(seed)


def apart(clip, other):
    return np.degrees(angle_between(clip.rotations, other.rotations))


def test_nothing_varied_is_the_clip(knocking):
    assert vary(knocking, 0.0, 0.0, drawn()) is knocking


@pytest.mark.parametrize(("path", "rhythm"), [(1.0, 0.0), (0.0, 1.0), (0.6, 0.6)])
def test_the_same_draws_give_the_same_motion_and_others_another(knocking, path, rhythm):
    first, again = (vary(knocking, path, rhythm, drawn()) for _ in range(2))
    np.testing.assert_array_equal(first.rotations, again.rotations)
    assert apart(first, vary(knocking, path, rhythm, drawn(8))).max() > 5


@pytest.mark.parametrize("seed", range(4))
def test_length_and_bones_stay_and_nothing_jumps(knocking, seed):
    varied = vary(knocking, 1.0, 1.0, drawn(seed))
    assert varied.frames == knocking.frames
    assert np.isfinite(varied.rotations).all()
    np.testing.assert_allclose(bone_lengths(varied)[0], bone_lengths(knocking)[0], atol=1e-9)
    steps = angle_between(varied.rotations[1:], varied.rotations[:-1]).max()
    # Up to 2.5 times as fast, on a path up to twice as long.
    assert steps < 5 * angle_between(knocking.rotations[1:], knocking.rotations[:-1]).max()


def test_rhythm_alone_keeps_the_way_its_ends_and_every_pose(knocking):
    varied = vary(knocking, 0.0, 1.0, drawn())
    assert apart(varied, knocking)[[0, -1]].max() < 1e-5
    np.testing.assert_allclose(varied.root_positions[[0, -1]], knocking.root_positions[[0, -1]])
    way = [np.linalg.norm(np.diff(c.root_positions, axis=0), axis=1) for c in (knocking, varied)]
    assert way[1].sum() == pytest.approx(way[0].sum(), rel=0.01)
    nearest = [
        np.degrees(angle_between(pose, knocking.rotations).max(axis=1).min())
        for pose in varied.rotations[::10]
    ]
    assert max(nearest) < 8  # between two of the original's frames


def test_the_pace_goes_up_and_down(knocking):
    """Little rhythm is little, and the root is now ahead and now behind where it was."""
    early = vary(knocking, 0.0, 1.0, drawn()).root_positions[:, 2] - knocking.root_positions[:, 2]
    assert early.max() > 0.02 or early.min() < -0.02
    assert apart(vary(knocking, 0.0, 1e-4, drawn()), knocking).max() < 0.1


def test_feet_stand_again(knocking):
    report = check(knocking, vary(knocking, 1.0, 0.0, drawn()))
    assert not {finding.kind for finding in report.findings} & {"foot slip", "floor"}


def test_a_cycle_stays_seamless(samples):
    clip = samples["set_a_proud"]
    varied = vary(clip, 0.8, 0.8, drawn())
    assert varied.cyclic
    assert np.degrees(angle_between(varied.rotations[0], varied.rotations[-1])).max() < 1e-5
    across = np.degrees(angle_between(varied.rotations[1], varied.rotations[-2])).max()
    assert across < 4 * apart_of_neighbours(clip)


def apart_of_neighbours(clip):
    return np.degrees(angle_between(clip.rotations[1:], clip.rotations[:-1])).max()
