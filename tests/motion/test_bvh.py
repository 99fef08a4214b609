"""Reading gives exactly the numbers that are written; writing loses nothing that is seen."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from scipy.spatial.transform import Rotation

from motion.bvh import read_bvh, write_bvh
from motion.bvh_numbers import BadNumberError, parse_numbers
from motion.bvh_write import format_rows
from motion.clip import Clip
from motion.errors import MotionError
from motion.ingest import ingest
from motion.kinematics import end_site_positions, forward_kinematics
from motion.local_motion import bake, local_motion
from motion.skeleton import EndSite, Skeleton
from tests.support.bvh_files import two_joints

finite = st.floats(allow_nan=False, allow_infinity=False)
formats = st.sampled_from(
    ["{!r}", "{:.4f}", "{:.6f}", "{:.6g}", "{:e}", "{:+.3E}", "{:.17g}", "{:.0f}."]
)


@given(
    st.lists(st.tuples(finite | st.integers(-(10**18), 10**18), formats), min_size=1),
    st.sampled_from([" ", "\n", "\t", "\r\n", "  \t "]),
)
def test_every_number_equals_what_python_reads_bit_for_bit(numbers, separator):
    tokens = [form.format(float(number)) for number, form in numbers]
    values = parse_numbers(separator.join(tokens).encode()).values
    assert values.tobytes() == np.array([float(token) for token in tokens]).tobytes()


@given(st.text("0123456789+-.eE ,nfi", max_size=40))
def test_a_token_is_read_exactly_if_python_reads_it(text):
    tokens = text.encode().split()
    try:
        expected = [float(token) for token in tokens]
    except ValueError:
        with pytest.raises(BadNumberError):
            parse_numbers(text.encode())
    else:
        np.testing.assert_array_equal(parse_numbers(text.encode()).values, expected)


def test_numbers_are_read_across_blocks_and_lines_counted():
    rows = [f"{row} {row / 7:.5f} {-row / 3:.3e}" for row in range(40_000)]
    numbers = parse_numbers("\n".join(rows).encode())
    expected = np.array([float(token) for row in rows for token in row.split()])
    assert np.array_equal(numbers.values, expected)
    assert np.array_equal(numbers.line_ends, np.arange(1, 40_001) * 3)


@pytest.mark.parametrize("bad", [b"oops", b"1.2.3", b"-.0.0000000", b"0.00000000.0000000"])
@pytest.mark.parametrize("before", [0, 3, 50_000])
def test_a_bad_number_is_told_by_index_and_place(before, bad):
    data = b"1.5 " * before + bad + b" 2"
    with pytest.raises(BadNumberError) as caught:
        parse_numbers(data)
    assert (caught.value.token, caught.value.index) == (bad, before)


@pytest.mark.motions
def test_real_files_are_read_bit_for_bit(motions_dir):
    for path in ("cmu/12_01_walk.bvh", "bandai-namco/dance-short_normal_001.bvh"):
        data = (motions_dir / path).read_bytes()
        file = read_bvh(data)
        _, _, motion = data.partition(b"Frame Time:")
        expected = [float(token) for token in motion.split()[1:]]
        assert file.values.ravel().tobytes() == np.array(expected).tobytes()


# Writing


@given(
    hnp.arrays(
        float, hnp.array_shapes(min_dims=2, max_dims=2), elements=st.floats(-999_998, 999_998)
    )
)
def test_numbers_are_written_with_six_decimals(values):
    text = format_rows(values)
    rows = [[float(token) for token in line.split()] for line in text.splitlines()]
    assert np.array(rows) == pytest.approx(values, abs=5.1e-7)
    assert text.split() == [
        token.removeprefix(b"-") if float(token) == 0 else token for token in text.split()
    ]


def test_numbers_are_written_as_people_write_them():
    values = np.array([[0.0, -0.0, 1000.0, -1234.5], [1e-7, 0.5, -0.000001, 100000.25]])
    assert format_rows(values) == (
        b"0.000000 0.000000 1000.000000 -1234.500000\n0.000000 0.500000 -0.000001 100000.250000\n"
    )


def read_back(data, unit):
    """A written file's clip, without what ingest decides: floor, heading and start stay."""
    file = read_bvh(data)
    motion = local_motion(file, 0)
    baked, _ = bake(motion)
    tips = tuple(
        EndSite(joint, tuple(np.array(tip) * unit)) for joint, tip in motion.tips if any(tip)
    )
    names = tuple(joint.name for joint in motion.joints)
    skeleton = Skeleton(names, motion.parents, baked.offsets * unit, tips)
    assert file.frame_time is not None
    return Clip(skeleton, baked.root_positions * unit, baked.rotations, file.frame_time)


