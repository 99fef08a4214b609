"""How a foot rolls over the ground and swings to its next place.

A foot is a rigid sole from heel to ball and toes that bend at the ball. On the ground it turns
about its heel, lies flat, turns about its ball and at last about the toes' tip, so the point it
turns about does not slip. Seen from the side: "ahead" is along the foot, "up" is from the floor.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.special import betainc

from motion.procedural import gait
from motion.procedural.bodies import Body, Foot
from motion.procedural.plan import LEFT, Plan, Step
from motion.procedural.style import Style

Array = NDArray[np.float64]

_TOES_BEND = 32.0  # degrees the toes bend before they, too, leave the floor
# Lift of the foot over the swing, metres at shares of it: up after toe-off, then as much as takes
# the toes past the floor while the foot levels out, and down to the heel's soft landing.
_LIFT = ((0.0, 0.2, 0.4, 0.575, 0.75, 0.9, 1.0), (0.0, 0.026, 0.021, 0.029, 0.016, 0.004, 0.0))
_LEAST_CLEARANCE = 0.009  # metres in mid-swing, at a foot lift of 1


@dataclass(frozen=True)
class FootPath:
    """One foot over time.

    Attributes:
        ankle: (T, 3) m.
        pitch: (T,) rad, toe up positive.
        bend: (T,) rad, toes bent upward against the sole.
        yaw: rad, turned towards the left.
        phase: (T,) of this foot.
    """

    ankle: Array
    pitch: Array
    bend: Array
    yaw: float
    phase: Array


def foot_path(plan: Plan, style: Style, body: Body, side: int) -> FootPath:
    """The way of one foot through a plan."""
    steps = plan.of_side(side)
    phase = plan.foot_phase(side)
    count = np.floor(phase).astype(int)
    part = phase - count
    swing = np.clip((part - gait.TOE_OFF) / (1.0 - gait.TOE_OFF), 0.0, 1.0)
    pitch = _pitch(phase, style, _step_shares(steps, plan.start[side], style, body))
    bend = _toe_bend(pitch, part, swing)
    ahead, up, lowest = _sole(body.foot, pitch, bend, part, swing)
    places = np.array([plan.start[side], *(step.place for step in steps)])
    here = np.clip(count + 1, 0, len(steps))
    there = np.clip(here + 1, 0, len(steps))
    # A beta distribution's curve: starts and stops gently and peaks at 1.5 × its mean.
    progress = betainc(1.96, 2.15, swing)
    length = places[there] - places[here]
    lift = style.foot_lift * np.clip(np.abs(length) / 0.8, 0.35, 1.0)
    up = _clear(up + lift * CubicSpline(*_LIFT, bc_type="clamped")(swing), lowest, swing, style)
    sign = 1.0 if side == LEFT else -1.0
    yaw = sign * np.radians(style.toe_out)
    ankle = np.stack(
        [
            sign * style.step_width / 2 + ahead * np.sin(yaw),
            up,
            places[here] + progress * length + ahead * np.cos(yaw),
        ],
        axis=-1,
    )
    return FootPath(ankle, pitch, bend, yaw, phase)


def _step_shares(steps: list[Step], start: float, style: Style, body: Body) -> Array:
    """Each step's length against a neutral stride: short steps roll less."""
    places = np.array([start, *(step.place for step in steps)])
    return np.clip(np.abs(np.diff(places)) / (1.5 * body.leg_length), 0.0, 1.15)


def _pitch(phase: Array, style: Style, shares: Array) -> Array:
    """Sole's pitch (T,) rad: the published curve, exactly 0 while the foot lies flat."""
    part = phase - np.floor(phase)
    rolled = 1.0 - gait.smooth_step((part - 0.02) / 0.10) * gait.smooth_step((0.55 - part) / 0.20)
    # The longer a foot stays behind the body, the further its heel has to rise.
    late = style.push_off * (style.stance - 0.25) / (gait.TOE_OFF - 0.25)
    knots = [(-0.7, late * shares[0]), (-0.2, late * shares[0])]
    for count, share in enumerate(shares):
        strike = style.heel_strike * share
        knots += [(count - 0.08, strike), (count + 0.15, strike)]
        push = late * shares[min(count + 1, len(shares) - 1)]
        knots += [(count + 0.3, push), (count + 0.8, push)]
    at, gains = np.array(knots).T
    gain = np.interp(phase, at, gains)
    return np.radians(rolled * gain * gait.signal("foot", phase))


def _toe_bend(pitch: Array, part: Array, swing: Array) -> Array:
    """Toes' bend (T,) rad: flat on the floor under a rising heel, loosening in swing."""
    limit, width = np.radians(_TOES_BEND), np.radians(12.0)
    over = np.clip(-pitch - limit + width, 0.0, None)
    off_floor = np.where(over < 2 * width, over**2 / (4 * width), -pitch - limit)
    grounded = np.clip(-pitch, 0.0, None) - off_floor
    raised = np.radians(9.0) * gait.smooth_step((swing - 0.35) / 0.5)
    raised += np.radians(9.0) * (1.0 - gait.smooth_step(part / 0.09)) * (part < gait.TOE_OFF)
    return grounded * (1.0 - gait.smooth_step(swing / 0.75)) + raised


def _clear(up: Array, lowest: Array, swing: Array, style: Style) -> Array:
    """Ankle heights (T,) raised in swing as far as the sole's lowest point needs it."""
    middle = np.sin(np.pi * swing) ** 2
    wanted = _LEAST_CLEARANCE * style.foot_lift * middle - lowest
    short = np.where(middle > 0.2, (wanted - up) / np.maximum(middle, 0.2), 0.0)
    return up + max(float(short.max()), 0.0) * middle


def _sole(
    foot: Foot, pitch: Array, bend: Array, part: Array, swing: Array
) -> tuple[Array, Array, Array]:
    """Ankle's shift ahead and height (T,) that keep the turning point still and on the floor.

    The third (T,) is the height of the sole's lowest point against the ankle.
    """
    toes = pitch + bend
    heel = _turn(foot.heel, -foot.ankle, pitch)
    ball = _turn(foot.ball, foot.ball_height - foot.ankle, pitch)
    tip = ball + _turn(foot.tip - foot.ball, -foot.ball_height, toes)
    under_ball = _turn(foot.ball, -foot.ankle, pitch)
    about_heel = foot.heel - heel[0]
    about_tip = foot.tip - tip[0]
    to_heel = np.where(
        part < gait.TOE_OFF,
        1.0 - gait.smooth_step((part - 0.13) / 0.15),
        gait.smooth_step((swing - 0.35) / 0.55),
    )
    ahead = to_heel * about_heel + (1.0 - to_heel) * about_tip
    lowest = np.minimum(np.minimum(heel[1], tip[1]), under_ball[1])
    in_air = -to_heel * heel[1] - (1.0 - to_heel) * tip[1]
    return ahead, np.where(swing > 0.0, in_air, -lowest), lowest


def _turn(ahead: float, up: float, angle: Array) -> Array:
    """Points (2, T): ahead and up after turning by ``angle`` (T,) rad, toe up."""
    return np.stack(
        [
            ahead * np.cos(angle) - up * np.sin(angle),
            ahead * np.sin(angle) + up * np.cos(angle),
        ]
    )
