"""Motion graph: clips that can follow each other, and walks through them (Förger, ch. 3.6).

Where two clips look alike and move alike for a moment, the one can go over into the other. The
likeness is that of Kovar, Gleicher & Pighin (2002, Motion Graphs): the distance of the joints'
point clouds over a short window, the one cloud moved on the floor and turned about the vertical
to where it fits best. Written with complex numbers (forward + i·left) the best turn is an argument
and the distance a matrix product, so all pairs of frames are compared at once.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from itertools import product

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import minimum_filter1d
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components

from motion.clip import Clip
from motion.errors import MotionError
from motion.graph_window import Windows

Array = NDArray[np.float64]

_APART = 0.3  # s between two transitions of the same pair of clips, at both ends
_GOOD = 0.5  # of the threshold: below, a transition need not be at a minimum
_SAME = 0.02  # m: a clip whose frames are all that near to each other stands still


@dataclass(frozen=True)
class Transition:
    """A way from one clip into another.

    Attributes:
        source, source_frame: where the one clip is left: its next frames fade out.
        target, target_frame: where the other is entered: from there its frames fade in.
        turn: rad about the vertical, by which the target is turned to follow the source.
        shift: (x, z) m, added after the turn.
        distance: m, mean distance of the two bodies' joints during the cross-fade, their
            velocities counted in.
    """

    source: str
    source_frame: int
    target: str
    target_frame: int
    turn: float
    shift: tuple[float, float]
    distance: float


@dataclass(frozen=True, eq=False)
class MotionGraph:
    """Clips and the transitions between them; after each of them another can follow, for ever.

    Attributes:
        clips: by name; one skeleton, one frame time.
        transitions: ordered by source, frame and target.
        fade: frames that a cross-fade lasts.
    """

    clips: Mapping[str, Clip]
    transitions: tuple[Transition, ...]
    fade: int

    @cached_property
    def by_source(self) -> Mapping[str, tuple[Transition, ...]]:
        """Transitions that leave each clip."""
        return {n: tuple(t for t in self.transitions if t.source == n) for n in self.clips}

    def leaving(self, clip: str, frame: int) -> list[tuple[int, Transition]]:
        """Frames to wait for, and transitions that can be taken, from a frame of a clip on."""
        found = []
        for transition in self.by_source[clip]:
            wait = transition.source_frame - frame
            if self.clips[clip].cyclic:
                wait %= self.clips[clip].frames - 1
            if wait >= 0:
                found.append((wait, transition))
        return found

    def left(self, clip: str, frame: int) -> float:
        """Seconds from a frame of a clip to its end; a cyclic one has none."""
        found = self.clips[clip]
        return np.inf if found.cyclic else (found.frames - 1 - frame) * found.frame_time

    def to_dict(self) -> dict[str, object]:
        """As plain values, for JSON."""
        return {"fade": self.fade, "transitions": [asdict(t) for t in self.transitions]}


def build_graph(
    clips: Mapping[str, Clip], *, threshold: float = 0.07, fade: float = 0.3
) -> MotionGraph:
    """The graph of clips, its transitions at the local minima of their distance.

    Only the largest part in which every transition can be reached from every other is kept.

    Args:
        clips: at least one; one skeleton, one frame time.
        threshold: m, the greatest distance of a transition.
        fade: s, length of the cross-fade, over which clips are compared.

    Raises:
        MotionError: if the clips do not belong together.
    """
    step = _common_frame_time(clips)
    frames = max(2, round(fade / step))
    windows = {name: Windows.of(clip, frames) for name, clip in clips.items()}
    search = _Search(windows, threshold, round(_APART / step))
    found = [t for source, target in product(clips, clips) for t in search.between(source, target)]
    return _strongly_connected(MotionGraph(dict(clips), tuple(found), frames))


def edit_graph(graph: MotionGraph, edit: Callable[[Clip], Clip]) -> MotionGraph:
    """The graph with every clip edited; its transitions stay, fitted to the new motions.

    Args:
        graph: of the original clips.
        edit: changes how a clip is done, not its skeleton, frames or frame time.

    Raises:
        MotionError: if an edit changes what it must not.
    """
    clips = {name: edit(clip) for name, clip in graph.clips.items()}
    _common_frame_time(clips)
    for name, clip in clips.items():
        if clip.frames != graph.clips[name].frames:
            raise MotionError(
                f"The edit gives “{name}” {clip.frames} frames instead of "
                f"{graph.clips[name].frames}: transitions would lose their places."
            )
    windows = {name: Windows.of(clip, graph.fade) for name, clip in clips.items()}
    fitted = []
    for old in graph.transitions:
        one, other = windows[old.source], windows[old.target]
        turn, shift = one.alignment(other, old.source_frame, old.target_frame)
        distance = one.distance(other, old.source_frame, old.target_frame)
        fitted.append(replace(old, turn=turn, shift=shift, distance=distance))
    return MotionGraph(clips, tuple(fitted), graph.fade)


def route(
    graph: MotionGraph, clip: str, frame: int, target: str, *, lasting: float = 2.0
) -> list[Transition]:
    """The transitions that lead soonest from a frame of a clip into the clip ``target``.

    None, where it is there already.

    Args:
        graph: clips and transitions.
        clip: where the way begins.
        frame: in that clip.
        target: the clip to reach.
        lasting: s of the target that are still to come on arrival, if it does not cycle.

    Raises:
        MotionError: if no way leads there.
    """
    for name in (clip, target):
        if name not in graph.clips:
            raise MotionError(f"The graph has no clip “{name}”, only {', '.join(graph.clips)}.")
    waiting: list[tuple[int, int, str, int, list[Transition]]] = [(0, 0, clip, frame, [])]
    seen: set[tuple[str, int]] = set()
    count = 0
    while waiting:
        time, _, here, at, way = heapq.heappop(waiting)
        if here == target and graph.left(here, at) >= lasting:
            return way
        if (here, at) in seen:
            continue
        seen.add((here, at))
        for wait, transition in graph.leaving(here, at):
            count += 1  # of two ways that take as long, the one found first
            after = transition.target_frame + graph.fade
            arrival = (time + wait + graph.fade, count, transition.target, after)
            heapq.heappush(waiting, (*arrival, [*way, transition]))
    raise MotionError(f"From frame {frame} of “{clip}” no way leads to “{target}”.")


def _common_frame_time(clips: Mapping[str, Clip]) -> float:
    if not clips:
        raise MotionError("A motion graph needs at least one clip.")
    first_name, first = next(iter(clips.items()))
    for name, clip in clips.items():
        if clip.skeleton.content_hash != first.skeleton.content_hash:
            raise MotionError(f"“{name}” and “{first_name}” have different skeletons.")
        if not np.isclose(clip.frame_time, first.frame_time):
            raise MotionError(
                f"“{name}” has {1 / clip.frame_time:g} frames a second, “{first_name}” "
                f"{1 / first.frame_time:g}: resample one of them."
            )
    return first.frame_time


@dataclass(frozen=True, eq=False)
class _Search:
    """Looks for transitions.

    Attributes:
        windows: of each clip.
        threshold: m.
        apart: frames between two transitions of the same pair of clips.
    """

    windows: Mapping[str, Windows]
    threshold: float
    apart: int

    def between(self, source: str, target: str) -> Iterator[Transition]:
        """The transitions from one clip into another, or within one."""
        one, other = self.windows[source], self.windows[target]
        if one.count == 0 or other.count == 0:
            return
        distance = self._distances(source, target)
        for i, j in np.argwhere(self._lowest(distance, one, other)).tolist():
            turn, shift = one.alignment(other, i, j)
            yield Transition(source, i, target, j, turn, shift, float(distance[i, j]))

    def _distances(self, source: str, target: str) -> Array:
        """(N, M) m; a clip's own neighbouring frames are infinitely far apart."""
        one = self.windows[source]
        distance = one.distances(self.windows[target])
        if source == target:
            frames = np.arange(one.count)
            gap = np.abs(frames[:, None] - frames)
            near = np.minimum(gap, one.count - gap) if one.cyclic else gap
            # Nobody needs a way to where they are, nor within a body that only stands.
            still = np.median(distance) < _SAME
            distance[(near < 2 * self.apart) | still] = np.inf
        return distance

    def _lowest(self, distance: Array, one: Windows, other: Windows) -> NDArray[np.bool_]:
        """(N, M) where transitions are: at local minima, and at any time where likeness is great.

        A valley of the distance has only one lowest place. Where it is flat, such as between
        standing and standing, its whole length is good, and nobody should have to wait.
        """
        size = 2 * self.apart + 1
        valley = minimum_filter1d(
            distance, size, axis=1, mode="wrap" if other.cyclic else "nearest"
        )
        lowest = minimum_filter1d(valley, size, axis=0, mode="wrap" if one.cyclic else "nearest")
        found = (distance == lowest) & (distance < self.threshold)
        rows = slice(None, None, self.apart)
        good = distance[rows] < _GOOD * self.threshold
        found[rows] |= good & (distance[rows] == valley[rows])
        return np.asarray(found)


def _strongly_connected(graph: MotionGraph) -> MotionGraph:
    """The graph without transitions after which the way would end."""
    ways = graph.transitions
    number = {id(transition): index for index, transition in enumerate(ways)}
    pairs = [
        (index, number[id(follower)])
        for index, transition in enumerate(ways)
        for _, follower in graph.leaving(transition.target, transition.target_frame + graph.fade)
    ]
    if not pairs:
        return MotionGraph(graph.clips, (), graph.fade)
    rows, columns = np.array(pairs).T
    links = csr_array((np.ones(len(rows)), (rows, columns)), shape=(len(ways), len(ways)))
    _, parts = connected_components(links, directed=True, connection="strong")
    largest = np.bincount(parts).argmax()
    kept = tuple(t for t, part in zip(ways, parts, strict=True) if part == largest)
    return MotionGraph(graph.clips, kept, graph.fade)
