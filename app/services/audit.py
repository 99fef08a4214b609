"""The audit trail: who did what with a study, told in sentences.

What changes a study calls `note` in the same transaction, so that neither stands without the other.
"""

from __future__ import annotations

import uuid
from datetime import timedelta
from typing import Any

from sqlalchemy.orm import Session

from app.persistence import audit
from app.persistence.audit import AuditRow
from app.persistence.models import AuditEntry, now
from app.schemas.live import AuditLine, AuditTrail

PAGE = 50
# Act to sentence; `{…}` is filled in from the entry's detail.
ACTS = {
    "study_created": "made the study",
    "study_duplicated": "made the study as a copy of “{source}”",
    "draft_saved": "changed the draft",
    "draft_discarded": "gave the draft up",
    "published": "published version {number}",
    "state_changed": "set the study to “{state}”",
    "running_changed": "changed how the study is run",
    "links_made": "made {count} personal links",
    "member_added": "made {email} {role}",
    "member_changed": "made {email} {role} instead of {before}",
    "member_removed": "took {email} out of the study",
    "session_excluded": "left participant {name} out: {reason}",
    "session_included": "counted participant {name} again",
    "session_flagged": "marked participant {name}: {reason}",
    "session_unflagged": "took the mark off participant {name}",
    "session_deleted": "deleted participant {name} and every answer of theirs",
    "session_exported": "downloaded all that is stored of participant {name}",
    "impressions_cut": "set the analysis of “{part}” to pairs with μ* from {least_peak} and σ̄ up "
    "to {most_spread}, in {clusters} clusters",
    "cluster_named": "called the cluster of {pair} in “{part}” “{name}”",
    "cluster_unnamed": "took the name “{name}” off the cluster of {pair} in “{part}”",
    "pair_moved": "moved {pair} of “{part}” into the cluster of {to} by hand",
    "pair_moved_back": "put {pair} of “{part}” back into the cluster that the tree has it in",
    "space_made": "made the authoring space “{name}”, version {number}, of “{part}”",
    "space_deleted": "deleted the authoring space “{name}”, version {number}",
    "session_expired": "deleted participant {name}: {days} days had passed since the last answer",
}


def note(
    db: Session,
    study_id: int,
    act: str,
    researcher_id: int | None = None,
    session_id: uuid.UUID | None = None,
    *,
    unless_within: timedelta | None = None,
    **detail: Any,  # noqa: ANN401 -- whatever JSON holds
) -> None:
    """Write down that something was done; the commit is the caller's.

    Args:
        db: where the change itself is being made.
        study_id: of which study.
        act: one of `ACTS`.
        researcher_id: who; None for what the server or a participant did.
        session_id: the participant that it was about.
        unless_within: no new entry if the newest is the same act by the same researcher and this
            young; for what a page saves with every key stroke.
        detail: what the act's sentence needs.
    """
    if unless_within is not None:
        last = audit.newest(db, study_id)
        same = last and (last.act, last.researcher_id) == (act, researcher_id)
        if last and same and now() - last.at < unless_within:
            return
    audit.add(
        db,
        AuditEntry(
            study_id=study_id,
            researcher_id=researcher_id,
            session_id=session_id,
            act=act,
            detail=detail,
        ),
    )


def trail(
    db: Session, study_id: int, before: int | None = None, session_id: uuid.UUID | None = None
) -> AuditTrail:
    """A page of the trail, the newest first; `older` asks for the next one."""
    rows = audit.listed(db, study_id, before=before, limit=PAGE + 1, session_id=session_id)
    shown = rows[:PAGE]
    return AuditTrail(
        entries=[_line(row) for row in shown],
        older=shown[-1].id if len(rows) > PAGE else None,
    )


def _line(row: AuditRow) -> AuditLine:
    return AuditLine(
        id=row.id,
        at=row.at,
        who=row.researcher or "The server",
        act=row.act,
        sentence=_sentence(row.act, row.detail),
        session_id=row.session_id,
    )


def _sentence(act: str, detail: dict[str, Any]) -> str:
    words = ACTS.get(act, act.replace("_", " "))
    for name, value in detail.items():  # not str.format: the details are strangers' texts
        words = words.replace(f"{{{name}}}", str(value))
    return words
