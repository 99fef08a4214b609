"""Study files: read whole, or every fault told at its line with the mend."""

from __future__ import annotations

import json
import re
from pathlib import Path

import jsonschema
import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as some

from app.services import study_files, study_schema
from app.services.study_files import Fault
from tests.support.broken_studies import BROKEN

DOCUMENT = (Path(__file__).parents[3] / "docs" / "study-files.md").read_text()
GOOD = DOCUMENT.split("```yaml\n")[1].split("```")[0]


def faults(text: str, name: str = "study.yaml") -> list[Fault]:
    return study_files.read(text, name).faults


def line_of(text: str, needle: str) -> int:
    assert text.count(needle) == 1, f"{needle} stands there {text.count(needle)} times"
    return text.count("\n", 0, text.index(needle)) + 1


def test_the_documented_example_is_read_whole() -> None:
    read = study_files.read(GOOD, "study.yaml")
    assert read.faults == []
    assert read.definition is not None
    assert [part.id for part in read.definition.parts] == [
        "about_you", "how_it_works", "mood", "last_words", "about",
    ]  # fmt: skip
    assert read.running is not None
    assert read.running.quota == 40


def test_the_same_study_as_json_is_the_same_study() -> None:
    text = json.dumps(yaml.safe_load(GOOD), default=lambda moment: moment.isoformat(), indent="\t")
    as_json = study_files.read(text, "study.json")
    as_yaml = study_files.read(GOOD, "study.yaml")
    assert as_json.faults == []
    assert (as_json.definition, as_json.running) == (as_yaml.definition, as_yaml.running)


def test_the_json_schema_accepts_the_documented_example_and_refuses_a_misspelt_member() -> None:
    document = json.loads(json.dumps(yaml.safe_load(GOOD), default=str))
    validator = jsonschema.Draft202012Validator(study_schema.schema())
    assert list(validator.iter_errors(document)) == []
    document["parts"][2]["stimulli"] = []
    assert list(validator.iter_errors(document)) != []


def test_every_member_of_the_schema_is_documented() -> None:
    found: set[str] = set()

    def collect(node: object) -> None:
        if isinstance(node, dict):
            found.update(node.get("properties", {}))
            for inside in node.values():
                collect(inside)
        elif isinstance(node, list):
            for inside in node:
                collect(inside)

    collect(study_schema.schema())
    assert len(found) > 60
    assert [name for name in sorted(found) if f"`{name}" not in DOCUMENT] == []


def test_what_is_written_is_read_as_the_same() -> None:
    document = yaml.safe_load(GOOD)
    del document["running"]
    document["parts"][1]["text"] = {"en": "One.\n\nTwo: “three” # four", "fi": "- yksi\n  kaksi "}
    again = study_files.read(study_files.write(document), "study.yaml")
    given = study_files.read(json.dumps(document), "study.json")
    assert again.faults == given.faults == []
    assert again.definition == given.definition


@pytest.mark.parametrize("name", BROKEN)
def test_a_broken_file_names_the_line_and_the_mend(name: str) -> None:
    find, put, needle, message, mend = BROKEN[name]
    assert GOOD.count(find) == 1, f"{find} is no single place of the example"
    text = GOOD.replace(find, put)
    found = faults(text)
    assert found, "nothing was told"
    at = text.index(needle) + (1 if needle.startswith("\n") else 0)
    line = text.count("\n", 0, at) + 1
    told = [fault for fault in found if fault.line == line]
    assert told, f"told at {[(fault.line, fault.message) for fault in found]}, not {line}"
    assert any(
        re.search(message, fault.message) and re.search(mend, fault.mend) for fault in told
    ), [(fault.message, fault.mend) for fault in told]
    assert all(fault.mend and fault.message.endswith((".", "?")) for fault in found)


@pytest.mark.parametrize(
    ("text", "line", "column", "message"),
    [
        ('{"slug": "a",\n "title": }', 2, 11, "no JSON"),
        ('{"slug": "a",\n "slug": "b"}', 2, 2, "twice"),
        ('{"manner": NaN}', 1, 1, "number"),
        ("[" * 100_000, 1, 1, "deep"),
        ("[1, 2]", 1, 1, "no members"),
        ("", 1, 1, "no JSON"),
        ('{"slug": "a"', 1, 13, "no JSON"),
    ],
)
def test_json_is_told_at_its_place_as_well(text: str, line: int, column: int, message: str) -> None:
    first = faults(text, "study.json")[0]
    assert (first.line, first.column) == (line, column)
    assert message in first.message
    assert first.mend


