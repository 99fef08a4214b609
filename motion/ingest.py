"""From BVH bytes to a clip in Manner's conventions, with a report of what was decided."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motion.body import ROLES, RoleGuess, detect_roles, sole_heights
from motion.bvh import BvhFile, Limits, Note, read_bvh
from motion.clip import Clip
from motion.errors import MotionError
from motion.kinematics import WorldPose, forward_kinematics
from motion.local_motion import Baked, LocalMotion, bake, local_motion, merge_root
from motion.rotations import (
    angle_between,
    conjugate,
    from_axis_angle,
    from_matrix,
    multiply,
    rotate,
)
from motion.skeleton import EndSite, Skeleton
from motion.units import (
    AXES,
    guess_unit,
    guess_up,
    heading,
    overall_heading,
    standing_height,
    stature,
    turn_up,
    unit_name,
)

Array = NDArray[np.float64]

_REST_FRAME_TIME = 1 / 30  # of a skeleton without motion, which becomes a clip of one frame
_NEAR_FLOOR = 0.03  # metres between the soles and the file's own floor
_CLEARLY_UP = 0.7  # cosine between the body's direction and the nearest axis
_JUMP = np.radians(20)  # a calibration pose is at least this far from the next frame


@dataclass(frozen=True)
class IngestOptions:
    """What the user knows better than the guesses.

    Attributes:
        unit: metres per unit of the file.
        up_axis: the file's axis that points up: x, y, z, -x, -y or -z.
        roles: body role to joint name; the empty name takes a guessed role away.
        drop_first_frame: leave out a calibration pose at the start.
        fill_gaps: interpolate over values that are not finite.
        root: which ROOT to take, counted from 0, where the file has several.
        frame_time: seconds a frame.
    """

    unit: float | None = None
    up_axis: str | None = None
    roles: Mapping[str, str] | None = None
    drop_first_frame: bool = False
    fill_gaps: bool = False
    root: int | None = None
    frame_time: float | None = None


@dataclass(frozen=True)
class ImportReport:
    """What was found, repaired and guessed.

    Attributes:
        repairs: what was done that the file did not say.
        questions: what the user should confirm.
        unit: metres per unit of the file.
        unit_name: the unit in words.
        up_axis: the file's axis that points up.
        stature: standing height, m.
        lowest_foot: height of the lowest point of the soles over the clip, m.
        heading: direction that the body faced in the file, rad about the vertical; turned away.
        roles: body role to joint name.
        missing_roles: roles without a joint, those that a figure needs first.
        joint_names: all joints.
        frames: number of frames.
        frame_time: seconds a frame.
        duration: seconds.
        bake_error: how far a joint lies from where the file has it at most, m.
    """

    repairs: tuple[Note, ...]
    questions: tuple[Note, ...]
    unit: float
    unit_name: str
    up_axis: str
    stature: float
    lowest_foot: float
    heading: float
    roles: Mapping[str, str]
    missing_roles: tuple[str, ...]
    joint_names: tuple[str, ...]
    frames: int
    frame_time: float
    duration: float
    bake_error: float

    def to_dict(self) -> dict[str, Any]:
        """The report as JSON-able values."""
        return asdict(self)


@dataclass(frozen=True)
class Ingested:
    """An imported clip and the report about it."""

    clip: Clip
    report: ImportReport


def ingest(
    data: bytes, options: IngestOptions | None = None, *, limits: Limits | None = None
) -> Ingested:
    """Read BVH bytes into a clip: metres, y up, facing +z, on the floor, starting over the origin.

    Args:
        data: the file's bytes.
        options: what the user decided.
        limits: what the file may hold at most.

    Raises:
        BvhSyntaxError: if the file cannot be read, with line and column.
        MotionError: if an option does not fit the file.
    """
    options = options or IngestOptions()
    if options.frame_time is not None and not 0 < options.frame_time < np.inf:
        raise MotionError(f"The frame time must be above 0 s, not {options.frame_time}.")
    file = read_bvh(data, limits=limits, fill_gaps=options.fill_gaps, frame_time=options.frame_time)
    repairs, questions = list(file.notes), list[Note]()
    motion = local_motion(file, _choose_root(file, options, questions))
    motion, merged = merge_root(_without_first_frame(motion, options, repairs))
    baked, folded = bake(motion)
    repairs += merged + folded
    raw = _raw_clip(file, motion, baked, repairs)
    guess = _roles(raw, options)
    scale = _choose_scale(raw, guess, options, questions)
    settled = _settle(_convert(raw, guess.roles, scale), scale.stature * scale.unit)
    questions += _questions(settled, scale) + [Note(text, offer="roles") for text in guess.notes]
    report = _report(settled, scale, guess.missing, repairs, questions)
    return Ingested(settled.clip, replace(report, bake_error=baked.error * scale.unit))


def _report(
    settled: _Settled,
    scale: _Scale,
    missing: tuple[str, ...],
    repairs: list[Note],
    questions: list[Note],
) -> ImportReport:
    clip = settled.clip
    names = clip.skeleton.names
    return ImportReport(
        repairs=tuple(repairs),
        questions=tuple(questions),
        unit=scale.unit,
        unit_name=scale.unit_name,
        up_axis=scale.up_axis,
        stature=settled.stature,
        lowest_foot=settled.lowest_foot,
        heading=settled.heading,
        roles={role: names[joint] for role, joint in clip.skeleton.roles.items()},
        missing_roles=missing,
        joint_names=names,
        frames=clip.frames,
        frame_time=clip.frame_time,
        duration=clip.duration,
        bake_error=0.0,
    )


def _choose_root(file: BvhFile, options: IngestOptions, questions: list[Note]) -> int:
    roots = file.roots
    if options.root is not None:
        if not 0 <= options.root < len(roots):
            raise MotionError(
                f"The file has {len(roots)} roots; there is no number {options.root}."
            )
        return roots[options.root]
    if len(roots) > 1:
        names = ", ".join(f"“{file.joints[root].name}”" for root in roots)
        line = file.joints[roots[1]].line
        text = (
            f"The file has {len(roots)} figures: {names}. The first was taken; is it the right one?"
        )
        questions.append(Note(text, line, f"line {line}", offer="root"))
    return roots[0]


def _without_first_frame(
    motion: LocalMotion, options: IngestOptions, notes: list[Note]
) -> LocalMotion:
    if not options.drop_first_frame or len(motion.positions) < 2:
        return motion
    notes.append(Note("The first frame, a calibration pose, was left out", where="frame 1"))
    return replace(motion, positions=motion.positions[1:], rotations=motion.rotations[1:])


def _raw_clip(file: BvhFile, motion: LocalMotion, baked: Baked, notes: list[Note]) -> Clip:
    """The motion as a clip, still in the file's units and axes."""
    skeleton = Skeleton(
        names=_unique_names(motion, notes),
        parents=motion.parents,
        offsets=baked.offsets,
        end_sites=tuple(EndSite(joint, offset) for joint, offset in motion.tips if any(offset)),
    )
    return Clip(
        skeleton, baked.root_positions, baked.rotations, file.frame_time or _REST_FRAME_TIME
    )


