"""A walk through a motion graph as one clip."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from motion.clip import Clip
from motion.errors import MotionError
from motion.graph import MotionGraph, Transition
from motion.graph_blend import Frames, Placement, Side, blend
from motion.graph_window import frames_of
from motion.rotations import make_continuous


def play(
    graph: MotionGraph,
    clip: str,
    way: Sequence[Transition],
    *,
    start: int = 0,
    stop: int | None = None,
) -> Clip:
    """The motion along a way through the graph.

    While two clips cross-fade a planted foot may still slide by a few millimetres;
    ``repair_feet(clip, clip)`` makes it stand.

    Args:
        graph: clips and transitions.
        clip: name of the first clip, played in its own place.
        way: transitions in the order in which they are taken.
        start: frame of the first clip.
        stop: frames of the last clip that are played, counted from its own first one; None for
            all, of a cyclic clip to the end of its cycle.

    Raises:
        MotionError: naming the first transition that cannot be taken where the way has led.
    """
    pieces: list[Frames] = []
    here, at, placement = clip, start, Placement()
    for index, transition in enumerate(way):
        wait = {t: frames for frames, t in graph.leaving(here, at)}.get(transition)
        if wait is None:
            raise MotionError(
                f"Transition {index} leaves “{transition.source}” at frame "
                f"{transition.source_frame}; the way is in “{here}” at frame {at}."
            )
        leave = at + wait
        source = graph.clips[here]
        pieces.append(placement.apply(frames_of(source, at, leave)))
        after = placement.then(transition.turn, _after_cycles(source, transition, leave))
        old, here, at = Side(source, leave, placement), transition.target, transition.target_frame
        mixed, placement = blend(old, Side(graph.clips[here], at, after), graph.fade)
        pieces.append(mixed)
        at += graph.fade
    last = graph.clips[here]
    end = stop if stop is not None else _end(last, at)
    pieces.append(placement.apply(frames_of(last, at, end)))
    roots, rotations = (np.concatenate(part) for part in zip(*pieces, strict=True))
    return Clip(last.skeleton, roots, make_continuous(rotations), last.frame_time)


def _after_cycles(source: Clip, transition: Transition, leave: int) -> tuple[float, float]:
    """The transition's shift from where a cyclic source has come to after some cycles."""
    if not source.cyclic:
        return transition.shift
    way = leave // (source.frames - 1) * source.travel
    return float(transition.shift[0] + way[0]), float(transition.shift[1] + way[2])


def _end(clip: Clip, frame: int) -> int:
    if not clip.cyclic:
        return clip.frames
    cycle = clip.frames - 1
    return (frame // cycle + 1) * cycle + 1
