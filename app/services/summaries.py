"""Keeps one small summary a session, so that a live page need not read a million answers.

A summary is always computed from all answers of its session, never counted on: so it cannot drift,
and a lost one is made again. The keeper makes those that are due every few seconds.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from sqlalchemy.orm import Session

from app.persistence import live
from app.persistence.engine import Database
from app.persistence.writer import Writer
from app.schemas.study import StudyDefinition, Trials
from app.services.plans import planned_steps
from app.services.studies import definition_by_hash
from app.services.suspicions import Judged, measure

WINDOW = 2000  # answers looked through at once
DIGITS = 4  # hexadecimal, of a clip's place


def catch_up(database: Database, writer: Writer, window: int = WINDOW) -> bool:
    """Summarise the sessions of the next answers; whether more wait behind them.

    Answers that come in meanwhile are left for the next time: on a busy server there would be no
    end to it.
    """
    with database.reading() as db:
        found = live.waiting(db, window)
        rows = [_summary(db, asked, found.end) for asked in live.to_summarise(db, found.sessions)]
    if rows:
        writer.write(lambda db: live.put_summaries(db, rows))
    return found.more


def places(definition: StudyDefinition) -> dict[str, int]:
    """The version's clips, each with its place among them."""
    clips = [s.clip for part in definition.parts if isinstance(part, Trials) for s in part.stimuli]
    return {clip: place for place, clip in enumerate(dict.fromkeys(clips)) if clip is not None}


def counted(seen: str) -> dict[int, int]:
    """How often each place stands in summaries that are joined to one string."""
    times = np.bincount(np.frombuffer(bytes.fromhex(seen), ">u2"))
    return {int(place): int(times[place]) for place in np.flatnonzero(times)}


def encode(numbers: Iterable[int]) -> str:
    """Places as a summary keeps them."""
    return "".join(f"{number:0{DIGITS}x}" for number in numbers)


def _summary(db: Session, asked: live.Asked, end: int) -> dict[str, Any]:
    answers = live.newest_answers(db, asked.id)
    trials = [_trial(row) for row in answers if row.clips or row.clip_id]
    known = places(definition_by_hash(db, asked.version_id, asked.definition_hash))
    last_at = max((row.received_at for row in answers), default=asked.began)
    judged = [row for row in answers if not row.practice and row.check is None]
    return {
        "session_id": asked.id,
        "upto": end,
        "steps": len(planned_steps(asked.plan)),
        "answered": len(answers),
        "last_at": last_at,
        "seconds": max(0, round((last_at - asked.began).total_seconds())),
        "seen": encode(known[clip] for row in judged for clip in _clips(row) if clip in known),
        **measure(trials)._asdict(),
    }


def _trial(row: live.Answered) -> Judged:
    return Judged(
        part=row.part,
        answers=row.answers,
        rt_ms=row.rt_ms,
        hidden_ms=row.hidden_ms or 0,
        practice=row.practice,
        check=row.check,
        passed=row.passed,
    )


def _clips(row: live.Answered) -> list[str]:
    if row.clips is not None:
        return list(dict.fromkeys(row.clips))  # X of A/B/X is one of the two
    return [] if row.clip_id is None else [row.clip_id]