def test_a_place_is_told_in_words_that_name_the_part_and_the_scale() -> None:
    text = GOOD.replace("{en: weak, fi: heikko}", "5")
    (fault,) = faults(text)
    assert fault.where == "part 3 (mood) › task › scale 2 (weak_strong) › left"
    assert fault.column == text.splitlines()[fault.line - 1].index("left") + 1
    assert fault.told("study.yaml").startswith(f"study.yaml:{fault.line}:11: part 3 (mood)")


def test_all_faults_are_told_at_once_in_the_order_of_lines() -> None:
    text = GOOD.replace("order: shuffle", "order: odd").replace("[en, fi]", "[en, xx]")
    text = text.replace("quota: 40", "quota: none")
    assert [fault.path for fault in faults(text)] == [
        ("languages", 1), ("parts", 2, "order"), ("running", "quota"),
    ]  # fmt: skip


def test_a_file_that_is_too_long_is_not_read_at_all() -> None:
    (fault,) = faults(f"title: {'x' * 2_000_001}")
    assert "2 MB" in fault.message


def test_repeats_that_would_grow_without_bound_are_refused_at_the_first() -> None:
    bomb = "a: &a [x, x]\n" + "".join(
        f"{new}: &{new} [*{old}, *{old}]\n" for old, new in zip("abcdefgh", "bcdefghi", strict=True)
    )
    (fault,) = faults(bomb)
    assert (fault.line, fault.column) == (1, 4)


HOSTILE = {
    "a script": "<script>alert(1)</script>",
    "an override to the left": "\u202egnikcah\u202c",
    "many signs": "x" * 100_000,
    "NUL": "before\x00after",
    "half a character": "\ud800",
    "an escape to the terminal": "\x1b[2J",
    "a formula": "=HYPERLINK(1)",
    "a template": "{{ 7 * 7 }}{% raw %}",
    "quotes": "'\"`\\",
    "a line end": "a\r\nb\u2028c",
}
KEPT = {"a script", "an override to the left", "a formula", "a template", "quotes", "a line end"}


def texts(node: object, path: tuple[str | int, ...] = ()) -> list[tuple[str | int, ...]]:
    """Where text stands in a document."""
    if isinstance(node, str):
        return [path]
    inside = (
        node.items()
        if isinstance(node, dict)
        else enumerate(node)
        if isinstance(node, list)
        else ()
    )
    return [one for key, value in inside for one in texts(value, (*path, key))]


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_text_in_any_field_is_kept_as_text_or_told_but_never_a_crash(name: str) -> None:
    document = json.loads(json.dumps(yaml.safe_load(GOOD), default=str))
    kept = 0
    for path in texts(document):
        spoiled = json.loads(json.dumps(document))
        node = spoiled
        for step in path[:-1]:
            node = node[step]
        node[path[-1]] = HOSTILE[name]
        read = study_files.read(json.dumps(spoiled), "study.json")
        if read.faults:
            assert all(len(fault.told("f")) < 1000 for fault in read.faults)
            assert all(
                sign not in fault.told("f") for fault in read.faults for sign in "\x00\x1b\u202e"
            )
        else:
            kept += 1
            assert read.definition is not None
            dumped = read.definition.model_dump_json()
            assert json.dumps(HOSTILE[name].strip(), ensure_ascii=False)[1:-1] in dumped
    assert (kept > 20) == (name in KEPT)


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_names_of_members_are_told_and_never_a_crash(name: str) -> None:
    document = json.loads(json.dumps(yaml.safe_load(GOOD), default=str))
    for target in (document, document["parts"][2], document["parts"][2]["task"]["scales"][0]):
        target[HOSTILE[name]] = "x"
    found = faults(json.dumps(document), "study.json")
    assert found
    assert all(len(fault.told("f")) < 1000 for fault in found)


@given(some.text(max_size=300))
def test_whatever_stands_in_a_file_is_data_or_a_fault(text: str) -> None:
    for name in ("a.yaml", "a.json", ""):
        read = study_files.read(text, name)
        assert (read.definition is None) == bool(read.faults)


@given(some.recursive(
    some.none() | some.booleans() | some.integers() | some.floats() | some.text(max_size=5),
    lambda inside: some.lists(inside, max_size=4)
    | some.dictionaries(
        some.sampled_from(["parts", "kind", "trials", "task", "stimuli", "id", "languages"])
        | some.text(max_size=5),
        inside, max_size=5,
    ), max_leaves=20,
))  # fmt: skip
def test_whatever_data_is_no_study_is_told_as_problems(document: object) -> None:
    definition, _, problems = study_files.examine(
        document if isinstance(document, dict) else {"parts": document}
    )
    assert definition is None
    assert problems
    assert all(problem.message for problem in problems)
