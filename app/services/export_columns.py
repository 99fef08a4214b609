"""The columns of the exported long table: what each one means and where its value comes from.

Said once for tables and codebooks alike, so that no column can be without its explanation. The
table has one row an answer; an answer that gives each of several figures a number (parallel rating,
ranking) has one row a figure, so that every kind has one clip and one value a row.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from operator import attrgetter
from typing import Any, NamedTuple

from app.schemas.codebook import Column, Kind, Level
from app.schemas.study import Trials
from app.services.export_rows import Row, value_of
from app.services.measures import EACH_FIGURE, Measure, measures
from app.services.versions import Version

BETWEEN = "|"  # between several names in one cell
SLIDERS = ("analogue", "parallel")


class Field(NamedTuple):
    """One column of the long table."""

    column: Column
    value: Callable[[Row], Any]


def long_fields(versions: Sequence[Version]) -> list[Field]:
    """All columns of the long table, of all versions, the newest first in `versions`."""
    asked = named_measures(versions)
    values = [field for name, measure in asked for field in _asked(name, measure, versions)]
    return [*about_participant(versions), *_shown(versions), *values, *_viewed()]


def named_measures(versions: Sequence[Version]) -> list[tuple[str, Measure]]:
    """Each value that the study asks for under its column's name: mostly its id.

    One that several parts ask for has the part's name before it: `walks__sad_happy`.
    """
    found: dict[tuple[str, str], Measure] = {}
    for version in versions:
        for part in version.definition.parts:
            for measure in measures(part):
                found.setdefault((part.id, measure.id), measure)
    always = {
        field.column.name for field in (*about_participant(versions), *_shown(versions), *_viewed())
    }
    asked = Counter(name for _, name in found)
    names = [
        name if asked[name] == 1 and name not in always else f"{part}__{name}"
        for part, name in found
    ]
    return list(zip(unlike(names, always), found.values(), strict=True))


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


def about_participant(versions: Sequence[Version]) -> list[Field]:
    """What is known of who answered, and in which study."""
    groups = {group.id: str(group.label) for one in versions for group in one.definition.groups}
    return [
        field("study", "address of the study", "text", "study.slug"),
        field("version", "the version that was answered", "integer", "version.number"),
        field("study_hash", "SHA-256 of the version’s definition", "text", "version.hash"),
        field("session", "the participant’s pseudonym", "text", "participant.id"),
        field(
            "kind", "whether it was a person", "category", "participant.kind",
            levels={"participant": "a person", "simulated": "simulated, with known effects"},
        ),
        field(
            "session_state", "how far the participant came", "category", "participant.state",
            levels={
                "complete": "answered everything", "active": "has not finished",
                "screened_out": "an answer ended the study",
                "failed_attention": "failed attention checks ended the study",
            },
        ),
        field(
            "excluded", "whether a researcher left the participant out of the results",
            "category", lambda row: int(row.participant.excluded is not None), levels=NO_YES,
        ),
        field(
            "excluded_reason", "why", "text",
            lambda row: (row.participant.excluded or {}).get("reason"),
        ),
        field(
            "group", "between-subject group", "category", "participant.group", levels=groups
        ),
        field("slot", "place in the study’s design, from 0", "integer", "participant.slot"),
        field("language", "language of the texts", "category", "participant.language"),
        field(
            "source", "from where the participant came", "category", "participant.source",
            levels={
                "open": "the study’s address", "personal": "a personal link",
                "prolific": "Prolific", "sona": "SONA", "mturk": "Mechanical Turk",
            },
        ),
        field(
            "consent_version", "version of the text agreed to", "text",
            "participant.consent_version",
        ),
        field(
            "device", "kind of device", "category", "participant.user_agent_class",
            levels={"phone": "phone", "tablet": "tablet", "desktop": "desktop or laptop"},
        ),
        field("seed", "from which the orders were drawn", "integer", "participant.seed"),
    ]  # fmt: skip


NO_YES = {0: "no", 1: "yes"}


def _shown(versions: Sequence[Version]) -> list[Field]:
    parts = {part.id: part for one in reversed(versions) for part in one.definition.parts}
    kinds = {
        kind: kind.replace("_", " ")
        for kind in (
            part.task.kind if isinstance(part, Trials) else part.kind for part in parts.values()
        )
    }
    checks = {
        check.id: f"{check.kind} check of {part.id}"
        for part in parts.values()
        if isinstance(part, Trials)
        for check in part.checks
    }
    known = {one.name or "": one for version in versions for one in version.shown.values()}
    return [
        field(
            "part", "the part of the study", "category", "answer.part",
            levels={name: part.kind for name, part in parts.items()},
        ),
        field("trial_type", "kind of trial, or of page", "category", "answer.trial_type",
              levels=kinds),
        field("trial_index", "place in this participant’s order, from 0", "integer",
              "answer.trial_index"),
        field("practice", "whether it was an unannounced practice clip", "category",
              lambda row: int(row.answer.practice), levels=NO_YES),
        field("check", "the attention check that this trial was", "category", "answer.check",
              levels=checks),
        field("passed", "whether the attention check held", "category",
              lambda row: None if row.answer.passed is None else int(row.answer.passed),
              levels=NO_YES),
        field("revision", "1, 2, … for changed answers", "integer", "answer.revision"),
        field(
            "newest", "whether it is the newest revision of this answer", "category",
            lambda row: int(row.newest), levels={0: "no, a newer one exists", 1: "yes"},
        ),
        field("figure", "of several figures with a number each, the place on the page, from 0",
              "integer", "figure"),
        field(
            "stimulus", "the name of the clip that the row is about", "category",
            lambda row: row.name_of(row.clip) if row.clip else None,
            levels={name: str(one.label or name) for name, one in known.items()},
        ),
        field("body", "the body that the clip shows", "category", _of_stimulus("body"),
              levels={one.body: one.body for one in known.values() if one.body}),
        field("style", "the style of the clip", "category", _of_stimulus("style"),
              levels={one.style: one.style for one in known.values() if one.style}),
        field("stimulus_hash", "the clip’s id in the library, 64 digits", "text", "clip"),
        field("stimuli", f"names of all clips of the trial, from the left, parted by {BETWEEN}",
              "text", lambda row: BETWEEN.join(map(row.name_of, row.clips)) or None),
        field("stimuli_hashes", f"the ids of the same, parted by {BETWEEN}", "text",
              lambda row: BETWEEN.join(row.clips) or None),
        field("engine_version", "of the engine that made the clip (the first, of several)", "text",
              lambda row: row.version.engines.get(row.clips[0]) if row.clips else None),
    ]  # fmt: skip


def _of_stimulus(name: str) -> Callable[[Row], Any]:
    def value(row: Row) -> Any:  # noqa: ANN401 -- a cell
        if row.clip is None:
            return None
        return getattr(row.version.stimulus(row.answer.part, row.clip), name)

    return value


def _asked(name: str, measure: Measure, versions: Sequence[Version]) -> list[Field]:
    column = column_of(measure, name, versions)
    found = [Field(column, lambda row: value_of(measure, row))]
    if measure.id == "choice":
        meaning = "the chosen clip’s id in the library; empty: none of them"
        found.append(field(f"{name}__hash", meaning, "text", lambda row: _chosen(row, measure)))
    if measure.trial_type in SLIDERS:
        key = None if measure.trial_type in EACH_FIGURE else measure.id
        found.append(
            field(
                f"{name}__start", "where the slider stood before it was touched; empty: nowhere",
                "number", lambda row: _start(row, measure.part, key), measure.unit,
            )
        )  # fmt: skip
    return found


def _chosen(row: Row, measure: Measure) -> str | None:
    choice = row.answer.answers.get("choice", -1) if row.answer.part == measure.part else -1
    return row.clips[choice] if choice >= 0 else None


def _start(row: Row, part: str, key: str | None) -> float | None:
    if row.answer.part != part:
        return None
    start: dict[str, float] = row.answer.record.get("start") or {}
    return start.get(str(row.figure) if key is None else key)


def column_of(measure: Measure, name: str, versions: Sequence[Version], about: str = "") -> Column:
    """A measure as a column; `about` says of which clip, where the column is of one alone."""
    levels = dict(measure.levels)
    if measure.id == "choice" and not levels:
        levels = {
            one.name: str(one.label or one.name)
            for version in versions
            for (part, _), one in version.shown.items()
            if part == measure.part and one.name
        }
    return Column(
        name=name,
        meaning=f"“{about}”, {measure.title}" if about else measure.title,
        type=measure.type,
        unit=measure.unit,
        levels=tuple(Level(value=value, label=label) for value, label in levels.items()),
    )


def _viewed() -> list[Field]:
    return [
        field(
            "touched", "what was set by hand; the others kept what was preselected", "text",
            lambda row: " ".join(row.answer.record.get("touched", ())),
        ),
        field("comment", "free text about the clip", "text", "answer.comment"),
        field("rt_ms", "from the trial’s start to the answer", "number", "answer.rt_ms", "ms"),
        _recorded("time_elapsed_ms", "since the page was opened", "number", "ms"),
        _recorded("plays", "how often the clip ran", "integer"),
        _recorded("viewing_ms", "how long the clip ran", "number", "ms"),
        field("figures_ms", f"of several figures, how long each ran in view, parted by {BETWEEN}",
              "text", _each_viewed, "ms"),
        _recorded("camera_moves", "how often the view was turned", "integer"),
        _recorded("hidden_ms", "how long the page was out of sight", "number", "ms"),
        _recorded("blur_count", "how often the window lost the focus", "integer"),
        _recorded("dropped_frames", "frames shown late", "integer", "frames"),
        _recorded("tier", "the drawing quality that the device was given", "text"),
        _of_viewport("width", "width of the page", "integer", "CSS pixels"),
        _of_viewport("height", "height of the page", "integer", "CSS pixels"),
        _of_viewport("pixel_ratio", "device pixels for one CSS pixel", "number", None),
        _recorded("client_time", "the browser’s clock", "time"),
        field(
            "received_at", "when the server stored the answer, UTC", "time",
            lambda row: row.answer.received_at.isoformat(),
        ),
    ]  # fmt: skip


def _each_viewed(row: Row) -> str | None:
    times: list[float] = row.answer.record.get("figure_ms") or []
    return BETWEEN.join(f"{one:g}" for one in times) or None


def _recorded(name: str, meaning: str, kind: Kind, unit: str | None = None) -> Field:
    return field(name, meaning, kind, lambda row: row.answer.record.get(name), unit)


def _of_viewport(part: str, meaning: str, kind: Kind, unit: str | None) -> Field:
    return field(
        f"viewport_{part}", meaning, kind,
        lambda row: (row.answer.record.get("viewport") or {}).get(part), unit,
    )  # fmt: skip


def field(
    name: str,
    meaning: str,
    kind: Kind,
    value: str | Callable[[Row], Any],
    unit: str | None = None,
    levels: dict[Any, str] | None = None,
) -> Field:
    """A column with where its cells come from: an attribute's path, or a function of the row."""
    found = tuple(Level(value=key, label=label) for key, label in (levels or {}).items())
    column = Column(name=name, meaning=meaning, type=kind, unit=unit, levels=found)
    return Field(column, attrgetter(value) if isinstance(value, str) else value)
