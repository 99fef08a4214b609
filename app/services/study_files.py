"""Study files, YAML or JSON: reading them with every fault at its line, and writing them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import yaml

from app.schemas.studies_api import Problem
from app.schemas.study import Running, StudyDefinition
from app.services import study_faults, study_rules
from app.services.study_text import Path, StudyText, StudyTextError, read_text, short, unstorable

_SINGULAR = {
    "fields": "field",
    "options": "option",
    "parts": "part",
    "scales": "scale",
    "items": "item",
    "stimuli": "stimulus",
    "checks": "check",
    "terms": "term",
    "figures": "figure",
    "groups": "group",
    "sets": "set",
    "steps": "step",
    "facts": "fact",
    "languages": "language",
    "blocks": "block",
    "operations": "step",
}


@dataclass(frozen=True)
class Fault:
    """What is wrong in a file.

    Attributes:
        line, column: counted from 1.
        where: the place in words, such as “part 2 (emotion) › task › scale 1”.
        path: the place for programs.
    """

    line: int
    column: int
    where: str
    message: str
    mend: str
    path: Path = ()

    def told(self, name: str) -> str:
        """As a compiler tells it, with the mend on a line of its own."""
        place = f"{self.where}: " if self.where else ""
        return f"{name}:{self.line}:{self.column}: {place}{self.message}\n    {self.mend}"


@dataclass(frozen=True)
class StudyFile:
    """A file as far as it could be read.

    Attributes:
        definition: None where the file describes no study.
        running: who may come and when; None where the file does not say, or says it wrongly.
        faults: in the order of lines; where there are any, it cannot be published.
    """

    definition: StudyDefinition | None = None
    running: Running | None = None
    faults: list[Fault] = field(default_factory=list)
    text: StudyText = field(default_factory=StudyText)

    def located(self, problems: list[Problem]) -> list[Fault]:
        """Problems that were found otherwise, such as clips that are not there, by their lines."""
        return _sorted(self.text, problems)


def read(text: str, name: str = "") -> StudyFile:
    """The study that a file describes, or all that is wrong with it.

    Args:
        text: YAML or JSON.
        name: the file's name; `.json` is read as JSON, without an ending the text decides.
    """
    try:
        known = read_text(text, name)
    except StudyTextError as error:
        return StudyFile(faults=[Fault(error.line, error.column, "", error.message, error.mend)])
    definition, running, problems = examine(known.data, known.bare)
    return StudyFile(definition, running, _sorted(known, problems), known)


def examine(
    document: Mapping[str, Any], bare: Mapping[Path, str] | None = None
) -> tuple[StudyDefinition | None, Running | None, list[Problem]]:
    """The study that a document describes, how it is run, and what is wrong with both.

    Args:
        document: a study file as data.
        bare: how values that are no text were written.
    """
    problems = [
        Problem(where=list(path), message=message, mend="Take it out.")
        for path, message in unstorable(document)
    ]
    if problems:
        return None, None, problems[: study_faults.MOST_FAULTS]
    given = {name: value for name, value in document.items() if name != "running"}
    definition, problems = study_faults.faults(StudyDefinition, given, bare=bare)
    running = None
    if "running" in document:
        running, more = study_faults.faults(
            Running, document["running"], under=("running",), bare=bare
        )
        problems += more
    if definition is not None:
        problems += study_rules.problems(definition, running)
    return definition, running, problems


def write(document: Mapping[str, Any]) -> str:
    """A study as the YAML that a person would write: nothing left out is spelled."""
    return yaml.dump(
        _plain(document), Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=96
    )


def in_words(document: object, path: Path) -> str:
    """A place as one says it: “part 2 (emotion) › task › scale 1 (sad_happy)”."""
    words: list[str] = []
    node: Any = document
    for step in path:
        node = _inside(node, step)
        if isinstance(step, int):
            many = words.pop() if words else "item"
            identity = node.get("id") if isinstance(node, Mapping) else None
            called = f" ({short(identity, 40)})" if isinstance(identity, str) else ""
            words.append(f"{_SINGULAR.get(many, f'{many} number')} {step + 1}{called}")
        else:
            words.append(short(step, 40))
    return " › ".join(words)


def _sorted(text: StudyText, problems: list[Problem]) -> list[Fault]:
    faults = [_fault(text, problem) for problem in problems]
    return sorted(faults, key=lambda fault: (fault.line, fault.column))[: study_faults.MOST_FAULTS]


def _fault(text: StudyText, problem: Problem) -> Fault:
    path = tuple(problem.where)
    line, column = text.place(path)
    where = in_words(text.data, path)
    return Fault(line, column, where, problem.message, problem.mend or "Change it.", path)


def _inside(node: Any, step: str | int) -> Any:  # noqa: ANN401 -- any JSON
    try:
        return node[step]
    except (KeyError, IndexError, TypeError):
        return None


def _plain(value: Any) -> Any:  # noqa: ANN401 -- any JSON
    """Without members that say nothing."""
    if isinstance(value, Mapping):
        return {name: _plain(one) for name, one in value.items() if one is not None}
    return [_plain(one) for one in value] if isinstance(value, list | tuple) else value


class _Dumper(yaml.SafeDumper):
    """Writes long texts as paragraphs, and lists indented below their name."""

    def increase_indent(self, flow: bool = False, indentless: bool = False) -> None:
        super().increase_indent(flow, False)

    def ignore_aliases(self, data: object) -> bool:
        return True


def _text(dumper: yaml.SafeDumper, text: str) -> yaml.ScalarNode:
    style = (
        "|" if "\n" in text and not any(line.endswith(" ") for line in text.split("\n")) else None
    )
    return dumper.represent_scalar("tag:yaml.org,2002:str", text, style=style)


_Dumper.add_representer(str, _text)
