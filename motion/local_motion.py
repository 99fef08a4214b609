"""From a BVH file's channels to a skeleton whose joints only turn, still in the file's units.

A BVH joint may move within its parent; Manner's skeletons do not. So a root above moving hips is
merged into them, positions that stay constant become offsets, and what still moves is baked: the
parent turns so that its child points where it was.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from motion.bvh import BvhFile
from motion.bvh_hierarchy import BvhJoint
from motion.bvh_text import Note, counted
from motion.rotations import (
    between,
    conjugate,
    from_euler,
    from_matrix,
    make_continuous,
    multiply,
    rotate,
)

Array = NDArray[np.float64]

_FOLD = 5e-4  # of the skeleton's reach: half a millimetre on a person


@dataclass(frozen=True)
class LocalMotion:
    """Every joint's pose in its parent's frame.

    Attributes:
        joints: the file's joints that take part.
        parents: (J,) index of the parent, -1 for the root, which comes first.
        tips: (joint, offset) of end sites.
        offsets: (J, 3) as the hierarchy says, file units.
        positions: (T, J, 3) file units.
        rotations: (T, J, 4) wxyz.
    """

    joints: tuple[BvhJoint, ...]
    parents: NDArray[np.intp]
    tips: tuple[tuple[int, tuple[float, float, float]], ...]
    offsets: Array
    positions: Array
    rotations: Array


@dataclass(frozen=True)
class Baked:
    """A motion by rotations alone.

    Attributes:
        offsets: (J, 3) file units; zero for the root.
        root_positions: (T, 3) file units.
        rotations: (T, J, 4) wxyz.
        error: largest distance of a joint from where the file has it, file units.
    """

    offsets: Array
    root_positions: Array
    rotations: Array
    error: float


def local_motion(file: BvhFile, root: int) -> LocalMotion:
    """The motion of the joints below one of the file's roots.

    Args:
        file: as read.
        root: index of the ROOT among ``file.joints``.
    """
    chosen = [root]
    for index in range(root + 1, len(file.joints)):
        if file.joints[index].parent < 0:
            break
        chosen.append(index)
    place = {joint: position for position, joint in enumerate(chosen)}
    joints = tuple(file.joints[index] for index in chosen)
    offsets = np.array([joint.offset for joint in joints])
    return LocalMotion(
        joints=joints,
        parents=np.array([place.get(joint.parent, -1) for joint in joints], np.intp),
        tips=tuple((place[tip.joint], tip.offset) for tip in file.tips if tip.joint in place),
        offsets=offsets,
        positions=_positions(file, joints, offsets),
        rotations=_rotations(file, joints),
    )


def _positions(file: BvhFile, joints: tuple[BvhJoint, ...], offsets: Array) -> Array:
    positions = np.tile(offsets, (max(len(file.values), 1), 1, 1))
    if not len(file.values):
        return positions
    for index, joint in enumerate(joints):
        for number, channel in enumerate(joint.channels):
            if channel.endswith("position"):
                column = file.values[:, joint.column + number]
                positions[:, index, "XYZ".index(channel[0])] = column
    return positions


def _rotations(file: BvhFile, joints: tuple[BvhJoint, ...]) -> Array:
    """Quaternions of all joints, those of one rotation order at once."""
    rotations = np.zeros((max(len(file.values), 1), len(joints), 4))
    rotations[..., 0] = 1.0
    if not len(file.values):
        return rotations
    groups: dict[str, tuple[list[int], list[list[int]]]] = {}
    for index, joint in enumerate(joints):
        turns = [n for n, name in enumerate(joint.channels) if name.endswith("rotation")]
        order = "".join(joint.channels[n][0] for n in turns)
        members, columns = groups.setdefault(order, ([], []))
        members.append(index)
        columns.append([joint.column + n for n in turns])
    for order, (members, columns) in groups.items():
        if order:
            rotations[:, members] = from_euler(np.radians(file.values[:, columns]), order)
    return make_continuous(rotations)


def merge_root(motion: LocalMotion) -> tuple[LocalMotion, list[Note]]:
    """Take away roots above a single child that moves within them: the travel goes to the child."""
    notes = []
    while (what := _mergeable(motion)) is not None:
        root, child = motion.joints[0], motion.joints[1]
        text = f"{what} “{root.name}” above the moving “{child.name}” was merged into it"
        notes.append(Note(text, root.line, f"line {root.line}"))
        motion = _without_root(motion)
    return motion, notes


def _mergeable(motion: LocalMotion) -> str | None:
    """What to call a root that only carries the hips; None for any other root."""
    alone = np.count_nonzero(motion.parents == 0) == 1
    if not alone or any(joint == 0 for joint, _ in motion.tips):
        return None
    if not any(name.endswith("position") for name in motion.joints[1].channels):
        return None
    still = not (np.ptp(motion.positions[:, 0], axis=0).any() or _turns(motion.rotations[:, 0]))
    forks = np.count_nonzero(motion.parents == 1) > 1
    moves = np.linalg.norm(np.ptp(motion.positions[:, 1], axis=0)) > _FOLD * reach(motion)
    if still and (moves or forks):
        return "The still root"
    return "The root" if moves and forks else None


def _turns(rotations: Array) -> bool:
    return bool(np.ptp(rotations, axis=0).max(initial=0.0) > 1e-6)


def _without_root(motion: LocalMotion) -> LocalMotion:
    turn = motion.rotations[:, 0]
    positions, rotations = motion.positions[:, 1:].copy(), motion.rotations[:, 1:].copy()
    positions[:, 0] = motion.positions[:, 0] + rotate(turn, motion.positions[:, 1])
    rotations[:, 0] = multiply(turn, motion.rotations[:, 1])
    return replace(
        motion,
        joints=motion.joints[1:],
        parents=np.maximum(motion.parents[1:] - 1, -1),
        tips=tuple((joint - 1, offset) for joint, offset in motion.tips),
        offsets=motion.offsets[1:],
        positions=positions,
        rotations=rotations,
    )


def reach(motion: LocalMotion) -> float:
    """Longest way along bones from the root to a joint or tip, file units."""
    lengths = np.linalg.norm(np.median(motion.positions, axis=0), axis=-1)
    far = np.zeros(len(lengths))
    for joint in range(1, len(lengths)):
        far[joint] = far[motion.parents[joint]] + lengths[joint]
    tips = [far[joint] + np.linalg.norm(offset) for joint, offset in motion.tips]
    return float(max([*far, *tips]))


def bake(motion: LocalMotion) -> tuple[Baked, list[Note]]:
    """Fold constant positions into offsets and turn parents to follow what moves."""
    tolerance = _FOLD * reach(motion)
    middle = np.median(motion.positions, axis=0)
    deviation = np.abs(motion.positions - middle).max(axis=(0, 2))
    moving = deviation > tolerance
    moving[0] = False
    as_written = np.abs(middle - motion.offsets).max(axis=1) <= tolerance
    offsets = np.where(as_written[:, None], motion.offsets, middle)
    offsets[moving] = _lengthened(motion.positions[:, moving])
    offsets[0] = 0.0
    rotations = motion.rotations
    if moving.any():
        rotations = _follow(motion, offsets, moving)
    baked = Baked(offsets, motion.positions[:, 0], rotations, 0.0)
    if (motion.positions[:, 1:] != offsets[1:]).any():
        baked = replace(baked, error=_error(motion, baked))
    return baked, _notes(motion, moving, as_written)


def _lengthened(positions: Array) -> Array:
    """(K, 3) mean directions of (T, K, 3) positions, with their median lengths."""
    mean = positions.mean(axis=0)
    length = np.linalg.norm(mean, axis=-1, keepdims=True)
    wanted = np.median(np.linalg.norm(positions, axis=-1), axis=0)[:, None]
    return np.where(length > 1e-9, mean / np.maximum(length, 1e-9) * wanted, mean)


def _follow(motion: LocalMotion, offsets: Array, moving: NDArray[np.bool_]) -> Array:
    """Rotations in which each parent of a moving joint points at where its children are."""
    rotations = motion.rotations.copy()
    for parent in np.unique(motion.parents[moving]):
        children = np.flatnonzero(motion.parents == parent)
        children = children[np.linalg.norm(offsets[children], axis=-1) > 0]
        turn = _best_turn(offsets[children], motion.positions[:, children])
        rotations[:, parent] = multiply(rotations[:, parent], turn)
        below = np.flatnonzero(motion.parents == parent)
        rotations[:, below] = multiply(conjugate(turn)[:, None], rotations[:, below])
    return make_continuous(rotations)


def _best_turn(offsets: Array, positions: Array) -> Array:
    """(T, 4) turns that bring (K, 3) offsets nearest to (T, K, 3) positions (Kabsch, 1976)."""
    if not len(offsets):
        return np.tile([1.0, 0.0, 0.0, 0.0], (len(positions), 1))
    if len(offsets) == 1:
        length = np.maximum(np.linalg.norm(positions[:, 0], axis=-1, keepdims=True), 1e-12)
        direction = offsets[0] / np.linalg.norm(offsets[0])
        return between(np.broadcast_to(direction, positions[:, 0].shape), positions[:, 0] / length)
    u, _, vt = np.linalg.svd(np.einsum("tki,kj->tij", positions, offsets))
    sign = np.linalg.det(u @ vt)
    u[..., 2] *= sign[:, None]
    return from_matrix(u @ vt)


def _error(motion: LocalMotion, baked: Baked) -> float:
    """Largest distance between the joints' places before and after."""
    places = [motion.positions[:, 0]]
    turns = [motion.rotations[:, 0]]
    wanted, ours = places.copy(), places.copy()
    our_turns = [baked.rotations[:, 0]]
    worst = 0.0
    for joint in range(1, len(motion.parents)):
        parent = motion.parents[joint]
        wanted.append(wanted[parent] + rotate(turns[parent], motion.positions[:, joint]))
        turns.append(multiply(turns[parent], motion.rotations[:, joint]))
        ours.append(ours[parent] + rotate(our_turns[parent], baked.offsets[joint]))
        our_turns.append(multiply(our_turns[parent], baked.rotations[:, joint]))
        worst = max(worst, float(np.linalg.norm(wanted[joint] - ours[joint], axis=-1).max()))
    return worst


