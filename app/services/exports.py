"""The raw answers as a table: one row an answer, streamed, safe to open in a spreadsheet."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterator
from io import StringIO
from typing import Any

from app.persistence import responses
from app.persistence.engine import Database
from app.persistence.models import Response, Study, StudySession
from app.schemas.study import StudyDefinition
from app.services.studies import definition_of, find

ROWS_AT_ONCE = 200
# What spreadsheets take for the beginning of a formula, full-width forms included.
DANGEROUS = ("=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠")
BEFORE_SCALES = (
    "study", "study_hash", "session", "session_state", "consent_version", "device", "seed",
    "trial_type", "trial_index", "practice", "revision", "newest",
    "stimulus", "body", "style", "stimulus_hash",
)  # fmt: skip
RECORDED = (
    "plays", "viewing_ms", "camera_moves", "hidden_ms", "blur_count", "dropped_frames", "tier",
)  # fmt: skip
VIEWPORT = ("width", "height", "pixel_ratio")
AFTER_SCALES = (
    "touched", "comment", "rt_ms", "time_elapsed_ms", *RECORDED,
    *(f"viewport_{part}" for part in VIEWPORT), "client_time", "received_at",
)  # fmt: skip


def responses_csv(database: Database, slug: str) -> Iterator[str]:
    """Every stored answer of a study as CSV text, a piece at a time.

    The study is looked up before the first piece, so that a wrong address is still an error page.
    """
    with database.reading() as session:
        study = find(session, slug)
    return _pieces(database, study, definition_of(study))


def columns(definition: StudyDefinition) -> list[str]:
    """The table's columns: one a scale between what was shown and how it was answered."""
    return [*BEFORE_SCALES, *(scale.id for scale in definition.scales), *AFTER_SCALES]


def safe(cell: object) -> object:
    """Text that a spreadsheet would take for a formula gets an apostrophe; numbers stay numbers."""
    return f"'{cell}" if isinstance(cell, str) and cell.startswith(DANGEROUS) else cell


def _pieces(database: Database, study: Study, definition: StudyDefinition) -> Iterator[str]:
    buffer = StringIO()
    write = csv.writer(buffer).writerow
    write(columns(definition))
    row_of = _row_maker(study, definition)
    with database.reading() as session:
        for count, (answer, participant, superseded) in enumerate(responses.stream(session, study)):
            write([safe(cell) for cell in row_of(answer, participant, not superseded)])
            if count % ROWS_AT_ONCE == 0:
                yield _taken(buffer)
    yield _taken(buffer)


def _taken(buffer: StringIO) -> str:
    text = buffer.getvalue()
    buffer.seek(0)
    buffer.truncate()
    return text


def _row_maker(
    study: Study, definition: StudyDefinition
) -> Callable[[Response, StudySession, bool], list[Any]]:
    stimuli = {stimulus.clip: stimulus for stimulus in definition.stimuli}
    scales = [scale.id for scale in definition.scales]

    def row(answer: Response, participant: StudySession, newest: bool) -> list[Any]:
        shown, record = stimuli[answer.clip_id], answer.record
        viewport = record.get("viewport") or {}
        return [
            study.slug, study.definition_hash, participant.id, participant.state,
            participant.consent_version, participant.user_agent_class, participant.seed,
            "semantic_differential", answer.trial_index, int(answer.practice), answer.revision,
            int(newest), shown.name, shown.body, shown.style, shown.clip,
            *(answer.answers[scale] for scale in scales),
            " ".join(record.get("touched", ())), answer.comment, answer.rt_ms,
            record.get("time_elapsed_ms"), *(record.get(name) for name in RECORDED),
            *(viewport.get(part) for part in VIEWPORT),
            record.get("client_time"), answer.received_at.isoformat(),
        ]  # fmt: skip

    return row
