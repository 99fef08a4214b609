"""A stored clip is the clip."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from motion.clip import Clip
from motion.errors import MotionError
from motion.skeleton import EndSite, Skeleton
from motion.storage import clip_from_bytes, clip_to_bytes


@st.composite
def clips(draw):
    joints, frames = draw(st.integers(1, 6)), draw(st.integers(0, 5))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    names = draw(st.lists(st.text(min_size=1), min_size=joints, max_size=joints, unique=True))
    parents = np.array([-1] + [draw(st.integers(0, joint - 1)) for joint in range(1, joints)])
    skeleton = Skeleton(
        tuple(names),
        parents,
        rng.normal(size=(joints, 3)),
        (EndSite(joints - 1, (0.1, 1 / 3, -0.0)),),
        {"hips": 0, "head": joints - 1},
    )
    turns = Rotation.random(max(frames * joints, 1), rng=rng).as_quat()[: frames * joints]
    return Clip(
        skeleton,
        rng.normal(size=(frames, 3)),
        turns.reshape(frames, joints, 4),
        draw(st.floats(1e-4, 1.0)),
        draw(st.booleans()),
    )


@given(clips())
def test_storing_loses_nothing_and_gives_the_same_bytes_each_time(clip):
    data = clip_to_bytes(clip)
    again = clip_from_bytes(data)
    assert again.content_hash == clip.content_hash
    assert again.skeleton.content_hash == clip.skeleton.content_hash
    assert again.skeleton.names == clip.skeleton.names
    assert again.skeleton.end_sites == clip.skeleton.end_sites
    assert dict(again.skeleton.roles) == dict(clip.skeleton.roles)
    assert (again.frame_time, again.cyclic) == (clip.frame_time, clip.cyclic)
    assert clip_to_bytes(again) == data


@pytest.mark.parametrize("data", [b"", b"PK", b"manner-clip-1\n{}\n", b"manner-clip-1\nx\ny"])
def test_bytes_that_are_no_clip_are_refused(data):
    with pytest.raises(MotionError):
        clip_from_bytes(data)


@given(clips(), st.data())
def test_a_clip_cut_short_is_refused(clip, data):
    whole = clip_to_bytes(clip)
    with pytest.raises(MotionError):
        clip_from_bytes(whole[: data.draw(st.integers(0, len(whole) - 1))])
