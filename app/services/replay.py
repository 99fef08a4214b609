"""One participant's way through a study: order, answers, times, and what was seen."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.errors import NotFoundError
from app.persistence import live as store
from app.persistence import studies
from app.persistence.models import Response, StudySession
from app.persistence.studies import Media
from app.schemas.live import Kind, ReplayFigure, ReplayStep, SessionDetail, ToldAnswer, Viewed
from app.schemas.study import AnyPart, StudyDefinition, Trials
from app.services import audit, live
from app.services.live_numbers import spoken
from app.services.measures import EACH_FIGURE, Measure, measures, shown_in
from app.services.plans import PAUSE, Step, planned_steps
from app.services.rights import Access
from app.services.studies import definition_of, media_url

# Member of the record, how it is called, and how its number is told.
VIEWED = (
    ("viewing_ms", "watched", "ms"),
    ("plays", "plays", ""),
    ("camera_moves", "turns of the view", ""),
    ("hidden_ms", "out of sight", "ms"),
    ("blur_count", "window left", ""),
    ("dropped_frames", "late frames", ""),
)


def replay(db: Session, access: Access, session_id: UUID) -> SessionDetail:
    """A session, step by step.

    Raises:
        NotFoundError: no such session, or a withdrawn one, of which nothing is left.
    """
    session = find(db, access, session_id)
    kind: Kind = "simulated" if session.kind == "simulated" else "participant"
    line = live.session_line(db, session.study, session_id, kind)
    if line is None or session.state == "withdrawn":
        raise no_such_session()
    definition = definition_of(session.version)
    rows = store.answers_of(db, session_id)
    return SessionDetail(
        study=session.study.title,
        session=line,
        version=session.version.number,
        slot=session.slot,
        seed=session.seed,
        consented_at=session.consented_at,
        completed_at=session.completed_at,
        steps=_steps(db, definition, session, rows),
        trail=audit.trail(db, access.study_id, session_id=session_id).entries,
    )


def find(db: Session, access: Access, session_id: UUID, *, lock: bool = False) -> StudySession:
    """A session of the study.

    Raises:
        NotFoundError: the study has none of this id.
    """
    session = store.session_of(db, access.study_id, session_id, lock=lock)
    if session is None:
        raise no_such_session()
    return session


def no_such_session() -> NotFoundError:
    """What to raise for a participant that is not there, or not any more."""
    return NotFoundError(
        "This study has no such participant, or their data are deleted.",
        code="participant_not_found",
        mend="Look for them on the study's live page.",
    )


def _steps(
    db: Session, definition: StudyDefinition, session: StudySession, rows: Sequence[Response]
) -> list[ReplayStep]:
    parts: dict[str, AnyPart] = {part.id: part for part in (*definition.parts, PAUSE)}
    steps = planned_steps(session.plan)
    given: dict[int, list[Response]] = {}
    for row in rows:
        given.setdefault(row.trial_index, []).append(row)
    media = studies.media(db, {clip for step in steps for clip in step.get("clips", ())})
    media |= studies.media(db, _references(definition))
    return [
        _step(index, step, parts[step["part"]], given.get(index, []), media)
        for index, step in enumerate(steps)
    ]


def _step(
    index: int, step: Step, part: AnyPart, rows: Sequence[Response], media: Mapping[str, Media]
) -> ReplayStep:
    newest = rows[-1] if rows else None
    names = _names(part)
    clips = list(step.get("clips", ()))
    if "x" in step:
        clips.append(clips[step["x"]])
    figures = [_figure(clip, names, media) for clip in clips]
    reference = getattr(part.task, "reference", None) if isinstance(part, Trials) else None
    record = newest.record if newest else {}
    return ReplayStep(
        index=index,
        part=part.id,
        kind=part.task.kind if isinstance(part, Trials) else part.kind,
        title=_title(part),
        note=_note(step, newest),
        figures=figures,
        reference=_figure(reference, names, media) if reference else None,
        answered=newest is not None,
        answers=_told(part, newest, [figure.name for figure in figures]) if newest else [],
        comment=newest.comment if newest else "",
        changed=max(0, len(rows) - 1),
        rt_ms=newest.rt_ms if newest else None,
        at=newest.received_at if newest else None,
        viewed=_viewed(record) if clips else [],
        camera=record.get("camera") or [],
    )


def _title(part: AnyPart) -> str:
    if isinstance(part, Trials):
        return str(part.task.question)
    return str(part.question if part.kind == "comment" else part.heading)


def _note(step: Step, newest: Response | None) -> str | None:
    if step.get("practice"):
        return "practice"
    if "check" not in step:
        return None
    held = newest.passed if newest else None
    return "attention check" + ("" if held is None else ", held" if held else ", failed")


def _names(part: AnyPart) -> dict[str, str]:
    shown = shown_in(part) if isinstance(part, Trials) else []
    return {one.clip: str(one.label or one.name or one.clip) for one in shown if one.clip}


def _references(definition: StudyDefinition) -> set[str]:
    found = {getattr(part.task, "reference", None) for part in definition.trials}
    return {clip for clip in found if clip}


def _figure(clip: str, names: Mapping[str, str], media: Mapping[str, Media]) -> ReplayFigure:
    found = media.get(clip)
    return ReplayFigure(
        glb_url=media_url(found.glb) if found else None,
        figure_url=media_url(found.figure) if found and found.figure else None,
        name=names.get(clip, "reference"),
    )


def _told(part: AnyPart, row: Response, names: Sequence[str]) -> list[ToldAnswer]:
    told: list[ToldAnswer] = []
    for measure in measures(part):
        if measure.trial_type in EACH_FIGURE:
            told += [
                ToldAnswer(label=name, value=_value(measure, measure.read(row.answers, names, at)))
                for at, name in enumerate(names)
            ]
        else:
            value = measure.read(row.answers, names)
            told.append(ToldAnswer(label=_label(measure), value=_value(measure, value)))
    return told


def _label(measure: Measure) -> str:
    if measure.left and measure.trial_type in ("semantic_differential", "analogue"):
        return f"{measure.left} – {measure.right}"
    if measure.id == "choice":
        return "chosen"
    return measure.title


def _value(measure: Measure, value: Any) -> str:  # noqa: ANN401 -- whatever was answered
    if value is None:
        return "no answer"
    word = dict(measure.levels).get(value)
    if isinstance(value, str):
        return word or value
    number = f"{value:g}".replace("-", "\u2212")
    if measure.trial_type == "semantic_differential" and value > 0:
        number = f"+{number}"
    return number if word is None else f"{word} ({number})"


def _viewed(record: Mapping[str, Any]) -> list[Viewed]:
    return [
        Viewed(label=label, value=_length(record[name]) if unit else f"{record[name]:g}")
        for name, label, unit in VIEWED
        if record.get(name) is not None
    ]


def _length(ms: float) -> str:
    return f"{ms / 1000:.1f} s" if ms < 60_000 else spoken(ms / 1000)
