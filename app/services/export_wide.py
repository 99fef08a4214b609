"""The columns of the wide table: one row a participant, for each clip its place and its answer."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, NamedTuple

from app.schemas.codebook import Column
from app.schemas.study import OF_ONE, OF_TWO, Match, Stimulus, Trials
from app.services.export_columns import (
    Field,
    about_participant,
    column_of,
    named_measures,
    unlike,
)
from app.services.export_rows import Row, value_of
from app.services.measures import EACH_FIGURE, Measure
from app.services.plans import units
from app.services.versions import Version

# What a participant's newest answer was to: the part, the clips that stood together and, where a
# clip is asked about in several ways, which of them.
Key = tuple[str, frozenset[str], str]


class Person(NamedTuple):
    """One participant's rows: any of them, and of each trial the newest that counts."""

    any: Row
    newest: dict[Key, Row]

    @classmethod
    def of(cls, rows: Iterable[Row]) -> Person:
        """The participant of these rows; practice and attention checks do not count."""
        listed = list(rows)
        counted = [
            row
            for row in listed
            if row.newest and not row.answer.practice and row.answer.check is None
        ]
        return cls(
            listed[-1],
            {(row.answer.part, frozenset(row.clips), _way(row)): row for row in counted},
        )


def _way(row: Row) -> str:
    """In which of several ways a clip was asked about: a target, by every interface."""
    if row.answer.trial_type != "match":
        return ""
    return way_of(row.answer.answers["interface"], seen=bool(row.answer.answers["seen"]))


def way_of(interface: str, *, seen: bool) -> str:
    """How the columns of a guess, or of a match, with an interface begin."""
    return f"{interface}_{'match' if seen else 'guess'}"


class WideField(NamedTuple):
    """One column of the wide table."""

    column: Column
    value: Callable[[Person], Any]


def wide_fields(versions: Sequence[Version]) -> list[WideField]:
    """All columns of the wide table, of all versions, the newest first in `versions`."""
    fields = [_of_person(one) for one in about_participant(versions)]
    for part in _pages_and_trials(versions):
        fields += part
    names = unlike(one.column.name for one in fields)
    return [
        one._replace(column=one.column.model_copy(update={"name": name}))
        for one, name in zip(fields, names, strict=True)
    ]


def _of_person(field: Field) -> WideField:
    return WideField(field.column, lambda person: field.value(person.any))


def _pages_and_trials(versions: Sequence[Version]) -> Iterator[list[WideField]]:
    asked: dict[str, list[tuple[str, Measure]]] = {}
    for name, measure in named_measures(versions):
        asked.setdefault(measure.part, []).append((name, measure))
    groups = _groups(versions)
    names = dict(zip(groups, unlike(one.name for one in groups.values()), strict=True))
    for part, values in asked.items():
        if not values[0][1].of_clips:
            yield [_of_page(name, measure, versions) for name, measure in values]
        for key, group in groups.items():
            if key[0] == part:
                begun = group._replace(name=names[key])
                yield _of_group(key, begun, [measure for _, measure in values], versions)


class Group(NamedTuple):
    """Clips that stand together in a trial: how its columns begin, and what they are about."""

    name: str
    label: str
    clips: list[Stimulus]


def _groups(versions: Sequence[Version]) -> dict[Key, Group]:
    """Each trial of each part; clips that are in several parts have the part's name before them."""
    parts = [part for version in versions for part in version.definition.trials]
    used = Counter(name for name, _ in {(one.name, p.id) for p in parts for one in p.stimuli})
    found: dict[Key, Group] = {}
    for part in parts:
        every = [[part.stimuli[place] for place in unit] for unit in units(part)]
        for number, clips in enumerate(every, 1):
            name, label = _named(part, clips, number, len(every))
            alone = all(used[one.name] == 1 for one in clips) or len(clips) == len(part.stimuli) > 2
            begun = name if alone else f"{part.id}__{name}"
            stood = frozenset(one.clip or "" for one in clips)
            for way in _ways(part):
                called = f"{begun}__{way}" if way else begun
                told = f"{label}, {way.replace('_', ', ')}" if way else label
                found.setdefault((part.id, stood, way), Group(called, told, clips))
    return found


def _ways(part: Trials) -> list[str]:
    task = part.task
    if not isinstance(task, Match):
        return [""]
    rounds = (False, True) if task.guess_first else (True,)
    return [way_of(one, seen=seen) for seen in rounds for one in task.interfaces]


def _of_page(name: str, measure: Measure, versions: Sequence[Version]) -> WideField:
    key: Key = (measure.part, frozenset(), "")
    return WideField(column_of(measure, name, versions), _reader(key, measure, None))


def _of_group(
    key: Key, group: Group, asked: list[Measure], versions: Sequence[Version]
) -> list[WideField]:
    fields = [_place(key, f"{group.name}__order", group.label)]
    for measure in asked:
        if not (key[2] and measure.id in ("interface", "seen")):  # the column's name says it
            fields += _answers(key, measure, group, versions)
    return fields


def _answers(
    key: Key, measure: Measure, group: Group, versions: Sequence[Version]
) -> Iterator[WideField]:
    if measure.trial_type not in EACH_FIGURE:
        column = column_of(measure, f"{group.name}__{measure.id}", versions, group.label)
        yield WideField(column, _reader(key, measure, None))
        return
    for one in group.clips:
        label = str(one.label or one.name)
        name = f"{group.name}__{_word(one.name)}__{measure.id}"
        yield WideField(column_of(measure, name, versions, label), _reader(key, measure, one.clip))


def _named(part: Trials, clips: list[Stimulus], number: int, of: int) -> tuple[str, str]:
    label = " / ".join(str(one.label or one.name) for one in clips)
    if part.task.kind in OF_ONE:
        return _word(clips[0].name), label
    if part.task.kind in OF_TWO:
        return "_vs_".join(_word(one.name) for one in clips), label
    return (part.id, str(part.task.question)) if of == 1 else (f"{part.id}_{number}", label)


def _place(key: Key, name: str, label: str) -> WideField:
    column = Column(
        name=name, meaning=f"place of “{label}” in this participant’s order, from 0", type="integer"
    )

    def value(person: Person) -> int | None:
        row = person.newest.get(key)
        return row.answer.trial_index if row else None

    return WideField(column, value)


def _reader(key: Key, measure: Measure, clip: str | None) -> Callable[[Person], Any]:
    def value(person: Person) -> Any:  # noqa: ANN401 -- a cell
        row = person.newest.get(key)
        if row is None:
            return None
        figure = row.clips.index(clip) if clip is not None else None
        return value_of(measure, row._replace(figure=figure))

    return value


def _word(name: str | None) -> str:
    """A name as a part of a column's: letters, digits and _ alone."""
    return re.sub(r"\W+", "_", name or "")
