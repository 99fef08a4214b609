"""When and where the feet stand on the floor."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_propagation, gaussian_filter1d

from motion.clip import Clip
from motion.errors import MotionError
from motion.kinematics import WorldPose, forward_kinematics
from motion.rotations import conjugate, rotate

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

SIDES = ("left", "right")
_SPAN = 0.1  # s: how long a foot rests at least when it is looked for at rest
# A contact point stands around a moment at which it is below the strict share of both limits, for
# as long as it stays below the limits (hysteresis). Height in leg lengths, speed in those a second.
LOW, _SLOW, STRICT = 0.045, 0.25, 0.6
_AT_REST = 0.1  # of both limits
_STEADY = 0.015  # s, standard deviation of the smoothing of its velocity


@dataclass(frozen=True, eq=False)
class ContactPoint:
    """A point of a sole, fixed to a joint.

    Attributes:
        joint: the foot's joint for the heel, the toes' for the ball.
        offset: (3,) in the joint's frame, metres.
    """

    joint: int
    offset: Array

    def positions(self, pose: WorldPose) -> Array:
        """World positions (T, 3), metres."""
        return pose.positions[:, self.joint] + rotate(pose.rotations[:, self.joint], self.offset)


@dataclass(frozen=True, eq=False)
class Foot:
    """One foot: its joints, the points of its sole and when each of them stands.

    Attributes:
        side: left or right.
        thigh, shin, ankle: joints of the leg.
        points: heel and ball; for a foot without toes, its one point.
        planted: (P, T) whether the foot stands on that point: it is low and slow, and at rest or
            the slowest of the foot's points.
    """

    side: str
    thigh: int
    shin: int
    ankle: int
    points: tuple[ContactPoint, ...]
    planted: Flags

    @property
    def stands(self) -> Flags:
        """(T,) whether any part of the foot stands."""
        return np.asarray(self.planted.any(axis=0))

    def plants(self) -> Iterator[slice]:
        """The stretches of frames in which the foot stands."""
        return runs(self.stands)


def find_feet(clip: Clip, pose: WorldPose | None = None) -> tuple[Foot, Foot]:
    """Both feet of a clip, their contact points found where the feet rest most.

    Raises:
        MotionError: if a leg's roles are missing.
    """
    pose = pose or forward_kinematics(clip)
    return _find_foot(clip, pose, "left"), _find_foot(clip, pose, "right")


def leg_length(clip: Clip, side: str) -> float:
    """Thigh and shin together, metres."""
    roles, offsets = clip.skeleton.roles, clip.skeleton.offsets
    joints = (roles[f"{side}_shin"], roles[f"{side}_foot"])
    return float(sum(np.linalg.norm(offsets[joint]) for joint in joints))


def runs(flags: Flags) -> Iterator[slice]:
    """The stretches (start, stop) in which a row (T,) of flags is true."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(np.int8)))
    for start, stop in edges.reshape(-1, 2):
        yield slice(int(start), int(stop))


def _find_foot(clip: Clip, pose: WorldPose, side: str) -> Foot:
    roles = clip.skeleton.roles
    missing = [r for r in ("thigh", "shin", "foot") if f"{side}_{r}" not in roles]
    if missing:
        raise MotionError(f"No joint is the {side} {missing[0]}: set that body role first.")
    ankle = roles[f"{side}_foot"]
    toes = roles.get(f"{side}_toes")
    joints = [ankle] if toes is None else [ankle, toes]
    resting = resting_frames(pose, joints, clip.frame_time)
    points = tuple(_sole_point(pose, joint, resting) for joint in joints)
    level = np.array([motion_level(p.positions(pose), clip, side) for p in points])
    stands = np.array([binary_propagation(row < STRICT, mask=row < 1.0) for row in level])
    slowest = np.where(stands, level, np.inf).argmin(axis=0) == np.arange(len(points))[:, None]
    slowest |= level < _AT_REST  # heel and ball both, instead of either by chance
    return Foot(
        side, roles[f"{side}_thigh"], roles[f"{side}_shin"], ankle, points, stands & slowest
    )


def resting_frames(pose: WorldPose, joints: list[int], frame_time: float) -> NDArray[np.intp]:
    """Frames in which the whole foot is lowest and slowest: there it is flat."""
    places = pose.positions[:, joints]
    if len(places) < 3:
        return np.arange(len(places))
    height = places[..., 1].sum(axis=1)
    speed = np.linalg.norm(np.gradient(places, frame_time, axis=0), axis=2).sum(axis=1)
    low = np.flatnonzero(height <= np.quantile(height, 0.4))
    count = max(3, round(_SPAN / frame_time))
    return low[np.argsort(speed[low], kind="stable")[:count]]


def _sole_point(pose: WorldPose, joint: int, resting: NDArray[np.intp]) -> ContactPoint:
    """The point of the floor right under a joint while the foot rests."""
    height = float(np.median(pose.positions[resting, joint, 1]))
    down = rotate(conjugate(pose.rotations[resting, joint]), np.array([0.0, -1.0, 0.0])).mean(
        axis=0
    )
    return ContactPoint(joint, height * down / np.linalg.norm(down))


def motion_level(positions: Array, clip: Clip, side: str) -> Array:
    """How far (T,) a point (T, 3) is from standing: 1 where it is just low and slow enough."""
    if len(positions) < 3:
        return np.zeros(len(positions))
    leg = leg_length(clip, side)
    speed = steady_speed(positions, clip.frame_time)
    return np.maximum(speed / (_SLOW * leg), positions[:, 1] / (LOW * leg))


def steady_speed(positions: Array, frame_time: float) -> Array:
    """Speed (T,) of a point (T ≥ 2, 3), m/s, without a recording's jitter.

    Jitter, which grows with the frame rate, is no motion of the foot.
    """
    velocity = np.gradient(positions, frame_time, axis=0)
    velocity = gaussian_filter1d(velocity, _STEADY / frame_time, axis=0, mode="nearest")
    return np.linalg.norm(velocity, axis=1)
