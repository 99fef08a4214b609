"""The whole report, and an edit lowered until it is clean."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from motion.body import REQUIRED
from motion.clip import Clip
from motion.errors import MotionError
from motion.quality.feet import imbalance, slips, sunk
from motion.quality.jerk import jerks
from motion.quality.joints import bends
from motion.quality.limbs import intersections
from motion.quality.pair import matched
from motion.quality.report import QualityReport, in_words

Made = TypeVar("Made")

_MEASURES = (slips, sunk, bends, intersections, imbalance, jerks)


def check(original: Clip, edited: Clip) -> QualityReport:
    """What the edited clip does that it should not, where the original does not do it as well.

    Args:
        original: tells when feet stand and what the recording itself does beyond the limits.
        edited: the same skeleton. If it lasts longer or has another frame rate, it is compared
            with the original stretched evenly to its frames.

    Raises:
        MotionError: if the two clips cannot be compared, or a limb's body roles are missing.
    """
    missing = [role for role in REQUIRED if role not in original.skeleton.roles]
    if missing:
        raise MotionError(f"No joint is the {in_words(missing[0])}: set that body role first.")
    pair = matched(original, edited)
    findings = [
        finding
        for measures in _MEASURES
        for measure in measures(pair)
        for finding in measure.findings(edited.frame_time)
    ]
    return QualityReport(tuple(sorted(findings, key=lambda f: (f.start, f.kind, f.part))))


def ease_off(
    original: Clip, edit: Callable[[float], Clip], *, steps: int = 6
) -> tuple[float, Clip, QualityReport]:
    """The edit at the greatest amount that is clean, as near as halving finds it.

    Args:
        original: the clip before the edit.
        edit: amount in [0, 1] to the edited clip; 0 changes nothing, 1 is the edit as wanted.
        steps: halvings; six find the amount to 1/64.

    Returns:
        The amount, the clip and its report, which is not clean only if even amount 0 is not.
    """

    def attempt(amount: float) -> tuple[Clip, QualityReport]:
        clip = edit(amount)
        return clip, check(original, clip)

    return greatest_clean(attempt, steps=steps)


def greatest_clean(
    attempt: Callable[[float], tuple[Made, QualityReport]], *, steps: int = 6
) -> tuple[float, Made, QualityReport]:
    """The greatest amount in [0, 1] whose report is clean, as near as halving finds it.

    Args:
        attempt: amount to what it makes and its report.
        steps: halvings; six find the amount to 1/64.

    Returns:
        The amount, what it makes and its report, which is not clean only if even amount 0 is not.
    """
    best = (1.0, *attempt(1.0))
    if best[2].clean:
        return best
    best = (0.0, *attempt(0.0))
    if not best[2].clean:
        return best
    high = 1.0
    for _ in range(steps):
        middle = (best[0] + high) / 2.0
        tried = (middle, *attempt(middle))
        if tried[2].clean:
            best = tried
        else:
            high = middle
    return best
