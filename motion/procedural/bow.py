"""A bow of thanks: hands folded before the body, down from the hips, held, and up again."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.procedural import gait
from motion.procedural.bodies import BODIES, Body
from motion.procedural.channels import Channels, walking_channels
from motion.procedural.feet import foot_path
from motion.procedural.plan import FRAME_RATE, LEFT, RIGHT, Plan, Step
from motion.procedural.pose import build_clip
from motion.procedural.styles import NEUTRAL

Array = NDArray[np.float64]

# Seconds. The bow is deepest in the middle of the clip; one rises more slowly than one goes down.
_START, _DOWN, _HOLD, _UP, _REST = 0.5, 1.35, 1.0, 1.5, 0.35
_NEVER = 1e3  # seconds: the step for which a standing body's feet wait

_STYLE = NEUTRAL.but(step_width=0.11, toe_out=6, lean=1, head_pitch=1, arm_swing=0)

# Degrees of the arms, upright and bowed: the hands lie on each other before the lap and slide
# down along the thighs.
_FOLDED = {
    "swing": (8.0, -23.0), "out": (1.0, 16.0), "turn": (38.0, 62.0), "elbow": (32.0, 59.0),
    "forearm_turn": (9.0, 27.0), "wrist": (29.0, -5.0), "collar_up": (0.0, 0.0),
    "collar_forward": (6.0, 9.0),
}  # fmt: skip
# Forward and down, degrees: pelvis, chest and head lie on one line when it is deepest.
_PELVIS, _CHEST, _HEAD = 30.0, 44.0, 50.0
_BACK = 0.12  # metres that the hips go back, so that the weight stays over the feet


def bow(body: Body = BODIES["adult"]) -> Clip:
    """A standing body bows and rises; it ends as it began."""
    end = _START + _DOWN + _HOLD + _UP + _REST
    times = np.arange(round(end * FRAME_RATE) + 1) / FRAME_RATE
    steps = tuple(Step(side, _NEVER, _NEVER + 1.0, 0.5) for side in (LEFT, RIGHT))
    plan = Plan(times, steps, (0.0, 0.0), stride_time=1.1)
    channels = walking_channels(plan, _STYLE)
    _bend(channels, plan)
    _fold(channels, plan)
    feet = (foot_path(plan, _STYLE, body, LEFT), foot_path(plan, _STYLE, body, RIGHT))
    return build_clip(plan, _STYLE, body, channels, feet)


def _share(plan: Plan, lead: float) -> Array:
    """(T,) 0 upright to 1 bowed; what leads by so many seconds goes first both ways."""
    t = plan.times + lead
    down = gait.smooth_step((t - _START) / _DOWN)
    up = gait.smooth_step((t - _START - _DOWN - _HOLD) / _UP)
    return plan.smooth(down * (1.0 - up), 0.06)


def _bend(channels: Channels, plan: Plan) -> None:
    # The hips begin, the back follows, the head comes last: a bow, not a hinge.
    hips, back, head = (_share(plan, lead) for lead in (0.06, 0.0, -0.08))
    breath = np.sin(2.0 * np.pi * plan.times / plan.times[-1])
    channels.pelvis[:, 1] += _PELVIS * hips
    channels.chest[:, 1] += _CHEST * back - 0.5 * breath
    channels.head[:, 1] += _HEAD * head
    channels.forward -= _BACK * hips


def _fold(channels: Channels, plan: Plan) -> None:
    share = _share(plan, 0.0)
    for side, arm in enumerate(channels.arms):
        for name, (upright, bowed) in _FOLDED.items():
            setattr(arm, name, upright + share * (bowed - upright))
        if side == LEFT:  # the left hand lies over the right
            arm.swing = arm.swing + 3.0
