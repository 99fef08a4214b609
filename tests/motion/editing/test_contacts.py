"""Acceleration at contacts only."""

import numpy as np
import pytest

from motion.editing.contacts import accelerate_contacts, sudden_stops
from motion.editing.foot_plants import find_feet
from motion.editing.limbs import find_limbs
from motion.editing.timing import limb_speed
from motion.kinematics import forward_kinematics
from motion.quality import check
from motion.rotations import angle_between
from tests.motion.editing.measures import bone_lengths


def speed_of(clip, limb):
    """(T − 1,) m/s of a limb's end relative to the hips."""
    return limb_speed(clip, forward_kinematics(clip), find_limbs(clip.skeleton)[limb])


def strikes(clip):
    """Limb and frame at which each foot comes down after a swing."""
    for foot in find_feet(clip):
        for plant in list(foot.plants())[1:]:
            yield f"{foot.side}_leg", plant.start


def test_an_amount_of_zero_changes_nothing(knocking):
    assert accelerate_contacts(knocking, 0.0) is knocking


def test_more_of_the_speed_lies_right_before_the_strikes(knocking):
    """Of the way that a foot makes in its last 0.4 s, more is left for the last 0.12 s."""
    last, all_of_it = round(0.12 / knocking.frame_time), round(0.4 / knocking.frame_time)
    shares = []
    for amount in (0.0, 0.5, 1.0):
        edited = accelerate_contacts(knocking, amount)
        part = []
        for limb, strike in strikes(knocking):
            speed = speed_of(edited, limb)
            part.append(
                speed[strike - last : strike].sum() / speed[strike - all_of_it : strike].sum()
            )
        shares.append(part)
    assert np.all(np.diff(shares, axis=0) > 0)


def test_knocks_are_found_and_hit_harder(knocking):
    speed = speed_of(knocking, "right_arm")
    knocks = sudden_stops(speed, knocking.frame_time)
    assert len(knocks) == 3
    harder = speed_of(accelerate_contacts(knocking), "right_arm")
    before = round(0.12 / knocking.frame_time)
    for knock in knocks:
        into = slice(knock - before, knock)
        assert harder[into].max() > 1.15 * speed[into].max()


@pytest.mark.motions
def test_arms_that_only_swing_hit_nothing(walk):
    """One of the recordings lets an arm come to rest once."""
    stops = [
        sudden_stops(speed_of(walk, arm), walk.frame_time) for arm in ("left_arm", "right_arm")
    ]
    assert sum(map(len, stops)) <= 1


@pytest.mark.parametrize("amount", [-1.0, 1.0, 2.0])
def test_length_ends_bones_and_other_times_stay(knocking, amount):
    edited = accelerate_contacts(knocking, amount)
    assert edited.frames == knocking.frames
    np.testing.assert_allclose(bone_lengths(edited), bone_lengths(knocking), atol=1e-9)
    arms = list(find_limbs(knocking.skeleton)["right_arm"].joints)
    ends = angle_between(edited.rotations[[0, -1]], knocking.rotations[[0, -1]])
    assert np.degrees(ends[:, arms]).max() < 1e-5
    knocks = sudden_stops(speed_of(knocking, "right_arm"), knocking.frame_time)
    untouched = slice(0, knocks[0] - round(0.5 / knocking.frame_time))
    turned = angle_between(edited.rotations[untouched, arms], knocking.rotations[untouched, arms])
    assert np.degrees(turned).max() < 1e-5


def test_feet_stand_and_stay_above_the_floor(knocking):
    kinds = {finding.kind for finding in check(knocking, accelerate_contacts(knocking)).findings}
    assert not kinds & {"foot slip", "floor", "balance"}


def test_a_cycle_stays_seamless(samples):
    clip = samples["set_a_proud"]
    edited = accelerate_contacts(clip)
    assert edited.cyclic
    np.testing.assert_array_equal(edited.rotations[0], edited.rotations[-1])
    steps = np.degrees(angle_between(edited.rotations[1:], edited.rotations[:-1])).max(axis=1)
    across = np.degrees(angle_between(edited.rotations[1], edited.rotations[-2])).max()
    assert across <= 2 * steps.max()
