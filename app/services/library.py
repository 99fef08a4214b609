"""The motion library: looking, keeping, deleting."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from sqlalchemy.orm import Session

from app.errors import ConflictError, InvalidError, NotFoundError, SignInNeededError
from app.persistence import blobs, clips, jobs, spaces
from app.persistence.models import ClipRecord
from app.schemas.library import ClipDetail, ClipList, ClipView, Provenance
from app.services.engine_version import engine_version
from app.services.studies import media_url

if TYPE_CHECKING:  # it brings SciPy, for which the server's start shall not wait
    from app.services.clip_files import ClipFiles

# A motion on another body, or of several motions, is a variant of none of them.
ORIGINS = ("retarget@", "blend@")
NEEDS = (
    (
        clips.is_in_use,
        "A study shows this clip, or somebody has answered it.",
        "Take it out of the study first; answered clips stay.",
    ),
    (clips.is_in_graph, "A motion graph plays this clip.", "Take it out of the graph first."),
    (jobs.refer_to, "A job that is not done yet needs this clip.", "Wait for it, or cancel it."),
)


def listed(db: Session, query: str, tags: Sequence[str], *, signed_in: bool) -> ClipList:
    """The clips that hold every word of the query in name or tags, and every tag.

    A tag is ``emotion:sad``, or a value alone: ``sad``. All but samples show to researchers only.
    """
    words = query.lower().split()
    found = [
        view(clip, figure)
        for clip, figure in clips.listed(db, imported=signed_in)
        if _has_words(clip, words) and all(_has_tag(clip, tag) for tag in tags)
    ]
    return ClipList(clips=found)


def detail(db: Session, clip_id: str, *, signed_in: bool) -> ClipDetail:
    """One clip: how it came in, or what it is made of."""
    return described(db, find(db, clip_id, signed_in=signed_in))


def described(db: Session, clip: ClipRecord) -> ClipDetail:
    """A clip with the report of its import or its provenance."""
    figure = clips.figure(db, clip.skeleton_hash)
    known = view(clip, figure.glb_blob if figure else None)
    return ClipDetail.model_validate(
        {
            **known.model_dump(),
            "report": clip.report,
            "provenance": _provenance(db, clip),
            "quality": clip.quality,
        }
    )


def find(db: Session, clip_id: str, *, signed_in: bool) -> ClipRecord:
    """The clip. Strangers see samples only, and are not told whether there is another.

    Raises:
        NotFoundError: there is none.
        SignInNeededError: a stranger asks for what is no sample.
    """
    clip = clips.by_id(db, clip_id)
    if not signed_in and (clip is None or clip.source != "sample"):
        raise SignInNeededError(
            "Only samples can be seen without an API key, and no sample has this id.",
            code="key_needed",
            mend="Send the header “Authorization: Bearer mnr_…”, or sign in on this browser.",
        )
    if clip is None:
        raise NotFoundError(
            "There is no such clip.", code="clip_not_found", mend="Look for it in the library."
        )
    return clip


def content(db: Session, clip: ClipRecord) -> bytes:
    """The stored motion.

    Raises:
        InvalidError: somebody has deleted it behind our back.
    """
    stored = blobs.content(db, clip.clip_blob)
    if stored is None:
        raise InvalidError(f"The file of the clip {clip.name} is missing from the database.")
    return stored


def confirm(db: Session, clip_id: str) -> ClipDetail:
    """Keep an imported clip as its report describes it."""
    clip = find(db, clip_id, signed_in=True)
    clip.state = "kept" if clip.state == "to_confirm" else clip.state
    db.commit()
    return detail(db, clip_id, signed_in=True)


def label(db: Session, clip_id: str, name: str, tags: dict[str, str] | None) -> ClipDetail:
    """Give a clip another name, and other tags if any are given.

    Raises:
        ConflictError: the clip is a sample, which studies and papers know by its name.
    """
    clip = find(db, clip_id, signed_in=True)
    if clip.source == "sample":
        raise ConflictError("Samples keep their names and tags.", code="sample_clip")
    clip.name = name
    clip.tags = clip.tags if tags is None else tags
    db.commit()
    return described(db, clip)


def delete(db: Session, clip_id: str) -> None:
    """Delete an imported or edited clip and its files, unless something needs it.

    Raises:
        ConflictError: it is a sample, or a study, a graph, a space, a job or other clips need it.
    """
    clips.lock(db, clip_id)
    clip = find(db, clip_id, signed_in=True)
    if clip.source == "sample":
        raise ConflictError("Samples come with the server and stay.", code="sample_clip")
    _refuse_while_needed(db, clip_id)
    clips.delete(db, clip)
    db.commit()


def store(
    db: Session,
    files: ClipFiles,
    *,
    name: str,
    source: str,
    state: str,
    tags: dict[str, str],
    report: dict[str, Any] | None = None,
    source_file: bytes | None = None,
) -> ClipRecord:
    """Add a clip with its files; the caller commits."""
    clip = record(db, files, name=name, source=source, state=state, tags=tags)
    clip.report = report
    clip.source_blob = None if source_file is None else blobs.put(db, source_file, blobs.BVH)
    return clips.put(db, clip)


def record(
    db: Session, files: ClipFiles, *, name: str, source: str, state: str, tags: dict[str, str]
) -> ClipRecord:
    """A clip's row, its files stored and itself not yet."""
    return ClipRecord(
        id=files.id,
        name=name,
        source=source,
        state=state,
        skeleton_hash=files.skeleton_hash,
        frames=files.frames,
        frame_time=files.frame_time,
        duration=files.duration,
        cyclic=files.cyclic,
        stature=files.stature,
        poster_time=files.poster_time,
        tags=tags,
        clip_blob=blobs.put(db, files.clip, blobs.CLIP),
        glb_blob=blobs.put(db, files.glb, blobs.GLB),
        content_hash=files.id,
        engine_version=engine_version(),
    )


