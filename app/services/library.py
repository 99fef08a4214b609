"""The motion library: looking, keeping, deleting."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from sqlalchemy.orm import Session

from app.errors import ConflictError, NotFoundError
from app.persistence import blobs, clips
from app.persistence.models import ClipRecord
from app.schemas.library import ClipDetail, ClipList, ClipView
from app.services.engine_version import engine_version
from app.services.studies import media_url

if TYPE_CHECKING:  # it brings SciPy, for which the server's start shall not wait
    from app.services.clip_files import ClipFiles


def listed(db: Session, query: str, tags: Sequence[str], *, signed_in: bool) -> ClipList:
    """The clips that hold every word of the query in name or tags, and every tag.

    A tag is ``emotion:sad``, or a value alone: ``sad``. Imported clips show to researchers only.
    """
    words = query.lower().split()
    found = [
        view(clip, figure)
        for clip, figure in clips.listed(db, imported=signed_in)
        if _has_words(clip, words) and all(_has_tag(clip, tag) for tag in tags)
    ]
    return ClipList(clips=found)


def detail(db: Session, clip_id: str, *, signed_in: bool) -> ClipDetail:
    """One clip with the report of its import."""
    clip = find(db, clip_id, signed_in=signed_in)
    figure = clips.figure(db, clip.skeleton_hash)
    known = view(clip, figure.glb_blob if figure else None)
    return ClipDetail.model_validate({**known.model_dump(), "report": clip.report})


def find(db: Session, clip_id: str, *, signed_in: bool) -> ClipRecord:
    """The clip; to strangers an imported one is not there at all.

    Raises:
        NotFoundError: there is none that this person may see.
    """
    clip = clips.by_id(db, clip_id)
    if clip is None or (clip.source != "sample" and not signed_in):
        raise NotFoundError(
            "There is no such clip.",
            code="clip_not_found",
            mend="Look for it in the library. Imported clips show after signing in.",
        )
    return clip


def confirm(db: Session, clip_id: str) -> ClipDetail:
    """Keep an imported clip as its report describes it."""
    clip = find(db, clip_id, signed_in=True)
    clip.state = "kept" if clip.state == "to_confirm" else clip.state
    db.commit()
    return detail(db, clip_id, signed_in=True)


def delete(db: Session, clip_id: str) -> None:
    """Delete an imported clip and its files, unless a study needs it."""
    clip = find(db, clip_id, signed_in=True)
    if clip.source == "sample":
        raise ConflictError("Samples come with the server and stay.", code="sample_clip")
    if clips.is_in_use(db, clip_id):
        raise ConflictError(
            "A study shows this clip, or somebody has answered it.",
            code="clip_in_use",
            mend="Take it out of the study first; answered clips stay.",
        )
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
    clip = ClipRecord(
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
        report=report,
        clip_blob=blobs.put(db, files.clip, blobs.CLIP),
        glb_blob=blobs.put(db, files.glb, blobs.GLB),
        source_blob=None if source_file is None else blobs.put(db, source_file, blobs.BVH),
        content_hash=files.id,
        engine_version=engine_version(),
    )
    return clips.put(db, clip)


def view(clip: ClipRecord, figure: str | None) -> ClipView:
    """What the API tells of a clip; ``figure`` is the hash of its skeleton's."""
    return ClipView.model_validate(
        {
            **{name: getattr(clip, name) for name in ClipView.model_fields if hasattr(clip, name)},
            "glb_url": media_url(clip.glb_blob),
            "figure_url": figure and media_url(figure),
            "page_url": f"/library/{clip.id}",
        }
    )


def _has_words(clip: ClipRecord, words: list[str]) -> bool:
    text = " ".join([clip.name, *clip.tags.values()]).lower()
    return all(word in text for word in words)


def _has_tag(clip: ClipRecord, tag: str) -> bool:
    name, colon, value = tag.partition(":")
    return clip.tags.get(name) == value if colon else tag in clip.tags.values()
