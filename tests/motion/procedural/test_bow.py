"""What makes a bow a bow."""

import numpy as np
import pytest

from motion.centre_of_mass import centre_of_mass
from motion.rotations import angle_between


@pytest.fixture(scope="module")
def bow(gaits):
    return gaits["bow"]


def test_the_head_sinks_to_the_middle_of_the_clip_and_comes_back(bow):
    height = bow.at("head")[:, 1]
    middle = bow.clip.frames // 2
    assert height[0] - height[middle] > 0.15
    assert height[middle] == pytest.approx(height.min(), abs=0.005)
    assert height[-1] == pytest.approx(height[0], abs=0.005)
    turned = angle_between(bow.clip.rotations[0], bow.clip.rotations[-1])
    assert np.degrees(turned).max() < 0.5


def test_the_weight_stays_over_the_feet(bow):
    """Horizontally between the heels and the balls, and in the middle."""
    centre = centre_of_mass(bow.clip.skeleton, bow.world)
    soles = np.stack([bow.sole("left"), bow.sole("right")])
    heels, balls = soles[:, 0, :, 2].max(axis=0), soles[:, 1, :, 2].min(axis=0)
    assert np.all((heels < centre[:, 2]) & (centre[:, 2] < balls))
    assert np.abs(centre[:, 0]).max() < 0.02


def test_the_feet_never_leave_their_place(bow):
    for side in ("left", "right"):
        assert np.ptp(bow.sole(side), axis=1).max() < 0.001


def test_the_hands_stay_one_over_the_other_in_front_of_the_body(bow):
    left, right = ((bow.at(f"{s}_hand") + bow.tips[f"{s}_hand"]) / 2 for s in ("left", "right"))
    apart = np.linalg.norm(left - right, axis=-1)
    assert apart.max() < 0.10
    assert (left - right)[:, 2].min() > 0.01
    hips = bow.at("hips")
    assert (np.minimum(left[:, 2], right[:, 2]) - hips[:, 2]).min() > 0.10


def test_the_trunk_bends_from_the_hips(bow):
    """The pelvis takes at least half of the trunk's bend: it is no crouching back."""

    def pitch(role):
        turn = bow.turn(role)[bow.clip.frames // 2]
        return np.degrees(2.0 * np.arctan2(turn[1], turn[0]))

    assert pitch("hips") > 0.5 * pitch("chest") > 15.0
