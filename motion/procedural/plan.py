"""Where and when the feet are set down, and what follows from it for the whole body."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator
from scipy.ndimage import gaussian_filter1d

from motion.procedural.bodies import Body
from motion.procedural.gait import TOE_OFF
from motion.procedural.style import Style

Array = NDArray[np.float64]

# 60 frames a second: displays of 60 and 120 Hz show each frame for a whole number of refreshes,
# and the quickest thing a body does here, a knock of about 70 ms, still gets four frames.
FRAME_RATE = 60

LEFT, RIGHT = 0, 1
_FLAT = 0.20  # phase at which the published foot lies flat


@dataclass(frozen=True)
class Step:
    """One foot's way to its next place.

    Attributes:
        side: LEFT or RIGHT.
        lift: s, the toes leave the ground.
        contact: s, the heel touches the ground.
        place: m forward, where the ankle stands afterwards.
    """

    side: int
    lift: float
    contact: float
    place: float


@dataclass(frozen=True)
class Plan:
    """A walk along +z as steps in time.

    Attributes:
        times: (T,) s, at which the pose is wanted.
        steps: in the order of their contacts.
        start: m forward, where the left and the right foot stand before the first step.
        stride_time: s, of a full cycle; sets the pace of what happens around each step.
    """

    times: Array
    steps: tuple[Step, ...]
    start: tuple[float, float]
    stride_time: float

    def of_side(self, side: int) -> list[Step]:
        """The steps of one foot."""
        return [step for step in self.steps if step.side == side]

    def smooth(self, values: Array, cycles: float) -> Array:
        """Values (T, ...) low-passed over time by a Gaussian of ``cycles`` of a stride."""
        sigma = cycles * self.stride_time * FRAME_RATE
        filtered: Array = gaussian_filter1d(values, sigma, axis=0, mode="nearest")
        return filtered

    def follow(self, knots: Sequence[tuple[float, float]]) -> Array:
        """Values (T,) on straight lines through (time, value) knots, constant outside."""
        times, values = zip(*sorted(knots), strict=True)
        return np.interp(self.times, times, values)

    def foot_phase(self, side: int) -> Array:
        """(T,) phase of one foot: a whole number at each contact, + 0.61 at each toe-off."""
        steps = self.of_side(side)
        knots = [(steps[0].lift - (TOE_OFF - _FLAT) * self.stride_time, _FLAT - 1.0)]
        for count, step in enumerate(steps):
            knots += [(step.lift, count - 1 + TOE_OFF), (step.contact, float(count))]
        knots.append((steps[-1].contact + _FLAT * self.stride_time, len(steps) - 1 + _FLAT))
        times, phases = np.array(knots).T
        inside = np.clip(self.times, times[0], times[-1])
        return np.asarray(PchipInterpolator(times, phases)(inside), dtype=float)

    def phase(self) -> Array:
        """(T,) phase of the whole body: whole at left contacts, half between at right ones."""
        value = 0.0 if self.steps[0].side == LEFT else 0.5
        first, last = self.steps[0], self.steps[-1]
        knots = [(first.lift - 0.2 * self.stride_time, value - 0.45)]
        for step in self.steps:
            knots.append((step.contact, value))
            value += 0.5
        knots.append((last.contact + 0.25 * self.stride_time, value - 0.3))
        return self.smooth(self.follow(knots), 0.04)

    def walking(self) -> Array:
        """(T,) from 0 in standing to 1 in full gait."""
        first, last = self.steps[0], self.steps[-1]
        share = self.follow(
            [
                (first.lift - 0.25 * self.stride_time, 0.0),
                (first.contact, 1.0),
                (last.lift, 1.0),
                (last.contact + 0.3 * self.stride_time, 0.0),
            ]
        )
        return self.smooth(share, 0.08)

    def load(self) -> Array:
        """(T,) share of the weight on the left foot, shifted during double support."""
        knots: list[tuple[float, float]] = []
        first, last = self.steps[0], self.steps[-1]
        knots.append((first.lift - 0.45 * self.stride_time, 0.5))
        for step in self.steps:
            on_left = 1.0 if step.side == RIGHT else 0.0
            knots += [(step.lift, on_left), (step.contact, on_left)]
        knots.append((last.contact + 0.4 * self.stride_time, 0.5))
        return self.follow(knots)

    def carrier(self) -> Array:
        """(T,) share of the left leg in setting the hips' height: the new leg takes over at once.

        The weight itself shifts more slowly, but the leading leg is the shorter reach.
        """
        knots = [(self.steps[0].lift - 0.3 * self.stride_time, 0.5)]
        share = 0.5
        for step in self.steps:
            to = 1.0 if step.side == LEFT else 0.0
            if share == 0.5:
                share = 1.0 - to
                knots.append((step.lift, share))
            knots.append((step.contact - 0.045 * self.stride_time, share))
            knots.append((step.contact + 0.02 * self.stride_time, to))
            share = to
        knots.append((self.steps[-1].contact + 0.4 * self.stride_time, 0.5))
        return self.follow(knots)

    def middle(self) -> Array:
        """(T,) m forward, midway between the feet, moving evenly from contact to contact."""
        feet = list(self.start)
        first, last = self.steps[0], self.steps[-1]
        knots = [(first.lift - 0.15 * self.stride_time, sum(feet) / 2)]
        for step in self.steps:
            feet[step.side] = step.place
            knots.append((step.contact, sum(feet) / 2))
        late = last.contact + 0.1 * self.stride_time
        knots[-1] = (late, knots[-1][1])
        return self.smooth(self.follow(knots), 0.1)


def cycle_frames(style: Style) -> int:
    """Number of frame intervals in one stride: a whole one, so that the loop closes exactly."""
    return round(120.0 / style.cadence * FRAME_RATE)


def plan_cycle(style: Style, body: Body) -> Plan:
    """An endless walk, sampled from one stride before to one stride after the one wanted.

    The middle stride then sees the same steps on both sides, which makes it truly periodic.
    """
    frames = cycle_frames(style)
    duration = frames / FRAME_RATE
    stride = style.stride * body.leg_length
    late = 0.5 + 0.5 * style.asymmetry
    steps = []
    for count in range(-4, 6):
        for side, share in ((LEFT, 0.0), (RIGHT, late)):
            contact = (count + share) * duration
            lift = contact - (1.0 - style.stance) * duration
            place = (count + (share if side == LEFT else 0.5) + 0.25) * stride
            steps.append(Step(side, lift, contact, place))
    times = np.arange(-frames, 2 * frames + 1) / FRAME_RATE
    start = (steps[0].place - stride, steps[1].place - stride)
    linger = style.hesitation * duration / (4.0 * np.pi)
    # Time runs slowest shortly before each contact: the foot hangs back before it commits.
    times = times + 0.75 * linger * np.sin(4.0 * np.pi * (times / duration - 0.18))
    return Plan(times, tuple(steps), start, duration)
