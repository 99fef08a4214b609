"""A motion put onto another body's skeleton, by body roles.

Every segment is turned in the world as it was, seen from how either body stands upright, so that
limbs point where they pointed whatever the joints' axes are. The hips' way is scaled by the legs'
length; the feet are set down on the floor at as many leg lengths from the hips as before, and made
to stand.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

from motion.body import REQUIRED
from motion.clip import Clip
from motion.editing.cycles import middle_cycle, three_cycles
from motion.editing.foot_plants import SIDES, Foot, find_feet, leg_length, runs
from motion.editing.foot_repair import carried_on, legs_onto, repair_feet
from motion.errors import MotionError
from motion.kinematics import WorldPose, forward_kinematics, pose_to_world
from motion.rotations import conjugate, make_continuous, multiply
from motion.standing import Standing

Array = NDArray[np.float64]
Feet = tuple[Foot, Foot]

_LEVEL = np.array([1.0, 0.0, 1.0])
_RESTING = 0.25  # quantile of a sole's height in a plant: it rolls up before it leaves
_LEANING = 4  # plants that tell whether a floor leans
_LIMBS = {"upper_arm": "forearm", "forearm": "hand", "thigh": "shin", "shin": "foot"}


@dataclass(frozen=True)
class RetargetError:
    """How well a motion fits its new body.

    Attributes:
        mean_direction, greatest_direction: rad, between the directions of the limbs' segments
            before and after, over all frames.
        slip: m, the farthest that a point of a sole slides while it stands.
        sole_height: m, that a sole is above or below the floor while it stands, in the mean.
        unmapped: body roles that only one of the two skeletons has; they rest as in standing.
    """

    mean_direction: float
    greatest_direction: float
    slip: float
    sole_height: float
    unmapped: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Retargeted:
    """A motion on its new skeleton, and how well it fits."""

    clip: Clip
    error: RetargetError


def retarget(clip: Clip, onto: Clip) -> Retargeted:
    """The motion of one clip on the skeleton of another; frames and cycle stay.

    Joints of the new skeleton without a role in both rest as in standing.

    Args:
        clip: the motion.
        onto: has the skeleton, and shows by its motion how that stands.

    Raises:
        MotionError: if a role that a human body needs is missing in either skeleton.
    """
    for body, name in ((clip, "motion's"), (onto, "new")):
        missing = [role for role in REQUIRED if role not in body.skeleton.roles]
        if missing:
            part = missing[0].replace("_", " ")
            raise MotionError(
                f"No joint is the {part} of the {name} skeleton: set that body role first."
            )
    if clip.skeleton.content_hash == onto.skeleton.content_hash:
        moved = clip
    elif clip.cyclic and clip.frames > 1:
        moved = middle_cycle(_moved(three_cycles(clip), Standing.of(clip), onto))
    else:
        moved = _moved(clip, Standing.of(clip), onto)
    return Retargeted(moved, _error(clip, moved, onto))


def _moved(clip: Clip, standing: Standing, onto: Clip) -> Clip:
    feet, new_feet = find_feet(clip), find_feet(onto)
    level = _on_level_floor(clip, feet)
    pose = forward_kinematics(level)
    rotations = make_continuous(_turned(clip, pose, standing, onto))
    scale = _leg(onto) / _leg(clip)
    still = pose_to_world(onto.skeleton, np.zeros((clip.frames, 3)), rotations)
    root = _between_thighs(clip, pose) * scale - _between_thighs(onto, still)
    rough = replace(clip, skeleton=onto.skeleton, root_positions=root, rotations=rotations)
    lifts = _lifts(pose, feet, forward_kinematics(rough), new_feet, scale)
    return _set_down(rough, feet, new_feet, lifts)


def _on_level_floor(clip: Clip, feet: Feet) -> Clip:
    """The clip with its soles standing at height 0, where a recording's floor leans or is off."""
    pose = forward_kinematics(clip)
    found = [
        (plant.start, plant.stop, np.quantile(_lowest(pose, foot)[plant], _RESTING))
        for foot in feet
        for plant in foot.plants()
    ]
    if not found:
        return clip
    starts, stops, heights = np.array(found).T
    degree = 1 if len(found) >= _LEANING else 0
    floor = Polynomial.fit((starts + stops - 1.0) / 2.0, heights, degree, w=stops - starts)
    root = clip.root_positions.copy()
    root[:, 1] -= floor(np.arange(clip.frames))
    return replace(clip, root_positions=root)


def _lifts(
    pose: WorldPose, feet: Feet, new_pose: WorldPose, new_feet: Feet, scale: float
) -> list[Array]:
    """Of each foot how far (T,) its sole is too low on the new body."""
    return [
        scale * _lowest(pose, old) - _lowest(new_pose, new)
        for old, new in zip(feet, new_feet, strict=True)
    ]


