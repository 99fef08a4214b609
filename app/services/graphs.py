"""Motion graphs: kept under a name, looked at, and walked through.

Motions are computed in a process of ``app.workers``; see ``graph_motion``.
"""

from __future__ import annotations

import uuid
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError, NotFoundError
from app.persistence import graphs
from app.persistence.engine import Database
from app.persistence.models import ClipRecord, GraphRecord
from app.persistence.studies import sample_clips
from app.persistence.writer import Writer
from app.schemas.graphs import (
    GraphClip,
    GraphDetail,
    GraphList,
    GraphRequest,
    GraphShape,
    GraphTransitions,
    GraphView,
    Piece,
    PlayRequest,
    TransitionKey,
)
from app.services import edits
from app.services.studies import media_url
from app.workers import Workers

if TYPE_CHECKING:  # it brings SciPy, for which the server's start shall not wait
    from app.services.graph_motion import Plan

SAMPLE = "sample"
SAMPLE_SET = "graph"
SAMPLE_NAME = "Stand, walk and turn"
_ORDER = ("stand", "walk", "turn_left", "turn_right")


def listed(db: Session) -> GraphList:
    """The sample, where the library has its clips, and everybody's graphs."""
    sample = _sample(db)
    found = [_view(SAMPLE, sample)] if sample else []
    own = [_view(str(graph.id), _request(graph), graph) for graph in graphs.listed(db)]
    return GraphList(graphs=[*found, *own])


def view(db: Session, graph_id: str) -> GraphView:
    """One graph without its transitions, which take their time."""
    record = _record(db, graph_id)
    return _view(graph_id, _request(record) if record else _known_sample(db), record)


def detail(database: Database, workers: Workers, graph_id: str) -> GraphDetail:
    """A graph with its transitions."""
    with database.reading() as db:
        wanted = _wanted(db, graph_id)
    return _detail(database, workers, graph_id, wanted)


def preview(database: Database, workers: Workers, shape: GraphShape) -> GraphTransitions:
    """The transitions that a graph would have; nothing is stored."""
    from app.services import graph_motion

    found = _computed(database, workers, shape, graph_motion.transitions)
    return GraphTransitions.model_validate(found)


def create(
    database: Database, writer: Writer, workers: Workers, request: GraphRequest
) -> GraphDetail:
    """Keep a graph under a name.

    Raises:
        ConflictError: a clip waits to be confirmed.
        InvalidError: its clips do not belong together.
    """
    preview(database, workers, request)

    def keep(db: Session) -> str:
        _check_clips(db, request)
        record = GraphRecord(name=request.name, definition=_definition(request))
        return str(graphs.add(db, record).id)

    return _detail(database, workers, writer.write(keep), request)


def change(
    database: Database, writer: Writer, workers: Workers, graph_id: str, request: GraphRequest
) -> GraphDetail:
    """Change a graph of one's own.

    Raises:
        ConflictError: it is the sample, or a clip waits to be confirmed.
        InvalidError: its clips do not belong together.
    """
    with database.reading() as db:
        _own(db, graph_id)
    preview(database, workers, request)

    def keep(db: Session) -> None:
        record = _own(db, graph_id)
        _check_clips(db, request)
        record.name, record.definition = request.name, _definition(request)

    writer.write(keep)
    return _detail(database, workers, graph_id, request)


def delete(writer: Writer, graph_id: str) -> None:
    """Delete a graph of one's own; its clips stay."""
    writer.write(lambda db: graphs.delete(db, _own(db, graph_id)))


def play(database: Database, workers: Workers, graph_id: str, request: PlayRequest) -> Piece:
    """The next piece of a steered walk.

    Raises:
        InvalidError: there is no such place, posture or way.
    """
    from app.services import graph_motion

    with database.reading() as db:
        wanted = _wanted(db, graph_id)
    found = _computed(database, workers, wanted, graph_motion.piece, request.model_dump())
    return Piece.model_validate(found)


def _computed(
    database: Database,
    workers: Workers,
    shape: GraphShape,
    function: Callable[..., dict[str, Any] | None],
    *more: Mapping[str, Any],
) -> dict[str, Any]:
    """What a worker makes of a graph; it gets the clips only if it does not know them."""
    plan = _plan(shape)
    key = ",".join(clip for _, clip in plan.clips)
    found = workers.run(key, function, plan, None, *more)
    if found is None:
        found = workers.run(key, function, plan, _contents(database, shape), *more)
    if found is None:
        raise ConflictError("The clips of this graph are being changed.", mend="Try again.")
    return found


