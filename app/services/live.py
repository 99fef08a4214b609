"""What a study looks like while it runs.

Numbers come from indexes and summaries (`app.services.summaries`), so that a page of a million
answers opens at once.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import datetime, timedelta
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.persistence import live as store
from app.persistence import studies, study_versions
from app.persistence.live import Limits, Line, Scope, Seen
from app.persistence.models import SessionSummary, Study, now
from app.schemas.live import ClipCount, Kind, LiveView, Mark, PartStart, SessionLine, SessionList
from app.schemas.study import StudyDefinition
from app.services import live_numbers
from app.services.plans import planned_steps
from app.services.rights import Access
from app.services.studies import definition_of, running_of
from app.services.summaries import places
from app.services.suspicions import Numbers, limits, suspicions

LISTED = 25


def overview(db: Session, access: Access, kind: Kind = "participant", page: int = 1) -> LiveView:
    """All that the live page shows.

    Args:
        db: where to read.
        access: whose study.
        kind: participants, or simulated ones.
        page: of the list of all sessions, from 1.
    """
    study = studies.by_id(db, access.study_id)
    running, scope = running_of(study), Scope(study.id, kind)
    since = now() - timedelta(minutes=running.lease_minutes)
    totals, active = store.totals(db, scope), store.active(db, scope, since)
    seen = store.seen(db, scope)
    definitions = _definitions(db, study)
    newest = next(iter(definitions.values()), None)
    counts = live_numbers.counts(totals, active, seen, store.excluded_count(db, scope))
    clips = _clips(seen, definitions)
    groups = _groups(newest)
    lists = _lists(db, scope, since, groups, page)
    begun = sum(one.sessions for one in totals if one.state != "withdrawn")
    return LiveView(
        slug=study.slug,
        title=study.title,
        state=study.state,
        kind=kind,
        quota=running.quota if kind == "participant" else None,
        lease_minutes=running.lease_minutes,
        counts=counts,
        groups=live_numbers.by_group(totals, active, groups),
        dropout=live_numbers.dropout(counts.complete, active, seen, _parts(db, scope, definitions)),
        durations=live_numbers.durations(store.durations(db, scope)),
        clips=clips,
        clips_sentence=live_numbers.clips_sentence(clips),
        suspicious=lists[0],
        marked=lists[1],
        latest=lists[2].model_copy(update={"total": begun + counts.excluded}),
    )


def session_line(db: Session, study: Study, session_id: UUID, kind: Kind) -> SessionLine | None:
    """One session as lists show it; None for one that is not there."""
    lease = timedelta(minutes=running_of(study).lease_minutes)
    limit = _limits(db, Scope(study.id, kind))
    groups = _groups(next(iter(_definitions(db, study).values()), None))
    found = store.lines(db, [session_id]).get(session_id)
    return found and _line(found, limit, groups, now() - lease)


def session_name(session_id: UUID) -> str:
    """The first digits of a session's id, by which people tell participants apart."""
    return session_id.hex[:8]


def mark(stored: dict[str, Any] | None) -> Mark | None:
    """A mark as it is kept in the session's row."""
    return None if stored is None else Mark.model_validate(stored)


def _lists(
    db: Session, scope: Scope, since: datetime, groups: Mapping[str, str], page: int
) -> tuple[SessionList, SessionList, SessionList]:
    """Suspicious sessions, those marked by hand, and a page of all."""
    limit = _limits(db, scope)
    total, suspicious = store.suspicious(db, scope, limit, LISTED)
    marked = store.marked(db, scope, LISTED)
    latest = store.latest(db, scope, LISTED, LISTED * (page - 1))
    known = store.lines(db, {*suspicious, *marked, *latest})

    def listed(total: int, ids: Sequence[UUID]) -> SessionList:
        found = [_line(known[one], limit, groups, since) for one in ids if one in known]
        return SessionList(total=total, sessions=found)

    return listed(total, suspicious), listed(len(marked), marked), listed(len(latest), latest)


def _limits(db: Session, scope: Scope) -> Limits:
    paces = store.paces(db, scope)
    usual = live_numbers.quantile(paces, 0.5) if paces else None
    return limits(usual, sum(count for _, count in paces))


def _line(line: Line, limit: Limits, groups: Mapping[str, str], since: datetime) -> SessionLine:
    summary = line.summary
    going = (summary.last_at if summary else line.began) >= since
    return SessionLine(
        id=line.id,
        name=session_name(line.id),
        state=line.state,
        stands=live_numbers.stands(line.state, going),
        group=groups.get(line.group, line.group) if line.group else None,
        language=line.language,
        device=line.device,
        source=line.source,
        began=line.began,
        answered=summary.answered if summary else 0,
        steps=summary.steps if summary else 0,
        seconds=summary.seconds if summary else None,
        suspicions=suspicions(_numbers(summary), limit) if summary else [],
        excluded=mark(line.excluded),
        flag=mark(line.flags),
    )


def _numbers(summary: SessionSummary) -> Numbers:
    return Numbers(*(getattr(summary, name) for name in Numbers._fields))


def _definitions(db: Session, study: Study) -> dict[int, StudyDefinition]:
    """The study's versions, the newest first."""
    return {one.id: definition_of(one) for one in study_versions.versions(db, study)}


def _groups(definition: StudyDefinition | None) -> dict[str, str]:
    return {group.id: group.label for group in definition.groups} if definition else {}


def _parts(
    db: Session, scope: Scope, definitions: Mapping[int, StudyDefinition]
) -> list[PartStart]:
    """Where the parts begin, as long as there is one version."""
    if len(definitions) != 1:
        return []
    ((version, definition),) = definitions.items()
    return live_numbers.part_starts(definition, planned_steps(store.a_plan(db, scope, version)))


def _clips(seen: Sequence[Seen], definitions: Mapping[int, StudyDefinition]) -> list[ClipCount]:
    """How often each clip was judged, those of the newest version first."""
    known = {version: list(places(one)) for version, one in definitions.items()}
    labels: dict[str, str] = {}
    for definition in definitions.values():
        for part in definition.trials:
            for shown in part.stimuli:
                if shown.clip is not None:
                    labels.setdefault(shown.clip, str(shown.label or shown.name or shown.clip))
    return live_numbers.clip_counts(seen, known, labels)
