"""Studies: finding them, their versions, the welcome, and the demonstration."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime

from sqlalchemy.orm import Session

from app.errors import NotFoundError
from app.i18n import best
from app.persistence import studies as store
from app.persistence.models import ClipRecord, Study, StudyVersion, now
from app.schemas.study import Language, Running, SemanticDifferential, Stimulus, StudyDefinition
from app.services.admission import Closed, closed_for
from app.services.recruiting import Arrival
from app.studies import emotion


@dataclass(frozen=True)
class ExampleClip:
    """A clip that moves beside a text."""

    glb_url: str
    figure_url: str | None
    cyclic: bool


@dataclass(frozen=True)
class WelcomePage:
    """What a person reads before taking part, in one language.

    Attributes:
        closed: why nobody can begin now; None where one can.
        opens_at: when it opens, where it is not open yet.
    """

    study: StudyDefinition
    language: Language
    clip: ExampleClip | None
    closed: Closed | None = None
    opens_at: datetime | None = None


def find(db: Session, slug: str, *, lock: bool = False) -> Study:
    """The study at this address.

    Raises:
        NotFoundError: there is none.
    """
    study = store.by_slug(db, slug, lock=lock)
    if study is None:
        raise no_such_study(slug)
    return study


def newest(db: Session, study: Study) -> StudyVersion:
    """The version that new participants see.

    Raises:
        NotFoundError: none was published yet.
    """
    version = store.newest_version(db, study)
    if version is None:
        raise NotFoundError(
            f"“{study.title}” is not published yet.",
            code="study_not_published",
            mend="Publish it first; until then only its preview can be seen.",
        )
    return version


def definition_of(version: StudyVersion) -> StudyDefinition:
    """The version's validated definition, read once: what is published never changes."""
    known = _DEFINITIONS.get(version.definition_hash)
    if known is None:
        known = StudyDefinition.model_validate(version.definition)
        _DEFINITIONS[version.definition_hash] = known
    return known


def asks_pairs(db: Session, slug: str) -> bool:
    """Whether the newest version asks for pairs of opposite words, at least two in one part."""
    version = store.newest_version(db, find(db, slug))
    return version is not None and any(
        isinstance(part.task, SemanticDifferential) and len(part.task.scales) > 1
        for part in definition_of(version).trials
    )


def definition_by_hash(db: Session, version_id: int, definition_hash: str) -> StudyDefinition:
    """The same, without a look at the database once it is known."""
    known = _DEFINITIONS.get(definition_hash)
    return known or definition_of(store.version_by_id(db, version_id))


def localised(version: StudyVersion, language: Language) -> StudyDefinition:
    """The version's definition with all texts in one language."""
    key = version.definition_hash, language
    if key not in _LOCALISED:
        _LOCALISED[key] = definition_of(version).into(language)
    return _LOCALISED[key]


_DEFINITIONS: dict[str, StudyDefinition] = {}
_LOCALISED: dict[tuple[str, Language], StudyDefinition] = {}


def language_for(definition: StudyDefinition, *wanted: str | None) -> Language:
    """The first wanted language that the study has, else its own first one."""
    return best(definition.languages, wanted)


def running_of(study: Study) -> Running:
    """The study's settings."""
    return Running.model_validate(study.running)


def welcome(
    db: Session, slug: str, coming: Arrival | None = None, languages: tuple[str | None, ...] = ()
) -> WelcomePage:
    """What the welcome page of a study shows.

    Args:
        db: where to read.
        slug: which study.
        coming: who comes, from where; None for the open link.
        languages: those that the person wants, the best first.
    """
    study = find(db, slug)
    version = store.newest_version(db, study)
    if version is None:
        raise no_such_study(slug)
    definition, running = definition_of(version), running_of(study)
    language = language_for(definition, *languages)
    return WelcomePage(
        localised(version, language),
        language,
        example_clip(db, definition),
        closed_for(db, study, running, coming or Arrival(), now()),
        running.opens_at,
    )


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


def ensure_demonstration(db: Session) -> Study | None:
    """Make the demonstration study from the sample library; None while that has no clips.

    A study that nobody began follows a changed library: its version is replaced, the only case in
    which that happens. One with participants stays as they saw it.
    """
    clips = store.sample_clips(db, emotion.SAMPLE_SET)
    study = store.by_slug(db, emotion.SLUG)
    if not clips or (study and store.has_sessions(db, study)):
        return study
    definition = emotion.demonstration(map(_stimulus, clips), _example(db))
    if study is None:
        study = Study(slug=definition.slug, state="open", running={})
        db.add(study)
    study.title = definition.title
    db.flush()
    version = store.newest_version(db, study)
    if version is None:
        version = StudyVersion(study_id=study.id, number=1)
        db.add(version)
    version.definition = definition.model_dump(mode="json")
    version.definition_hash = definition.content_hash
    db.commit()
    return study


def _stimulus(clip: ClipRecord) -> Stimulus:
    body = clip.tags.get("body", "one body")
    style = clip.tags.get("style") or clip.tags.get("emotion", clip.name)
    return Stimulus.model_validate(
        {
            "clip": clip.id, "name": clip.name, "label": f"{style}, {body}",
            "body": body, "style": style,
        }
    )  # fmt: skip


def _example(db: Session) -> str | None:
    """A walk that is no stimulus, the neutral one if there is one."""
    walks = store.sample_clips(db, emotion.EXAMPLE_SET)
    walks.sort(key=lambda clip: clip.tags.get("style") != "neutral")
    return walks[0].id if walks else None


def no_such_study(slug: str) -> NotFoundError:
    """What to raise for an address without a study, or without one that is the caller's."""
    return NotFoundError(
        f"There is no study “{slug[:100]}” on this server.",
        code="study_not_found",
        mend="Check the link that you were given.",
    )
