"""From angles and foot paths to a clip: the hips ride on the legs, the legs reach the feet."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import maximum_filter1d

from motion.clip import Clip
from motion.ik import frame_along, solve_two_bones
from motion.procedural import gait
from motion.procedural.bodies import SIDES, Body, build_skeleton
from motion.procedural.channels import Arm, Channels
from motion.procedural.feet import FootPath
from motion.procedural.plan import FRAME_RATE, Plan
from motion.procedural.style import Style
from motion.rotations import (
    conjugate,
    from_axis_angle,
    make_continuous,
    multiply,
    normalise,
    rotate,
    slerp,
)
from motion.skeleton import Skeleton

Array = NDArray[np.float64]

_X, _Y, _Z = np.eye(3)
_REACH = 0.9978  # share of the leg's length at which the hips come down rather than stretch it


def orientation(yaw_pitch_roll: Array) -> Array:
    """World rotations (T, 4) of (T, 3) degrees: left forward, forward down, left up."""
    yaw, pitch, roll = np.radians(yaw_pitch_roll).T
    tilt = multiply(from_axis_angle(_X, pitch), from_axis_angle(_Z, roll))
    return multiply(from_axis_angle(_Y, -yaw), tilt)


def build_clip(
    plan: Plan, style: Style, body: Body, channels: Channels, feet: tuple[FootPath, FootPath]
) -> Clip:
    """The clip of a plan: world rotations of every joint, then local ones."""
    skeleton = build_skeleton(body)
    pelvis = orientation(channels.pelvis)
    root = _root(plan, style, body, channels, feet, pelvis)
    world = _trunk(channels, pelvis)
    heading = orientation(channels.chest * [1.0, 0.0, 0.0])
    for index, (side, sign) in enumerate(SIDES):
        world |= _leg(body, side, sign, root, pelvis, feet[index])
        world |= _arm(side, sign, channels.arms[index], world["chest"], heading)
    return Clip(skeleton, root, _local(skeleton, world), 1.0 / FRAME_RATE)


def _local(skeleton: Skeleton, world: dict[str, Array]) -> Array:
    """Local rotations (T, J, 4) of world rotations by joint name."""
    rotations = [world[skeleton.names[0]]]
    for name, parent in zip(skeleton.names[1:], skeleton.parents[1:], strict=True):
        rotations.append(multiply(conjugate(world[skeleton.names[parent]]), world[name]))
    return make_continuous(normalise(np.stack(rotations, axis=1)))


def _root(
    plan: Plan,
    style: Style,
    body: Body,
    channels: Channels,
    feet: tuple[FootPath, FootPath],
    pelvis: Array,
) -> Array:
    """(T, 3) the middle of the hips, as high as knees bent in the published way carry it."""
    flat = np.stack(
        [channels.sideways, np.zeros_like(channels.sideways), channels.forward], axis=-1
    )
    carried, ceiling = [], []
    for (_, sign), foot in zip(SIDES, feet, strict=True):
        offset = rotate(pelvis, np.array([sign * body.hip_half, 0.0, 0.0]))
        level = foot.ankle - flat - offset
        across = level[:, 0] ** 2 + level[:, 2] ** 2
        knee = np.radians(_stance_knee(plan, style, foot))
        wanted = body.thigh**2 + body.shin**2 + 2 * body.thigh * body.shin * np.cos(knee)
        reach = (_REACH * (body.thigh + body.shin)) ** 2
        carried.append(level[:, 1] + np.sqrt(np.maximum(wanted - across, 0.01)))
        ceiling.append(level[:, 1] + np.sqrt(np.maximum(reach - across, 0.01)))
    carrier = plan.smooth(plan.carrier(), 0.01)
    height = carrier * carried[0] + (1.0 - carrier) * carried[1]
    height = plan.smooth(np.minimum(height, np.minimum(*ceiling)), 0.03)
    mean = plan.smooth(height, 0.35)
    height = mean + style.bounce * (height - mean) - channels.drop
    excess = np.maximum(height - np.minimum(*ceiling), 0.0)
    # Come down before the leg is too short and stay until after: never at once.
    width = max(3, round(0.12 * plan.stride_time * FRAME_RATE))
    height = height - plan.smooth(maximum_filter1d(excess, width, mode="nearest"), 0.03)
    return flat + height[:, None] * _Y


def _stance_knee(plan: Plan, style: Style, foot: FootPath) -> Array:
    """(T,) degrees, bend of the carrying knee."""
    going = plan.walking()
    part = foot.phase % 1.0
    walking = gait.signal("knee", np.where(part > 0.9, part, np.minimum(part, 0.45)))
    return going * walking + (1.0 - going) * 6.0 + style.knee_bend


def _trunk(channels: Channels, pelvis: Array) -> dict[str, Array]:
    chest, head = orientation(channels.chest), orientation(channels.head)
    return {
        "hips": pelvis,
        "spine": slerp(pelvis, chest, 0.5),
        "chest": chest,
        "neck": slerp(chest, head, 0.5),
        "head": head,
    }


def _leg(
    body: Body, side: str, sign: float, root: Array, pelvis: Array, foot: FootPath
) -> dict[str, Array]:
    hip = root + rotate(pelvis, np.array([sign * body.hip_half, 0.0, 0.0]))
    # The knee points where the foot points, a little turned in towards the line of travel.
    pole = np.array([np.sin(0.6 * foot.yaw), 0.25, np.cos(0.6 * foot.yaw)])
    leg = solve_two_bones(hip, foot.ankle, pole, (body.thigh, body.shin), soft=0.001)
    heading = from_axis_angle(_Y, np.full(len(root), foot.yaw))
    sole = multiply(heading, from_axis_angle(_X, -foot.pitch))
    return {
        f"{side}_thigh": frame_along(leg.middle - hip, leg.hinge, -_Y),
        f"{side}_shin": frame_along(leg.end - leg.middle, leg.hinge, -_Y),
        f"{side}_foot": sole,
        f"{side}_toes": multiply(sole, from_axis_angle(_X, -foot.bend)),
    }


def _arm(side: str, sign: float, arm: Arm, chest: Array, heading: Array) -> dict[str, Array]:
    """World rotations from the T-pose; upper arms are set against the vertical, not the chest."""
    rad = np.radians
    lift = from_axis_angle(_Z, sign * rad(arm.collar_up))
    collar = multiply(chest, multiply(from_axis_angle(_Y, -sign * rad(arm.collar_forward)), lift))
    hang = multiply(
        from_axis_angle(_Z, sign * rad(arm.out - 90.0)), from_axis_angle(_X, rad(arm.turn))
    )
    upper = multiply(heading, multiply(from_axis_angle(_X, -rad(arm.swing)), hang))
    bend = from_axis_angle(_Y, -sign * rad(arm.elbow))
    forearm = multiply(upper, multiply(bend, from_axis_angle(_X, rad(arm.forearm_turn))))
    return {
        f"{side}_clavicle": collar,
        f"{side}_upper_arm": upper,
        f"{side}_forearm": forearm,
        f"{side}_hand": multiply(forearm, from_axis_angle(_Z, -sign * rad(arm.wrist))),
    }
