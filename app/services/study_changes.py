"""What a new version of a study changes, in sentences that a colleague understands."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from pydantic import BaseModel

from app.schemas.study import (
    LANGUAGE_NAMES,
    AnyPart,
    Form,
    StudyDefinition,
    Trials,
    Words,
)

_PAGES = {"welcome": "The welcome page", "thanks": "The last page"}
_ORDERS = {
    "shuffle": "shuffled for each participant",
    "latin_square": "in a balanced Latin square",
    "fixed": "in the listed order",
}
_KINDS = {
    "semantic_differential": "opposite words",
    "unipolar": "qualities from not at all to very",
    "likert": "statements to agree with",
    "analogue": "sliders",
    "choose": "choosing one of several",
    "ab": "choosing one of two",
    "abx": "finding the equal one of two",
    "parallel": "several figures with a slider each",
    "ranking": "putting figures into order",
    "free_text": "own words",
    "match": "matching a motion with sliders",
}


def sentences(before: StudyDefinition | None, after: StudyDefinition) -> list[str]:
    """What `after` changes; none where nothing is new."""
    if before is None:
        clips = len({one.name for part in after.trials for one in part.stimuli})
        parts = _counted(len(after.parts), "part")
        return [f"The first version: {parts}, {_counted(clips, 'clip')}."]
    told = [*_whole(before, after), *_parts(before, after)]
    if not told and before.content_hash != after.content_hash:
        told = ["Details that no participant sees."]
    return told


def _whole(before: StudyDefinition, after: StudyDefinition) -> Iterator[str]:
    if before.title != after.title:
        yield f"The title is “{after.title}”."
    new, gone = _difference(before.languages, after.languages)
    if new or gone:
        yield from _come_and_gone("Language", _languages(new), _languages(gone))
    elif before.languages != after.languages:
        yield f"{LANGUAGE_NAMES[after.languages[0]]} stands first among the languages."
    for name, page in _PAGES.items():
        if getattr(before, name) != getattr(after, name):
            yield f"{page} is another."
    if before.consent.version != after.consent.version:
        yield f"The consent is version {after.consent.version}, before {before.consent.version}."
    new, gone = _difference(
        [group.label for group in before.groups], [group.label for group in after.groups]
    )
    yield from _come_and_gone("Group", new, gone)
    if before.blocks != after.blocks:
        yield "Other parts change places with each other."
    if before.back != after.back:
        yield f"Participants {'can' if after.back else 'cannot'} go back and change an answer."
    if before.contact != after.contact:
        yield f"The contact is {after.contact or 'left out'}."


def _parts(before: StudyDefinition, after: StudyDefinition) -> Iterator[str]:
    old = {part.id: part for part in before.parts}
    now = {part.id: part for part in after.parts}
    for name in [one for one in now if one not in old]:
        yield f"“{name}” is new{_with_clips(now[name])}."
    for name in [one for one in old if one not in now]:
        yield f"“{name}” is gone."
    if [name for name in old if name in now] != [name for name in now if name in old]:
        yield "The parts stand in another order."
    for name, part in now.items():
        if name in old and old[name] != part:
            yield from (f"“{name}”: {change}" for change in _part(old[name], part))


def _part(before: AnyPart, after: AnyPart) -> list[str]:
    if before.kind != after.kind:
        return [f"it is now of the kind {after.kind}."]
    told: list[str] = []
    if before.groups != after.groups:
        told.append("it is for other groups.")
    if isinstance(before, Trials) and isinstance(after, Trials):
        told += _trials(before, after)
    elif isinstance(before, Form) and isinstance(after, Form):
        told += _form(before, after)
    elif not told or _differs(before, after, besides={"groups"}):
        told.append("the text is another.")
    return told


def _form(before: Form, after: Form) -> Iterator[str]:
    yield from _named_things("question", before.fields, after.fields)
    if _differs(before, after, besides={"fields", "groups"}):
        yield "the text is another."


def _trials(before: Trials, after: Trials) -> Iterator[str]:
    yield from _clips(before, after)
    yield from _task(before, after)
    yield from _named_things("attention check", before.checks, after.checks)
    if before.order != after.order:
        yield f"the clips come {_ORDERS[after.order]}."
    if before.practice != after.practice:
        yield f"{_counted(after.practice, 'clip')} for practice, before {before.practice}."
    if before.subset != after.subset:
        yield (
            f"each participant sees {_counted(after.subset, 'clip')}."
            if after.subset
            else "each participant sees all clips."
        )
    if _differs(before, after, only={"block_by", "sets", "break_every"}):
        yield "clips stand together, or pauses come, in another way."


def _clips(before: Trials, after: Trials) -> Iterator[str]:
    old, now = ({one.name: one.clip for one in part.stimuli} for part in (before, after))
    new, gone = _difference(list(old), list(now))
    if new:
        yield f"{_counted(len(new), 'clip')} new ({_listed(new)})."
    if gone:
        yield f"{_counted(len(gone), 'clip')} gone ({_listed(gone)})."
    others = [str(name) for name in now if name in old and old[name] != now[name]]
    if others:
        yield f"{_listed(others)} {'moves' if len(others) == 1 else 'move'} in another way."


def _task(before: Trials, after: Trials) -> Iterator[str]:
    if before.task.kind != after.task.kind:
        yield f"it asks by {_KINDS[after.task.kind]}, before by {_KINDS[before.task.kind]}."
        return
    if before.task.question != after.task.question:
        yield _question(before.task.question, after.task.question)
    for name, word in (("scales", "scale"), ("items", "line")):
        if hasattr(after.task, name):
            yield from _named_things(word, getattr(before.task, name), getattr(after.task, name))
    listed = {"kind", "question", "scales", "items"}
    if _differs(before.task, after.task, besides=listed):
        yield "steps, hints or options are others."


def _question(before: Words, after: Words) -> str:
    """Says which languages keep the old wording: a translation is easily forgotten."""
    old, now = before.root, after.root
    if isinstance(old, str) or isinstance(now, str):
        return f"the question is “{after}”."
    changed = [language for language in now if now[language] != old.get(language)]
    kept = [language for language in now if language not in changed]
    if not kept:
        return f"the question is “{after}”."
    if not changed:
        return f"the question is in {_listed(_languages(kept))} alone."
    told = _listed(_languages(changed))
    words = f" is “{now[changed[0]]}”" if len(changed) == 1 else " changed"
    return f"the question in {told}{words}; in {_listed(_languages(kept))} it is as before."


def _named_things(word: str, before: Sequence[Any], after: Sequence[Any]) -> Iterator[str]:
    """Changes of a list whose members have an id."""
    old, now = ({one.id: one for one in things} for things in (before, after))
    new, gone = _difference(list(old), list(now))
    yield from (f"{line[0].lower()}{line[1:]}" for line in _come_and_gone(word, new, gone))
    changed = [name for name in now if name in old and now[name] != old[name]]
    if changed:
        yield f"{word} {_listed(changed)} changed."
    if [name for name in old if name in now] != [name for name in now if name in old]:
        yield f"the {word}s stand in another order."


def _come_and_gone(word: str, new: Sequence[str], gone: Sequence[str]) -> Iterator[str]:
    if new:
        yield f"{word} {_listed(new)} {'is' if len(new) == 1 else 'are'} new."
    if gone:
        yield f"{word} {_listed(gone)} {'is' if len(gone) == 1 else 'are'} gone."


def _difference(before: Sequence[Any], after: Sequence[Any]) -> tuple[list[str], list[str]]:
    """What came and what went, each in its order."""
    new = [str(one) for one in after if one not in before]
    return new, [str(one) for one in before if one not in after]


def _differs(
    before: BaseModel, after: BaseModel, *, only: Iterable[str] = (), besides: Iterable[str] = ()
) -> bool:
    names = set(only) or set(type(after).model_fields) - set(besides)
    return any(getattr(before, name) != getattr(after, name) for name in names)


def _with_clips(part: AnyPart) -> str:
    return f", with {_counted(len(part.stimuli), 'clip')}" if isinstance(part, Trials) else ""


def _languages(codes: Sequence[str]) -> list[str]:
    return [name for code, name in LANGUAGE_NAMES.items() if code in codes]


def _listed(names: Sequence[str], most: int = 4) -> str:
    """“a, b and c”; of many, the first and how many more."""
    if len(names) > most:
        return f"{', '.join(names[: most - 1])} and {len(names) - most + 1} more"
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def _counted(count: int, word: str) -> str:
    return f"{count} {word}{'' if count == 1 else 's'}"
