"""A draft becomes a version, which never changes; and who may come to it, and when."""

from __future__ import annotations

import secrets
from collections.abc import Sequence
from typing import Any

from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError
from app.persistence import studies as store
from app.persistence.engine import Database
from app.persistence.models import Study, StudyVersion, now
from app.persistence.writer import Writer
from app.schemas.studies_api import Changes, Invitation, Problem
from app.schemas.study import Running, StudyDefinition
from app.services import audit, drafts, recruiting, rights, studies, study_changes, study_files
from app.services.rights import Access
from app.services.study_stimuli import Make, maker, resolve
from app.workers import Workers


def changes(db: Session, access: Access) -> Changes:
    """What publishing the draft would change.

    Raises:
        InvalidError: the draft is no study yet; where.problems says why.
    """
    study = studies.find(db, access.slug)
    after = _resolved(db, study, lambda requests: None)
    return _changes(store.newest_version(db, study), after)


def publish(database: Database, writer: Writer, workers: Workers, access: Access) -> Changes:
    """Freeze the draft as the next version; one that changes nothing makes none.

    Clips that are to be made are made before anything else is stored.

    Raises:
        InvalidError: the draft is no study yet; where.problems says why.
        ConflictError: it was changed while its clips were being made.
    """
    with database.reading() as db:
        study = studies.find(db, access.slug)
        draft = drafts.content(db, study)
        after = _resolved(db, study, maker(database, writer, workers))
    with database.writing() as db:
        study = studies.find(db, access.slug, lock=True)
        if drafts.content(db, study) != draft:
            raise ConflictError(
                "The draft was changed while it was being published.",
                code="draft_changed",
                mend="Look at the changes and publish again.",
            )
        return _freeze(db, study, after, access.researcher_id)


def _freeze(db: Session, study: Study, after: StudyDefinition, researcher_id: int) -> Changes:
    newest = store.newest_version(db, study)
    told = _changes(newest, after)
    study.draft, study.draft_saved_at = None, now()
    if not told.same:
        db.add(
            StudyVersion(
                study_id=study.id,
                number=told.number,
                definition=after.model_dump(mode="json"),
                definition_hash=told.hash,
                changes=told.changes,
                published_by=researcher_id,
            )
        )
        study.title = after.title
        study.state = "open" if study.state == "draft" else study.state
        audit.note(db, study.id, "published", researcher_id, number=told.number, hash=told.hash)
    db.commit()
    return told


def _changes(newest: StudyVersion | None, after: StudyDefinition) -> Changes:
    before = studies.definition_of(newest) if newest else None
    same = newest is not None and newest.definition_hash == after.content_hash
    number = newest.number if newest else 0
    return Changes(
        number=number if same else number + 1,
        hash=after.content_hash,
        same=same,
        changes=study_changes.sentences(before, after),
    )


def _resolved(db: Session, study: Study, make: Make) -> StudyDefinition:
    """The draft as it would be published.

    Raises:
        InvalidError: it is no study yet.
    """
    draft = drafts.content(db, study)
    problems = drafts.problems(db, study, draft)
    if problems:
        raise unpublishable(draft, problems)
    return resolve(db, StudyDefinition.model_validate(draft), make)


def unpublishable(draft: dict[str, Any], problems: Sequence[Problem]) -> InvalidError:
    """What to raise for a draft with problems."""
    first, others = problems[0], len(problems) - 1
    place = study_files.in_words(draft, tuple(first.where)) or "the study"
    more = f" And {others} more." if others else ""
    return InvalidError(
        f"This cannot be published yet. In {place}: {first.message}{more}",
        code="study_incomplete",
        where={"problems": [problem.model_dump() for problem in problems]},
        mend=first.mend,
    )


def run(db: Session, access: Access, running: Running) -> None:
    """Change who may come, when, and what happens at the end; versions stay as they are.

    Raises:
        ForbiddenError: the retention time is to change, which deletes, by one who is no owner.
    """
    study = studies.find(db, access.slug, lock=True)
    before, after = studies.running_of(study), running
    changed = [
        name for name in Running.model_fields if getattr(before, name) != getattr(after, name)
    ]
    if "retention_days" in changed:
        rights.may(db, study, access.researcher_id, "own")
    if changed:
        study.running = running.model_dump(mode="json")
        audit.note(db, study.id, "running_changed", access.researcher_id, changed=changed)
    db.commit()


def set_state(db: Session, access: Access, state: str) -> None:
    """Open, pause or close a study for newcomers.

    Raises:
        ConflictError: it was never published, so that there is nothing to open.
    """
    study = studies.find(db, access.slug, lock=True)
    if study.state == "draft":
        raise ConflictError(
            "This study was never published.",
            code="never_published",
            mend="Publish it; that opens it as well.",
        )
    if study.state != state:
        study.state = state
        audit.note(db, study.id, "state_changed", access.researcher_id, state=state)
    db.commit()


def invite(
    db: Session, access: Access, labels: Sequence[str], count: int, secret: str, home: str
) -> list[Invitation]:
    """Personal links for these labels; without labels, for as many new ones as asked for.

    The same label always gives the same link. Nothing about a link is stored: its signature tells.
    """
    names = list(dict.fromkeys(labels)) or sorted(secrets.token_hex(4) for _ in range(count))
    audit.note(db, access.study_id, "links_made", access.researcher_id, count=len(names))
    db.commit()
    slug = access.slug
    address = f"{home}/studies/{slug}?invite="
    return [
        Invitation(label=name, url=address + recruiting.invitation(secret, slug, name))
        for name in names
    ]
