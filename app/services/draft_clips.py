"""Clips on their way into studies: which parts take them, and putting them there.

A draft may be incomplete or wrong in any place, so nothing here expects more of it than it needs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from datetime import datetime
from typing import Any

from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError, NotFoundError
from app.persistence import clips, study_versions
from app.persistence import studies as store
from app.persistence.models import ClipRecord, Study
from app.schemas.studies_api import AskingPart, ClipsAdded, DraftList, NewClips, StudyDraft
from app.services import drafts, library, rights, studies
from app.services.rights import Access

Draft = dict[str, Any]

# The first part of a study that has none: one question that needs no more words to be asked.
FIRST_PART: Draft = {
    "id": "clips",
    "kind": "trials",
    "task": {
        "kind": "analogue",
        "question": "How does this movement seem to you?",
        "scales": [{"id": "natural", "left": "unnatural", "right": "natural"}],
    },
    "stimuli": [],
    "order": "shuffle",
}


def listed(db: Session, researcher_id: int) -> DraftList:
    """What is being edited of every study that the researcher may change, the newest first."""
    roles = rights.visible(db, researcher_id)
    newest = study_versions.newest_numbers(db)
    found = [
        _line(db, study, newest.get(study.id))
        for study in reversed(store.all_studies(db))
        if roles.get(study.id) in rights.NEEDED["edit"]
    ]
    return DraftList(drafts=found)


def add(db: Session, access: Access, wanted: NewClips, seen: datetime | None = None) -> ClipsAdded:
    """Give a part of a draft more clips, in one write.

    Raises:
        NotFoundError: no such clip, or no such part that asks about clips.
        InvalidError: a clip cannot be shown.
        ConflictError: all of them are there already, or as `drafts.save`.
    """
    given = _usable(db, wanted.clips)
    study = studies.find(db, access.slug, lock=True)
    draft = _with_a_part(drafts.content(db, study))
    place, part = _part(draft, wanted.part)
    there = _clips_of(db, part)
    already = [clip for clip in given if clip.id in there]
    new = [clip for clip in given if clip.id not in there]
    if not new:
        raise _all_there(already, drafts.title_of(draft) or study.title)
    filled = {**part, "stimuli": [*_list(part, "stimuli"), *_stimuli(new)]}
    saved = drafts.save(db, access, _with_part(draft, place, filled), seen)
    return ClipsAdded(
        title=drafts.title_of(draft) or study.title,
        part=str(part.get("id", "")),
        added=[clip.id for clip in new],
        already=[clip.id for clip in already],
        draft=saved,
    )


def begun_with(db: Session, definition: Draft, ids: Sequence[str]) -> Draft:
    """A definition whose first part that asks about clips has these in the place of its own.

    Raises:
        NotFoundError: no such clip.
        InvalidError: a clip cannot be shown.
    """
    draft = _with_a_part(definition)
    place, part = _part(draft, None)
    given = _usable(db, ids)
    # What names or counts the clips that are gone goes with them.
    kept = {name: value for name, value in part.items() if name not in ("sets", "subset")}
    if isinstance(practice := kept.get("practice"), int):
        kept["practice"] = min(practice, len(given))
    return _with_part(draft, place, {**kept, "stimuli": _stimuli(given)})


def _line(db: Session, study: Study, version: int | None) -> StudyDraft:
    draft = drafts.content(db, study)
    return StudyDraft.model_validate(
        {
            "slug": study.slug,
            "title": drafts.title_of(draft) or study.title,
            "state": study.state,
            "version": version,
            "languages": [one for one in _list(draft, "languages") if isinstance(one, str)],
            "parts": [
                AskingPart(
                    id=str(part.get("id", "")),
                    task=str(_object(part, "task").get("kind", "")),
                    clips=len(_list(part, "stimuli")),
                )
                for _, part in _asking(draft)
            ],
        }
    )


def _asking(draft: Draft) -> Iterator[tuple[int, Draft]]:
    """The parts that ask about clips, with their places."""
    for place, part in enumerate(_list(draft, "parts")):
        if isinstance(part, dict) and part.get("kind") == "trials":
            yield place, part


def _with_a_part(draft: Draft) -> Draft:
    if any(_asking(draft)):
        return draft
    return {**draft, "parts": [*_list(draft, "parts"), FIRST_PART]}


def _with_part(draft: Draft, place: int, part: Draft) -> Draft:
    parts = _list(draft, "parts")
    return {**draft, "parts": [*parts[:place], part, *parts[place + 1 :]]}


def _part(draft: Draft, wanted: str | None) -> tuple[int, Draft]:
    asking = list(_asking(draft))
    for place, part in asking:
        if wanted is None or part.get("id") == wanted:
            return place, part
    raise NotFoundError(
        f"No part called “{wanted}” asks about clips.",
        code="part_not_found",
        where={"part": wanted},
        mend=f"Name one of {', '.join(str(part.get('id', '')) for _, part in asking)}, or none.",
    )


def _usable(db: Session, ids: Sequence[str]) -> list[ClipRecord]:
    """The clips, each once, if all of them can be shown."""
    found = [library.find(db, one, signed_in=True) for one in dict.fromkeys(ids)]
    media = store.media(db, ids)
    for clip in found:
        if clip.state != "kept":
            waits = clip.state == "to_confirm"
            raise InvalidError(
                f"“{clip.name}” {'waits to be confirmed' if waits else 'was deleted'}.",
                code="clip_not_kept",
                where={"clip": clip.id},
                mend="Look through its import report in the library and keep it."
                if waits
                else "Make or import it again.",
            )
        if media[clip.id].figure is None:
            raise InvalidError(
                f"No figure can stand on the skeleton of “{clip.name}”.",
                code="clip_without_figure",
                where={"clip": clip.id},
                mend="Import it again and say which joint moves which part.",
            )
    return found


def _clips_of(db: Session, part: Draft) -> set[str]:
    """The clips that a part has already, by id; a file may call them by their names."""
    references = {
        one if isinstance(one, str) else one.get("clip")
        for one in _list(part, "stimuli")
        if isinstance(one, str | dict)
    }
    named = {one for one in references if isinstance(one, str)}
    return named | {clip.id for clip in clips.named(db, named)}


def _all_there(already: Sequence[ClipRecord], title: str) -> ConflictError:
    what = f"“{already[0].name}” is" if len(already) == 1 else f"All {len(already)} clips are"
    return ConflictError(
        f"{what} in “{title}” already.",
        code="clips_there",
        where={"clips": [clip.id for clip in already]},
        mend="A clip is shown again by an attention check of the kind “A clip comes again”.",
    )


def _stimuli(given: Sequence[ClipRecord]) -> list[Draft]:
    return [{"clip": clip.id} for clip in given]


def _list(of: Draft, name: str) -> list[Any]:
    value = of.get(name)
    return value if isinstance(value, list) else []


def _object(of: Draft, name: str) -> Draft:
    value = of.get(name)
    return value if isinstance(value, dict) else {}