def largest_distance(first, second):
    a, b = forward_kinematics(first), forward_kinematics(second)
    tips = end_site_positions(first.skeleton, a) - end_site_positions(second.skeleton, b)
    joints = a.positions - b.positions
    return max(np.linalg.norm(part, axis=-1).max(initial=0.0) for part in (joints, tips))


@st.composite
def clips(draw):
    joints, frames = draw(st.integers(1, 12)), draw(st.integers(1, 4))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    parents = np.array([-1] + [draw(st.integers(0, joint - 1)) for joint in range(1, joints)])
    offsets = rng.uniform(-0.5, 0.5, (joints, 3)) * (rng.random((joints, 1)) > 0.2)
    turns = Rotation.random(frames * joints, rng=rng).as_quat(scalar_first=True)
    sites = (EndSite(joints - 1, (0.1, -0.02, 0.0)),) if draw(st.booleans()) else ()
    return Clip(
        Skeleton(tuple(f"joint {n}" for n in range(joints)), parents, offsets, sites),
        rng.uniform(-20, 20, (frames, 3)),
        turns.reshape(frames, joints, 4),
        draw(st.sampled_from([1 / 30, 1 / 120, 0.01])),
    )


@given(clips(), st.sampled_from([0.01, 1.0, 0.0254]))
def test_written_and_read_again_every_joint_keeps_its_place(clip, unit):
    again = read_back(write_bvh(clip, unit=unit), unit)
    assert again.skeleton.names == tuple(
        clip.skeleton.names[joint] for joint in depth_first(clip.skeleton.parents)
    )
    assert again.frame_time == clip.frame_time
    order = depth_first(clip.skeleton.parents)
    first, second = (
        forward_kinematics(clip).positions[:, order],
        forward_kinematics(again).positions,
    )
    assert np.abs(first - second).max() < 1e-4


def depth_first(parents):
    order, stack = [], [0]
    while stack:
        joint = stack.pop()
        order.append(joint)
        stack += [child for child in range(len(parents) - 1, 0, -1) if parents[child] == joint]
    return order


@pytest.mark.motions
def test_every_real_file_written_and_read_again_keeps_every_joint_within_a_tenth_of_a_millimetre(
    motions_dir,
):
    paths = sorted(motions_dir.glob("*/*.bvh"))
    assert paths
    for path in paths:
        clip = ingest(path.read_bytes()).clip
        assert largest_distance(clip, read_back(write_bvh(clip), 0.01)) < 1e-4, path.name


def test_a_position_too_large_for_its_field_is_refused():
    clip = ingest(two_joints("0 0 0 0 0 0 0 0 0")).clip
    far = Clip(clip.skeleton, clip.root_positions + 1e7, clip.rotations, clip.frame_time)
    with pytest.raises(MotionError, match="too many digits"):
        write_bvh(far)


@pytest.mark.parametrize("unit", [0.0, -1.0, math.nan])
def test_a_unit_that_is_not_positive_is_refused(unit):
    clip = ingest(two_joints("0 0 0 0 0 0 0 0 0")).clip
    with pytest.raises(MotionError, match="unit must be above 0"):
        write_bvh(clip, unit=unit)