def _set_down(rough: Clip, feet: Feet, new_feet: Feet, lifts: list[Array]) -> Clip:
    """The clip with its standing soles as high as they shall be, and not sliding.

    The hips are lifted by what both need, the legs do the rest.
    """
    needed = np.concatenate([lift[foot.stands] for lift, foot in zip(lifts, feet, strict=True)])
    if len(needed) == 0:
        return rough
    root = rough.root_positions + np.array([0.0, float(np.median(needed)), 0.0])
    lifted = replace(rough, root_positions=root)
    pose = forward_kinematics(lifted)
    goals = {}
    for old, new, lift in zip(feet, new_feet, lifts, strict=True):
        goal = pose.positions[:, new.ankle].copy()
        frames = np.flatnonzero(old.stands)
        if len(frames):
            rest = lift[frames, None] - np.median(needed)
            goal[:, 1:2] += carried_on(frames, rest, rough.frames)
        goals[new] = goal, pose.rotations[:, new.ankle]
    placed = legs_onto(lifted, goals, pose)
    if placed.frames < 2:
        return placed
    return repair_feet(placed, placed, as_straight=True)


def _turned(clip: Clip, pose: WorldPose, standing: Standing, onto: Clip) -> Array:
    """(T, K, 4) local rotations of the new skeleton's joints, its segments turned as before."""
    skeleton, new = onto.skeleton, Standing.of(onto)
    source = {joint: clip.skeleton.roles.get(role) for role, joint in skeleton.roles.items()}
    world = np.empty((clip.frames, len(skeleton), 4))
    local = np.empty_like(world)
    rest = new.local
    for joint, parent in enumerate(skeleton.parents):
        before = source.get(joint)
        above = np.array([1.0, 0.0, 0.0, 0.0]) if parent < 0 else world[:, parent]
        if before is None:
            world[:, joint] = multiply(above, rest[joint])
        else:
            turn = multiply(pose.rotations[:, before], conjugate(standing.rotations[before]))
            world[:, joint] = multiply(turn, new.rotations[joint])
        local[:, joint] = multiply(conjugate(above), world[:, joint])
    return local


def _lowest(pose: WorldPose, foot: Foot) -> Array:
    """Height (T,) of the sole's lowest point."""
    return np.min([point.positions(pose)[:, 1] for point in foot.points], axis=0)


def _between_thighs(clip: Clip, pose: WorldPose) -> Array:
    joints = [clip.skeleton.roles[f"{side}_thigh"] for side in SIDES]
    return pose.positions[:, joints].mean(axis=1)


def _leg(clip: Clip) -> float:
    return sum(leg_length(clip, side) for side in SIDES) / 2.0


def _error(clip: Clip, moved: Clip, onto: Clip) -> RetargetError:
    before, after = forward_kinematics(clip), forward_kinematics(moved)
    angles = _direction_errors(clip, before, moved, after)
    heights = [
        np.abs(_lowest(after, sole))[foot.stands]
        for sole, foot in zip(find_feet(onto), find_feet(clip, before), strict=True)
    ]
    standing = np.concatenate(heights)
    roles = (set(clip.skeleton.roles), set(moved.skeleton.roles))
    return RetargetError(
        mean_direction=float(angles.mean()),
        greatest_direction=float(angles.max()),
        slip=_slip(moved, after),
        sole_height=float(standing.mean()) if len(standing) else 0.0,
        unmapped=tuple(sorted(roles[0] ^ roles[1])),
    )


def _direction_errors(clip: Clip, before: WorldPose, moved: Clip, after: WorldPose) -> Array:
    """(T, S) rad, between each limb segment's directions."""
    errors = []
    for side in SIDES:
        for near, far in _LIMBS.items():
            ends = [f"{side}_{near}", f"{side}_{far}"]
            if all(end in body.skeleton.roles for end in ends for body in (clip, moved)):
                one, other = (
                    _direction(body, pose, ends) for body, pose in ((clip, before), (moved, after))
                )
                cross = np.linalg.norm(np.cross(one, other), axis=1)
                errors.append(np.arctan2(cross, np.sum(one * other, axis=1)))
    return np.stack(errors, axis=-1)


def _direction(clip: Clip, pose: WorldPose, ends: list[str]) -> Array:
    near, far = (clip.skeleton.roles[end] for end in ends)
    return pose.positions[:, far] - pose.positions[:, near]


def _slip(clip: Clip, pose: WorldPose) -> float:
    farthest = 0.0
    for foot in find_feet(clip, pose):
        for point, planted in zip(foot.points, foot.planted, strict=True):
            places = point.positions(pose) * _LEVEL
            for plant in runs(planted):
                way = np.linalg.norm(places[plant] - places[plant.start], axis=1)
                farthest = max(farthest, float(way.max()))
    return farthest
