"""A study with one trial of every kind and one page of every kind, put onto a test's server."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path
from typing import Any

from app.persistence.engine import Database, make_engine
from app.schemas.study import StudyDefinition
from app.studies.adjectives import SCALES
from tests.support.published import add_published

SLUG = "every-kind"
Document = dict[str, Any]

SHORT_SCALES = [
    {"id": "sad_happy", "left": "sad", "right": "happy"},
    {"id": "weak_strong", "left": "weak", "right": "strong"},
]
STEPS = ["very", "rather", "neither", "rather", "very"]
QUALITIES = [{"id": name, "label": name} for name in ("friendly", "hurried", "clumsy")]
STATEMENTS = [
    {"id": "meet", "label": "I would like to meet this person."},
    {"id": "trust", "label": "I would ask this person the way."},
]
# Each kind of trial, how many figures its one trial shows, and what it asks.
TASKS: dict[str, tuple[int, Document]] = {
    "semantic_differential": (1, {
        "question": "The green walk is …", "scales": SCALES, "preselected": False,
        "steps": ["very", "rather", "as red", "rather", "very"],
    }),
    "unipolar": (1, {
        "question": "How much of this do you see?", "items": QUALITIES,
        "steps": ["not at all", "a little", "fairly", "very"],
    }),
    "likert": (1, {
        "question": "Do you agree?", "items": STATEMENTS, "steps": [
            "not at all", "hardly", "rather not", "neither", "rather", "mostly", "wholly",
        ],
    }),
    "analogue": (1, {"question": "Where between the two?", "scales": SHORT_SCALES}),
    "free_text": (1, {"question": "What is this person doing?", "required": True}),
    "choose": (10, {
        "question": "Which of these walks looks the most natural?", "allow_none": False,
        "hint": "All ten walk in step. Turn one and all turn. Look as often as you like.",
    }),
    "ab": (2, {"question": "Which of the two looks more natural?", "allow_same": True}),
    "abx": (2, {"question": "Is X the same as A, or as B?"}),
    "parallel": (4, {"question": "How natural is each?", "low": "not at all", "high": "wholly"}),
    "ranking": (4, {"question": "Order them.", "first": "most natural", "last": "least natural"}),
}  # fmt: skip
FORM: Document = {
    "kind": "form", "id": "about_you", "heading": "About you", "text": "A few facts, no name.",
    "fields": [
        {"id": "age", "label": "How old are you?", "type": "number", "minimum": 18,
         "maximum": 120, "unit": "years"},
        {"id": "hand", "label": "With which hand do you write?", "type": "choice", "options": [
            {"id": "left", "label": "Left"}, {"id": "right", "label": "Right"},
            {"id": "none", "label": "With neither", "screens_out": True}]},
        {"id": "dances", "label": "What do you dance?", "type": "choices", "required": False,
         "options": [{"id": "tango", "label": "Tango"}, {"id": "waltz", "label": "Waltz"}]},
        {"id": "town", "label": "Where do you live?", "type": "text"},
        {"id": "more", "label": "Anything that matters?", "type": "long_text", "required": False},
    ],
}  # fmt: skip


def add_every_kind(data_directory: Path) -> StudyDefinition:
    """Publish the study from the sample library of a server's data folder."""
    database = data_directory / "manner.sqlite3"
    definition = every_kind(_clips(database))
    engine = make_engine(f"sqlite:///{database}")
    with Database(engine).writing() as db:
        add_published(db, definition)
        db.commit()
    engine.dispose()
    return definition


def every_kind(clips: dict[str, str]) -> StudyDefinition:
    """The study's definition. ``clips``: name to id, of motion set A."""
    stimuli = [
        {"clip": clip, "name": name, "label": name, "body": "one", "style": name}
        for name, clip in sorted(clips.items())
    ]
    reference = clips["set_a_neutral"]
    trials = {kind: _trials(kind, stimuli, reference) for kind in TASKS}
    pause = {
        "kind": "break",
        "id": "rest",
        "heading": "Half of it is done",
        "text": "Rest a while.",
    }
    several = ("choose", "ab", "abx", "parallel", "ranking")
    return StudyDefinition.model_validate({
        "slug": SLUG, "title": "Every kind",
        "welcome": {
            "heading": "Every kind", "lead": "One of each.", "example": reference,
            "facts": ["a few clips", "a few minutes", "any device"],
        },
        "consent": {
            "version": "1", "heading": "Before you begin", "statement": "I agree.",
            "terms": [{"term": "What is kept", "text": "Your answers."}],
        },
        "parts": [
            FORM,
            {"kind": "instructions", "id": "how", "heading": "How it works",
             "text": "Watch the walks.\n\nThen say what you see.",
             "figures": [{"clip": reference, "caption": "an everyday walk"},
                         {"clip": clips["set_a_sad"], "caption": "another one"}]},
            *(part for kind, part in trials.items() if kind not in several), pause,
            *(trials[kind] for kind in several),
            {"kind": "comment", "id": "last_words", "question": "Anything else?"},
            {"kind": "debriefing", "id": "after", "heading": "What it was about",
             "text": "How a walk is seen."},
        ],
        "thanks": {"heading": "Thank you.", "text": "You judged {clips} movements."},
    })  # fmt: skip


def _trials(kind: str, stimuli: list[Document], reference: str) -> Document:
    figures, asks = TASKS[kind]
    task = {"kind": kind, **asks}
    if kind == "semantic_differential":
        task["reference"] = reference
    part: Document = {
        "kind": "trials", "id": f"the_{kind}", "task": task, "order": "fixed",
        "stimuli": stimuli[:figures],
    }  # fmt: skip
    if kind == "likert":
        part["checks"] = [{
            "kind": "instructed", "id": "reading", "text": "This time, choose “wholly” throughout.",
            "answers": {"meet": 7, "trust": 7},
        }]  # fmt: skip
    return part


def _clips(database: Path) -> dict[str, str]:
    with closing(sqlite3.connect(database)) as connection:
        return dict(connection.execute("select name, id from clips where name like 'set_a_%'"))
