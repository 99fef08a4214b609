"""A study's results: live counts, and of one part every clip on every axis and every choice.

Analysed are the newest answers of complete participants, practice and attention checks left out,
and whom a researcher excluded. The raw answers hold all that is needed to compute every number
again.
"""

from __future__ import annotations

from datetime import datetime, timedelta
from statistics import median

from sqlalchemy.orm import Session

from app.persistence import responses, sessions
from app.persistence.models import Study, now
from app.persistence.responses import Counted
from app.schemas.results import Clip, Counts, PartName, SessionKind, StudyResults
from app.schemas.study import SemanticDifferential, Stimulus
from app.services import matching_results, result_axes, result_choices, result_poles
from app.services.measures import CHOICES
from app.services.result_axes import NEEDED
from app.services.studies import find, running_of
from app.services.versions import Pooled, Version, parts_of, pooled, published
from app.statistics.poles import Against


def results(
    db: Session,
    slug: str,
    against: Against = "others",
    part: str | None = None,
    kind: SessionKind = "participant",
) -> StudyResults:
    """All numbers of the results page.

    Args:
        db: where to read.
        slug: which study.
        against: whether a best clip is compared with its body's other clips, or with all of them.
        part: which of the parts that ask about clips; None for the first.
        kind: whether people's answers are analysed or simulated ones.

    Raises:
        NotFoundError: there is no such study or part, or nothing is published.
    """
    study = find(db, slug)
    versions = published(db, study)
    asked = pooled(versions, part)
    rows = _answers(db, study, asked, kind)
    clips = [_clip(shown) for shown in asked.stimuli]
    ratings = result_axes.rating_array(asked, rows)
    people = len({row.session_id for row in rows})
    newest = next(iter(versions.values()))
    bipolar = isinstance(asked.task, SemanticDifferential)
    return StudyResults(
        slug=slug,
        title=str(newest.definition.title),
        state=study.state,
        study_hash=newest.hash,
        needed=NEEDED,
        participants=people,
        rule=_rule(asked, len(versions)),
        kind=kind,
        simulated=len(sessions.progress(db, study, "simulated")),
        against=against,
        counts=count(db, study, now(), kind),
        parts=[_name(versions, name) for name in parts_of(versions)],
        part=_name(versions, asked.part),
        clips=clips,
        axes=result_axes.axes(asked, clips, ratings),
        choices=result_choices.choices(asked, clips, rows) if asked.task.kind in CHOICES else [],
        poles=result_poles.poles(asked, clips, ratings, against, newest.hash) if bipolar else [],
        matching=matching_results.matching(asked, clips, rows) if people >= NEEDED else None,
        texts=sum(bool(row.answers.get("text")) for row in rows),
    )


def counts(db: Session, slug: str, kind: SessionKind = "participant") -> Counts:
    """How far the participants are at this moment."""
    return count(db, find(db, slug), now(), kind)


def count(db: Session, study: Study, moment: datetime, kind: SessionKind = "participant") -> Counts:
    """How far the participants were at the given moment, which the lease is counted back from."""
    every = sessions.progress(db, study, kind)
    counted = [one for one in every if not one.excluded]
    active = [one for one in counted if one.state == "active"]
    lease = timedelta(minutes=running_of(study).lease_minutes)
    left = [one for one in active if moment - _last_sign(one) > lease]
    complete = [one for one in counted if one.state == "complete"]
    times = [
        (one.completed_at - one.consented_at).total_seconds()
        for one in complete
        if one.completed_at and one.consented_at
    ]
    return Counts(
        complete=len(complete),
        under_way=len(active) - len(left),
        left_early=len(left),
        left_after=sorted(one.answered for one in left),
        ended=sum(one.state in ("screened_out", "failed_attention") for one in counted),
        excluded=len(every) - len(counted),
        withdrawn=sum(one.state == "withdrawn" for one in every),
        answers=responses.count(db, study, kind),
        median_seconds=median(times) if times else None,
    )


def _answers(db: Session, study: Study, asked: Pooled, kind: SessionKind) -> list[Counted]:
    rows = responses.analysed(db, study, asked.part, kind)
    return [row for row in rows if row.version_id in asked.versions]


def _last_sign(progress: sessions.Progress) -> datetime:
    times = [time for time in (progress.last_answer, progress.consented_at) if time]
    return max(times, default=now())


def _clip(shown: Stimulus) -> Clip:
    name = shown.name or shown.clip or ""
    return Clip(
        id=shown.clip or "", name=name, label=str(shown.label or name),
        body=shown.body or "", style=shown.style or "",
    )  # fmt: skip


def _name(versions: dict[int, Version], part: str) -> PartName:
    found = next(
        one for version in versions.values() for one in version.definition.trials if one.id == part
    )
    return PartName(id=part, kind=found.task.kind, question=str(found.task.question))


def _rule(asked: Pooled, versions: int) -> str:
    """Which answers are analysed, in words."""
    told = [
        "Analysed are complete participants only; of each clip the newest answer; practice clips, "
        "attention checks and excluded participants are left out."
    ]
    if versions > 1:
        told.append(f"Versions {', '.join(map(str, sorted(asked.numbers)))} are taken together.")
    if asked.apart:
        numbers = ", ".join(map(str, sorted(asked.apart)))
        told.append(f"Answers to version {numbers}, which asked otherwise, are in the exports.")
    return " ".join(told)
