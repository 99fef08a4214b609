"""Feet that stand again after an edit (Förger, ch. 3.5, finished by two-bone inverse kinematics).

An edit of the joints makes the feet slide. First the hips are moved against the slip of the
standing feet; with both feet in the air they keep the horizontal velocity they had. What is left,
because in double support two feet disagree, is taken out by the legs.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator
from scipy.ndimage import gaussian_filter1d, maximum_filter1d

from motion.clip import Clip
from motion.editing.cycles import middle_cycle, three_cycles
from motion.editing.foot_plants import Foot, find_feet, leg_length
from motion.ik import solve_two_bones
from motion.kinematics import WorldPose, forward_kinematics
from motion.rotations import between, conjugate, multiply, rotate, slerp

Array = NDArray[np.float64]
Feet = tuple[Foot, Foot]

_LEVEL = np.array([1.0, 0.0, 1.0])
_BLEND = 0.08  # s in which a foot goes over into its plant and out of it
_SMOOTH = 0.05  # s, standard deviation of the smoothing of the hips' repaired path
_SINK = 0.005  # m
_STRETCH = 0.985  # of the leg's length: a standing leg reaches no farther, or its knee would snap
_STRAIGHTEST = 0.998


def repair_feet(
    original: Clip, edited: Clip, *, feet: Feet | None = None, as_straight: bool = False
) -> Clip:
    """The edited clip with hips and legs such that feet stand where and when they stood before.

    Args:
        original: the clip before the edit: it tells when the feet stand.
        edited: the same skeleton and frames with other rotations; a cycle stays a cycle.
        feet: the original's, where it is known better than by looking when they stand.
        as_straight: standing legs may be as straight as they were before, however little more
            would make their knees snap; for edits that hardly move the feet.
    """
    if original.cyclic and original.frames > 1:
        three = three_cycles(original), three_cycles(edited)
        thrice = feet and (_three_times(feet[0]), _three_times(feet[1]))
        return middle_cycle(repair_feet(*three, feet=thrice, as_straight=as_straight))
    before = forward_kinematics(original)
    feet = feet or find_feet(original, before)
    if not any(foot.stands.any() for foot in feet):
        return edited
    moved = replace(edited, root_positions=_hips_path(original, edited, feet, before))
    pose = forward_kinematics(moved)
    moved = _with_standing_toes(moved, original, feet)
    goals = {foot: _foot_goal(foot, moved, pose, before) for foot in feet}
    lowered = _within_reach(moved, pose, goals, before if as_straight else None)
    return legs_onto(lowered, goals, before)


def _three_times(foot: Foot) -> Foot:
    """A cycle's foot over three cycles."""
    once = foot.planted[:, :-1]
    return replace(foot, planted=np.hstack([once, once, foot.planted]))


def _hips_path(original: Clip, edited: Clip, feet: Feet, before: WorldPose) -> Array:
    """(T, 3) path of the root that moves against the slip of the standing feet.

    Level it is moved by what the feet slip more than in the original, so that a walk whose ankles
    roll forward over the toes goes as far as before.
    """
    step = original.frame_time
    still = forward_kinematics(replace(edited, root_positions=original.root_positions))
    ankles = [foot.ankle for foot in feet]
    strayed = still.positions[:, ankles] - before.positions[:, ankles]
    weights = np.stack([_soft(foot.stands, step) for foot in feet], axis=-1)
    total = weights.sum(axis=-1, keepdims=True)
    supported = total[:, 0] > 0.05
    weights = (weights / np.maximum(total, 1e-9))[..., None]
    velocity = -np.sum(weights * np.gradient(strayed, step, axis=0), axis=1)
    change = _integral(_smooth(_bridge(velocity, supported), step), step)
    lift = -np.sum(weights * strayed, axis=1)[:, 1:2]
    change[:, 1:2] = _smooth(_bridge(lift, supported), step)
    return original.root_positions + change


def _with_standing_toes(clip: Clip, original: Clip, feet: Feet) -> Clip:
    """The clip with toes bent as in the original while the foot stands on them."""
    rotations = clip.rotations.copy()
    for foot in feet:
        share = _standing_share(foot, clip.frame_time)
        for joint in {point.joint for point in foot.points} - {foot.ankle}:
            rotations[:, joint] = slerp(rotations[:, joint], original.rotations[:, joint], share)
    return replace(clip, rotations=rotations)


