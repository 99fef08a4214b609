"""The nine motions and what lies between them."""

from collections import OrderedDict
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motion import MotionError
from motion.editing import grid
from motion.editing.foot_repair import repair_feet
from motion.editing.grid import LONGER, SHORTER, cached_nine_motions, nine_motions
from motion.editing.path_length import PathLength, change_path_length
from motion.editing.timing import ADDED, EVEN, Timing, change_timing
from motion.kinematics import forward_kinematics
from motion.rotations import angle_between, from_directions, to_directions
from tests.motion.editing.measures import bone_lengths

ON_GRID = [(path, timing) for path in (0, 1, 2) for timing in (0, 1, 2)]


@pytest.fixture(scope="module")
def clip(samples):
    return samples["acted_male_neutral"]


@pytest.fixture(scope="module")
def nine(clip):
    return nine_motions(clip)


@pytest.mark.parametrize(("path", "timing"), ON_GRID)
def test_a_grid_point_is_its_own_motion(clip, nine, path, timing):
    expected = clip
    if path != 1:
        gain = SHORTER if path == 0 else LONGER
        expected = repair_feet(clip, change_path_length(clip, PathLength(gain)))
    if timing != 1:
        expected = change_timing(expected, Timing(EVEN if timing == 0 else ADDED))
    ours = forward_kinematics(nine.at(path, timing)).positions
    np.testing.assert_allclose(ours, forward_kinematics(expected).positions, atol=1e-9)


def test_near_a_grid_point_the_motion_is_near_its_own(nine):
    for path, timing in ON_GRID:
        inward = (path + (1 - path) * 1e-6 if path != 1 else 1 + 1e-6, timing)
        near = forward_kinematics(nine.at(*inward)).positions
        np.testing.assert_allclose(
            near, forward_kinematics(nine.at(path, timing)).positions, atol=1e-4
        )


@pytest.fixture(scope="module")
def table(nine):
    """(3, 3, T, J, 6) direction vectors of the nine."""
    return np.array([[to_directions(clip.rotations) for clip in row] for row in nine.motions])


@settings(max_examples=25, deadline=None)
@given(st.floats(0, 2), st.floats(0, 2))
def test_the_order_of_interpolation_does_not_matter(nine, table, path, timing):
    """Figure 28: first along one axis and then along the other, on the direction vectors."""
    along_path, along_time = (np.maximum(0, 1 - np.abs(np.arange(3) - at)) for at in (path, timing))
    path_first = np.tensordot(along_time, np.tensordot(along_path, table, 1), 1)
    time_first = np.tensordot(along_path, np.tensordot(along_time, table.swapaxes(0, 1), 1), 1)
    np.testing.assert_allclose(path_first, time_first, atol=1e-12)
    angles = angle_between(nine.at(path, timing).rotations, from_directions(time_first))
    np.testing.assert_allclose(angles, 0.0, atol=1e-9)


@settings(max_examples=10, deadline=None)
@given(st.floats(0, 2), st.floats(0, 2))
def test_every_point_keeps_the_bones(nine, clip, path, timing):
    np.testing.assert_allclose(bone_lengths(nine.at(path, timing)), bone_lengths(clip), atol=1e-9)


@pytest.mark.parametrize("point", [(-0.1, 1), (1, 2.1), (float("nan"), 1)])
def test_outside_the_grid_there_is_nothing(nine, point):
    with pytest.raises(MotionError, match="from 0 to 2"):
        nine.at(*point)


def tiny(clip, number, frames=8):
    """A few frames of a clip, different for each number."""
    part = slice(number, number + frames)
    return replace(clip, root_positions=clip.root_positions[part], rotations=clip.rotations[part])


def test_grids_are_remembered_by_what_the_clip_is(clip):
    first = cached_nine_motions(tiny(clip, 0))
    assert cached_nine_motions(tiny(clip, 0)) is first
    assert cached_nine_motions(tiny(clip, 1)) is not first
    assert cached_nine_motions(tiny(clip, 0), ("head",)) is not first


def test_few_grids_are_remembered(clip, monkeypatch):
    """As many as fit; the newest always, the longest unused go first."""
    monkeypatch.setattr(grid, "_CACHE", OrderedDict())
    monkeypatch.setattr(grid, "_MOST", 3 * 8 * len(clip.skeleton))
    made = [cached_nine_motions(tiny(clip, number)) for number in range(3)]
    assert cached_nine_motions(tiny(clip, 0)) is made[0]
    cached_nine_motions(tiny(clip, 3))
    assert len(grid._CACHE) == 3
    assert cached_nine_motions(tiny(clip, 0)) is made[0]
    assert cached_nine_motions(tiny(clip, 1)) is not made[1]
    long = cached_nine_motions(tiny(clip, 0, 100))
    assert list(grid._CACHE.values()) == [long]


def test_a_cycle_s_grid_is_seamless_everywhere(samples):
    nine = nine_motions(samples["set_a_proud"])
    for point in [*ON_GRID, (0.3, 1.7), (1.6, 0.4)]:
        made = nine.at(*point)
        assert made.cyclic
        assert np.degrees(angle_between(made.rotations[0], made.rotations[-1])).max() < 1e-5
