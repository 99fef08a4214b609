"""Acceleration at contacts only: limbs linger and then burst into the contact.

Förger proposes it for anger (ch. 6): where hands and feet meet something, the force shows.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.signal import argrelmin

from motion.clip import Clip
from motion.editing.cycles import middle_cycle, three_cycles
from motion.editing.foot_plants import find_feet
from motion.editing.foot_repair import repair_feet
from motion.editing.limbs import Limb, find_limbs
from motion.editing.timing import limb_speed, resample
from motion.kinematics import WorldPose, forward_kinematics

Array = NDArray[np.float64]

_REACH = 0.45  # s before a contact that take part
_BURST, _OVER = 0.12, 0.25  # s before it: from the one on fast, before the other slow
_CONTRAST = np.log(1.5)  # how much longer the slow and how much shorter the fast frames last
_SUDDEN = 0.07  # s in which a hand comes to rest if it hits something
_FALL = 0.6  # of the hand's high speed: what it loses then; a swinging arm takes longer to turn
_APART = 0.25  # s between two contacts of a limb
_LEAST = 0.3  # m/s: a hand that is never faster hits nothing


def accelerate_contacts(clip: Clip, amount: float = 1.0) -> Clip:
    """The clip with each limb slow before its contacts and fast into them.

    Contacts are foot strikes and sudden stops of a hand. They stay when they are, and so do length,
    first and last frame; the feet are repaired.

    Args:
        clip: any clip; a cyclic one stays cyclic, and its first frame need not stay.
        amount: 0 changes nothing; 1 makes the way to a contact last 1.5 times as long, then 1.5
            times as short, less what it takes to arrive on time.

    Raises:
        MotionError: if a leg's roles are missing.
    """
    if amount == 0.0 or clip.frames < 4:
        return clip
    if clip.cyclic:
        return middle_cycle(accelerate_contacts(three_cycles(clip), amount))
    pose = forward_kinematics(clip)
    rotations = clip.rotations.copy()
    for limb, approaches in _approaches(clip, pose):
        warp = _warp(clip, approaches, amount)
        joints = list(limb.joints)
        rotations[:, joints] = resample(clip.rotations[:, joints], warp)
    return repair_feet(clip, replace(clip, rotations=rotations))


def _approaches(clip: Clip, pose: WorldPose) -> Iterator[tuple[Limb, list[slice]]]:
    """Limbs that meet something, with the frames that lead to each contact."""
    limbs = find_limbs(clip.skeleton)
    for foot in find_feet(clip, pose):
        if f"{foot.side}_leg" in limbs:
            plants = list(foot.plants())
            ends = [0, *(plant.stop - 1 for plant in plants)]
            yield (
                limbs[f"{foot.side}_leg"],
                [slice(end, plant.start) for end, plant in zip(ends, plants, strict=False)],
            )
    for name in ("left_arm", "right_arm"):
        if name in limbs:
            stops = sudden_stops(limb_speed(clip, pose, limbs[name]), clip.frame_time)
            yield (
                limbs[name],
                [slice(a, b) for a, b in zip([0, *stops], stops, strict=False)],
            )


def sudden_stops(speed: Array, frame_time: float) -> list[int]:
    """Frames at which something that moves at a speed (T,) m/s has come to rest all at once."""
    high = float(np.quantile(speed, 0.95))
    if high < _LEAST:
        return []
    before = max(1, round(_SUDDEN / frame_time))
    apart = max(1, round(_APART / frame_time))
    stops: list[int] = []
    for moment in argrelmin(speed)[0].tolist():
        falls = speed[max(0, moment - before) : moment + 1].max() - speed[moment] > _FALL * high
        if falls and (not stops or moment - stops[-1] >= apart):
            stops.append(moment)
    return stops


def _warp(clip: Clip, approaches: list[slice], amount: float) -> Array:
    """Which frame (T,), fractional, is shown when."""
    lasting = np.ones(clip.frames - 1)
    reach = round(_REACH / clip.frame_time)
    for approach in approaches:
        part = slice(max(approach.start, approach.stop - reach), approach.stop)
        count = part.stop - part.start
        if count < 3:
            continue
        # A short approach, such as a step's swing, has all of it in less time.
        before = (np.arange(count)[::-1] + 0.5) / count * _REACH
        shape = np.interp(before, [_BURST, _OVER, 0.8 * _REACH, _REACH], [-1.0, 1.0, 1.0, 0.0])
        new = np.exp(amount * _CONTRAST * shape)
        lasting[part] = new * (count / new.sum())
    shown_at = np.concatenate([[0.0], np.cumsum(lasting)])
    shown_at[-1] = clip.frames - 1
    return np.interp(np.arange(clip.frames), shown_at, np.arange(clip.frames))
