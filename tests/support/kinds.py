"""A study with every kind of trial and page, on clips without motion."""

from __future__ import annotations

from typing import Any

from sqlalchemy.orm import Session

from app.persistence.models import ClipRecord, Study, StudyVersion
from app.schemas.study import StudyDefinition
from app.services import studies
from tests.support.published import add_version
from tests.support.simulate import add_study

SLUG = "every-kind"
STEPS = ["very", "rather", "neither", "rather", "very"]
SCALE = {"id": "sad_happy", "left": "sad", "right": "happy"}
STYLES = ("angry", "happy", "neutral", "sad")


def add_every_kind(db: Session, **changes: Any) -> Study:
    """The study, published as its first version."""
    add_study(db)
    study = Study(slug=SLUG, title="Every kind", state="open", running={})
    db.add(study)
    db.flush()
    publish(db, study, definition(clips(db)) | changes)
    return study


def publish(db: Session, study: Study, told: dict[str, Any]) -> StudyVersion:
    """The next version of a study."""
    made = StudyDefinition.model_validate(told)
    number = 1 if not studies.store.newest_version(db, study) else None
    version = add_version(db, study, made, number or studies.newest(db, study).number + 1)
    db.commit()
    return version


def clips(db: Session) -> list[dict[str, Any]]:
    """Four acted clips of one body as stimuli."""
    found = {clip.name: clip for clip in db.query(ClipRecord)}
    return [
        {
            "clip": found[f"acted_female_{style}"].id, "name": style, "label": f"{style} walk",
            "body": "female", "style": style,
        }
        for style in STYLES
    ]  # fmt: skip


def definition(stimuli: list[dict[str, Any]]) -> dict[str, Any]:
    """What the study asks: each kind of trial once, and each kind of page."""
    asked = {
        "pairs": {"kind": "semantic_differential", "scales": [SCALE], "steps": STEPS},
        "qualities": {
            "kind": "unipolar", "items": [{"id": "calm", "label": "calm"}], "steps": STEPS,
        },
        "agreement": {
            "kind": "likert", "items": [{"id": "real", "label": "It looks real."}], "steps": STEPS,
        },
        "sliders": {"kind": "analogue", "scales": [SCALE]},
        "best": {"kind": "choose", "allow_none": True},
        "two": {"kind": "ab", "allow_same": True},
        "third": {"kind": "abx"},
        "together": {"kind": "parallel", "low": "bad", "high": "good"},
        "order": {"kind": "ranking", "first": "best", "last": "worst"},
        "words": {"kind": "free_text"},
    }  # fmt: skip
    trials = [
        {"kind": "trials", "id": name, "stimuli": stimuli, "task": {"question": "Why?"} | task}
        for name, task in asked.items()
    ]
    trials[0] |= {
        "practice": 1,
        "checks": [
            {"kind": "instructed", "id": "read", "text": "Very sad", "answers": {"sad_happy": -2}},
            {"kind": "repeated", "id": "again"},
        ],
    }
    return {
        "slug": SLUG,
        "title": "Every kind",
        "welcome": {"heading": "Hello", "lead": "Look", "facts": ["a", "b", "c"]},
        "consent": {"version": "1", "heading": "Consent", "terms": [], "statement": "I agree"},
        "parts": [_form(), *trials, *_pages()],
        "thanks": {"heading": "Thanks", "text": "You judged {clips}"},
    }


def _form() -> dict[str, Any]:
    options = [{"id": "sport", "label": "Sport"}, {"id": "dance", "label": "Dance"}]
    fields = [
        {"id": "age", "label": "Age", "type": "number", "minimum": 18, "maximum": 90},
        {"id": "moves", "label": "Which?", "type": "choices", "options": options},
        {"id": "likes", "label": "The most?", "type": "choice", "options": options},
        {"id": "why", "label": "Why?", "type": "long_text", "required": False},
    ]
    return {"kind": "form", "id": "person", "heading": "You", "fields": fields}


def _pages() -> list[dict[str, Any]]:
    text = {"heading": "A page", "text": "To read"}
    return [
        {"kind": "instructions", "id": "how", **text},
        {"kind": "break", "id": "rest", **text},
        {"kind": "comment", "id": "last", "question": "Anything else?"},
        {"kind": "debriefing", "id": "end", **text},
    ]
