"""Standing, walking, turning left and right: clips from which a walk can be steered.

A turn is a straight walk whose ground is bent into an arc. While a foot stands it belongs to one
place of the arc and keeps its footing; in the air it goes over to the next place.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from motion.clip import Clip
from motion.ik import frame_along, solve_two_bones
from motion.kinematics import WorldPose, forward_kinematics
from motion.procedural import gait
from motion.procedural.bodies import SIDES, Body
from motion.procedural.channels import Channels, walking_channels
from motion.procedural.feet import foot_path
from motion.procedural.plan import FRAME_RATE, LEFT, RIGHT, Plan, Step
from motion.procedural.pose import build_clip
from motion.procedural.style import Style
from motion.procedural.styles import NEUTRAL, for_body
from motion.rotations import conjugate, from_axis_angle, make_continuous, multiply, rotate, slerp

Array = NDArray[np.float64]

_X, _Y, _Z = np.eye(3)
_BREATH = 4.0  # s
_AT_REST = 0.6  # s before the first foot lifts
_BEHIND = 0.05  # of a step: the right foot of a standing body stands that much behind the left
_GRID = 0.01  # m: how finely the bent path is known
_LOOK = 0.4  # m: how far along the path the eyes are ahead
_LEAN = 4.0  # degrees towards the inside of a turn
_DROP = 0.012  # m that the hips come down in a turn, for the outer leg has farther to reach


@dataclass(frozen=True)
class Turn:
    """Where a walk bends.

    Attributes:
        angle: rad in all, to the left positive.
        start, end: m along the walk; within, the path is an arc whose ends ease in and out.
    """

    angle: float
    start: float
    end: float


def graph_clips(body: Body) -> dict[str, Clip]:
    """The clips "stand", "walk", "turn_left" and "turn_right" of a body, 60 frames a second.

    Standing is cyclic; the others stand, walk off and come to stand in the same way, so that each
    can follow each. The turns go around by three quarters of a circle.
    """
    style = for_body(NEUTRAL, body).but(stride=1.3, knee_bend=4.0, asymmetry=0.0)
    step = style.stride * body.leg_length / 2.0
    around = (2.0 * step, 12.0 * step)
    return {
        "stand": _stand(style, body),
        "walk": _straight(style, body, _plan(style, body, 10)),
        "turn_left": turning_walk(style, body, 14, Turn(1.5 * np.pi, *around)),
        "turn_right": turning_walk(style, body, 14, Turn(-1.5 * np.pi, *around)),
    }


def turning_walk(style: Style, body: Body, steps: int, turn: Turn) -> Clip:
    """A walk from standing to standing whose way bends.

    Args:
        style: how it is walked.
        body: who walks.
        steps: an even number.
        turn: where and how far the way bends.
    """
    plan = _plan(style, body, steps)
    clip = _straight(style, body, plan)
    path = _Path(turn, end=plan.steps[-1].place + 2.0)
    middle = plan.middle()
    turned = _bent_trunk(clip, path, middle)
    return _legs_on_path(turned, clip, body, style, plan, path, middle)


def _plan(style: Style, body: Body, count: int) -> Plan:
    """``count`` steps, the last of which brings the feet to stand as they stood before."""
    stride_time = 120.0 / style.cadence
    swing = (1.0 - style.stance) * stride_time
    length = style.stride * body.leg_length / 2.0
    places = [length * (0.85 + index) for index in range(count - 1)]
    places.append(places[-1] + _BEHIND * length)
    steps = [
        Step(
            RIGHT if index % 2 == 0 else LEFT,
            lift := _AT_REST + 0.5 * index * stride_time,
            lift + swing,
            place,
        )
        for index, place in enumerate(places)
    ]
    end = steps[-1].contact + 0.5 * stride_time + _AT_REST
    times = np.arange(round(end * FRAME_RATE) + 1) / FRAME_RATE
    return Plan(times, tuple(steps), (0.0, -_BEHIND * length), stride_time)


def _stand(style: Style, body: Body) -> Clip:
    """One breath, standing as before the first step of a walk."""
    plan = _plan(style, body, 2)
    before = -2.0 * _BREATH + np.arange(round(_BREATH * FRAME_RATE) + 1) / FRAME_RATE
    clip = _straight(style, body, replace(plan, times=before))
    root, rotations = clip.root_positions.copy(), clip.rotations.copy()
    root[-1], rotations[-1] = root[0], rotations[0]
    return replace(clip, root_positions=root, rotations=rotations, cyclic=True)


def _straight(style: Style, body: Body, plan: Plan) -> Clip:
    channels = walking_channels(plan, style)
    _breathe(channels, plan, style)
    feet = (foot_path(plan, style, body, LEFT), foot_path(plan, style, body, RIGHT))
    return build_clip(plan, style, body, channels, feet)


def _breathe(channels: Channels, plan: Plan, style: Style) -> None:
    """A standing body balances its lean, breathes and sways a little."""
    still = 1.0 - plan.walking()
    channels.chest[:, 1] -= 0.25 * still * style.lean
    channels.forward -= 0.0032 * still * style.lean
    breath = np.sin(2.0 * np.pi * plan.times / _BREATH)
    channels.chest[:, 1] -= 0.5 * breath
    channels.sideways += 0.004 * still * np.sin(2.0 * np.pi * plan.times / _BREATH + 1.0)
    for arm in channels.arms:
        arm.collar_up = arm.collar_up + 0.6 * breath


class _Path:
    """A straight way along +z, bent: place and heading at each distance along it."""

    def __init__(self, turn: Turn, end: float) -> None:
        self.distance = np.arange(-2.0, end, _GRID)
        inside = (self.distance > turn.start) & (self.distance < turn.end)
        curvature = gaussian_filter1d(inside.astype(float), 0.3 / _GRID)
        self.share = curvature / curvature.max() * np.sign(turn.angle)
        heading = np.cumsum(curvature) / curvature.sum() * turn.angle
        self.heading = heading
        start = np.searchsorted(self.distance, 0.0)
        self.x = np.cumsum(np.sin(heading)) * _GRID
        self.z = np.cumsum(np.cos(heading)) * _GRID
        self.x -= self.x[start]
        self.z -= self.z[start]

    def value(self, along: Array, values: Array) -> Array:
        """Values (T,) of the grid at distances (T,)."""
        return np.interp(along, self.distance, values)

    def turn(self, along: Array) -> Array:
        """World rotations (T, 4) of somebody who walks there."""
        return from_axis_angle(_Y, self.value(along, self.heading))

    def bend(self, points: Array, along: Array) -> Array:
        """Points (T, 3) of the straight walk, carried to the path with its distances (T,)."""
        level = np.zeros_like(along)
        place = np.stack([self.value(along, self.x), level, self.value(along, self.z)], axis=-1)
        return place + rotate(self.turn(along), points - along[:, None] * _Z)


def _bent_trunk(clip: Clip, path: _Path, middle: Array) -> Clip:
    """Hips on the path, leaning inwards; the head stays level and looks ahead into the turn."""
    roles = clip.skeleton.roles
    lean = -np.radians(_LEAN) * path.value(middle, path.share)
    tilt = from_axis_angle(_Z, lean)
    root = rotate(tilt, clip.root_positions - middle[:, None] * _Z) + middle[:, None] * _Z
    root[:, 1] -= _DROP * np.abs(path.value(middle, path.share))
    rotations = clip.rotations.copy()
    rotations[:, 0] = multiply(path.turn(middle), multiply(tilt, rotations[:, 0]))
    ahead = path.value(middle + _LOOK, path.heading) - path.value(middle, path.heading)
    for role in ("neck", "head"):
        look = multiply(from_axis_angle(_Y, ahead / 2.0), from_axis_angle(_Z, -lean / 2.0))
        rotations[:, roles[role]] = multiply(look, rotations[:, roles[role]])
    return replace(clip, root_positions=path.bend(root, middle), rotations=rotations)


def _legs_on_path(
    turned: Clip, straight: Clip, body: Body, style: Style, plan: Plan, path: _Path, middle: Array
) -> Clip:
    roles = turned.skeleton.roles
    pose, before = forward_kinematics(turned), forward_kinematics(straight)
    rotations = turned.rotations.copy()
    for index, (side, sign) in enumerate(SIDES):
        along = _footing(plan, index)
        heading = path.turn(along)
        ankle = path.bend(before.positions[:, roles[f"{side}_foot"]], along)
        yaw = sign * 0.6 * np.radians(style.toe_out)
        knee = np.array([np.sin(yaw), 0.25, np.cos(yaw)])
        pole = rotate(slerp(path.turn(middle), heading, 0.6), knee)
        hip = pose.positions[:, roles[f"{side}_thigh"]]
        leg = solve_two_bones(hip, ankle, pole, (body.thigh, body.shin), soft=0.001)
        thigh = frame_along(leg.middle - hip, leg.hinge, -_Y)
        shin = frame_along(leg.end - leg.middle, leg.hinge, -_Y)
        foot = multiply(heading, before.rotations[:, roles[f"{side}_foot"]])
        _set_leg(rotations, pose, roles[f"{side}_thigh"], (thigh, shin, foot))
    return replace(turned, rotations=make_continuous(rotations))


def _set_leg(
    rotations: Array, pose: WorldPose, thigh: int, world: tuple[Array, Array, Array]
) -> None:
    """World rotations of thigh, shin and foot, which follow each other, as local ones."""
    above = pose.rotations[:, 0]
    for joint, turn in enumerate(world, start=thigh):
        rotations[:, joint] = multiply(conjugate(above), turn)
        above = turn


def _footing(plan: Plan, side: int) -> Array:
    """(T,) m along the way: the place to which a foot belongs."""
    along = np.full(len(plan.times), plan.start[side])
    before = plan.start[side]
    for step in plan.of_side(side):
        share = gait.smooth_step((plan.times - step.lift) / (step.contact - step.lift))
        along += share * (step.place - before)
        before = step.place
    return along
