"""Edits that look at what comes before and after, on clips whose end is their beginning."""

from __future__ import annotations

from dataclasses import replace

from motion.clip import Clip
from motion.graph_window import frames_of


def three_cycles(clip: Clip) -> Clip:
    """A cyclic clip with the cycle before it and the one after, as a clip that is not cyclic."""
    last = clip.frames - 1
    root, rotations = frames_of(clip, -last, 2 * last + 1)
    return replace(clip, root_positions=root, rotations=rotations, cyclic=False)


def middle_cycle(three: Clip) -> Clip:
    """The cyclic clip in the middle of three cycles, its last frame made its first again."""
    last = (three.frames - 1) // 3
    part = slice(last, 2 * last + 1)
    root, rotations = three.root_positions[part].copy(), three.rotations[part].copy()
    rotations[-1] = rotations[0]
    root[-1, 1] = root[0, 1]
    return replace(three, root_positions=root, rotations=rotations, cyclic=True)
