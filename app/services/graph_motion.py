"""Motion graphs and steering through them, computed in a process of ``app.workers``.

A worker keeps the last graphs. It is asked for by what the graph is made of; only where the worker
does not know it yet are the clips sent along.
"""

from __future__ import annotations

import base64
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from app.errors import InvalidError
from motion import Clip, MotionError
from motion.graph import Key, MotionGraph, Transition, build_graph
from motion.graph_blend import Placement
from motion.graph_steer import Manner, Piece, Place, next_piece
from motion.storage import clip_from_bytes

GRAPHS_KEPT = 6
MOST_FRAMES = 4000  # of all clips of a graph: every frame is compared with every other


@dataclass(frozen=True)
class Plan:
    """What a graph is made of: clips by (name, id), and what its page has set."""

    clips: tuple[tuple[str, str], ...]
    threshold: float
    fade: float
    removed: frozenset[Key]
    added: tuple[Key, ...]


def transitions(plan: Plan, clips: Mapping[str, bytes] | None) -> dict[str, Any] | None:
    """The graph's transitions, as the API tells them; None where the clips are needed first.

    Raises:
        InvalidError: the clips do not belong together, or an added transition has no place.
    """
    with _told():
        graph = _graph(plan, clips)
    if graph is None:
        return None
    added = set(plan.added)
    return {
        "fade_frames": graph.fade,
        "transitions": [
            {**_key(t), "distance": t.distance, "turn": t.turn, "added": t.key in added}
            for t in graph.transitions
        ],
        "dead_ends": len(graph.dead_ends),
    }


def piece(
    plan: Plan, clips: Mapping[str, bytes] | None, request: Mapping[str, Any]
) -> dict[str, Any] | None:
    """The next piece of a steered walk; None where the clips are needed first.

    Raises:
        InvalidError: there is no such place, posture or way.
    """
    with _told():
        graph = _graph(plan, clips)
        if graph is None:
            return None
        wanted = request["via"]
        found = next_piece(
            graph,
            _place(graph, request["place"]),
            request["target"],
            _manner(request["manner"]),
            request["frames"],
            via=tuple(wanted[name] for name in _KEY) if wanted else None,
        )
    return _told_piece(found)


_KEY = ("source", "source_frame", "target", "target_frame")
_graphs: dict[Plan, MotionGraph] = {}
_clips: dict[str, Clip] = {}  # of the graphs that are kept: a grid is known by its clip


def _graph(plan: Plan, contents: Mapping[str, bytes] | None) -> MotionGraph | None:
    """The graph of a plan; the last ones are kept."""
    graph = _graphs.pop(plan, None)
    if graph is None:
        ids = {clip for _, clip in plan.clips}
        known = {clip: _clips[clip] for clip in ids if clip in _clips}
        if contents is not None:
            known |= {k: clip_from_bytes(data) for k, data in contents.items() if k not in known}
        if set(known) != ids:
            return None
        graph = _built(plan, known)
        _clips.update(known)
    _graphs[plan] = graph
    for oldest in list(_graphs)[:-GRAPHS_KEPT]:
        del _graphs[oldest]
    used = {clip for kept in _graphs for _, clip in kept.clips}
    for clip in set(_clips) - used:
        del _clips[clip]
    return graph


def _built(plan: Plan, clips: Mapping[str, Clip]) -> MotionGraph:
    frames = sum(clips[clip].frames for _, clip in plan.clips)
    if frames > MOST_FRAMES:
        raise InvalidError(
            f"These clips have {frames} frames together; a graph takes up to {MOST_FRAMES}.",
            code="graph_too_long",
            mend="Leave out a clip, or cut long ones shorter first.",
        )
    return build_graph(
        {name: clips[clip] for name, clip in plan.clips},
        threshold=plan.threshold,
        fade=plan.fade,
        removed=plan.removed,
        added=plan.added,
    )


def _place(graph: MotionGraph, told: Mapping[str, Any]) -> Place:
    name, frame = told["clip"], told["frame"]
    clip = graph.clips.get(name)
    if clip is None or not (clip.cyclic or frame < clip.frames):
        raise InvalidError(
            f"The graph has no frame {frame} of a clip “{name}”.",
            code="no_such_place",
            where={"field": "place"},
            mend="Begin again at frame 0 of one of its clips: " + ", ".join(graph.clips) + ".",
        )
    placement = Placement(told["turn"], (told["x"], told["z"]))
    return Place(name, frame, placement, _manner(told["manner"]))


def _manner(told: Mapping[str, Any]) -> Manner:
    """Rounded to what a slider can tell apart, so that one that comes again is known."""
    postures = {name: round(amount, 2) for name, amount in told["postures"].items()}
    return Manner(
        round(told["path"], 2),
        round(told["timing"], 2),
        tuple(sorted((name, amount) for name, amount in postures.items() if amount)),
    )


def _key(transition: Transition) -> dict[str, Any]:
    return dict(zip(_KEY, transition.key, strict=True))


def _told_piece(found: Piece) -> dict[str, Any]:
    roots, rotations = found.frames
    count, joints = rotations.shape[:2]
    turned = rotations[..., [1, 2, 3, 0]].reshape(count, -1)
    numbers = np.concatenate([roots, turned], axis=1).astype("<f4")
    after, placement = found.after, found.after.placement
    manner = {**asdict(after.manner), "postures": dict(after.manner.postures)}
    x, z = placement.shift
    return {
        "frames": count,
        "joints": joints,
        "motion": base64.b64encode(numbers.tobytes()).decode(),
        "after": {
            "clip": after.clip,
            "frame": after.frame,
            "turn": placement.turn,
            "x": x,
            "z": z,
            "manner": manner,
        },
        "blended": found.blended,
        "taken": found.taken and _key(found.taken),
        "ahead": found.ahead and _key(found.ahead),
        "wait": found.wait,
        "reaches": found.reaches,
    }


@contextmanager
def _told() -> Iterator[None]:
    """What the clips or a request make impossible is the request's fault, not ours."""
    try:
        yield
    except MotionError as error:
        raise InvalidError(str(error), code="graph_unusable") from error
