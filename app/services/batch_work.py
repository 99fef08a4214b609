"""What a process computes of a job: several edits of one clip, one after the other."""

from __future__ import annotations

import traceback
from collections.abc import Sequence
from dataclasses import dataclass

from app.errors import MannerError
from app.services.clip_files import ClipFiles
from app.services.rendering import Steps, Supplies, render


@dataclass(frozen=True)
class Failure:
    """Why a clip could not be made, for a person; ``trace`` for the log if nobody foresaw it."""

    message: str
    trace: str = ""


def render_all(
    source: bytes, stature: float, edits: Sequence[tuple[Steps, Supplies]]
) -> list[ClipFiles | Failure]:
    """The edited clips in their order; one that fails does not hinder the others."""
    return [_render(source, stature, *edit) for edit in edits]


def _render(
    source: bytes, stature: float, operations: Steps, supplies: Supplies
) -> ClipFiles | Failure:
    try:
        return render(source, operations, supplies, stature)
    except MannerError as error:
        return Failure(f"{error.message} {error.mend or ''}".rstrip())
    except Exception:
        return Failure("Something went wrong on our side.", traceback.format_exc())
