"""Measures of a gait that people have words for: how far the arms are spread, how fast it goes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motion.centre_of_mass import SegmentEnds
from motion.clip import Clip
from motion.errors import MotionError
from motion.features.steps import Step, find_steps
from motion.features.view import View

Array = NDArray[np.float64]


@dataclass(frozen=True)
class GaitMeasures:
    """What is seen of a gait at first sight.

    Attributes:
        arm_span: m between the wrists, mean over time.
        widest_arm_span: m between the wrists at their widest.
        step_length: m along the heading, mean over the steps; 0 without a step.
        cadence: steps a minute; 0 where fewer than two steps tell it.
        hand_speed: m/s of the wrists against the hips, mean over time and both sides.
    """

    arm_span: float
    widest_arm_span: float
    step_length: float
    cadence: float
    hand_speed: float


def gait_measures(clip: Clip) -> GaitMeasures:
    """The measures of a clip.

    Raises:
        MotionError: if the clip has no frame, or a body role of arms or legs is missing.
    """
    if clip.frames == 0:
        raise MotionError("A clip without frames has no gait: import it again.")
    view = View.of(clip)
    left, right, hips = _wrists_and_hips(view)
    span = np.linalg.norm(left - right, axis=1)[view.part]
    steps = find_steps(view)
    return GaitMeasures(
        arm_span=float(view.mean(span)),
        widest_arm_span=float(span.max()),
        step_length=float(np.mean([step.forward for step in steps])) if steps else 0.0,
        cadence=_cadence(clip, steps),
        hand_speed=float(np.mean([_speed(view, wrist - hips) for wrist in (left, right)])),
    )


def _wrists_and_hips(view: View) -> tuple[Array, Array, Array]:
    """Places (T', 3) of both wrists and of the middle between the hip joints."""
    ends = SegmentEnds(view.clip.skeleton, view.pose)
    (left, _), (right, _) = ends.of("hand")
    _, hips = ends.of("trunk")[0]
    return left, right, hips


def _speed(view: View, places: Array) -> float:
    return float(view.mean(np.linalg.norm(view.velocity(places)[view.part], axis=1)))


def _cadence(clip: Clip, steps: list[Step]) -> float:
    """Steps a minute: all of a cycle's in its time, else those between the first and the last."""
    if clip.cyclic:
        return 60.0 * len(steps) / clip.duration if steps else 0.0
    if len(steps) < 2:
        return 0.0
    return 60.0 * (len(steps) - 1) / (steps[-1].time - steps[0].time)
