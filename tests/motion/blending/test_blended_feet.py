"""Feet of blends stand where they stand, on the floor."""

from __future__ import annotations

import numpy as np
import pytest

from motion import Clip
from motion.editing.cycles import three_cycles
from motion.editing.foot_plants import find_feet, runs
from motion.kinematics import forward_kinematics
from tests.motion.blending.conftest import mixtures

SLIP = 0.01  # m within one plant


def greatest_slip(clip: Clip) -> float:
    """How far any point of a sole moves on the floor while it stands, m."""
    three = three_cycles(clip)
    pose, found = forward_kinematics(three), [0.0]
    for foot in find_feet(three, pose):
        for point, planted in zip(foot.points, foot.planted, strict=True):
            level = point.positions(pose)[:, [0, 2]]
            for plant in runs(planted):
                if plant.start > 0 and plant.stop < three.frames:
                    way = level[plant] - level[plant.start]
                    found.append(float(np.linalg.norm(way, axis=1).max()))
    return max(found)


def soles(clip: Clip) -> np.ndarray:
    """Height (2, T) of the lowest point of either sole, m."""
    pose = forward_kinematics(clip)
    feet = find_feet(three_cycles(clip))
    heights = [[p.positions(pose)[:, 1] for p in foot.points] for foot in feet]
    return np.array([np.min(foot, axis=0) for foot in heights])


def test_feet_slide_less_than_a_centimetre(blender, walks):
    for weights in mixtures(40, len(walks)):
        clip = blender.blend(weights)
        assert greatest_slip(clip) <= SLIP
        assert len([r for f in find_feet(three_cycles(clip)) for r in f.plants()]) >= 4


def test_even_a_mean_of_all_stands(blender, walks):
    assert greatest_slip(blender.blend(np.ones(len(walks)))) <= SLIP


@pytest.mark.parametrize("kept", [1, 2, 3])
def test_a_foot_that_is_told_by_its_ankle_alone_stands_too(walks_a, kept):
    """A skeleton whose toes have no role has one point under each foot."""
    from dataclasses import replace

    from tests.motion.blending.conftest import blender_of

    roles = {r: j for r, j in walks_a[0].skeleton.roles.items() if "toes" not in r}
    toeless = walks_a[0].skeleton.with_roles(roles)
    clips = tuple(replace(walk, skeleton=toeless) for walk in walks_a[kept : kept + 2])
    assert greatest_slip(blender_of(clips).blend([0.5, 0.5])) <= SLIP


def test_soles_are_as_near_to_the_floor_as_those_of_the_examples(blender, walks):
    deepest = min(soles(walk).min() for walk in walks)
    for weights in mixtures(10, len(walks), seed=6):
        heights = soles(blender.blend(weights))
        assert heights.min() >= deepest - 0.002
        assert np.abs(heights.min(axis=1)).max() < 0.011


def test_knees_bend_forward(blender, walks):
    """As a rule: the knee lies ahead of the line from hip to ankle in nearly every frame."""
    roles = walks[0].skeleton.roles
    for weights in mixtures(6, len(walks), seed=7):
        places = forward_kinematics(blender.blend(weights)).positions
        for side in ("left", "right"):
            hip, knee, ankle = (places[:, roles[f"{side}_{p}"]] for p in ("thigh", "shin", "foot"))
            share = (hip - knee)[:, 1] / (hip - ankle)[:, 1]
            ahead = (knee - hip - share[:, None] * (ankle - hip))[:, 2]
            assert ahead.min() > -0.01