def _plan(shape: GraphShape) -> Plan:
    from app.services.graph_motion import Plan

    return Plan(
        clips=tuple(shape.clips.items()),
        threshold=shape.threshold,
        fade=shape.fade,
        removed=frozenset(_key(key) for key in shape.removed),
        added=tuple(_key(key) for key in shape.added),
    )


def _key(key: TransitionKey) -> tuple[str, int, str, int]:
    return key.source, key.source_frame, key.target, key.target_frame


def _contents(database: Database, shape: GraphShape) -> dict[str, bytes]:
    """The bytes of a graph's clips by their id."""
    with database.reading() as db:
        found = _members(db, shape)
        stored = graphs.contents(db, [clip.clip_blob for clip, _ in found.values()])
    return {
        clip.id: stored[clip.clip_blob] for clip, _ in found.values() if clip.clip_blob in stored
    }


def _members(db: Session, shape: GraphShape) -> dict[str, tuple[ClipRecord, str | None]]:
    found = graphs.members(db, shape.clips.values())
    gone = [name for name, clip in shape.clips.items() if clip not in found]
    if gone:
        raise InvalidError(
            f"The library has no clip “{gone[0]}” of this graph any more.",
            code="clip_not_found",
            where={"field": "clips", "name": gone[0]},
            mend="Make a graph of clips that are there.",
        )
    return found


def _check_clips(db: Session, request: GraphRequest) -> None:
    """Whether its clips are still there, and to stay: one may have been deleted meanwhile."""
    for clip, _ in _members(db, request).values():
        edits.source_clip(db, clip.id)


def _detail(
    database: Database, workers: Workers, graph_id: str, request: GraphRequest
) -> GraphDetail:
    with database.reading() as db:
        found = _members(db, request)
    members = [
        GraphClip(
            id=clip,
            name=name,
            frames=found[clip][0].frames,
            frame_time=found[clip][0].frame_time,
            cyclic=found[clip][0].cyclic,
            glb_url=media_url(found[clip][0].glb_blob),
            figure_url=(figure := found[clip][1]) and media_url(figure),
        )
        for name, clip in request.clips.items()
    ]
    kind = "sample" if graph_id == SAMPLE else "own"
    shown = preview(database, workers, request).model_dump()
    return GraphDetail.model_validate(
        {**request.model_dump(), **shown, "id": graph_id, "kind": kind, "members": members}
    )


def _wanted(db: Session, graph_id: str) -> GraphRequest:
    record = _record(db, graph_id)
    return _request(record) if record else _known_sample(db)


def _known_sample(db: Session) -> GraphRequest:
    sample = _sample(db)
    if sample is None:
        raise _not_found()
    return sample


def _sample(db: Session) -> GraphRequest | None:
    """The graph of the sample library's own clips; it has no row, so it is never out of date."""
    clips = {clip.name: clip.id for clip in sample_clips(db, SAMPLE_SET)}
    if not set(_ORDER) <= set(clips):
        return None
    return GraphRequest(name=SAMPLE_NAME, clips={name: clips[name] for name in _ORDER})


def _record(db: Session, graph_id: str) -> GraphRecord | None:
    """The graph's row; none for the sample.

    Raises:
        NotFoundError: there is no such graph.
    """
    if graph_id == SAMPLE:
        return None
    try:
        record = graphs.by_id(db, uuid.UUID(graph_id))
    except ValueError:
        record = None
    if record is None:
        raise _not_found()
    return record


def _own(db: Session, graph_id: str) -> GraphRecord:
    record = _record(db, graph_id)
    if record is None:
        raise ConflictError(
            "The sample graph comes with the server and stays as it is.",
            code="sample_graph",
            mend="Make a copy of it and change that.",
        )
    return record


def _not_found() -> NotFoundError:
    return NotFoundError(
        "There is no such graph.", code="graph_not_found", mend="Look for it under Graphs."
    )


def _request(record: GraphRecord) -> GraphRequest:
    # The order of the clips is part of the graph, and a database may not keep that of an object.
    clips = dict(record.definition["clips"])
    return GraphRequest.model_validate({**record.definition, "clips": clips, "name": record.name})


def _definition(request: GraphRequest) -> dict[str, Any]:
    plain = request.model_dump(exclude={"name"})
    return {**plain, "clips": [list(pair) for pair in request.clips.items()]}


def _view(graph_id: str, request: GraphRequest, record: GraphRecord | None = None) -> GraphView:
    return GraphView(
        id=graph_id,
        name=request.name,
        kind="own" if record else "sample",
        clips=list(request.clips),
        page_url=f"/graphs/{graph_id}",
        created_at=record.created_at if record else None,
    )
