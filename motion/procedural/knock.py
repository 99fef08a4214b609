"""A few steps up to a door, and a knock with the right hand."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator

from motion.clip import Clip
from motion.procedural import gait
from motion.procedural.bodies import Body
from motion.procedural.channels import Arm, Channels, walking_channels
from motion.procedural.feet import foot_path
from motion.procedural.plan import FRAME_RATE, LEFT, RIGHT, Plan, Step
from motion.procedural.pose import build_clip
from motion.procedural.style import Style
from motion.procedural.styles import ACTED, for_body

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Knock:
    """How somebody knocks.

    Angles in degrees, times in seconds.

    Attributes:
        count: knocks.
        period: from knock to knock.
        swing: how far the forearm opens for each knock.
        raise_time: from the hand's start to the first knock.
        height: upper arm forward of the vertical when it knocks.
        out: upper arm away from the body.
        elbow: bend between two knocks.
        lean: trunk bows towards the door while knocking.
        head: nose down while knocking, against the walk's.
        pause: from the last step to the hand's start; below 0 the hand rises before it.
        drop_time: the hand's way back.
        uneven: share by which the rhythm slows from knock to knock; below 0 it quickens.
    """

    count: int = 3
    period: float = 0.30
    swing: float = 22.0
    raise_time: float = 0.65
    height: float = 38.0
    out: float = 10.0
    elbow: float = 108.0
    lean: float = 3.0
    head: float = 0.0
    pause: float = -0.10
    drop_time: float = 0.9
    uneven: float = 0.0


KNOCKS: dict[str, Knock] = {
    "afraid": Knock(count=2, period=0.40, swing=11, raise_time=1.0, height=24, out=4, elbow=122,
                    lean=-2, head=4, pause=0.45, drop_time=0.5, uneven=0.25),
    "angry": Knock(count=5, period=0.19, swing=40, raise_time=0.42, height=62, out=24, elbow=112,
                   lean=6, head=-6, pause=-0.30, drop_time=0.55),
    "excited": Knock(count=5, period=0.17, swing=24, raise_time=0.45, height=56, out=16, elbow=106,
                     lean=4, head=-2, pause=-0.30, drop_time=0.6, uneven=-0.05),
    "happy": Knock(count=4, period=0.23, swing=26, raise_time=0.55, height=48, out=14,
                   lean=2, head=-3, pause=-0.2, drop_time=0.75),
    "neutral": Knock(),
    "relaxed": Knock(count=3, period=0.40, swing=20, raise_time=0.85, height=30, out=10, elbow=104,
                     lean=1, pause=0.1, drop_time=1.1),
    "sad": Knock(count=2, period=0.55, swing=15, raise_time=1.15, height=22, out=6, elbow=110,
                 lean=3, head=3, pause=0.35, drop_time=1.2, uneven=0.2),
    "strong": Knock(count=3, period=0.36, swing=42, raise_time=0.6, height=66, out=28, elbow=116,
                    lean=4, pause=-0.05, drop_time=0.8),
    "tired": Knock(count=3, period=0.50, swing=17, raise_time=1.1, height=24, out=6, elbow=106,
                   lean=7, head=5, pause=0.3, drop_time=0.9, uneven=0.15),
    "weak": Knock(count=3, period=0.42, swing=9, raise_time=1.0, height=26, out=3, elbow=118,
                  lean=2, pause=0.25, drop_time=0.9, uneven=0.1),
}  # fmt: skip

_STEPS = 4


def walk_and_knock(emotion: str, body: Body) -> Clip:
    """A body stands, walks four steps up to a door, knocks and lowers its hand."""
    style, knock = for_body(ACTED[emotion], body), KNOCKS[emotion]
    plan, hits = _plan(style, knock, body)
    channels = walking_channels(plan, style)
    _knock(channels, plan, knock, hits)
    feet = (foot_path(plan, style, body, LEFT), foot_path(plan, style, body, RIGHT))
    return build_clip(plan, style, body, channels, feet)


def _plan(style: Style, knock: Knock, body: Body) -> tuple[Plan, Array]:
    """Steps, and the times (n,) s at which the knuckles meet the door."""
    stride_time = 120.0 / style.cadence
    swing = (1.0 - style.stance) * stride_time
    contact = 0.45 + 0.3 * stride_time + swing
    length = style.stride * body.leg_length / 2.0
    ways = np.array([0.85, 1.0, 0.95, 0.0]) * length
    places = np.cumsum(ways)
    steps = []
    for count, place in enumerate(places):
        side = RIGHT if count % 2 == 0 else LEFT
        last = count == len(places) - 1
        slow = 1.12 if last else 1.0
        steps.append(Step(side, contact - swing, contact + (slow - 1.0) * swing, float(place)))
        contact += stride_time / 2.0
    start = steps[-1].contact + knock.pause + knock.raise_time
    gaps = knock.period * (1.0 + knock.uneven * np.arange(knock.count - 1))
    hits = start + np.concatenate([[0.0], np.cumsum(gaps)])
    end = hits[-1] + 0.25 + knock.drop_time + 0.35
    times = np.arange(round(end * FRAME_RATE) + 1) / FRAME_RATE
    return Plan(times, tuple(steps), (0.0, 0.0), stride_time), hits


def _knock(channels: Channels, plan: Plan, knock: Knock, hits: Array) -> None:
    """Lay the knock over the right arm, the trunk and the hips."""
    t = plan.times
    up = gait.smooth_step((t - hits[0] + knock.raise_time) / (knock.raise_time * 0.9))
    down = gait.smooth_step((t - hits[-1] - 0.15) / knock.drop_time)
    near = up * (1.0 - down)
    strike = _strikes(t, hits, knock.period)
    arm = channels.arms[RIGHT]
    poses = {
        "swing": (knock.height, 0.22 * knock.swing),
        "out": (knock.out, 0.0),
        "turn": (30.0, 0.0),
        "elbow": (knock.elbow, -knock.swing),
        "forearm_turn": (10.0, 0.0),
        "wrist": (-18.0, 30.0),
        "collar_up": (4.0, 0.0),
        "collar_forward": (8.0, 3.0),
    }
    for name, (held, hit) in poses.items():
        _blend(arm, name, near, held + hit * strike)
    channels.chest[:, 1] += near * (knock.lean + 0.05 * knock.swing * strike)
    channels.chest[:, 0] += -near * -6.0
    channels.pelvis[:, 1] += 0.3 * near * knock.lean
    channels.head[:, 1] += near * knock.head
    channels.forward += 0.02 * near
    channels.sideways += 0.012 * near


def _blend(arm: Arm, name: str, share: Array, value: Array) -> None:
    setattr(arm, name, (1.0 - share) * getattr(arm, name) + share * value)


def _strikes(times: Array, hits: Array, period: float) -> Array:
    """(T,) 1 at each knock, 0 between: quick towards the door, slower back."""
    knots = [(float(times[0]) - 1.0, 0.0)]
    for hit in hits:
        knots += [(hit - 0.42 * period, -0.35), (hit, 1.0), (hit + 0.25 * period, 0.35)]
    knots.append((hits[-1] + 0.5, 0.0))
    knots.append((float(times[-1]) + 1.0, 0.0))
    at, values = np.array(knots).T
    return np.asarray(PchipInterpolator(at, values)(times), dtype=float)
