"""The columns of the exported tables: what each one means and where its value comes from.

Said once for tables and codebooks alike, so that no column can be without its explanation.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from operator import attrgetter
from typing import Any, NamedTuple

from app.persistence.models import Response, Study, StudySession
from app.schemas.codebook import Column, Kind, Level
from app.schemas.study import Scale, Stimulus, StudyDefinition


class Row(NamedTuple):
    """One answer with all that its cells are made of."""

    study: Study
    participant: StudySession
    answer: Response
    shown: Stimulus
    newest: bool


class Field(NamedTuple):
    """One column of the long table."""

    column: Column
    value: Callable[[Row], Any]


def long_fields(definition: StudyDefinition) -> list[Field]:
    """The table with one row an answer: one column a scale between what was shown and how."""
    scales = [
        Field(_scale_column(definition, scale, name), _answer_on(scale))
        for name, scale in about_scales(definition)
    ]
    return [*about_participant(), *_shown(definition), *scales, *_answered(definition)]


def about_scales(definition: StudyDefinition) -> list[tuple[str, Scale]]:
    """Each scale under its column's name in the long table: mostly its id."""
    others = (*about_participant(), *_shown(definition), *_answered(definition))
    # A scale may be called as a column that is always there: comment, study …
    names = unlike(
        (scale.id for scale in definition.scales), {field.column.name for field in others}
    )
    return list(zip(names, definition.scales, strict=True))


def wide_columns(definition: StudyDefinition) -> list[Column]:
    """The table with one row a participant: after its own facts, each clip's place and scales."""
    columns = [field.column for field in about_participant()]
    for stimulus, name in zip(definition.stimuli, clip_names(definition), strict=True):
        columns.append(
            Column(
                name=f"{name}__order",
                meaning=f"place of “{stimulus.label}” in this participant's order, from 0",
                type="integer",
            )
        )
        columns += [
            _scale_column(definition, scale, f"{name}__{scale.id}", stimulus.label)
            for scale in definition.scales
        ]
    names = unlike(column.name for column in columns)  # a scale may be called order
    return [
        column.model_copy(update={"name": name})
        for column, name in zip(columns, names, strict=True)
    ]


def clip_names(definition: StudyDefinition) -> list[str]:
    """Each clip's name as a part of a column's: letters, digits and _ alone, never twice."""
    return unlike(re.sub(r"\W+", "_", shown.name) for shown in definition.stimuli)


def unlike(wanted: Iterable[str], taken: Iterable[str] = ()) -> list[str]:
    """The wanted names, numbered where one would come again."""
    known, found = set(taken), []
    for name in wanted:
        free, number = name, 2
        while free in known:
            free, number = f"{name}_{number}", number + 1
        known.add(free)
        found.append(free)
    return found


def about_participant() -> list[Field]:
    """What is known of who answered, and in which study."""
    return [
        _field("study", "address of the study", "text", "study.slug"),
        _field("study_hash", "SHA-256 of the study's definition", "text", "study.definition_hash"),
        _field("session", "the participant's pseudonym", "text", "participant.id"),
        _field(
            "session_state", "how far the participant came", "category", "participant.state",
            levels={"complete": "answered everything", "active": "has not finished"},
        ),
        _field(
            "consent_version", "version of the text agreed to", "text",
            "participant.consent_version",
        ),
        _field(
            "device", "kind of device", "category", "participant.user_agent_class",
            levels={"phone": "phone", "tablet": "tablet", "desktop": "desktop or laptop"},
        ),
        _field("seed", "from which the order was drawn", "integer", "participant.seed"),
    ]  # fmt: skip


