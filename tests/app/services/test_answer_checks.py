"""Answers fit what was asked, for every kind of trial and page; attention checks hold or do not."""

from __future__ import annotations

from typing import Any

import pytest

from app.schemas.study import Catch, Instructed, Repeated
from app.services.answer_checks import faults_of, held, screens_out
from tests.support.study_files import study, trials

FORM = {
    "kind": "form", "id": "you", "heading": "You",
    "fields": [
        {"id": "age", "label": "Age", "type": "number", "minimum": 18, "maximum": 120},
        {"id": "name", "label": "Name", "required": False},
        {
            "id": "eyes", "label": "Eyes", "type": "choice",
            "options": [{"id": "good", "label": "Good"},
                        {"id": "bad", "label": "Bad", "screens_out": True}],
        },
        {
            "id": "sports", "label": "Sports", "type": "choices", "required": False,
            "options": [{"id": "run", "label": "Run"}, {"id": "swim", "label": "Swim"}],
        },
    ],
}  # fmt: skip
GOOD: list[tuple[str, dict[str, Any], dict[str, Any]]] = [
    ("semantic_differential", {}, {"sad_happy": -2, "weak_strong": 2}),
    ("unipolar", {}, {"natural": 0, "human": 4}),
    ("likert", {}, {"natural": 1, "human": 5}),
    ("analogue", {}, {"sad_happy": 0, "weak_strong": 99.5}),
    ("choose", {}, {"choice": 2}),
    ("choose", {"allow_none": True}, {"choice": -1}),
    ("ab", {}, {"choice": 1}),
    ("ab", {"allow_same": True}, {"choice": -1}),
    ("abx", {}, {"choice": 0}),
    ("parallel", {}, {"0": 0, "1": 50.5, "2": 100}),
    ("ranking", {}, {"0": 3, "1": 1, "2": 2}),
    ("free_text", {}, {"text": "limps"}),
    ("free_text", {"required": False}, {"text": ""}),
]
BAD: list[tuple[str, dict[str, Any], dict[str, Any], str]] = [
    ("semantic_differential", {}, {"sad_happy": 0}, "not answered"),
    ("semantic_differential", {}, {"sad_happy": 3, "weak_strong": 0}, "not within"),
    ("semantic_differential", {}, {"sad_happy": 0.5, "weak_strong": 0}, "no step"),
    ("semantic_differential", {}, {"sad_happy": "0", "weak_strong": 0}, "no step"),
    ("semantic_differential", {}, {"sad_happy": 0, "weak_strong": 0, "x": 0}, "not asked"),
    ("unipolar", {}, {"natural": -1, "human": 0}, "not within"),
    ("likert", {}, {"natural": 0, "human": 1}, "not within"),
    ("analogue", {}, {"sad_happy": 100.1, "weak_strong": 0}, "not within"),
    ("choose", {}, {"choice": 3}, "not within"),
    ("choose", {}, {"choice": -1}, "not within"),
    ("ab", {}, {"choice": -1}, "not within"),
    ("abx", {}, {"choice": 2}, "not within"),
    ("parallel", {}, {"0": 0, "1": 50}, "not answered"),
    ("ranking", {}, {"0": 1, "1": 1, "2": 2}, "same rank"),
    ("free_text", {}, {"text": "  "}, "not answered"),
    ("free_text", {}, {"text": 3}, "no text"),
]


def part(kind: str, task: dict[str, Any]) -> Any:
    return study(trials(kind, 2 if kind in ("ab", "abx") else 3, task=task)).parts[0]


def figures(kind: str) -> int:
    return 2 if kind in ("ab", "abx") else 3


@pytest.mark.parametrize(("kind", "task", "answers"), GOOD)
def test_a_whole_answer_has_no_fault(
    kind: str, task: dict[str, Any], answers: dict[str, Any]
) -> None:
    assert faults_of(part(kind, task), answers, figures(kind)) == []


@pytest.mark.parametrize(("kind", "task", "answers", "fault"), BAD)
def test_what_does_not_fit_is_named(
    kind: str, task: dict[str, Any], answers: dict[str, Any], fault: str
) -> None:
    found = faults_of(part(kind, task), answers, figures(kind))
    assert len(found) == 1
    assert fault in found[0]


@pytest.mark.parametrize(
    ("answers", "fault"),
    [
        ({"age": 30, "eyes": "good"}, None),
        ({"age": 30, "eyes": "good", "name": "", "sports": ["run", "swim"]}, None),
        ({"eyes": "good"}, "“age” is not answered"),
        ({"age": 17, "eyes": "good"}, "not within"),
        ({"age": "old", "eyes": "good"}, "no number"),
        ({"age": 30, "eyes": "blue"}, "none of its options"),
        ({"age": 30, "eyes": "good", "sports": ["chess"]}, "none of its options"),
        ({"age": 30, "eyes": "good", "sports": "run"}, "none of its options"),
        ({"age": 30, "eyes": "good", "shoe": 44}, "not asked"),
    ],
)
def test_a_form_takes_what_its_fields_say(answers: dict[str, Any], fault: str | None) -> None:
    found = faults_of(study(FORM).parts[0], answers, 0)
    assert (found == []) if fault is None else (len(found) == 1 and fault in found[0])


def test_pages_without_a_question_take_nothing() -> None:
    page = study({"kind": "break", "id": "rest", "heading": "Rest", "text": "A while."}).parts[0]
    assert faults_of(page, {}, 0) == []
    assert faults_of(None, {}, 0) == []
    assert len(faults_of(None, {"a": 1}, 0)) == 1


def test_only_the_options_that_say_so_end_the_study() -> None:
    form = study(FORM).parts[0]
    assert screens_out(form, {"age": 30, "eyes": "bad"})
    assert not screens_out(form, {"age": 30, "eyes": "good", "sports": ["run"]})
    assert not screens_out(part("choose", {}), {"choice": 1})


def test_checks_hold_when_the_answer_is_the_one_told_close_enough_or_in_range() -> None:
    told = Instructed.model_validate({"id": "a", "text": "Choose 2.", "answers": {"x": 2}})
    assert held(told, {"x": 2, "y": 0}, None) is True
    assert held(told, {"x": 1, "y": 0}, None) is False
    again = Repeated(id="b", within=0.5)
    assert held(again, {"x": 2, "y": 0}, {"x": 1, "y": 0}) is True
    assert held(again, {"x": 2, "y": 0}, {"x": 0, "y": 0}) is False
    assert held(again, {"x": 2}, None) is None
    lax = Repeated(id="b", within=2)
    assert held(lax, {"choice": 1}, {"choice": 1}, chosen=True) is True
    assert held(lax, {"choice": 1}, {"choice": 0}, chosen=True) is False
    easy = Catch.model_validate(
        {"id": "c", "stimulus": {"clip": "lying"}, "answers": {"x": [-2, -1]}}
    )
    assert held(easy, {"x": -1}, None) is True
    assert held(easy, {"x": 0}, None) is False
    assert held(easy, {}, None) is False
