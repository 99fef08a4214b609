"""The centre of mass, against what is published and what arithmetic says."""

import numpy as np
import pytest

from motion import Clip, MotionError
from motion.centre_of_mass import SEGMENTS, centre_of_mass
from motion.kinematics import forward_kinematics, pose_to_world
from motion.procedural.bodies import BODIES, build_skeleton
from motion.rotations import from_axis_angle


@pytest.fixture(params=sorted(BODIES))
def body(request):
    return BODIES[request.param]


def upright(body):
    skeleton = build_skeleton(body)
    rotations = np.zeros((1, len(skeleton), 4))
    rotations[..., 0] = 1.0
    for side, sign in (("left", -1), ("right", 1)):
        down = from_axis_angle(np.array([0.0, 0.0, 1.0]), np.asarray(sign * np.pi / 2))
        rotations[:, skeleton.roles[f"{side}_upper_arm"]] = down
    return Clip(skeleton, np.array([[0.0, body.leg_length, 0.0]]), rotations, 1 / 60)


def test_the_segments_weigh_as_much_as_the_body():
    paired = sum(s.mass for name, s in SEGMENTS.items() if name not in ("head", "trunk"))
    single = SEGMENTS["head"].mass + SEGMENTS["trunk"].mass
    assert single + 2 * paired == pytest.approx(1.0, abs=1e-3)


def test_a_standing_body_s_centre_is_at_its_usual_height(body):
    """54 to 58 % of the stature above the floor, in the middle (Hay 1973 and others)."""
    clip = upright(body)
    x, y, z = centre_of_mass(clip.skeleton, forward_kinematics(clip))[0]
    assert 0.54 < y / body.stature < 0.58
    assert x == pytest.approx(0.0, abs=1e-12)
    assert abs(z) < 0.02


def test_a_straight_arm_raised_to_the_side_moves_it_by_the_arm_s_moment(body):
    clip = upright(body)
    rotations = clip.rotations.copy()
    rotations[:, clip.skeleton.roles["left_upper_arm"]] = [1, 0, 0, 0]
    raised = pose_to_world(clip.skeleton, clip.root_positions, rotations)
    shift = centre_of_mass(clip.skeleton, raised) - centre_of_mass(
        clip.skeleton, forward_kinematics(clip)
    )
    upper, lower, hand = (np.array([0.163, 0.143, 0.105]) * body.stature).tolist()
    parts = [SEGMENTS[name] for name in ("upper_arm", "forearm", "hand")]
    reaches = [
        parts[0].centre * upper,
        upper + parts[1].centre * lower,
        upper + lower + parts[2].centre * hand,
    ]
    moment = sum(part.mass * reach for part, reach in zip(parts, reaches, strict=True))
    np.testing.assert_allclose(shift[0], [moment, moment, 0.0], atol=1e-4)


def test_a_missing_role_is_named(body):
    clip = upright(body)
    roles = {role: joint for role, joint in clip.skeleton.roles.items() if role != "left_shin"}
    with pytest.raises(MotionError, match="left shin"):
        centre_of_mass(clip.skeleton.with_roles(roles), forward_kinematics(clip))
