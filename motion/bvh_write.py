"""Write a clip as BVH."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.errors import MotionError
from motion.rotations import to_euler
from motion.skeleton import Skeleton

Array = NDArray[np.float64]

CENTIMETRE = 0.01
_ORDER = "ZXY"
_ROTATION_CHANNELS = " ".join(f"{axis}rotation" for axis in _ORDER)
_DECIMALS = 6
_LIMIT = 999_999.0  # six digits before the point
_BLOCK = 1 << 15  # numbers formatted at once


def write_bvh(clip: Clip, *, unit: float = CENTIMETRE) -> bytes:
    """BVH text of a clip: position channels on the root, rotations z, x, y everywhere.

    Args:
        clip: the motion.
        unit: metres that one unit of the file stands for.

    Raises:
        MotionError: if the unit is not positive or too small for the clip's positions.
    """
    if not unit > 0:
        raise MotionError(f"The unit must be above 0 m, not {unit}.")
    header, order = _hierarchy(clip.skeleton, unit)
    header += ["MOTION", f"Frames: {clip.frames}", f"Frame Time: {clip.frame_time!r}", ""]
    positions = clip.root_positions / unit
    if np.abs(positions).max(initial=0.0) > _LIMIT:
        raise MotionError(f"A position of {np.abs(positions).max():.0f} units has too many digits.")
    angles = np.degrees(to_euler(clip.rotations[:, order], _ORDER)).reshape(clip.frames, -1)
    return "\n".join(header).encode() + format_rows(np.hstack([positions, angles]))


def _hierarchy(skeleton: Skeleton, unit: float) -> tuple[list[str], list[int]]:
    """The HIERARCHY part, and the joints in the order in which it opens them."""
    children: list[list[int]] = [[] for _ in skeleton.names]
    for joint, parent in enumerate(skeleton.parents[1:], start=1):
        children[parent].append(joint)
    lines, order = ["HIERARCHY"], []
    stack: list[tuple[int, int, bool]] = [(0, 0, False)]
    while stack:
        joint, depth, closing = stack.pop()
        pad = "\t" * depth
        if closing:
            lines.append(pad + "}")
            continue
        order.append(joint)
        lines += _joint_lines(skeleton, joint, unit, pad)
        lines += _tip_lines(skeleton, joint, unit, pad + "\t", leaf=not children[joint])
        stack.append((joint, depth, True))
        stack += [(child, depth + 1, False) for child in reversed(children[joint])]
    return lines, order


def _joint_lines(skeleton: Skeleton, joint: int, unit: float, pad: str) -> list[str]:
    positions = "6 Xposition Yposition Zposition" if joint == 0 else "3"
    return [
        f"{pad}{'JOINT' if joint else 'ROOT'} {skeleton.names[joint]}",
        pad + "{",
        f"{pad}\tOFFSET {_vector(skeleton.offsets[joint] / unit)}",
        f"{pad}\tCHANNELS {positions} {_ROTATION_CHANNELS}",
    ]


def _tip_lines(skeleton: Skeleton, joint: int, unit: float, pad: str, *, leaf: bool) -> list[str]:
    tips = [site.offset for site in skeleton.end_sites if site.joint == joint]
    if leaf and not tips:
        tips = [(0.0, 0.0, 0.0)]  # many readers insist on an End Site at the end of a chain
    lines = []
    for offset in tips:
        vector = _vector(np.array(offset) / unit)
        lines += [f"{pad}End Site", pad + "{", f"{pad}\tOFFSET {vector}", pad + "}"]
    return lines


def _vector(values: Array) -> str:
    return " ".join(f"{value:.9g}" for value in values.tolist())


def format_rows(values: Array) -> bytes:
    """Text of (T, C) numbers below 10⁶ in size, six decimals, one line a row.

    Works on whole blocks: every number becomes a field of fixed width, made of groups of three
    digits looked up in a table; what a number does not need is zero bytes, left out at the end.
    """
    if not values.size:
        return b""
    scaled = np.rint(np.abs(values) * 10**_DECIMALS).astype(np.int64).ravel()
    negative = (values < 0).ravel() & (scaled > 0)
    last = np.zeros(values.shape, bool)
    last[:, -1] = True
    separators = np.where(last.ravel(), ord("\n"), ord(" ")).astype(np.uint8)
    parts = [
        _format_block(scaled[part], negative[part], separators[part])
        for part in (slice(start, start + _BLOCK) for start in range(0, len(scaled), _BLOCK))
    ]
    return b"".join(parts)


def _digit_groups() -> NDArray[np.uint8]:
    """(3, 1000, 3) digits of 0 … 999: in full; bare before the point; nothing for 0."""
    full = np.array([list(b"%03d" % number) for number in range(1000)], np.uint8)
    bare = np.array([list((b"%d" % number).rjust(3, b"\0")) for number in range(1000)], np.uint8)
    empty = bare.copy()
    empty[0] = 0
    return np.stack([full, bare, empty])


_GROUPS = _digit_groups()


def _format_block(
    scaled: NDArray[np.int64], negative: NDArray[np.bool_], separators: NDArray[np.uint8]
) -> bytes:
    whole, decimals = np.divmod(scaled, 10**_DECIMALS)
    high, low = np.divmod(whole, 1000)
    first, second = np.divmod(decimals, 1000)
    fields = np.empty((len(scaled), 15), np.uint8)
    fields[:, 0] = np.where(negative, ord("-"), 0)
    fields[:, 1:4] = _GROUPS[2, high]
    fields[:, 4:7] = _GROUPS[(high == 0).astype(np.intp), low]
    fields[:, 7] = ord(".")
    fields[:, 8:11] = _GROUPS[0, first]
    fields[:, 11:14] = _GROUPS[0, second]
    fields[:, 14] = separators
    return fields.tobytes().translate(None, b"\0")