def _unique_names(motion: LocalMotion, notes: list[Note]) -> tuple[str, ...]:
    wanted = Counter(joint.name for joint in motion.joints)
    used: set[str] = set()
    names = []
    for joint in motion.joints:
        name, number = joint.name, 1
        while name in used or (number > 1 and name in wanted):
            number += 1
            name = f"{joint.name}_{number}"
        if name != joint.name:
            text = f"A second joint “{joint.name}” is called “{name}”"
            notes.append(Note(text, joint.line, f"line {joint.line}"))
        used.add(name)
        names.append(name)
    return tuple(names)


def _roles(raw: Clip, options: IngestOptions) -> RoleGuess:
    guess = detect_roles(raw.skeleton, forward_kinematics(raw))
    if not options.roles:
        return guess
    roles = dict(guess.roles)
    for role, name in options.roles.items():
        if role not in ROLES:
            raise MotionError(f"There is no body role “{role}”. Roles: {', '.join(ROLES)}.")
        roles.pop(role, None)
        if name:
            if name not in raw.skeleton.names:
                raise MotionError(f"There is no joint “{name}” for the role {role}.")
            roles[role] = raw.skeleton.names.index(name)
    return RoleGuess({role: roles[role] for role in ROLES if role in roles}, ())


@dataclass(frozen=True)
class _Scale:
    """What the file's numbers mean: its up axis, metres per unit, and the stature in its units."""

    up_axis: str
    unit: float
    unit_name: str
    likely: bool
    stature: float


def _choose_scale(
    raw: Clip, guess: RoleGuess, options: IngestOptions, questions: list[Note]
) -> _Scale:
    up = _choose_up(raw, guess, options, questions)
    height = stature(raw.skeleton, guess.roles)
    if options.unit is None:
        return _Scale(up, *guess_unit(height), height)
    if not (np.isfinite(options.unit) and options.unit > 0):
        raise MotionError(f"The unit must be above 0 m, not {options.unit}.")
    return _Scale(up, options.unit, unit_name(options.unit), True, height)