def _notes(
    motion: LocalMotion, moving: NDArray[np.bool_], as_written: NDArray[np.bool_]
) -> list[Note]:
    notes = []
    placed = [any(name.endswith("position") for name in joint.channels) for joint in motion.joints]
    root = motion.joints[0]
    if placed[0] and any(root.offset):
        text = f"Position channels replace the OFFSET of “{root.name}”"
        notes.append(Note(text, root.line + 2, f"line {root.line} ff."))
    others = [index for index in range(1, len(placed)) if placed[index]]
    changed = [index for index in others if moving[index] or not as_written[index]]
    if changed:
        line = motion.joints[changed[0]].line
        text = f"Position channels replace the offsets of {counted(len(changed), 'joint')}"
        notes.append(Note(text, line, f"line {line} ff."))
    folded = len([index for index in others if not moving[index]])
    if folded:
        text = "Constant positions folded into the skeleton"
        notes.append(Note(text, motion.joints[others[0]].line, counted(folded, "joint")))
    if moving.any():
        names = ", ".join(motion.joints[index].name for index in np.flatnonzero(moving)[:3])
        more = "" if moving.sum() <= 3 else f" and {moving.sum() - 3} more"
        text = f"Moving positions of {names}{more} turned into rotations of their parents"
        notes.append(Note(text, where=counted(int(moving.sum()), "joint")))
    return notes