def _shown(definition: StudyDefinition) -> list[Field]:
    stimuli = definition.stimuli
    kinds = {"semantic_differential": "scales between two opposite words, beside a clip"}
    return [
        _field(
            "trial_type", "kind of trial", "category", lambda _: "semantic_differential",
            levels=kinds,
        ),
        _field(
            "trial_index", "place in this participant's order, from 0", "integer",
            "answer.trial_index",
        ),
        _field(
            "practice", "whether it was an unannounced practice clip", "category",
            lambda row: int(row.answer.practice), levels={0: "no", 1: "yes"},
        ),
        _field("revision", "1, 2, … for changed answers", "integer", "answer.revision"),
        _field(
            "newest", "whether it is the newest revision of this answer", "category",
            lambda row: int(row.newest), levels={0: "no, a newer one exists", 1: "yes"},
        ),
        _field(
            "stimulus", "the clip's name", "category", "shown.name",
            levels={shown.name: shown.label for shown in stimuli},
        ),
        _field(
            "body", "the body that the clip shows", "category", "shown.body",
            levels={shown.body: shown.body for shown in stimuli},
        ),
        _field(
            "style", "the style of the clip", "category", "shown.style",
            levels={shown.style: shown.style for shown in stimuli},
        ),
        _field("stimulus_hash", "the clip's content hash", "text", "shown.clip"),
    ]  # fmt: skip


def _answered(definition: StudyDefinition) -> list[Field]:
    asked = definition.comment.label
    return [
        _field(
            "touched", "scales set by hand, apart by spaces; the others kept the middle", "text",
            lambda row: " ".join(row.answer.record.get("touched", ())),
        ),
        _field("comment", f"free text: “{asked}”", "text", "answer.comment"),
        _field("rt_ms", "from the trial's start to the answer", "number", "answer.rt_ms", "ms"),
        _recorded("time_elapsed_ms", "since the page was opened", "number", "ms"),
        _recorded("plays", "how often the clip ran", "integer"),
        _recorded("viewing_ms", "how long the clip ran", "number", "ms"),
        _recorded("camera_moves", "how often the view was turned", "integer"),
        _recorded("hidden_ms", "how long the page was out of sight", "number", "ms"),
        _recorded("blur_count", "how often the window lost the focus", "integer"),
        _recorded("dropped_frames", "frames shown late", "integer", "frames"),
        _recorded("tier", "the drawing quality that the device was given", "text"),
        _of_viewport("width", "width of the page", "integer", "CSS pixels"),
        _of_viewport("height", "height of the page", "integer", "CSS pixels"),
        _of_viewport("pixel_ratio", "device pixels for one CSS pixel", "number", None),
        _recorded("client_time", "the browser's clock", "time"),
        _field(
            "received_at", "when the server stored the answer, UTC", "time",
            lambda row: row.answer.received_at.isoformat(),
        ),
    ]  # fmt: skip


def _answer_on(scale: Scale) -> Callable[[Row], Any]:
    return lambda row: row.answer.answers.get(scale.id)


def _scale_column(
    definition: StudyDefinition, scale: Scale, name: str, clip: str | None = None
) -> Column:
    meaning = f"from {scale.left} to {scale.right}; toward {scale.right} is positive"
    return Column(
        name=name,
        meaning=f"“{clip}”, {meaning}" if clip else meaning,
        type="integer",
        unit="steps",
        levels=tuple(
            Level(value=value, label=f"{word} {pole}" if pole else word)
            for value, word, pole in _steps(definition, scale)
        ),
    )


def _steps(definition: StudyDefinition, scale: Scale) -> Iterable[tuple[int, str, str]]:
    for value, word in enumerate(definition.steps, -definition.reach):
        yield value, word, scale.left if value < 0 else scale.right if value else ""


def _recorded(name: str, meaning: str, kind: Kind, unit: str | None = None) -> Field:
    return _field(name, meaning, kind, lambda row: row.answer.record.get(name), unit)


def _of_viewport(part: str, meaning: str, kind: Kind, unit: str | None) -> Field:
    return _field(
        f"viewport_{part}", meaning, kind,
        lambda row: (row.answer.record.get("viewport") or {}).get(part), unit,
    )  # fmt: skip


def _field(
    name: str,
    meaning: str,
    kind: Kind,
    value: str | Callable[[Row], Any],
    unit: str | None = None,
    levels: dict[Any, str] | None = None,
) -> Field:
    found = tuple(Level(value=key, label=label) for key, label in (levels or {}).items())
    column = Column(name=name, meaning=meaning, type=kind, unit=unit, levels=found)
    return Field(column, attrgetter(value) if isinstance(value, str) else value)