def view(clip: ClipRecord, figure: str | None) -> ClipView:
    """What the API tells of a clip; ``figure`` is the hash of its skeleton's."""
    return ClipView.model_validate(
        {
            **{name: getattr(clip, name) for name in ClipView.model_fields if hasattr(clip, name)},
            "glb_url": media_url(clip.glb_blob),
            "figure_url": figure and media_url(figure),
            "page_url": f"/library/{clip.id}",
            "variant_of": None if _is_origin(clip) else clip.recipe_source,
        }
    )


def _is_origin(clip: ClipRecord) -> bool:
    return any(step["operation"].startswith(ORIGINS) for step in clip.recipe or ())


def _refuse_while_needed(db: Session, clip_id: str) -> None:
    for is_needed, message, mend in NEEDS:
        if is_needed(db, clip_id):
            raise ConflictError(message, code="clip_in_use", mend=mend)
    if blending := spaces.blending(db, clip_id):
        first, others = blending[0], len(blending) - 1
        more = f" So {'does' if others == 1 else 'do'} {others} more." if others else ""
        raise ConflictError(
            f"The authoring space “{first.name}”, version {first.number}, blends this clip.{more}",
            code="clip_in_use",
            mend="Delete the space first, if nothing else needs it.",
            extra={"spaces": [space.id for space in blending]},
        )
    if made := clips.made_from(db, clip_id):
        raise ConflictError(
            f"{made} {'clip was' if made == 1 else 'clips were'} made from this one.",
            code="clip_has_edits",
            mend="Delete what was made from it first.",
            extra={"edits": made},
        )


def _provenance(db: Session, clip: ClipRecord) -> Provenance | None:
    """What an edited clip is made of."""
    source = clips.by_id(db, clip.recipe_source) if clip.recipe_source else None
    if source is None or clip.recipe is None or clip.recipe_hash is None:
        return None
    return Provenance.model_validate(
        {
            "source": source.id,
            "source_name": source.name,
            "source_hash": source.content_hash,
            "recipe": clip.recipe,
            "recipe_hash": clip.recipe_hash,
            "engine_version": clip.engine_version,
            "current_engine": clip.engine_version == engine_version(),
            "content_hash": clip.content_hash,
        }
    )


def _has_words(clip: ClipRecord, words: list[str]) -> bool:
    text = " ".join([clip.name, *clip.tags.values()]).lower()
    return all(word in text for word in words)


def _has_tag(clip: ClipRecord, tag: str) -> bool:
    name, colon, value = tag.partition(":")
    return clip.tags.get(name) == value if colon else tag in clip.tags.values()
