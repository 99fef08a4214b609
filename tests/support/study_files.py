"""Small studies for tests, as the study file says them."""

from __future__ import annotations

from typing import Any

from app.schemas.study import StudyDefinition

TEXTS = {"heading": "Welcome", "lead": "Look and say.", "facts": ["few", "short", "any device"]}
CONSENT = {"version": "1", "heading": "Before", "terms": [], "statement": "I agree."}
THANKS = {"heading": "Thank you.", "text": "{clips} judged."}
SCALES = [
    {"id": "sad_happy", "left": "sad", "right": "happy"},
    {"id": "weak_strong", "left": "weak", "right": "strong"},
]
STEPS = ["very", "rather", "neither", "rather", "very"]
LIKERT = ["not at all", "little", "neither", "rather", "fully"]
ITEMS = [{"id": "natural", "label": "It is natural."}, {"id": "human", "label": "It is human."}]

# One task of every kind.
TASKS: dict[str, dict[str, Any]] = {
    "semantic_differential": {"question": "How?", "scales": SCALES, "steps": STEPS},
    "unipolar": {"question": "How?", "items": ITEMS, "steps": LIKERT},
    "likert": {"question": "How?", "items": ITEMS, "steps": LIKERT},
    "analogue": {"question": "How?", "scales": SCALES},
    "choose": {"question": "Which is the most natural?"},
    "ab": {"question": "Which is more natural?"},
    "abx": {"question": "Which one is X?"},
    "parallel": {"question": "How natural?", "low": "not at all", "high": "very"},
    "ranking": {"question": "Which order?", "first": "most natural", "last": "least natural"},
    "free_text": {"question": "What do you see?"},
}
for _kind, _task in TASKS.items():
    _task["kind"] = _kind


def clip(number: int) -> str:
    """An id as a published study has it."""
    return f"{number:064x}"


def stimuli(number: int) -> list[dict[str, Any]]:
    return [
        {
            "clip": clip(index), "name": f"clip_{index}", "label": f"clip {index}",
            "body": ("woman", "man")[index % 2], "style": f"style {index // 2}",
        }
        for index in range(number)
    ]  # fmt: skip


def trials(kind: str = "semantic_differential", number: int = 4, **more: Any) -> dict[str, Any]:
    """A part of trials; `task` in `more` is laid over the kind's own."""
    task = {**TASKS[kind], **more.pop("task", {})}
    return {
        "kind": "trials", "id": kind, "task": task, "stimuli": stimuli(number), **more,
    }  # fmt: skip


def study(*parts: dict[str, Any], **more: Any) -> StudyDefinition:
    return StudyDefinition.model_validate(study_file(*parts, **more))


def study_file(*parts: dict[str, Any], **more: Any) -> dict[str, Any]:
    return {
        "slug": "small", "title": "Small", "welcome": TEXTS, "consent": CONSENT,
        "thanks": THANKS, "parts": list(parts), **more,
    }  # fmt: skip
