"""Motion graph: clips that can follow each other, and walks through them (Förger, ch. 3.6).

Where two clips look alike and move alike for a moment, the one can go over into the other. The
likeness is that of Kovar, Gleicher & Pighin (2002, Motion Graphs): the distance of the joints'
point clouds over a short window, the one cloud moved on the floor and turned about the vertical
to where it fits best. Written with complex numbers (forward + i·left) the best turn is an argument
and the distance a matrix product, so all pairs of frames are compared at once.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from itertools import product

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import minimum_filter1d
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components, dijkstra

from motion.clip import Clip
from motion.errors import MotionError
from motion.graph_window import Windows

Array = NDArray[np.float64]

_APART = 0.3  # s between two transitions of the same pair of clips, at both ends
_GOOD = 0.5  # of the threshold: below, a transition need not be at a minimum
_SAME = 0.02  # m: a clip whose frames are all that near to each other stands still
_MOST = 2000  # transitions: each is linked with every one that can follow it
_FEWER = 1e-3  # frames that a transition counts more: of two ways as long, that with fewer is taken

Key = tuple[str, int, str, int]  # a transition's source, source frame, target and target frame


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

    @property
    def key(self) -> Key:
        """What tells it from the graph's other transitions."""
        return self.source, self.source_frame, self.target, self.target_frame


@dataclass(frozen=True, eq=False)
class MotionGraph:
    """Clips and the transitions between them; after each of them another can follow, for ever.

    Attributes:
        clips: by name; one skeleton, one frame time.
        transitions: ordered by source, frame and target.
        fade: frames that a cross-fade lasts.
        dead_ends: transitions that were found but left out: the way would end after them, or
            nothing leads to them.
    """

    clips: Mapping[str, Clip]
    transitions: tuple[Transition, ...]
    fade: int
    dead_ends: tuple[Transition, ...] = ()

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
        """Seconds from a frame of a clip to where it is left at last; a cyclic one has no last."""
        found = self.clips[clip]
        if found.cyclic:
            return np.inf
        last = max((t.source_frame for t in self.by_source[clip]), default=-1)
        return (last - frame) * found.frame_time

    @cached_property
    def links(self) -> csr_array:
        """(N, N) frames from the end of one transition to the end of one that can follow it."""
        rows, columns, frames = [], [], []
        place = {transition: index for index, transition in enumerate(self.transitions)}
        for index, transition in enumerate(self.transitions):
            after = transition.target_frame + self.fade
            for wait, follower in self.leaving(transition.target, after):
                rows.append(index)
                columns.append(place[follower])
                frames.append(wait + self.fade + _FEWER)
        count = len(self.transitions)
        return csr_array((frames, (rows, columns)), shape=(count, count), dtype=float)

    def frames_to(self, target: str, lasting: float) -> Mapping[Transition, float]:
        """Frames from the end of each transition until a clip is reached, by the soonest way.

        Args:
            target: name of the clip.
            lasting: s of it that are still to come on arrival.
        """
        key = target, lasting
        if key not in self._frames_to:
            reached = [
                index
                for index, t in enumerate(self.transitions)
                if t.target == target and self.left(target, t.target_frame + self.fade) >= lasting
            ]
            found = np.full(len(self.transitions), np.inf)
            if reached:
                found = dijkstra(self.links.T, indices=reached, min_only=True)
            self._frames_to[key] = dict(zip(self.transitions, found.tolist(), strict=True))
        return self._frames_to[key]

    @cached_property
    def _frames_to(self) -> dict[tuple[str, float], dict[Transition, float]]:
        return {}

    def to_dict(self) -> dict[str, object]:
        """As plain values, for JSON."""
        return {"fade": self.fade, "transitions": [asdict(t) for t in self.transitions]}


def build_graph(
    clips: Mapping[str, Clip],
    *,
    threshold: float = 0.07,
    fade: float = 0.3,
    removed: Collection[Key] = (),
    added: Collection[Key] = (),
) -> MotionGraph:
    """The graph of clips, its transitions at the local minima of their distance.

    Only the largest part in which every transition can be reached from every other is kept.

    Args:
        clips: at least one; one skeleton, one frame time.
        threshold: m, the greatest distance of a transition that is found.
        fade: s, length of the cross-fade, over which clips are compared.
        removed: transitions that are left out though they were found.
        added: transitions that are there whatever their distance.

    Raises:
        MotionError: if the clips do not belong together, an added transition has no place, or
            there are too many.
    """
    step = _common_frame_time(clips)
    frames = max(2, round(fade / step))
    windows = {name: Windows.of(clip, frames) for name, clip in clips.items()}
    search = _Search(windows, threshold, round(_APART / step))
    found = [t for source, target in product(clips, clips) for t in search.between(source, target)]
    ways = {t.key: t for t in found if t.key not in removed}
    ways |= {key: search.at(*key) for key in added}
    if len(ways) > _MOST:
        raise MotionError(
            f"These clips have {len(ways)} transitions; a graph takes up to {_MOST}. Lower the "
            "threshold, or cut long clips shorter."
        )
    order = {name: index for index, name in enumerate(clips)}
    kept = sorted(ways.values(), key=lambda t: (order[t.source], t.source_frame, order[t.target]))
    return _strongly_connected(MotionGraph(dict(clips), tuple(kept), frames))


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
    return MotionGraph(clips, tuple(fitted), graph.fade, graph.dead_ends)


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
    still = graph.frames_to(target, lasting)
    way: list[Transition] = []
    while clip != target or graph.left(clip, frame) < lasting:
        ahead = [(w + graph.fade + _FEWER + still[t], t) for w, t in graph.leaving(clip, frame)]
        frames, chosen = min(ahead, key=lambda one: one[0], default=(np.inf, None))
        if chosen is None or not np.isfinite(frames):
            raise MotionError(f"From frame {frame} of “{clip}” no way leads to “{target}”.")
        way.append(chosen)
        clip, frame = chosen.target, chosen.target_frame + graph.fade
    return way


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

    def at(self, source: str, here: int, target: str, there: int) -> Transition:
        """The transition at a chosen place.

        Raises:
            MotionError: if there is no such place.
        """
        for name, frame in ((source, here), (target, there)):
            if name not in self.windows:
                raise MotionError(f"There is no clip “{name}” among {', '.join(self.windows)}.")
            count = self.windows[name].count
            if not 0 <= frame < count:
                raise MotionError(
                    f"A transition of “{name}” can begin at the frames 0 to {count - 1}, "
                    f"not at {frame}: the cross-fade has to end before the clip does."
                )
        one, other = self.windows[source], self.windows[target]
        turn, shift = one.alignment(other, here, there)
        return Transition(
            source, here, target, there, turn, shift, one.distance(other, here, there)
        )

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
    kept = np.zeros(len(ways), bool)
    if graph.links.nnz:
        _, parts = connected_components(graph.links, directed=True, connection="strong")
        kept = parts == np.bincount(parts).argmax()
    inside, outside = (
        tuple(t for t, one in zip(ways, kept, strict=True) if one == chosen)
        for chosen in (True, False)
    )
    return replace(graph, transitions=inside, dead_ends=outside)
