"""The acted clips: a body walks up to a door and knocks."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import find_peaks

from motion.procedural.knock import KNOCKS
from motion.procedural.styles import ACTED
from tests.support.gait import SIDES

SCENES = [f"acted_{body}_{emotion}" for body in ("female", "male") for emotion in ACTED]


def reach(gait):
    """(T,) m that the right hand's tip is in front of the standing hips."""
    return gait.tips["right_hand"][:, 2] - gait.hips[-1, 2]


def knocks(gait):
    """Frames at which the right hand, raised, strikes forward."""
    way = reach(gait)
    peaks, _ = find_peaks(way, prominence=0.012, distance=6)
    peaks = peaks[gait.tips["right_hand"][peaks, 1] > 0.70 * gait.body.stature]
    return peaks[way[peaks] > way[peaks].max() - 0.02]


def hand_speed(gait):
    near = knocks(gait)
    speed = np.linalg.norm(gait.velocity(gait.tips["right_hand"] - gait.hips), axis=-1)
    return speed[near[0] - 10 : near[-1] + 10].max()


@pytest.mark.parametrize("name", SCENES)
def test_it_starts_standing_walks_a_few_steps_and_ends_standing(gaits, name):
    gait = gaits[name]
    assert 4.0 <= gait.clip.duration <= 8.0
    assert not gait.clip.cyclic
    speed = np.linalg.norm(gait.velocity(gait.hips), axis=-1)
    assert speed[:12].max() < 0.06
    assert speed[-12:].max() < 0.06
    assert speed.max() > 0.4
    assert gait.clip.travel[2] > 1.0
    # Both feet flat on the floor, side by side.
    for frame in (0, -1):
        assert all(gait.sole(side)[:, frame, 1].max() < 0.002 for side in SIDES)
        apart = gait.at("left_foot")[frame, 2] - gait.at("right_foot")[frame, 2]
        assert abs(apart) < 0.10


@pytest.mark.parametrize("name", SCENES)
def test_the_right_hand_knocks_as_often_as_the_emotion_does_and_always_at_the_same_door(
    gaits, name
):
    gait = gaits[name]
    frames = knocks(gait)
    assert len(frames) == KNOCKS[name.split("_")[-1]].count
    door = reach(gait)[frames]
    assert np.ptp(door) < 0.02
    assert reach(gait).max() < door.min() + 0.02  # nothing of the way leads through the door


@pytest.mark.parametrize("name", SCENES)
def test_the_hand_hangs_at_rest_before_and_after(gaits, name):
    gait = gaits[name]
    for frame in (0, -1):
        turned = gait.at("right_hand")[frame] - gait.at("right_upper_arm")[frame]
        assert turned[1] < -0.1


@pytest.mark.parametrize("body", ["female", "male"])
def test_emotions_knock_differently(gaits, body):
    take = {emotion: gaits[f"acted_{body}_{emotion}"] for emotion in ACTED}
    force = {emotion: hand_speed(gait) for emotion, gait in take.items()}
    assert force["angry"] > 1.4 * force["neutral"]
    assert force["strong"] > 1.2 * force["neutral"]
    assert max(force["sad"], force["weak"], force["afraid"]) < 0.8 * force["neutral"]
    rate = {e: np.diff(knocks(gait)).mean() for e, gait in take.items()}
    assert rate["excited"] < rate["neutral"] < rate["sad"]
    height = {e: gait.tips["right_hand"][knocks(gait), 1].mean() for e, gait in take.items()}
    assert height["strong"] > height["neutral"] > height["sad"]


@pytest.mark.parametrize("body", ["female", "male"])
def test_emotions_walk_and_stand_differently(gaits, body):
    take = {emotion: gaits[f"acted_{body}_{emotion}"] for emotion in ACTED}
    speed = {e: gait.velocity(gait.hips)[:, 2].max() for e, gait in take.items()}
    assert speed["angry"] > 1.15 * speed["neutral"]
    assert speed["sad"] < 0.75 * speed["neutral"]
    assert speed["afraid"] < 0.8 * speed["neutral"]
    head = {e: gait.head_pitch.mean() for e, gait in take.items()}
    assert head["sad"] > head["neutral"] + 15
    assert head["tired"] > head["neutral"] + 15
    assert head["happy"] < head["neutral"]
    elbow = {e: gait.elbow("left")[0] for e, gait in take.items()}
    assert elbow["afraid"] > elbow["neutral"] + 40
    wrist = {
        e: gait.at("left_hand")[0, 0] - gait.at("left_thigh")[0, 0] for e, gait in take.items()
    }
    assert wrist["strong"] > wrist["neutral"] > wrist["afraid"]
