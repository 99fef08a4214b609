"""The 51 features of a clip, measured."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from motion.centre_of_mass import SIDES, SegmentEnds, centre_of_mass
from motion.clip import Clip
from motion.errors import MotionError
from motion.features.definitions import (
    DURATION,
    FEATURES,
    FRONT_BACK,
    LEFT_RIGHT,
    LONGEST_STEP,
    MEAN,
    SPREAD,
    STEP_LENGTH,
    STEP_WIDTH,
)
from motion.features.steps import Step, find_steps
from motion.features.view import View
from motion.rotations import conjugate, rotate

Array = NDArray[np.float64]

_LEFT, _UP, _FORWARD = 0, 1, 2
_PAIRED = ("upper_arm", "forearm", "thigh", "shin", "foot")
# An arm may be raised to the front until it points up and beyond, but hardly that far backward.
_ARM_MIDDLE = np.radians(60.0)
_SIDEWAYS = 0.25  # squared length seen from the side of a segment that points 60° to a side


def features(clip: Clip) -> Array:
    """The values (51,) of ``FEATURES`` for a clip, in their units: degrees, metres and seconds.

    Directions are the world's, seen from the clip's own heading; positions count from the floor at
    height 0. A clip without steps has step lengths of 0, one frame has velocities of 0.

    Raises:
        MotionError: if the clip has no frame, or a body role is missing that a segment needs.
    """
    if clip.frames == 0:
        raise MotionError("A clip without frames has no features: import it again.")
    view = View.of(clip)
    found = _angles(view) | _centre(view) | _step_values(find_steps(view))
    found[DURATION] = clip.duration
    return np.array([found[feature.id] for feature in FEATURES])


def _angles(view: View) -> dict[str, float]:
    """Mean and spread of every segment's two angles, degrees."""
    found: dict[str, float] = {}
    for name, direction in _directions(view).items():
        along, out, middle = _seen_from_the_side(name, direction)
        visible = np.minimum((along**2 + out**2) / _SIDEWAYS, 1.0)
        aside = np.arcsin(np.clip(direction[:, _LEFT], -1.0, 1.0))
        front = _circular(view, np.arctan2(out, along), visible, middle)
        for way, (mean, spread) in (
            (FRONT_BACK, front),
            (LEFT_RIGHT, (float(view.mean(aside)), float(view.spread(aside)))),
        ):
            found[f"{name}_{way}_{MEAN}"] = float(np.degrees(mean))
            found[f"{name}_{way}_{SPREAD}"] = float(np.degrees(spread))
    return found


def _seen_from_the_side(name: str, direction: Array) -> tuple[Array, Array, float]:
    """A direction's part along where its angle is 0, its part towards 90°, and a usual angle."""
    _, up, forward = direction.T
    if name in ("torso", "head"):
        return up, forward, 0.0
    if name.endswith("foot"):
        return forward, up, 0.0
    return -up, forward, _ARM_MIDDLE if name.endswith("arm") else 0.0


def _circular(view: View, angles: Array, visible: Array, middle: float) -> tuple[float, float]:
    """Mean and spread (rad) of angles (T,) that may pass half a turn.

    A segment that points to the side has no angle seen from the side: such frames count less
    (``visible``, (T,) in [0, 1]), so an arm held sideways does not swing. The mean is at most half
    a turn from the ``middle``.
    """
    weights = view.weights * visible
    total = float(weights.sum())
    if total < 1e-12:
        return 0.0, 0.0
    centre = np.angle(weights @ np.exp(1j * angles))
    away = _wrapped(angles - centre)
    shift = weights @ away / total
    spread = np.sqrt(weights @ (away - shift) ** 2)
    return float(_wrapped(centre + shift - middle) + middle), float(spread)


def _wrapped(angles: Array) -> Array:
    """Angles in [−π, π)."""
    return (angles + np.pi) % (2.0 * np.pi) - np.pi


def _directions(view: View) -> Mapping[str, Array]:
    """Unit direction (T, 3) left, up, forward of each segment; zero where nothing tells it."""
    ends = SegmentEnds(view.clip.skeleton, view.pose)
    top, bottom = ends.of("trunk")[0]
    ways = {"torso": top - bottom, "head": _head(view)}
    for part in _PAIRED:
        for side, (near, far) in zip(SIDES, ends.of(part), strict=True):
            ways[f"{side}_{part}"] = far - near
    return {name: _unit(view.turned(way[view.part])) for name, way in ways.items()}


def _head(view: View) -> Array:
    """(T, 3) up through the head: to its tip, or the joint's axis that the neck runs along."""
    skeleton, pose = view.clip.skeleton, view.pose
    head = skeleton.roles["head"]
    turns = pose.rotations[:, head]
    for site in skeleton.end_sites:
        if site.joint == head and np.linalg.norm(site.offset) > 1e-6:
            return rotate(turns, np.array(site.offset))
    below = [skeleton.roles[r] for r in _below_head(skeleton.roles)]
    neck = pose.positions[:, head] - pose.positions[:, below].mean(axis=1)
    seen = rotate(conjugate(turns), neck)[view.part].mean(axis=0)
    axis = np.argmax(np.abs(seen))
    return rotate(turns, np.sign(seen[axis]) * np.eye(3)[axis])


def _below_head(roles: Mapping[str, int]) -> tuple[str, ...]:
    return ("neck",) if "neck" in roles else ("left_upper_arm", "right_upper_arm")


def _unit(vectors: Array) -> Array:
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.divide(vectors, length, out=np.zeros_like(vectors), where=length > 1e-9)


def _centre(view: View) -> dict[str, float]:
    """Features of the centre of mass, metres and seconds."""
    whole = view.turned(centre_of_mass(view.clip.skeleton, view.pose))
    places, velocity = whole[view.part], view.velocity(whole)[view.part]
    duration = view.clip.duration
    mean = (places[-1] - places[0]) / duration if duration else np.zeros(3)
    even = np.arange(len(places)) * view.clip.frame_time * mean[_LEFT]
    return {
        f"com_{LEFT_RIGHT}_{SPREAD}": float(view.spread(places[:, _LEFT] - even)),
        f"com_position_vertical_{MEAN}": float(view.mean(places[:, _UP])),
        f"com_position_vertical_{SPREAD}": float(view.spread(places[:, _UP])),
        f"com_velocity_vertical_{SPREAD}": float(view.spread(velocity[:, _UP])),
        f"com_velocity_{LEFT_RIGHT}_{MEAN}": float(mean[_LEFT]),
        f"com_velocity_{FRONT_BACK}_{MEAN}": float(mean[_FORWARD]),
        f"com_velocity_{FRONT_BACK}_{SPREAD}": float(view.spread(velocity[:, _FORWARD])),
    }


def _step_values(steps: list[Step]) -> dict[str, float]:
    """Features of the steps, metres."""
    lengths = [step.forward for step in steps]
    widths = [[step.outward for step in steps if step.side == side] for side in SIDES]
    sides = [np.mean(side) for side in widths if side]
    return {
        STEP_WIDTH: float(np.mean(sides)) if sides else 0.0,
        STEP_LENGTH: float(np.mean(lengths)) if lengths else 0.0,
        LONGEST_STEP: max(lengths, default=0.0),
    }
