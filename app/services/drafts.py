"""Studies in the making: their list, what they begin as, saving what somebody edits."""

from __future__ import annotations

import json
from datetime import datetime, timedelta
from typing import Any

from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError, NotFoundError
from app.persistence import studies as store
from app.persistence import study_versions
from app.persistence.models import Study, StudyVersion, now
from app.schemas.live import Role
from app.schemas.studies_api import (
    Problem,
    SavedDraft,
    StudyCounts,
    StudyDetail,
    StudyLine,
    StudyList,
    VersionLine,
)
from app.schemas.study import Running, StudyDefinition
from app.services import (
    audit,
    rights,
    studies,
    study_files,
    study_stimuli,
    study_text,
)
from app.services.rights import Access

ONE_EDIT = timedelta(minutes=10)  # what is saved so closely together is one entry of the audit


def listed(db: Session, researcher_id: int) -> StudyList:
    """Every study that the researcher may see, oldest first."""
    counts = store.state_counts(db)
    newest = study_versions.newest_numbers(db)
    roles = rights.visible(db, researcher_id)
    lines = [
        _line(study, roles[study.id], newest.get(study.id), counts)
        for study in store.all_studies(db)
        if study.id in roles
    ]
    return StudyList(studies=lines)


def _line(
    study: Study, role: Role, version: int | None, counts: dict[tuple[int, str], int]
) -> StudyLine:
    states = ("complete", "active", "withdrawn")
    return StudyLine.model_validate(
        {
            "slug": study.slug,
            "title": study.title,
            "state": study.state,
            "role": role,
            "version": version,
            "draft": study.draft is not None,
            "counts": StudyCounts(**{one: counts.get((study.id, one), 0) for one in states}),
            "created_at": study.created_at,
        }
    )


def view(db: Session, access: Access) -> StudyDetail:
    """A study with its draft, its versions and how it is run."""
    study = studies.find(db, access.slug)
    newest, draft = store.newest_version(db, study), study.draft
    found, can_be_shown = ([], True) if draft is None else _examined(db, study, draft)
    return StudyDetail.model_validate(
        {
            "slug": study.slug,
            "title": study.title,
            "state": study.state,
            "role": access.role,
            "draft": draft,
            "saved_at": _saved_at(study),
            "definition": newest and newest.definition,
            "versions": _version_lines(db, study),
            "running": Running.model_validate(study.running),
            "problems": found,
            "can_be_shown": can_be_shown,
        }
    )


def _version_lines(db: Session, study: Study) -> list[VersionLine]:
    begun = study_versions.begun(db, study)
    return [
        VersionLine(
            number=one.number,
            hash=one.definition_hash,
            published_at=one.published_at,
            changes=one.changes,
            sessions=begun.get(one.id, 0),
        )
        for one in study_versions.versions(db, study)
    ]


def content(db: Session, study: Study) -> dict[str, Any]:
    """What is being edited: the draft, or the newest version where there is none."""
    if study.draft is not None:
        return study.draft
    newest = store.newest_version(db, study)
    return newest.definition if newest else {}


def save(
    db: Session, access: Access, draft: dict[str, Any], seen: datetime | None = None
) -> SavedDraft:
    """Keep a draft, whatever is still wrong with it.

    Raises:
        ConflictError: somebody saved another draft after the one from `seen`.
        InvalidError: it holds characters or numbers that cannot be stored.
    """
    check_storable(draft)
    study = studies.find(db, access.slug, lock=True)
    if seen is not None and seen != _saved_at(study):
        raise ConflictError(
            "This study was changed elsewhere in the meantime.",
            code="draft_changed",
            where={"saved_at": _saved_at(study).isoformat()},
            mend="Load the page again to see it. What you changed last is not saved.",
        )
    if draft != content(db, study):
        who = access.researcher_id
        audit.note(db, study.id, "draft_saved", who, unless_within=ONE_EDIT)
        study.draft = draft
        if study.state == "draft":
            study.title = title_of(draft) or study.title
    study.draft_saved_at = now()
    db.commit()
    found, can_be_shown = _examined(db, study, draft)
    return SavedDraft(saved_at=study.draft_saved_at, problems=found, can_be_shown=can_be_shown)