def _foot_goal(foot: Foot, clip: Clip, pose: WorldPose, before: WorldPose) -> tuple[Array, Array]:
    """Where the ankle shall be (T, 3) and how the foot shall be turned (T, 4).

    In a plant the foot moves as in the original, without its slip, shifted level to where the edit
    brings it; between plants the shift goes over smoothly, and the sole is kept above the floor.
    """
    ankle = pose.positions[:, foot.ankle]
    locked = _without_slip(foot, before)
    frames, gaps = [], []
    for plant in foot.plants():
        shift = np.median(ankle[plant] - locked[plant], axis=0) * _LEVEL
        frames.append(np.arange(plant.start, plant.stop))
        gaps.append(locked[plant] + shift - ankle[plant])
    if not frames:
        return ankle, pose.rotations[:, foot.ankle]
    goal = ankle + carried_on(np.concatenate(frames), np.concatenate(gaps), clip.frames)
    share = _standing_share(foot, clip.frame_time)
    turn = slerp(pose.rotations[:, foot.ankle], before.rotations[:, foot.ankle], share)
    # A recording may stand a little below the floor; only a standing foot keeps that.
    allowed = np.where(foot.stands, _SINK, 0.0)
    sunk = np.maximum(-_sole_height(foot, clip, goal, turn) - allowed, 0.0)
    goal[:, 1] += _soft_maximum(sunk, clip.frame_time)
    return goal, turn


def _within_reach(
    clip: Clip, pose: WorldPose, goals: dict[Foot, tuple[Array, Array]], before: WorldPose | None
) -> Clip:
    """The clip with its hips lowered where a standing leg would not reach.

    Legs that were straighter in a pose ``before`` may be so again; then swinging ones are looked
    after as well, which would snap when they come to their end.
    """
    needed = np.zeros(clip.frames)
    for foot, (ankle, _) in goals.items():
        hip = pose.positions[:, foot.thigh]
        level = np.linalg.norm((hip - ankle)[:, [0, 2]], axis=1)
        length = leg_length(clip, foot.side)
        reach: Array | float = _STRETCH * length
        if before is not None:
            was = before.positions[:, foot.thigh] - before.positions[:, foot.ankle]
            reach = np.clip(np.linalg.norm(was, axis=1), reach, _STRAIGHTEST * length)
        highest = ankle[:, 1] + np.sqrt(np.maximum(reach**2 - level**2, 0.0))
        asked = foot.stands if before is None else True
        needed = np.maximum(needed, np.where(asked, hip[:, 1] - highest, 0.0))
    root = clip.root_positions.copy()
    root[:, 1] -= _soft_maximum(needed, clip.frame_time)
    return replace(clip, root_positions=root)


def legs_onto(clip: Clip, goals: dict[Foot, tuple[Array, Array]], before: WorldPose) -> Clip:
    """The clip with each foot's ankle where it shall be (T, 3) and turned as it shall be (T, 4).

    Knees bend as they do in a pose ``before``; legs reach as far as they are long.
    """
    pose = forward_kinematics(clip)
    rotations = clip.rotations.copy()
    for foot, (ankle, turn) in goals.items():
        bones = pose.positions[:, [foot.thigh, foot.shin, foot.ankle]]
        hinge = rotate(pose.rotations[:, foot.thigh], _knee_axis(foot, before))
        lengths = np.linalg.norm(clip.skeleton.offsets[[foot.shin, foot.ankle]], axis=1)
        solved = solve_two_bones(
            bones[:, 0], ankle, np.cross(ankle - bones[:, 0], hinge), (lengths[0], lengths[1])
        )
        first = between(_unit(bones[:, 1] - bones[:, 0]), _unit(solved.middle - bones[:, 0]))
        shin_now = rotate(first, bones[:, 2] - bones[:, 1])
        second = between(_unit(shin_now), _unit(solved.end - solved.middle))
        thigh = multiply(first, pose.rotations[:, foot.thigh])
        shin = multiply(second, multiply(first, pose.rotations[:, foot.shin]))
        above = pose.rotations[:, clip.skeleton.parents[foot.thigh]]
        rotations[:, foot.thigh] = multiply(conjugate(above), thigh)
        rotations[:, foot.shin] = multiply(conjugate(thigh), shin)
        rotations[:, foot.ankle] = multiply(conjugate(shin), turn)
    return replace(clip, rotations=rotations)


