"""Steering a character through a motion graph, piece by piece (Förger, ch. 3.6).

Each piece begins where the one before has led. How the character moves may change between them.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import lru_cache

from motion.clip import Clip
from motion.editing.grid import cached_nine_motions
from motion.editing.posture import PostureOffset, add_posture
from motion.errors import MotionError
from motion.graph import Key, MotionGraph, Transition, route
from motion.graph_blend import Frames, Placement, Side, blend, fit
from motion.graph_window import frames_of
from motion.procedural.stances import STANCES, stance

_LASTING = 2.0  # s of a clip that should still be to come when it is reached


@dataclass(frozen=True)
class Manner:
    """How a character moves.

    Attributes:
        path: 0 shorter, 1 as is, 2 longer.
        timing: 0 even speed, 1 as is, 2 added acceleration.
        postures: names of stances and how much of each is added, −2 … 2.
    """

    path: float = 1.0
    timing: float = 1.0
    postures: tuple[tuple[str, float], ...] = ()


@dataclass(frozen=True)
class Place:
    """Where a steered character is: its next frame.

    Attributes:
        clip, frame: that frame.
        placement: where on the floor the clip is played.
        manner: how it is done.
    """

    clip: str
    frame: int = 0
    placement: Placement = field(default_factory=Placement)
    manner: Manner = field(default_factory=Manner)


@dataclass(frozen=True, eq=False)
class Piece:
    """A short stretch of motion.

    Attributes:
        frames: root positions (n, 3) and rotations (n, J, 4).
        after: where it leads.
        blended: the whole piece is one cross-fade; else it is a stretch of one clip.
        taken: the transition that it is, if it is one.
        ahead: the next transition on the way to what is wanted.
        wait: frames from the piece's end until that one is left.
        reaches: frames from the piece's end until the wanted clip is reached.
    """

    frames: Frames
    after: Place
    blended: bool
    taken: Transition | None
    ahead: Transition | None
    wait: int
    reaches: int


@lru_cache(maxsize=64)
def in_manner(clip: Clip, manner: Manner) -> Clip:
    """The clip done like that; the last ones are kept.

    Raises:
        MotionError: if a posture is unknown, or the skeleton lacks the body's roles.
    """
    moved = clip
    if (manner.path, manner.timing) != (1.0, 1.0):
        moved = cached_nine_motions(clip).at(manner.path, manner.timing)
    return add_posture(moved, [(_offset(name), amount) for name, amount in manner.postures])


def next_piece(
    graph: MotionGraph,
    place: Place,
    target: str,
    manner: Manner,
    frames: int,
    *,
    via: Key | None = None,
) -> Piece:
    """The motion from a place on the way to a clip.

    A changed manner fades in: over a transition if one comes soon, else within the clip.

    Args:
        graph: of the unedited clips.
        place: where the character is.
        target: the clip that is wanted.
        manner: how it shall move.
        frames: length of the piece, at the most; a cross-fade lasts as long as it does.
        via: a transition that shall be taken whatever the way, when it comes.

    Raises:
        MotionError: if no way leads there.
    """
    way = _way(graph, place, target, via)
    wait = _wait(graph, place, way[0]) if way else _stay(graph, place)
    if way and wait == 0:
        piece = _cross(graph, place, way[0], manner)
        way = way[1:]
    elif manner != place.manner and wait >= graph.fade:
        piece = _cross(graph, place, None, manner)
    else:
        piece = _straight_on(graph, place, min(frames, wait))
    return _with_outlook(graph, piece, way)


def _way(graph: MotionGraph, place: Place, target: str, via: Key | None) -> list[Transition]:
    if via is None:
        return route(graph, place.clip, place.frame, target, lasting=_lasting(graph, target))
    chosen = [t for _, t in graph.leaving(place.clip, place.frame) if t.key == via]
    if not chosen:
        raise MotionError(
            f"From frame {place.frame} of “{place.clip}” the graph has no transition at frame "
            f"{via[1]} of “{via[0]}” to frame {via[3]} of “{via[2]}”."
        )
    return chosen


def _lasting(graph: MotionGraph, target: str) -> float:
    """Seconds of the target that shall be to come: of a short clip, its greater part."""
    return min(_LASTING, 0.5 * graph.left(target, 0)) if target in graph.clips else _LASTING


def _wait(graph: MotionGraph, place: Place, transition: Transition) -> int:
    return next(w for w, t in graph.leaving(place.clip, place.frame) if t is transition)


def _stay(graph: MotionGraph, place: Place) -> int:
    """Frames that the character can stay in its clip until the last transition leaves it."""
    clip = graph.clips[place.clip]
    left = graph.left(place.clip, place.frame)
    return clip.frames if clip.cyclic else max(1, round(left / clip.frame_time))


def _straight_on(graph: MotionGraph, place: Place, count: int) -> Piece:
    clip = in_manner(graph.clips[place.clip], place.manner)
    stop = place.frame + count
    frames = place.placement.apply(frames_of(clip, place.frame, stop))
    after = _within_cycle(clip, replace(place, frame=stop))
    return Piece(frames, after, False, None, None, 0, 0)


def _cross(
    graph: MotionGraph, place: Place, transition: Transition | None, manner: Manner
) -> Piece:
    """Over into another clip, or into the same one done differently."""
    name, enter = (
        (transition.target, transition.target_frame) if transition else (place.clip, place.frame)
    )
    source = in_manner(graph.clips[place.clip], place.manner)
    target = in_manner(graph.clips[name], manner)
    turn, shift = fit(source, place.frame, target, enter, graph.fade)
    old = Side(source, place.frame, place.placement)
    new = Side(target, enter, place.placement.then(turn, shift))
    frames, placement = blend(old, new, graph.fade)
    after = _within_cycle(target, Place(name, enter + graph.fade, placement, manner))
    return Piece(frames, after, True, transition, None, 0, 0)


def _within_cycle(clip: Clip, place: Place) -> Place:
    """The same place, told within the first cycle of a cyclic clip."""
    if not clip.cyclic:
        return place
    cycles, frame = divmod(place.frame, clip.frames - 1)
    placement = place.placement
    travel = placement.place(cycles * clip.travel) - placement.place(0.0 * clip.travel)
    return replace(place, frame=frame, placement=placement.moved(travel))


def _with_outlook(graph: MotionGraph, piece: Piece, way: list[Transition]) -> Piece:
    """The piece with what comes after it."""
    if not way:
        return piece
    wait = _wait(graph, piece.after, way[0])
    clip, frame, reaches = piece.after.clip, piece.after.frame, 0
    for transition in way:
        stands = Place(clip, frame)
        reaches += _wait(graph, stands, transition) + graph.fade
        clip, frame = transition.target, transition.target_frame + graph.fade
    return replace(piece, ahead=way[0], wait=wait, reaches=reaches)


@lru_cache
def _offset(name: str) -> PostureOffset:
    if name not in STANCES:
        raise MotionError(f"There is no stance “{name}”, only {', '.join(STANCES)}.")
    return PostureOffset.between(stance("neutral"), stance(name))
