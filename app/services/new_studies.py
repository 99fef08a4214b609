"""What a study begins as: a template, a file, another study, or nothing but its usual texts."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable
from dataclasses import asdict
from typing import Any

from sqlalchemy.orm import Session

from app.errors import InvalidError, NotFoundError
from app.persistence import studies as store
from app.persistence.models import Study, now
from app.schemas.studies_api import NewStudy, TemplateLine, TemplateList, UploadedFile
from app.schemas.study import Running
from app.services import audit, draft_clips, drafts, rights, studies, study_files
from app.services.rights import Access
from app.studies import TEMPLATES

LONGEST_SLUG = 60


def templates() -> TemplateList:
    """The studies that come with the server to begin with."""
    return TemplateList(
        templates=[
            TemplateLine(id=one.id, title=one.title, summary=one.summary, minutes=one.minutes)
            for one in TEMPLATES.values()
        ]
    )


def make(db: Session, wanted: NewStudy, researcher_id: int) -> Access:
    """A new study as asked for.

    Raises:
        NotFoundError: no such template, or no such clip.
        InvalidError: the file cannot be read; where.faults has each line. Or a clip cannot be
            shown.
    """
    running = Running()
    if wanted.template is not None:
        definition = _of_template(wanted.template)
    elif wanted.file is not None:
        definition, running = _of_file(wanted.file)
    elif wanted.definition is not None:
        definition = wanted.definition
    else:
        definition = empty(wanted.title or "Untitled study")
    if wanted.title is not None:
        definition = {**definition, "title": wanted.title, "slug": ""}
    if wanted.clips:
        definition = draft_clips.begun_with(db, definition, wanted.clips)
    return create(db, definition, researcher_id, running)


def _of_template(name: str) -> dict[str, Any]:
    template = TEMPLATES.get(name)
    if template is None:
        raise NotFoundError(
            f"There is no template “{name[:100]}”.",
            code="template_not_found",
            mend=f"Use one of {', '.join(TEMPLATES)}.",
        )
    return template.build()


def _of_file(file: UploadedFile) -> tuple[dict[str, Any], Running]:
    read = study_files.read(file.text, file.name)
    if read.faults:
        first, others = read.faults[0], len(read.faults) - 1
        more = f" {others} more below." if others else ""
        raise InvalidError(
            f"Line {first.line}: {first.message}{more}",
            code="study_file_invalid",
            where={"faults": [asdict(fault) for fault in read.faults]},
            mend=first.mend,
        )
    written = {name: value for name, value in read.text.data.items() if name != "running"}
    return written, read.running or Running()


def create(
    db: Session,
    definition: dict[str, Any],
    researcher_id: int,
    running: Running | None = None,
    copy_of: str | None = None,
) -> Access:
    """A new study with this draft, owned by who makes it.

    Its address is the one in the definition, or is made from the title; if it is taken, it gets a
    number. The definition need not be complete.
    """
    drafts.check_storable(definition)
    title = drafts.title_of(definition) or "Untitled study"
    wanted = definition.get("slug")
    if not isinstance(wanted, str) or slug_for(wanted, lambda _: False) != wanted:
        wanted = title
    slug = slug_for(wanted, lambda one: store.by_slug(db, one) is not None)
    study = Study(
        slug=slug,
        title=title,
        draft={**definition, "slug": slug},
        draft_saved_at=now(),
        running=(running or Running()).model_dump(mode="json"),
    )
    db.add(study)
    db.flush()
    rights.make_owner(db, study, researcher_id)
    if copy_of is None:
        audit.note(db, study.id, "study_created", researcher_id)
    else:
        audit.note(db, study.id, "study_duplicated", researcher_id, source=copy_of)
    db.commit()
    return Access(study.id, study.slug, researcher_id, "owner")


def duplicate(db: Session, access: Access) -> Access:
    """Another study with the same content; nobody has taken part in it yet."""
    study = studies.find(db, access.slug)
    return create(
        db,
        {**drafts.content(db, study), "title": f"{study.title[:190]} (copy)"},
        access.researcher_id,
        studies.running_of(study),
        copy_of=study.slug,
    )


def slug_for(title: str, is_taken: Callable[[str], bool]) -> str:
    """An address from a title; of two that are alike, the later gets a number."""
    plain = unicodedata.normalize("NFKD", title).encode("ascii", "ignore").decode().lower()
    base = re.sub(r"[^a-z0-9]+", "-", plain)[:LONGEST_SLUG].strip("-") or "study"
    slug, number = base, 2
    while is_taken(slug):
        slug, number = f"{base}-{number}", number + 1
    return slug


def empty(title: str) -> dict[str, Any]:
    """A draft without parts. Its texts are a beginning to be written over."""
    return {
        "manner": 1,
        "slug": "",
        "title": title,
        "languages": ["en"],
        "welcome": {
            "heading": "How does this movement seem to you?",
            "lead": "You will see short clips of people moving and tell us how they seem to you. "
            "There are no right or wrong answers.",
            "facts": ["A few minutes", "On a phone, a tablet or a computer", "No sound needed"],
        },
        "consent": {
            "version": "1",
            "heading": "Before you begin",
            "terms": [
                {
                    "term": "What is kept",
                    "text": "Your answers and how long they took. No name and no internet address.",
                },
                {
                    "term": "Your right",
                    "text": "Stop at any time. A personal link lets you delete your answers later.",
                },
            ],
            "statement": "I am 18 or older, I have read this, and I agree to take part.",
        },
        "parts": [],
        "thanks": {
            "heading": "Thank you",
            "text": "That was everything. Clips that you judged: {clips}.",
        },
    }
