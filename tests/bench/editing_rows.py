"""Editing: the nine motions, a grid point, and what edits of long clips cost."""

from __future__ import annotations

import statistics
import time
import tracemalloc
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from motion import Clip
from motion.editing.contacts import accelerate_contacts
from motion.editing.foot_repair import repair_feet
from motion.editing.grid import nine_motions
from motion.editing.path_length import PathLength, change_path_length
from motion.editing.posture import PostureOffset, add_posture
from motion.editing.tempo import resample_rate
from motion.editing.timing import ADDED, Timing, change_timing
from motion.ingest import IngestOptions, ingest
from motion.procedural.stances import stance
from motion.skeleton import Skeleton
from motion.standing import Standing
from tests.bench.measure import RUNS, Row, durations
from tests.bench.motion_rows import MOTIONS

RATE, JOINTS = 100.0, 22
SECONDS = (10, 100, 1000)
BOW = PostureOffset.between(stance("neutral"), stance("head_down"))
CLOSER = PostureOffset.between(stance("neutral"), stance("hands_and_feet_closer"))


def rows(_: Path) -> list[Row]:
    """All rows about editing."""
    clip = walking(SECONDS[0])
    return [*grid(clip), *costs()]


def walking(seconds: int) -> Clip:
    """A walk again and again, at 100 frames a second, of 22 joints."""
    walk = MOTIONS / "bandai-namco" / "walk_normal_001.bvh"
    once = resample_rate(ingest(walk.read_bytes(), IngestOptions()).clip, RATE)
    last = once.frames - 1
    lap, frame = np.divmod(np.arange(round(seconds * RATE) + 1), last)
    missing = JOINTS - len(once.skeleton)
    rest = np.tile([1.0, 0.0, 0.0, 0.0], (len(frame), missing, 1))
    return Clip(
        _with_more(once.skeleton, missing),
        once.root_positions[frame] + lap[:, None] * once.travel * [1.0, 0.0, 1.0],
        np.concatenate([once.rotations[frame], rest], axis=1),
        1.0 / RATE,
    )


def _with_more(skeleton: Skeleton, count: int) -> Skeleton:
    """The skeleton with so many joints more, which hang from its last one."""
    joints = len(skeleton)
    return replace(
        skeleton,
        names=(*skeleton.names, *(f"tip {number}" for number in range(count))),
        parents=np.concatenate([skeleton.parents, np.full(count, joints - 1)]),
        offsets=np.concatenate([skeleton.offsets, np.full((count, 3), 0.02)]),
    )


def grid(clip: Clip) -> list[Row]:
    nine = nine_motions(clip)
    standing = Standing.of(clip)

    def point() -> Clip:
        return add_posture(nine.at(0.4, 1.6), [(BOW, 1.0)], standing)

    what = "10 s, 22 joints, 100 fps"
    return [
        *durations(
            f"Nine motions, {what}", {"Manner": lambda: nine_motions(clip).motions}, aim="≤ 300"
        ),
        *durations(f"Grid point with posture, {what}", {"Manner": point}, aim="≤ 5"),
        *durations(
            f"Grid point, new clip, {what}", {"Manner": lambda: nine_motions(clip).at(0.4, 1.6)}
        ),
    ]


def edits(clip: Clip) -> dict[str, Callable[[], object]]:
    longer = change_path_length(clip, PathLength(1.6))
    return {
        "Path length": lambda: change_path_length(clip, PathLength(1.6)),
        "Foot repair": lambda: repair_feet(clip, longer),
        "Timing": lambda: change_timing(clip, Timing(ADDED)),
        "Contacts": lambda: accelerate_contacts(clip),
        "Posture": lambda: add_posture(clip, [(CLOSER, 1.0)]),
        "Nine motions": lambda: nine_motions(clip).motions,
    }


def costs() -> list[Row]:
    """Time and memory of each edit for each length; three runs of the longest."""
    found: dict[str, list[Row]] = {}
    for seconds in SECONDS:
        runs = 3 if seconds == SECONDS[-1] else RUNS
        for name, edit in edits(walking(seconds)).items():
            aim = "" if seconds == SECONDS[0] else "≤ T log T, memory ≤ T"
            found.setdefault(name, []).extend(_cost(name, f"{seconds} s", edit, runs, aim))
    return [row for group in found.values() for row in group]


def _cost(name: str, who: str, edit: Callable[[], object], runs: int, aim: str) -> list[Row]:
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        edit()
        times.append(1000 * (time.perf_counter() - start))
    tracemalloc.start()  # counts NumPy's arrays as well
    edit()
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    spread = (min(times), max(times))
    return [
        Row(f"{name} of a long clip", who, statistics.median(times), "ms", aim, spread),
        Row(f"{name} of a long clip", who, peak / 1e6, "MB at most"),
    ]