def _knee_axis(foot: Foot, pose: WorldPose) -> Array:
    """(3,) axis in the thigh's frame about which the knee bends, from all frames of a clip.

    The knee's own bend cannot tell: an edit may straighten it or push it past straight.
    """
    thigh = pose.positions[:, foot.shin] - pose.positions[:, foot.thigh]
    shin = pose.positions[:, foot.ankle] - pose.positions[:, foot.shin]
    local = rotate(conjugate(pose.rotations[:, foot.thigh]), np.cross(thigh, shin))
    return _unit(local.sum(axis=0))


def _without_slip(foot: Foot, before: WorldPose) -> Array:
    """The ankle's path (T, 3) in the original less the slip of the point that it stands on."""
    slip = np.zeros((len(before.positions), 3))
    for point, planted in zip(foot.points, foot.planted, strict=True):
        way = np.diff(point.positions(before), axis=0, prepend=np.nan) * _LEVEL
        lasting = planted & np.concatenate([[False], planted[:-1]])
        slip[lasting] = way[lasting]
    return before.positions[:, foot.ankle] - np.cumsum(slip, axis=0)


def _sole_height(foot: Foot, clip: Clip, ankle: Array, turn: Array) -> Array:
    """Height (T,) of the lowest contact point of a foot that is placed and turned like this."""
    heights = []
    for point in foot.points:
        place, rotation = ankle, turn
        if point.joint != foot.ankle:
            place = ankle + rotate(turn, clip.skeleton.offsets[point.joint])
            rotation = multiply(turn, clip.rotations[:, point.joint])
        heights.append((place + rotate(rotation, point.offset))[:, 1])
    return np.min(heights, axis=0)


def carried_on(frames: NDArray[np.intp], values: Array, count: int) -> Array:
    """Values (count, 3), known at some frames, monotone between them and held beyond the ends."""
    if len(frames) == 1:
        return np.repeat(values, count, axis=0)
    inside = np.clip(np.arange(count), frames[0], frames[-1])
    return PchipInterpolator(frames, values, axis=0)(inside)


def _bridge(values: Array, known: NDArray[np.bool_]) -> Array:
    """Values (T, C) with unknown frames filled in a straight line from the known around them."""
    frames = np.arange(len(values))
    return np.stack([np.interp(frames, frames[known], row[known]) for row in values.T], axis=-1)


def _integral(velocity: Array, step: float) -> Array:
    middle = (velocity[1:] + velocity[:-1]) / 2.0 * step
    return np.concatenate([np.zeros((1, 3)), np.cumsum(middle, axis=0)])


def _smooth(values: Array, step: float) -> Array:
    return gaussian_filter1d(values, _SMOOTH / step, axis=0, mode="nearest")


def _soft(flags: NDArray[np.bool_], step: float) -> Array:
    """Flags (T,) as weights that go over within the blend's time."""
    return gaussian_filter1d(flags.astype(float), 0.4 * _BLEND / step, mode="nearest")


def _standing_share(foot: Foot, step: float) -> Array:
    """1 (T,) while a foot stands, going over to 0 before and after."""
    width = 2 * max(1, round(_BLEND / step)) + 1
    widened = np.asarray(maximum_filter1d(foot.stands, width))
    return np.maximum(_soft(widened, step), foot.stands)


def _soft_maximum(values: Array, step: float) -> Array:
    """A smooth curve (T,) that is nowhere below the values (T,) ≥ 0."""
    width = max(1, round(_BLEND / step))
    wide = maximum_filter1d(values, 4 * width + 1)
    return gaussian_filter1d(wide, width, mode="nearest", truncate=2.0)


def _unit(vectors: Array) -> Array:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-12)
