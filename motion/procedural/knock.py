"""A few steps up to a door, and a knock with the right hand."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator

from motion.clip import Clip
from motion.procedural import gait
from motion.procedural.bodies import Body
from motion.procedural.channels import Channels, walking_channels
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
        falter: share of the way that the hand draws back once before the first knock.
        breath: seconds of a breath.
        tremble: degrees.
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
    falter: float = 0.0
    breath: float = 4.0
    tremble: float = 0.0


KNOCKS: dict[str, Knock] = {
    "afraid": Knock(
        count=2, period=0.40, swing=16, raise_time=1.35, height=44, out=4, elbow=122, lean=-2,
        head=-4, pause=0.25, drop_time=0.45, uneven=0.25, falter=0.35, breath=1.7, tremble=0.9,
    ),
    "angry": Knock(
        count=5, period=0.20, swing=42, raise_time=0.42, height=64, out=24, elbow=104, lean=5,
        head=-8, pause=-0.30, drop_time=0.5, breath=2.0,
    ),
    "excited": Knock(
        count=5, period=0.17, swing=25, raise_time=0.45, height=58, out=16, lean=3, head=-2,
        pause=-0.30, drop_time=0.6, uneven=-0.05, breath=2.2,
    ),
    "happy": Knock(
        count=4, period=0.23, swing=27, raise_time=0.55, height=50, out=14, lean=2, head=-3,
        pause=-0.20, drop_time=0.75, breath=3.2,
    ),
    "neutral": Knock(),
    "relaxed": Knock(
        count=3, period=0.40, swing=21, raise_time=0.85, height=34, out=12, elbow=104, lean=1,
        pause=0.10, drop_time=1.1, breath=5.0,
    ),
    "sad": Knock(
        count=2, period=0.58, swing=16, raise_time=1.15, height=24, out=6, elbow=108, lean=2,
        head=3, pause=0.35, drop_time=1.2, uneven=0.2, breath=4.6,
    ),
    "strong": Knock(
        count=3, period=0.36, swing=44, raise_time=0.6, height=68, out=28, elbow=108, lean=3,
        pause=-0.05, drop_time=0.8, breath=3.4,
    ),
    "tired": Knock(
        count=3, period=0.50, swing=18, raise_time=1.1, height=26, out=8, elbow=104, lean=6,
        head=5, pause=0.30, drop_time=0.8, uneven=0.15, breath=4.4,
    ),
    "weak": Knock(
        count=3, period=0.42, swing=16, raise_time=1.0, height=30, out=3, elbow=124, lean=2,
        pause=0.25, drop_time=0.9, uneven=0.1, breath=3.0, tremble=0.3,
    ),
}  # fmt: skip

# Share of a full step of each way; the last foot comes to stand a little behind the other.
_WAYS = (0.85, 1.0, 0.95, -0.08)


def walk_and_knock(emotion: str, body: Body) -> Clip:
    """A body stands, walks four steps up to a door, knocks and lowers its hand."""
    style, knock = for_body(ACTED[emotion], body), KNOCKS[emotion]
    plan, hits = _plan(style, knock, body)
    channels = walking_channels(plan, style)
    _stand(channels, plan, style, knock)
    _knock(channels, plan, knock, hits)
    feet = (foot_path(plan, style, body, LEFT), foot_path(plan, style, body, RIGHT))
    return build_clip(plan, style, body, channels, feet)


def _plan(style: Style, knock: Knock, body: Body) -> tuple[Plan, Array]:
    """Steps, and the times (n,) s at which the knuckles meet the door."""
    stride_time = 120.0 / style.cadence
    swing = (1.0 - style.stance) * stride_time
    contact = 0.45 + 0.3 * stride_time + swing
    length = style.stride * body.leg_length / 2.0
    steps = []
    for count, place in enumerate(np.cumsum(_WAYS) * length):
        side = RIGHT if count % 2 == 0 else LEFT
        slow = 1.12 if count == len(_WAYS) - 1 else 1.0  # the last step is no longer in a hurry
        steps.append(Step(side, contact - swing, contact + (slow - 1.0) * swing, float(place)))
        contact += stride_time / 2.0
    gaps = knock.period * (1.0 + knock.uneven * np.arange(knock.count - 1))
    first = steps[-1].contact + knock.pause + knock.raise_time
    hits = first + np.concatenate([[0.0], np.cumsum(gaps)])
    end = hits[-1] + 0.15 + knock.drop_time + 0.4
    times = np.arange(round(end * FRAME_RATE) + 1) / FRAME_RATE
    return Plan(times, tuple(steps), (0.0, -0.05 * length), stride_time), hits


def _stand(channels: Channels, plan: Plan, style: Style, knock: Knock) -> None:
    """What a standing body does beside standing: balance its lean, breathe, tremble."""
    still = 1.0 - plan.walking()
    bow = style.lean + style.chest_pitch
    channels.chest[:, 1] -= still * 0.25 * bow
    channels.forward -= still * 0.0032 * max(bow, 0.0)
    breath = np.sin(2.0 * np.pi * plan.times / knock.breath)
    channels.chest[:, 1] -= 0.5 * breath * (2.0 - knock.breath / 5.0)
    channels.sideways += still * 0.004 * np.sin(2.0 * np.pi * plan.times / 3.1)
    # Two frequencies that do not fit: a tremble is not a vibration.
    tremble = np.sin(2.0 * np.pi * 7.1 * plan.times) + np.sin(2.0 * np.pi * 8.9 * plan.times + 1.0)
    for arm in channels.arms:
        arm.collar_up = arm.collar_up + 0.8 * breath
        arm.elbow = arm.elbow + knock.tremble * tremble
        arm.wrist = arm.wrist + 0.8 * knock.tremble * tremble


def _knock(channels: Channels, plan: Plan, knock: Knock, hits: Array) -> None:
    """Lay the knock over the right arm, the trunk and the hips."""
    t = plan.times
    rise = (t - hits[0] + knock.raise_time) / (knock.raise_time * 0.92)
    fall = (t - hits[-1] - 0.15) / knock.drop_time
    near = _raised(rise, fall, knock.falter, 0.0)
    # The hand comes up along the body and goes back along it, as the door would have it: the
    # elbow bends before the arm lifts, and stretches after it has sunk.
    bent = _raised(rise, fall, knock.falter, 0.3)
    strike = _strikes(t, hits, knock.period)
    force = knock.swing / 22.0 * strike
    # The wrist leads: on the way up and down the hand hangs behind the forearm.
    trailing = 22.0 * np.sin(np.pi * gait.smooth_step(rise * 1.1))
    trailing -= 16.0 * np.sin(np.pi * gait.smooth_step(fall))
    poses: dict[str, Array | float] = {
        "swing": knock.height + 0.22 * knock.swing * strike,
        "out": knock.out,
        "turn": 14.0,
        "elbow": knock.elbow - knock.swing * strike,
        "forearm_turn": -62.0,  # the palm looks back: knuckles knock
        "wrist": 30.0 - 26.0 * strike,
        "collar_up": 4.0,
        "collar_forward": 8.0 + 3.0 * force,
    }
    arm = channels.arms[RIGHT]
    # The palm turns last: a forearm on its way up or down carries no tray.
    shares = {"elbow": bent, "forearm_turn": near**3}
    for name, value in poses.items():
        share = shares.get(name, near)
        setattr(arm, name, (1.0 - share) * getattr(arm, name) + share * value)
    arm.wrist = arm.wrist + trailing
    channels.chest += np.stack(
        [near * (-5.0 - 1.5 * force), near * (knock.lean + 1.0 * force), 1.5 * near], axis=-1
    )
    channels.pelvis += np.stack([-2.0 * near, 0.3 * near * knock.lean, 0.0 * near], axis=-1)
    channels.head[:, 1] += near * (knock.head + 0.5 * force)
    channels.forward += 0.015 * near
    channels.sideways += -0.012 * near


def _raised(rise: Array, fall: Array, falter: float, lead: float) -> Array:
    """(T,) from 0, hanging, to 1, at the door; ``lead`` is up earlier and down later."""
    up = gait.smooth_step((rise - 0.3 + lead) / 0.7)
    up = up - falter * np.exp(-(((rise - 0.62 + 0.5 * lead) / 0.16) ** 2))
    return up * (1.0 - gait.smooth_step((fall - lead) / 0.7))


def _strikes(times: Array, hits: Array, period: float) -> Array:
    """(T,) 1 at each knock, 0 between: quick towards the door, slower back."""
    knots = [(float(times[0]) - 1.0, 0.0), (float(hits[0]) - period, 0.0)]
    for hit in hits:
        knots += [(hit - 0.42 * period, -0.35), (hit, 1.0), (hit + 0.25 * period, 0.35)]
    knots += [(float(hits[-1]) + 0.5, 0.0), (float(times[-1]) + 1.0, 0.0)]
    at, values = np.array(knots).T
    return np.asarray(PchipInterpolator(at, values)(times), dtype=float)
