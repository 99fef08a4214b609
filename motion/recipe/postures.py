"""Operations on poses: posture, key poses, limits of joints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motion.body import REQUIRED, ROLES
from motion.clip import Clip
from motion.editing.posture import PostureOffset, add_posture
from motion.editing.warping import Keyframe, warp_poses
from motion.editing.waveshaping import AXES, SoftLimit, shape
from motion.errors import MotionError
from motion.procedural.stances import STANCES
from motion.recipe.feet import moves_feet, standing_again
from motion.recipe.operation import Context, operation
from motion.recipe.parameters import Choice, Group, ListOf, Number, Reference
from motion.rotations import from_axis_angle, multiply
from motion.standing import Standing

Array = NDArray[np.float64]

_AXES = np.eye(3)


def _posture(clip: Clip, context: Context, *, offsets: list[dict[str, Any]]) -> Clip:
    pose = context.materials.pose
    amounts = [
        (PostureOffset.between(pose(entry["neutral"]), pose(entry["pose"])), entry["amount"])
        for entry in offsets
        if entry["amount"] != 0.0
    ]
    edited = add_posture(clip, amounts, Standing.of(context.source))
    moved = {r for offset, _ in amounts for r, change in offset.directions.items() if change.any()}
    return standing_again(clip, edited) if moves_feet(moved) else edited


def _warp(
    clip: Clip, context: Context, *, keyframes: list[dict[str, Any]], amount: float, reach: float
) -> Clip:
    if amount == 0.0 or not keyframes:
        return clip
    standing = Standing.of(context.source)
    keys = [_keyframe(clip, standing, context, entry) for entry in keyframes]
    bent = warp_poses(clip, [replace(key, root=None) for key in keys], amount, reach=reach)
    turned = {joint for key in keys for joint in key.rotations}
    if moves_feet(role for role, joint in clip.skeleton.roles.items() if joint in turned):
        bent = standing_again(clip, bent)
    # A shift is meant to move the feet as well, so it comes after their repair.
    shifts = [
        Keyframe(key.frame, root=bent.root_positions[key.frame] + key.root)
        for key in keys
        if key.root is not None and key.root.any()
    ]
    return warp_poses(bent, shifts, amount, reach=reach)


def _keyframe(clip: Clip, standing: Standing, context: Context, entry: dict[str, Any]) -> Keyframe:
    """A keyframe whose root is still a shift."""
    frame = round(entry["time"] / clip.frame_time)
    if frame >= clip.frames:
        raise MotionError(
            f"A keyframe at {entry['time']:g} s lies beyond the clip's {clip.duration:.3g} s."
        )
    roles = clip.skeleton.roles
    now = standing.canonical(clip.rotations[frame])
    wanted = {} if entry["pose"] is None else dict(context.materials.pose(entry["pose"]))
    wanted.pop("hips", None)  # where the body faces is where it goes
    for turn in entry["turns"]:
        role = turn["role"]
        if role not in roles:
            name = role.replace("_", " ")
            raise MotionError(f"No joint is the {name}: set that body role first.")
        wanted[role] = multiply(_rotation(turn), wanted.get(role, now[roles[role]]))
    rotations = {
        roles[role]: standing.from_canonical(rotation, roles[role])
        for role, rotation in wanted.items()
        if role in roles
    }
    return Keyframe(frame, rotations, np.array([entry[name] for name in ("left", "up", "forward")]))


def _rotation(turn: dict[str, Any]) -> Array:
    """(4,) first about x, then about y, then about z, in canonical axes."""
    x, y, z = (
        from_axis_angle(axis, np.radians(turn[name]))
        for axis, name in zip(_AXES, "xyz", strict=True)
    )
    return multiply(z, multiply(y, x))


def _waveshape(
    clip: Clip, context: Context, *, limits: list[dict[str, Any]], amount: float
) -> Clip:
    if amount == 0.0:
        return clip
    curves = [SoftLimit(**limit) for limit in limits]
    edited = shape(clip, curves, amount, Standing.of(context.source))
    return standing_again(clip, edited) if moves_feet(e["role"] for e in limits) else edited


def _room(values: Mapping[str, Any]) -> tuple[str, str] | None:
    if values["high"] - values["low"] >= 2.0 * values["soft"]:
        return None
    return (
        f"Between {values['low']:g}° and {values['high']:g}° there is no room for "
        f"{values['soft']:g}° at both ends.",
        "Give limits farther apart, or a smaller soft range.",
    )


def _times_once(values: Mapping[str, Any]) -> tuple[str, str] | None:
    times = [entry["time"] for entry in values["keyframes"]]
    if len(set(times)) == len(times):
        return None
    return "Two keyframes have the same time.", "Put them into one."


def _degrees(title: str, description: str, default: float = 0.0) -> Number:
    return Number(
        title=title,
        description=description,
        unit="°",
        minimum=-180.0,
        maximum=180.0,
        default=default,
    )


def _metres(title: str) -> Number:
    return Number(title=title, unit="m", minimum=-5.0, maximum=5.0, default=0.0)


_AMOUNT = Number(
    title="Amount",
    description="0 none, 1 all of it.",
    minimum=0.0,
    maximum=1.0,
    default=1.0,
    neutral=0.0,
)

POSTURE = operation(
    "posture@1",
    "Posture",
    "Adds to every frame that by which a standing pose differs from the neutral one.",
    {
        "offsets": ListOf(
            title="Offsets",
            description="They add up, in whatever order.",
            longest=16,
            item=Group(
                title="Offset",
                members={
                    "pose": Reference(
                        title="Pose",
                        description="A stance's name, or the id of a captured pose.",
                        kind="pose",
                        names=tuple(STANCES),
                    ),
                    "neutral": Reference(
                        title="Neutral pose",
                        description="What the pose is compared with.",
                        kind="pose",
                        names=tuple(STANCES),
                        default="neutral",
                    ),
                    "amount": Number(
                        title="Amount",
                        description="0 none, 1 as it stands, more exaggerates, below 0 opposite.",
                        minimum=-2.0,
                        maximum=2.0,
                        default=1.0,
                        neutral=0.0,
                    ),
                },
            ),
        )
    },
    _posture,
    needs=REQUIRED,
)

WARP = operation(
    "warp@1",
    "Key poses",
    "Bends the motion so that it passes through given poses; its details stay.",
    {
        "keyframes": ListOf(
            title="Keyframes",
            description="What shall be at which moment.",
            longest=64,
            item=Group(
                title="Keyframe",
                members={
                    "time": Number(title="Time", unit="s", minimum=0.0, maximum=3600.0),
                    "pose": Reference(
                        title="Pose",
                        description="The pose to pass through; the body goes where it went.",
                        kind="pose",
                        names=tuple(STANCES),
                        optional=True,
                    ),
                    "turns": ListOf(
                        title="Turns",
                        description="Joints to turn further.",
                        longest=len(ROLES),
                        default=[],
                        item=Group(
                            title="Turn",
                            members={
                                "role": Choice(title="Joint", options=ROLES),
                                "x": _degrees("About x", "Bows and bends."),
                                "y": _degrees("About y", "Turns."),
                                "z": _degrees("About z", "Leans and spreads."),
                            },
                        ),
                    ),
                    "left": _metres("Shift to +x"),
                    "up": _metres("Shift up"),
                    "forward": _metres("Shift to +z"),
                },
            ),
        ),
        "amount": _AMOUNT,
        "reach": Number(
            title="Reach",
            description="Time before the first and after the last keyframe that changes.",
            unit="s",
            minimum=0.02,
            maximum=10.0,
            default=0.5,
        ),
    },
    _warp,
    needs=REQUIRED,
    rule=_times_once,
)

WAVESHAPE = operation(
    "waveshape@1",
    "Soft limits",
    "Presses joint angles together where they come near their limits.",
    {
        "limits": ListOf(
            title="Limits",
            description="Each is applied to what the ones before have left.",
            longest=32,
            item=Group(
                title="Limit",
                members={
                    "role": Choice(title="Joint", options=ROLES),
                    "axis": Choice(
                        title="Axis",
                        description="x bows and bends, y turns, z leans and spreads.",
                        options=tuple(AXES),
                    ),
                    "low": _degrees("Low", "Approached, never passed.", default=-180.0),
                    "high": _degrees("High", "Approached, never passed.", default=180.0),
                    "soft": Number(
                        title="Soft range",
                        description="Before a limit, from where on the angle is pressed together.",
                        unit="°",
                        minimum=0.0,
                        maximum=90.0,
                        default=15.0,
                    ),
                },
                rule=_room,
            ),
        ),
        "amount": _AMOUNT,
    },
    _waveshape,
    needs=REQUIRED,
)
