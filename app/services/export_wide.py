"""The columns of the wide table: one row a participant, for each clip its place and its answer."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, NamedTuple

from app.schemas.codebook import Column
from app.schemas.study import OF_ONE, OF_TWO, Stimulus, Trials
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

# What a participant's newest answer was to: the part, and the clips that stood together.
Key = tuple[str, frozenset[str]]


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
        return cls(listed[-1], {(row.answer.part, frozenset(row.clips)): row for row in counted})


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
    parts = [part for version in versions for part in version.definition.trials]
    names = Counter(
        name for name, _ in {(one.name, part.id) for part in parts for one in part.stimuli}
    )
    for part_id, values in asked.items():
        if not values[0][1].of_clips:
            yield [_of_page(name, measure, versions) for name, measure in values]
            continue
        seen: set[Key] = set()
        own = [part for part in parts if part.id == part_id]
        for part in own:
            yield from _units(part, [one for _, one in values], versions, names, seen)


def _of_page(name: str, measure: Measure, versions: Sequence[Version]) -> WideField:
    key: Key = (measure.part, frozenset())
    return WideField(column_of(measure, name, versions), _reader(key, measure, None))


def _units(
    part: Trials,
    asked: list[Measure],
    versions: Sequence[Version],
    names: Counter[str | None],
    seen: set[Key],
) -> Iterator[list[WideField]]:
    """The columns of each trial of a part; `seen` are those of newer versions."""
    every = [[part.stimuli[place] for place in unit] for unit in units(part)]
    for number, together in enumerate(every, 1):
        key = part.id, frozenset(one.clip or "" for one in together)
        if key in seen:
            continue
        seen.add(key)
        before = "" if all(names[one.name] == 1 for one in together) else f"{part.id}__"
        name, label = _named(part, together, number, len(every))
        yield [
            _place(key, f"{before}{name}__order", label),
            *(
                field
                for measure in asked
                for field in _answers(key, measure, before + name, label, together, versions)
            ),
        ]


def _answers(
    key: Key,
    measure: Measure,
    name: str,
    label: str,
    together: list[Stimulus],
    versions: Sequence[Version],
) -> Iterator[WideField]:
    if measure.trial_type not in EACH_FIGURE:
        column = column_of(measure, f"{name}__{measure.id}", versions, label)
        yield WideField(column, _reader(key, measure, None))
        return
    for one in together:
        column = column_of(
            measure, f"{name}__{_word(one.name)}__{measure.id}", versions,
            str(one.label or one.name),
        )  # fmt: skip
        yield WideField(column, _reader(key, measure, one.clip))


def _named(part: Trials, together: list[Stimulus], number: int, of: int) -> tuple[str, str]:
    """How the columns of a trial begin, and what they are said to be about."""
    label = " / ".join(str(one.label or one.name) for one in together)
    if part.task.kind in OF_ONE:
        return _word(together[0].name), label
    if part.task.kind in OF_TWO:
        return "_vs_".join(_word(one.name) for one in together), label
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
