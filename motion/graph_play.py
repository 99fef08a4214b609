"""A walk through a motion graph as one clip."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from motion.clip import Clip
from motion.errors import MotionError
from motion.graph import MotionGraph, Transition
from motion.graph_window import frames_of
from motion.rotations import (
    from_axis_angle,
    from_directions,
    make_continuous,
    multiply,
    rotate,
    to_directions,
)

Array = NDArray[np.float64]
Frames = tuple[Array, Array]  # root positions (n, 3), rotations (n, J, 4)

_UP = np.array([0.0, 1.0, 0.0])


@dataclass(frozen=True)
class Placement:
    """Where on the floor a clip is played.

    Attributes:
        turn: rad about the vertical.
        shift: (x, z) m, after the turn.
    """

    turn: float = 0.0
    shift: tuple[float, float] = (0.0, 0.0)

    def then(self, transition: Transition) -> Placement:
        """Where the transition's target is played, if its source is played here."""
        x, _, z = self._place(np.array([transition.shift[0], 0.0, transition.shift[1]]))
        return Placement(self.turn + transition.turn, (float(x), float(z)))

    def apply(self, frames: Frames) -> Frames:
        """The frames, moved there."""
        positions, rotations = frames
        moved = rotations.copy()
        moved[:, 0] = multiply(from_axis_angle(_UP, self.turn), rotations[:, 0])
        return self._place(positions), moved

    def _place(self, points: Array) -> Array:
        shift = np.array([self.shift[0], 0.0, self.shift[1]])
        return rotate(from_axis_angle(_UP, self.turn), points) + shift


def play(
    graph: MotionGraph,
    clip: str,
    way: Sequence[Transition],
    *,
    start: int = 0,
    stop: int | None = None,
) -> Clip:
    """The motion along a way through the graph.

    While two clips cross-fade a planted foot may slide by up to 3 cm; ``repair_feet(clip, clip)``
    makes it stand.

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
        wait = {id(t): frames for frames, t in graph.leaving(here, at)}.get(id(transition))
        if wait is None:
            raise MotionError(
                f"Transition {index} leaves “{transition.source}” at frame "
                f"{transition.source_frame}; the way is in “{here}” at frame {at}."
            )
        leave = at + wait
        pieces.append(placement.apply(frames_of(graph.clips[here], at, leave)))
        old = placement.apply(frames_of(graph.clips[here], leave, leave + graph.fade))
        placement = placement.then(_after_cycles(graph, transition, leave))
        here, at = transition.target, transition.target_frame
        new = placement.apply(frames_of(graph.clips[here], at, at + graph.fade))
        pieces.append(_cross_fade(old, new))
        at += graph.fade
    last = graph.clips[here]
    end = stop if stop is not None else _end(last, at)
    pieces.append(placement.apply(frames_of(last, at, end)))
    roots, rotations = (np.concatenate(part) for part in zip(*pieces, strict=True))
    return Clip(last.skeleton, roots, make_continuous(rotations), last.frame_time)


def _after_cycles(graph: MotionGraph, transition: Transition, leave: int) -> Transition:
    """The transition from where a cyclic source has come to after some cycles."""
    source = graph.clips[transition.source]
    if not source.cyclic:
        return transition
    way = leave // (source.frames - 1) * source.travel
    x, z = transition.shift
    moved = (float(x + way[0]), float(z + way[2]))
    return replace(transition, shift=moved)


def _end(clip: Clip, frame: int) -> int:
    if not clip.cyclic:
        return clip.frames
    cycle = clip.frames - 1
    return (frame // cycle + 1) * cycle + 1


def _cross_fade(old: Frames, new: Frames) -> Frames:
    """From the one motion into the other, with no corner at either end."""
    count = len(old[0])
    t = (np.arange(count) + 1.0) / (count + 1.0)
    share = t * t * (3.0 - 2.0 * t)
    roots = old[0] + share[:, None] * (new[0] - old[0])
    before, after = to_directions(old[1]), to_directions(new[1])
    directions = before + share[:, None, None] * (after - before)
    return roots, from_directions(directions)
