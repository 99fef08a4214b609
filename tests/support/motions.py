"""Small motions for tests of the server."""

from __future__ import annotations

from functools import cache

from motion import Clip
from motion.bvh_write import write_bvh
from motion.procedural.library import SampleClip, set_a


@cache
def walks() -> tuple[SampleClip, ...]:
    """The first three samples."""
    return tuple(sample for sample, _ in zip(set_a(), range(3), strict=False))


def walk() -> Clip:
    return walks()[0].clip


@cache
def walk_bvh() -> bytes:
    """A walk as a BVH file, in centimetres."""
    return write_bvh(walk())


@cache
def faulty_bvh() -> bytes:
    """The same with a word in the place of a number, in the tenth frame."""
    lines = walk_bvh().decode().splitlines()
    row = next(i for i, line in enumerate(lines) if line.startswith("Frame Time")) + 10
    words = lines[row].split()
    words[7] = "nonsense"
    lines[row] = " ".join(words)
    return "\n".join(lines).encode()