def _choose_up(raw: Clip, guess: RoleGuess, options: IngestOptions, questions: list[Note]) -> str:
    if options.up_axis is not None:
        if options.up_axis not in AXES:
            raise MotionError(
                f"The up axis must be one of {', '.join(AXES)}, not {options.up_axis}."
            )
        return options.up_axis
    up, clarity = guess_up(forward_kinematics(raw), guess.roles)
    if clarity < _CLEARLY_UP:
        text = f"Is {up} the axis that points up? The poses do not tell."
        questions.append(Note(text, offer="up_axis"))
    return up


def _convert(raw: Clip, roles: Mapping[str, int], scale: _Scale) -> Clip:
    """The clip in metres with y up; rest pose and motion are turned alike."""
    matrix, unit = turn_up(scale.up_axis), scale.unit
    turn = from_matrix(matrix)
    rotations = raw.rotations
    if scale.up_axis != "y":
        rotations = multiply(multiply(turn, rotations), conjugate(turn))
    sites = tuple(
        EndSite(site.joint, _triple(matrix @ np.array(site.offset) * unit))
        for site in raw.skeleton.end_sites
    )
    skeleton = replace(
        raw.skeleton, offsets=raw.skeleton.offsets @ matrix.T * unit, end_sites=sites, roles=roles
    )
    return replace(
        raw,
        skeleton=skeleton,
        root_positions=raw.root_positions @ matrix.T * unit,
        rotations=rotations,
    )


def _triple(vector: Array) -> tuple[float, float, float]:
    x, y, z = vector.tolist()
    return x, y, z


@dataclass(frozen=True)
class _Settled:
    """A clip in its place and what was measured on the way."""

    clip: Clip
    heading: float
    steady: bool
    stature: float
    lowest_foot: float


def _settle(clip: Clip, height: float) -> _Settled:
    """Turn the clip to +z, put it on the floor and its start over the origin.

    The file's own floor is kept where the soles come near it.
    """
    pose = forward_kinematics(clip)
    angle, steady = _facing(clip, pose)
    lowest = float(sole_heights(pose, clip.skeleton, height).min())
    if not np.isfinite(lowest):  # without feet, the lowest joint stands on the floor
        lowest = float(pose.positions[..., 1].min())
    floor = 0.0 if abs(lowest) < _NEAR_FLOOR else lowest
    start = np.array([clip.root_positions[0, 0], floor, clip.root_positions[0, 2]])
    back = from_axis_angle(np.array([0.0, 1.0, 0.0]), -angle)
    rotations = clip.rotations.copy()
    rotations[:, 0] = multiply(back, rotations[:, 0])
    positions = rotate(back, clip.root_positions - start)
    return _Settled(
        clip=replace(clip, root_positions=positions, rotations=rotations),
        heading=angle,
        steady=steady,
        stature=standing_height(clip, pose, floor),
        lowest_foot=lowest - floor,
    )


def _facing(clip: Clip, pose: WorldPose) -> tuple[float, bool]:
    headings = heading(pose, clip.skeleton.roles)
    if _starts_with_jump(clip):
        headings = headings[1:]
    return overall_heading(headings, clip.frame_time)


def _starts_with_jump(clip: Clip) -> bool:
    """Whether the first frame is far from the second, and the others are not so far apart."""
    if clip.frames < 4:
        return False
    steps = angle_between(clip.rotations[:-1], clip.rotations[1:]).max(axis=1)
    return bool(steps[0] > _JUMP and steps[0] > 3 * steps[1:].max())


def _questions(settled: _Settled, scale: _Scale) -> list[Note]:
    read = f"Read as {scale.unit_name}, {scale.up_axis} up."
    if not settled.stature:
        questions = [Note(f"How tall is the figure? {read}", offer="unit")]
    elif scale.likely:
        questions = [Note(f"Is the figure {settled.stature:.2f} m tall? {read}", offer="unit")]
    else:
        text = f"Is the figure {settled.stature:.2f} m tall? No known unit fits. {read}"
        questions = [Note(text, offer="unit")]
    if not settled.steady:
        text = "The figure turns; its first direction was taken as forward"
        questions.append(Note(text))
    if _starts_with_jump(settled.clip):
        text = "Is the first frame a calibration pose? It is far from the second."
        questions.append(Note(text, where="frame 1", offer="drop_first_frame"))
    return questions
