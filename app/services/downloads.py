"""Clips as files to take home."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sqlalchemy.orm import Session

from app.errors import InvalidError
from app.persistence import blobs
from app.services import library

if TYPE_CHECKING:
    from motion import Clip
    from motion.figure import FigureMesh

FIGURES_KEPT = 16

# The motion library is imported where it is used. It brings SciPy, which takes as long to load as
# all the rest of the server, and the first page shall not wait for it.


def as_bvh(db: Session, clip_id: str, *, signed_in: bool) -> tuple[str, bytes]:
    """File name and BVH text of a clip, in centimetres."""
    from motion.bvh_write import write_bvh

    name, clip = _load(db, clip_id, signed_in=signed_in)
    return f"{name}.bvh", write_bvh(clip)


def as_glb(db: Session, clip_id: str, *, signed_in: bool) -> tuple[str, bytes]:
    """File name and GLB of a clip, with its figure if its skeleton can have one."""
    from motion.glb import write_clip_glb

    name, clip = _load(db, clip_id, signed_in=signed_in)
    return f"{name}.glb", write_clip_glb(clip, figure=_figure(clip))


def _figure(clip: Clip) -> FigureMesh | None:
    """The mannequin of the clip's skeleton; the last ones are kept, since each takes a second."""
    from motion import MotionError
    from motion.figure import build_figure

    skeleton = clip.skeleton.content_hash
    figure = _figures.get(skeleton)
    if figure is None:
        try:
            figure = build_figure(clip)
        except MotionError:  # a skeleton without a human's parts
            return None
        _figures[skeleton] = figure
        for oldest in list(_figures)[:-FIGURES_KEPT]:
            _figures.pop(oldest, None)
    return figure


_figures: dict[str, FigureMesh] = {}


def _load(db: Session, clip_id: str, *, signed_in: bool) -> tuple[str, Clip]:
    from motion.storage import clip_from_bytes

    record = library.find(db, clip_id, signed_in=signed_in)
    content = blobs.content(db, record.clip_blob)
    if content is None:
        raise InvalidError(f"The file of the clip {record.name} is missing from the database.")
    return record.name, clip_from_bytes(content)
