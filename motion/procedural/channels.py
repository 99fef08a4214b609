"""The body's angles over time, before the feet are fixed to the floor."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.procedural import gait
from motion.procedural.plan import Plan
from motion.procedural.style import Style

Array = NDArray[np.float64]

_AHEAD = 0.027  # metres that the hips are carried in front of the ankles' middle


@dataclass
class Arm:
    """One arm, degrees, each (T,); forward, out, inward, bent and up are positive."""

    swing: Array
    out: Array
    turn: Array
    elbow: Array
    forearm_turn: Array
    wrist: Array
    collar_up: Array
    collar_forward: Array


@dataclass
class Channels:
    """Everything but the legs, degrees and metres, each (T,).

    Yaw and roll: left side forward and up; pitch: forward and down. All against the world, not
    against the parent, so that a head stays level on a leaning trunk.
    """

    forward: Array
    sideways: Array
    drop: Array
    pelvis: Array
    chest: Array
    head: Array
    arms: tuple[Arm, Arm]


def walking_channels(plan: Plan, style: Style) -> Channels:
    """Pelvis, trunk, head and arms of a walk."""
    phase, going = plan.phase(), plan.walking()
    load = plan.smooth(plan.load(), 0.09)
    side = 2.0 * load - 1.0
    pelvis = _pelvis(phase, going, style)
    chest = _chest(phase, going, side, pelvis, style)
    speed = np.gradient(plan.middle(), plan.times)
    # The speed is highest in double support; its integral is the hips' advance and lag.
    # Who keeps the feet down for longer leaves them further behind, were the hips as far ahead.
    ahead = _AHEAD - going * 0.3 * (style.stance - 0.60)
    surge = style.surge / (4.0 * np.pi) * plan.stride_time * speed
    return Channels(
        forward=plan.middle() + ahead + going * gait.wave(phase, 1.0, 7.0 + 12.5, 2) * surge,
        sideways=style.sway / 2.0 * 1.05 * side,
        drop=np.zeros_like(phase),
        pelvis=pelvis,
        chest=chest,
        head=_head(phase, going, chest, style),
        arms=(_arm(phase, going, style, 1.0), _arm(phase + 0.5, going, style, -1.0)),
    )


def _pelvis(phase: Array, going: Array, style: Style) -> Array:
    """(T, 3) yaw, pitch, roll."""
    yaw = style.pelvis_yaw * gait.signal("pelvis_yaw", phase)
    roll = style.pelvis_roll * gait.signal("pelvis_roll", phase)
    pitch = 0.35 * style.lean + going * gait.wave(phase, 1.2, 3.0, 2)
    return np.stack([going * yaw, pitch, going * roll], axis=-1)


def _chest(phase: Array, going: Array, side: Array, pelvis: Array, style: Style) -> Array:
    """(T, 3): turns against the pelvis, leans a little over the standing leg, bows each step."""
    loose = 1.0 - 0.6 * style.tension
    yaw = loose * style.shoulder_twist * going * gait.wave(phase, 1.0, 52.0)
    yaw += 0.15 * going * style.asymmetry * 60.0
    dip = gait.wave(phase, 0.7 + 3.0 * style.heaviness, 8.0, 2)
    pitch = style.lean + style.chest_pitch + going * dip
    roll = -0.25 * pelvis[:, 2] * loose - style.side_lean * side
    return np.stack([yaw, pitch, roll], axis=-1)


def _head(phase: Array, going: Array, chest: Array, style: Style) -> Array:
    """(T, 3): nearly still in the world; it follows the trunk only a little."""
    yaw = 0.15 * chest[:, 0]
    pitch = style.head_pitch + going * gait.wave(phase, style.head_bob, 14.0, 2)
    return np.stack([yaw, pitch, 0.25 * chest[:, 2]], axis=-1)


def _arm(phase: Array, going: Array, style: Style, sign: float) -> Arm:
    """One arm; ``phase`` is that of the same side's foot, which the arm swings against."""
    loose = 1.0 - style.tension
    amplitude = going * style.arm_swing / 2.0 * (1.0 + 4.0 * sign * style.asymmetry)
    cycle = gait.wave(phase, 1.0, 49.0) + gait.wave(phase, 0.06, 45.0, 2)
    lag = 52.0 + 3.0 * loose  # the forearm trails the upper arm like the second of two pendulums
    bend = gait.wave(phase, 1.0, lag) + 0.15 * loose * gait.wave(phase, 1.0, 52.0, 2)
    hand = gait.wave(phase, 1.0, lag + 8.0)
    still = np.zeros_like(phase)
    above = 0.04 * sign * style.elbow  # of two hands held up, the left lies over the right
    share = amplitude / 17.0
    return Arm(
        swing=style.arm_forward + amplitude * cycle,
        out=style.arm_out + share * gait.wave(phase, 1.2, 53.0),
        turn=style.arm_turn + share * gait.wave(phase, 5.0, 52.0),
        elbow=np.maximum(style.elbow + above + going * style.elbow_swing / 2.0 * bend, 3.0),
        forearm_turn=18.0 + share * gait.wave(phase, 4.0, 56.0),
        wrist=style.wrist - 4.0 * loose * share * hand,
        collar_up=style.shoulder_lift + 2.0 * style.tension + share * gait.wave(phase, 0.8, 50.0),
        collar_forward=style.shoulder_forward + share * gait.wave(phase, 2.0, 50.0) + still,
    )