def _saved_at(study: Study) -> datetime:
    """What the next save must have seen; nobody has edited the demonstration when it is made."""
    return study.draft_saved_at or study.created_at


def discard(db: Session, access: Access) -> None:
    """Go back to the newest version.

    Raises:
        ConflictError: there is none yet.
    """
    study = studies.find(db, access.slug, lock=True)
    if store.newest_version(db, study) is None:
        raise ConflictError(
            "This study was never published, so there is nothing to go back to.",
            code="never_published",
            mend="Delete the study instead.",
        )
    study.draft, study.draft_saved_at = None, now()
    audit.note(db, study.id, "draft_discarded", access.researcher_id)
    db.commit()


def delete(db: Session, access: Access) -> None:
    """Delete a study that nobody began.

    Raises:
        ConflictError: it has participants, or was published.
    """
    study = studies.find(db, access.slug, lock=True)
    if study.state != "draft" or store.has_sessions(db, study):
        raise ConflictError(
            "Only a study that was never published can be deleted.",
            code="study_published",
            mend="Close it instead; its answers stay.",
        )
    study_versions.drop(db, study)
    db.commit()


def problems(db: Session, study: Study, draft: dict[str, Any]) -> list[Problem]:
    """All that stands in the way of publishing a draft."""
    return _examined(db, study, draft)[0]


def _examined(db: Session, study: Study, draft: dict[str, Any]) -> tuple[list[Problem], bool]:
    """A draft's problems, and whether it can be shown in spite of them."""
    definition, _, found = study_files.examine(draft)
    can_be_shown = definition is not None and is_presentable(found)
    if draft.get("slug") != study.slug and "slug" in draft:
        found.append(
            Problem(
                where=["slug"],
                message=f"The address of this study stays “{study.slug}”.",
                mend="Write it so, or duplicate the study to have another address.",
            )
        )
    if definition is None:
        return found, False
    found += _consent_problems(store.newest_version(db, study), definition)
    clips = study_stimuli.problems(db, definition)
    return [*found, *clips], can_be_shown and not clips


def is_presentable(problems: list[Problem]) -> bool:
    """Whether the preview works nevertheless: a study without clips has its pages to show."""
    return all(problem.where == ["parts"] for problem in problems)


def file(db: Session, access: Access, number: int | None, file_format: str) -> tuple[str, str]:
    """Name and text of a study file: of a version, or of what is being edited.

    Raises:
        NotFoundError: no such version.
    """
    study = studies.find(db, access.slug)
    if number is None:
        definition = content(db, study)
    else:
        version = study_versions.version(db, study, number)
        if version is None:
            raise NotFoundError(
                f"“{study.title}” has no version {number}.", code="version_not_found"
            )
        definition = version.definition
    name = f"{study.slug}{f'-{number}' if number else ''}.{file_format}"
    if file_format == "json":
        return name, json.dumps(definition, indent=2, ensure_ascii=False) + "\n"
    return name, study_files.write(definition)


def _consent_problems(newest: StudyVersion | None, definition: StudyDefinition) -> list[Problem]:
    """Whoever agreed to a wording must be able to tell from its version which it was."""
    before = studies.definition_of(newest).consent if newest else None
    consent = definition.consent
    if before is None or before == consent or before.version != consent.version:
        return []
    return [
        Problem(
            where=["consent", "version"],
            message=f"The consent has another wording, but is still called “{consent.version}”.",
            mend="Give the new wording a new version.",
        )
    ]


def title_of(draft: dict[str, Any]) -> str:
    """The draft's title, as far as it has one."""
    title = draft.get("title")
    return title.strip()[:200] if isinstance(title, str) else ""


def check_storable(draft: dict[str, Any]) -> None:
    """Refuse what JSON as such may hold, but no database and no page can.

    Raises:
        InvalidError: with the place.
    """
    for path, message in study_text.unstorable(draft):
        raise InvalidError(
            message,
            code="draft_unstorable",
            where={"path": list(path)},
            mend="Take it out.",
        )
