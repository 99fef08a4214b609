"""Studies: finding them, showing them, and the demonstration that comes with the server."""

from __future__ import annotations

from dataclasses import dataclass

from sqlalchemy.orm import Session

from app.errors import NotFoundError
from app.persistence import studies as store
from app.persistence.models import ClipRecord, Study
from app.schemas.study import Stimulus, StudyDefinition
from app.studies import emotion


@dataclass(frozen=True)
class ExampleClip:
    """A clip that moves beside a text."""

    glb_url: str
    figure_url: str | None
    cyclic: bool


@dataclass(frozen=True)
class WelcomePage:
    """What a person reads before taking part."""

    study: StudyDefinition
    clip: ExampleClip | None


@dataclass(frozen=True)
class StudyLine:
    """A study in the researchers' list."""

    slug: str
    title: str
    complete: int
    active: int
    withdrawn: int


def find(db: Session, slug: str) -> Study:
    """The study at this address.

    Raises:
        NotFoundError: there is none.
    """
    study = store.by_slug(db, slug)
    if study is None:
        raise NotFoundError(
            f"There is no study “{slug[:100]}” on this server.",
            code="study_not_found",
            mend="Check the link that you were given.",
        )
    return study


def definition_of(study: Study) -> StudyDefinition:
    """The study's validated definition."""
    return StudyDefinition.model_validate(study.definition)


def definition_by_hash(db: Session, study_id: int, definition_hash: str) -> StudyDefinition:
    """The same, read once: what has the same hash is the same definition."""
    known = _DEFINITIONS.get(definition_hash)
    if known is None:
        known = _DEFINITIONS[definition_hash] = definition_of(store.by_id(db, study_id))
    return known


_DEFINITIONS: dict[str, StudyDefinition] = {}


def welcome(db: Session, slug: str) -> WelcomePage:
    """What the welcome page of a study shows."""
    definition = definition_of(find(db, slug))
    return WelcomePage(definition, example_clip(db, definition))


def example_clip(db: Session, definition: StudyDefinition) -> ExampleClip | None:
    """The clip that moves beside the study's texts, if it has one."""
    return _shown(db, definition.welcome.example)


def thanks_clip(db: Session, definition: StudyDefinition) -> ExampleClip | None:
    """The figure that takes leave: it bows, or moves as in the beginning where no bow is known."""
    gestures = store.sample_clips(db, emotion.THANKS_SET)
    return _shown(db, gestures[0].id) if gestures else example_clip(db, definition)


def _shown(db: Session, clip: str | None) -> ExampleClip | None:
    found = store.media(db, [clip]).get(clip) if clip else None
    if found is None:
        return None
    return ExampleClip(media_url(found.glb), found.figure and media_url(found.figure), found.cyclic)


def media_url(content_hash: str) -> str:
    """Where the bytes of this hash are served."""
    return f"/media/{content_hash}.glb"


def overview(db: Session) -> list[StudyLine]:
    """Every study with its counts."""
    counts = store.state_counts(db)
    return [
        StudyLine(
            slug=study.slug,
            title=study.title,
            complete=counts.get((study.id, "complete"), 0),
            active=counts.get((study.id, "active"), 0),
            withdrawn=counts.get((study.id, "withdrawn"), 0),
        )
        for study in store.all_studies(db)
    ]


def ensure_demonstration(db: Session) -> Study | None:
    """Make the demonstration study from the sample library; None while that has no clips.

    A study that nobody began follows a changed library. One with participants stays as they saw it.
    """
    clips = store.sample_clips(db, emotion.SAMPLE_SET)
    study = store.by_slug(db, emotion.SLUG)
    if not clips or (study and store.has_sessions(db, study)):
        return study
    definition = emotion.demonstration(map(_stimulus, clips), _example(db))
    if study is None:
        study = Study(slug=definition.slug)
        db.add(study)
    study.title = definition.title
    study.definition = definition.model_dump(mode="json")
    study.definition_hash = definition.content_hash
    db.commit()
    return study


def _stimulus(clip: ClipRecord) -> Stimulus:
    body = clip.tags.get("body", "one body")
    style = clip.tags.get("style") or clip.tags.get("emotion", clip.name)
    return Stimulus(clip=clip.id, name=clip.name, label=f"{style}, {body}", body=body, style=style)


def _example(db: Session) -> str | None:
    """A walk that is no stimulus, the neutral one if there is one."""
    walks = store.sample_clips(db, emotion.EXAMPLE_SET)
    walks.sort(key=lambda clip: clip.tags.get("style") != "neutral")
    return walks[0].id if walks else None
