"""What is computed from a stored clip's bytes alone."""

from __future__ import annotations

import pytest

from app.errors import InvalidError
from app.services.clip_files import make_files
from app.services.rendering import Supplies, keytimes, render, retarget_error
from motion.keytimes import find_keytimes
from motion.procedural.library import sample_clips
from motion.storage import clip_to_bytes


@pytest.fixture(scope="module")
def samples():
    wanted = ("set_a_sad", "acted_male_sad", "acted_female_sad")
    return {sample.name: sample.clip for sample in sample_clips() if sample.name in wanted}


def test_keytimes_come_from_the_stored_clip(samples):
    for clip in samples.values():
        assert keytimes(clip_to_bytes(clip)) == find_keytimes(clip)
    assert len(keytimes(clip_to_bytes(samples["set_a_sad"]))) == 4


def test_the_error_of_a_retargeting_is_told_in_numbers(samples):
    man, woman = (clip_to_bytes(samples[f"acted_{who}_sad"]) for who in ("male", "female"))
    told = retarget_error(man, woman)
    assert 0.0 < told["mean_direction"] <= told["greatest_direction"] < 0.1
    assert 0.0 <= told["slip"] < 0.01
    assert 0.0 <= told["sole_height"] < 0.01
    assert told["unmapped"] == ()


def test_a_body_that_cannot_be_mapped_is_told(samples):
    man = samples["acted_male_sad"]
    arms = {role: joint for role, joint in man.skeleton.roles.items() if "arm" in role}
    other = type(man)(
        man.skeleton.with_roles(arms), man.root_positions, man.rotations, man.frame_time
    )
    with pytest.raises(InvalidError, match="set that body role"):
        retarget_error(clip_to_bytes(man), clip_to_bytes(other))


def test_on_another_body_the_stature_is_that_body_s(samples):
    man, woman = samples["acted_male_sad"], samples["acted_female_sad"]
    name, stature = "a" * 64, make_files(man).stature
    supplies = Supplies(clips={name: clip_to_bytes(woman)})
    onto = [{"operation": "retarget@1", "parameters": {"clip": name}}]
    assert render(clip_to_bytes(man), [], supplies, 1.5).stature == 1.5
    moved = render(clip_to_bytes(man), onto, supplies, stature)
    assert moved.stature == make_files(woman).stature
    assert moved.stature < stature - 0.05
    assert moved.skeleton_hash == woman.skeleton.content_hash
